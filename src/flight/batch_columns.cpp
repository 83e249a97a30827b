// fly_columns(): launches taken from columns, and ends written into columns, part by part.
#include <algorithm>
#include <limits>
#include <mutex>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "flight/batch_threads.hpp"
#include "flight/kernels.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"

namespace physim {
namespace {

/// Shots of a part: few enough that their ends stay in the cache until they are written.
constexpr std::size_t kPart = 2048;

void check_columns(Checker& c, const LaunchColumns& from, const EndColumns& into) {
  c.require(!from.common.velocity, "launches.common.velocity", "cannot differ from shot to shot",
            "give a speed, an elevation and an azimuth");
  const std::size_t count = from.size();
  const auto check_length = [&](std::size_t length, const char* place) {
    c.require(length == 0 || length == count, place, "has another length than the other columns",
              "one number for each shot, or none");
  };
  const std::pair<const char*, std::span<const double>> launches[] = {
      {"launches.x", from.x},
      {"launches.y", from.y},
      {"launches.z", from.z},
      {"launches.speed", from.speed},
      {"launches.elevation", from.elevation},
      {"launches.azimuth", from.azimuth},
      {"launches.ballistic_coefficient", from.ballistic_coefficient},
      {"launches.form_factor", from.form_factor}};
  for (const auto& [place, column] : launches) check_length(column.size(), place);
  check_length(into.outcome.size(), "into.outcome");
  const std::pair<const char*, std::span<double>> ends[] = {{"into.time", into.time}, {"into.x", into.x},
                                                            {"into.y", into.y},       {"into.z", into.z},
                                                            {"into.vx", into.vx},     {"into.vy", into.vy},
                                                            {"into.vz", into.vz},     {"into.speed", into.speed},
                                                            {"into.drop", into.drop}, {"into.windage", into.windage}};
  for (const auto& [place, column] : ends) check_length(column.size(), place);
}

/// Writes the ends of a part's shots into the columns.
class EndWriter {
 public:
  EndWriter(const BatchTask& task, const EndColumns& into) : task_(task), into_(into) {}

  /// Block by block, as a block of shots stays in the fastest cache until all of its columns are written.
  void write(std::size_t first, const PartResult& part) const {
    constexpr std::size_t kBlock = 128;
    const std::span<const ShotResult> all = part.shots;
    for (std::size_t i = 0; i < all.size(); i += kBlock)
      write_block(first + i, all.subspan(i, std::min(kBlock, all.size() - i)), part.refused > 0);
    write_sighted(first, all);
  }

 private:
  void write_block(std::size_t first, std::span<const ShotResult> shots, bool some_refused) const {
    const auto put = [&](auto column, const auto& none, const auto& number) {
      if (column.empty()) return;
      PHYSIM_ASSERT(first + shots.size() <= column.size());
      auto* to = column.data() + first;
      for (const ShotResult& shot : shots) *to++ = number(shot);
      if (!some_refused) return;
      to -= shots.size();
      for (const ShotResult& shot : shots) {
        if (shot.outcome == Outcome::refused) *to = none;
        ++to;
      }
    };
    put(into_.outcome, Outcome::refused, [](const ShotResult& s) { return s.outcome; });
    put(into_.time, kNone, [](const ShotResult& s) { return s.time; });
    put(into_.x, kNone, [](const ShotResult& s) { return s.position.x; });
    put(into_.y, kNone, [](const ShotResult& s) { return s.position.y; });
    put(into_.z, kNone, [](const ShotResult& s) { return s.position.z; });
    put(into_.vx, kNone, [](const ShotResult& s) { return s.velocity.x; });
    put(into_.vy, kNone, [](const ShotResult& s) { return s.velocity.y; });
    put(into_.vz, kNone, [](const ShotResult& s) { return s.velocity.z; });
    put(into_.speed, kNone, [](const ShotResult& s) { return length(s.velocity); });
  }

  /// What is seen from the sight: it is the same for all shots of one place and azimuth.
  void write_sighted(std::size_t first, std::span<const ShotResult> shots) const {
    if (into_.drop.empty() && into_.windage.empty()) return;
    Launch scratch;
    SightFrame sight = sight_frame(task_.shots.launch(first, scratch));
    const LaunchColumns& from = *task_.shots.columns;
    const bool differs = !from.azimuth.empty() || !from.x.empty() || !from.y.empty() || !from.z.empty();
    for (std::size_t i = 0; i < shots.size(); ++i) {
      if (differs) sight = sight_frame(task_.shots.launch(first + i, scratch));
      const bool refused = shots[i].outcome == Outcome::refused;
      const Vec3d seen = shots[i].position - sight.start;
      if (!into_.drop.empty()) into_.drop[first + i] = refused ? kNone : dot(seen, sight.up);
      if (!into_.windage.empty()) into_.windage[first + i] = refused ? kNone : dot(seen, sight.right);
    }
  }

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const BatchTask& task_;
  const EndColumns& into_;
};

/// What the parts report: of the first shot that has it, whichever part comes in first.
class Summary {
 public:
  void take(std::size_t first, PartResult& part) {
    const std::lock_guard lock(mutex_);
    refused_ += part.refused;
    if (part.error && first < first_error_) first_error_ = first, error_ = std::move(part.error);
    if (part.in_use && first < first_in_use_) first_in_use_ = first, in_use_ = std::move(*part.in_use);
  }
  [[nodiscard]] ColumnsResult result() {
    return {refused_, std::move(error_), batch_kernel().name, std::move(in_use_)};
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::mutex mutex_;
  std::size_t refused_ = 0, first_error_ = kNone, first_in_use_ = kNone;
  std::optional<Error> error_;
  FidelityInUse in_use_;
};

ColumnsResult refuse_all(std::size_t count, const Error& error) {
  ColumnsResult result;
  result.refused = count;
  result.error = error;
  return result;
}

}  // namespace

ColumnsResult fly_columns(const ProjectileDef& projectile, const LaunchColumns& launches,
                          const Environment& environment, const Fidelity& fidelity, const Tolerance& tolerance,
                          const Until& until, const EndColumns& into, TaskRunner* runner, const Weather& weather) {
  const IeeeMode mode;
  const std::size_t count = launches.size();
  const ShotList list{.one_projectile = &projectile, .columns = &launches};
  const BatchTask task{list, environment, weather, fidelity, tolerance, until};
  Checker c;
  check_columns(c, launches, into);
  if (const Status status = c.also(check_common(task)).status(); !status) return refuse_all(count, status.error());
  Summary summary;
  const EndWriter ends(task, into);
  const auto fly = [&](BatchPart& part, std::size_t i) {
    const std::size_t first = i * kPart;
    std::vector<ShotResult>& shots = part.own_shots(std::min(kPart, count - first));
    PartResult given{.shots = shots, .wants_events = false};
    part.fly(first, given);
    ends.write(first, given);
    summary.take(first, given);
  };
  BatchSteps steps(task);
  BatchThreads(task, steps, (count + kPart - 1) / kPart, fly).run(runner);
  ColumnsResult result = summary.result();
  for (FidelityNote& note : steps.notes()) result.fidelity_in_use.notes.push_back(std::move(note));
  return result;
}

}  // namespace physim
