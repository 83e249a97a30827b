# GDAL, which reads terrain from GeoTIFF and SRTM files (Debian: libgdal-dev); without it such files are refused. One
# file of ours knows it, and loads it when it is wanted: by the name that its ABI has, "libgdal.so.32".
find_package(GDAL QUIET)
if(GDAL_FOUND)
  file(REAL_PATH "${GDAL_LIBRARY}" gdal_file)
  get_filename_component(gdal_file "${gdal_file}" NAME)
  string(REGEX REPLACE "^(.*[.]so[.][0-9]+).*$" "\\1" gdal_file "${gdal_file}")
  target_include_directories(physim_scenario SYSTEM PRIVATE ${GDAL_INCLUDE_DIRS})
  target_link_libraries(physim_scenario PRIVATE ${CMAKE_DL_LIBS})
endif()
set_source_files_properties(
  src/scenario/terrain_file.cpp PROPERTIES COMPILE_DEFINITIONS
                                           "PHYSIM_HAS_GDAL=$<BOOL:${GDAL_FOUND}>;PHYSIM_GDAL_FILE=\"${gdal_file}\"")
