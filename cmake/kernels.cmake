# Kernel files (src/*/*_kernel.cpp) are compiled once per instruction set, each copy in the namespace PHYSIM_ISA; the
# library chooses among them at run time. PHYSIM_HAVE_AVX2 and PHYSIM_HAVE_AVX512 (0 or 1) tell it which copies exist.
#
# They are optimised in a debug build too: a helper left un-inlined there would be a weak symbol that the linker may
# share with code for older processors. `./dev lint` checks that no such symbol is left.

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(physim_isas base avx2 avx512)
else()
  set(physim_isas base)
endif()
set(PHYSIM_ISAS all CACHE STRING
    "Instruction sets that kernels are compiled for: all; native: base and the best that runs here; or a list of base \
avx2 avx512")

# base, and the best that this machine runs, by the questions that src/base/kernel_choice.cpp asks at run time.
function(physim_native_isas out)
  if(CMAKE_CROSSCOMPILING)
    message(FATAL_ERROR "PHYSIM_ISAS=native: the machine that will run this is another one; give all, or a list")
  endif()
  include(CheckCXXSourceRuns)
  set(has "__builtin_cpu_supports")
  foreach(isa IN ITEMS avx512 avx2)
    if(NOT isa IN_LIST physim_isas)
      continue()
    endif()
    if(isa STREQUAL avx512)
      set(all "${has}(\"avx512f\") && ${has}(\"avx512vl\") && ${has}(\"avx512bw\") && ${has}(\"avx512dq\") && "
              "${has}(\"avx512cd\")")
    else()
      set(all "${has}(\"avx2\") && ${has}(\"fma\") && ${has}(\"bmi2\")")
    endif()
    string(JOIN "" all ${all})
    unset(PHYSIM_RUNS_${isa} CACHE)  # the folder may have come from another machine
    check_cxx_source_runs("int main() { return !(${all}); }" PHYSIM_RUNS_${isa})
    if(PHYSIM_RUNS_${isa})
      set(${out} base ${isa} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${out} base PARENT_SCOPE)
endfunction()

# The list that PHYSIM_ISAS asks for.
function(physim_isas_asked out)
  set(isas ${PHYSIM_ISAS})
  if("${PHYSIM_ISAS}" STREQUAL all)
    set(isas ${physim_isas})
  elseif("${PHYSIM_ISAS}" STREQUAL native)
    physim_native_isas(isas)
  endif()
  foreach(isa IN LISTS isas)
    if(NOT isa IN_LIST physim_isas)
      message(FATAL_ERROR "PHYSIM_ISAS: there is no \"${isa}\" here; give all, native, or a list of: ${physim_isas}")
    endif()
  endforeach()
  if(PHYSIM_SMALL_KERNELS AND NOT isas STREQUAL base)
    message(FATAL_ERROR "PHYSIM_SMALL_KERNELS: they are of base alone, give PHYSIM_ISAS=base")
  endif()
  if(NOT base IN_LIST isas)
    message(FATAL_ERROR "PHYSIM_ISAS: base is missing; it is what flies where nothing else runs")
  endif()
  set(${out} ${isas} PARENT_SCOPE)
endfunction()

set(physim_isa_flags_base "")
set(physim_isa_flags_avx2 -march=x86-64-v3)
set(physim_isa_flags_avx512 -march=x86-64-v4)

# For sanitizers, which take many minutes and gigabytes to compile kernels as they ship, and for a first look: functions
# are called instead of written out again and again, on fewer registers at a time, and without guards around variables on
# the stack; all other memory is checked.
option(PHYSIM_SMALL_KERNELS "Compile slow kernels, of base alone, in a fifth of the time" OFF)

# PHYSIM_BATCH_PACKS: packs of one register that a batch flies side by side; PHYSIM_PACK_BYTES: size of the packs that a
# world steps.
# PHYSIM_PACKS_ALONE: 1 in the copies that go without a loop over plain numbers, which those of base and avx2 have.
function(physim_add_kernels target)
  physim_isas_asked(isas)
  foreach(isa IN ITEMS avx2 avx512)
    string(TOUPPER ${isa} ISA)
    list(FIND isas ${isa} at)
    target_compile_definitions(${target} PRIVATE PHYSIM_HAVE_${ISA}=$<NOT:$<EQUAL:${at},-1>>)
  endforeach()
  if(NOT ARGN)
    return()
  endif()
  foreach(isa IN LISTS isas)
    set(kernels ${target}_kernels_${isa})
    set(narrow ${PHYSIM_SMALL_KERNELS})
    if(PHYSIM_ISAS STREQUAL native AND isa STREQUAL base AND NOT isas STREQUAL base)
      set(narrow ON)  # a better copy flies here: this one is for tests, and compiles in a quarter of the time
    endif()
    add_library(${kernels} OBJECT ${ARGN})
    physim_flags(${kernels})
    target_compile_definitions(
      ${kernels} PRIVATE PHYSIM_ISA=${isa} PHYSIM_PACKS_ALONE=$<STREQUAL:${isa},avx512>
                         PHYSIM_BATCH_PACKS=$<IF:$<BOOL:${PHYSIM_SMALL_KERNELS}>,2,4>
                         "PHYSIM_PACK_BYTES=$<IF:$<BOOL:${narrow}>,1,2> * kNativeBytes")
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      # Their vectors are written out; `./dev determinism` sees to it that nothing in them is fused.
      target_compile_options(${kernels} PRIVATE ${physim_isa_flags_${isa}} $<$<CONFIG:Release,RelWithDebInfo>:-O3>
                                                $<$<CONFIG:Debug>:-O2> -ftree-slp-vectorize)
      # Of themselves compilers copy vectors of packs by halves of registers, and a register that is read where its halves
      # have just been written waits until they are in the cache; or they call memcpy(), which keeps nothing in registers.
      if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND isa STREQUAL avx512)
        target_compile_options(${kernels} PRIVATE -mprefer-vector-width=512)
      elseif(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND isa STREQUAL avx2
             AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
        target_compile_options(${kernels} PRIVATE -mmove-max=256 -mstore-max=256)
      endif()
      if(PHYSIM_SMALL_KERNELS)
        set(no_guards $<IF:$<CXX_COMPILER_ID:GNU>,--param=asan-stack=0,SHELL:-mllvm -asan-stack=0>)
        # At -O1 g++ 12 does not survive the selects of packs (gimple-isel.cc).
        target_compile_options(${kernels} PRIVATE $<IF:$<CXX_COMPILER_ID:GNU>,-O2,-O1> ${no_guards})
      endif()
    endif()
    target_include_directories(${kernels} PRIVATE include src)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
