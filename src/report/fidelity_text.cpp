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

std::string physics_left_out(const Fidelity& full, const Fidelity& fidelity) {
  std::string out;
  const auto all = fidelity_fields(full), some = fidelity_fields(fidelity);
  for (std::size_t i = 0; i < std::min(all.size(), some.size()); ++i) {  // a body form, the last one, few have
    const std::string_view effect = all[i].effect;
    PHYSIM_ASSERT(some[i].effect == effect);
    const bool is_numerics = effect == "integrator" || effect == "precision" || effect == "body_form";
    if (is_numerics || all[i].rung == some[i].rung) continue;
    out += (out.empty() ? "" : "; ") + std::string(some[i].effect) + " " + std::string(some[i].rung);
  }
  return out;
}

}  // namespace physim::report
