#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Geodesic_remeshing/version.h>

#include <cstring>

// Compiles in no time: all that matters is that the headers are found, the package's and CGAL's.

#if CGAL_GEODESIC_REMESHING_VERSION_NR < CGAL_GEODESIC_REMESHING_VERSION_NUMBER(0, 1, 0)
#error "not the version that the macros tell"
#endif

int main()
{
  const auto np = CGAL::Geodesic_remeshing::parameters::number_of_iterations(7).use_segmentation(false);
  (void)np;
  return std::strlen(CGAL_GEODESIC_REMESHING_VERSION) > 0 ? 0 : 1;
}
