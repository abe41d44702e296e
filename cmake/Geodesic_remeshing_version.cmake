# Sets geodesic_remeshing_version, which is written down in one place only: the header that users include.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../include/CGAL/Geodesic_remeshing/version.h geodesic_remeshing_version
  REGEX "#define CGAL_GEODESIC_REMESHING_VERSION \"")
string(REGEX REPLACE ".*\"(.*)\"" "\\1" geodesic_remeshing_version "${geodesic_remeshing_version}")
