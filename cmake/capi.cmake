# The C interface: one shared library that has all it needs and shows its own functions alone. Its users need a C compiler,
# the headers physim/physim.h and physim/c_*.h, and nothing else.
file(GLOB capi_sources CONFIGURE_DEPENDS src/capi/*.cpp)
add_library(physim_c SHARED ${capi_sources})
add_library(physim::c ALIAS physim_c)
physim_flags(physim_c)
physim_compile_together(physim_c 8)
# Until 1.0 a minor version may break programs: it is in the name that they ask for.
set_target_properties(physim_c PROPERTIES EXPORT_NAME c VERSION ${PROJECT_VERSION} CXX_VISIBILITY_PRESET hidden
                                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
                                          VISIBILITY_INLINES_HIDDEN ON)
target_compile_definitions(physim_c PRIVATE PHYSIM_C_BUILD)
target_include_directories(
  physim_c
  PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
  PRIVATE src)
target_link_libraries(physim_c PRIVATE physim_report)
if(UNIX AND NOT APPLE)  # templates of the C++ library would show otherwise
  set(shown ${PROJECT_SOURCE_DIR}/src/capi/shown.map)
  target_link_options(physim_c PRIVATE LINKER:--version-script=${shown})
  set_target_properties(physim_c PROPERTIES LINK_DEPENDS ${shown})
endif()
