# Runs doxygen, with variables DOXYGEN, DOXYFILE, PYTHON and HTML, the folder that it writes: cmake -D... -P build_doc.cmake
# Pages of names that are gone would stay.
file(GLOB old "${HTML}/*.html" "${HTML}/*.js" "${HTML}/search/*")
if(old)
  file(REMOVE ${old})
endif()
execute_process(COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/python_pages.py" "${CMAKE_CURRENT_LIST_DIR}/../python/intrinsic"
  "${CMAKE_CURRENT_LIST_DIR}/Intrinsic_triangulations/fig" "${HTML}/../python"
  COMMAND_ERROR_IS_FATAL ANY)
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

# Search in texts, without a server.
execute_process(COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/make_text_index.py" "${HTML}/../searchdata.xml" "${HTML}"
  "${CMAKE_CURRENT_LIST_DIR}/Intrinsic_triangulations"
  COMMAND_ERROR_IS_FATAL ANY)
file(COPY "${CMAKE_CURRENT_LIST_DIR}/search.js" DESTINATION "${HTML}/search")
# Doxygen knows no pages of concepts but those of classes. Pages tell browsers of a server that does not exist.
file(GLOB pages "${HTML}/*.html")
foreach(page IN LISTS pages)
  file(READ "${page}" text)
  string(REGEX REPLACE "<link rel=\"search\"[^>]*>\n" "" text "${text}")
  if(page MATCHES "/class[A-Za-z]+\\.html$")
    string(REPLACE "Class Reference" "Concept" text "${text}")
  endif()
  file(WRITE "${page}" "${text}")
endforeach()
