# Run by ctest: lists the tests of a GoogleTest program and adds an entry for each suite, so that 3500 tests are some 400
# processes; or for each test if the variable PHYSIM_EACH_TEST of the environment is not empty, so that a name or a
# regular expression finds single tests.
function(physim_add_gtests program prefix timeout)
  if(NOT EXISTS "${program}")
    add_test("${prefix}NOT_BUILT" "${program}")
    return()
  endif()
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
  if(failed)
    add_test("${prefix}NOT_LISTED" "${program}" --gtest_list_tests)
    return()
  endif()
  string(REPLACE ";" "," listed "${listed}")
  string(REPLACE "\n" ";" lines "${listed}")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE " *#.*" "" name "${line}")  # GetParam() = ..., TypeParam = ...
    if(name MATCHES "^([^ ]+)\\.$")
      set(suite ${CMAKE_MATCH_1})
      if("$ENV{PHYSIM_EACH_TEST}" STREQUAL "")
        physim_add_gtest("${suite}" "${suite}.*")
      endif()
    elseif(name MATCHES "^  ([^ ]+)$" AND NOT "$ENV{PHYSIM_EACH_TEST}" STREQUAL "")
      physim_add_gtest("${suite}.${CMAKE_MATCH_1}" "${suite}.${CMAKE_MATCH_1}")
    endif()
  endforeach()
endfunction()

# Of the caller: program, prefix, timeout.
macro(physim_add_gtest name filter)
  add_test("${prefix}${name}" "${program}" "--gtest_filter=${filter}")
  set_tests_properties("${prefix}${name}" PROPERTIES TIMEOUT ${timeout})
endmacro()
