// Aim, fit, the choice of a fidelity, and studies.
#include <chrono>

#include "capi/objects.hpp"
#include "physim/names.hpp"
#include "report/ladder.hpp"
#include "scenario/suggest.hpp"
#include "scenario/writer.hpp"

namespace physim::capi {
namespace {

/// A copy of a def in which a shot has changed: each of its settings that differs is set.
std::shared_ptr<Def> with_shot(Call& call, const Def& def, const CheckedShot& was, const ScenarioShot& now) {
  Scenario changed = was.scenario();
  changed.shots[was.index] = now;
  const auto before = effective_settings(was.scenario()), after = effective_settings(changed);
  PHYSIM_ASSERT(before.size() == after.size());
  auto made = std::make_shared<Def>(def);
  for (std::size_t i = 0; i < after.size(); ++i) {
    PHYSIM_ASSERT(before[i].first == after[i].first);
    if (before[i] != after[i] && !call.take(made->set(after[i].first, after[i].second))) break;
  }
  return made;
}

physim_way way_of(const AimSolution& s) {
  PHYSIM_ASSERT(s.miss >= 0);
  physim_way way{.found = 1,
                 .reserved = 0,
                 .elevation = s.launch.elevation,
                 .azimuth = s.launch.azimuth,
                 .time = s.time,
                 .miss = s.miss,
                 .speed = s.speed,
                 .descent = s.descent,
                 .position = {}};
  put(way.position, s.position);
  return way;
}

std::optional<double> known(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

/// The target of a call, else that of the def.
Target target_of(Call& call, const physim_target* given, const ScenarioTarget& own, AimOptions& options) {
  const physim_target t = call.read(given, "target");
  options.arc = own.arc;
  options.tolerance = own.tolerance;
  if (given == nullptr) {
    if (!own.position) call.fail(PHYSIM_REFUSED, "there is no target", "target.position", "set it, or give a target");
    return {own.position.value_or(Vec3d{}), own.velocity, own.acceleration};
  }
  options.arc = Arc::both;
  options.tolerance = t.tolerance != 0 ? t.tolerance : AimOptions{}.tolerance;
  return {vector_at(t.position), vector_at(t.velocity), vector_at(t.acceleration)};
}

Purpose purpose_of(Call& call, const physim_purpose* given) {
  const physim_purpose p = call.read(given, "purpose");
  Purpose purpose;
  if (p.error != 0) purpose.error = p.error;
  if (p.time != 0) purpose.time = p.time;
  if (p.step != 0) purpose.step = p.step;
  if (p.free_step != 0) purpose.step = 0;
  if (given != nullptr) purpose.ground = known(p.ground);
  return purpose;
}

double or_nan(std::optional<double> value) { return value.value_or(std::numeric_limits<double>::quiet_NaN()); }

physim_compared row_of(const ComparedFlight& flight) {
  const auto measured = [&](double figure) {
    return or_nan(flight.problem.empty() ? std::optional(figure) : std::nullopt);
  };
  return {.end_distance = measured(flight.end_distance),
          .largest_distance = measured(flight.largest_distance),
          .end_delay = measured(flight.end_delay),
          .steps = flight.flight.cost().steps,
          .evaluations = flight.flight.cost().evaluations};
}

/// The figure whose width ends a study.
Result<StudyWidth> width_of(const Study& study, const char* target, std::size_t quantity, double width) {
  if (target == nullptr) {
    const std::size_t count = study.quantities.size();
    if (quantity >= count) return Error{"there are not so many", "quantity", "they count from 0"};
    return StudyWidth{.target = {}, .quantity = quantity, .width = width};
  }
  const auto index = index_in(study.targets, target, "target", [](const StudyTarget& each) { return each.name; });
  if (!index) return index.error();
  return StudyWidth{.target = *index, .quantity = 0, .width = width};
}

/// Flies a study for some time, or to its end; what it has then.
Result<StudyResult> run_for(const StudyPlan& plan, double seconds, TaskRunner* runner, StudyPart& all) {
  using Clock = std::chrono::steady_clock;
  PHYSIM_ASSERT(seconds >= 0);
  const auto start = Clock::now();
  StudyOptions options{.so_far = all};
  options.after_shard = [&all](const StudyPart& part) { return all = part, true; };
  if (seconds > 0)
    options.time_is_up = [=] { return std::chrono::duration<double>(Clock::now() - start).count() >= seconds; };
  return run_study(plan, runner, options);
}

}  // namespace
}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

physim_result physim_aim(const physim_def* def, const char* shot, const physim_target* target, physim_aim_info* info) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const Scenario& s = of->scenario();
    AimOptions options{.ground = s.until.ground, .flight = s.tolerance};
    if (of->checked->scene) options.scene = &*of->checked->scene, options.contact = contact_of(of->shot());
    const Target at = target_of(call, target, s.target, options);
    if (!call.ok()) return;
    const ProjectileDef projectile = projectile_of(of->shot());
    const Result<Aim> aim = physim::aim(projectile, of->shot().launch, s.environment, projectile.fidelity, at, options);
    if (!call.take(aim)) return;
    physim_aim_info out{};
    out.in_reach = aim->in_reach();
    out.behind_ground = aim->behind_ground;
    out.blocked = static_cast<std::uint32_t>(aim->blocked.size());
    out.flights = aim->flights;
    if (aim->low) out.low = way_of(*aim->low);
    if (aim->high) out.high = way_of(*aim->high);
    out.nearest = way_of(aim->nearest);
    put_text(out.explanation, sizeof out.explanation, aim->explanation());
    call.write(info, out);
  });
}

physim_result physim_max_range(const physim_def* def, const char* shot, double ground, double slope, double time,
                               physim_farthest* info) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(!std::isnan(ground), "ground", "is not a number");
    call.need(!std::isnan(slope), "slope", "is not a number");
    call.need(time >= 0, "time", "is negative, or not a number");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const ProjectileDef projectile = projectile_of(of->shot());
    const Result<MaxRange> found = max_range(projectile, of->shot().launch, of->scenario().environment,
                                             projectile.fidelity, ground, slope, time != 0 ? time : 3600);
    if (!call.take(found)) return;
    physim_farthest out{};
    out.elevation = found->elevation, out.range = found->range, out.time = found->time, out.flights = found->flights;
    put(out.position, found->position);
    put(out.velocity, found->velocity);
    call.write(info, out);
  });
}

physim_result physim_suvat(const physim_straight* given, physim_straight* into, size_t* count) {
  return guarded([&](Call& call) {
    call.need(given, "given");
    call.need(into, "into");
    call.need(count, "count");
    if (!call.ok()) return;
    const auto found = suvat({known(given->s), known(given->u), known(given->v), known(given->a), known(given->t)});
    if (!call.take(found)) return;
    PHYSIM_ASSERT(found->size() == 1 || found->size() == 2);
    *count = found->size();
    for (std::size_t i = 0; i < *count; ++i) {
      const Suvat& motion = (*found)[i];
      into[i] = {.s = motion.s, .u = motion.u, .v = motion.v, .a = motion.a, .t = motion.t};
    }
  });
}

physim_result physim_compare(const physim_def* def, const char* shot, const char* const* fidelities, size_t count,
                             physim_compared* rows, size_t each, physim_flight** reference) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(count > 0, "count", "is 0");
    call.need_rows(fidelities, count, "fidelities");
    call.need_rows(rows, count, "rows");
    call.need(each >= sizeof(double), "each", "is not the sizeof of the struct");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    std::vector<FlightSetting> settings;
    for (std::size_t i = 0; i < count; ++i) {
      call.need(fidelities[i], "fidelities");
      if (!call.ok()) return;
      if (!fidelity_preset(fidelities[i]))
        return call.fail(PHYSIM_REFUSED, "no preset of fidelity has this name", fidelities[i],
                         suggestion(fidelities[i], fidelity_presets(), "they are"));
      settings.push_back(report::preset_setting(of->scenario(), of->shot(), fidelities[i]));
    }
    Result<Comparison> found = compare(projectile_of(of->shot()), of->shot().launch, of->scenario().environment,
                                       settings, report::reference_setting(of->scenario(), of->shot()), of->until());
    if (!call.take(found)) return;
    PHYSIM_ASSERT(found->flights.size() == count);
    for (std::size_t i = 0; i < count; ++i) put_row(rows, each, i, row_of(found->flights[i]));
    if (reference != nullptr)
      call.give(reference, std::make_shared<FlightObject>(FlightObject{std::move(found->reference)}));
  });
}

physim_result physim_fit(const physim_def* def, const char* shot, const physim_measurement* measurements, size_t count,
                         const physim_fit_options* options, physim_fit_info* info, physim_def** fitted) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    const physim_fit_options o = call.read(options, "options");
    call.need(count > 0, "count", "is 0");
    call.need_rows(measurements, count, "measurements");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    std::vector<Measurement> measured;
    for (std::size_t i = 0; i < count; ++i) {
      const physim_measurement& m = measurements[i];
      measured.push_back({m.range, known(m.speed), known(m.drop), known(m.time)});
    }
    FitOptions asked{.muzzle_speed = o.muzzle_speed != 0};
    if (o.speed_error != 0) asked.speed_error = o.speed_error;
    if (o.drop_error != 0) asked.drop_error = o.drop_error;
    if (o.time_error != 0) asked.time_error = o.time_error;
    const Result<Fit> fit = fit_drag(of->shot().projectile, of->shot().launch, of->scenario().environment,
                                     of->shot().projectile.fidelity, measured, asked);
    if (!call.take(fit)) return;
    std::shared_ptr<Def> made;
    if (fitted != nullptr) {
      ScenarioShot now = of->shot();
      now.projectile = fit->projectile;
      now.launch.speed = fit->launch.speed;
      made = with_shot(call, *from, *of, now);
    }
    if (!call.ok()) return;
    if (made != nullptr) call.give(fitted, std::move(made));
    call.write(info, {.size = 0,
                      .reserved = 0,
                      .scale = fit->scale,
                      .scale_error = fit->scale_error,
                      .muzzle_speed = fit->launch.speed,
                      .muzzle_speed_error = fit->muzzle_speed_error,
                      .rms = fit->rms,
                      .flights = fit->flights});
  });
}

physim_result physim_choose_fidelity(const physim_def* def, const char* shot, const physim_purpose* purpose,
                                     physim_fidelity_info* info, physim_def** chosen) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    const Purpose asked = purpose_of(call, purpose);
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const Result<AutoFidelity> found =
        cheapest_within(projectile_of(of->shot()), of->shot().launch, of->scenario().environment, asked);
    if (!call.take(found)) return;
    std::shared_ptr<Def> made;
    if (chosen != nullptr) {
      ScenarioShot now = of->shot();
      now.projectile.fidelity = found->fidelity;
      now.cheapest_within.reset();
      made = with_shot(call, *from, *of, now);
    }
    if (!call.ok()) return;
    if (made != nullptr) call.give(chosen, std::move(made));
    physim_fidelity_info out{.size = 0,
                             .ended_early = found->ended_early,
                             .step = found->step,
                             .error = found->error,
                             .cost = found->cost,
                             .truth_cost = found->truth_cost,
                             .explanation = {}};
    put_text(out.explanation, sizeof out.explanation, found->explanation());
    call.write(info, out);
  });
}

// ------------------------------------------------------------------------------------------------------------ studies
physim_result physim_study_create(const physim_def* def, const char* shot, physim_study** study) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(study, "study");
    if (!call.ok()) return;
    const auto of = shot_of(call, *from, shot);
    if (!of) return;
    const Result<Study> asked = study_of(of->scenario(), of->shot());
    if (!call.take(asked)) return;
    const Result<StudyPlan> plan = plan_study(*asked);
    PHYSIM_ASSERT(!plan || plan->shards() > 0);
    if (call.take(plan)) call.give(study, std::make_shared<StudyObject>(StudyObject{*plan}));
  });
}

physim_result physim_study_read(const physim_study* study, physim_study_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(study, "study");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const Study& s = of->plan.study();
    call.write(info, {.size = 0,
                      .shard_shots = s.shard_shots,
                      .shards = of->plan.shards(),
                      .inputs = s.inputs.size(),
                      .targets = s.targets.size()});
  });
}

physim_result physim_study_fly(const physim_study* study, uint64_t first, uint64_t count, const physim_pool* pool,
                               physim_part** part) {
  return guarded([&](Call& call) {
    const auto of = call.find(study, "study");
    const auto threads = call.find_or_null(pool, "pool");
    call.need(count > 0, "count", "is 0");
    call.need(part, "part");
    if (!call.ok()) return;
    const Lent lent(threads);
    const Result<StudyPart> flown = run_shards(of->plan, first, count, lent.runner());
    if (call.take(flown)) call.give(part, std::make_shared<PartObject>(PartObject{*flown}));
  });
}

physim_result physim_study_set_width(physim_study* study, const char* target, size_t quantity, double width) {
  return guarded([&](Call& call) {
    const auto of = call.find(study, "study");
    call.need(width >= 0, "width", "is negative, or not a number");
    if (!call.ok()) return;
    Study changed = of->plan.study();
    changed.until_width.reset();
    if (width > 0) {
      const Result<StudyWidth> until = width_of(changed, target, quantity, width);
      if (!call.take(until, PHYSIM_NOT_FOUND)) return;
      changed.until_width = *until;
    }
    const Result<StudyPlan> plan = plan_study(changed);
    if (call.take(plan)) of->plan = *plan;
  });
}

physim_result physim_study_run(const physim_study* study, const physim_part* so_far, double seconds,
                               const physim_pool* pool, physim_part** part, physim_figures** figures) {
  return guarded([&](Call& call) {
    const auto of = call.find(study, "study");
    const auto before = call.find_or_null(so_far, "so_far");
    const auto threads = call.find_or_null(pool, "pool");
    call.need(seconds >= 0, "seconds", "is negative, or not a number");
    call.need(part != nullptr || figures != nullptr, "figures", "is null, and so is part: nothing would be left");
    if (!call.ok()) return;
    StudyPart all = before ? before->part : StudyPart();
    const Lent lent(threads);
    Result<StudyResult> result = run_for(of->plan, seconds, lent.runner(), all);
    if (!call.take(result)) return;
    PHYSIM_ASSERT(result->shards <= all.shards());
    if (part != nullptr) call.give(part, std::make_shared<PartObject>(PartObject{all}));
    if (figures != nullptr) call.give(figures, std::make_shared<FiguresObject>(FiguresObject{std::move(*result)}));
  });
}

physim_result physim_part_join(const physim_part* a, const physim_part* b, physim_part** joined) {
  return guarded([&](Call& call) {
    const auto one = call.find(a, "a");
    const auto other = call.find(b, "b");
    call.need(joined, "joined");
    if (!call.ok()) return;
    const Result<StudyPart> made = merge(one->part, other->part);
    if (call.take(made)) call.give(joined, std::make_shared<PartObject>(PartObject{*made}));
  });
}

physim_result physim_part_load(const void* data, size_t size, physim_part** part) {
  return guarded([&](Call& call) {
    call.need(data, "data");
    call.need(part, "part");
    if (!call.ok()) return;
    const Result<StudyPart> loaded = load_part({static_cast<const std::byte*>(data), size});
    if (call.take(loaded)) call.give(part, std::make_shared<PartObject>(PartObject{*loaded}));
  });
}

physim_result physim_study_figures(const physim_study* study, const physim_part* part, uint64_t shards,
                                   physim_figures** figures) {
  return guarded([&](Call& call) {
    const auto of = call.find(study, "study");
    const auto from = call.find(part, "part");
    call.need(figures, "figures");
    if (!call.ok()) return;
    Result<StudyResult> result = result_of(of->plan, from->part, shards != 0 ? shards : of->plan.shards());
    if (call.take(result)) call.give(figures, std::make_shared<FiguresObject>(FiguresObject{std::move(*result)}));
  });
}

physim_result physim_figures_read(const physim_figures* figures, physim_figures_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(figures, "figures");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const StudyResult& r = of->result;
    const RadiusResult radius = r.from_aim.value_or(RadiusResult{});
    call.write(info, {.size = 0,
                      .has_plane = r.from_aim.has_value(),
                      .shots = r.shots,
                      .refused = r.refused,
                      .not_arrived = r.not_arrived,
                      .quantities = r.quantities.size(),
                      .targets = r.hits.size(),
                      .mean_radius = radius.mean.value,
                      .r50 = radius.r50,
                      .r90 = radius.r90,
                      .shards = r.shards,
                      .width_reached = r.width_reached,
                      .time_was_up = r.time_was_up});
  });
}

physim_result physim_figures_quantity(const physim_figures* figures, size_t index, physim_quantity* quantity) {
  return guarded([&](Call& call) {
    const auto of = call.find(figures, "figures");
    call.need_struct(quantity, "quantity");
    if (!call.ok()) return;
    if (index >= of->result.quantities.size()) return call.fail(PHYSIM_NOT_FOUND, "there are not so many", "index");
    const QuantityResult& q = of->result.quantities[index];
    call.write(quantity, {.size = 0,
                          .quantity = static_cast<std::int32_t>(q.quantity),
                          .mean = q.mean.value,
                          .error = q.mean.error,
                          .deviation = q.deviation,
                          .least = q.least,
                          .most = q.most});
  });
}

physim_result physim_figures_target(const physim_figures* figures, size_t index, physim_chance* chance) {
  return guarded([&](Call& call) {
    const auto of = call.find(figures, "figures");
    call.need_struct(chance, "chance");
    if (!call.ok()) return;
    if (index >= of->result.hits.size()) return call.fail(PHYSIM_NOT_FOUND, "there are not so many", "index");
    const HitResult& hit = of->result.hits[index];
    call.write(chance, {.size = 0,
                        .reserved = 0,
                        .target = hit.name.c_str(),
                        .hits = hit.hits,
                        .probability = hit.probability.value,
                        .error = hit.probability.error,
                        .low = hit.low,
                        .high = hit.high});
  });
}

physim_result physim_figures_quantile(const physim_figures* figures, size_t index, double part, double* value) {
  return guarded([&](Call& call) {
    const auto of = call.find(figures, "figures");
    call.need(part >= 0 && part <= 1, "part", "is not 0 to 1");
    call.need(value, "value");
    if (!call.ok()) return;
    if (index >= of->result.quantities.size()) return call.fail(PHYSIM_NOT_FOUND, "there are not so many", "index");
    *value = of->result.quantities[index].cells.quantile(part);
  });
}
