#include "flight/batch_steps.hpp"

#include <algorithm>

#include "prepare/check.hpp"
#include "prepare/launch.hpp"

namespace physim {

Result<double> BatchSteps::step_of(const Fidelity& granted) {
  if (const auto given = step_given(granted, task_.tolerance)) return *given;
  if (steps_by_frames(granted)) return kFrame;  // shots that need a shorter one fly alone
  const std::lock_guard lock(mutex_);
  Known& asked = known(granted);
  if (!asked.step) asked.step = choose(asked);
  return *asked.step;
}

std::vector<FidelityNote> BatchSteps::notes() const {
  std::vector<FidelityNote> all;
  for (const Known& k : known_)
    if (k.note) all.push_back(*k.note);
  return all;
}

/// Looks at shots until one of them flies so.
BatchSteps::Known& BatchSteps::known(const Fidelity& granted) {
  const auto find = [&] { return std::ranges::find(known_, granted, &Known::granted); };
  auto at = find();
  for (; at == known_.end(); ++scouted_) {
    PHYSIM_ASSERT(scouted_ < task_.shots.size());  // each caller has such a shot
    if (scout_.prepare(scouted_) != ShotState::flies) continue;
    const Fidelity& its = scout_.kind().group->cohort.in_use.fidelity;
    if (std::ranges::find(known_, its, &Known::granted) == known_.end()) known_.push_back({its, scouted_});
    at = find();
  }
  return *at;
}

Result<double> BatchSteps::choose(Known& known) {
  double step = kInfinity;
  PilotStep worst{0, task_.tolerance.position_error};
  for (const std::size_t i : pilots(known)) {
    Launch scratch;
    ShotEnvironments environments(task_);
    ShotProjectiles projectiles(task_.shots);
    const auto found = step_within(projectiles.of(i), task_.shots.launch(i, scratch), environments.of(i), known.granted,
                                   task_.tolerance, task_.until, 0.4 * task_.tolerance.position_error, step);
    if (!found) return found.error();
    step = std::min(step, found->step);
    if (found->reached > worst.reached) worst = *found;
  }
  PHYSIM_ASSERT(step > 0 && step < kInfinity);
  if (worst.step > 0) known.note = note_of_step(worst, task_.tolerance.position_error);
  return step;
}

bool BatchSteps::is_granted(std::size_t shot, const Fidelity& granted) {
  ShotProjectiles projectiles(task_.shots);
  const ProjectileDef& projectile = projectiles.of(shot);
  Launch scratch;
  const Launch& launch = task_.shots.launch(shot, scratch);
  ShotEnvironments environments(task_);
  return check(projectile) && check(launch) && check(projectile, launch) && check(environments.of(shot)) &&
         scout_.group_of(projectile).cohort.in_use.fidelity == granted;
}

std::vector<std::size_t> BatchSteps::pilots(const Known& known) {
  const std::size_t count = task_.shots.size();
  std::size_t slowest = known.first, fastest = slowest;
  double lowest = task_.shots.speed(slowest), highest = lowest;
  for (std::size_t i = 0; i < count; ++i) {
    const double speed = task_.shots.speed(i);
    if (speed < lowest) lowest = speed, slowest = i;
    if (speed > highest) highest = speed, fastest = i;
  }
  std::vector<std::size_t> list{known.first};
  for (const std::size_t i : {count / 2, count - 1, slowest, fastest})
    if (std::find(list.begin(), list.end(), i) == list.end() && is_granted(i, known.granted)) list.push_back(i);
  return list;
}

}  // namespace physim
