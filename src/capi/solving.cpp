// Aim, fit, the choice of a fidelity, and studies.
#include "capi/objects.hpp"
#include "scenario/writer.hpp"

namespace physim::capi {
namespace {

/// A shot of a def with what its flights need.
struct Shot1 {
  std::shared_ptr<const Checked> checked;
  std::size_t index = 0;

  [[nodiscard]] const Scenario& scenario() const { return checked->scenario; }
  [[nodiscard]] const ScenarioShot& shot() const { return scenario().shots[index]; }
};

std::optional<Shot1> shot_of(Call& call, const Def& def, const char* shot) {
  const auto checked = def.checked();
  if (!call.take(checked)) return std::nullopt;
  const auto index = shot_in((*checked)->scenario, shot);
  if (!call.take(index, PHYSIM_NOT_FOUND)) return std::nullopt;
  return Shot1{*checked, *index};
}

/// A copy of a def in which a shot has changed: each of its settings that differs is set.
std::shared_ptr<Def> with_shot(Call& call, const Def& def, const Shot1& was, const ScenarioShot& now) {
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
                      .r90 = radius.r90});
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
