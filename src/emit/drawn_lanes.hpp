// Curves and gradients of several particles side by side: a lane has the bits that it has alone.
// Equation: as emit/drawn.hpp.
#pragma once

#include "emit/particle_job.hpp"
#include "math/numbers.hpp"

PHYSIM_ISA_BEGIN

/// Which piece each lies on: counted, so that no branch has to be guessed.
template <class R>
struct PlacesOf {
  std::size_t at[kLanes<R>];
};
template <class R, class Pieces>
PHYSIM_INLINE PlacesOf<R> counted(const Pieces& pieces, const R& x) {
  PlacesOf<R> places{};
  for (std::size_t k = 1; k < pieces.count; ++k)
    for (int i = 0; i < kLanes<R>; ++i) places.at[i] += lane_of(x, i) < pieces.at[k].start ? 0 : 1;
  return places;
}

// ------------------------------------------------------------------------------------------------------- curves
/// A piece, or one for each lane.
template <class R>
struct CurveLanes {
  R start, c[4], low, high;
};
template <class R>
PHYSIM_INLINE CurveLanes<R> lanes_of(const CurvePiece& p) {
  return {R(p.start), {R(p.c[0]), R(p.c[1]), R(p.c[2]), R(p.c[3])}, R(p.low), R(p.high)};
}
template <class R>
PHYSIM_INLINE R curve_value(const CurveLanes<R>& p, const R& x) {
  const R s = x - p.start;
  return min(p.high, max(p.low, p.c[0] + s * (p.c[1] + s * (p.c[2] + s * p.c[3]))));
}
template <class R>
PHYSIM_INLINE CurveLanes<R> pieces_at(const CurvePieces& pieces, const R& x) {
  const PlacesOf<R> places = counted(pieces, x);
  CurveLanes<R> all{};
  for (int i = 0; i < kLanes<R>; ++i) {
    const CurvePiece& p = pieces.at[places.at[i]];
    set_lane(all.start, i, p.start), set_lane(all.low, i, p.low), set_lane(all.high, i, p.high);
    for (int k = 0; k < 4; ++k) set_lane(all.c[k], i, p.c[k]);
  }
  return all;
}
/// The values at places none of which is below 0.
template <class R>
PHYSIM_INLINE void put_curve(const CurvePieces& pieces, const double* x, double* y, std::size_t count) {
  constexpr auto kWide = static_cast<std::size_t>(kLanes<R>);
  if (pieces.first + 2 != pieces.count) {
    for (std::size_t i = 0; i < count; i += kWide) {
      const R at = load_lanes<R>(x + i);
      store_lanes(curve_value(pieces_at(pieces, at), at), y + i);
    }
    return;
  }
  // Between two keys there is one piece, and what is held before and behind.
  const CurvePiece &piece = pieces.at[pieces.first], &last = pieces.at[pieces.count - 1];
  const CurveLanes<R> all = lanes_of<R>(piece);
  const R before(curve_value(lanes_of<double>(pieces.at[0]), 0.0)),
      behind(curve_value(lanes_of<double>(last), last.start));
  const R start(piece.start), end(last.start);
  for (std::size_t i = 0; i < count; i += kWide) {
    const R at = load_lanes<R>(x + i);
    R here = select(at < end, curve_value(all, at), behind);
    if (pieces.first > 0) here = select(at < start, before, here);
    store_lanes(here, y + i);
  }
}

// ---------------------------------------------------------------------------------------------------- gradients
/// Red, green, blue and alpha at places, 0 to 255.
template <class R>
PHYSIM_INLINE void put_gradient(const GradientPieces& pieces, const double* x, const ColourColumns& colour,
                                std::size_t count) {
  constexpr auto kWide = static_cast<std::size_t>(kLanes<R>);
  if (pieces.count == 3) {  // of two keys
    const GradientPiece &p = pieces.at[1], &last = pieces.at[2];
    for (std::size_t i = 0; i < count; i += kWide) {
      const R at = load_lanes<R>(x + i);
      R u = at - R(p.start);
      if (p.length != 1) u = u / R(p.length);
      u = select(at < R(p.start), R(0.0), select(at < R(last.start), u, R(1.0)));
      for (std::size_t k = 0; k < 4; ++k) store_lanes(R(p.colour[k]) + u * R(p.more[k]), colour.part[k] + i);
    }
    return;
  }
  for (std::size_t i = 0; i < count; i += kWide) {
    const R at = load_lanes<R>(x + i);
    const PlacesOf<R> places = counted(pieces, at);
    R start{}, length{};
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const GradientPiece& p = pieces.at[places.at[lane]];
      set_lane(start, lane, p.start), set_lane(length, lane, p.length);
    }
    const R u = (at - start) / length;
    for (std::size_t k = 0; k < 4; ++k) {
      R from{}, more{};
      for (int lane = 0; lane < kLanes<R>; ++lane) {
        const GradientPiece& p = pieces.at[places.at[lane]];
        set_lane(from, lane, p.colour[k]), set_lane(more, lane, p.more[k]);
      }
      store_lanes(from + u * more, colour.part[k] + i);
    }
  }
}

PHYSIM_ISA_END
