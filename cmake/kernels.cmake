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
set(PHYSIM_ISAS ${physim_isas} CACHE STRING
    "Instruction sets that kernels are compiled for, of: base avx2 avx512; or native: base and the best that runs here")

# base, and the best that this machine runs, by the questions that src/flight/kernels.cpp asks at run time.
function(physim_native_isas out)
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
    check_cxx_source_runs("int main() { return !(${all}); }" PHYSIM_RUNS_${isa})
    if(PHYSIM_RUNS_${isa})
      set(${out} base ${isa} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${out} base PARENT_SCOPE)
endfunction()

set(physim_isa_flags_base "")
set(physim_isa_flags_avx2 -march=x86-64-v3)
set(physim_isa_flags_avx512 -march=x86-64-v4)

function(physim_add_kernels target)
  set(isas ${PHYSIM_ISAS})
  if(isas STREQUAL native)
    physim_native_isas(isas)
  endif()
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
    add_library(${kernels} OBJECT ${ARGN})
    physim_flags(${kernels})
    target_compile_definitions(${kernels} PRIVATE PHYSIM_ISA=${isa})
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      target_compile_options(${kernels} PRIVATE ${physim_isa_flags_${isa}} $<$<CONFIG:Release,RelWithDebInfo>:-O3>
                                                $<$<CONFIG:Debug>:-O2>)
    endif()
    target_include_directories(${kernels} PRIVATE include src)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
