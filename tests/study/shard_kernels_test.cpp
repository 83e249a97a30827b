// Work on columns of shots gives the bits that shot by shot gives, whatever kernel does it.
#include "study/shard_job.hpp"

#include "math/vec3.hpp"
#include "random_shots.hpp"
#include "study/cell_number.hpp"
#include "study/sums.hpp"
#include "study/targets.hpp"
#include "support.hpp"

namespace physim::study_shard_kernels_test {

using namespace test;

constexpr std::size_t kCounts[] = {1, 2, 7, 8, 9, 16, 17, 31, 33, 1000, 4001};

/// For each kernel and count.
template <class Check>
void with_each_kernel(const Check& check) {
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const std::size_t count : kCounts) check(shard_kernel(), count, kernel + ' ' + std::to_string(count));
  }
  use_kernel("");
}

std::vector<double> column(Random& r, std::size_t count, double low, double high) {
  std::vector<double> numbers(count);
  for (double& x : numbers) x = r.in(low, high);
  return numbers;
}

/// `expected(i)` for each place; behind the last one nothing is written.
template <class Expected>
void expect_column(std::vector<double> is, std::size_t count, const Expected& expected, const std::string& what) {
  ASSERT_EQ(is.size(), count + 1) << what;
  EXPECT_EQ(is[count], 7) << what;
  for (std::size_t i = 0; i < count && !testing::Test::HasFailure(); ++i)
    EXPECT_TRUE(same_bits(is[i], expected(i))) << what << ' ' << i << ": " << is[i] << ", not " << expected(i);
}

TEST(ShardKernels, stretch_measure_and_look_along_axes) {
  Random r(3);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    const auto x = column(r, count, -9, 9), y = column(r, count, -9, 9), z = column(r, count, -9, 9);
    std::vector<double> into(count + 1, 7);
    kernel.stretch(0.3, 1.7, x.data(), into.data(), count);
    expect_column(
        into, count, [&](std::size_t i) { return 0.3 + 1.7 * x[i]; }, what);
    const Vec3d axis{0.3, -0.5, 0.8}, start{1, 2, 3};
    kernel.along({axis, start, x.data(), y.data(), z.data(), into.data(), count});
    const auto along = [&](std::size_t i) {
      return (x[i] - start.x) * axis.x + (y[i] - start.y) * axis.y + (z[i] - start.z) * axis.z;
    };
    expect_column(into, count, along, what);
    kernel.lengths(x.data(), y.data(), z.data(), into.data(), count);
    expect_column(
        into, count, [&](std::size_t i) { return std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]); }, what);
    kernel.distances(x.data(), y.data(), 0.5, -0.7, into.data(), count);
    const auto distance = [&](std::size_t i) {
      return std::sqrt((x[i] - 0.5) * (x[i] - 0.5) + (y[i] + 0.7) * (y[i] + 0.7));
    };
    expect_column(into, count, distance, what);
  });
}

/// Shots that are far from the plane, or fly away from it, do not come there.
TEST(ShardKernels, move_shots_to_the_plane) {
  Random r(4);
  const Vec3d forward = normalized(Vec3d{1, 0.01, 0.02}), muzzle{0, 1.5, 0}, a{-80, -9, 0.3};
  int nowhere = 0, there = 0;
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    std::vector<double> of[7];
    const double low[] = {1, 980, -9, -9, -300, -40, -5}, high[] = {2, 1020, 9, 9, 500, 40, 5};
    for (int k = 0; k < 7; ++k) of[k] = column(r, count, low[k], high[k]), of[k].push_back(7);
    std::vector<double> moved[7];
    std::copy(std::begin(of), std::end(of), moved);
    kernel.to_plane({forward, muzzle, 1000, a, 0.25, moved[0].data(), moved[1].data(), moved[2].data(), moved[3].data(),
                     moved[4].data(), moved[5].data(), moved[6].data(), count});
    std::vector<double> expected[7];
    std::copy(std::begin(of), std::end(of), expected);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3d x{of[1][i], of[2][i], of[3][i]}, v{of[4][i], of[5][i], of[6][i]};
      const double left = 1000 - dot(x - muzzle, forward), ahead = dot(v, forward), slower = dot(a, forward);
      const double t = 2 * left / (ahead + std::sqrt(ahead * ahead + 2 * slower * left));
      if (!(ahead > 0 && std::abs(t) <= 0.25 * of[0][i])) {
        expected[1][i] = kNan, ++nowhere;
        continue;
      }
      ++there;
      x += v * t + a * (0.5 * t * t);
      v += a * t;
      const double end[] = {of[0][i] + t, x.x, x.y, x.z, v.x, v.y, v.z};
      for (int k = 0; k < 7; ++k) expected[k][i] = end[k];
    }
    for (int k = 0; k < 7; ++k)
      expect_column(
          moved[k], count, [&](std::size_t i) { return expected[k][i]; }, what + ' ' + std::to_string(k));
  });
  EXPECT_GT(nowhere, 100);
  EXPECT_GT(there, 100);
}

TEST(ShardKernels, see_what_is_no_number) {
  Random r(5);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    auto x = column(r, count, -1e300, 1e300);
    EXPECT_TRUE(kernel.all_finite(x.data(), count)) << what;
    EXPECT_TRUE(kernel.all_finite(x.data(), 0));
    for (const std::size_t i : {std::size_t{0}, count / 2, count - 1})
      for (const double bad : {kNan, kInfinity, -kInfinity}) {
        const double was = std::exchange(x[i], bad);
        EXPECT_FALSE(kernel.all_finite(x.data(), count)) << what << ' ' << i;
        x[i] = was;
      }
  });
}

/// Of zeros of either sign the first is the least, the last the most, as std::minmax_element() has it.
TEST(ShardKernels, find_the_least_and_the_most) {
  Random r(6);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    for (int turn = 0; turn < 20; ++turn) {
      auto x = column(r, count, turn % 3 == 0 ? 0 : -5, turn % 3 == 1 ? 0 : 5);
      for (double& number : x)
        if (turn > 9 && r.one_in(3)) number = r.one_in(2) ? 0.0 : -0.0;
      const auto [least, most] = std::minmax_element(x.begin(), x.end());
      const LeastAndMost of = kernel.least_and_most(x.data(), count);
      EXPECT_TRUE(same_bits(of.least, *least) && same_bits(of.most, *most)) << what << ' ' << turn;
    }
  });
}

/// In four lanes, which are added in the end.
double sum_in_lanes(std::size_t count, const auto& term) {
  double lanes[4] = {};
  const std::size_t whole = count / 4 * 4;
  for (std::size_t i = 0; i < count; ++i) lanes[i < whole ? i % 4 : 0] += term(i);
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

TEST(ShardKernels, add_up_moments) {
  Random r(12);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    std::vector<std::vector<double>> numbers;
    std::vector<const double*> columns;
    for (std::size_t size = 1; size <= 5; ++size) {
      numbers.push_back(column(r, count, -2, 9));
      columns.clear();
      for (const auto& each : numbers) columns.push_back(each.data());
      std::vector<double> means(size + 1, 7), products(size * (size + 1) / 2 + 1, 7);
      kernel.moments({columns.data(), size, count, means.data(), products.data()});
      const auto mean = [&](std::size_t k) {
        return sum_in_lanes(count, [&](std::size_t i) { return columns[k][i]; }) / static_cast<double>(count);
      };
      expect_column(means, size, mean, what);
      std::vector<double> expected;
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t l = k; l < size; ++l)
          expected.push_back(sum_in_lanes(
              count, [&](std::size_t i) { return (columns[k][i] - means[k]) * (columns[l][i] - means[l]); }));
      expect_column(
          products, expected.size(), [&](std::size_t i) { return expected[i]; }, what);
    }
  });
}

TEST(ShardKernels, number_cells) {
  Random r(7);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    auto x = column(r, count, -30, 30);
    for (double& number : x)
      if (r.one_in(4)) number = r.one_in(2) ? r.in(-1e20, 1e20) : r.one_in(2) ? 0.25 : 0.25 + r.in(-1e-9, 1e-9);
    x[0] = kInfinity;
    std::vector<std::uint64_t> cells(count + 1, 7);
    kernel.cells({x.data(), 0.25, 1 / 0.3, cells.data(), count});
    EXPECT_EQ(cells[count], 7);
    for (std::size_t i = 0; i < count; ++i) {
      const double y = (x[i] - 0.25) * (1 / 0.3), t = 1 + std::min(std::abs(y), 0x1p40);
      int exponent = 0;  // t = fraction 2^exponent, from 0.5 on
      const double fraction = std::frexp(t, &exponent);
      const auto k = static_cast<std::int64_t>(256 * (exponent - 1)) +
                     static_cast<std::int64_t>(std::floor((2 * fraction - 1) * 256));
      EXPECT_EQ(static_cast<std::int64_t>(cells[i]), y < 0 ? -1 - k : k) << what << ' ' << x[i];
    }
  });
}

TEST(ShardKernels, measure_extreme_spreads) {
  Random r(8);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    for (const std::size_t size : {2u, 3u, 10u, 100u}) {
      const std::size_t groups = count / size;
      auto right = column(r, count, -9, 9), up = column(r, count, -9, 9);
      for (double& x : right)
        if (r.one_in(90)) x = kNan;
      std::vector<double> spreads(groups + 1, 7);
      kernel.spreads({right.data(), up.data(), size, groups, spreads.data()});
      const auto expected = [&](std::size_t group) {
        double most = 0, all = 0;
        for (std::size_t i = group * size; i < (group + 1) * size; ++i) {
          all += right[i] + up[i];
          for (std::size_t j = group * size; j < i; ++j) {
            const double x = right[i] - right[j], y = up[i] - up[j];
            most = std::max(most, x * x + y * y);
          }
        }
        return is_finite(all) ? std::sqrt(most) : kNan;
      };
      expect_column(spreads, groups, expected, what + ' ' + std::to_string(size));
    }
  });
}

TEST(ShardKernels, reach_in_each_direction) {
  Random r(9);
  with_each_kernel([&](const ShardKernel& kernel, std::size_t count, const std::string& what) {
    const auto right = column(r, count, -9, 3), up = column(r, count, -2, 9);
    ReachJob job{.right = right.data(), .up = up.data(), .count = count};
    for (std::size_t k = 0; k < ReachJob::kDirections; ++k) job.to_right[k] = r.in(-1, 1), job.to_up[k] = r.in(-1, 1);
    kernel.reach(job);
    for (std::size_t k = 0; k < ReachJob::kDirections; ++k) {
      double farthest = -kInfinity;
      for (std::size_t i = 0; i < count; ++i)
        farthest = std::max(farthest, job.to_right[k] * right[i] + job.to_up[k] * up[i]);
      EXPECT_TRUE(same_bits(job.reach[k], farthest)) << what << ' ' << k;
    }
  });
}

/// Shots that did not arrive may have a place; those alone that did are marked.
TEST(ShardKernels, targets_mark_who_lies_on_them) {
  Random r(10);
  const auto right = column(r, 400, -2, 2), up = column(r, 400, -2, 2);
  const std::vector<std::uint32_t> arrived = {0, 3, 5, 6, 7, 100, 101, 102, 103, 104, 105, 106, 107, 108, 398, 399};
  const auto expect = [&](const StudyTarget& target, const auto& covers) {
    std::vector<std::uint8_t> marks(400, 9);
    mark_covered(target, arrived, right, up, marks);
    int on = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
      const bool has = std::ranges::binary_search(arrived, i);
      EXPECT_EQ(marks[i], has ? (covers(right[i], up[i]) ? 1 : 0) : 9) << i;
      on += has && marks[i] == 1 ? 1 : 0;
    }
    EXPECT_GT(on, 2);
    EXPECT_LT(on, 14);
  };
  expect({"disc", CircleTarget{{0.2, 0.1}, 1.2}},
         [](double x, double y) { return std::hypot(x - 0.2, y - 0.1) < 1.2; });
  expect({"plate", RectangleTarget{{0.1, -0.2}, 2, 3}},
         [](double x, double y) { return std::abs(x - 0.1) < 1 && std::abs(y + 0.2) < 1.5; });
  expect({"wedge", PolygonTarget{{{-2, -2}, {2, -2}, {-2, 2}}}}, [](double x, double y) { return x + y < 0; });
}

TEST(WorstShots, are_kept_one_by_one_as_all_at_once) {
  Random r(11);
  std::vector<SumOfShot> all, kept;
  for (std::uint64_t shot = 0; shot < 300; ++shot) {
    const SumOfShot one{shot, std::floor(r.in(0, 60))};
    all.push_back(one);
    put_worst(kept, one);
  }
  std::ranges::stable_sort(all, std::ranges::greater(), &SumOfShot::distance);
  ASSERT_EQ(kept.size(), kWorstShots);
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_TRUE(kept[i].shot == all[i].shot && kept[i].distance == all[i].distance) << i;
}

}  // namespace physim::study_shard_kernels_test
