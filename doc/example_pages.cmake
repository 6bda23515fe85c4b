# Writes examples.md, the table of examples as a page, and examples.h, which makes a page of each, beside the Doxyfile.

set(example_dir "${PROJECT_SOURCE_DIR}/examples")
file(GLOB_RECURSE examples CONFIGURE_DEPENDS "${example_dir}/*.cpp")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${example_dir}/README.md")
file(READ "${example_dir}/README.md" table)
string(REPLACE "# Examples" "# Examples {#page_examples}" table "${table}")
string(REGEX REPLACE "\\[([a-z0-9_]+\\.cpp)\\]\\([^)]*\\)" "\\\\ref \\1" table "${table}")
string(REGEX REPLACE "\\[([^]]*)\\]\\([^)]*/command_line\\.md\\)" "\\\\ref command_line \"\\1\"" table "${table}")
string(REGEX REPLACE "\\[([^]]*)\\]\\([^)]*\\)" "\\1" table "${table}") # what has no page
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/examples.md" "${table}")
set(example_pages "")
foreach(example IN LISTS examples)
  cmake_path(GET example FILENAME name)
  string(APPEND example_pages "/*! \\example ${name} */\n")
endforeach()
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/examples.h" "${example_pages}")
