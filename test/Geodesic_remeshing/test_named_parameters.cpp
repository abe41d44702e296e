#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GR = CGAL::Geodesic_remeshing;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

// what an algorithm does with its pack
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool segmentation_wanted(const NamedParameters& np = CGAL::parameters::default_values())
{
  return parameters::choose_parameter(parameters::get_parameter(np, GR::internal_np::use_segmentation), true);
}

template <typename NamedParameters>
unsigned int iterations_wanted(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, GR::internal_np::number_of_iterations), 1);
}

// the form in which functions of CGAL declare their pack
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
int iterations_by_cgal(const CGAL_NP_CLASS& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_iterations), 1);
}

} // namespace

TEST(Named_parameters, defaults_without_a_pack)
{
  EXPECT_TRUE(segmentation_wanted());
}

TEST(Named_parameters, own_and_cgal_names_chain_in_any_order)
{
  const auto own_last = parameters::number_of_iterations(7).use_segmentation(false).verbose(true);
  EXPECT_FALSE(segmentation_wanted(own_last));
  EXPECT_EQ(iterations_wanted(own_last), 7u);

  const auto own_first = parameters::use_segmentation(false).number_of_iterations(7);
  EXPECT_FALSE(segmentation_wanted(own_first));
  EXPECT_EQ(iterations_wanted(own_first), 7u);
}

TEST(Named_parameters, pack_of_cgal_is_accepted_and_can_be_continued)
{
  const auto pack = CGAL::parameters::number_of_iterations(7);
  EXPECT_TRUE(segmentation_wanted(pack));
  EXPECT_EQ(iterations_wanted(pack), 7u);
  EXPECT_FALSE(segmentation_wanted(parameters::from(pack).use_segmentation(false)));
}

TEST(Named_parameters, functions_of_cgal_take_our_pack)
{
  EXPECT_EQ(iterations_by_cgal(parameters::use_segmentation(false).number_of_iterations(7)), 7);

  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), mesh);
  const auto pack = parameters::vertex_point_map(mesh.points()).use_segmentation(true);
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(mesh, GR::internal::cgal_pack(pack)), 1.5 + std::sqrt(3.) / 2.,
              1e-12);
}

TEST(Named_parameters, reference_to_an_object_of_the_caller_survives_the_chain)
{
  int visits = 0;
  const auto pack = parameters::visitor(std::ref(visits)).use_segmentation(false);
  int fallback = 0;
  int& seen =
      parameters::choose_parameter(parameters::get_parameter_reference(pack, GR::internal_np::visitor), fallback);
  ++seen;
  EXPECT_EQ(visits, 1);
}
