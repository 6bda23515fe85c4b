# Runs doxygen, with variables DOXYGEN, DOXYFILE and HTML, the folder that it writes: cmake -D... -P build_doc.cmake
# Pages of names that are gone would stay.
file(GLOB old "${HTML}/*.html" "${HTML}/*.js" "${HTML}/search/*")
if(old)
  file(REMOVE ${old})
endif()
execute_process(COMMAND "${DOXYGEN}" -q "${DOXYFILE}" RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The documentation has warnings")
endif()

# The tree beside pages has room for names, not for the namespace before each.
file(GLOB trees "${HTML}/group__*.js")
foreach(tree IN LISTS trees)
  file(READ "${tree}" text)
  string(REPLACE "\"CGAL::Intrinsic_triangulations::" "\"" text "${text}")
  file(WRITE "${tree}" "${text}")
endforeach()
