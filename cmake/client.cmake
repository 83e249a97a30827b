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
target_include_directories(physim_client_core PUBLIC apps PRIVATE src)
target_link_libraries(physim_client_core PUBLIC physim_scenario)

if(NOT PHYSIM_HAS_CLIENT)
  message(STATUS "SimClient is left out: it needs glfw3, epoxy, imgui and stb (./dev client installs them)")
  return()
endif()
file(GLOB client_sources CONFIGURE_DEPENDS apps/simclient/*.cpp apps/simclient/gl/*.cpp apps/simclient/ui/*.cpp)
physim_add_executable(simclient ${client_sources})
target_link_libraries(simclient PRIVATE physim_client_core CLI11::CLI11 PkgConfig::CLIENT_LIBRARIES_OF)
