# Target embedded_three_js: three.js and its TrackballControls.js, as the functions that three_js.h
# declares, which is beside this file. Where the scripts are not found their text is empty, and who
# needs them says so. It depends on no other target: else all that links it would wait for these
# before it is compiled.

set(INTRINSIC_TRIANGULATIONS_THREE_JS_DIR "" CACHE PATH
  "Directory of three.js (three.min.js, examples/js/controls); empty: that of Debian's libjs-three")
set(directories "${INTRINSIC_TRIANGULATIONS_THREE_JS_DIR}" /usr/share/javascript/three)
find_file(INTRINSIC_TRIANGULATIONS_THREE_JS three.min.js
  PATHS ${directories} PATH_SUFFIXES build NO_DEFAULT_PATH)
find_file(INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS TrackballControls.js
  PATHS ${directories} PATH_SUFFIXES examples/js/controls NO_DEFAULT_PATH)
mark_as_advanced(INTRINSIC_TRIANGULATIONS_THREE_JS INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS)
if(NOT INTRINSIC_TRIANGULATIONS_THREE_JS OR NOT INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS)
  message(STATUS "Pages need three.js (Debian: libjs-three): they cannot be drawn without it")
endif()
set(three_js_source "${CMAKE_CURRENT_BINARY_DIR}/three_js.cpp")
add_custom_command(OUTPUT "${three_js_source}"
  COMMAND "${CMAKE_COMMAND}"
    "-DTHREE=${INTRINSIC_TRIANGULATIONS_THREE_JS}"
    "-DCONTROLS=${INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS}"
    "-DOUTPUT=${three_js_source}" -P "${PROJECT_SOURCE_DIR}/cmake/write_three_js_source.cmake"
  DEPENDS "${PROJECT_SOURCE_DIR}/cmake/write_three_js_source.cmake"
  VERBATIM)
add_library(embedded_three_js STATIC EXCLUDE_FROM_ALL "${three_js_source}")
target_compile_features(embedded_three_js PRIVATE cxx_std_20)
target_include_directories(embedded_three_js PUBLIC "${PROJECT_SOURCE_DIR}/cmake")
set_target_properties(embedded_three_js PROPERTIES POSITION_INDEPENDENT_CODE ON)
