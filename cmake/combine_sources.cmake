# combine_sources(RESULT SOURCE...): writes a source RESULT.cpp that includes the given ones, and
# puts its path into RESULT. What they share is then parsed and instantiated once.
#
# Unlike in CMake's unity builds, names of one source do not clash with those of another: headers are
# included first, then each source within a namespace of its own, where its includes find nothing left to do.

function(combine_sources result)
  set(includes "")
  set(bodies "")
  foreach(source IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(STRINGS "${source}" lines REGEX "^#include ")
    list(APPEND includes ${lines})
    cmake_path(GET source STEM name)
    string(APPEND bodies "namespace source_${name} {\n#include \"${source}\"\n}\n")
  endforeach()
  list(REMOVE_DUPLICATES includes)
  list(JOIN includes "\n" includes)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${result}.cpp")
  file(CONFIGURE OUTPUT "${file}" CONTENT "${includes}\n\n${bodies}" @ONLY)
  set(${result} "${file}" PARENT_SCOPE)
endfunction()
