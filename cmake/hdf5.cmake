# HDF5, in which `physim study` writes shots one by one (Debian: libhdf5-dev); without it that option is refused. One
# file of ours knows it. A build of HDF5 for MPI, which wants the headers of that, is left aside.
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)
if(HDF5_INCLUDE AND HDF5_LIBRARY)
  set(CMAKE_REQUIRED_INCLUDES ${HDF5_INCLUDE})
  check_include_file_cxx(hdf5.h PHYSIM_FOUND_HDF5)
  unset(CMAKE_REQUIRED_INCLUDES)
endif()
set_source_files_properties(apps/cli/study_columns.cpp PROPERTIES COMPILE_DEFINITIONS
                                                                  "PHYSIM_HAS_HDF5=$<BOOL:${PHYSIM_FOUND_HDF5}>")
if(PHYSIM_FOUND_HDF5)
  set_property(SOURCE apps/cli/study_columns.cpp PROPERTY COMPILE_OPTIONS -isystem${HDF5_INCLUDE})
  target_link_libraries(physim_cli PRIVATE ${HDF5_LIBRARY})
endif()
