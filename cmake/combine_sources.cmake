# combine_sources(RESULT SIZE SOURCE...): writes sources of which each includes up to SIZE of the given
# ones, next to each other, and lists them in RESULT. What they share is then parsed and instantiated once.
#
# Unlike in CMake's unity builds, names of one source do not clash with those of another: headers are
# included first, then each source within a namespace of its own, where its includes find nothing left to do.

function(combine_sources result size)
  set(combined "")
  set(part 0)
  set(rest ${ARGN})
  while(rest)
    list(LENGTH rest left)
    math(EXPR parts "(${left} + ${size} - 1) / ${size}")
    math(EXPR count "(${left} + ${parts} - 1) / ${parts}") # parts of equal size
    math(EXPR part "${part} + 1")
    set(includes "")
    set(bodies "")
    foreach(_ RANGE 1 ${count})
      list(POP_FRONT rest source)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
      file(STRINGS "${source}" lines REGEX "^#include ")
      list(APPEND includes ${lines})
      cmake_path(GET source STEM name)
      string(APPEND bodies "namespace source_${name} {\n#include \"${source}\"\n}\n")
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/${result}_${part}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT "${includes}\n\n${bodies}" @ONLY)
    list(APPEND combined "${file}")
  endwhile()
  set(${result} "${combined}" PARENT_SCOPE)
endfunction()
