# SimClient: the logic (a library without a window, so that it is tested without one) and the program.
# Debian 12: libglfw3-dev libimgui-dev libstb-dev libepoxy-dev.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(CLIENT_LIBRARIES_OF IMPORTED_TARGET glfw3 epoxy imgui stb)
endif()
set(PHYSIM_HAS_CLIENT ${CLIENT_LIBRARIES_OF_FOUND})

file(GLOB client_core_sources CONFIGURE_DEPENDS apps/simclient/core/*.cpp)
add_library(physim_client_core STATIC ${client_core_sources})
physim_flags(physim_client_core)
physim_compile_sooner(physim_client_core)
target_include_directories(physim_client_core PUBLIC apps PRIVATE src)
target_link_libraries(physim_client_core PUBLIC physim_report PRIVATE nlohmann_json::nlohmann_json)
target_compile_definitions(physim_client_core PRIVATE PHYSIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

# Tests of the logic; and in a window: on a screen in memory (xvfb), with events as from a hand (libxtst-dev).
function(physim_add_client_tests)
  file(GLOB test_files CONFIGURE_DEPENDS tests/client/*.cpp)
  physim_add_executable(physim_client_tests ${test_files})
  physim_compile_sooner(physim_client_tests)
  target_include_directories(physim_client_tests PRIVATE tests)
  target_link_libraries(physim_client_tests PRIVATE GTest::gtest_main physim_client_core)
  gtest_discover_tests(physim_client_tests TEST_PREFIX "client." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 300)

  find_program(XVFB Xvfb)
  find_package(X11 QUIET)
  if(NOT TARGET simclient OR NOT XVFB OR NOT X11_XTest_FOUND OR NOT GTest_FOUND)
    add_test(NAME client_window COMMAND ${CMAKE_COMMAND} -E echo "left out: needs SimClient, xvfb and libxtst-dev")
    set_tests_properties(client_window PROPERTIES SKIP_REGULAR_EXPRESSION "left out")
    return()
  endif()
  file(GLOB window_sources CONFIGURE_DEPENDS tests/window/*.cpp)
  physim_add_executable(physim_window_tests ${window_sources})
  physim_compile_sooner(physim_window_tests)
  add_dependencies(physim_window_tests simclient)
  target_include_directories(physim_window_tests PRIVATE tests)
  target_link_options(physim_window_tests PRIVATE -Wl,--as-needed)
  target_compile_definitions(physim_window_tests PRIVATE PHYSIM_SIMCLIENT="$<TARGET_FILE:simclient>")
  target_link_libraries(physim_window_tests PRIVATE GTest::gtest_main X11::X11 X11::Xtst PkgConfig::CLIENT_LIBRARIES_OF)
  gtest_discover_tests(physim_window_tests TEST_PREFIX "window." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES
                       TIMEOUT 300)
endfunction()

if(NOT PHYSIM_HAS_CLIENT)
  message(STATUS "SimClient is left out: it needs glfw3, epoxy, imgui and stb (./dev client installs them)")
  return()
endif()
file(GLOB client_sources CONFIGURE_DEPENDS apps/simclient/*.cpp apps/simclient/gl/*.cpp apps/simclient/ui/*.cpp)
physim_add_executable(simclient ${client_sources})
physim_compile_sooner(simclient)
target_link_libraries(simclient PRIVATE physim_client_core CLI11::CLI11 PkgConfig::CLIENT_LIBRARIES_OF)
