# Installs what was built into a folder of its own, builds a project against it and runs that.
# Given: BUILD, SOURCE, GENERATOR, COMPILER, FLAGS; C_COMPILER: empty if there is no C interface; SIZES: whether programs are as small as in an optimised build.
set(folder ${BUILD}/install_check)
file(REMOVE_RECURSE ${folder})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/prefix OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE package ${folder}/prefix/*physim-*.cmake)
foreach(file IN LISTS package)
  file(READ ${file} text)
  if(text MATCHES "nlohmann|toml")
    message(FATAL_ERROR "${file} asks users for ${CMAKE_MATCH_0}, which only our own sources need")
  endif()
endforeach()

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/tests/install -B ${folder}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
          -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_PREFIX_PATH=${folder}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/build OUTPUT_VARIABLE log RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the project does not build against what was installed:\n${log}")
endif()
execute_process(COMMAND ${folder}/build/my_game OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL "landed flown\n")
  message(FATAL_ERROR "the project printed: ${printed}")
endif()

# The C interface alone: by CMake, without a C++ compiler, and by pkg-config where it is there.
if(C_COMPILER)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/c --component c OUTPUT_QUIET
                          COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/tests/install/c -B ${folder}/c_build -G ${GENERATOR}
                          -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_PREFIX_PATH=${folder}/c
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/c_build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${folder}/c_build/my_range OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE pc ${folder}/c/physim.pc)
  get_filename_component(pc_dir ${pc} DIRECTORY)
  find_program(pkg_config NAMES pkg-config pkgconf)
  if(pkg_config)
    set(ENV{PKG_CONFIG_PATH} ${pc_dir})
    execute_process(COMMAND ${pkg_config} --cflags --libs physim OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    execute_process(COMMAND ${C_COMPILER} -std=c99 ${SOURCE}/tests/install/c/my_range.c -o ${folder}/by_pc ${flags}
                            -Wl,-rpath,${pc_dir}/.. COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${folder}/by_pc OUTPUT_VARIABLE by_pc COMMAND_ERROR_IS_FATAL ANY)
    string(APPEND printed "${by_pc}")
  else()
    string(APPEND printed "landed\n")
  endif()
  if(NOT printed STREQUAL "landed\nlanded\n")
    message(FATAL_ERROR "programs in C printed: ${printed}")
  endif()
endif()

# Programs hold what they use: at most this many bytes, stripped, with a shared C++ library and the kernels of one machine.
function(check_size program most)
  execute_process(COMMAND strip -o ${folder}/small ${folder}/build/${program} COMMAND_ERROR_IS_FATAL ANY)
  file(SIZE ${folder}/small bytes)
  message(STATUS "${program}: ${bytes} bytes")
  if(bytes GREATER most)
    message(FATAL_ERROR "${program} has ${bytes} bytes, and may have ${most}")
  endif()
endfunction()
if(SIZES)
  check_size(one_flight 1500000)
  check_size(one_world 5000000)
endif()
file(REMOVE_RECURSE ${folder})
