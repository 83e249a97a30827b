#include "study/misses.hpp"

#include <algorithm>
#include <limits>

#include "math/normal_quantile.hpp"
#include "study/targets.hpp"

namespace physim {
namespace {

constexpr std::uint32_t kPoints = 46368, kStep = 28657;  // neighbours among Fibonacci's numbers
constexpr double kFewest = 100.0 / kPoints;

}  // namespace

Misses::Misses(const Study& study, const PlanePoint& mean, const PlaneCovariance& all)
    : study_(study),
      mean_(mean),
      all_(all),
      numbers_(kPoints),
      first_(kPoints),
      second_(kPoints),
      right_(kPoints),
      up_(kPoints),
      marks_(kPoints) {
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const auto turned = static_cast<std::uint32_t>(std::uint64_t{i} * kStep % kPoints);
    numbers_[i] = i;
    first_[i] = normal_quantile((i + 0.5) / kPoints);
    second_[i] = normal_quantile((turned + 0.5) / kPoints);
  }
  beside_ = parts_beside(all);
}

std::vector<double> Misses::parts_beside(const PlaneCovariance& s) {
  const double along = std::sqrt(std::max(s.right_right, 0.0));
  const double both = along > 0 ? s.right_up / along : 0;
  const double alone = std::sqrt(std::max(s.up_up - both * both, 0.0));
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    right_[i] = mean_.right + along * first_[i];
    up_[i] = mean_.up + both * first_[i] + alone * second_[i];
  }
  std::vector<double> parts;
  for (const StudyTarget& target : study_.targets) {
    mark_covered(target, numbers_, right_, up_, marks_);
    parts.push_back(static_cast<double>(std::ranges::count(marks_, std::uint8_t{0})) / kPoints);
  }
  return parts;
}

std::vector<double> Misses::shares_of(const PlaneCovariance& group) {
  std::vector<double> shares = parts_beside(all_ - group);
  PHYSIM_ASSERT(shares.size() == study_.targets.size() && beside_.size() == shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const bool is_thing = std::holds_alternative<ThingTarget>(study_.targets[i].shape);
    shares[i] =
        is_thing || beside_[i] < kFewest ? std::numeric_limits<double>::quiet_NaN() : 1 - shares[i] / beside_[i];
  }
  return shares;
}

}  // namespace physim
