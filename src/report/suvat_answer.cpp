// What `physim suvat` says.
#include <algorithm>
#include <array>

#include "base/assert.hpp"
#include "physim/result.hpp"
#include "report/answer.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

struct SuvatColumn {
  const char* title;
  std::optional<double> SuvatGiven::*given;
  double Suvat::*found;
};
constexpr std::array<SuvatColumn, 5> kSuvatColumns = {{{"s [m]", &SuvatGiven::s, &Suvat::s},
                                                       {"u [m/s]", &SuvatGiven::u, &Suvat::u},
                                                       {"v [m/s]", &SuvatGiven::v, &Suvat::v},
                                                       {"a [m/s^2]", &SuvatGiven::a, &Suvat::a},
                                                       {"t [s]", &SuvatGiven::t, &Suvat::t}}};

}  // namespace

Answer suvat_answer(const SuvatGiven& given, std::span<const Suvat> motions) {
  PHYSIM_ASSERT(!motions.empty());
  PHYSIM_ASSERT(motions.size() <= 2);
  std::vector<std::string> titles;
  nlohmann::ordered_json asked = nlohmann::ordered_json::object(), found = nlohmann::ordered_json::array();
  for (const SuvatColumn& column : kSuvatColumns) {
    titles.emplace_back(column.title);
    if (given.*column.given) asked[column.title] = *(given.*column.given);
  }
  Table table(titles);
  for (const Suvat& motion : motions) {
    std::vector<std::string> cells;
    nlohmann::ordered_json& row = found.emplace_back(nlohmann::ordered_json::object());
    for (const SuvatColumn& column : kSuvatColumns) {
      cells.push_back(significant(motion.*column.found, 6));
      row[column.title] = motion.*column.found;
    }
    table.add_row(std::move(cells));
  }
  std::string text = table.text(2);
  if (std::ranges::any_of(motions, [](const Suvat& motion) { return motion.t < 0; }))
    text += "  t < 0: before the start\n";
  return {text,
          as_text(json_text({{"version", kVersion}, {"given", std::move(asked)}, {"motions", std::move(found)}}))};
}

}  // namespace physim::report
