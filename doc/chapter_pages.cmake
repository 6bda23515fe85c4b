# Writes a page per chapter of the user manual, beside the Doxyfile, and puts them into `chapter_pages`, in order: each section
# of user_manual.md whose label begins with `manual_`. So the tree at the side shows chapters, and pages below them.

set(user_manual "${CMAKE_CURRENT_SOURCE_DIR}/Intrinsic_triangulations/user_manual.md")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${user_manual}")
file(READ "${user_manual}" text)
string(ASCII 1 semicolon) # it would divide the list
string(REPLACE ";" "${semicolon}" text "${text}")
string(REPLACE "\n## " ";" sections "${text}")
set(chapter_pages "")
foreach(section IN LISTS sections)
  if(section MATCHES "^([^\n]+)\n<a id=\"(manual_[a-z_]+)\"></a>\n(.*)$")
    set(page "${CMAKE_CURRENT_BINARY_DIR}/chapter_${CMAKE_MATCH_2}.md")
    string(REPLACE "${semicolon}" ";" body "# ${CMAKE_MATCH_1}\n<a id=\"${CMAKE_MATCH_2}\"></a>\n${CMAKE_MATCH_3}\n")
    if(CMAKE_MATCH_2 STREQUAL "manual_program") # its pages are generated from the module
      string(APPEND body "\\subpage py_reference \"Python reference\": a page for each function\n")
    elseif(CMAKE_MATCH_2 STREQUAL "manual_inside")
      foreach(package IN ITEMS triangulations geodesics operators conformal simplification)
        string(APPEND body "- \\subpage page_rooms_of_${package} \"The rooms of ${package}\"\n")
      endforeach()
    endif()
    file(CONFIGURE OUTPUT "${page}" CONTENT "${body}" @ONLY)
    list(APPEND chapter_pages "\"${page}\"")
  endif()
endforeach()
