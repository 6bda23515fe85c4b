# Run as a script: writes OUTPUT, a C++ source with the bytes of the files THREE and CONTROLS.

set(text "#include <string_view>\n\nnamespace embedded {\n\n")
foreach(entry IN ITEMS "THREE;three_js" "CONTROLS;trackball_controls_js")
  list(GET entry 0 variable)
  list(GET entry 1 name)
  set(bytes "")
  if(EXISTS "${${variable}}")
    file(READ "${${variable}}" bytes HEX)
  endif()
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(APPEND text
    "static const unsigned char ${name}_bytes[] = {${bytes}0};\n"
    "std::string_view ${name}() {\n"
    "  return {reinterpret_cast<const char*>(${name}_bytes), sizeof(${name}_bytes) - 1};\n}\n\n")
endforeach()
string(APPEND text "} // namespace embedded\n")
file(WRITE "${OUTPUT}" "${text}")
