// The ladder of presets over every shipped scenario: each rung is worth standing on.
#include "report/ladder.hpp"

#include "prepare/fidelity_cost.hpp"
#include "shipped.hpp"
#include "support.hpp"

namespace physim::report::report_ladder_test {

/// Rungs that another one beats on a shipped shot, and why that is right.
struct Beaten {
  const char* shot;
  const char* rung;
  const char* why;
};
constexpr Beaten kBeaten[] = {
    {"308_168gr_six_dof/168gr", "artillery",
     "cubic curves reject fewer steps than those of small_arms; both err by the yaw "
     "that a point does not have"},
    {"free_kick/straight", "constant_air",
     "game's constant drag coefficient errs against the Coriolis deflection of 1 mm"},
    {"free_kick/straight", "small_arms", "as constant_air"},
    {"reich_1831/ellipsoid", "artillery",
     "the standard's g at sea level, less at this height, is further from the weight "
     "at this latitude than the standard's g itself"},
    {"original_test_3/corrected", "simulation",
     "exact to rounding as artillery: the end of its force cuts its steps elsewhere, 16 are left of 17"},
    {"original_test_3/tsit5", "simulation", "as above"},
    {"reich_1831/ellipsoid", "simulation", "as artillery"},
    {"reich_1831/flat-coriolis", "artillery", "as above"},
    {"reich_1831/flat-coriolis", "simulation", "as above"},
};
bool may_be_beaten(const std::string& shot, const RungResult& result) {
  if (!result.holds()) return true;  // its model does not hold on this flight, which compare says
  const std::string rung = result.rung.name();
  if (rung == "classic" || rung == "motion velocity") return true;  // the original's, no rungs of the ladder
  return std::ranges::any_of(kBeaten, [&](const Beaten& known) { return known.shot == shot && known.rung == rung; });
}

class PresetsOfScenario : public ::testing::TestWithParam<std::string> {};

TEST_P(PresetsOfScenario, presets_cost_more_and_err_less_from_arcade_to_reference_and_none_is_beaten) {
  const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml"));
  for (const ScenarioShot& shot : scenario.shots) {
    const auto ladder = climb_presets(scenario, shot);
    if (!ladder) continue;  // its reference has no end that can be compared: cli/every_scenario_test.cpp lists those
    const std::string name = GetParam() + "/" + shot.projectile.name;
    const RungResult* before = nullptr;
    for (const RungResult& result : ladder->rungs) {
      if (may_be_beaten(name, result)) continue;
      EXPECT_EQ(result.beaten_by, "") << name << ": " << result.rung.name() << " errs " << result.largest << " m by "
                                      << result.work << " operations";
      if (before != nullptr) {
        EXPECT_GE(result.work, before->work) << name << ": " << result.rung.name();
        EXPECT_LE(result.resolved, 1.01 * before->resolved) << name << ": " << result.rung.name();
      }
      before = &result;
    }
  }
}

/// The last row is flown as the reference of a comparison. Who flies the preset has the same: it costs more than
/// simulation, which by its own error it would beat.
TEST_P(PresetsOfScenario, the_preset_reference_is_the_dearest) {
  const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml"));
  for (const ScenarioShot& shot : scenario.shots) {
    const auto ladder = climb_presets(scenario, shot);
    if (!ladder) continue;
    const FlightSetting own = preset_setting(scenario, shot, "reference");
    const Flight& truth = ladder->rungs.back().flight;
    const Flight flown =
        fly(shot.projectile, shot.launch, scenario.environment, own.fidelity, own.tolerance, scenario.until);
    const std::string name = GetParam() + "/" + shot.projectile.name;
    if (shot.launch.sight.zero_range == 0 && own.fidelity == ladder->rungs.back().rung.setting.fidelity) {
      EXPECT_EQ(flown.cost().evaluations, truth.cost().evaluations) << name;
      EXPECT_EQ(flown.end().position, truth.end().position) << name;
    }
    const double steps = static_cast<double>(std::max<std::int64_t>(flown.cost().steps + flown.cost().rejected, 1));
    const double work = steps * step_cost(flown.fidelity_in_use().fidelity, shot.projectile, scenario.environment);
    for (const RungResult& result : ladder->rungs)
      if (result.rung.name() == "simulation") {
        EXPECT_GE(work, result.work) << name;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Ladder, PresetsOfScenario, ::testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& scenario) { return scenario.param; });

TEST(LadderOfSteps, a_rung_is_beaten_by_one_that_costs_no_more_and_errs_less) {
  const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/golf_ball_no_spin.toml"));
  const auto ladder = must(climb(scenario, scenario.shots.front()));
  ASSERT_GE(ladder.steps.size(), 6U);
  for (const StepsOfRung& rung : ladder.steps) {
    const auto better = [&](const StepsOfRung& other) {
      return other.cost <= rung.cost && std::max(other.largest, 1e-6) < 0.99 * std::max(rung.largest, 1e-6);
    };
    EXPECT_EQ(std::ranges::any_of(ladder.steps, better), !rung.beaten_by.empty()) << rung.name;
    if (rung.beaten_by.empty()) continue;
    const auto winner = std::ranges::find(ladder.steps, rung.beaten_by, &StepsOfRung::name);
    ASSERT_NE(winner, ladder.steps.end()) << rung.beaten_by;
    EXPECT_TRUE(better(*winner)) << rung.name << " by " << winner->name;
  }
}

TEST(LadderOfPresets, flies_spin_as_far_as_the_data_go) {
  struct Case {
    const char* scenario;
    RotationModel of_game, of_artillery, of_simulation;
  };
  using enum RotationModel;
  const Case cases[] = {{"golf_drive", magnus, magnus, magnus},
                        {"curve_ball", magnus, magnus, magnus},
                        {"free_kick", magnus, magnus, magnus},
                        {"105mm_m1_six_dof", none, modified_point_mass, rigid_body},
                        {"308_168gr_six_dof", none, modified_point_mass, rigid_body},
                        {"308_168gr_g7", none, spin_drift, spin_drift},
                        {"model_rocket", none, none, none}};
  for (const Case& each : cases) {
    const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + std::string(each.scenario) + ".toml"));
    const auto ladder = must(climb_presets(scenario, scenario.shots.front()));
    const double way = length(ladder.rungs.back().flight.end().position - scenario.shots.front().launch.position);
    for (const RungResult& result : ladder.rungs) {
      const std::string rung = result.rung.name();
      const RotationModel granted = result.flight.fidelity_in_use().fidelity.rotation;
      if (rung == "game") {
        EXPECT_EQ(granted, each.of_game) << each.scenario;
      }
      if (rung == "artillery") {
        EXPECT_EQ(granted, each.of_artillery) << each.scenario;
      }
      if (rung != "simulation") continue;
      EXPECT_EQ(granted, each.of_simulation) << each.scenario;
      EXPECT_LE(result.error, 0.01 * way) << each.scenario;
    }
  }
}

TEST(LadderOfPresets, a_step_of_the_scenario_binds_its_own_rung_alone) {
  auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/105mm_m1_six_dof.toml"));
  ASSERT_GT(scenario.tolerance.step, 0);
  for (const std::string_view preset : fidelity_presets()) {
    const Tolerance tolerance = preset_setting(scenario, scenario.shots.front(), preset).tolerance;
    EXPECT_EQ(tolerance.step, 0) << preset;
    EXPECT_EQ(tolerance.max_step, kInfinity) << preset;
    EXPECT_FALSE(tolerance.relative) << preset;
    EXPECT_EQ(tolerance.max_steps, scenario.tolerance.max_steps) << preset;
  }
}

TEST(LadderOfPresets, drag_that_a_shot_says_by_a_factor_is_kept_on_every_rung) {
  const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/original_test_1.toml"));
  const auto ladder = must(climb_presets(scenario, scenario.shots.front()));
  std::vector<std::string> names;
  for (const RungResult& result : ladder.rungs) {
    names.push_back(result.rung.name());
    const DragModel drag = result.flight.fidelity_in_use().fidelity.drag;
    EXPECT_EQ(drag, names.back() == "arcade" ? DragModel::off : DragModel::damping) << names.back();
    if (names.back() == "arcade") {
      EXPECT_NE(result.leaves_out.find("drag off"), std::string::npos);
    }
  }
  for (const char* original : {"classic", "motion velocity"})
    EXPECT_NE(std::ranges::find(names, original), names.end()) << original;
}

}  // namespace physim::report::report_ladder_test
