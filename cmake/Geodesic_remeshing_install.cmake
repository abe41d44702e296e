# Headers, the exported target and the files that find_package(Geodesic_remeshing) reads.
include(CMakePackageConfigHelpers)
set(GEODESIC_REMESHING_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Geodesic_remeshing)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS Geodesic_remeshing EXPORT Geodesic_remeshing_targets)
install(EXPORT Geodesic_remeshing_targets NAMESPACE Geodesic_remeshing:: DESTINATION ${GEODESIC_REMESHING_CMAKE_DIR})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/Geodesic_remeshingConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Geodesic_remeshingConfig.cmake INSTALL_DESTINATION ${GEODESIC_REMESHING_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/Geodesic_remeshingConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/Geodesic_remeshingConfig.cmake
              ${PROJECT_BINARY_DIR}/Geodesic_remeshingConfigVersion.cmake
        DESTINATION ${GEODESIC_REMESHING_CMAKE_DIR})
