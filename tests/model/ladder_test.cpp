// The table of rungs: complete, in order, and true to the tableaus.
#include "model/ladder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "physim/names.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim::model_ladder_test {

template <class Enum>
concept Ordered = requires(Enum a, Enum b) {
  a < b;
}
|| requires(Enum a, Enum b) { a >= b; };

TEST(Ladder, enumerators_cannot_be_compared_by_their_values) {
  for_each_effect([]<class Enum>(const char*, Enum Fidelity::*) { static_assert(!Ordered<Enum>); });
  static_assert(!Ordered<EventKind> && !Ordered<Outcome>);
  static_assert(Ordered<int>);
}

TEST(Ladder, every_rung_has_a_name_a_text_and_a_place) {
  for_each_effect([]<class Enum>(const char* place, Enum Fidelity::*) {
    SCOPED_TRACE(place);
    const auto rungs = rungs_of<Enum>();
    ASSERT_EQ(rungs.size(), names_of<Enum>().size());
    std::set<std::string_view> names, docs;
    for (std::size_t i = 0; i < rungs.size(); ++i) {
      EXPECT_FALSE(rungs[i].doc.empty()) << rungs[i].name;
      EXPECT_TRUE(i == 0 || rungs[i - 1].level < rungs[i].level) << rungs[i].name;
      EXPECT_EQ(level(*value_of<Enum>(rungs[i].name)), rungs[i].level);
      names.insert(rungs[i].name), docs.insert(rungs[i].doc);
    }
    EXPECT_EQ(names.size(), rungs.size());
    EXPECT_EQ(docs.size(), rungs.size());
  });
}

TEST(Ladder, columns_say_what_the_rows_say) {
  for (const EarthModel rung : all_rungs<EarthModel>()) {
    EXPECT_EQ(column<&EarthRow::shape>(rung), row(rung).shape) << row(rung).name;
    EXPECT_EQ(column<&EarthRow::turning>(rung), row(rung).turning) << row(rung).name;
  }
  for (const GravityModel rung : all_rungs<GravityModel>())
    EXPECT_EQ(column<&GravityRow::field>(rung), row(rung).field) << row(rung).name;
  static_assert(column<&EarthRow::shape>(EarthModel::ellipsoid) == EarthShape::ellipsoid);
  static_assert(!column<&EarthRow::turning>(EarthModel::sphere) && column<&EarthRow::turning>(EarthModel::ellipsoid));
}

TEST(Ladder, all_effects_are_the_fields_of_a_fidelity) {
  std::vector<std::string_view> effects;
  for (const EffectRungs& of : all_effects()) effects.push_back(of.effect);
  EXPECT_EQ(effects, (std::vector<std::string_view>{"motion", "integrator", "gravity", "drag", "air", "wind", "earth",
                                                    "rotation", "body_form", "precision", "interpolation"}));
  EXPECT_EQ(all_effects()[2].rungs.back().name, "wgs84");
}

TEST(Ladder, the_lower_of_two_is_the_cheaper_one) {
  EXPECT_EQ(lower_of(GravityModel::wgs84, GravityModel::constant), GravityModel::constant);
  EXPECT_EQ(lower_of(GravityModel::off, GravityModel::j2), GravityModel::off);
  EXPECT_EQ(higher_of(RotationModel::spin_drift, RotationModel::rigid_body), RotationModel::rigid_body);
  EXPECT_EQ(rungs_between(WindModel::off, WindModel::profile),
            (std::vector{WindModel::off, WindModel::constant, WindModel::profile}));
  EXPECT_EQ(rungs_between(GravityModel::constant, GravityModel::off), std::vector{GravityModel::off});
}

TEST(Ladder, texts_of_integrators_say_what_their_tableaus_are) {
  for (const Integrator integrator : all_rungs<Integrator>()) {
    const std::string doc(row(integrator).doc);
    if (level(integrator) < 0) continue;  // granted as one of the others
    EXPECT_EQ(doc.find("adaptive") != std::string::npos, is_adaptive(integrator)) << doc;
    if (integrator == Integrator::classic) continue;
    EXPECT_NE(doc.find("order " + std::to_string(order_of(integrator))), std::string::npos) << doc;
  }
}

TEST(Ladder, the_truest_integrator_has_the_highest_order) {
  for (const Integrator integrator : all_rungs<Integrator>())
    if (level(integrator) >= 0) {
      EXPECT_LE(order_of(integrator), order_of(all_rungs<Integrator>().back()));
    }
}

}  // namespace physim::model_ladder_test
