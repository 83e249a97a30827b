// Whether all functions were given again that a save or a recording needs.
#include <algorithm>

#include "world/journal/save.hpp"

namespace physim {

Status check_given(const FunctionCounts& needed, const LoadOptions& given, const std::string& what) {
  const auto check = [&what](const auto& list, std::size_t count, const char* place, const char* name) -> Status {
    const auto there = std::count_if(list.begin(), list.end(), [](const auto& f) {
      if constexpr (requires { f.function; })
        return bool(f.function);
      else
        return bool(f);
    });
    if (count <= static_cast<std::size_t>(there)) return {};
    return Error{what + " has " + std::to_string(count) + " " + name + ", and " + std::to_string(there) +
                     " functions were given",
                 place, "no file holds functions: give them in the order in which the world came to know them"};
  };
  if (Status s = check(given.custom_forces, needed.custom_forces, "custom_forces", "custom forces"); !s) return s;
  if (Status s = check(given.wind_fields, needed.wind_fields, "wind_fields", "fields of wind"); !s) return s;
  if (Status s = check(given.force_fields, needed.force_fields, "force_fields", "fields of force"); !s) return s;
  if (Status s = check(given.engine_queries, needed.engine_queries, "engine_queries", "engines of scenes"); !s)
    return s;
  if (!needed.hit_function || given.hit_function) return {};
  return Error{what + " has hits that ask, and no function was given", "hit_function", "no file holds functions"};
}

}  // namespace physim
