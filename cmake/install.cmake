# `cmake --install build/release --prefix DIR`, then find_package(physim) and link physim::physim, or physim::scenario
# for scenario, motor and recording files.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS physim EXPORT physim_targets)
if(TARGET physim_scenario)
  install(TARGETS physim_scenario EXPORT physim_targets)
endif()
install(DIRECTORY include/physim TYPE INCLUDE)
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/physim/data)
if(TARGET physim_cli)
  install(TARGETS physim_cli)
endif()

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/physim)
install(EXPORT physim_targets FILE physim-targets.cmake NAMESPACE physim:: DESTINATION ${config_dir})
if(has_assimp AND TARGET physim_scenario)  # its static library is linked with it
  set(needs_assimp "find_dependency(assimp)\n")
endif()
file(WRITE ${PROJECT_BINARY_DIR}/physim-config.cmake "include(CMakeFindDependencyMacro)
find_dependency(Threads)
${needs_assimp}include(\${CMAKE_CURRENT_LIST_DIR}/physim-targets.cmake)
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/physim-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/physim-config.cmake ${PROJECT_BINARY_DIR}/physim-config-version.cmake
        DESTINATION ${config_dir})
