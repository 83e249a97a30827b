# The core as objects, by how often they run. The linker takes the first copy of a function that many files have, so the
# objects of what flies come first, and what is compiled with less effort gives it nothing.
#
# hot: what flies. warm, of packages alone: scenes, emitters, studies and worlds around their steps. cold: what checks,
# names, reads, saves and draws.
set(cold_sources ${core_sources})
list(FILTER cold_sources INCLUDE REGEX "src/(\
base/names|settings/row|emit/check|collide/(content|convex_hull|materials|quickhull|scene_draw|scene_save|terrain)|\
flight/(auto_fidelity|auto_fidelity_cache|compare|fidelity_candidates|fit)\\.|\
prepare/(fidelity_presets|projectile_presets)|\
study/(by_distance|check_study|correlation|estimates|indices|linear|names|over_inputs|part|places|plan|run|targets|zone)\\.|\
world/core/check|world/journal/|world/door/(world_detail|world_draw|world_emitters|world_forces|world_scene))")
set(hot_sources ${core_sources})
list(REMOVE_ITEM hot_sources ${cold_sources})
set(warm_sources "")
if(PHYSIM_FOR_SIZE)
  set(warm_sources ${hot_sources})
  list(FILTER warm_sources INCLUDE REGEX "src/(collide|emit|study|world)/")
  list(FILTER warm_sources EXCLUDE REGEX "src/world/step/")
  list(REMOVE_ITEM hot_sources ${warm_sources})
endif()

set(core_objects "")
foreach(part IN ITEMS hot warm cold)
  if(NOT ${part}_sources)
    continue()
  endif()
  add_library(physim_${part} OBJECT ${${part}_sources})
  physim_flags(physim_${part})
  physim_compile_together(physim_${part} 24)
  target_include_directories(physim_${part} PRIVATE include src ${physim_generated})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # Loops of code that is no kernel start where they are: 3 % smaller.
    target_compile_options(physim_${part} PRIVATE -fno-align-loops -fno-align-jumps -fno-align-labels)
  endif()
  list(APPEND core_objects $<TARGET_OBJECTS:physim_${part}>)
endforeach()
if(TARGET physim_warm)
  target_compile_options(physim_warm PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Os>)
endif()
if(TARGET physim_cold)
  physim_compile_sooner(physim_cold)
endif()
