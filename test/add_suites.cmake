# ctest includes this: adds a test for each suite of the test program `program`. A process for each
# test would take longer to start than most tests take.
if(EXISTS "${program}")
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed
    RESULT_VARIABLE result)
else()
  set(result "it is not built")
endif()
if(result)
  add_test("${program}" "${program}") # fails, as it must
  return()
endif()
string(REGEX MATCHALL "\n[^ \n]+\\." suites "\n${listed}")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" name "${suite}")
  add_test("${name}" "${program}" "--gtest_filter=${suite}*")
  # What was skipped is said last, unless something failed.
  set_tests_properties("${name}" PROPERTIES TIMEOUT 600
    SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\] [^\n]*\n*$")
endforeach()
