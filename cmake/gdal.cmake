# GDAL, which reads terrain from GeoTIFF and SRTM files (Debian: libgdal-dev); without it such files are refused. One
# file of ours knows it.
find_package(GDAL QUIET)
set_source_files_properties(src/scenario/terrain_file.cpp PROPERTIES COMPILE_DEFINITIONS
                                                                     "PHYSIM_HAS_GDAL=$<BOOL:${GDAL_FOUND}>")
if(GDAL_FOUND)
  target_link_libraries(physim_scenario PRIVATE GDAL::GDAL)
endif()
