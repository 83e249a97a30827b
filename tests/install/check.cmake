# Installs what was built into a folder of its own, builds a project against it and runs that.
# Given: BUILD, SOURCE, GENERATOR, COMPILER, FLAGS; SIZES: whether programs are as small as in an optimised build.
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
