# Builds TARGET in BUILD_DIR and fails unless the compiler rejects it with a message that matches
# the line of CASE in SOURCE, `// case NAME: REGEX` (a regular expression of CMake), or
# `// case NAME at once: REGEX`: in the first five lines, those not counted that tell by which
# headers a header was included. `of templates` before the colon tells that the compiler finds it
# when it instantiates templates, which it does after it has read the source.

set(ENV{LC_ALL} C) # plain ASCII quotes in messages
file(READ "${SOURCE}" text)
if(NOT text MATCHES "\n// case ${CASE}( at once)?( of templates)?: ([^\n]+)\n")
  message(FATAL_ERROR "${SOURCE} must have a line `// case ${CASE}: REGEX`")
endif()
set(at_once "${CMAKE_MATCH_1}")
set(expected "${CMAKE_MATCH_3}")

execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${BUILD_DIR}" --target "${TARGET}" --config "${CONFIG}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message(NOTICE "${output}")
if(result EQUAL 0)
  message(FATAL_ERROR "${CASE} of ${SOURCE} compiles, it must not")
elseif(NOT output MATCHES " error: ")
  message(FATAL_ERROR "The compiler was not reached")
endif()
if(at_once) # what the compiler says follows its command
  string(REGEX REPLACE "^.* -c [^\n]*\n" "" output "${output}")
  string(REGEX REPLACE "(In file included| +) from [^\n]*\n" "" output "${output}")
  string(REGEX MATCH "^([^\n]*\n?[^\n]*\n?[^\n]*\n?[^\n]*\n?[^\n]*)" output "${output}")
endif()
if(NOT output MATCHES "${expected}")
  message(FATAL_ERROR "${CASE} of ${SOURCE} fails without a message that matches: ${expected}")
endif()
