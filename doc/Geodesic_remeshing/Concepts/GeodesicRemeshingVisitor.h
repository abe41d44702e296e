/*!
\ingroup PkgGeodesicRemeshingConcepts
\cgalConcept

The concept `GeodesicRemeshingVisitor` describes an object that watches `CGAL::geodesic_remeshing()` at work and can stop it.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geodesic_remeshing::Default_visitor}
\cgalHasModelsEnd
*/
class GeodesicRemeshingVisitor
{
public:
  /// called when a stage begins
  void stage(const std::string& name);

  /// called now and then with the part of the whole work that is done, from 0 to 1. Returning `false` stops the work:
  /// `CGAL::Geodesic_remeshing::Remeshing_error` is thrown, and the output is as it was before.
  bool progress(double done);
};
