# Tests: physim_tests (GoogleTest), physim_golden (determinism), and every example.

# Prints one hash over many flights; the same bits must come out of every compiler and instruction set. Core only.
file(GLOB golden_sources CONFIGURE_DEPENDS tests/golden/*.cpp)
if(PHYSIM_GOLDEN AND golden_sources)
  add_executable(physim_golden ${golden_sources})
  physim_flags(physim_golden)
  target_include_directories(physim_golden PRIVATE src tests)
  target_link_libraries(physim_golden PRIVATE physim)
  set_target_properties(physim_golden PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_test(NAME golden COMMAND physim_golden)
  # From threads that compute otherwise than the library does.
  add_test(NAME golden.upward COMMAND physim_golden upward)
  add_test(NAME golden.flush COMMAND physim_golden flush)
  set_tests_properties(golden golden.upward golden.flush PROPERTIES TIMEOUT 600)
endif()

if(NOT PHYSIM_TESTS)
  return()
endif()

# The tests of a GoogleTest program become tests of ctest when ctest starts.
function(physim_run_tests program prefix timeout)
  set(script ${PROJECT_BINARY_DIR}/${program}_suites.cmake)
  file(GENERATE OUTPUT ${script} CONTENT "include(${PROJECT_SOURCE_DIR}/cmake/gtest_suites.cmake)
physim_add_gtests(\"$<TARGET_FILE:${program}>\" \"${prefix}\" ${timeout})
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()

# Programs that try things at random, with a few things as a test; each has a long form in `./dev`.
function(physim_add_random_check test program source)
  add_executable(${program} ${source})
  physim_flags(${program})
  target_include_directories(${program} PRIVATE src tests)
  target_link_libraries(${program} PRIVATE physim)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_test(NAME ${test} COMMAND ${program} ${ARGN})
  set_tests_properties(${test} PROPERTIES TIMEOUT 900)
endfunction()
physim_add_random_check(soak physim_soak tests/soak/soak.cpp 1e6 2000)  # a crowded world in which everything changes
physim_add_random_check(scene_soak physim_scene_soak tests/soak/scene_soak.cpp 5e5 1000)  # and things move
physim_add_random_check(calls_soak physim_calls_soak tests/soak/calls_soak.cpp 30)  # programs of calls, played in several ways
physim_add_random_check(fuzz physim_fuzz tests/fuzz/aim_fuzz.cpp 500)  # questions to aim()
physim_add_random_check(world_fuzz physim_world_fuzz tests/fuzz/world_fuzz.cpp 100)  # calls of the whole interface
physim_add_random_check(extreme_fuzz physim_extreme_fuzz tests/fuzz/extreme_fuzz.cpp 300)  # one number far from usual
physim_add_random_check(energy_fuzz physim_energy_fuzz tests/fuzz/energy_fuzz.cpp 3000)  # worlds that make no energy
# Worlds that once made some: on Euler's steps, of one that slid, of two that met in flight, of one that slid down a thing
# through the ground, and of one that began to roll in thick air.
foreach(world "901 52513" "901 880744" "77 270582" "730131 193247" "20261130 450293" "31126113 12423")
  separate_arguments(seed_and_number UNIX_COMMAND "${world}")
  string(REPLACE " " "_" name "energy_fuzz_${world}")
  add_test(NAME ${name} COMMAND physim_energy_fuzz 1 ${seed_and_number})
endforeach()
if(TARGET physim_scenario)
  physim_add_random_check(settings_fuzz physim_settings_fuzz tests/fuzz/settings_pairs.cpp 400)  # two settings at a time
  target_link_libraries(physim_settings_fuzz PRIVATE physim_scenario)
  target_compile_definitions(physim_settings_fuzz PRIVATE PHYSIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  physim_add_random_check(text_fuzz physim_text_fuzz tests/fuzz/text_fuzz.cpp 2000)  # texts of scenarios and motors
  target_link_libraries(physim_text_fuzz PRIVATE physim_scenario)
  target_compile_definitions(physim_text_fuzz PRIVATE PHYSIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endif()
file(GLOB hits_sources CONFIGURE_DEPENDS tests/hits/*.cpp)
physim_add_random_check(hits physim_hits "${hits_sources}" 2000)  # casts, impacts, and what hits set off
physim_add_random_check(sweep physim_fidelity_sweep tests/fuzz/fidelity_sweep.cpp 60)  # answers of auto fidelity

# A user's program says the same whether it is compiled and linked with fast mathematics or not; and a project that is,
# with PhySim as its subfolder, gets a library that is not.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-march=native PHYSIM_HAS_MARCH_NATIVE)
  set(strict -fno-fast-math)
  set(fast -O2 -ffast-math)
  if(PHYSIM_HAS_MARCH_NATIVE)
    list(APPEND fast ${PHYSIM_NATIVE})
  endif()
  set(programs)
  foreach(flags IN ITEMS strict fast)
    add_executable(physim_consumer_${flags} tests/fast_math/consumer.cpp)
    target_compile_features(physim_consumer_${flags} PRIVATE cxx_std_20)
    target_compile_options(physim_consumer_${flags} PRIVATE ${PHYSIM_USERS_WARNINGS} ${${flags}})
    target_link_options(physim_consumer_${flags} PRIVATE ${${flags}})
    target_link_libraries(physim_consumer_${flags} PRIVATE physim)
    list(APPEND programs $<TARGET_FILE:physim_consumer_${flags}>)
  endforeach()
  add_test(NAME fast_math.consumer COMMAND ${CMAKE_COMMAND} "-DPROGRAMS=${programs}" -P
                                           ${PROJECT_SOURCE_DIR}/tests/fast_math/compare.cmake)
  add_test(NAME fast_math.parent
           COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR}
                   -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER} -P
                   ${PROJECT_SOURCE_DIR}/tests/fast_math/parent.cmake)
  set_tests_properties(fast_math.consumer fast_math.parent PROPERTIES TIMEOUT 300)
endif()

# The C interface, from C.
if(TARGET physim_c)
  enable_language(C)
  file(GLOB capi_tests CONFIGURE_DEPENDS tests/capi/*.c)
  add_executable(physim_c_test ${capi_tests})
  target_compile_options(physim_c_test PRIVATE "$<$<C_COMPILER_ID:GNU,Clang>:${PHYSIM_USERS_WARNINGS}>")
  set_target_properties(physim_c_test PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF C_STANDARD_REQUIRED ON
                                                 RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_link_libraries(physim_c_test PRIVATE physim_c $<$<PLATFORM_ID:Linux>:m>)
  add_test(NAME capi.c COMMAND physim_c_test)
  add_executable(physim_no_memory tests/no_memory/no_memory.cpp)
  physim_flags(physim_no_memory)
  set_target_properties(physim_no_memory PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_link_libraries(physim_no_memory PRIVATE physim_c)
  foreach(calls IN ITEMS flight batch threads world)
    add_test(NAME capi.no_memory.${calls} COMMAND physim_no_memory ${calls})
    set_tests_properties(capi.no_memory.${calls} PROPERTIES TIMEOUT 300)
  endforeach()
  set_tests_properties(capi.c PROPERTIES TIMEOUT 300)
endif()

# What is installed compiles and links in a project that knows the package alone.
if(TARGET physim_scenario)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" config)
  set(programs_are_small OFF)
  if("${CMAKE_BUILD_TYPE}" STREQUAL Release AND PHYSIM_ISAS STREQUAL native AND CMAKE_CXX_COMPILER_ID STREQUAL GNU
     AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(programs_are_small ON)
  endif()
  add_test(NAME install
           COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DGENERATOR=${CMAKE_GENERATOR}
                   -DCOMPILER=${CMAKE_CXX_COMPILER} "-DFLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${config}}"
                   -DSIZES=${programs_are_small} -DC_COMPILER=${CMAKE_C_COMPILER} -P
                   ${PROJECT_SOURCE_DIR}/tests/install/check.cmake)
  set_tests_properties(install PROPERTIES TIMEOUT 300)
endif()

file(GLOB_RECURSE test_sources CONFIGURE_DEPENDS tests/*.cpp)
list(FILTER test_sources EXCLUDE REGEX "/tests/(additions|capi|install|fast_math|fuzz|golden|hits|no_memory|soak|client|window)/")
if(test_sources)
  find_package(GTest QUIET)
endif()
if(test_sources AND NOT GTest_FOUND)  # the programs build all the same, the tests do not pass
  add_test(NAME GoogleTest_is_missing COMMAND ${CMAKE_COMMAND} -E false)
elseif(test_sources)
  physim_add_executable(physim_tests ${test_sources})
  physim_compile_tests(physim_tests)
  physim_compile_together(physim_tests 8)  # so a test's helpers stand in a namespace of its file's name
  target_include_directories(physim_tests PRIVATE tests)
  target_link_libraries(physim_tests PRIVATE GTest::gtest_main)
  # What nearly every test includes, read once: a third of the time to compile them.
  target_precompile_headers(physim_tests PRIVATE <gtest/gtest.h> <physim/physim.hpp> tests/support.hpp)
  if(TARGET physim_cli)
    add_dependencies(physim_tests physim_cli)
    target_compile_definitions(physim_tests PRIVATE PHYSIM_CLI="$<TARGET_FILE:physim_cli>")
  endif()
  # By itself whether HDF5 is there or not: files that are compiled together are the same everywhere.
  set_source_files_properties(tests/cli/study_columns_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(has_hdf5)
    set_source_files_properties(tests/cli/study_columns_test.cpp PROPERTIES COMPILE_OPTIONS -isystem${HDF5_INCLUDE})
    target_link_libraries(physim_tests PRIVATE ${HDF5_LIBRARY})
  endif()
  if(TARGET physim_client_core)
    physim_add_client_tests()
  endif()
  physim_run_tests(physim_tests "" 1800)
endif()

# The C interface beside C++: it has a copy of the library of its own, hidden in it.
file(GLOB capi_tests CONFIGURE_DEPENDS tests/capi/*.cpp)
if(TARGET physim_c AND capi_tests AND GTest_FOUND)
  physim_add_executable(physim_capi_tests ${capi_tests})
  physim_compile_tests(physim_capi_tests)
  target_link_libraries(physim_capi_tests PRIVATE physim_c GTest::gtest_main)
  physim_run_tests(physim_capi_tests "" 600)
endif()

# Tests of additions, which are there in a copy of the sources that tools/additions.py patches.
file(GLOB addition_sources CONFIGURE_DEPENDS tests/additions/*.cpp)
if(addition_sources AND GTest_FOUND)
  physim_add_executable(physim_additions ${addition_sources})
  target_include_directories(physim_additions PRIVATE tests)
  target_link_libraries(physim_additions PRIVATE GTest::gtest_main physim_c)
endif()

# The examples are what users read and copy: clean under the warnings that users compile with.
file(GLOB example_sources CONFIGURE_DEPENDS examples/*.cpp)
# One of them asks an engine's physics; it is left out where there is none.
if(NOT (PHYSIM_OPTIONAL AND BULLET_INCLUDE_DIR AND BULLET_BulletCollision AND BULLET_LinearMath))
  message(STATUS "Bullet is missing (libbullet-dev): the example engine_scene is left out")
  list(FILTER example_sources EXCLUDE REGEX "/engine_scene\\.cpp$")
endif()
if(NOT TARGET physim_scenario)
  list(FILTER example_sources EXCLUDE REGEX "/scenario_file\\.cpp$")
endif()
# Those in C: clean under the same warnings, as C99.
file(GLOB c_examples CONFIGURE_DEPENDS examples/*.c)
if(NOT has_sdl2)
  message(STATUS "SDL2 is missing (libsdl2-dev): the example c_gun_range is left out")
  list(FILTER c_examples EXCLUDE REGEX "/c_gun_range\\.c$")
endif()
if(TARGET physim_c)
  foreach(source IN LISTS c_examples)
    get_filename_component(name ${source} NAME_WE)
    add_executable(example_${name} ${source})
    target_compile_options(example_${name} PRIVATE "$<$<C_COMPILER_ID:GNU,Clang>:${PHYSIM_USERS_WARNINGS}>")
    target_link_libraries(example_${name} PRIVATE physim_c)
    set_target_properties(example_${name} PROPERTIES OUTPUT_NAME ${name} C_STANDARD 99 C_EXTENSIONS OFF
                                                     RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/examples)
    if(name STREQUAL "c_gun_range")  # it plays by itself, without a screen
      target_link_libraries(example_${name} PRIVATE SDL2::SDL2 $<$<PLATFORM_ID:Linux>:m>)
      add_test(NAME example.${name} COMMAND example_${name} --demo 300)
      set_tests_properties(example.${name} PROPERTIES ENVIRONMENT "SDL_VIDEODRIVER=dummy")
    else()
      add_test(NAME example.${name} COMMAND example_${name})
    endif()
    set_tests_properties(example.${name} PROPERTIES TIMEOUT 600)
  endforeach()
endif()
set(example_headers)  # the example that compiles the library's headers for the others
foreach(source IN LISTS example_sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(example_${name} ${source})
  if(PHYSIM_UNITY AND example_headers)
    target_precompile_headers(example_${name} REUSE_FROM ${example_headers})
  elseif(PHYSIM_UNITY)
    target_precompile_headers(example_${name} PRIVATE <physim/physim.hpp>)
    set(example_headers example_${name})
  endif()
  target_compile_features(example_${name} PRIVATE cxx_std_20)
  target_compile_options(example_${name} PRIVATE "$<$<CXX_COMPILER_ID:GNU,Clang>:${PHYSIM_USERS_WARNINGS}>")
  target_link_libraries(example_${name} PRIVATE physim)
  if(TARGET physim_scenario)
    target_link_libraries(example_${name} PRIVATE physim_scenario)
  endif()
  if(name STREQUAL "engine_scene")
    target_include_directories(example_${name} SYSTEM PRIVATE ${BULLET_INCLUDE_DIR})
    target_link_libraries(example_${name} PRIVATE ${BULLET_BulletCollision} ${BULLET_LinearMath})
  endif()
  set_target_properties(example_${name} PROPERTIES OUTPUT_NAME ${name} RUNTIME_OUTPUT_DIRECTORY
                                                                       ${PROJECT_BINARY_DIR}/examples)
  add_test(NAME example.${name} COMMAND example_${name})
  set_tests_properties(example.${name} PROPERTIES TIMEOUT 600)
endforeach()
