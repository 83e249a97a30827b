#include "study/plan.hpp"

#include <algorithm>
#include <cmath>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/zero.hpp"
#include "physim/scene.hpp"
#include "study/estimates.hpp"
#include "study/impacts.hpp"
#include "study/moments.hpp"
#include "study/over_inputs.hpp"
#include "study/paths.hpp"
#include "study/places.hpp"
#include "study/quantities.hpp"

namespace physim {
namespace {

/// Evenly spread shots from which it is seen where the study's shots end.
constexpr std::size_t kPilotShots = 1024;

void fill_quantities(Study& study) {
  if (!study.quantities.empty()) return;
  const StudyQuantity second = study.until.range || study.scene ? StudyQuantity::up : StudyQuantity::along;
  study.quantities = {StudyQuantity::right, second, StudyQuantity::time, StudyQuantity::speed};
  if (study.scene) study.quantities.insert(study.quantities.begin() + 2, StudyQuantity::along);
}

void add_member(Hasher& hasher, const std::shared_ptr<const Scene>& scene) {
  if (scene) hasher.add(scene->hash());
}
template <class T>
void add_member(Hasher& hasher, const T& member) {
  hasher.add(member);
}

/// What belongs to the results of shards: not how many there are.
std::uint64_t hash_of_study(const StudyPlanRecord& plan) {
  Study study = plan.study;
  study.shots = 0;
  study.until_width.reset();
  Hasher hasher;
  hasher.add(kStudyFormat);
  with_members(study, [&](const auto&... members) { (add_member(hasher, members), ...); });
  return hasher.value();
}

/// Inputs that reach into what cannot be.
void note_the_impossible(StudyPlanRecord& plan) {
  for (const StudyInput& input : plan.study.inputs) {
    const FoundPath path = find_path(input.path);
    if (!path || !path.row->above_zero || input.added) continue;  // what is added is told by the pilot shots
    const double part = probability_up_to(input.distribution, 0);
    if (part * static_cast<double>(plan.study.shots) < 0.01) continue;
    plan.notes.push_back(input.path + ": " + rounded_text(100 * part) +
                         " % of its draws are not above zero; these shots are refused, so cut the distribution off");
  }
}

std::uint64_t shards_of(const StudyPlanRecord& plan, std::uint64_t shots) {
  const std::uint64_t shards = (shots + plan.study.shard_shots - 1) / plan.study.shard_shots;
  const std::uint64_t at_once = plan.shards_at_once();
  return (shards + at_once - 1) / at_once * at_once;
}

/// Where shots arrive, roughly: cells and distances are counted about that.
void put_grids(StudyPlanRecord& plan, const SampleMoments& m) {
  PHYSIM_ASSERT(m.size() == plan.study.quantities.size());
  const auto deviation = [&](std::size_t q) { return std::sqrt(m.covariance(q, q)); };
  const auto least = [&](std::size_t q) { return 1e-9 * std::max(std::abs(m.mean[q]), 1e-3); };
  for (std::size_t q = 0; q < m.size(); ++q) plan.grids.push_back({m.mean[q], std::max(deviation(q), least(q))});
  if (plan.has_plane()) {
    plan.centre = {m.mean[0], m.mean[1]};
    const double right = m.mean[0] - plan.study.aim.right, up = m.mean[1] - plan.study.aim.up;
    plan.aim_distance = std::sqrt(right * right + up * up);
    plan.radius_scale = std::max(plan.grids[0].scale, plan.grids[1].scale);
  }
  for (const StudyQuantity axis : {StudyQuantity::x, StudyQuantity::y, StudyQuantity::z}) {
    const auto at = std::ranges::find(plan.study.quantities, axis);
    if (at == plan.study.quantities.end()) return plan.in_space.clear();
    plan.in_space.push_back(static_cast<std::size_t>(at - plan.study.quantities.begin()));
    plan.space_scale =
        std::max(plan.in_space.size() == 1 ? 0 : plan.space_scale, plan.grids[plan.in_space.back()].scale);
  }
}

/// From columns of shots at their ends, or at a place: how many arrived.
std::size_t put_seen(StudyPlanRecord& plan, std::span<const std::span<double>> columns) {
  std::vector<std::span<const double>> seen;
  std::size_t arrived = 0;
  for (std::size_t i = 0; i < kPilotShots; ++i) {
    if (!std::ranges::all_of(columns, [i](const auto& column) { return is_finite(column[i]); })) continue;
    for (const auto& column : columns) column[arrived] = column[i];
    ++arrived;
  }
  for (const auto& column : columns) seen.push_back(column.first(arrived));
  if (arrived >= 2) put_grids(plan, moments_of(seen));
  return arrived;
}

/// What may help where shots do not arrive.
const char* hint_to_arrive(const Study& study) {
  if (std::ranges::any_of(study.quantities, is_of_impact))
    return "more time: a shot that meets neither ground nor thing has no impact, and does not arrive";
  if (study.scene && study.until.range) return "leave the range out: shots end at the things that they meet before it";
  return "a range that the shot reaches, or more time";
}

Status fly_pilot(StudyPlanRecord& plan) {
  const std::size_t inputs = plan.study.inputs.size(), quantities = plan.columns();
  std::vector<double> numbers((inputs + quantities) * kPilotShots);
  std::vector<std::span<double>> in, out;
  for (std::size_t i = 0; i < inputs + quantities; ++i)
    (i < inputs ? in : out).push_back(std::span(numbers).subspan(i * kPilotShots, kPilotShots));
  const std::uint32_t rounds = std::exchange(plan.study.rounds, 1);
  draw(plan, {Sampling::sobol, ~plan.study.seed}, 0, 0, in);
  plan.study.rounds = rounds;
  ModelScratch scratch;
  const std::vector<std::span<const double>> read(in.begin(), in.end());
  const ModelTold told = plan.model->evaluate(read, out, scratch);
  if (told.refused == kPilotShots && told.error) return *told.error;
  if (told.refused > 0 && told.error && plan.notes.empty())
    plan.notes.push_back("about " + rounded_text(100.0 * static_cast<double>(told.refused) / kPilotShots) +
                         " % of the shots are refused, as the first: " + within_sentence(*told.error));
  const auto told_of = [](std::size_t arrived) {
    return "of " + std::to_string(kPilotShots) + " shots " + std::to_string(arrived) + " arrived";
  };
  std::size_t first = plan.study.quantities.size();
  if (const std::size_t arrived = put_seen(plan, std::span(out).first(first)); arrived < 2)
    return Error{told_of(arrived), "until", hint_to_arrive(plan.study)};
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    const std::size_t count = plan.places[i].study.quantities.size();
    if (const std::size_t arrived = put_seen(plan.places[i], std::span(out).subspan(first, count)); arrived < 2)
      return Error{told_of(arrived) + " there", "at[" + std::to_string(i) + ']',
                   "name a place that shots come to before they end"};
    first += count;
  }
  return {};
}

/// Adds a note for a target at the muzzle, where a plane on the ground begins, if hardly a shot comes down on it.
void note_targets_at_muzzle(StudyPlanRecord& plan) {
  const Study& study = plan.study;
  if (!plan.has_plane() || study.quantities[1] != StudyQuantity::along || study.aim.up != 0) return;
  constexpr double kHardlyAny = 4;  // times the middle distance of shots from their centre
  const double nearest = plan.centre.up - kHardlyAny * plan.radius_scale;
  for (const StudyTarget& target : study.targets) {
    const auto is_at_muzzle = [nearest](const auto& shape) {
      if constexpr (requires { shape.radius; }) return shape.centre.up == 0 && shape.radius < nearest;
      if constexpr (requires { shape.height; }) return shape.centre.up == 0 && 0.5 * shape.height < nearest;
      return false;
    };
    if (std::visit(is_at_muzzle, target.shape))
      plan.notes.push_back("target \"" + target.name + "\" stands at the muzzle: without until.range the plane lies " +
                           "on the ground, and shots come down about " + rounded_text(plan.centre.up) + " m along it");
  }
}

/// Adds a note for rounds that no figure depends on: spreads of groups are those of random shots.
void note_rounds(StudyPlanRecord& plan) {
  const Study& study = plan.study;
  if (study.rounds > 1 && study.sampling == Sampling::latin_hypercube && plan.shots_in_common() == 1)
    plan.notes.push_back(
        "study.rounds: has no effect: no input is drawn for an occasion, and Latin hypercubes have no groups of shots");
}

/// A study that ends at a place.
StudyPlanRecord place_of(const StudyPlanRecord& whole, std::size_t i) {
  StudyPlanRecord place;
  place.study = study_at(whole.study, i);
  place.takes_plane = has_plane_axes(place.study.quantities);
  place.hash = hash_of(whole.hash, std::uint64_t{i});
  place.quantiles = whole.quantiles, place.groups = whole.groups;
  if (place.study.over_inputs) place.edges = whole.edges;
  place.shards = whole.shards;
  std::size_t first = whole.study.quantities.size();
  for (std::size_t before = 0; before < i; ++before) first += whole.study.at[before].quantities.size();
  place.model = part_of_model(whole.model, first, whole.columns());
  return place;
}

Result<StudyPlan> finish(StudyPlanRecord&& plan) {
  auto groups = groups_of(plan.study);
  if (!groups) return groups.error();
  plan.groups = std::move(*groups);
  for (const StudyInput& input : plan.study.inputs) plan.quantiles.emplace_back(input.distribution);
  put_edges(plan);
  note_the_impossible(plan);
  plan.hash = hash_of_study(plan);
  plan.shards = shards_of(plan, plan.study.shots);
  for (std::size_t i = 0; i < plan.study.at.size(); ++i) plan.places.push_back(place_of(plan, i));
  if (const Status status = fly_pilot(plan); !status) return status.error();
  note_targets_at_muzzle(plan);
  note_rounds(plan);
  return StudyPlanRecord::plan_of(std::move(plan));
}

}  // namespace

std::size_t StudyPlanRecord::columns() const {
  std::size_t count = study.quantities.size();
  for (const StudyPlace& place : study.at) count += place.quantities.size();
  return count;
}

std::uint32_t StudyPlanRecord::shots_in_common() const {
  return std::ranges::count(study.inputs, DrawnFor::occasion, &StudyInput::drawn_for) > 0 ? study.rounds : 1;
}

std::uint64_t StudyPlanRecord::shards_at_once() const { return is_plain() && !study.indices ? 1 : kReplicates; }

std::vector<StudyPlan> StudyPlan::places() const {
  std::vector<StudyPlan> plans;
  for (const StudyPlanRecord& place : record_->places)
    plans.push_back(StudyPlan(std::shared_ptr<const StudyPlanRecord>(record_, &place)));
  return plans;
}

const Study& StudyPlan::study() const { return record_->study; }
std::uint64_t StudyPlan::shards() const { return record_->shards; }
const std::vector<std::string>& StudyPlan::notes() const { return record_->notes; }

Result<StudyPlan> plan_study(const Study& study) {
  const IeeeMode mode;
  if (const Status status = check(study, true); !status) return status.error();
  StudyPlanRecord plan;
  plan.study = study;
  fill_quantities(plan.study);
  fill_places(plan.study);
  Launch& launch = plan.study.launch;
  if (launch.sight.zero_range > 0) {
    const auto elevation = elevation_of(study.projectile, launch, study.environment, study.fidelity);
    if (!elevation) return elevation.error();
    launch.elevation = *elevation;
    launch.sight.zero_range = 0;
  }
  plan.takes_plane = has_plane_axes(plan.study.quantities);
  auto model = flight_model(plan.study);
  if (!model) return model.error();
  plan.model = std::move(*model);
  return finish(std::move(plan));
}

Result<StudyPlan> plan_study(const Study& study, const StudyFunction& function) {
  const IeeeMode mode;
  if (const Status status = check(study, false); !status) return status.error();
  if (!function) return Error{"is empty", "function", ""};
  StudyPlanRecord plan;
  plan.study = study;
  plan.takes_plane = has_plane_axes(plan.study.quantities);
  plan.model = function_model(function);
  return finish(std::move(plan));
}

}  // namespace physim
