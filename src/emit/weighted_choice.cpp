// Equations, symbols and Source: emit/weighted_choice.hpp.
#include "emit/weighted_choice.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim {

WeightedChoice::WeightedChoice(const std::vector<double>& weights) : places_(weights.size()) {
  double sum = 0;
  for (const double w : weights) {
    PHYSIM_ASSERT(w >= 0);
    sum += w;
  }
  PHYSIM_ASSERT(sum > 0);
  const double per = static_cast<double>(weights.size()) / sum;
  std::vector<std::uint32_t> low, high;  // below one, and others
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    places_[i] = {weights[i] * per, i};
    (places_[i].keep < 1 ? low : high).push_back(i);
  }
  while (!low.empty() && !high.empty()) {
    const std::uint32_t poor = low.back(), rich = high.back();
    low.pop_back();
    places_[poor].alias = rich;
    places_[rich].keep -= 1 - places_[poor].keep;
    if (places_[rich].keep < 1) high.pop_back(), low.push_back(rich);
  }
  // What is left would be one but for rounding.
  for (const auto& list : {low, high})
    for (const std::uint32_t i : list) places_[i] = {1, i};
}

WeightedChoice::Chosen WeightedChoice::operator()(double u) const {
  PHYSIM_ASSERT(!places_.empty() && u >= 0 && u <= 1);
  const double at = u * static_cast<double>(places_.size());
  const auto i = static_cast<std::uint32_t>(std::min(at, static_cast<double>(places_.size() - 1)));
  const double part = std::min(at - i, 1.0), keep = places_[i].keep;
  if (part < keep || places_[i].alias == i) return {i, keep < 1 ? std::min(part / keep, 1.0) : part};
  return {places_[i].alias, (part - keep) / (1 - keep)};
}

}  // namespace physim
