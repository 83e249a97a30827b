#include "emit/odometer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

constexpr int kPartsOfPiece = 16;

struct GaussNode {
  double at;  // -1..1
  double weight;
};
constexpr std::array<GaussNode, 5> kGaussNodes = {{{-0.906179845938664, 0.236926885056189},
                                                   {-0.538469310105683, 0.478628670499366},
                                                   {0, 0.568888888888889},
                                                   {0.538469310105683, 0.478628670499366},
                                                   {0.906179845938664, 0.236926885056189}}};

/// It goes along a curve, or at a speed that changes.
bool is_bent(const collide::Path::Piece& piece) { return piece.c2 != Vec3d{} || piece.c3 != Vec3d{}; }

}  // namespace

Odometer::Odometer(const collide::Path& path, double from) {
  double distance = 0;
  path.pieces(from, kInfinity, [&](const collide::Path::Piece& piece, double begin, double end) {
    // Parts are those of the whole piece, whenever counting begins.
    const bool is_divided = is_bent(piece) && std::isfinite(end);
    const double part = is_divided ? (end - piece.start) / kPartsOfPiece : kInfinity;
    for (double i = is_divided ? std::floor((begin - piece.start) / part) : 0; i < kPartsOfPiece; ++i) {
      const double low = is_divided ? std::max(begin, piece.start + i * part) : begin;
      const double high = i + 1 < kPartsOfPiece && is_divided ? piece.start + (i + 1) * part : end;
      if (!(high > low)) continue;
      marks_.push_back({low, distance, piece});
      if (!std::isfinite(high)) break;
      distance += way(piece, low, high);
      if (!is_divided) break;
    }
    return true;
  });
  PHYSIM_ASSERT(!marks_.empty());
}

double Odometer::way(const collide::Path::Piece& piece, double from, double to) {
  PHYSIM_ASSERT(to >= from);
  if (!is_bent(piece)) return length(piece.c1) * (to - from);
  const double half = (to - from) / 2, middle = from + half;
  double sum = 0;
  for (const GaussNode& node : kGaussNodes) sum += node.weight * length(piece.velocity(middle + half * node.at));
  return sum * half;
}

const Odometer::Mark& Odometer::mark_at(double time) const {
  const auto after = std::ranges::upper_bound(marks_, time, {}, &Mark::time);
  return after == marks_.begin() ? marks_.front() : *std::prev(after);
}

double Odometer::at(double time) const {
  PHYSIM_ASSERT(time >= from());
  const Mark& mark = mark_at(time);
  return mark.distance + way(mark.piece, mark.time, time);
}

std::optional<double> Odometer::when(double distance, double latest) const {
  PHYSIM_ASSERT(distance > 0);
  if (!(latest > from()) || !(at(latest) >= distance)) return std::nullopt;
  const auto after = std::ranges::lower_bound(marks_, distance, {}, &Mark::distance);
  const Mark& mark = *std::prev(after);  // the last one before the distance is reached
  if (!is_bent(mark.piece)) return std::min(mark.time + (distance - mark.distance) / length(mark.piece.c1), latest);
  // The distance only grows: the time is halved until it cannot be halved any more.
  double low = mark.time, high = after == marks_.end() ? latest : after->time;
  for (double middle = low + (high - low) / 2; middle > low && middle < high; middle = low + (high - low) / 2)
    (mark.distance + way(mark.piece, mark.time, middle) < distance ? low : high) = middle;
  return std::min(high, latest);
}

}  // namespace physim
