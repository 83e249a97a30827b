#include "report/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "scenario/names.hpp"
#include "scenario/units.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double part) { return significant(100 * part, 3); }

/// The unit in which the text of an input has its numbers; null if none has that path, or it has no unit.
const Unit* unit_of_text(const StudyInput& input, std::span<const std::string> texts) {
  for (const std::string& text : texts)
    if (trimmed(std::string_view(text).substr(0, text.find_first_of("+="))) == input.path)
      return last_unit(text, quantity_of_si_unit(unit_of(input)));
  return nullptr;
}
/// The unit behind a number; a plain one has none.
std::string name_of(const Unit* unit, const StudyInput& input) {
  const std::string name = unit != nullptr ? std::string(unit->name) : unit_of(input);
  return name == "-" ? "" : name;
}
/// A difference of SI numbers, in a unit.
double in_unit(double difference, const Unit* unit) {
  return unit == nullptr ? difference : difference * unit->divisor / unit->factor;
}

// -------------------------------------------------------------------------------------------------------------- text
std::string counts_text(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  std::string text = "  " + std::to_string(r.shots) + " shots in " + std::to_string(r.shards) + " shards, " +
                     std::string(name(flown.plan.study().sampling)) + ", seed " +
                     std::to_string(flown.plan.study().seed);
  if (r.time_was_up) text += "; the time was up, and --shots " + std::to_string(r.shots) + " gives the same again";
  if (misses_width(flown.plan.study(), r)) text += "; the width asked for takes more shots than these";
  if (r.not_arrived > 0) text += "; " + std::to_string(r.not_arrived) + " did not arrive";
  if (r.refused > 0)
    text += "; " + std::to_string(r.refused) + " refused: " + in_files(within_sentence(*r.first_refusal));
  return text + "\n\n";
}

std::string quantities_text(const FlownStudy& flown) {
  Table table({"", "mean", "+-", "deviation", "by slopes", "5 %", "50 %", "95 %"}, "l");
  const std::size_t n = flown.result.quantities.size();
  for (std::size_t i = 0; i < n; ++i) {
    const QuantityResult& q = flown.result.quantities[i];
    table.add_row({with_unit(q.quantity), significant(q.mean.value, 6), significant(q.mean.error, 2),
                   significant(q.deviation, 4),
                   flown.linear ? significant(std::sqrt(flown.linear->covariance[i * n + i]), 4) : "",
                   significant(q.cells.quantile(0.05), 5), significant(q.cells.quantile(0.5), 5),
                   significant(q.cells.quantile(0.95), 5)});
  }
  return table.text(2) + "\n";
}

/// How far a zone reaches along the axes of the plane.
std::string zone_text(const ZoneResult& zone) {
  PHYSIM_ASSERT(!zone.corners.empty());
  constexpr double kUpwards = 1.005;  // so that three digits never tell less than may lie outside
  const auto [left, right] = std::ranges::minmax(zone.corners, {}, &PlanePoint::right);
  const auto [low, high] = std::ranges::minmax(zone.corners, {}, &PlanePoint::up);
  return "a zone from " + significant(left.right, 4) + " to " + significant(right.right, 4) + " m and from " +
         significant(low.up, 4) + " to " + significant(high.up, 4) + " m holds all but " +
         significant(kUpwards * 100 * (1 - zone.holds), 3) + " % of all shots that arrive, 95 % sure";
}

std::string plane_text(const StudyResult& r) {
  if (!r.from_aim || !r.from_centre) return "";
  Table table({"distance [m]", "mean", "CEP", "R90", "R95"}, "l");
  const auto add = [&](const char* from, const RadiusResult& radius) {
    table.add_row({from, significant(radius.mean.value, 4), significant(radius.r50, 4), significant(radius.r90, 4),
                   significant(radius.r95, 4)});
  };
  add("from the aim", *r.from_aim);
  add("from the centre", *r.from_centre);
  std::string text = table.text(2);
  if (r.ellipse)
    text += "  ellipse of one deviation: " + significant(r.ellipse->long_axis, 4) + " m by " +
            significant(r.ellipse->short_axis, 4) + " m, its long axis " + fixed(r.ellipse->angle / kDegree, 1) +
            " deg from the first axis\n";
  for (const SpreadResult& s : r.spreads)
    text += "  extreme spread of " + std::to_string(s.size) + " shots: " + significant(s.mean.value, 4) +
            " m, 90 % between " + significant(s.cells.quantile(0.05), 3) + " and " +
            significant(s.cells.quantile(0.95), 3) + " m\n";
  if (r.zone) text += "  " + zone_text(*r.zone) + "\n";
  return text + "\n";
}

/// A circle is given by its radius, a rectangle by its sides.
std::string shape_text(const StudyTarget& target) {
  const auto metres = [](double length) { return significant(length, 4) + " m"; };
  if (const auto* circle = std::get_if<CircleTarget>(&target.shape)) return "radius " + metres(circle->radius);
  if (const auto* sides = std::get_if<RectangleTarget>(&target.shape))
    return metres(sides->width) + " x " + metres(sides->height);
  return std::holds_alternative<PolygonTarget>(target.shape) ? "polygon" : "thing";
}

std::string hits_text(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  const std::vector<StudyTarget>& targets = flown.plan.study().targets;
  if (r.hits.empty()) return "";
  PHYSIM_ASSERT(r.hits.size() == targets.size());
  Table table({"target", "", "hits [%]", "95 % interval"}, "llr");
  for (std::size_t i = 0; i < r.hits.size(); ++i) {
    const HitResult& hit = r.hits[i];
    table.add_row({hit.name, shape_text(targets[i]), percent(hit.probability.value),
                   percent(hit.low) + " .. " + percent(hit.high)});
  }
  return table.text(2) + "\n";
}

/// What each input does: its effect by slopes, and its share of the variance of the plane's axes and of the misses.
std::string inputs_text(const FlownStudy& flown) {
  PHYSIM_ASSERT(flown.units.size() == flown.plan.study().inputs.size());
  if (!flown.linear) return "";
  const Study& study = flown.plan.study();
  const std::size_t shown = std::min<std::size_t>(2, flown.result.quantities.size());
  std::vector<std::string> headers = {"input", "deviation"};
  for (std::size_t q = 0; q < shown; ++q) {
    headers.push_back("on " + with_unit(flown.result.quantities[q].quantity));
    headers.push_back("share [%]");
  }
  const bool tells_misses = !flown.linear->rows.empty() && !flown.linear->rows.front().misses.empty();
  std::vector<std::size_t> told;  // targets on the plane
  for (std::size_t i = 0; i < study.targets.size() && tells_misses; ++i)
    if (!std::holds_alternative<ThingTarget>(study.targets[i].shape)) told.push_back(i);
  for (const std::size_t i : told) headers.push_back("misses of " + study.targets[i].name + " [%]");
  Table table(headers, "l");
  for (const LinearRow& row : flown.linear->rows) {
    const StudyInput& input = study.inputs[row.input];
    const Unit* unit = flown.units[row.input];
    const std::string unit_name = name_of(unit, input);
    std::vector<std::string> cells = {input.path + (unit_name.empty() ? "" : " [" + unit_name + "]"),
                                      significant(in_unit(row.deviation, unit), 3)};
    for (std::size_t q = 0; q < shown; ++q) {
      cells.push_back(significant(row.effect[q], 3));
      cells.push_back(percent(row.share[q]));
    }
    for (const std::size_t i : told) cells.push_back(std::isfinite(row.misses[i]) ? fixed(100 * row.misses[i], 1) : "");
    table.add_row(std::move(cells));
  }
  return table.text(2) + "\n";
}

std::string over_inputs_text(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  if (r.over_inputs.empty()) return "";
  std::vector<std::string> headers = {"hits over an input", "from", "to"};
  for (const HitResult& hit : r.hits) headers.insert(headers.end(), {hit.name + " [%]", "95 % interval"});
  Table table(headers, "lr");
  const auto end = [](double x) { return std::isfinite(x) ? significant(x, 5) : std::string(); };
  for (const HitsOverInput& over : r.over_inputs)
    for (const InputPart& part : over.parts) {
      const std::string name = with_unit(flown.plan.study().inputs[over.input]);
      std::vector<std::string> cells = {&part == &over.parts.front() ? name : "", end(part.low), end(part.high)};
      for (const HitResult& hit : part.hits)
        cells.insert(cells.end(), {percent(hit.probability.value), percent(hit.low) + " .. " + percent(hit.high)});
      table.add_row(std::move(cells));
    }
  return table.text(2) + "\n";
}

Json over_inputs_json(const FlownStudy& flown) {
  const auto end = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  Json inputs = Json::array();
  for (const HitsOverInput& over : flown.result.over_inputs) {
    Json parts = Json::array();
    for (const InputPart& part : over.parts) {
      Json hits = Json::array();
      for (const HitResult& hit : part.hits)
        hits.push_back({{"target", hit.name},
                        {"probability", hit.probability.value},
                        {"low", end(hit.low)},
                        {"high", end(hit.high)}});
      parts.push_back({{"low", end(part.low)},
                       {"middle", part.middle},
                       {"high", end(part.high)},
                       {"shots", part.shots},
                       {"hits", std::move(hits)}});
    }
    const StudyInput& input = flown.plan.study().inputs[over.input];
    inputs.push_back({{"path", input.path}, {"unit", unit_of(input)}, {"parts", std::move(parts)}});
  }
  return inputs;
}

Json histograms_json(const FlownStudy& flown) {
  Json list = Json::array();
  for (const NamedHistogram& histogram : histograms_of(flown)) {
    Json low = Json::array(), high = low, count = low;
    for (const HistogramBar& bar : histogram.bars)
      low.push_back(bar.low), high.push_back(bar.high), count.push_back(bar.count);
    list.push_back({{"name", histogram.name},
                    {"unit", histogram.unit},
                    {"low", std::move(low)},
                    {"high", std::move(high)},
                    {"count", std::move(count)}});
  }
  return list;
}

std::string indices_text(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  if (r.indices.empty()) return "";
  Table table({"Sobol indices", "of", "first", "+-", "total", "+-"}, "ll");
  for (const IndexResult& index : r.indices)
    for (std::size_t q = 0; q < index.first.size(); ++q) {
      const std::string inputs = q == 0 ? names_of_inputs(flown.plan.study(), index.inputs) : "";
      const std::string of(name(r.quantities[q].quantity));
      if (r.quantities[q].varies())
        table.add_row({inputs, of, fixed(index.first[q].value, 3), significant(index.first[q].error, 2),
                       fixed(index.total[q].value, 3), significant(index.total[q].error, 2)});
      else
        table.add_row({inputs, of, "no variance", "", "", ""});
    }
  return table.text(2) + "\n";
}

std::string worst_text(const FlownStudy& flown) {
  if (flown.result.worst.empty()) return "";
  const WorstShot& worst = flown.result.worst.front();
  std::string text = "  worst shot: number " + std::to_string(worst.shot) + ", " + significant(worst.distance, 4) +
                     " m from the aim, with";
  for (std::size_t i = 0; i < worst.draws.size(); ++i) {
    const StudyInput& input = flown.plan.study().inputs[i];
    const Unit* unit = flown.units[i];
    const double zero = unit != nullptr && !input.added ? unit->zero : 0;
    text += (i == 0 ? " " : ", ") + input.path + (input.added ? " += " : " = ") +
            std::string(trimmed(significant(in_unit(worst.draws[i], unit) - zero, 5) + " " + name_of(unit, input)));
  }
  return text + "\n";
}

/// All figures of an end, or of a place.
std::string figures_text(const FlownStudy& flown) {
  return quantities_text(flown) + plane_text(flown.result) + hits_text(flown) + over_inputs_text(flown) +
         inputs_text(flown) + indices_text(flown) + histograms_text(flown) + worst_text(flown);
}

std::string place_heading(const FlownStudy& flown, std::size_t i) {
  const std::uint64_t missed = flown.at[i].result.not_arrived;
  std::string text = "\n  at " + name_of_place(flown, i);
  if (missed > 0) text += ": " + std::to_string(missed) + " did not come there";
  return text + "\n\n";
}

Json zone_json(const StudyResult& r) {
  if (!r.zone) return nullptr;
  Json corners = Json::array();
  for (const PlanePoint& corner : r.zone->corners) corners.push_back({corner.right, corner.up});
  return {{"corners [m]", std::move(corners)}, {"holds", r.zone->holds}, {"confidence", r.zone->confidence}};
}

Json json_of(const FlownStudy& flown);

Json places_json(const FlownStudy& flown) {
  Json places = Json::array();
  for (std::size_t i = 0; i < flown.at.size(); ++i) {
    Json place = {{"place", name_of_place(flown, i)}};
    place.update(json_of(flown.at[i]));
    places.push_back(std::move(place));
  }
  return places;
}

Json json_of(const FlownStudy& flown) {
  const Study& study = flown.plan.study();
  Json figures = Json::array(), worst = Json::array(), inputs = Json::array();
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  for (const Figure& figure : figures_of(flown))
    figures.push_back({{"name", figure.name}, {"value", number(figure.value)}, {"error", number(figure.error)}});
  for (const WorstShot& shot : flown.result.worst)
    worst.push_back({{"shot", shot.shot}, {"distance [m]", shot.distance}, {"draws", shot.draws}});
  for (std::size_t i = 0; i < study.inputs.size(); ++i) {
    Json row = {{"path", study.inputs[i].path}};
    if (flown.linear) {
      const LinearRow& linear = flown.linear->rows[i];
      row["deviation"] = linear.deviation;
      row["slope"] = linear.slope;
      row["effect"] = linear.effect;
      row["share"] = linear.share;
      row["misses"] = Json::array();
      for (const double share : linear.misses) row["misses"].push_back(number(share));
    }
    inputs.push_back(std::move(row));
  }
  Json quantities = Json::array();
  for (const StudyQuantity quantity : study.quantities) quantities.push_back(with_unit(quantity));
  return {{"sampling", name(study.sampling)},
          {"seed", study.seed},
          {"shards", flown.result.shards},
          {"width_reached", flown.result.width_reached},
          {"time_was_up", flown.result.time_was_up},
          {"quantities", std::move(quantities)},
          {"figures", std::move(figures)},
          {"covariance", flown.result.covariance},
          {"zone", zone_json(flown.result)},
          {"inputs", std::move(inputs)},
          {"over_inputs", over_inputs_json(flown)},
          {"histograms", histograms_json(flown)},
          {"at", places_json(flown)},
          {"worst", std::move(worst)},
          {"notes", notes_of(flown.plan)}};
}

/// State of a shot: rows for people, quantities and hits for programs. `place`: "800 m: " before what is of a place.
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

std::string unit_of(const StudyInput& input) {
  const auto known = study_path(input.path);
  return known ? known->unit : "";
}

std::string with_unit(const StudyInput& input) {
  const std::string unit = unit_of(input);
  return input.path + (input.added ? " +=" : "") + (unit.empty() ? "" : " [" + unit + "]");
}

std::string with_unit(StudyQuantity quantity) {
  return std::string(name(quantity)) + " [" + std::string(unit_of(quantity)) + "]";
}

bool misses_width(const Study& study, const StudyResult& result) { return study.until_width && !result.width_reached; }

FlownStudy told_study(const StudyPlan& plan, StudyResult result, std::size_t histogram_bars,
                      std::span<const std::string> texts) {
  FlownStudy flown{plan, std::move(result)};
  for (const StudyInput& input : plan.study().inputs) flown.units.push_back(unit_of_text(input, texts));
  flown.histogram_bars = histogram_bars;
  if (auto linear = propagate_linearly(plan)) flown.linear = *std::move(linear);
  const std::vector<StudyPlan> places = plan.places();
  PHYSIM_ASSERT(places.size() == flown.result.at.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    flown.at.push_back(told_study(places[i], std::move(flown.result.at[i]), histogram_bars, texts));
  flown.result.at.clear();  // they stand in `at` now
  return flown;
}

std::string name_of_place(const FlownStudy& flown, std::size_t i) {
  PHYSIM_ASSERT(i < flown.plan.study().at.size());
  return place_text(flown.plan.study().at[i].event);
}

std::vector<std::string> notes_of(const StudyPlan& plan) {
  std::vector<std::string> notes;
  for (const std::string& note : plan.notes()) notes.push_back(in_files(note));
  return notes;
}

Answer study_answer(const AskedShot& asked, const FlownStudy& flown, const Style& style) {
  std::string text = counts_text(flown) + figures_text(flown);
  if (const std::vector<StudyAtRange> ranges = ranges_of(flown); ranges.size() > 1)
    text += "\n  over range, by the same flights\n" + over_range_text(ranges);
  for (std::size_t i = 0; i < flown.at.size(); ++i) text += place_heading(flown, i) + figures_text(flown.at[i]);
  return about_shot(asked, style, text, json_of(flown));
}

std::vector<StudyAtRange> ranges_of(const FlownStudy& flown) {
  std::vector<StudyAtRange> list;
  const auto add = [&](const FlownStudy& there) {
    const Study& study = there.plan.study();
    const bool is_plane = study.quantities.size() >= 2 && study.quantities[0] == StudyQuantity::right &&
                          study.quantities[1] == StudyQuantity::up;
    if (!study.until.range || !is_plane) return;
    list.push_back({*study.until.range, there.result, {}});
    std::vector<HitResult>& hits = list.back().result.hits;  // without things, which stand where they stand
    for (std::size_t i = study.targets.size(); i-- > 0;)
      if (std::holds_alternative<ThingTarget>(study.targets[i].shape))
        hits.erase(hits.begin() + static_cast<std::ptrdiff_t>(i));
  };
  for (const FlownStudy& there : flown.at) add(there);
  add(flown);
  std::ranges::stable_sort(list, {}, &StudyAtRange::range);
  return list;
}

std::string over_range_text(std::span<const StudyAtRange> list, const Unit* of_ranges, std::span<const double> missed) {
  PHYSIM_ASSERT(!list.empty());
  const std::string_view of_range = of_ranges != nullptr ? of_ranges->name : "m";
  const bool customary = of_range == "yd" || of_range == "ft" || of_range == "mi";
  const Unit* small = customary ? last_unit("1 in", Quantity::length) : nullptr;
  const auto with = [&](const char* what) { return what + std::string(customary ? " [in]" : " [m]"); };
  std::vector<std::string> headers = {"range [" + std::string(of_range) + "]", with("right +-"), with("up +-"),
                                      with("CEP"), with("R95")};
  const bool holds = std::ranges::any_of(list, [](const StudyAtRange& at) { return at.held != PlanePoint{}; });
  if (holds) headers.insert(headers.end(), {with("held right"), with("held up")});
  for (const HitResult& hit : list.front().result.hits) headers.push_back(hit.name + " [%]");
  Table table(headers);
  const auto digits = [&](double length) { return significant(in_unit(length, small), 3); };
  for (const auto& [range, r, held] : list) {
    std::vector<std::string> cells = {significant(in_unit(range, of_ranges), 12), digits(r.quantities[0].deviation),
                                      digits(r.quantities[1].deviation), digits(r.from_centre->r50),
                                      digits(r.from_centre->r95)};
    if (holds) {
      const int places = customary ? 1 : 3;
      cells.insert(cells.end(), {fixed(in_unit(held.right, small), places), fixed(in_unit(held.up, small), places)});
    }
    for (const HitResult& hit : r.hits) cells.push_back(percent(hit.probability.value));
    table.add_row(std::move(cells));
  }
  for (const double range : missed) table.add_row({significant(in_unit(range, of_ranges), 12), "not reached"});
  return table.text(2);
}

Records records_of(std::span<const StudyAtRange> list, std::span<const double> missed) {
  PHYSIM_ASSERT(!list.empty());
  Records records{
      {"range [m]", "right.deviation [m]", "up.deviation [m]", "cep [m]", "r95 [m]", "held.right [m]", "held.up [m]"},
      {}};
  for (const HitResult& hit : list.front().result.hits)
    for (const char* what : {"", ".low", ".high"}) records.columns.push_back("hit." + hit.name + what);
  records.rows = [list, missed, count = records.columns.size()](const std::function<void(Row)>& take) {
    for (const auto& [range, r, held] : list) {
      std::vector<Cell> cells = {range,
                                 r.quantities[0].deviation,
                                 r.quantities[1].deviation,
                                 r.from_centre->r50,
                                 r.from_centre->r95,
                                 held.right,
                                 held.up};
      for (const HitResult& hit : r.hits) cells.insert(cells.end(), {hit.probability.value, hit.low, hit.high});
      take(cells);
    }
    for (const double range : missed) {
      std::vector<Cell> cells(count);
      cells.front() = range;
      take(cells);
    }
  };
  return records;
}

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
