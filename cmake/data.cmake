# Tables of data/ that the core needs, as C++: it opens no file. A row "0.5,0.1194" becomes "{0.5,0.1194},".
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
