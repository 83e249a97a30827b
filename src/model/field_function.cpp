// Equations, symbols and Source: model/field_function.hpp.
#include "model/field_function.hpp"

#include <limits>

namespace physim {
namespace {

bool is_number(double x) { return x - x == 0; }
bool is_number(const Vec3d& v) { return is_number(v.x) && is_number(v.y) && is_number(v.z); }

WindBatch batch_of(const WindFunction::Function&, const AskedLanes& lanes, std::size_t first, std::size_t count) {
  return {{lanes.time + first, count}, {lanes.position + first, count}, {lanes.answer + first, count}};
}
FieldForceBatch batch_of(const ForceFunction::Function&, const AskedLanes& lanes, std::size_t first,
                         std::size_t count) {
  return {{lanes.time + first, count},
          {lanes.position + first, count},
          {lanes.velocity + first, count},
          {lanes.mass + first, count},
          {lanes.answer + first, count}};
}

/// Whether it answered.
template <class Function>
bool answers(const Function& function, const AskedLanes& lanes, std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < first + count; ++i) lanes.answer[i] = {};
  try {
    function(batch_of(function, lanes, first, count));
  } catch (...) {  // no kernel lets it through
    return false;
  }
  return true;
}

template <class Function>
void ask_any(const Function& function, const AskedLanes& lanes) {
  PHYSIM_ASSERT(function && lanes.count > 0);
  const auto count = static_cast<std::size_t>(lanes.count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_number(lanes.time[i])) lanes.time[i] = 0;
    if (!is_number(lanes.mass[i])) lanes.mass[i] = 0;
    if (!is_number(lanes.position[i])) lanes.position[i] = {};
    if (!is_number(lanes.velocity[i])) lanes.velocity[i] = {};
  }
  if (answers(function, lanes, 0, count)) return;
  // Each alone, so that what stands beside a place changes nothing there.
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i)
    if (!answers(function, lanes, i, 1)) lanes.answer[i] = {kNan, kNan, kNan};
}

}  // namespace

void ask(const WindFunction::Function& function, const AskedLanes& lanes) { ask_any(function, lanes); }
void ask(const ForceFunction::Function& function, const AskedLanes& lanes) { ask_any(function, lanes); }

}  // namespace physim
