// When emitters fire in a step, in order of time, and where they are then.
//
// Each emitter's next moment waits in a queue, beside those of its metres and its rain, and beside what sub-emitters
// were set off by. Moments of one emitter by itself are taken from its timeline several at a time, so that what is born
// at them is drawn and flown side by side; they wait in the queue one by one as all others do.
#pragma once

#include <cstddef>
#include <optional>

#include "world/birth_columns.hpp"
#include "world/emitter_firing.hpp"
#include "world/emitter_rain.hpp"

namespace physim {

class EmitterMoments {
 public:
  /// The step ends at `end` [s].
  EmitterMoments(WorldImpl& world, const SettleContext& context, double end);

  /// The ways of those that are led through the step are known by now.
  void close_ways();

 protected:
  enum Rank : std::uint32_t { kOwnMoment, kMetre, kFill, kRain, kSub };

  /// Where one is and which way it points; none: what it follows is gone.
  [[nodiscard]] std::optional<Pose> pose_at(std::uint32_t emitter, double time) const;
  /// So far it is led in this step; what lies before the first cycle does not count [m].
  [[nodiscard]] double led_way(std::uint32_t emitter) const;

  /// An emitter's own moment, and when that is in the world [s].
  struct OwnMoment {
    double time;
    EmitMoment moment;
  };
  /// The next one in the step that is not taken.
  [[nodiscard]] std::optional<OwnMoment> next_moment(const Emitter& emitter) const;
  void queue_moment(std::uint32_t emitter);
  void queue_metre(std::uint32_t emitter);
  /// The box of its rain goes through the step, along a straight way.
  void begin_rain(std::uint32_t emitter);
  void queue_rain(std::uint32_t emitter);

  /// Whether moments of one are taken ahead: nothing between them changes which they are, or their numbers.
  [[nodiscard]] bool sees_ahead(const Firing& first) const;
  /// Takes its first moment, `first`, and those after it that let out one particle each, at most so many.
  BirthColumns& look_ahead(const Firing& first, std::size_t most);
  [[nodiscard]] bool has_ahead(std::uint32_t emitter) const {
    return s_.ahead[emitter] && !s_.ahead[emitter]->is_over();
  }
  /// One of those that were taken ahead.
  [[nodiscard]] Firing firing_of(std::uint32_t emitter, const BirthColumns& births, std::size_t lane) const;
  /// How many of them come before all else that waits, from the next on, which does.
  [[nodiscard]] std::size_t first_ahead(std::uint32_t emitter, const BirthColumns& births) const;

  const WorldImpl& world_;
  const SettleContext& context_;
  Emitters& all_;
  EmitterScratch& s_;
  double end_;            // of the step [s]
  bool is_past_ = false;  // the step is the time before the world's
  FiringQueue queue_;
  RainStep rain_;

 private:
  void take_steady(Emitter& emitter, std::size_t room, BirthColumns& births) const;
  [[nodiscard]] std::optional<double> when_led(std::uint32_t emitter, double distance) const;
  [[nodiscard]] EmitMoment rain_moment(std::uint32_t emitter, double time, std::uint32_t count) const;
};

}  // namespace physim
