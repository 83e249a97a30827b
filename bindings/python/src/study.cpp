// Studies: uncertain shots, by shards, so that any executor of Python flies them.
#include "physim/study.hpp"

#include <algorithm>
#include <chrono>

#include "report/study_answer.hpp"
#include "report_table.hpp"
#include "setup.hpp"
#include "study/quantities.hpp"

namespace physim::python {
namespace {

/// A study that was checked, with what it was made of: functions of place need their objects.
struct PyStudy {
  SetupPtr setup;
  StudyPlan plan;
};

nb::bytes bytes_of(const std::vector<std::byte>& data) { return nb::bytes(data.data(), data.size()); }
StudyPart part_of(const nb::bytes& data) {
  if (data.size() == 0) return {};
  return taken(load_part({static_cast<const std::byte*>(static_cast<const void*>(data.c_str())), data.size()}));
}

std::optional<StudyWidth> width_of(const Study& study, double width) {
  if (!(width > 0)) return std::nullopt;
  StudyWidth wanted{.width = width};
  if (!study.targets.empty()) wanted.target = 0;
  return wanted;
}

std::unique_ptr<PyStudy> make_study(SetupPtr setup, const std::string& shot, double until_width) {
  Study study = taken(study_of(setup->scenario, setup->shot(shot)));
  study.until_width = width_of(study, until_width);
  StudyPlan plan = [&] {
    const Released free;
    return taken(plan_study(study));
  }();
  setup->raise_kept();
  return std::make_unique<PyStudy>(PyStudy{std::move(setup), std::move(plan)});
}

// ------------------------------------------------------------------------------------------------------------- results
nb::tuple pair_of(const Estimate& e) { return nb::make_tuple(e.value, e.error); }

nb::list bars_of(const CountedCells& cells, std::size_t bars) {
  nb::list all;
  for (const HistogramBar& bar : cells.histogram(bars)) all.append(nb::make_tuple(bar.low, bar.high, bar.count));
  return all;
}

nb::dict quantity_table(const QuantityResult& q, std::size_t bars) {
  nb::dict out;
  out["quantity"] = std::string(name(q.quantity));
  out["mean"] = pair_of(q.mean);
  out["deviation"] = q.deviation, out["least"] = q.least, out["most"] = q.most;
  nb::list quantiles;
  for (const double p : {0.05, 0.25, 0.5, 0.75, 0.95}) quantiles.append(nb::make_tuple(p, q.cells.quantile(p)));
  out["quantiles"] = quantiles;
  out["histogram"] = bars_of(q.cells, bars);
  return out;
}

nb::dict radius_table(const RadiusResult& r) {
  nb::dict out;
  out["mean"] = pair_of(r.mean), out["r50"] = r.r50, out["r90"] = r.r90, out["r95"] = r.r95;
  return out;
}

nb::dict hit_table(const HitResult& h) {
  nb::dict out;
  out["name"] = h.name, out["hits"] = h.hits, out["probability"] = pair_of(h.probability);
  out["low"] = h.low, out["high"] = h.high;
  return out;
}

template <class T, class Table>
nb::object optional_table(const std::optional<T>& value, const Table& table) {
  return value ? nb::object(table(*value)) : nb::none();
}

template <class List, class Table>
nb::list tables_of(const List& list, const Table& table) {
  nb::list all;
  for (const auto& each : list) all.append(table(each));
  return all;
}

nb::dict ellipse_table(const EllipseResult& e) {
  nb::dict out;
  out["right"] = e.right, out["up"] = e.up, out["long_axis"] = e.long_axis, out["short_axis"] = e.short_axis;
  out["angle"] = e.angle;
  return out;
}

nb::dict zone_table(const ZoneResult& z) {
  nb::dict out;
  std::vector<double> corners;
  for (const PlanePoint& p : z.corners) corners.insert(corners.end(), {p.right, p.up});
  out["corners"] = owned(std::move(corners), {z.corners.size(), 2});
  out["holds"] = z.holds, out["confidence"] = z.confidence;
  return out;
}

nb::dict result_table(const StudyResult& r, std::size_t bars) {
  nb::dict out;
  out["shards"] = r.shards, out["shots"] = r.shots, out["refused"] = r.refused, out["not_arrived"] = r.not_arrived;
  out["first_refusal"] = r.first_refusal ? nb::cast(r.first_refusal->text()) : nb::none();
  out["quantities"] = tables_of(r.quantities, [&](const QuantityResult& q) { return quantity_table(q, bars); });
  const std::size_t n = r.quantities.size();
  out["covariance"] = r.covariance.size() == n * n ? owned(std::vector<double>(r.covariance), {n, n}) : nb::none();
  out["from_aim"] = optional_table(r.from_aim, radius_table);
  out["from_centre"] = optional_table(r.from_centre, radius_table);
  out["in_space"] = optional_table(r.in_space, radius_table);
  out["ellipse"] = optional_table(r.ellipse, ellipse_table);
  out["spreads"] = tables_of(r.spreads, [](const SpreadResult& s) {
    nb::dict row;
    row["size"] = s.size, row["groups"] = s.groups, row["mean"] = pair_of(s.mean), row["deviation"] = s.deviation;
    return row;
  });
  out["zone"] = optional_table(r.zone, zone_table);
  out["hits"] = tables_of(r.hits, hit_table);
  out["worst"] = tables_of(r.worst, [](const WorstShot& w) {
    nb::dict row;
    row["shot"] = w.shot, row["distance"] = w.distance, row["draws"] = owned(std::vector<double>(w.draws));
    return row;
  });
  out["indices"] = tables_of(r.indices, [](const IndexResult& i) {
    nb::dict row;
    row["inputs"] = i.inputs;
    row["first"] = tables_of(i.first, pair_of), row["total"] = tables_of(i.total, pair_of);
    return row;
  });
  out["over_inputs"] = tables_of(r.over_inputs, [](const HitsOverInput& h) {
    nb::dict row;
    row["input"] = h.input;
    row["parts"] = tables_of(h.parts, [](const InputPart& p) {
      nb::dict part;
      part["low"] = p.low, part["middle"] = p.middle, part["high"] = p.high, part["shots"] = p.shots;
      part["hits"] = tables_of(p.hits, hit_table);
      return part;
    });
    return row;
  });
  out["stages"] = tables_of(r.stages, [](const StudyStage& s) {
    nb::dict row;
    row["shots"] = s.shots, row["distance"] = pair_of(s.distance), row["hits"] = tables_of(s.hits, hit_table);
    return row;
  });
  out["width_reached"] = r.width_reached, out["time_was_up"] = r.time_was_up;
  out["at"] = tables_of(r.at, [&](const StudyResult& place) { return result_table(place, bars); });
  return out;
}

nb::dict linear_table(const LinearResult& l) {
  nb::dict out;
  out["mean"] = owned(std::vector<double>(l.mean));
  const std::size_t n = l.mean.size();
  out["covariance"] = owned(std::vector<double>(l.covariance), {n, l.covariance.size() / std::max<std::size_t>(n, 1)});
  out["rows"] = tables_of(l.rows, [](const LinearRow& row) {
    nb::dict one;
    one["input"] = row.input, one["deviation"] = row.deviation;
    one["slope"] = owned(std::vector<double>(row.slope)), one["effect"] = owned(std::vector<double>(row.effect));
    one["share"] = owned(std::vector<double>(row.share)), one["misses"] = owned(std::vector<double>(row.misses));
    return one;
  });
  return out;
}

nb::dict target_table(const StudyTarget& target) {
  nb::dict out;
  out["name"] = target.name;
  if (const auto* circle = std::get_if<CircleTarget>(&target.shape)) {
    out["shape"] = "circle", out["centre"] = nb::make_tuple(circle->centre.right, circle->centre.up);
    out["radius"] = circle->radius;
  } else if (const auto* box = std::get_if<RectangleTarget>(&target.shape)) {
    out["shape"] = "rectangle", out["centre"] = nb::make_tuple(box->centre.right, box->centre.up);
    out["width"] = box->width, out["height"] = box->height;
  } else if (const auto* polygon = std::get_if<PolygonTarget>(&target.shape)) {
    nb::list corners;
    for (const PlanePoint& p : polygon->corners) corners.append(nb::make_tuple(p.right, p.up));
    out["shape"] = "polygon", out["corners"] = corners;
  } else {
    out["shape"] = "thing";
  }
  return out;
}

nb::dict shots_table(const StudyPlan& plan, const StudyShots& shots) {
  const Study& study = plan.study();
  nb::dict out, hits;
  for (std::size_t i = 0; i < shots.inputs.size(); ++i) {
    std::string key = study.inputs[i].path;
    while (out.contains(key.c_str())) key += "'";  // a number that is drawn twice
    out[key.c_str()] = owned(std::vector<double>(shots.inputs[i]));
  }
  for (std::size_t i = 0; i < shots.quantities.size(); ++i)
    out[name(study.quantities[i]).data()] = owned(std::vector<double>(shots.quantities[i]));
  for (std::size_t i = 0; i < shots.hits.size(); ++i)
    out[("hits " + study.targets[i].name).c_str()] = flags_of(shots.hits[i], [](bool hit) { return hit; });
  return out;
}

// ---------------------------------------------------------------------------------------------------------------- runs
std::optional<Function> function_of(const nb::object& object) {
  return object.is_none() ? std::nullopt : std::optional<Function>(object);
}

/// Asks a function of Python whether the study goes on; what it raises is kept, and ends the study.
bool goes_on(const std::optional<Function>& after, const StudyPart& part) {
  if (!after) return true;
  bool answer = false;
  try {
    after->call([&](const nb::object& f) { answer = nb::cast<bool>(nb::bool_(f(part.shards()))); });
  } catch (...) {
    return false;
  }
  return answer;
}

/// Flies shards first ... first + count - 1 that `so_far` lacks; `after` is called after each and may stop it.
nb::bytes run_part(const PyStudy& s, std::uint64_t first, std::uint64_t count, const nb::bytes& so_far,
                   unsigned threads, const nb::object& after) {
  const std::optional<Function> asked = function_of(after);
  StudyOptions options{.so_far = part_of(so_far)};
  options.after_shard = [&](const StudyPart& part) { return goes_on(asked, part); };
  const StudyPart part = [&] {
    const Released free;
    const Threads pool(threads);
    return taken(run_shards(s.plan, first, count, pool.runner(), options));
  }();
  s.setup->raise_kept();
  if (asked) asked->raise_kept();
  return bytes_of(save_part(part));
}

/// All of it, with the ends of studies by width.
nb::tuple run_all(const PyStudy& s, const nb::bytes& so_far, unsigned threads, const nb::object& after,
                  std::size_t bars, std::optional<double> seconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::optional<Function> asked = function_of(after);
  StudyOptions options{.so_far = part_of(so_far)};
  StudyPart last = options.so_far;
  options.after_shard = [&](const StudyPart& part) {
    last = part;
    return goes_on(asked, part);
  };
  if (seconds)
    options.time_is_up = [=] { return std::chrono::duration<double>(Clock::now() - start).count() >= *seconds; };
  const StudyResult result = [&] {
    const Released free;
    const Threads pool(threads);
    return taken(run_study(s.plan, pool.runner(), options));
  }();
  s.setup->raise_kept();
  if (asked) asked->raise_kept();
  return nb::make_tuple(result_table(result, bars), bytes_of(save_part(last)));
}

nb::dict figures_table(const PyStudy& s, const nb::bytes& part, std::uint64_t shards) {
  StudyResult result = taken(result_of(s.plan, part_of(part), shards));
  nb::dict out;
  nb::list names, values, errors;
  for (const report::Figure& figure : report::figures_of(report::told_study(s.plan, std::move(result), 0))) {
    names.append(figure.name), values.append(figure.value), errors.append(figure.error);
  }
  out["figure"] = names, out["value"] = values, out["error"] = errors;
  return out;
}

}  // namespace

void add_study(nb::module_& m) {
  nb::class_<PyStudy>(m, "Study", "Many flights of one shot with uncertain numbers.")
      .def_static("make", &make_study, "setup"_a, "shot"_a, "until_width"_a)
      .def_prop_ro(
          "shards", [](const PyStudy& s) { return s.plan.shards(); }, "Of all its shots.")
      .def_prop_ro("shard_shots", [](const PyStudy& s) { return s.plan.study().shard_shots; })
      .def_prop_ro("notes", [](const PyStudy& s) { return s.plan.notes(); })
      .def_prop_ro("inputs",
                   [](const PyStudy& s) {
                     std::vector<std::string> paths;
                     for (const StudyInput& input : s.plan.study().inputs) paths.push_back(report::with_unit(input));
                     return paths;
                   })
      .def_prop_ro("quantities",
                   [](const PyStudy& s) {
                     std::vector<std::string> names;
                     for (const StudyQuantity q : s.plan.study().quantities) names.emplace_back(name(q));
                     return names;
                   })
      .def_prop_ro("units",
                   [](const PyStudy& s) {
                     std::vector<std::string> units;
                     for (const StudyQuantity q : s.plan.study().quantities) units.emplace_back(unit_of(q));
                     return units;
                   })
      .def_prop_ro("targets", [](const PyStudy& s) { return tables_of(s.plan.study().targets, target_table); })
      .def_prop_ro("aim",
                   [](const PyStudy& s) { return nb::make_tuple(s.plan.study().aim.right, s.plan.study().aim.up); })
      .def_prop_ro("sampling", [](const PyStudy& s) { return std::string(name(s.plan.study().sampling)); })
      .def_prop_ro("seed", [](const PyStudy& s) { return s.plan.study().seed; })
      .def("run_part", &run_part, "first"_a, "count"_a, "so_far"_a, "threads"_a, "after"_a.none())
      .def("run_all", &run_all, "so_far"_a, "threads"_a, "after"_a.none(), "bars"_a, "seconds"_a.none())
      .def(
          "result",
          [](const PyStudy& s, const nb::bytes& part, std::uint64_t shards, std::size_t bars) {
            return result_table(taken(result_of(s.plan, part_of(part), shards)), bars);
          },
          "part"_a, "shards"_a, "bars"_a)
      .def("figures", &figures_table, "part"_a, "shards"_a)
      .def(
          "shots",
          [](const PyStudy& s, std::uint64_t shard) {
            const StudyShots shots = [&] {
              const Released free;
              return fly_shots_of(s.plan, shard);
            }();
            s.setup->raise_kept();
            return shots_table(s.plan, shots);
          },
          "shard"_a)
      .def("linear", [](const PyStudy& s) -> nb::object {
        const Result<LinearResult> linear = propagate_linearly(s.plan);
        return linear ? nb::object(linear_table(*linear)) : nb::none();
      });
  m.def(
      "merge_parts",
      [](const nb::bytes& a, const nb::bytes& b) { return bytes_of(save_part(taken(merge(part_of(a), part_of(b))))); },
      "a"_a, "b"_a, "Joins parts of one study.");
  m.def(
      "shards_in", [](const nb::bytes& part) { return part_of(part).shards(); }, "part"_a, "Shards of a part.");
  m.def(
      "has_shard", [](const nb::bytes& part, std::uint64_t shard) { return part_of(part).has(shard); }, "part"_a,
      "shard"_a);
  m.def("study_paths", [] {
    nb::list all;
    for (const StudyPath& path : study_paths()) all.append(nb::make_tuple(path.path, path.unit, path.about));
    return all;
  });
}

}  // namespace physim::python
