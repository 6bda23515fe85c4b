# What tests and examples share.
#
#   read_polygon_mesh_instance  the mesh type that most of them read, and CGAL's reader for it
#   shared_settings             their options; they share a precompiled header,
#   shared_precompiled          the target that has it

add_library(read_polygon_mesh_instance STATIC EXCLUDE_FROM_ALL
  "${PROJECT_SOURCE_DIR}/cmake/read_polygon_mesh_instance.cpp")
target_link_libraries(read_polygon_mesh_instance PUBLIC Intrinsic_triangulations)

add_library(shared_settings INTERFACE)
target_link_libraries(shared_settings INTERFACE
  Intrinsic_triangulations Intrinsic_triangulations_warnings)
if(TARGET Intrinsic_triangulations::OpenMesh_support)
  target_link_libraries(shared_settings INTERFACE Intrinsic_triangulations::OpenMesh_support)
endif()
# Tests and examples are many and compile for longer than they run.
target_compile_options(shared_settings INTERFACE -Og)
# At this level g++ warns of values in CGAL that are initialized.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(shared_settings INTERFACE -Wno-maybe-uninitialized)
endif()
# CGAL's kernels take GMP's rational numbers then, which compile faster than Boost's around them.
target_compile_definitions(shared_settings INTERFACE CGAL_DO_NOT_USE_BOOST_MP)

file(CONFIGURE OUTPUT precompiled.cpp CONTENT "// Only carries the precompiled header.\n")
add_library(shared_precompiled OBJECT EXCLUDE_FROM_ALL
  "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
target_link_libraries(shared_precompiled PRIVATE shared_settings)
if(INTRINSIC_TRIANGULATIONS_BUILD_TESTS)
  find_package(GTest QUIET)
  if(GTest_FOUND)
    # Users of a precompiled header must have the macros that it was made with.
    target_compile_definitions(shared_settings INTERFACE
      $<TARGET_PROPERTY:GTest::gtest,INTERFACE_COMPILE_DEFINITIONS>)
    target_compile_options(shared_settings INTERFACE
      $<TARGET_PROPERTY:GTest::gtest,INTERFACE_COMPILE_OPTIONS>)
    target_precompile_headers(shared_precompiled PRIVATE
      "${PROJECT_SOURCE_DIR}/test/support/functions_as_tests.h") # includes gtest
  endif()
endif()
if(NOT INTRINSIC_TRIANGULATIONS_TEST_PROGRAM_PER_FILE) # else foreign ones only, which do not change
  target_link_libraries(shared_settings INTERFACE read_polygon_mesh_instance)
  target_precompile_headers(shared_precompiled PRIVATE
    "${PROJECT_SOURCE_DIR}/cmake/read_polygon_mesh_instance.h"
    <CGAL/Intrinsic_geodesics.h>)
endif()
target_precompile_headers(shared_precompiled PRIVATE
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Interval_nt.h>
  <CGAL/Simple_cartesian.h>
  <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/Euler_operations.h>
  <CGAL/boost/graph/IO/polygon_mesh_io.h>)
if(TARGET Eigen3::Eigen)
  target_precompile_headers(shared_precompiled PRIVATE <Eigen/Dense> <Eigen/Sparse>)
endif()
