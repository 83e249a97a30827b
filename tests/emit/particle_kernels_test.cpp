// Columns of numbers: each kernel gives each particle the bits that it has alone.
#include "emit/looks.hpp"
#include "emit/pack_chance.hpp"
#include "emit/particle_job.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::emit_particle_kernels_test {

using test::same_bits;
using Column = std::array<double, kColumn>;

template <class Check>
void with_each_kernel(const Check& check) {
  for (const std::string& name : kernels()) {
    ASSERT_TRUE(use_kernel(name));
    const std::string_view found = particle_kernel().name;
    EXPECT_EQ(found, name == "scalar" ? "base" : name);
    for (int round = 0; round < 200 && !testing::Test::HasFailure(); ++round) {
      test::Random r(static_cast<std::uint64_t>(round));
      check(particle_kernel(), r);
    }
  }
  use_kernel("");
}

/// Places, some of them at keys and beyond the last one.
Column places(test::Random& r, const std::vector<double>& keys) {
  Column x;
  for (double& at : x) at = !keys.empty() && r.one_in(3) ? keys[r.bits() % keys.size()] : r.in(0, 1.1);
  return x;
}
Curve random_curve(test::Random& r, std::vector<double>& keys) {
  Curve curve;
  for (double at = r.one_in(2) ? 0 : r.in(0, 0.4); at <= 1 && !r.one_in(6); at += r.in(0.05, 0.5)) {
    curve.push_back({at, r.one_in(4) ? 0 : r.in(-2, 2)});
    keys.push_back(at);
  }
  return curve;
}
Gradient random_gradient(test::Random& r, std::vector<double>& keys) {
  Gradient gradient;
  for (double at = r.one_in(2) ? 0 : r.in(0, 0.4); at <= 1 && !r.one_in(6); at += r.in(0.05, 0.5)) {
    gradient.push_back({at, r.bits()});
    keys.push_back(at);
  }
  return gradient;
}

TEST(ParticleKernels, words_are_those_of_each_number) {
  with_each_kernel([](const ParticleKernel& kernel, test::Random& r) {
    std::array<std::uint64_t, kColumn> number;
    for (auto& n : number) n = r.one_in(2) ? r.bits() % 1000 : std::uint64_t{r.bits()} << 32 | r.bits();
    const std::uint64_t seed = std::uint64_t{r.bits()} << 32 | r.bits();
    const std::uint32_t index = r.bits() >> 8;
    const auto job = [&](auto& words, std::size_t count) {
      return WordsJob{seed,
                      static_cast<std::uint32_t>(EmitStream::flight) | index << 8,
                      count,
                      number.data(),
                      {words[0].data(), words[1].data(), words[2].data(), words[3].data()}};
    };
    WordColumns<kColumn> words;
    kernel.words(job(words, kColumn));
    WordColumns<kColumn> few;
    const std::size_t count = 1 + r.below(kColumn);
    kernel.words(job(few, count));
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_TRUE(std::ranges::equal(std::span(few[k]).first(count), std::span(words[k]).first(count)));
    for (std::size_t i = 0; i < kColumn; ++i) {
      const PhiloxCounter alone = emit_words(seed, EmitStream::flight, index, number[i], 0);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(words[k][i], alone[k]) << kernel.name << ' ' << i;
    }
  });
}

TEST(ParticleKernels, numbers_are_those_of_each_place_and_draw) {
  with_each_kernel([](const ParticleKernel& kernel, test::Random& r) {
    std::vector<double> keys;
    DrawnNumber def{r.in(-3, 3), {}, random_curve(r, keys)};
    if (!r.one_in(3)) def.to = r.one_in(4) ? def.value : r.in(-3, 3);
    if (def.to && r.one_in(2)) def.to_curve = random_curve(r, keys);
    const EmitNumber number(def);
    const Column x = places(r, keys);
    Column y;
    std::array<std::uint32_t, kColumn> words;
    for (auto& word : words) word = r.one_in(8) ? 0xffffffff : r.bits();
    kernel.number(number.job(x.data(), number.is_drawn() ? words.data() : nullptr, y.data()));
    for (std::size_t i = 0; i < kColumn; ++i)
      EXPECT_TRUE(same_bits(y[i], number.at(x[i], [&] { return open_unit(words[i]); }))) << kernel.name << ' ' << x[i];
  });
}

TEST(ParticleKernels, colours_are_those_of_each_place) {
  with_each_kernel([](const ParticleKernel& kernel, test::Random& r) {
    std::vector<double> keys;
    const EmitGradient gradient(random_gradient(r, keys));
    const Column x = places(r, keys);
    RgbaColumns<kColumn> colour;
    gradient.at_each(x, colour, &kernel);
    std::array<std::uint32_t, kColumn> packed;
    kernel.pack_colours(columns_of(colour), packed.data());
    for (std::size_t i = 0; i < kColumn; ++i) {
      const Rgba alone = gradient(x[i]);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(same_bits(colour[k][i], alone.part[k])) << kernel.name;
      EXPECT_EQ(packed[i], alone.packed()) << kernel.name << ' ' << x[i];
    }
  });
}

TEST(ParticleKernels, a_life_is_lived_from_birth_to_the_end_of_its_span) {
  with_each_kernel([](const ParticleKernel& kernel, test::Random& r) {
    Column birth, span, part;
    const double time = r.in(0, 100);
    for (std::size_t i = 0; i < kColumn; ++i) {
      birth[i] = r.one_in(5) ? time : r.in(time - 3, time + 0.5);
      span[i] = r.one_in(5) ? time - birth[i] : r.in(0.1, 3);
      if (!(span[i] > 0)) span[i] = 1;
    }
    kernel.part_of_life(time, birth.data(), span.data(), part.data());
    for (std::size_t i = 0; i < kColumn; ++i)
      EXPECT_TRUE(same_bits(part[i], std::clamp((time - birth[i]) / span[i], 0.0, 1.0))) << kernel.name;
  });
}

}  // namespace physim::emit_particle_kernels_test
