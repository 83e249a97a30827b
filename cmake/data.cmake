# Data that the library has within itself, as C++.

# The core opens no file. A row "0.5,0.1194" of a table becomes "{0.5,0.1194},".
set(text [[// Made by cmake/data.cmake of data/drag/*.csv.
#pragma once

#include "physim/projectile.hpp"

namespace physim {
]])
file(GLOB drag_tables CONFIGURE_DEPENDS data/drag/*.csv)
foreach(table IN LISTS drag_tables)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  get_filename_component(name ${table} NAME_WE)
  string(TOUPPER ${name} name)
  file(STRINGS ${table} rows REGEX "^[0-9]")
  list(TRANSFORM rows REPLACE "(.+)" "    {\\1}")
  list(JOIN rows ",\n" rows)
  string(APPEND text "constexpr DragPoint kDrag${name}[] = {\n${rows}};\n")
endforeach()
file(CONFIGURE OUTPUT ${physim_generated}/model/drag_tables.hpp CONTENT "${text}}  // namespace physim\n")

# Suites fly the check-cases as their scenarios have them, wherever the figures lie that they are compared with.
set(text "// Made by cmake/data.cmake of scenarios/nesc_case*.toml.\n#pragma once\n\n")
string(APPEND text "namespace physim::validation {\nconstexpr const char* kNescCases[] = {\n")
file(GLOB cases CONFIGURE_DEPENDS scenarios/nesc_case*.toml)
foreach(case IN LISTS cases)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${case})
  file(READ ${case} scenario)
  string(APPEND text "R\"toml(${scenario})toml\",\n")
endforeach()
file(CONFIGURE OUTPUT ${physim_generated}/validation/nesc_cases.hpp CONTENT "${text}};\n}  // namespace physim::validation\n" @ONLY)
