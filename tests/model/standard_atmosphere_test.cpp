// The standard atmosphere, and its shift to a station.
#include "model/standard_atmosphere.hpp"

#include "support.hpp"

namespace physim::model_standard_atmosphere_test {

using test::near;

// U.S. Standard Atmosphere 1976 from its defining equations to 40 digits
// (the exact figures of us76_exact.csv): geometric altitude, molecular temperature, pressure, density, sound
// speed, viscosity.
constexpr double kExact[][6] = {
    {-4000, 314.1663708217806228, 159598.14239931133859, 1.7697256191981742029, 355.32434567529594128,
     0.000019122799665686042258},
    {-2000, 301.15409141737083631, 127782.83336558689068, 1.4781603437626644178, 347.88804225103568796,
     0.000018514575204715217617},
    {0, 288.15, 101325.0, 1.2249991558877121338, 340.29410778693532873, 0.000017893802780775829122},
    {2000, 275.15408884365299808, 79501.424641667012068, 1.0065532169786470874, 332.53173846181086152,
     0.000017259816220014495065},
    {10000, 223.25209264797858128, 26499.898139253344954, 0.41351042889884680044, 299.53176567728741341,
     0.000014576624910815677786},
    {12000, 216.65, 19399.448482237202986, 0.31193814907224263364, 295.06959735390426329, 0.000014216130796413357928},
    {18000, 216.65, 7565.2344913607924666, 0.12164702757881833678, 295.06959735390426329, 0.000014216130796413357928},
    {20000, 216.65, 5529.311892299156287, 0.088909915088886521387, 295.06959735390426329, 0.000014216130796413357928},
    {22000, 218.57412325518760212, 4047.5000239713518389, 0.064509832748363521059, 296.37699467157282198,
     0.000014321677942801189655},
    {30000, 226.50908361133005343, 1197.0316403859617419, 0.018410170384692276334, 301.70876622345067412,
     0.000014752758669594570483},
    {34000, 233.7435192432331273, 663.41304748983828253, 0.009887402890430184119, 306.48901020722936391,
     0.000015140049538777841988},
    {46000, 266.92464992473565331, 131.34065318870053448, 0.0017141478998685352409, 327.52123148335853041,
     0.000016850987984103474498},
    {48000, 270.65, 102.29563402712469716, 0.0013167000982066956623, 329.79884707098852297, 0.000017036783525427037497},
    {52000, 269.03138187601170022, 62.214746843655604844, 0.00080561621124194716612, 328.811189746344578,
     0.000016956206230292849855},
    {60000, 247.02088477279676398, 21.958666139698349367, 0.00030967780764751608605, 315.0735554871931905,
     0.000015837189300043244703},
    {70000, 219.58482177505762618, 5.2208964300662254659, 0.000082828645911789607458, 297.06143595494259512,
     0.00001437695905198139937},
    {72000, 214.26275118739739477, 3.8362489080812887289, 0.00006237318219173094706, 293.43942021316356618,
     0.000014084618077799779376},
    {80000, 198.63857625086883693, 1.05247354505453968, 0.000018458032036858087632, 282.53803099019042074,
     0.000013208096103893720698},
    {86000, 186.9459083101885122, 0.37338046183105787657, 6.9578237813324772381e-6, 274.09625353495053743,
     0.000012528819632922058207},
};

TEST(StandardAtmosphere, has_the_exact_values) {
  for (const auto& [z, t, p, rho, a, mu] : kExact) {
    const auto air = must(air_at({}, z), z);
    EXPECT_TRUE(near(air.temperature, t, 1e-10)) << z;
    EXPECT_TRUE(near(air.pressure, p, 1e-10)) << z;
    EXPECT_TRUE(near(air.density, rho, 1e-10)) << z;
    EXPECT_TRUE(near(air.sound_speed, a, 1e-10)) << z;
    // Above 80 km the standard's viscosity reads the kinetic temperature, which lies 0.04 % below the molecular one.
    EXPECT_TRUE(near(air.viscosity, mu, z > 80000 ? 5e-4 : 1e-10)) << z;
  }
}

TEST(StandardAtmosphere, is_refused_outside_its_range) {
  for (const double z : {-5001.0, 86001.0, test::kNan, test::kInfinity}) {
    const auto air = air_at({}, z);
    ASSERT_FALSE(air) << z;
    EXPECT_EQ(air.error().place, "altitude");
  }
}

/// Environments with station data of every kind; the standard itself first.
std::vector<Environment> stations() {
  std::vector<Environment> list(5);
  list[1].atmosphere.temperature = 310;
  list[2].atmosphere.pressure = 85000;
  list[2].altitude = 1600;
  list[3].atmosphere.temperature = 263.15;
  list[3].atmosphere.pressure = 97000;
  list[3].atmosphere.humidity = 0.9;
  list[3].altitude = 300;
  list[4].atmosphere.temperature = 281;
  list[4].atmosphere.pressure = 70000;
  list[4].atmosphere.humidity = 0.4;
  list[4].atmosphere.station_altitude = 2900;
  list[4].altitude = 120;
  return list;
}

// Z of the layers' bases (the exact figures of us76_layers.csv).
constexpr double kBases[] = {11019.067832000108419, 20063.123681701359968, 32161.903222980897633,
                             47350.092222120439966, 51412.479625790110194, 71801.97067469581273};

TEST(StandardAtmosphere, is_continuous_across_layers) {
  for (const Environment& environment : stations())
    for (const double z : kBases) {
      const auto below = air_at(environment, z - 1e-6);
      const auto above = air_at(environment, z + 1e-6);
      EXPECT_TRUE(near(above->density, below->density, 1e-9)) << z;
      EXPECT_TRUE(near(above->temperature, below->temperature, 1e-9)) << z;
      EXPECT_TRUE(near(above->sound_speed, below->sound_speed, 1e-9)) << z;
    }
}

TEST(StandardAtmosphere, is_in_hydrostatic_equilibrium) {
  // dp/dZ = -rho g(Z) with the standard's gravity, by a central difference of order 4.
  for (const Environment& environment : stations())
    for (const double z : {0.0, 2500.0, 9000.0, 15000.0, 25000.0, 40000.0, 49000.0, 60000.0, 80000.0}) {
      const double h = 50;
      const auto p = [&](double at) { return air_at(environment, at)->pressure; };
      const double slope = (8 * (p(z + h) - p(z - h)) - (p(z + 2 * h) - p(z - 2 * h))) / (12 * h);
      const double ratio = 6356766 / (6356766 + z);
      EXPECT_TRUE(near(slope, -air_at(environment, z)->density * 9.80665 * ratio * ratio, 1e-8)) << z;
    }
}

TEST(StandardAtmosphere, goes_through_the_station) {
  for (const Environment& e : stations()) {
    const Atmosphere& a = e.atmosphere;
    const double z = a.station_altitude.value_or(e.altitude);
    const auto air = air_at(e, z);
    const auto standard = air_at({}, z);
    EXPECT_TRUE(near(air->temperature, a.temperature.value_or(standard->temperature), 1e-13));
    EXPECT_TRUE(near(air->pressure, a.pressure.value_or(standard->pressure), 1e-13));
    if (!a.temperature && !a.pressure && !a.humidity) continue;
    EXPECT_TRUE(near(air->density, moist_air_density(air->temperature, air->pressure, a.humidity.value_or(0)), 1e-13));
    EXPECT_TRUE(
        near(air->sound_speed, moist_air_sound_speed(air->temperature, air->pressure, a.humidity.value_or(0)), 1e-13));
  }
}

TEST(StandardAtmosphere, keeps_the_standard_lapse_rate_when_shifted) {
  Environment warm{.atmosphere = {.temperature = 308.15}};
  for (const double z : {0.0, 5000.0, 15000.0, 40000.0})
    EXPECT_NEAR(air_at(warm, z)->temperature - air_at({}, z)->temperature, 20, 1e-10) << z;
}

TEST(StandardAtmosphere, station_readings_of_the_standard_change_little) {
  // CIPM-2007's real air against the standard's ideal gas: compressibility and composition, 5e-4 at most.
  Environment same{.atmosphere = {.temperature = 288.15, .pressure = 101325}};
  for (const double z : {0.0, 3000.0}) EXPECT_TRUE(near(air_at(same, z)->density, air_at({}, z)->density, 6e-4)) << z;
}

TEST(StandardAtmosphere, constant_air_is_that_of_the_origin) {
  Environment e = stations()[3];
  const auto origin = air_at(e, e.altitude);
  e.atmosphere.model = AirModel::constant;
  for (const double z : {-1000.0, 300.0, 20000.0}) {
    EXPECT_TRUE(near(air_at(e, z)->density, origin->density, 1e-14));
    EXPECT_TRUE(near(air_at(e, z)->sound_speed, origin->sound_speed, 1e-14));
  }
  e.atmosphere.density = 0.9;
  e.atmosphere.sound_speed = 333;
  EXPECT_DOUBLE_EQ(air_at(e, 5000)->density, 0.9);
  EXPECT_DOUBLE_EQ(air_at(e, 5000)->sound_speed, 333);
}

TEST(StandardAtmosphere, exponential_air_falls_by_e_per_scale_height) {
  Environment e{.altitude = 500, .atmosphere = {.model = AirModel::exponential, .density = 1.2, .scale_height = 7000}};
  EXPECT_TRUE(near(air_at(e, 500)->density, 1.2, 1e-15));
  EXPECT_TRUE(near(air_at(e, 7500)->density, 1.2 / 2.718281828459045, 1e-15));
  EXPECT_TRUE(near(air_at(e, 21500)->density, 1.2 / 20.085536923187668, 1e-15));
}

/// Density as a flight feels it, at any altitude: the drag of a body with Cd A / 2m = 1 at 1 m/s.
double felt_density(double z) {
  ProjectileDef p{.drag = {.coefficient = 1, .ballistic_coefficient = 3.14159265358979323846 / 8}};
  Fidelity f{.gravity = GravityModel::off};
  const test::Prepared prepared(p, {}, {}, f);
  return -prepared.acceleration(0, {{0, z, 0}, {1, 0, 0}}).x;
}

TEST(StandardAtmosphere, is_what_flights_feel) {
  for (const auto& [z, t, p, rho, a, mu] : kExact) EXPECT_TRUE(near(felt_density(z), rho, 1e-10)) << z;
}

TEST(StandardAtmosphere, of_one_number_is_that_of_all_to_the_bit) {
  Environment warm{.altitude = 1500, .atmosphere = {.temperature = 310}};
  for (const Environment& environment : {Environment{}, warm}) {
    const Air<double> air = prepare_conditions(environment, Fidelity::small_arms()).air;
    const LowAirOfOne of_one(air);
    for (double z = -5000; z < air.low_top; z += 0.37) {
      const AirState<double> one = of_one(z), all = low_air(air, air.common, z);
      ASSERT_TRUE(test::same_bits(one.density, all.density)) << z;
      ASSERT_TRUE(test::same_bits(one.per_sound_speed, all.per_sound_speed)) << z;
    }
  }
}

TEST(StandardAtmosphere, air_at_refuses_an_environment_as_flights_do) {
  const auto air = air_at({.atmosphere = {.pressure = -1}}, 0);
  ASSERT_FALSE(air);
  EXPECT_EQ(air.error().place, "environment.atmosphere.pressure");
}

TEST(StandardAtmosphere, goes_on_above_its_top) {
  double last = felt_density(86000);
  for (const double z : {90e3, 120e3, 200e3, 1000e3, 1e9}) {
    const double density = felt_density(z);
    EXPECT_LT(density, last) << z;
    EXPECT_GE(density, 0) << z;
    last = density;
  }
}

}  // namespace physim::model_standard_atmosphere_test
