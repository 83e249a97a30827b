# For packages: what takes no time is compiled for size. The linker takes the first copy of a function that many files
# have, so the objects of what flies come first, and what is compiled for size gives it nothing.
#
# warm: scenes, emitters, studies and worlds around their steps.
set(warm_sources ${core_sources})
list(FILTER warm_sources INCLUDE REGEX "src/(collide|emit|study|world)/")
list(FILTER warm_sources EXCLUDE REGEX "src/world/step/")
set(hot_sources ${core_sources})
list(REMOVE_ITEM hot_sources ${warm_sources})

set(core_sources "")
foreach(part IN ITEMS hot warm)
  add_library(physim_${part} OBJECT ${${part}_sources})
  physim_flags(physim_${part})
  physim_compile_together(physim_${part} 24)
  target_include_directories(physim_${part} PRIVATE include src ${physim_generated})
  list(APPEND core_sources $<TARGET_OBJECTS:physim_${part}>)
endforeach()
target_compile_options(physim_warm PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Os>)
