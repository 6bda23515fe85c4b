# Installs the headers, the libraries and what `find_package(Intrinsic_triangulations)` needs.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Intrinsic_triangulations")
set(package_component Intrinsic_triangulations_Development)

set_target_properties(Intrinsic_triangulations_header_only PROPERTIES EXPORT_NAME header_only)
set_target_properties(Intrinsic_triangulations_core PROPERTIES EXPORT_NAME core)
set_target_properties(Intrinsic_triangulations_correspondences PROPERTIES EXPORT_NAME correspondences)
set_target_properties(Intrinsic_triangulations_geodesics PROPERTIES EXPORT_NAME geodesics)
set_target_properties(Intrinsic_triangulations_operators PROPERTIES EXPORT_NAME operators)
set_target_properties(Intrinsic_triangulations_conformal PROPERTIES EXPORT_NAME conformal)
set_target_properties(Intrinsic_triangulations_simplification PROPERTIES EXPORT_NAME simplification)
install(TARGETS Intrinsic_triangulations Intrinsic_triangulations_core Intrinsic_triangulations_correspondences
    Intrinsic_triangulations_geodesics Intrinsic_triangulations_operators Intrinsic_triangulations_conformal
    Intrinsic_triangulations_simplification Intrinsic_triangulations_header_only
  EXPORT Intrinsic_triangulations_targets
  ARCHIVE
    DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT ${package_component}
  FILE_SET HEADERS
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT ${package_component}
  FILE_SET sources
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT ${package_component}
  FILE_SET openmesh_headers
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT ${package_component}
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT Intrinsic_triangulations_targets
  NAMESPACE Intrinsic_triangulations::
  DESTINATION "${package_dir}"
  COMPONENT ${package_component})

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/Intrinsic_triangulationsConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/Intrinsic_triangulationsConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Intrinsic_triangulationsConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion) # until 1.0 every minor version may change the interface
install(FILES
  "${PROJECT_BINARY_DIR}/Intrinsic_triangulationsConfig.cmake"
  "${PROJECT_BINARY_DIR}/Intrinsic_triangulationsConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/Intrinsic_triangulations_dependencies.cmake"
  DESTINATION "${package_dir}"
  COMPONENT ${package_component})
