# Finds MPFI, interval arithmetic on top of MPFR, which ships no package configuration file.
#
# Result: MPFI_FOUND and the imported target MPFI::MPFI
# Cache:  MPFI_INCLUDE_DIR, MPFI_LIBRARY

find_path(MPFI_INCLUDE_DIR NAMES mpfi.h)
find_library(MPFI_LIBRARY NAMES mpfi)
mark_as_advanced(MPFI_INCLUDE_DIR MPFI_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFI
  REQUIRED_VARS MPFI_LIBRARY MPFI_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "On Debian and Ubuntu install libmpfi-dev.")

if(MPFI_FOUND AND NOT TARGET MPFI::MPFI)
  add_library(MPFI::MPFI UNKNOWN IMPORTED)
  set_target_properties(MPFI::MPFI PROPERTIES
    IMPORTED_LOCATION "${MPFI_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${MPFI_INCLUDE_DIR}")
endif()
