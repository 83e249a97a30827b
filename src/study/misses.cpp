#include "study/misses.hpp"

#include <algorithm>
#include <limits>

#include "math/normal_quantile.hpp"
#include "study/targets.hpp"

namespace physim {
namespace {

constexpr std::uint32_t kPoints = 46368, kStep = 28657;  // neighbours among Fibonacci's numbers
constexpr double kFewest = 100.0 / kPoints;

/// Impacts as the lattice has them.
struct LatticeImpacts {
  std::vector<std::uint32_t> numbers;
  std::vector<double> right, up;

  LatticeImpacts(const PlanePoint& mean, const PlaneCovariance& s) : numbers(kPoints), right(kPoints), up(kPoints) {
    const double along = std::sqrt(std::max(s.right_right, 0.0));
    const double both = along > 0 ? s.right_up / along : 0;
    const double alone = std::sqrt(std::max(s.up_up - both * both, 0.0));
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const auto turned = static_cast<std::uint32_t>(std::uint64_t{i} * kStep % kPoints);
      const double first = normal_quantile((i + 0.5) / kPoints), second = normal_quantile((turned + 0.5) / kPoints);
      numbers[i] = i;
      right[i] = mean.right + along * first;
      up[i] = mean.up + both * first + alone * second;
    }
  }
};

}  // namespace

std::vector<double> parts_beside(const Study& study, const PlanePoint& mean, const PlaneCovariance& all) {
  const LatticeImpacts impacts(mean, all);
  std::vector<std::uint8_t> marks(kPoints);
  std::vector<double> parts;
  for (const StudyTarget& target : study.targets) {
    mark_covered(target, impacts.numbers, impacts.right, impacts.up, marks);
    parts.push_back(static_cast<double>(std::ranges::count(marks, std::uint8_t{0})) / kPoints);
  }
  return parts;
}

std::vector<double> shares_of_misses(const Study& study, const PlanePoint& mean, const PlaneCovariance& all,
                                     const PlaneCovariance& of_group) {
  std::vector<double> shares = parts_beside(study, mean, all);
  const std::vector<double> without = parts_beside(study, mean, all - of_group);
  PHYSIM_ASSERT(shares.size() == study.targets.size() && without.size() == shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const bool is_thing = std::holds_alternative<ThingTarget>(study.targets[i].shape);
    shares[i] = is_thing || shares[i] < kFewest ? std::numeric_limits<double>::quiet_NaN() : 1 - without[i] / shares[i];
  }
  return shares;
}

}  // namespace physim
