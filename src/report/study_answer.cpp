#include "report/study_answer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

struct Figure {
  std::string name;
  double value, error;
};

constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();

std::string percent(double part) { return significant(100 * part, 3); }

/// The names of a group of inputs.
std::string names_of_inputs(const Study& study, const std::vector<std::size_t>& inputs) {
  std::string text;
  for (const std::size_t input : inputs) {
    PHYSIM_ASSERT(input < study.inputs.size());
    text += (text.empty() ? "" : ", ") + study.inputs[input].path;
  }
  return text;
}

// ---------------------------------------------------------------------------------------------------------- figures
void add_radius(const char* from, const std::optional<RadiusResult>& radius, std::vector<Figure>& list) {
  if (!radius) return;
  const std::string head = std::string("radius.") + from;
  list.push_back({head + ".mean [m]", radius->mean.value, radius->mean.error});
  list.push_back({head + ".r50 [m]", radius->r50, kNoError});
  list.push_back({head + ".r90 [m]", radius->r90, kNoError});
  list.push_back({head + ".r95 [m]", radius->r95, kNoError});
}

/// Every figure under a name of its own.
std::vector<Figure> figures_of(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  const Study& study = flown.plan.study();
  std::vector<Figure> list = {{"shots", static_cast<double>(r.shots), kNoError},
                              {"refused", static_cast<double>(r.refused), kNoError},
                              {"not_arrived", static_cast<double>(r.not_arrived), kNoError}};
  for (const QuantityResult& q : r.quantities) {
    const std::string head(name(q.quantity)), unit = " [" + std::string(unit_of(q.quantity)) + "]";
    list.push_back({head + ".mean" + unit, q.mean.value, q.mean.error});
    list.push_back({head + ".deviation" + unit, q.deviation, kNoError});
    list.push_back({head + ".least" + unit, q.least, kNoError});
    for (const double p : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
      list.push_back({head + ".quantile_" + as_typed(p) + unit, q.cells.quantile(p), kNoError});
    list.push_back({head + ".most" + unit, q.most, kNoError});
  }
  add_radius("aim", r.from_aim, list);
  add_radius("centre", r.from_centre, list);
  add_radius("space", r.in_space, list);
  if (r.ellipse) {
    list.push_back({"ellipse.long_axis [m]", r.ellipse->long_axis, kNoError});
    list.push_back({"ellipse.short_axis [m]", r.ellipse->short_axis, kNoError});
    list.push_back({"ellipse.angle [rad]", r.ellipse->angle, kNoError});
  }
  for (const SpreadResult& s : r.spreads)
    list.push_back({"extreme_spread." + std::to_string(s.size) + " [m]", s.mean.value, s.mean.error});
  for (const HitResult& hit : r.hits) {
    list.push_back({"hit." + hit.name, hit.probability.value, hit.probability.error});
    list.push_back({"hit." + hit.name + ".low", hit.low, kNoError});
    list.push_back({"hit." + hit.name + ".high", hit.high, kNoError});
  }
  for (const IndexResult& index : r.indices)
    for (std::size_t q = 0; q < index.first.size(); ++q) {
      const std::string of = std::string(name(r.quantities[q].quantity)) + "." + names_of_inputs(study, index.inputs);
      list.push_back({"index.first." + of, index.first[q].value, index.first[q].error});
      list.push_back({"index.total." + of, index.total[q].value, index.total[q].error});
    }
  return list;
}

/// Hits over each input: its number and path, then the number of the part. An end that is none is left out.
void add_over_inputs(const FlownStudy& flown, std::vector<Figure>& list) {
  for (const HitsOverInput& over : flown.result.over_inputs) {
    const StudyInput& input = flown.plan.study().inputs[over.input];
    const std::string unit = unit_of(input).empty() ? "" : " [" + unit_of(input) + "]";
    for (std::size_t i = 0; i < over.parts.size(); ++i) {
      const InputPart& part = over.parts[i];
      const std::string head = "over." + std::to_string(over.input + 1) + "." + input.path + (input.added ? "+=" : "") +
                               "." + std::to_string(i + 1);
      if (std::isfinite(part.low)) list.push_back({head + ".from" + unit, part.low, kNoError});
      list.push_back({head + ".middle" + unit, part.middle, kNoError});
      if (std::isfinite(part.high)) list.push_back({head + ".to" + unit, part.high, kNoError});
      list.push_back({head + ".shots", static_cast<double>(part.shots), kNoError});
      for (const HitResult& hit : part.hits) {
        list.push_back({head + ".hit." + hit.name, hit.probability.value, hit.probability.error});
        list.push_back({head + ".hit." + hit.name + ".low", hit.low, kNoError});
        list.push_back({head + ".hit." + hit.name + ".high", hit.high, kNoError});
      }
    }
  }
}

// -------------------------------------------------------------------------------------------------------------- text
std::string counts_text(const FlownStudy& flown) {
  const StudyResult& r = flown.result;
  std::string text = "  " + std::to_string(r.shots) + " shots in " + std::to_string(r.shards) + " shards, " +
                     std::string(name(flown.plan.study().sampling)) + ", seed " +
                     std::to_string(flown.plan.study().seed);
  if (r.time_was_up) text += "; the time was up, and --shots " + std::to_string(r.shots) + " gives the same again";
  if (r.not_arrived > 0) text += "; " + std::to_string(r.not_arrived) + " did not arrive";
  if (r.refused > 0) text += "; " + std::to_string(r.refused) + " refused: " + r.first_refusal->text();
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

std::string hits_text(const StudyResult& r) {
  if (r.hits.empty()) return "";
  Table table({"target", "hits [%]", "95 % interval"}, "lr");
  for (const HitResult& hit : r.hits)
    table.add_row({hit.name, percent(hit.probability.value), percent(hit.low) + " .. " + percent(hit.high)});
  return table.text(2) + "\n";
}

/// What each input does: its effect by slopes, and its share of the variance of the plane's axes and of the misses.
std::string inputs_text(const FlownStudy& flown) {
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
    std::vector<std::string> cells = {study.inputs[row.input].path, significant(row.deviation, 3)};
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
    text += (i == 0 ? " " : ", ") + input.path + (input.added ? " += " : " = ") + significant(worst.draws[i], 5);
  }
  return text + "\n";
}

Json zone_json(const StudyResult& r) {
  if (!r.zone) return nullptr;
  Json corners = Json::array();
  for (const PlanePoint& corner : r.zone->corners) corners.push_back({corner.right, corner.up});
  return {{"corners [m]", std::move(corners)}, {"holds", r.zone->holds}, {"confidence", r.zone->confidence}};
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
          {"worst", std::move(worst)},
          {"notes", flown.plan.notes()}};
}

}  // namespace

std::string_view unit_of(StudyQuantity quantity) {
  switch (quantity) {
    case StudyQuantity::time: return "s";
    case StudyQuantity::vx:
    case StudyQuantity::vy:
    case StudyQuantity::vz:
    case StudyQuantity::impact_speed:
    case StudyQuantity::speed: return "m/s";
    case StudyQuantity::x:
    case StudyQuantity::y:
    case StudyQuantity::z:
    case StudyQuantity::right:
    case StudyQuantity::up:
    case StudyQuantity::along: return "m";
    case StudyQuantity::obliquity: return "rad";
    case StudyQuantity::impact_energy: return "J";
  }
  PHYSIM_UNREACHABLE();
}

std::string unit_of(const StudyInput& input) {
  static const std::vector<StudyPath> kPaths = study_paths();
  const auto known = std::ranges::find(kPaths, input.path, &StudyPath::path);
  return known == kPaths.end() ? "" : known->unit;
}

std::string with_unit(const StudyInput& input) {
  const std::string unit = unit_of(input);
  return input.path + (input.added ? " +=" : "") + (unit.empty() ? "" : " [" + unit + "]");
}

std::string with_unit(StudyQuantity quantity) {
  return std::string(name(quantity)) + " [" + std::string(unit_of(quantity)) + "]";
}

Answer study_answer(const AskedShot& asked, const FlownStudy& flown, const Style& style) {
  const std::string text = counts_text(flown) + quantities_text(flown) + plane_text(flown.result) +
                           hits_text(flown.result) + over_inputs_text(flown) + inputs_text(flown) +
                           indices_text(flown) + worst_text(flown);
  return about_shot(asked, style, text, json_of(flown));
}

std::string over_range_text(std::span<const StudyAtRange> list) {
  PHYSIM_ASSERT(!list.empty());
  std::vector<std::string> headers = {"range [m]", "right +- [m]", "up +- [m]", "CEP [m]", "R95 [m]"};
  for (const HitResult& hit : list.front().result.hits) headers.push_back(hit.name + " [%]");
  Table table(headers);
  for (const auto& [range, r] : list) {
    std::vector<std::string> cells = {as_typed(range), significant(r.quantities[0].deviation, 3),
                                      significant(r.quantities[1].deviation, 3), significant(r.from_centre->r50, 3),
                                      significant(r.from_centre->r95, 3)};
    for (const HitResult& hit : r.hits) cells.push_back(percent(hit.probability.value));
    table.add_row(std::move(cells));
  }
  return table.text(2);
}

Records records_of(std::span<const StudyAtRange> list) {
  PHYSIM_ASSERT(!list.empty());
  Records records{{"range [m]", "right.deviation [m]", "up.deviation [m]", "cep [m]", "r95 [m]"}, {}};
  for (const HitResult& hit : list.front().result.hits)
    for (const char* what : {"", ".low", ".high"}) records.columns.push_back("hit." + hit.name + what);
  records.rows = [list](const std::function<void(Row)>& take) {
    for (const auto& [range, r] : list) {
      std::vector<Cell> cells = {range, r.quantities[0].deviation, r.quantities[1].deviation, r.from_centre->r50,
                                 r.from_centre->r95};
      for (const HitResult& hit : r.hits) cells.insert(cells.end(), {hit.probability.value, hit.low, hit.high});
      take(cells);
    }
  };
  return records;
}

Records records_of(const FlownStudy& flown) {
  std::vector<Figure> list = figures_of(flown);
  add_over_inputs(flown, list);
  const auto figures = std::make_shared<const std::vector<Figure>>(std::move(list));
  return {{"figure", "value", "error"}, [figures](const std::function<void(Row)>& take) {
            for (const Figure& figure : *figures) {
              const Cell cells[] = {std::string_view(figure.name), figure.value, figure.error};
              take(cells);
            }
          }};
}

}  // namespace physim::report
