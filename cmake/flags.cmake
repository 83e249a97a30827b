# Our flags, per target: a project that adds PhySim as a subfolder keeps its own.
#
# Determinism rests on IEEE operations in the order written. What flags from outside allow beside them (-ffast-math,
# -Ofast, -funsafe-math-optimizations, -ffp-contract=fast; in CMAKE_CXX_FLAGS or of a project around this one) is taken
# back: ours come behind. base/strict_math.hpp ends a build where that fails.
#
# -fno-math-errno and -fno-trapping-math change no bit of a result; they let the compilers vectorise sqrt and select.
# One string: as a list, CMake would drop what stands in front already, and keep it there.
set(PHYSIM_IEEE "SHELL:-fno-fast-math -fno-associative-math -fno-reciprocal-math -fsigned-zeros -fno-finite-math-only \
-fno-rounding-math")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND PHYSIM_IEEE " -fno-unsafe-math-optimizations -fno-single-precision-constant")
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  string(APPEND PHYSIM_IEEE " -fno-approx-func -fdenormal-fp-math=ieee")
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 18)
    string(APPEND PHYSIM_IEEE " -Wno-overriding-t-option")  # it tells that flags were taken back
  endif()
endif()
string(APPEND PHYSIM_IEEE " -ffp-contract=off -fno-math-errno -fno-trapping-math")

# How far clang looks back through memory for what is known: it stops at a hundred uses of a variable and a hundred
# instructions, and what a step of a known rung reads of its conditions lies farther back. Bits are those of the code.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  include(CheckCXXCompilerFlag)
  set(PHYSIM_FAR "-mllvm -capture-tracking-max-uses-to-explore=10000 -mllvm -memdep-block-scan-limit=20000")
  check_cxx_compiler_flag("${PHYSIM_FAR}" PHYSIM_LOOKS_FAR)
endif()

# Every instruction of this machine, for what is compared with the library. clang 19 warns of processors with AVX10 that
# its own list for them contradicts itself.
set(PHYSIM_NATIVE -march=native)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  check_cxx_compiler_flag(-Winvalid-feature-combination PHYSIM_KNOWS_COMBINATIONS)
  if(PHYSIM_KNOWS_COMBINATIONS)
    list(APPEND PHYSIM_NATIVE -Wno-invalid-feature-combination)
  endif()
endif()

# A switch over an enumeration names every enumerator, so that a new one does not compile until each says what it does.
# Wide vectors in signatures make g++ note an ABI change (psabi); designated initialisers leave fields out on purpose.
set(PHYSIM_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wfloat-conversion
    -Wvla -Wundef -Werror=switch -Werror=switch-enum -Wno-psabi -Wno-missing-field-initializers)
# What users compile with: the examples must be clean under these alone.
set(PHYSIM_USERS_WARNINGS -Wall -Wextra -Wpedantic -Werror)

function(physim_flags target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  # Kernels of wide instruction sets have asserts in debug builds alone: those of base check the same code.
  set(asserts $<AND:$<BOOL:${PHYSIM_ASSERTS}>,$<NOT:$<BOOL:$<TARGET_PROPERTY:PHYSIM_IS_WIDE>>>>)
  target_compile_definitions(${target} PRIVATE PHYSIM_ASSERTS=$<OR:$<CONFIG:Debug>,${asserts}>
                                               $<$<BOOL:${PHYSIM_SMALL_KERNELS}>:PHYSIM_SMALL_KERNELS>)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE ${PHYSIM_WARNINGS} "${PHYSIM_IEEE}")
    # A program keeps the functions that it calls, and no others: --gc-sections, which users of the library link with.
    target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections)
    if(PHYSIM_FOR_SIZE)  # functions that throw nothing are not unwound
      target_compile_options(${target} PRIVATE -fno-asynchronous-unwind-tables)
    endif()
    # Asserts name files from the root of the sources, wherever that is.
    target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Where g++ 12 joins scalars to vectors it fuses alternating sums and differences of products (vfmaddsub),
      # whatever -ffp-contract says, if the whole build is for processors that can.
      target_compile_options(${target} PRIVATE -fno-tree-slp-vectorize)
      # Garbage is collected later: less time, for memory that machines have.
      target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=500000)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarms on std::string (GCC bug 105651)
    endif()
    if(PHYSIM_LOOKS_FAR)
      target_compile_options(${target} PRIVATE "SHELL:${PHYSIM_FAR}")
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      # The mask of a single lane is a bool, joined by & as masks of packs are; libstdc++'s stable_sort uses what it
      # has itself deprecated.
      target_compile_options(${target} PRIVATE -Wno-bitwise-instead-of-logical -Wno-deprecated-declarations)
    endif()
    if(PHYSIM_WERROR)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()

# For packages: what takes no time is compiled small, and so are the kernels of base, in whose place wider ones fly on
# machines of the last ten years. More than half of a package is kernels, whose functions stand wherever they are called.
option(PHYSIM_FOR_SIZE "Compile what is not hot for size" OFF)
set(PHYSIM_SMALLEST $<IF:$<CXX_COMPILER_ID:Clang>,-Oz,-Os>)

# Programs and tests that leave the work to the library: compiled with less effort, in three quarters of the time.
function(physim_compile_sooner target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${PHYSIM_FOR_SIZE}>,${PHYSIM_SMALLEST},-O1>$<SEMICOLON>-g0>)
endfunction()

# Tests: they compute a little themselves; and those that compute nothing, without any effort.
function(physim_compile_tests target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og$<SEMICOLON>-g0>)
endfunction()
function(physim_compile_soonest target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0$<SEMICOLON>-g0>)
endfunction()

# Many files are compiled as one, so that their headers are read once: half of the time. Names of a file's own must then
# differ from those of its neighbours. Debug builds compile one file at a time: each must include what it needs.
option(PHYSIM_UNITY "Compile many files as one, in half of the time" ON)
function(physim_compile_together target files)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${PHYSIM_UNITY} UNITY_BUILD_BATCH_SIZE ${files})
endfunction()
