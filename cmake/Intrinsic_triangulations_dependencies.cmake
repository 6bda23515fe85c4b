# Finds what the library is built on. Included by the build and, once installed, by the package
# configuration file, so that both find the same things in the same way.
#
# Required: CGAL (which brings GMP, MPFR, Boost headers and -frounding-math).
# Optional: Eigen3 (headers in operators/ and applications/), Spectra (operators/solvers/eigenpairs.h), OpenMesh (connectivity/adaptors/OpenMesh_adaptor.h).
#
# Defines the target Intrinsic_triangulations::OpenMesh_support if OpenMesh is found; programs that
# use OpenMesh meshes link to it beside the library.

# Asked for 5.5, CGAL's version file refuses 6.
find_package(CGAL QUIET REQUIRED)
if(CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "Intrinsic_triangulations needs CGAL 5.5 or later, ${CGAL_VERSION} was found")
endif()
find_package(Threads QUIET REQUIRED) # large matrices are factored by two
find_package(Eigen3 3.3 QUIET NO_MODULE) # after CGAL, whose own find module knows no target
if(TARGET Eigen3::Eigen)
  find_path(SPECTRA_INCLUDE_DIR NAMES Spectra/SymGEigsShiftSolver.h)
  mark_as_advanced(SPECTRA_INCLUDE_DIR)
endif()
find_package(OpenMesh QUIET NO_MODULE)

if(TARGET OpenMeshCore AND NOT TARGET Intrinsic_triangulations::OpenMesh_support)
  # GLOBAL: also for the project that adds this one as a subdirectory
  add_library(Intrinsic_triangulations::OpenMesh_support INTERFACE IMPORTED GLOBAL)
  target_link_libraries(Intrinsic_triangulations::OpenMesh_support INTERFACE OpenMeshCore)
  target_compile_definitions(Intrinsic_triangulations::OpenMesh_support
    INTERFACE _USE_MATH_DEFINES) # its headers use M_PI, which strict C++ hides
endif()
