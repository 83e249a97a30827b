// Segments against what moves: as seen from the thing, the segment is a curve, which chords follow.
//
// A chord is nowhere farther from its part of the curve than `off` (path.hpp). Where a sphere of the segment's radius
// and `off` about the chord meets nothing, the curve meets nothing; else the chord is halved, which brings `off` down
// to a quarter, until it is below kMotionTolerance and counts as the curve. So nothing is passed unseen but what is
// grazed by less than that. A thing that does not turn and moves straight is met by one chord: exactly.
#pragma once

#include "collide/path.hpp"

namespace physim::collide {

inline constexpr double kMotionTolerance = 1e-6;  // [m]

template <bool kExits, class Take>
class Sweep {
 public:
  /// Calls take(crossing, segment) as cross() does; normals are as seen from the thing when it is met.
  Sweep(const Shape& shape, const Path& path, double time, double duration, Segment& s, const Take& take)
      : shape_(shape), path_(path), time_(time), duration_(duration), s_(s), take_(take) {
    PHYSIM_ASSERT(duration >= 0);
    if (duration < kShortest)
      as_at_rest();
    else
      in_motion();
  }

 private:
  static constexpr int kMostChords = 1 << 16, kMostHalvings = 40;
  static constexpr double kOverlap = 1 + 1e-9;  // so that nothing slips between two chords
  static constexpr double kShortest = 1e-100;   // in less nothing moves, and speeds are no numbers [s]

  struct Chord {
    double from, to;   // parts of the segment
    Vec3d begin, end;  // as seen from the thing
    double off;        // from the curve
    int halvings;
  };

  [[nodiscard]] double part_of(double time) const { return std::clamp((time - time_) / duration_, 0.0, 1.0); }
  [[nodiscard]] Vec3d seen(double part) const {
    return path_.placement(*piece_, time_ + part * duration_).inside(s_.at(part));
  }

  void in_motion() {
    const double end = time_ + duration_;
    path_.pieces(time_, end, [&](const Path::Piece& piece, double from, double to) {
      piece_ = &piece;
      follow(part_of(from), to >= end ? 1 : part_of(to));
      return s_.reach >= part_of(to);
    });
  }
  void as_at_rest() {
    Segment inside = path_.placement(time_).inside(s_);
    cross<kExits>(shape_, inside, [&](const Crossing& crossing, Segment& within) {
      take_(crossing, s_);
      within.reach = s_.reach;
    });
  }

  void follow(double from, double to) {
    if (!(from <= to)) return;
    const double begin = time_ + from * duration_, h = (to - from) * duration_;
    PHYSIM_ASSERT(piece_ && duration_ > 0);
    const MotionState start = piece_->at(begin);
    const double bend = piece_->most_acceleration(begin, begin + h);
    const double speed = length(s_.along * (1 / duration_) - start.velocity) + bend * h;
    const double far = length(s_.at(from) - start.position) + speed * h;
    const double most = bend + piece_->rate * (2 * speed + piece_->rate * far);
    const double off = piece_->is_straight() ? 0 : h * h / 8 * most * (1 + 1e-12);
    follow(Chord{from, to, seen(from), seen(to), off / path_.scale(), 0});
  }
  void follow(const Chord& chord) {
    if (s_.reach < chord.from) return;
    const bool fine = chord.off * path_.scale() <= kMotionTolerance || chord.halvings == kMostHalvings;
    if (fine || --chords_ < 0) return meet(chord);
    if (!may_meet(chord)) return;
    PHYSIM_ASSERT(chord.from <= chord.to && chord.off > 0);
    const double part = 0.5 * (chord.from + chord.to);
    const Vec3d middle = seen(part);
    follow(Chord{chord.from, part, chord.begin, middle, 0.25 * chord.off, chord.halvings + 1});
    follow(Chord{part, chord.to, middle, chord.end, 0.25 * chord.off, chord.halvings + 1});
  }
  [[nodiscard]] bool may_meet(const Chord& chord) const {
    Segment wide{chord.begin, chord.end - chord.begin, s_.radius / path_.scale() + chord.off, 1};
    bool some = false;
    cross<false>(shape_, wide, [&](const Crossing&, Segment& within) {
      some = true;
      within.reach = -1;
    });
    return some;
  }
  void meet(const Chord& chord) {
    const bool whole = chord.from == 0 && chord.to == 1;
    const double stretch = whole ? 1 : kOverlap, parts = (chord.to - chord.from) * stretch;
    const auto reach = [&] { return parts > 0 ? std::min(1.0, (s_.reach - chord.from) / parts) : s_.reach; };
    Segment inside{chord.begin, (chord.end - chord.begin) * stretch, s_.radius / path_.scale(), reach(),
                   seam_at(s_.extent()) / path_.scale()};
    cross<kExits>(shape_, inside, [&](Crossing crossing, Segment& within) {
      if (crossing.starts_inside && chord.from > 0) {
        if (kExits) return;  // the chord before has told
        crossing.starts_inside = false;
      }
      const double part = std::min(chord.from + crossing.t * parts, 1.0);
      crossing.t = chord.off > 0 && !crossing.starts_inside
                       ? on_curve(part, inside.at(crossing.t), crossing.normal, chord)
                       : part;
      if (crossing.t <= s_.reach) take_(crossing, s_);
      within.reach = reach();
    });
  }
  /// From where the chord is met to where the curve passes the plane that it met there.
  [[nodiscard]] double on_curve(double part, const Vec3d& place, const Vec3d& normal, const Chord& chord) const {
    const double rate = dot(normal, chord.end - chord.begin) / (chord.to - chord.from);
    const double most = chord.off / std::max(std::abs(rate), chord.off / (chord.to - chord.from));
    double found = part;
    for (int i = 0; i < 3 && rate != 0; ++i)
      found = std::clamp(found - dot(normal, seen(found) - place) / rate, part - 2 * most, part + 2 * most);
    return std::clamp(found, 0.0, 1.0);
  }

  const Shape& shape_;
  const Path& path_;
  double time_, duration_;
  Segment& s_;
  const Take& take_;
  const Path::Piece* piece_ = nullptr;
  int chords_ = kMostChords;
};

}  // namespace physim::collide
