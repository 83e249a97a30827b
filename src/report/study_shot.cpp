#include "report/study_shot.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/study_answer.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

/// Where a shot was: rows for people, quantities and hits for programs. `place`: "800 m: " before what is of a place.
struct ToldEnd {
  Json quantities = Json::array(), hits = Json::array();

  ToldEnd(const Study& study, const StudyShots& shots, std::size_t row, const std::string& place, Table& ends,
          Table& targets) {
    PHYSIM_ASSERT(shots.hits.size() == study.targets.size() && shots.quantities.size() == study.quantities.size());
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
      const double number = shots.quantities[q][row];
      const bool arrived = std::isfinite(number);
      const std::string name = with_unit(study.quantities[q]);
      ends.add_row({place + name, arrived ? significant(number, 9) : "did not arrive"});
      quantities.push_back({{"name", name}, {"value", arrived ? Json(number) : Json(nullptr)}});
    }
    for (std::size_t i = 0; i < study.targets.size(); ++i) {
      const bool hit = shots.hits[i][row];
      targets.add_row({place + study.targets[i].name, hit ? "yes" : "no"});
      hits.push_back({{"target", study.targets[i].name}, {"hit", hit}});
    }
  }
};

}  // namespace

Answer study_shot_answer(const AskedShot& asked, const StudyPlan& plan, std::uint64_t shot, const Style& style) {
  const Study& study = plan.study();
  const StudyShots shots = fly_shots_of(plan, shot / study.shard_shots);
  const auto row = static_cast<std::size_t>(shot % study.shard_shots);
  PHYSIM_ASSERT(shots.inputs.size() == study.inputs.size() && shots.at.size() == study.at.size());
  Table drawn({"input", "drawn"}, "l"), ends({"quantity", "end"}, "l"), targets({"target", "hit"}, "l");
  Json inputs = Json::array(), places = Json::array();
  for (std::size_t i = 0; i < study.inputs.size(); ++i) {
    const double number = shots.inputs[i][row];
    drawn.add_row({with_unit(study.inputs[i]), significant(number, 9)});
    inputs.push_back({{"path", study.inputs[i].path}, {"unit", unit_of(study.inputs[i])}, {"drawn", number}});
  }
  ToldEnd end(study, shots, row, "", ends, targets);
  const std::vector<StudyPlan> at = plan.places();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string place = place_text(study.at[i].event);
    ToldEnd there(at[i].study(), shots.at[i], row, place + ": ", ends, targets);
    places.push_back({{"place", place}, {"quantities", there.quantities}, {"hits", there.hits}});
  }
  std::string text = "  shot number " + std::to_string(shot) + " of the study, " + std::string(name(study.sampling)) +
                     ", seed " + std::to_string(study.seed) + "\n\n" + drawn.text(2) + "\n" + ends.text(2);
  if (!targets.empty()) text += "\n" + targets.text(2);
  return about_shot(
      asked, style, text,
      {{"shot_number", shot}, {"inputs", inputs}, {"quantities", end.quantities}, {"hits", end.hits}, {"at", places}});
}

}  // namespace physim::report
