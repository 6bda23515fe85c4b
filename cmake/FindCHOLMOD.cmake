# Finds CHOLMOD, sparse Cholesky factorization (of SuiteSparse), which ships no package configuration file.
#
# Result: CHOLMOD_FOUND and the imported target CHOLMOD::CHOLMOD
# Cache:  CHOLMOD_INCLUDE_DIR, CHOLMOD_LIBRARY

find_path(CHOLMOD_INCLUDE_DIR NAMES cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY NAMES cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD
  REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "On Debian and Ubuntu install libsuitesparse-dev.")

if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
  # GLOBAL: also for the project that adds this one as a subdirectory
  add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED GLOBAL)
  set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
    IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
    INTERFACE_COMPILE_DEFINITIONS CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD=1
    INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}")
endif()
