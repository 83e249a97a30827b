# PhySim's sources take back what the flags of a project around them allow: base/strict_math.hpp ends their compilation
# otherwise. Given: BUILD, SOURCE, GENERATOR, COMPILER.
set(folder ${BUILD}/fast_math_parent)
file(REMOVE_RECURSE ${folder})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/tests/fast_math/parent -B ${folder} -G ${GENERATOR} -DPHYSIM=${SOURCE}
          -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=-Ofast -ffinite-math-only -fno-signed-zeros"
          -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(READ ${folder}/compile_commands.json commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
set(looked_at 0)
foreach(i RANGE ${last})
  string(JSON file GET "${commands}" ${i} file)
  if(NOT file MATCHES "src/math/vec3\\.cpp$|_kernel\\.cpp$")
    continue()
  endif()
  string(JSON command GET "${commands}" ${i} command)
  string(JSON directory GET "${commands}" ${i} directory)
  string(REGEX REPLACE " -o [^ ]+" "" command "${command}")
  string(REPLACE " -c " " -E " command "${command}")
  execute_process(COMMAND sh -c "${command}" WORKING_DIRECTORY ${directory} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  if(NOT command MATCHES "-Ofast.*-ffast-math.*-fno-fast-math.*-ffp-contract=off")
    message(FATAL_ERROR "the flags from outside are not taken back behind them:\n${command}")
  endif()
  math(EXPR looked_at "${looked_at} + 1")
endforeach()
if(looked_at LESS 3)
  message(FATAL_ERROR "only ${looked_at} sources were looked at")
endif()
file(REMOVE_RECURSE ${folder})
