// Numbers drawn in lanes are those drawn one by one, whatever draws them.
#include "math/normal.hpp"
#include "random_shots.hpp"
#include "study/draw_job.hpp"
#include "study/sampling.hpp"
#include "support.hpp"

namespace physim::study_draw_kernels_test {

using test::same_bits;

template <class Check>
void with_each_kernel(const Check& check) {
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    check(kernel);
  }
  use_kernel("");
}

TEST(DrawKernels, random_numbers) {
  with_each_kernel([](const std::string& kernel) {
    for (const std::uint64_t shard : {0ull, 1ull, 77ull, 1ull << 32, (1ull << 52) + 3})
      for (const std::size_t count : {1u, 2u, 7u, 32u, 33u, 256u, 1001u}) {
        std::vector<double> numbers(count + 1, 7);
        const Sampler sampler{Sampling::random, 0x123456789abcdef0};
        sampler.fill(5, shard, std::span(numbers).first(count));
        EXPECT_EQ(numbers[count], 7);
        for (std::size_t i = 0; i < count && !testing::Test::HasFailure(); ++i) {
          const std::uint64_t bits = philox_bits(sampler.seed, DrawStream::draw, 5, 0, shard * count + i);
          EXPECT_TRUE(same_bits(numbers[i], unit_of_digits(bits >> 12))) << kernel << ' ' << shard << ' ' << i;
        }
      }
  });
}

TEST(DrawKernels, normal_numbers) {
  with_each_kernel([](const std::string& kernel) {
    test::Random r(3);
    for (const std::size_t count : {0u, 1u, 3u, 16u, 17u, 1000u}) {
      std::vector<double> p;
      for (std::size_t i = 0; i < count; ++i)
        p.push_back(r.one_in(5)   ? std::pow(10.0, r.in(-300, -1))
                    : r.one_in(9) ? 1 - std::pow(10.0, r.in(-15, -1))
                                  : r.in(1e-9, 1 - 1e-9));
      std::vector<double> z = p;
      z.push_back(7);
      std::vector<double> x = z;
      draw_kernel().normals(z.data(), count, {});
      draw_kernel().normals(x.data(), count, {820, 3});
      EXPECT_EQ(z[count], 7);
      EXPECT_EQ(x[count], 7);
      for (std::size_t i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        EXPECT_TRUE(same_bits(z[i], normal_quantile(p[i]))) << kernel << ' ' << p[i];
        EXPECT_TRUE(same_bits(x[i], 820 + 3 * normal_quantile(p[i]))) << kernel << ' ' << p[i];
      }
    }
  });
}

}  // namespace physim::study_draw_kernels_test
