# Writes directories.h, beside the Doxyfile: what each folder of headers holds, from the README of its package, where each room
# has a heading and a paragraph.

set(directories "")
foreach(package IN ITEMS triangulations geodesics operators conformal simplification)
  set(folder "CGAL/Intrinsic_${package}")
  set(readme "${PROJECT_SOURCE_DIR}/include/${folder}/README.md")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${readme}")
  string(APPEND directories "\\dir ${folder}\n\\brief Headers of ${package}: see \\ref page_rooms_of_${package}.\n\n")
  file(READ "${readme}" text)
  string(ASCII 1 semicolon) # it would divide a list
  string(REPLACE ";" "${semicolon}" text "${text}")
  string(REGEX MATCHALL "\n## `[a-zA-Z_/]+/`\n\n[^\n]+(\n[^\n]+)*" rooms "${text}")
  foreach(room IN LISTS rooms) # doxygen reads include/ alone
    string(REGEX REPLACE "^\n## `([^`]*)/`.*" "\\1" name "${room}")
    if(NOT IS_DIRECTORY "${PROJECT_SOURCE_DIR}/include/${folder}/${name}")
      list(REMOVE_ITEM rooms "${room}")
    endif()
  endforeach()
  list(TRANSFORM rooms REPLACE "^\n## `(.*)/`\n\n" "\\\\dir ${folder}/\\1\n\\\\brief ")
  list(JOIN rooms "\n\n" rooms)
  string(REPLACE "${semicolon}" ";" rooms "${rooms}")
  string(APPEND directories "${rooms}\n\n")
endforeach()
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/directories.h" "/*!\n${directories}*/\n")
