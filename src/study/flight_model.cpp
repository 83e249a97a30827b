// Flights of a block of shots: columns where launches and weather alone are uncertain, a structure for each shot where
// more of it is.
//
// The plane of impact is that of the shot without uncertainty: across its line of sight, at the range. A flight ends on
// the plane across its own line of sight, from its own muzzle, which an uncertain azimuth or place moves; from there it
// continues, or returns, for the time t to the plane:
//   x' = x + v t + a t^2 / 2,  v' = v + a t,
// a the acceleration of the shot without uncertainty where it arrives. With an azimuth e off [rad] the planes are
// range e^2 / 2 apart, and nothing of it is left to see. With a muzzle off by 20 m, t is about 0.04 s; what is left out
// is how accelerations differ and change, some per cent of a t^2 / 2: millimetres, and 0.15 m/s. A shot that needs more
// than a quarter of its time of flight to the plane, or does not go towards it, counts as not arrived.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/checker.hpp"
#include "base/hash.hpp"
#include "flight/pilot.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/earth.hpp"
#include "model/ladder.hpp"
#include "model/sight.hpp"
#include "physim/scene.hpp"
#include "prepare/grant.hpp"
#include "study/impacts.hpp"
#include "study/model.hpp"
#include "study/paths.hpp"
#include "study/places.hpp"
#include "study/quantities.hpp"
#include "study/shard_job.hpp"
#include "study/targets.hpp"

namespace physim {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// A number of the shot or its weather, and the inputs that are drawn for it.
struct UncertainNumber {
  FoundPath path;
  double there;           // without uncertainty
  bool replaced = false;  // by the first of the inputs; the others are added
  std::vector<std::size_t> inputs{};

  [[nodiscard]] const PathRow& row() const { return *path.row; }
};

/// A block of shots: what they drew, and how they ended.
struct Block {
  InputColumns inputs;
  std::span<double> speeds;                      // work space
  std::vector<std::span<const double>> columns;  // of the uncertain numbers, then the two of a wind by compass
  SeenColumns ends;
  ModelScratch& scratch;
  Weather weather{};

  [[nodiscard]] std::size_t size() const { return ends.time.size(); }
};

class FlightModel : public ShotModel {
 public:
  explicit FlightModel(const Study& study)
      : study_(study), plain_{study.projectile, study.launch}, sight_(sight_frame(study.launch)), places_(study.at) {
    study_.inputs.clear();
    study_.until.scene = study_.scene.get();
    places_.watch(study_.until);
    if (study_.scene) things_ = things_of(study_), as_columns_ = false;
    for (std::size_t i = 0; i < study.inputs.size(); ++i) take(study.inputs[i], i);
  }
  [[nodiscard]] Status prepare();
  [[nodiscard]] Status check_gravity() const;
  ModelTold evaluate(InputColumns inputs, QuantityColumns quantities, ModelScratch& scratch) const override;

 private:
  void take(const StudyInput& input, std::size_t index);
  void blow_by_compass(const Block& block, std::span<double> x, std::span<double> z) const;
  [[nodiscard]] Weather weather_of(const Block& block) const;
  [[nodiscard]] std::span<const double> column_of(const UncertainNumber& number, InputColumns inputs,
                                                  std::span<double> room) const;
  [[nodiscard]] ModelTold fly(const Block& block) const;
  [[nodiscard]] LaunchColumns launches_of(const Block& block) const;
  [[nodiscard]] ModelTold fly_columns_of(const Block& block, const LaunchColumns& launches) const;
  [[nodiscard]] ModelTold fly_launches_of(const Block& block, const LaunchColumns& launches) const;
  [[nodiscard]] ModelTold fly_shots_of(const Block& block) const;
  [[nodiscard]] Environment environment_of(std::size_t shot, const Block& block) const;
  void fly_in_own_places(const Block& block, std::span<const Shot> shots) const;
  void fly_among_things(const Block& block, std::span<const Shot> shots) const;
  void mark_things(const Flight& flight, std::size_t shot, std::size_t shots, ModelScratch& scratch) const;
  [[nodiscard]] ModelTold take_batch(const Block& block) const;
  void move_to_plane(const SeenColumns& seen, double range, const Vec3d& acceleration) const;
  void put_ground_impacts(const Block& block) const;
  void put(StudyQuantity quantity, const SeenColumns& seen, const ModelScratch& scratch, std::span<double> into) const;
  void put_places(const ModelScratch& scratch, QuantityColumns quantities) const;

  Study study_;
  Shot plain_;
  SightFrame sight_;
  std::vector<UncertainNumber> numbers_;
  ThingsOfTargets things_;
  Places places_;
  Vec3d acceleration_{};                       // of the shot without uncertainty, where it ends [m/s^2]
  std::vector<Vec3d> acceleration_at_places_;  // of that shot at each place, or its end if it never comes there [m/s^2]
  Fidelity granted_{};
  std::optional<Impacts> impacts_;  // where they are asked for
  bool as_columns_ = true;
  bool moves_profile_ = false;  // an uncertain wind is added to a profile
  bool has_own_place_ = false;  // numbers of the place are uncertain, which all shots of a batch have in common
  bool has_factor_ = false;     // of several numbers of a shot
  bool by_compass_ = false;     // the wind; two more columns have its components
  bool draws_gravity_ = false;
  std::optional<std::size_t> azimuth_;  // among the numbers, where that of the x axis is drawn
};

void FlightModel::take(const StudyInput& input, std::size_t index) {
  const FoundPath path = find_path(input.path);
  PHYSIM_ASSERT(path);
  const PathRow* row = path.row;
  if (row->is_wind && row->weather && study_.environment.wind.profile.size() > 0) moves_profile_ = true;
  if (row->compass != CompassWind::none)
    by_compass_ = true;
  else if (!row->launches && !row->weather)
    as_columns_ = false;
  if (row->is_of_place()) has_own_place_ = true;
  if (row->scale) has_factor_ = true;
  auto at = std::ranges::find(numbers_, path, &UncertainNumber::path);
  if (at == numbers_.end()) {
    numbers_.push_back({path, path.there(plain_, study_.environment)});
    at = numbers_.end() - 1;
    if (path.is(study_.environment, study_.environment.earth.azimuth)) azimuth_ = numbers_.size() - 1;
    if (path.is(study_.environment, study_.environment.gravity.acceleration)) draws_gravity_ = true;
  }
  at->inputs.insert(input.added ? at->inputs.end() : at->inputs.begin(), index);
  at->replaced = at->replaced || !input.added;
}

/// An acceleration of one's own goes with no flattened field, nor with the GM of a round Earth: shots that drew one
/// would stand on another rung than a shot with the mean.
Status FlightModel::check_gravity() const {
  const bool of_the_earth = row(granted_.gravity).field != GravityField::uniform && is_round(granted_.earth);
  if (!draws_gravity_ || !of_the_earth) return {};
  return Error{"an acceleration of each shot's own has no field of the Earth", "inputs",
               "let gravity be 'constant', or the earth 'flat' or 'flat_coriolis'"};
}

/// An automatic step is chosen once for all shards, with the margin that batches have.
Status FlightModel::prepare() {
  const Flight flight = physim::fly(plain_.projectile, plain_.launch, study_.environment, study_.fidelity,
                                    study_.tolerance, study_.until);
  if (flight.error()) return *flight.error();
  acceleration_ = flight.accelerations(flight.duration()).total;
  for (std::size_t i = 0; i < places_.size(); ++i)
    acceleration_at_places_.push_back(flight.accelerations(places_.time_of(flight, i)).total);
  granted_ = flight.fidelity_in_use().fidelity;
  if (Status status = check_gravity(); !status) return status;
  if (std::ranges::any_of(study_.quantities, is_of_impact)) impacts_.emplace(study_, granted_);
  if (step_given(granted_, study_.tolerance) || steps_by_frames(granted_)) return {};
  Tolerance finer = study_.tolerance;
  finer.position_error *= 0.4;
  const auto step = pilot_step(plain_.projectile, plain_.launch, study_.environment, granted_, finer, study_.until);
  if (!step) return step.error();
  study_.tolerance.step = *step;
  return {};
}

std::span<const double> FlightModel::column_of(const UncertainNumber& number, InputColumns inputs,
                                               std::span<double> room) const {
  PHYSIM_ASSERT(!number.inputs.empty());
  if (number.replaced && number.inputs.size() == 1) return inputs[number.inputs[0]];
  const double offset = number.replaced ? 0 : number.there;
  shard_kernel().stretch(offset, 1, inputs[number.inputs[0]].data(), room.data(), room.size());
  for (const std::size_t input : std::span(number.inputs).subspan(1))
    for (std::size_t i = 0; i < room.size(); ++i) room[i] += inputs[input][i];
  return room;
}

/// Where it comes from is where it does not blow to.
void FlightModel::blow_by_compass(const Block& block, std::span<double> x, std::span<double> z) const {
  PHYSIM_ASSERT(by_compass_ && x.size() == z.size());
  const Vec3d& there = study_.environment.wind.velocity;
  std::span<const double> speed, from, azimuth;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i].row().compass == CompassWind::speed) speed = block.columns[i];
    if (numbers_[i].row().compass == CompassWind::from) from = block.columns[i];
    if (i == azimuth_) azimuth = block.columns[i];
  }
  const double plain_speed = std::sqrt(there.x * there.x + there.z * there.z);
  const Vec3d plain_way = plain_speed > 0 ? there * (1 / plain_speed) : Vec3d{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double strength = speed.empty() ? plain_speed : speed[i];
    if (from.empty()) {
      x[i] = strength * plain_way.x, z[i] = strength * plain_way.z;
      continue;
    }
    const auto side = sincos(from[i] - (azimuth.empty() ? study_.environment.earth.azimuth : azimuth[i]));
    x[i] = -strength * side.cos, z[i] = -strength * side.sin;
  }
}

Weather FlightModel::weather_of(const Block& block) const {
  PHYSIM_ASSERT(block.columns.size() == numbers_.size() + (by_compass_ ? 2 : 0));
  Weather weather;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const PathRow& row = numbers_[i].row();
    if (row.weather) weather.*row.weather = block.columns[i];
  }
  weather.moves_profile = moves_profile_;
  if (by_compass_) weather.wind_x = block.columns[numbers_.size()], weather.wind_z = block.columns[numbers_.size() + 1];
  return weather;
}

LaunchColumns FlightModel::launches_of(const Block& block) const {
  LaunchColumns launches{.common = plain_.launch};
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    if (const auto column = numbers_[i].row().launches) launches.*column = block.columns[i];
  if (launches.speed.empty()) {
    std::ranges::fill(block.speeds, plain_.launch.speed);
    launches.speed = block.speeds;
  }
  return launches;
}

ModelTold FlightModel::fly_columns_of(const Block& block, const LaunchColumns& launches) const {
  const auto& [time, x, y, z, vx, vy, vz] = block.ends;
  const EndColumns into{std::span(block.scratch.outcomes).first(block.size()), time, x, y, z, vx, vy, vz};
  const ColumnsResult result = fly_columns(plain_.projectile, launches, study_.environment, study_.fidelity,
                                           study_.tolerance, study_.until, into, nullptr, block.weather);
  return {result.refused, result.error, {}};
}

/// What is watched on the way are events, which columns do not have.
ModelTold FlightModel::fly_launches_of(const Block& block, const LaunchColumns& launches) const {
  PHYSIM_ASSERT(!launches.has_drag() && launches.size() == block.size());
  block.scratch.launches.resize(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) block.scratch.launches[i] = launches.at(i);
  fly_batch(plain_.projectile, block.scratch.launches, study_.environment, study_.fidelity, study_.tolerance,
            study_.until, block.scratch.batch, nullptr, block.weather);
  return take_batch(block);
}

ModelTold FlightModel::fly_shots_of(const Block& block) const {
  ModelScratch& scratch = block.scratch;
  if (scratch.shots.size() < block.size()) scratch.shots.resize(block.size(), plain_);
  const auto shots = std::span(scratch.shots).first(block.size());
  if (has_factor_) std::ranges::fill(shots, plain_);  // its points are multiplied by the factor, drawn ones, too
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    for (std::size_t shot = 0; shot < shots.size(); ++shot) numbers_[i].path.put(shots[shot], block.columns[i][shot]);
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    for (std::size_t shot = 0; shot < shots.size() && numbers_[i].row().scale; ++shot)
      numbers_[i].row().scale(shots[shot], block.columns[i][shot]);
  if (study_.scene)
    fly_among_things(block, shots);
  else if (has_own_place_)
    fly_in_own_places(block, shots);
  else
    fly_batch(shots, study_.environment, study_.fidelity, study_.tolerance, study_.until, scratch.batch, nullptr,
              block.weather);
  return take_batch(block);
}

/// Flies a block the quickest way that it can go.
ModelTold FlightModel::fly(const Block& block) const {
  if (as_columns_) {
    const LaunchColumns launches = launches_of(block);
    if (places_.empty()) return fly_columns_of(block, launches);
    if (!launches.has_drag()) return fly_launches_of(block, launches);
  }
  return fly_shots_of(block);
}

ModelTold FlightModel::take_batch(const Block& block) const {
  const BatchResult& batch = block.scratch.batch;
  const SeenColumns& ends = block.ends;
  PHYSIM_ASSERT(batch.shots.size() == block.size());
  for (const ShotEvent& event : batch.events) places_.take(event.event, event.shot, block.scratch.places);
  ModelTold told{0, batch.error, {}};
  for (std::size_t i = 0; i < block.size(); ++i) {
    const ShotResult& shot = batch.shots[i];
    block.scratch.outcomes[i] = shot.outcome;
    told.refused += shot.outcome == Outcome::refused ? 1 : 0;
    ends.time[i] = shot.time;
    ends.x[i] = shot.position.x, ends.y[i] = shot.position.y, ends.z[i] = shot.position.z;
    ends.vx[i] = shot.velocity.x, ends.vy[i] = shot.velocity.y, ends.vz[i] = shot.velocity.z;
  }
  return told;
}

/// The environment that a shot flies in alone.
Environment FlightModel::environment_of(std::size_t shot, const Block& block) const {
  Environment own = study_.environment;
  for (std::size_t k = 0; k < numbers_.size(); ++k)
    if (!numbers_[k].row().weather) numbers_[k].path.put(own, block.columns[k][shot]);
  if (!block.weather.empty()) block.weather.put(shot, own);
  return own;
}

/// Each shot alone, at its own place.
void FlightModel::fly_in_own_places(const Block& block, std::span<const Shot> shots) const {
  BatchResult all, one;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Environment own = environment_of(i, block);
    fly_batch(shots.subspan(i, 1), own, study_.fidelity, study_.tolerance, study_.until, one);
    PHYSIM_ASSERT(one.shots.size() == 1);
    all.shots.push_back(one.shots[0]);
    for (const ShotEvent& event : one.events) places_.take(event.event, i, block.scratch.places);
    if (one.error && !all.error) all.error = one.error;
  }
  block.scratch.batch = std::move(all);
}

/// Each shot alone through the scene, as fly() does. What its contacts leave to chance follows from what it drew.
void FlightModel::fly_among_things(const Block& block, std::span<const Shot> shots) const {
  ModelScratch& scratch = block.scratch;
  BatchResult all;
  all.shots.resize(shots.size());
  Until until = study_.until;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    Hash chance(study_.until.contact.seed);
    for (const auto& column : block.inputs) chance.add(column[i]);
    until.contact.seed = chance.value();
    const Flight flight = physim::fly(shots[i].projectile, shots[i].launch, environment_of(i, block), study_.fidelity,
                                      study_.tolerance, until);
    ShotResult& shot = all.shots[i];
    shot.outcome = flight.outcome();
    if (flight.error() && !all.error) all.error = flight.error();
    if (flight.error()) continue;
    const Sample end = flight.end();
    shot.time = end.time, shot.position = end.position, shot.velocity = end.velocity;
    for (const Event& event : flight.events()) places_.take(event, i, scratch.places);
    mark_things(flight, i, shots.size(), scratch);
    if (impacts_) scratch.impacts[i] = impacts_->first_of(flight);
  }
  scratch.batch = std::move(all);
}

void FlightModel::mark_things(const Flight& flight, std::size_t shot, std::size_t shots, ModelScratch& scratch) const {
  PHYSIM_ASSERT(scratch.thing_hits.size() == things_.size() * shots);
  for (const Event& event : flight.events()) {
    if (event.kind != EventKind::hit && event.kind != EventKind::sensed) continue;
    for (std::size_t target = 0; target < things_.size(); ++target)
      if (std::ranges::binary_search(things_[target], event.instance)) scratch.thing_hits[target * shots + shot] = 1;
  }
}

void FlightModel::move_to_plane(const SeenColumns& seen, double range, const Vec3d& acceleration) const {
  constexpr double kLastPart = 0.25;  // parts of the time of flight
  shard_kernel().to_plane({sight_.forward, sight_.muzzle, range, acceleration, kLastPart, seen.time.data(),
                           seen.x.data(), seen.y.data(), seen.z.data(), seen.vx.data(), seen.vy.data(), seen.vz.data(),
                           seen.x.size()});
}

/// Impacts of shots that fly without a scene.
void FlightModel::put_ground_impacts(const Block& block) const {
  const bool all_alike = as_columns_;  // in what flies
  const auto& [time, x, y, z, vx, vy, vz] = block.ends;
  ModelScratch& scratch = block.scratch;
  MassInFlight mass(plain_.projectile, granted_);
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (scratch.outcomes[i] != Outcome::landed) continue;
    if (!all_alike) mass = MassInFlight(scratch.shots[i].projectile, granted_);
    scratch.impacts[i] = impacts_->on_ground({x[i], y[i], z[i]}, {vx[i], vy[i], vz[i]}, mass.at(time[i]));
  }
}

void FlightModel::put(StudyQuantity quantity, const SeenColumns& e, const ModelScratch& scratch,
                      std::span<double> into) const {
  const auto copy = [&](std::span<const double> from) { std::copy(from.begin(), from.end(), into.begin()); };
  const auto seen = [&](const Vec3d& axis, const Vec3d& start) {
    shard_kernel().along({axis, start, e.x.data(), e.y.data(), e.z.data(), into.data(), into.size()});
  };
  switch (quantity) {
    case StudyQuantity::time: return copy(e.time);
    case StudyQuantity::x: return copy(e.x);
    case StudyQuantity::y: return copy(e.y);
    case StudyQuantity::z: return copy(e.z);
    case StudyQuantity::vx: return copy(e.vx);
    case StudyQuantity::vy: return copy(e.vy);
    case StudyQuantity::vz: return copy(e.vz);
    case StudyQuantity::speed:
      return shard_kernel().lengths(e.vx.data(), e.vy.data(), e.vz.data(), into.data(), into.size());
    case StudyQuantity::right: return seen(sight_.right, sight_.start);
    case StudyQuantity::up: return seen(sight_.up, sight_.start);
    case StudyQuantity::along: return seen(sight_.forward, sight_.muzzle);
    case StudyQuantity::impact_speed:
    case StudyQuantity::obliquity:
    case StudyQuantity::impact_energy:
      for (std::size_t i = 0; i < into.size(); ++i) into[i] = part_of(scratch.impacts[i], quantity);
      return;
  }
  PHYSIM_UNREACHABLE();
}

/// Columns of one place after the other; NaN of shots that do not come there.
void FlightModel::put_places(const ModelScratch& scratch, QuantityColumns quantities) const {
  PHYSIM_ASSERT(scratch.places.size() == places_.size());
  std::size_t column = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const SeenColumns& seen = scratch.places[i];
    const StudyPlace& place = study_.at[i];
    if (place.event.kind == EventKind::range) move_to_plane(seen, place.event.value, acceleration_at_places_[i]);
    for (const StudyQuantity quantity : place.quantities) put(quantity, seen, scratch, quantities[column++]);
  }
  PHYSIM_ASSERT(column == quantities.size());
}

ModelTold FlightModel::evaluate(InputColumns inputs, QuantityColumns all, ModelScratch& scratch) const {
  const QuantityColumns quantities = all.first(study_.quantities.size());
  const std::size_t count = quantities[0].size();
  scratch.numbers.resize(count * (10 + numbers_.size()));
  scratch.outcomes.resize(std::max(scratch.outcomes.size(), count));
  scratch.thing_hits.assign(things_.size() * count, 0);
  scratch.places = places_.columns(count, scratch.place_numbers);
  if (impacts_) scratch.impacts.assign(count, kNoImpact);
  std::size_t taken = 0;
  const auto room = [&] { return std::span(scratch.numbers).subspan(count * taken++, count); };
  Block block{inputs, {}, {}, {room(), room(), room(), room(), room(), room(), room()}, scratch};
  block.speeds = room();
  for (const UncertainNumber& number : numbers_) block.columns.push_back(column_of(number, inputs, room()));
  if (by_compass_) {
    const std::span<double> x = room(), z = room();
    blow_by_compass(block, x, z);
    block.columns.insert(block.columns.end(), {x, z});
  }
  block.weather = weather_of(block);
  ModelTold told = fly(block);
  if (impacts_ && !study_.scene) put_ground_impacts(block);
  if (study_.until.range) move_to_plane(block.ends, *study_.until.range, acceleration_);
  for (std::size_t q = 0; q < quantities.size(); ++q) put(study_.quantities[q], block.ends, scratch, quantities[q]);
  for (std::size_t i = 0; i < count; ++i) {
    const Outcome outcome = scratch.outcomes[i];
    if (outcome == Outcome::refused && !told.first) told.first = i;
    const bool arrived = study_.until.range ? outcome == Outcome::reached_range && std::isfinite(block.ends.x[i])
                                            : ended_as_planned(outcome);
    if (arrived) continue;
    for (const auto& column : quantities) column[i] = kNowhere;
  }
  put_places(scratch, all.subspan(quantities.size()));
  return told;
}

class FunctionModel : public ShotModel {
 public:
  explicit FunctionModel(StudyFunction function) : function_(std::move(function)) {}
  ModelTold evaluate(InputColumns inputs, QuantityColumns quantities, ModelScratch&) const override {
    function_(inputs, quantities);
    return {};
  }

 private:
  StudyFunction function_;
};

}  // namespace

Result<std::shared_ptr<const ShotModel>> flight_model(const Study& study) {
  auto model = std::make_shared<FlightModel>(study);
  if (const Status status = model->prepare(); !status) return status.error();
  return std::shared_ptr<const ShotModel>(std::move(model));
}

std::shared_ptr<const ShotModel> function_model(const StudyFunction& function) {
  return std::make_shared<FunctionModel>(function);
}

}  // namespace physim
