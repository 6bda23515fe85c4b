# Builds TARGET in BUILD_DIR and fails unless the compiler rejects it with a message that matches
# the first line of SOURCE, `// expect: REGEX` (a regular expression of CMake).

set(ENV{LC_ALL} C) # plain ASCII quotes in messages
file(STRINGS "${SOURCE}" first_line LIMIT_COUNT 1)
if(NOT first_line MATCHES "^// expect: (.+)$")
  message(FATAL_ERROR "${SOURCE} must start with a line `// expect: REGEX`")
endif()
set(expected "${CMAKE_MATCH_1}")

execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${BUILD_DIR}" --target "${TARGET}" --config "${CONFIG}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message(NOTICE "${output}")
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles, it must not")
elseif(NOT output MATCHES " error: ")
  message(FATAL_ERROR "The compiler was not reached")
elseif(NOT output MATCHES "${expected}")
  message(FATAL_ERROR "${SOURCE} fails without a message that matches: ${expected}")
endif()
