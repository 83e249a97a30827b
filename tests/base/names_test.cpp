// Names of enumerators and presets of fidelity.
#include "physim/names.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace physim::base_names_test {

template <class Enum>
class NamesTest : public testing::Test {};

using NamedEnums =
    testing::Types<Motion, Integrator, GravityModel, DragModel, AirModel, WindModel, EarthModel, RotationModel,
                   Interpolation, Precision, DragTable, WindAxis, WindInterpolation, EventKind, Crossing, Outcome>;
TYPED_TEST_SUITE(NamesTest, NamedEnums);

TYPED_TEST(NamesTest, RoundTrip) {
  const auto names = names_of<TypeParam>();
  ASSERT_FALSE(names.empty());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = static_cast<TypeParam>(i);
    EXPECT_EQ(name(value), names[i]);
    EXPECT_EQ(value_of<TypeParam>(names[i]), value);
  }
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(value_of<TypeParam>("no such name"), std::nullopt);
  EXPECT_EQ(value_of<TypeParam>(""), std::nullopt);
}

// One in the middle and the last of each list: a name out of place would show.
TEST(Names, AreSpelledAsTheEnumerators) {
  EXPECT_EQ(name(Motion::velocity), "velocity");
  EXPECT_EQ(name(Motion::force), "force");
  EXPECT_EQ(name(Integrator::semi_implicit_euler), "semi_implicit_euler");
  EXPECT_EQ(name(Integrator::rk4), "rk4");
  EXPECT_EQ(name(Integrator::dop853), "dop853");
  EXPECT_EQ(name(GravityModel::inverse_square), "inverse_square");
  EXPECT_EQ(name(DragModel::linear_quadratic), "linear_quadratic");
  EXPECT_EQ(name(DragModel::equation), "equation");
  EXPECT_EQ(name(AirModel::exponential), "exponential");
  EXPECT_EQ(name(AirModel::isa), "isa");
  EXPECT_EQ(name(WindModel::profile), "profile");
  EXPECT_EQ(name(EarthModel::flat_coriolis), "flat_coriolis");
  EXPECT_EQ(name(EarthModel::sphere), "sphere");
  EXPECT_EQ(name(RotationModel::spin_drift), "spin_drift");
  EXPECT_EQ(name(Interpolation::pchip), "pchip");
  EXPECT_EQ(name(Interpolation::cubic), "cubic");
  EXPECT_EQ(name(Precision::float64), "float64");
  EXPECT_EQ(name(DragTable::g7), "g7");
  EXPECT_EQ(name(DragTable::ra4), "ra4");
  EXPECT_EQ(name(DragTable::custom), "custom");
  EXPECT_EQ(name(WindAxis::range), "range");
  EXPECT_EQ(name(WindInterpolation::step), "step");
  EXPECT_EQ(name(EventKind::mach), "mach");
  EXPECT_EQ(name(EventKind::time), "time");
  EXPECT_EQ(name(Crossing::falling), "falling");
  EXPECT_EQ(name(Outcome::time_limit), "time_limit");
  EXPECT_EQ(name(Outcome::refused), "refused");
}

TEST(FidelityPresets, AreFoundByName) {
  ASSERT_EQ(fidelity_presets().size(), 8U);
  const std::tuple<std::string_view, Fidelity> presets[] = {{"arcade", Fidelity::arcade()},
                                                            {"game", Fidelity::game()},
                                                            {"constant_air", Fidelity::constant_air()},
                                                            {"small_arms", Fidelity::small_arms()},
                                                            {"artillery", Fidelity::artillery()},
                                                            {"simulation", Fidelity::simulation()},
                                                            {"reference", Fidelity::reference()},
                                                            {"classic", Fidelity::classic()}};
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& [name, fidelity] = presets[i];
    EXPECT_EQ(fidelity_presets()[i], name);
    EXPECT_EQ(fidelity_preset(name), fidelity) << name;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(std::get<1>(presets[j]) == fidelity) << "two presets are equal";
  }
  EXPECT_EQ(fidelity_preset("Arcade"), std::nullopt);
}

TEST(FidelityPresets, SayWhatTheyPromise) {
  EXPECT_EQ(Fidelity::arcade().motion, Motion::closed_form);
  EXPECT_EQ(Fidelity::arcade().drag, DragModel::off);
  EXPECT_EQ(Fidelity::arcade().air, AirModel::vacuum);
  EXPECT_EQ(Fidelity::game().integrator, Integrator::automatic);
  EXPECT_EQ(Fidelity::game().drag, DragModel::linear_quadratic);
  EXPECT_EQ(Fidelity::game().precision, Precision::float32);
  EXPECT_EQ(Fidelity::constant_air().air, AirModel::constant);
  EXPECT_EQ(Fidelity::constant_air().precision, Precision::float64);
  EXPECT_EQ(Fidelity::small_arms().rotation, RotationModel::automatic_point);
  EXPECT_EQ(Fidelity::small_arms().gravity, GravityModel::constant);
  EXPECT_EQ(Fidelity::small_arms().interpolation, Interpolation::pchip) << "range cards of others are made so";
  EXPECT_EQ(Fidelity::artillery().earth, EarthModel::flat_coriolis);
  EXPECT_EQ(Fidelity::artillery().gravity, GravityModel::inverse_square);
  EXPECT_EQ(Fidelity::simulation().interpolation, Interpolation::cubic);
  EXPECT_EQ(Fidelity::simulation().rotation, RotationModel::automatic);
  for (const Fidelity& preset :
       {Fidelity::constant_air(), Fidelity::small_arms(), Fidelity::artillery(), Fidelity::simulation()})
    EXPECT_EQ(preset.integrator, Integrator::adaptive);
  double before = 1;  // each is at least as exact as the one before
  for (const std::string_view name : {"game", "constant_air", "small_arms", "artillery", "simulation", "reference"}) {
    const double tolerance = fidelity_preset(name)->tolerance;
    EXPECT_LE(tolerance, before) << name;
    before = tolerance;
  }
  Fidelity reference = Fidelity::reference();
  EXPECT_EQ(reference.integrator, Integrator::dop853);
  reference.integrator = Fidelity::simulation().integrator;
  reference.tolerance = Fidelity::simulation().tolerance;
  EXPECT_EQ(reference, Fidelity::simulation());
  EXPECT_EQ(Fidelity::classic().motion, Motion::velocity);
  EXPECT_EQ(Fidelity::classic().integrator, Integrator::classic);
  EXPECT_EQ(Fidelity::classic().drag, DragModel::damping);
}

}  // namespace physim::base_names_test
