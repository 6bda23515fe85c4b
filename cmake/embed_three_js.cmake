# embed_three_js(TARGET): compiles three.js and its TrackballControls.js into TARGET, which then has the
# functions that three_js.h declares, which is beside this file. Where the scripts are not found their
# text is empty, and who needs them says so.

set(INTRINSIC_TRIANGULATIONS_THREE_JS_DIR "" CACHE PATH
  "Directory of three.js (three.min.js, examples/js/controls); empty: that of Debian's libjs-three")

function(embed_three_js target)
  set(directories "${INTRINSIC_TRIANGULATIONS_THREE_JS_DIR}" /usr/share/javascript/three)
  find_file(INTRINSIC_TRIANGULATIONS_THREE_JS three.min.js
    PATHS ${directories} PATH_SUFFIXES build NO_DEFAULT_PATH)
  find_file(INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS TrackballControls.js
    PATHS ${directories} PATH_SUFFIXES examples/js/controls NO_DEFAULT_PATH)
  mark_as_advanced(INTRINSIC_TRIANGULATIONS_THREE_JS INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS)
  if(NOT INTRINSIC_TRIANGULATIONS_THREE_JS OR NOT INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS)
    message(STATUS "Pages need three.js (Debian: libjs-three): ${target} is built without it")
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/three_js.cpp")
  set_source_files_properties("${source}" PROPERTIES
    SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  add_custom_command(OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}"
      "-DTHREE=${INTRINSIC_TRIANGULATIONS_THREE_JS}"
      "-DCONTROLS=${INTRINSIC_TRIANGULATIONS_TRACKBALL_CONTROLS_JS}"
      "-DOUTPUT=${source}" -P "${PROJECT_SOURCE_DIR}/cmake/write_three_js_source.cmake"
    DEPENDS "${PROJECT_SOURCE_DIR}/cmake/write_three_js_source.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${source}")
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/cmake")
endfunction()
