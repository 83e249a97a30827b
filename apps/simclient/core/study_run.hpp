// A study that runs beside the scene: its shots fly on threads of their own, and frames look at what there is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physim/study.hpp"

namespace physim::client {

/// What there is to tell of a study where it ends, or at one of Study::at.
struct StudyTold {
  const Study& study;  // as it is there: with quantities, targets and aim of that place
  const StudyResult& result;
  const LinearResult* linear;  // what each input does by its slope; null where a shot near the mean does not arrive
  const StudyShots& dots;      // the first shots one by one, StudyRun::kMostDots of them at most
  std::size_t dots_shown;      // how many are to be seen yet
};

class StudyRun {
 public:
  static constexpr std::uint64_t kMostDots = 16384;  // shots of which each is kept, to be drawn

  enum class State { none, running, paused, done };

  StudyRun();
  ~StudyRun();
  StudyRun(StudyRun&&) noexcept;
  StudyRun& operator=(StudyRun&&) noexcept;

  /// Checks and prepares a study instead of the one before, and lets it run.
  [[nodiscard]] Status begin(const Study& study);
  /// Pauses, and goes on: with the same bits as without.
  void pause();
  void go_on();
  /// Forgets everything.
  void clear();
  /// A frame has passed. `one_by_one`: waits until one shard more is there and shows that, as scripts do, so that the
  /// same frames show the same; else shows whatever there is by now.
  void advance(bool one_by_one);

  [[nodiscard]] State state() const { return state_; }
  /// The study that was begun, prepared; null before there is one.
  [[nodiscard]] const StudyPlan* plan() const { return told_.empty() ? nullptr : &told_[0].plan; }
  /// What the shards that are shown come to: figures of `physim study` with as many shots. Nothing before the first.
  [[nodiscard]] const std::optional<StudyResult>& result() const { return result_; }
  /// What there is to tell at one of Study::at; without a place, at the end. To be asked once there is a result.
  [[nodiscard]] StudyTold told(std::optional<std::size_t> place) const;
  /// The first shots one by one, kMostDots of them at most.
  [[nodiscard]] const StudyShots& dots() const { return dots_; }
  /// How many of them are to be seen yet: they appear by and by, so that the scatter is seen to grow.
  [[nodiscard]] std::size_t dots_shown() const { return dots_shown_; }
  /// Why a study could not go on; empty: it could.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  class Flyer;
  struct Seen;
  /// A place, or the end, as it was prepared.
  struct Told {
    StudyPlan plan;
    std::optional<LinearResult> linear;
  };

  void take(Seen seen);

  State state_ = State::none;
  std::vector<Told> told_;        // the end, then each place; empty before there is a study
  std::unique_ptr<Flyer> flyer_;  // none while nothing flies
  StudyPart part_;                // that is there by now
  std::uint64_t shards_ = 0;      // that are shown
  std::optional<StudyResult> result_;
  StudyShots dots_;
  std::size_t dots_shown_ = 0;
  std::string problem_;
};

}  // namespace physim::client
