// Air through stations, by power series and by layers, against its laws in long double.
#include "model/low_air.hpp"

#include "math/polynomial.hpp"
#include "support.hpp"

namespace physim::model_low_air_test {

constexpr long double kG0 = 9.80665L, kGas = 8314.32L, kMolar = 28.9644L, kR0 = 6356766.0L;
constexpr long double kBases[] = {0, 11000, 20000, 32000, 47000, 51000, 71000};
constexpr long double kLapses[] = {-0.0065L, 0, 0.001L, 0.0028L, 0, -0.0028L, -0.002L};

struct Station {
  double altitude = 0, temperature = 288.15, pressure = 101325, humidity = 0;

  [[nodiscard]] Environment environment() const {
    return Environment{.altitude = altitude,
                       .atmosphere = {.temperature = temperature, .pressure = pressure, .humidity = humidity}};
  }
};

int layer_of(long double h) {
  int i = 0;
  while (i < 6 && h >= kBases[i + 1]) ++i;
  return i;
}
long double standard_temperature(long double h) {
  long double t = 288.15L;
  const int layer = layer_of(h);
  for (int i = 0; i < layer; ++i) t += kLapses[i] * (kBases[i + 1] - kBases[i]);
  return t + kLapses[layer] * (h - kBases[layer]);
}

struct State {
  long double density, sound;
};
/// The laws: the standard's profile moved to the station's temperature, pressure in equilibrium layer by layer.
State by_law(const Station& s, long double z) {
  const long double h_station = kR0 * s.altitude / (kR0 + s.altitude), h = kR0 * z / (kR0 + z);
  const long double shift = s.temperature - standard_temperature(h_station);
  const long double f =
      moist_air_density(s.temperature, s.pressure, s.humidity) * kGas * s.temperature / (s.pressure * kMolar);
  const long double k = f * kG0 * kMolar / kGas;
  const auto log_ratio = [&](int i, long double from, long double to) {
    const long double a = standard_temperature(from) + shift, b = a + kLapses[i] * (to - from);
    return kLapses[i] == 0 ? -k * (to - from) / a : -k / kLapses[i] * std::log(b / a);
  };
  long double log_p = 0, from = h_station;
  const long double step = h >= from ? 1 : -1;
  while (from != h) {
    const int i = step > 0 ? layer_of(from) : layer_of(from - 1e-9L);
    long double to = h;
    if (step > 0 && i < 6) to = std::min(h, kBases[i + 1]);
    if (step < 0 && i > 0) to = std::max(h, kBases[i]);
    log_p += log_ratio(i, from, to);
    from = to;
  }
  const long double t = standard_temperature(h) + shift;
  return {f * s.pressure * std::exp(log_p) * kMolar / (kGas * t),
          moist_air_sound_speed(s.temperature, s.pressure, s.humidity) *
              std::sqrt(t / static_cast<long double>(s.temperature))};
}

void expect_laws(const Station& s, double low, double high, double tolerance) {
  for (int i = 0; i <= 400; ++i) {
    const double z = low + (high - low) * i / 400;
    const auto air = must(air_at(s.environment(), z));
    const State law = by_law(s, z);
    EXPECT_NEAR(air.density / static_cast<double>(law.density), 1, tolerance) << s.temperature << ' ' << z;
    EXPECT_NEAR(air.sound_speed / static_cast<double>(law.sound), 1, tolerance) << s.temperature << ' ' << z;
    if (testing::Test::HasFailure()) return;
  }
}

TEST(LowAir, is_that_of_the_laws) {
  constexpr double kTop = 11019;
  for (const double humidity : {0.0, 0.5, 1.0}) {
    for (const double t : {268.0, 281.0, 288.15, 300.0, 320.0})
      expect_laws({.altitude = 200, .temperature = t, .pressure = 9.6e4, .humidity = humidity}, -5000, kTop, 1e-14);
    expect_laws({.altitude = 1500, .temperature = 240, .pressure = 8.4e4, .humidity = humidity}, -5000, kTop, 1e-13);
  }
  expect_laws({.temperature = 228}, -5000, kTop, 2e-13);
  expect_laws({.temperature = 200}, -5000, kTop, 4e-12);
  expect_laws({.temperature = 150}, -5000, kTop, 1e-8);
}

TEST(LowAir, goes_on_in_the_layers_above) {
  for (const Station& s : {Station{.altitude = 200, .temperature = 300, .pressure = 9.6e4, .humidity = 0.5},
                           Station{.altitude = 3000, .temperature = 250, .pressure = 7e4},
                           Station{.altitude = 15000, .temperature = 210, .pressure = 1.2e4}})
    expect_laws(s, 11020, 84000, 3e-13);
}

/// Any power, any slope: coefficients that a computer of fractions gave.
TEST(LowAir, series_of_a_power) {
  // ((1 - u / 4) / (1 + u / 8))^2 = 1 - 3/4 u + 15/64 u^2 - 3/64 u^3 + 33/4096 u^4 - ...
  double c[5];
  const LowLayer<double> layer{0.25, 0.125};
  const double square = 2, inverse_root = -0.5, one = 1, three = 3;
  put_powers(layer, power<5>(square, one, c));
  const double exact[] = {1, -3.0 / 4, 15.0 / 64, -3.0 / 64, 33.0 / 4096};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(c[i], exact[i], 1e-15) << i;
  // Drawn together it stays closer than what is cut off.
  double short_one[8], long_one[24];
  put_powers(layer, power<16>(inverse_root, three, short_one), power<24>(inverse_root, three, long_one));
  for (double u = -1; u <= 1; u += 0.125) {
    const double law = 3 / std::sqrt((1 - 0.25 * u) / (1 + 0.125 * u));
    EXPECT_NEAR(polynomial(u, long_one), law, 1e-14) << u;
    EXPECT_NEAR(polynomial(u, short_one), law, 2e-7) << u;  // c_8 is 9e-6
  }
}

/// Packs of several registers go through the series one register at a time.
TEST(LowAir, each_lane_of_a_pack_gets_its_own_polynomial) {
  constexpr int kMany = 16;
  using Many = Pack<double, kMany>;
  Many a(0.0), b(0.0), nu(0.0), scale(0.0), of[14], other[16];
  for (int lane = 0; lane < kMany; ++lane) {
    set_lane(a, lane, 0.1 + 0.01 * lane), set_lane(b, lane, 0.001 * lane);
    set_lane(nu, lane, 4 - 0.3 * lane), set_lane(scale, lane, 1 + 0.02 * lane);
  }
  put_powers(LowLayer<Many>{a, b}, power<16>(nu, scale, of), power<20>(scale, nu, other));
  for (int lane = 0; lane < kMany; ++lane) {
    double alone[14], other_alone[16];
    const double its_nu = nu[lane], its_scale = scale[lane];
    const LowLayer<double> layer{a[lane], b[lane]};
    put_powers(layer, power<16>(its_nu, its_scale, alone));
    put_powers(layer, power<20>(its_scale, its_nu, other_alone));
    for (int k = 0; k < 14; ++k) EXPECT_TRUE(test::same_bits(of[k][lane], alone[k])) << lane << ' ' << k;
    for (int k = 0; k < 16; ++k) EXPECT_TRUE(test::same_bits(other[k][lane], other_alone[k])) << lane << ' ' << k;
  }
}

}  // namespace physim::model_low_air_test
