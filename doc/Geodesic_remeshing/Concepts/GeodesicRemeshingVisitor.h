/*!
\ingroup PkgGeodesicRemeshingConcepts
\cgalConcept

The concept `GeodesicRemeshingVisitor` describes an object that watches `CGAL::geodesic_remeshing()` at work and can
stop it. It is passed by reference, `visitor(std::ref(v))`, if what it sees is to be found in `v` afterwards; else a
copy of it is called. Its functions are called from the thread that called `CGAL::geodesic_remeshing()`; an exception
that they throw passes through to the caller, the output being as it was before.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geodesic_remeshing::Default_visitor}
\cgalHasModelsEnd
*/
class GeodesicRemeshingVisitor
{
public:
  /// is called when a stage begins.
  /// \param name one of those that `CGAL::Geodesic_remeshing::Default_visitor::stage()` lists
  void stage(const std::string& name);

  /// is called now and then.
  /// \param done the part of the whole work that is done, from 0 to 1, which never falls
  /// \return `false` before 1 stops the work: `CGAL::Geodesic_remeshing::Remeshing_error` is thrown, and the output is
  /// as it was before
  bool progress(double done);
};
