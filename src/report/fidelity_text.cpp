#include "report/fidelity_text.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "physim/names.hpp"

namespace physim::report {

std::vector<FidelityField> fidelity_fields(const Fidelity& f) {
  const auto truth = [](bool value) -> std::string_view { return value ? "true" : "false"; };
  std::vector<FidelityField> fields{{"motion", name(f.motion)},
                                    {"integrator", name(f.integrator)},
                                    {"gravity", name(f.gravity)},
                                    {"drag", name(f.drag)},
                                    {"air", name(f.air)},
                                    {"wind", name(f.wind)},
                                    {"earth", name(f.earth)},
                                    {"rotation", name(f.rotation)},
                                    {"precision", name(f.precision)},
                                    {"interpolation", name(f.interpolation)},
                                    {"planar", truth(f.planar)},
                                    {"aerodynamic_jump", truth(f.aerodynamic_jump)},
                                    {"original_one_shot_forces", truth(f.original_one_shot_forces)}};
  if (f.rotation == RotationModel::rigid_body) fields.push_back({"body_form", name(f.body_form)});
  return fields;
}

std::string preset_name(const Fidelity& fidelity) {
  for (const std::string_view preset : fidelity_presets())
    if (fidelity_preset(preset) == fidelity) return std::string(preset);
  return "custom";
}

std::string in_words(const Fidelity& fidelity) {
  std::string out;
  for (const auto& [effect, rung] : fidelity_fields(fidelity)) {
    if (rung == "false") continue;  // a switch that is off
    out += (out.empty() ? "" : ", ") + std::string(effect) + (rung == "true" ? "" : " " + std::string(rung));
  }
  return out;
}

std::string note_text(const FidelityNote& note) {
  PHYSIM_ASSERT(!note.effect.empty());
  PHYSIM_ASSERT(!note.reason.empty());
  const std::string where = note.granted == note.asked ? "" : " where " + note.asked + " was asked";
  return note.effect + " " + note.granted + where + ": " + note.reason;
}

std::vector<RungApart> rungs_apart(const Fidelity& full, const Fidelity& fidelity) {
  std::vector<RungApart> apart;
  const auto all = fidelity_fields(full), some = fidelity_fields(fidelity);
  for (std::size_t i = 0; i < std::min(all.size(), some.size()); ++i) {  // a body form, the last one, few have
    const std::string_view effect = all[i].effect;
    PHYSIM_ASSERT(some[i].effect == effect);
    const bool is_numerics = effect == "integrator" || effect == "precision" || effect == "body_form";
    if (!is_numerics && all[i].rung != some[i].rung) apart.push_back({effect, all[i].rung, some[i].rung});
  }
  return apart;
}

std::string physics_left_out(const Fidelity& full, const Fidelity& fidelity) {
  std::string out;
  for (const RungApart& each : rungs_apart(full, fidelity))
    out += (out.empty() ? "" : "; ") + std::string(each.effect) + " " + std::string(each.rung);
  return out;
}

namespace {

/// "no drag", "flat earth".
std::string words_of(const RungApart& apart) {
  PHYSIM_ASSERT(apart.full != apart.rung);
  const bool is_off = apart.rung == "off" || apart.rung == "none" || apart.rung == "vacuum";
  if (apart.effect == "rotation" && is_off)
    return apart.full == "magnus" ? "no lift from spin" : apart.full == "rigid_body" ? "no attitude" : "no spin drift";
  if (apart.rung == "false") return "no " + std::string(apart.effect);
  if (apart.rung == "true") return std::string(apart.effect);
  return (is_off ? "no" : std::string(apart.rung)) + " " + std::string(apart.effect);
}

}  // namespace

/// The list omits the air where there is no drag, and interpolation beside other effects.
std::string why_apart(const Fidelity& full, const Fidelity& fidelity) {
  const std::vector<RungApart> apart = rungs_apart(full, fidelity);
  std::string out;
  for (const RungApart& each : apart) {
    const bool is_implied = each.effect == "air" && fidelity.drag == DragModel::off;
    const bool is_small = each.effect == "interpolation" && apart.size() > 1;
    if (is_implied || is_small) continue;
    out += (out.empty() ? "" : ", ") + words_of(each);
  }
  return out;
}

}  // namespace physim::report
