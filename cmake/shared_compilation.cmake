# What takes long to compile, compiled once for all programs of this project.
#
#   exact_instances          exact predicates; programs that include exact_instances.h first link it
#   triangulation_instances  the usual triangulations and algorithms on them; the same
#   shared_settings          the options of tests and examples, which share a precompiled header,
#   shared_precompiled       the target that has it

add_library(exact_instances STATIC EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/cmake/exact_instances.cpp")
target_link_libraries(exact_instances PUBLIC Intrinsic_triangulations)
target_link_libraries(exact_instances PRIVATE Intrinsic_triangulations_warnings)
set(exact_instances_header "${PROJECT_SOURCE_DIR}/cmake/exact_instances.h")

add_library(triangulation_instances STATIC EXCLUDE_FROM_ALL
  "${PROJECT_SOURCE_DIR}/cmake/triangulation_instances.cpp")
target_link_libraries(triangulation_instances PUBLIC exact_instances)
target_link_libraries(triangulation_instances PRIVATE Intrinsic_triangulations_warnings)

add_library(shared_settings INTERFACE)
target_link_libraries(shared_settings INTERFACE
  Intrinsic_triangulations Intrinsic_triangulations_warnings)
if(TARGET Intrinsic_triangulations::OpenMesh_support)
  target_link_libraries(shared_settings INTERFACE Intrinsic_triangulations::OpenMesh_support)
endif()
# Tests and examples are many and compile for longer than they run.
target_compile_options(shared_settings INTERFACE -O1)

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
    target_precompile_headers(shared_precompiled PRIVATE <gtest/gtest.h>)
  endif()
endif()
if(NOT INTRINSIC_TRIANGULATIONS_TEST_PROGRAM_PER_FILE) # else foreign ones only, which do not change
  target_link_libraries(shared_settings INTERFACE triangulation_instances)
  target_precompile_headers(shared_precompiled PRIVATE
    "${PROJECT_SOURCE_DIR}/cmake/triangulation_instances.h"
    <CGAL/Intrinsic_triangulations.h>)
endif()
target_precompile_headers(shared_precompiled PRIVATE
  <CGAL/Constrained_Delaunay_triangulation_2.h>
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Gmpfi.h>
  <CGAL/Interval_nt.h>
  <CGAL/Projection_traits_3.h>
  <CGAL/Simple_cartesian.h>
  <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/Euler_operations.h>
  <CGAL/boost/graph/IO/polygon_mesh_io.h>)
if(TARGET Eigen3::Eigen)
  target_precompile_headers(shared_precompiled PRIVATE <Eigen/Dense> <Eigen/Sparse>)
endif()
