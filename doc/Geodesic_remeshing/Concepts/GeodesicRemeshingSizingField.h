/*!
\ingroup PkgGeodesicRemeshingConcepts
\cgalConcept

The concept `GeodesicRemeshingSizingField` describes an object that tells how long the edges of a remeshed surface are
to be. It is passed to `CGAL::geodesic_remeshing()` by the named parameter `sizing_field`, and asked once for each
vertex of the input that has a face.

A vertex property map of lengths or a model of `PMPSizingField`, whose function is `at(v, tmesh)`, may take its place.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geodesic_remeshing::Curvature_sizing_field}
\cgalHasModelsEnd
*/
class GeodesicRemeshingSizingField
{
public:
  /// vertex descriptor of the mesh to be remeshed
  typedef unspecified_type vertex_descriptor;

  /// a number type
  typedef unspecified_type FT;

  /// \return the length of the edges at `v`, positive and finite, up to a factor that is the same for all vertices
  /// \param v a vertex that has a face
  FT at(vertex_descriptor v) const;

  /// \name Optional
  /// @{

  /// tells the limits of the lengths. A class that has no limits of its own need not have this function; named
  /// parameters of `CGAL::geodesic_remeshing()` come before what it returns.
  /// \return the limits
  CGAL::Geodesic_remeshing::Sizing_limits limits() const;

  /// tells what it is worth to be near to the surface: vertices move over the surface to where the RMS distance of the
  /// mesh from it is less, for what this costs in angles. A class need not have this function; 0, which holds without
  /// it, does nothing of the kind.
  /// \return a number from 0 to 10: with 1 the RMS distance falls by about a quarter and the mean of the smallest
  /// angles by half a degree, with more both fall further
  FT nearness() const;

  /// @}
};
