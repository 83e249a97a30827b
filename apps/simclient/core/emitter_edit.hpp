// What of an emitter is drawn by hand: curves and gradients over its cycle or a particle's life. Without a window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace physim::client {

/// A curve or a gradient of an emitter.
struct EmitterLine {
  std::string_view title;  // "size over life"
  Curve* curve = nullptr;
  Gradient* gradient = nullptr;  // one of both
};
/// All that an emitter has, said or not.
[[nodiscard]] std::vector<EmitterLine> lines_of(EmitterDef& def);

/// Keys as the mouse moves them: they stay in order and within 0..1, a little apart.
inline constexpr double kKeysApart = 1e-3;

/// Which key of a list is nearest to a place, not farther than `within` along the span.
template <class Key>
[[nodiscard]] std::optional<std::size_t> key_near(const std::vector<Key>& keys, double at, double within) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double away = keys[i].at < at ? at - keys[i].at : keys[i].at - at;
    if (away <= within) nearest = i, within = away;
  }
  return nearest;
}
/// Takes a key to a place, as far as its neighbours let it.
template <class Key>
void move_key(std::vector<Key>& keys, std::size_t i, double at) {
  const double low = i == 0 ? 0 : keys[i - 1].at + kKeysApart;
  const double high = i + 1 == keys.size() ? 1 : keys[i + 1].at - kKeysApart;
  if (low <= high) keys[i].at = at < low ? low : at > high ? high : at;
}
/// Puts a key in; nothing where one is there already. Where it is in the list.
template <class Key>
std::optional<std::size_t> add_key(std::vector<Key>& keys, const Key& key) {
  if (key_near(keys, key.at, kKeysApart) || !(key.at >= 0 && key.at <= 1)) return std::nullopt;
  std::size_t i = 0;
  while (i < keys.size() && keys[i].at < key.at) ++i;
  keys.insert(keys.begin() + static_cast<std::ptrdiff_t>(i), key);
  return i;
}

/// The value of a curve, and the colour of a gradient, as emitters have them.
[[nodiscard]] double value_of(const Curve& curve, double at);
[[nodiscard]] std::uint32_t colour_of(const Gradient& gradient, double at);

/// Whether two emitters of a scenario are the same in all that lines_of() names.
[[nodiscard]] bool have_same_lines(const EmitterDef& a, const EmitterDef& b);

}  // namespace physim::client
