#include "report/ladder.hpp"

#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr double kMicro = 1e6;

bool is_reference(const Ladder& ladder, const RungResult& result) { return &result == &ladder.rungs.back(); }

std::string family_text(const Ladder& ladder, const RungResult& result) {
  return is_reference(ladder, result) ? "reference" : std::string(family_name(result.rung.family));
}

std::vector<std::string> row(const RungResult& result) {
  const FlightCost& cost = result.flight.cost();
  std::string leaves_out = result.leaves_out;
  if (result.flight.fidelity_in_use().fidelity.precision == Precision::float32)
    leaves_out += (leaves_out.empty() ? "" : "; ") + std::string("float32");
  return {result.rung.name(),
          significant(result.error, 3),
          significant(result.time_error, 3),
          std::to_string(cost.steps),
          std::to_string(cost.evaluations),
          readable(result.cost * kMicro, 3),
          leaves_out.empty() ? "-" : leaves_out};
}

}  // namespace

std::string ladder_text(const LadderOfShot& subject, const Style& style) {
  const auto& [scenario, ladder] = subject;
  PHYSIM_ASSERT(!ladder.rungs.empty());
  std::string out = style.bold(one_line(title_of(scenario))) + ": " + one_line(ladder.shot) + "\n";
  const RungResult& reference = ladder.rungs.back();
  const Sample end = reference.flight.end();
  out += "The reference " + std::string(name(reference.flight.outcome())) + " at " + fixed(end.time, 6) + " s, " +
         fixed(end.range, 4) + " m downrange, height " + fixed(end.position.y, 4) + " m, windage " +
         fixed(end.windage, 4) +
         " m. Errors are distances from there.\nCost is the median time of one fly() on this machine.\n\n";
  Table table({"rung", "error [m]", "time error [s]", "steps [-]", "evaluations [-]", "cost [us]", "leaves out"},
              "lrrrrrl");
  std::string family;
  for (const RungResult& result : ladder.rungs) {
    const std::string next = family_text(ladder, result);
    if (next != family) table.add_row({style.dim("- " + next)});
    family = next;
    table.add_row(row(result));
  }
  out += table.text();
  for (const RungLeftOut& rung : ladder.left_out) out += "not shown: " + rung.name + ": " + rung.reason + "\n";
  return out;
}

Records records_of(const LadderOfShot& subject) {
  const auto rows = [&ladder = subject.ladder](const auto& take) {
    for (const RungResult& result : ladder.rungs) {
      const FlightCost& cost = result.flight.cost();
      const std::string family = family_text(ladder, result), rung = result.rung.name();
      const Cell row[] = {ladder.shot,
                          family,
                          rung,
                          result.error,
                          result.time_error,
                          static_cast<std::uint64_t>(cost.steps),
                          static_cast<std::uint64_t>(cost.evaluations),
                          result.cost * kMicro,
                          name(result.flight.outcome()),
                          result.leaves_out};
      take(row);
    }
  };
  return {{"shot", "family", "rung", "error [m]", "time error [s]", "steps [-]", "evaluations [-]", "cost [us]",
           "outcome", "leaves out"},
          rows};
}

Content ladder_json(const LadderOfShot& subject) {
  const auto& [scenario, ladder] = subject;
  nlohmann::ordered_json out = provenance(scenario);
  out["shot"] = ladder.shot;
  out["cost"] = "cost [us] is the median time of one fly()";
  out["rungs"] = nlohmann::ordered_json::array();
  for (const RungResult& result : ladder.rungs) {
    nlohmann::ordered_json rung = {{"rung", result.rung.name()},        {"family", family_text(ladder, result)},
                                   {"error [m]", result.error},         {"time error [s]", result.time_error},
                                   {"cost [us]", result.cost * kMicro}, {"leaves_out", result.leaves_out}};
    rung.update(flight_json(result.flight, result.rung.setting.fidelity));
    out["rungs"].push_back(std::move(rung));
  }
  out["left_out"] = nlohmann::ordered_json::array();
  for (const RungLeftOut& rung : ladder.left_out)
    out["left_out"].push_back({{"rung", rung.name}, {"reason", rung.reason}});
  return json_text(out);
}

}  // namespace physim::report
