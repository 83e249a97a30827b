// fly_batch(): cuts a batch into parts, flies them on all threads that are lent, and joins what comes back.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "flight/batch_threads.hpp"
#include "flight/kernels.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"

namespace physim {

namespace {

Status check_columns(const Weather& weather, std::size_t shots) {
  const std::pair<const char*, std::size_t> columns[] = {
      {"weather.wind_x", weather.wind_x.size()},     {"weather.wind_y", weather.wind_y.size()},
      {"weather.wind_z", weather.wind_z.size()},     {"weather.temperature", weather.temperature.size()},
      {"weather.pressure", weather.pressure.size()}, {"weather.humidity", weather.humidity.size()},
      {"weather.density", weather.density.size()}};
  for (const auto& [place, length] : columns)
    if (length != 0 && length != shots)
      return Error{"has another length than there are shots", place, "one number for each shot, or none"};
  return {};
}

Status check_station(const Weather& weather, const Atmosphere& air) {
  const std::pair<const char*, bool> columns[] = {{"weather.temperature", !weather.temperature.empty()},
                                                  {"weather.pressure", !weather.pressure.empty()},
                                                  {"weather.humidity", !weather.humidity.empty()}};
  for (const auto& [place, is_given] : columns)
    if (is_given && !air.profile.empty())
      return Error{"is that of a station, and the environment has air by levels", place,
                   "leave temperature, pressure and humidity of the weather out, or Atmosphere::profile"};
  return {};
}

}  // namespace

Status check_common(const BatchTask& task) {
  if (task.until.scene)
    return Error{"many shots at once meet nothing", "until.scene", "fly() and worlds let projectiles meet things"};
  for (const Status& status :
       {check(task.environment), check(task.tolerance, task.fidelity), check(task.until),
        check_columns(task.weather, task.shots.size()), check_station(task.weather, task.environment.atmosphere)})
    if (!status) return status;
  return task.shots.one_projectile ? check(*task.shots.one_projectile) : Status{};
}

namespace {

/// Shots of a part: enough to fill packs, of each group where projectiles differ; few enough that all threads end at
/// about the same time. One thread flies all in one part.
std::size_t part_size(const BatchTask& task, const TaskRunner* runner) {
  const std::size_t fitting = task.shots.one_projectile ? 2048 : 16384;
  return runner != nullptr && runner->threads() > 1 ? fitting : std::max<std::size_t>(task.shots.size(), 1);
}

/// Adds what a part gave, from the shot `first` on; parts come in their order.
void join(PartResult& part, std::size_t first, BatchResult& result, bool& some_accepted) {
  if (part.error && !result.error) result.error = std::move(part.error);
  if (part.in_use && !std::exchange(some_accepted, true)) result.fidelity_in_use = std::move(*part.in_use);
  if (first == 0) return result.events.swap(part.events);
  for (ShotEvent& event : part.events) event.shot += static_cast<std::uint32_t>(first);
  result.events.insert(result.events.end(), part.events.begin(), part.events.end());
}

bool some_turned(const std::vector<PartResult>& parts) {
  return std::ranges::any_of(parts, [](const PartResult& part) { return part.turned; });
}

void fly_task(const ShotList& shots, const Environment& environment, const Fidelity& fidelity,
              const Tolerance& tolerance, const Until& until, BatchResult& result, TaskRunner* runner,
              const Weather& weather) {
  const IeeeMode mode;
  const BatchTask task{shots, environment, weather, fidelity, tolerance, until};
  const std::size_t count = task.shots.size();
  result.kernel = batch_kernel().name;
  result.shots.resize(count);  // each is written once: how it ended, or that it was refused
  result.attitudes.clear();
  result.events.clear();
  result.fidelity_in_use = {};
  result.error.reset();
  if (const Status status = check_common(task); !status) {
    std::ranges::fill(result.shots, ShotResult{});
    result.error = status.error();
    return;
  }
  const bool has_attitudes = may_turn(task.fidelity);
  if (has_attitudes) result.attitudes.resize(count);
  const std::size_t size = part_size(task, runner);
  std::vector<PartResult> parts((count + size - 1) / size);
  if (!parts.empty()) parts[0].events.swap(result.events);  // its memory is used again
  const auto fly = [&](BatchPart& part, std::size_t i) {
    const std::size_t first = i * size, own = std::min(size, count - first);
    parts[i].shots = std::span(result.shots).subspan(first, own);
    if (has_attitudes) parts[i].attitudes = std::span(result.attitudes).subspan(first, own);
    parts[i].events.reserve(own);
    part.fly(first, parts[i]);
  };
  BatchSteps steps(task);
  BatchThreads(task, steps, parts.size(), fly).run(runner);
  if (!some_turned(parts)) result.attitudes.clear();
  bool some_accepted = false;
  for (std::size_t i = 0; i < parts.size(); ++i) join(parts[i], i * size, result, some_accepted);
  for (FidelityNote& note : steps.notes()) result.fidelity_in_use.notes.push_back(std::move(note));
}

}  // namespace

void fly_batch(std::span<const Shot> shots, const Environment& environment, const Fidelity& fidelity,
               const Tolerance& tolerance, const Until& until, BatchResult& result, TaskRunner* runner,
               const Weather& weather) {
  const ShotList list{.shots = shots};
  fly_task(list, environment, fidelity, tolerance, until, result, runner, weather);
}

void fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
               const Fidelity& fidelity, const Tolerance& tolerance, const Until& until, BatchResult& result,
               TaskRunner* runner, const Weather& weather) {
  const ShotList list{.one_projectile = &projectile, .launches = launches};
  fly_task(list, environment, fidelity, tolerance, until, result, runner, weather);
}

BatchResult fly_batch(std::span<const Shot> shots, const Environment& environment, const Fidelity& fidelity,
                      const Tolerance& tolerance, const Until& until, TaskRunner* runner, const Weather& weather) {
  BatchResult result;
  fly_batch(shots, environment, fidelity, tolerance, until, result, runner, weather);
  return result;
}

BatchResult fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
                      const Fidelity& fidelity, const Tolerance& tolerance, const Until& until, TaskRunner* runner,
                      const Weather& weather) {
  BatchResult result;
  fly_batch(projectile, launches, environment, fidelity, tolerance, until, result, runner, weather);
  return result;
}

}  // namespace physim
