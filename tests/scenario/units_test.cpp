// Quantities as people write them.
#include "scenario/units.hpp"
#include "must.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "physim/units.hpp"

namespace physim::scenario_units_test {

using namespace physim::units;

struct Written {
  const char* text;
  Quantity quantity;
  double si;
  friend std::ostream& operator<<(std::ostream& out, const Written& written) { return out << written.text; }
};

class QuantityTest : public testing::TestWithParam<Written> {};

TEST_P(QuantityTest, IsReadInSi) {
  const double value = must(parse_quantity(GetParam().text, GetParam().quantity));
  EXPECT_DOUBLE_EQ(value, GetParam().si) << GetParam().text;
}

constexpr double kPi = 3.14159265358979323846;

INSTANTIATE_TEST_SUITE_P(
    Units, QuantityTest,
    testing::Values(Written{"0.5", Quantity::number, 0.5}, Written{"60 %", Quantity::number, 0.6},
                    Written{"1 m", Quantity::length, 1}, Written{"7.82 mm", Quantity::length, 0.00782},
                    Written{"5 um", Quantity::length, 5e-6}, Written{"2 cm", Quantity::length, 0.02},
                    Written{"3 km", Quantity::length, 3000}, Written{"1 in", Quantity::length, 0.0254},
                    Written{"1 ft", Quantity::length, 0.3048}, Written{"100 yd", Quantity::length, 91.44},
                    Written{"1 mi", Quantity::length, 1609.344}, Written{"1 nmi", Quantity::length, 1852},
                    Written{"2 kg", Quantity::mass, 2}, Written{"5 g", Quantity::mass, 0.005},
                    Written{"5 mg", Quantity::mass, 5e-6}, Written{"168 gr", Quantity::mass, 168 * 64.79891e-6},
                    Written{"7000 gr", Quantity::mass, 0.45359237}, Written{"1 lb", Quantity::mass, 0.45359237},
                    Written{"16 oz", Quantity::mass, 0.45359237}, Written{"1 slug", Quantity::mass, 14.593902937206364},
                    Written{"2 t", Quantity::mass, 2000}, Written{"3 s", Quantity::time, 3},
                    Written{"20 ms", Quantity::time, 0.02}, Written{"5 us", Quantity::time, 5e-6},
                    Written{"2 min", Quantity::time, 120}, Written{"1 h", Quantity::time, 3600},
                    Written{"800 m/s", Quantity::speed, 800}, Written{"36 km/h", Quantity::speed, 10},
                    Written{"2600 ft/s", Quantity::speed, 792.48}, Written{"2600 fps", Quantity::speed, 792.48},
                    Written{"10 mph", Quantity::speed, 4.4704}, Written{"10 kn", Quantity::speed, 18520.0 / 3600},
                    Written{"1 km/s", Quantity::speed, 1000}, Written{"1 rad", Quantity::angle, 1},
                    Written{"180 deg", Quantity::angle, kPi}, Written{"180°", Quantity::angle, kPi},
                    Written{"5 mrad", Quantity::angle, 0.005}, Written{"5 mil", Quantity::angle, 0.005},
                    Written{"10 moa", Quantity::angle, kPi / 1080}, Written{"10 MOA", Quantity::angle, kPi / 1080},
                    Written{"9.8 m/s^2", Quantity::acceleration, 9.8},
                    Written{"10 ft/s^2", Quantity::acceleration, 3.048},
                    Written{"1 g0", Quantity::acceleration, 9.80665}, Written{"2 g", Quantity::acceleration, 19.6133},
                    Written{"2 N", Quantity::force, 2}, Written{"2 kN", Quantity::force, 2000},
                    Written{"1 lbf", Quantity::force, 4.4482216152605}, Written{"1 kgf", Quantity::force, 9.80665},
                    Written{"1 Pa", Quantity::pressure, 1}, Written{"990 hPa", Quantity::pressure, 99000},
                    Written{"99 kPa", Quantity::pressure, 99000}, Written{"1 MPa", Quantity::pressure, 1e6},
                    Written{"1 bar", Quantity::pressure, 1e5}));
INSTANTIATE_TEST_SUITE_P(
    MoreUnits, QuantityTest,
    testing::Values(
        Written{"990 mbar", Quantity::pressure, 99000}, Written{"1 atm", Quantity::pressure, 101325},
        Written{"30 inHg", Quantity::pressure, 101591.67}, Written{"760 mmHg", Quantity::pressure, 760 * 133.322387415},
        Written{"1 psi", Quantity::pressure, 6894.757293168361}, Written{"288.15 K", Quantity::temperature, 288.15},
        Written{"15 degC", Quantity::temperature, 288.15}, Written{"15 °C", Quantity::temperature, 288.15},
        Written{"59 degF", Quantity::temperature, 288.15}, Written{"518.67 degR", Quantity::temperature, 288.15},
        Written{"1.225 kg/m^3", Quantity::density, 1.225}, Written{"1 kg/m³", Quantity::density, 1},
        Written{"1 g/cm^3", Quantity::density, 1000}, Written{"1 lb/ft^3", Quantity::density, 16.018463373960138},
        Written{"150 kg/m^2", Quantity::ballistic_coefficient, 150},
        Written{"1 lb/in^2", Quantity::ballistic_coefficient, 703.0695796391593},
        Written{"1 lb/in2", Quantity::ballistic_coefficient, 703.0695796391593},
        Written{"1 lb/in²", Quantity::ballistic_coefficient, 703.0695796391593},
        Written{"1 kg/s", Quantity::linear_drag, 1}, Written{"1 N s/m", Quantity::linear_drag, 1},
        Written{"1 kg/m", Quantity::quadratic_drag, 1}, Written{"1 rad/s", Quantity::angular_rate, 1},
        Written{"360 deg/s", Quantity::angular_rate, 2 * kPi}, Written{"60 rpm", Quantity::angular_rate, 2 * kPi},
        Written{"3 J", Quantity::energy, 3}, Written{"3 kJ", Quantity::energy, 3000},
        Written{"1 ft lbf", Quantity::energy, 1.3558179483314004},
        // spellings
        Written{"  168   gr ", Quantity::mass, 168 * 64.79891e-6}, Written{"168gr", Quantity::mass, 168 * 64.79891e-6},
        Written{"-3.10 m", Quantity::length, -3.1}, Written{"+2 m", Quantity::length, 2},
        Written{".5 m", Quantity::length, 0.5}, Written{"1e3 m", Quantity::length, 1000},
        Written{"12", Quantity::mass, 12}));

TEST(Quantities, AgreeWithTheLiteralsOfTheApi) {
  EXPECT_EQ(*parse_quantity("168 gr", Quantity::mass), 168_gr);
  EXPECT_EQ(*parse_quantity("0.243 lb/in^2", Quantity::ballistic_coefficient), 0.243_lb_in2);
  EXPECT_EQ(*parse_quantity("2 deg", Quantity::angle), 2_deg);
  EXPECT_EQ(*parse_quantity("10 moa", Quantity::angle), 10_moa);
  EXPECT_EQ(*parse_quantity("100 km/h", Quantity::speed), 100_kmh);
  EXPECT_EQ(*parse_quantity("30 inHg", Quantity::pressure), 30_inHg);
  EXPECT_EQ(*parse_quantity("25 degC", Quantity::temperature), 25_degC);
  EXPECT_EQ(*parse_quantity("59 degF", Quantity::temperature), 59_degF);
  EXPECT_EQ(*parse_quantity("7.82 mm", Quantity::length), 7.82_mm);
}

TEST(Quantities, NinetyDegreesAreARightAngle) {
  EXPECT_EQ(*parse_quantity("90 deg", Quantity::angle), kPi / 2);
  EXPECT_EQ(*parse_quantity("360 deg", Quantity::angle), 2 * kPi);
}

struct Refused {
  const char* text;
  Quantity quantity;
  const char* message;
  const char* hint;
  friend std::ostream& operator<<(std::ostream& out, const Refused& refused) { return out << refused.text; }
};

class RefusedQuantityTest : public testing::TestWithParam<Refused> {};

TEST_P(RefusedQuantityTest, SaysWhy) {
  const Result<double> value = parse_quantity(GetParam().text, GetParam().quantity);
  ASSERT_FALSE(value.ok());
  EXPECT_EQ(value.error().message, GetParam().message);
  EXPECT_EQ(value.error().hint, GetParam().hint);
}

INSTANTIATE_TEST_SUITE_P(
    Units, RefusedQuantityTest,
    testing::Values(
        Refused{"168 ft", Quantity::mass, "\"168 ft\" is a length", "expected a mass such as \"168 gr\""},
        Refused{"15 g", Quantity::length, "\"15 g\" is a mass", "expected a length such as \"7.82 mm\""},
        Refused{"0.5 m", Quantity::number, "\"0.5 m\" is a length", "expected a plain number such as \"0.5\""},
        Refused{"15 %", Quantity::mass, "\"15 %\" is a plain number", "expected a mass such as \"168 gr\""},
        Refused{"5 Kg", Quantity::mass, "unknown unit \"Kg\" in \"5 Kg\"", "did you mean \"kg\"?"},
        Refused{"5 grains", Quantity::mass, "unknown unit \"grains\" in \"5 grains\"",
                "known units: kg, g, mg, gr, lb, oz, slug, t"},
        Refused{"1,5 kg", Quantity::mass, "\"1,5 kg\" has a comma", "write a decimal point"},
        Refused{"heavy", Quantity::mass, "\"heavy\" is not a number", "expected a mass such as \"168 gr\""},
        Refused{"", Quantity::time, "\"\" is not a number", "expected a time such as \"2.5 s\""},
        Refused{"gr", Quantity::mass, "\"gr\" is not a number", "expected a mass such as \"168 gr\""},
        Refused{"nan", Quantity::mass, "\"nan\" is not a number", "expected a mass such as \"168 gr\""},
        Refused{"+-1 m", Quantity::length, "\"+-1 m\" is not a number", "expected a length such as \"7.82 mm\""},
        Refused{"1e999 m", Quantity::length, "\"1e999 m\" is too large or too small for a double",
                "expected a length such as \"7.82 mm\""},
        Refused{"5 m s", Quantity::length, "unknown unit \"m s\" in \"5 m s\"",
                "known units: m, um, mm, cm, km, in, ft, yd, mi, nmi"}));

TEST(Quantities, HaveOneSiUnitEach) {
  for (int i = 0; i <= static_cast<int>(kLastQuantity); ++i) {
    const auto quantity = static_cast<Quantity>(i);
    EXPECT_EQ(quantity_of_si_unit(si_unit(quantity)), quantity) << si_unit(quantity);
  }
  EXPECT_EQ(quantity_of_si_unit("-"), Quantity::number);
  EXPECT_EQ(quantity_of_si_unit("ft"), Quantity::number) << "no SI unit";
}

TEST(Quantities, TextReadsBackBitForBit) {
  for (const double value : {0.1, -0.0, 1.0 / 3, 1e-300, 6356766.0, 1e22, 5e-324, 0.010886217, -2.5e9,
                             std::numeric_limits<double>::max(), std::nextafter(1.0, 2.0)}) {
    for (int q = 0; q <= static_cast<int>(kLastQuantity); ++q) {
      const auto quantity = static_cast<Quantity>(q);
      const double back = *parse_quantity(quantity_text(value, quantity), quantity);
      EXPECT_EQ(std::memcmp(&back, &value, sizeof back), 0) << quantity_text(value, quantity);
    }
  }
}

/// What was read from a short text is written as that text, in each unit.
TEST(Quantities, AreWrittenAsTheyAreTyped) {
  for (const QuantityInfo& quantity : all_quantities())
    for (const Unit& unit : quantity.units)
      for (const char* number : {"0", "2", "-1.5", "170", "0.218", "59", "0.015", "2700.125"}) {
        const std::string behind = unit.name.empty() ? "" : " " + std::string(unit.name);
        const double value = parse_quantity(number + behind, quantity.quantity).value();
        EXPECT_EQ(number_with(value, quantity.quantity, behind), number + behind);
      }
  EXPECT_EQ(number_with(0.5, Quantity::length, " kg"), std::nullopt);
  EXPECT_EQ(number_with(0.5, Quantity::mass, "g"), "500g");
}

/// Three times 0.3048 is not the number next to 0.9144.
TEST(Quantities, HaveNoTextInAUnitThatReadsAsOtherBits) {
  EXPECT_EQ(number_with(0.9144, Quantity::length, " ft"), std::nullopt);
  EXPECT_EQ(number_with(0.9144, Quantity::length, " yd"), "1 yd");
  const auto nearest = must(number_with(0.9144, Quantity::length, " ft", ReadsAs::nearest));
  EXPECT_NEAR(parse_quantity(nearest, Quantity::length).value(), 0.9144, 1e-15);
}

TEST(Quantities, TextIsReadable) {
  EXPECT_EQ(number_text(6356766), "6356766");
  EXPECT_EQ(number_text(0.001), "0.001");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(quantity_text(0.5, Quantity::length), "0.5 m");
  EXPECT_EQ(quantity_text(0.5, Quantity::number), "0.5");
}

// Every advertised unit is accepted by its quantity, and no spelling means two things within one.
TEST(Quantities, AdvertisedUnitsAreAccepted) {
  for (int q = 0; q <= static_cast<int>(kLastQuantity); ++q) {
    const auto quantity = static_cast<Quantity>(q);
    for (const std::string& unit : units_of(quantity)) EXPECT_TRUE(parse_quantity("1 " + unit, quantity).ok()) << unit;
    EXPECT_TRUE(parse_quantity(info(quantity).example, quantity).ok());
  }
}

}  // namespace physim::scenario_units_test
