#include "simclient/core/emitter_edit.hpp"

#include "emit/drawn.hpp"

namespace physim::client {

std::vector<EmitterLine> lines_of(EmitterDef& def) {
  return {{"rate over the cycle", &def.per_second.curve, nullptr},
          {"speed over the cycle", &def.start.speed.curve, nullptr},
          {"lifetime over the cycle", &def.start.lifetime.curve, nullptr},
          {"gravity over the cycle", &def.start.gravity.curve, nullptr},
          {"size over the cycle", &def.start.size.curve, nullptr},
          {"size over life", &def.life.size.curve, nullptr},
          {"turning over life", &def.life.turn.curve, nullptr},
          {"size by speed", &def.life.size_by_speed, nullptr},
          {"colour over the cycle", nullptr, &def.start.colour.gradient},
          {"colour over life", nullptr, &def.life.colour.gradient},
          {"colour by speed", nullptr, &def.life.colour_by_speed}};
}

double value_of(const Curve& curve, double at) { return EmitCurve(curve)(at); }

std::uint32_t colour_of(const Gradient& gradient, double at) { return EmitGradient(gradient)(at).packed(); }

bool have_same_lines(const EmitterDef& a, const EmitterDef& b) {
  EmitterDef one = a, other = b;
  const auto of_one = lines_of(one), of_other = lines_of(other);
  for (std::size_t i = 0; i < of_one.size(); ++i) {
    const bool is_same =
        of_one[i].curve ? *of_one[i].curve == *of_other[i].curve : *of_one[i].gradient == *of_other[i].gradient;
    if (!is_same) return false;
  }
  return true;
}

}  // namespace physim::client
