// What studies refuse, and with which words.
#include "base/archive.hpp"
#include "study_support.hpp"

namespace physim::study_bad_studies_test {

using namespace test;

Study throw_of(const Distribution& speed = NormalDistribution{30, 1}) {
  Study study;
  study.environment.gravity.model = GravityModel::constant;
  study.fidelity = vacuum();
  study.fidelity.motion = Motion::closed_form;
  study.launch = {.position = {0, 1, 0}, .speed = 30, .elevation = 0.5};
  study.inputs = {input("shot.speed", speed)};
  study.shard_shots = 64;
  study.shots = 64;
  return study;
}

std::string refusal(const Study& study) {
  const auto plan = plan_study(study);
  return plan ? "" : plan.error().text();
}

void expect_refusal(const Study& study, const char* words) {
  const std::string said = refusal(study);
  EXPECT_NE(said.find(words), std::string::npos) << '"' << said << "\" says nothing of \"" << words << '"';
}

TEST(BadStudies, inputs) {
  Study study = throw_of();
  EXPECT_EQ(refusal(study), "");
  study.inputs.clear();
  expect_refusal(study, "nothing is uncertain");
  study = throw_of();
  study.inputs[0].path = "shot.sped";
  expect_refusal(study, "\"shot.sped\"");
  expect_refusal(study, "shot.speed, shot.elevation");
  expect_refusal(throw_of(NormalDistribution{30, 0}), "inputs[0].distribution.deviation");
  study = throw_of();
  study.inputs.push_back(study.inputs[0]);
  expect_refusal(study, "drawn by inputs[0] already");
  study.inputs[1].added = true;
  EXPECT_EQ(refusal(study), "");
  study.inputs[0].path = "environment.wind.velocity.x";
  study.environment.wind.profile = {{0, {1, 0, 0}}};
  expect_refusal(study, "profile");
  study = throw_of();
  study.launch.velocity = Vec3d{1, 2, 3};
  expect_refusal(study, "launch.velocity");
  study = throw_of();
  study.inputs.assign(33, study.inputs[0]);
  for (StudyInput& more : study.inputs) more.added = true;
  study.sampling = Sampling::sobol;
  EXPECT_EQ(refusal(study), "");
  study.indices = true;
  expect_refusal(study, "each input takes two");
}

/// Densities are drawn where the air has one of its own, about the one that it has.
TEST(BadStudies, densities) {
  Study study = throw_of();
  study.fidelity = Fidelity::small_arms();
  study.fidelity.rotation = RotationModel::none;
  const char* path = "environment.atmosphere.density";
  study.inputs = {{.path = path, .distribution = NormalDistribution{0, 0.01}, .added = true}};
  expect_refusal(study, "constant and exponential air");
  study.environment.atmosphere.model = AirModel::constant;
  const auto plan = must(plan_study(study));
  EXPECT_TRUE(plan.notes().empty()) << plan.notes()[0];
  study.environment.atmosphere.density = 1.225 + draws_of(plan, 5)[0];
  const Flight flight = fly(study.projectile, study.launch, study.environment, study.fidelity);
  EXPECT_NEAR(fly_shot_of(plan, 5)[2], flight.end().time, 1e-5);
}

/// How many shots the pilot refuses is told, in whatever way a number comes to be impossible.
TEST(BadStudies, what_is_refused_is_told_before) {
  Study study = throw_of();
  study.projectile.mass = 0.008;
  study.fidelity.drag = DragModel::equation;
  study.inputs = {{.path = "shot.mass", .distribution = NormalDistribution{0, 0.008}, .added = true}};
  const auto plan = must(plan_study(study));
  ASSERT_EQ(plan.notes().size(), 1U);
  EXPECT_NE(plan.notes()[0].find("about 16 %"), std::string::npos) << plan.notes()[0];
}

TEST(BadStudies, correlations) {
  Study study = throw_of();
  study.inputs.push_back(input("shot.elevation", NormalDistribution{0.5, 0.01}));
  study.inputs.push_back(input("shot.azimuth", NormalDistribution{0, 0.01}));
  study.correlated = {{{0, 1, 2}, {1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1}}};
  expect_refusal(study, "shot.azimuth with shot.speed = 0.9");
  study.correlated = {{{0, 1}, {1, 0, 0, 1}}, {{1, 2}, {1, 0, 0, 1}}};
  expect_refusal(study, "shot.elevation is correlated twice");
  study.correlated = {{{0, 7}, {1, 0, 0, 1}}};
  expect_refusal(study, "no input 7");
  study.correlated = {{{}, {}}};
  expect_refusal(study, "names no inputs");
  study.correlated = {{{0, 1}, {1, 0, 0, 1}}};
  study.inputs[1].drawn_for = DrawnFor::occasion;
  study.rounds = 4;
  expect_refusal(study, "more or less often");
}

TEST(BadStudies, sizes_and_figures) {
  const auto with = [](auto change) {
    Study study = throw_of();
    change(study);
    return study;
  };
  expect_refusal(with([](Study& s) { s.shots = 0; }), "shots");
  expect_refusal(with([](Study& s) { s.shots = ~std::uint64_t{0}; }), "2^50");
  expect_refusal(with([](Study& s) { s.shard_shots = 8; }), "shard_shots");
  expect_refusal(with([](Study& s) { s.rounds = 0; }), "rounds");
  expect_refusal(with([](Study& s) { s.rounds = 5; }), "5 do not divide the 64");
  expect_refusal(with([](Study& s) { s.rounds = 4, s.sampling = Sampling::sobol; }), "no occasions");
  expect_refusal(with([](Study& s) { s.inputs[0].drawn_for = DrawnFor::occasion; }), "how many shots an occasion has");
  expect_refusal(with([](Study& s) { s.shard_shots = 48, s.sampling = Sampling::sobol; }), "power of two");
  expect_refusal(with([](Study& s) { s.group_sizes = {1}; }), "group_sizes");
  expect_refusal(with([](Study& s) { s.aim.up = kNan; }), "aim.up");
  expect_refusal(with([](Study& s) { s.targets = {{"a", CircleTarget{{}, 0}}}; }), "targets[0].radius");
  expect_refusal(with([](Study& s) { s.targets = {{"a", PolygonTarget{{{0, 0}, {1, 1}}}}}; }), "three or more");
  expect_refusal(with([](Study& s) { s.quantities = {StudyQuantity::x, StudyQuantity::x}; }), "asked for twice");
  expect_refusal(with([](Study& s) { s.until_width = StudyWidth{.target = 2, .width = 1}; }), "no such target");
  expect_refusal(with([](Study& s) { s.until_width = StudyWidth{.width = 0}; }), "until_width.width");
  expect_refusal(with([](Study& s) { s.until.range = 1e6; }), "0 arrived");
  expect_refusal(with([](Study& s) { s.projectile.mass = -1; }), "projectile.mass");
  EXPECT_FALSE(plan_study(throw_of(), StudyFunction{}));
}

/// The share of draws below zero, Phi(-2) = 2.3 %, is told before, and so many shots are refused.
TEST(BadStudies, the_impossible_is_told_and_counted) {
  Study study = throw_of();
  study.inputs = {input("shot.mass", NormalDistribution{2, 1})};
  study.shots = 6400;
  const auto plan = must(plan_study(study));
  ASSERT_EQ(plan.notes().size(), 1U);
  EXPECT_NE(plan.notes()[0].find("2.3 %"), std::string::npos) << plan.notes()[0];
  const auto run = must(run_study(plan));
  EXPECT_NEAR(static_cast<double>(run.refused), 0.02275 * 6400, 4 * std::sqrt(0.02275 * 6400));
  ASSERT_TRUE(run.first_refusal);
  EXPECT_NE(run.first_refusal->text().find("mass"), std::string::npos);
  EXPECT_EQ(run.quantities[0].cells.count() + run.refused, run.shots);
}

/// Shots that fall short are misses, and no part of means.
TEST(BadStudies, shots_that_do_not_arrive_are_counted) {
  Study study = throw_of(NormalDistribution{30, 2});
  study.until.range = 79;
  study.targets = {{"wall", RectangleTarget{{}, 1000, 1000}}};
  study.shots = 6400;
  const auto run = must(run_study(study));
  EXPECT_GT(run.not_arrived, 500U);
  EXPECT_EQ(run.hits[0].hits + run.not_arrived, run.shots);
  EXPECT_GT(run.quantities[1].least, -1.1) << "none below the ground";
}

TEST(BadStudies, parts_that_do_not_fit) {
  const auto plan = plan_study(throw_of()), other = plan_study(throw_of(NormalDistribution{31, 1}));
  const StudyPart a = run_shard(*plan, 0), b = run_shard(*plan, 2);
  const auto words = [](const auto& result) { return result ? std::string() : result.error().text(); };
  EXPECT_NE(words(merge(a, a)).find("both parts have shard 0"), std::string::npos);
  EXPECT_NE(words(merge(a, run_shard(*other, 1))).find("different studies"), std::string::npos);
  const auto both = must(merge(a, b));
  EXPECT_TRUE(both.has(2) && !both.has(1));
  EXPECT_NE(words(result_of(*plan, both, 3)).find("shard 1 of 3 are missing"), std::string::npos);
  EXPECT_NE(words(result_of(*plan, both, 5)).find("shard 1, shards 3 to 4 of 5 are missing"), std::string::npos);
  EXPECT_NE(words(result_of(*other, both, 1)).find("another study"), std::string::npos);
  EXPECT_NE(words(run_study(*other, nullptr, {.so_far = both})).find("another study"), std::string::npos);
  EXPECT_TRUE(result_of(*plan, both, 1));
  EXPECT_FALSE(result_of(*plan, StudyPart(), 1));
}

/// A part with other bytes and the check sum that goes with them.
std::vector<std::byte> with_sum(std::vector<std::byte> bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t sum = hash_of(bytes);
  for (unsigned i = 0; i < 8; ++i) bytes.push_back(static_cast<std::byte>(sum >> (8 * i)));
  return bytes;
}

std::string why_not(const Result<StudyPart>& part) { return part ? "" : part.error().text(); }

TEST(BadStudies, parts_of_another_version_are_refused_by_name) {
  const auto plan = plan_study(throw_of());
  std::vector<std::byte> bytes = save_part(run_shard(*plan, 0));
  ASSERT_TRUE(load_part(with_sum(bytes)));
  constexpr std::size_t kFormat = 21, kVersionPlace = 29;  // behind "physim study part" with its length; format, length
  const std::string other = "PhySim 7" + std::string(kVersion).substr(1), own = std::string("PhySim ") + kVersion;
  bytes[kVersionPlace] = std::byte{'7'};
  EXPECT_EQ(why_not(load_part(with_sum(bytes))), "part: error: the part is of " + other + ", and this is " + own +
                                                     "; join it with the version that flew it, or fly it again");
  bytes[kFormat] = std::byte{99};
  EXPECT_NE(why_not(load_part(bytes)).find("the part is of format 99, written by " + other + "; this is " + own),
            std::string::npos);
  for (const int older : {2, 3, 4}) {  // they have the hash of the study where the version stands now
    bytes[kFormat] = static_cast<std::byte>(older);
    for (std::size_t i = 0; i < 8; ++i) bytes[kFormat + 4 + i] = std::byte(0x9e * (i + 1));
    EXPECT_NE(why_not(load_part(bytes))
                  .find("the part is of format " + std::to_string(older) +
                        ", written by an older version of PhySim; this is " + own),
              std::string::npos)
        << why_not(load_part(bytes));
  }
}

TEST(BadStudies, damaged_bytes_are_refused) {
  const auto plan = plan_study(throw_of());
  const std::vector<std::byte> bytes = save_part(run_shard(*plan, 0));
  ASSERT_TRUE(load_part(bytes));
  EXPECT_FALSE(load_part({}));
  for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 300) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{4};
    EXPECT_FALSE(load_part(damaged)) << i;
    EXPECT_FALSE(load_part(std::span(bytes).first(i))) << i;
  }
}

TEST(BadStudies, an_elevation_is_drawn_beside_a_zero_range) {
  Study study = throw_of();
  study.fidelity.motion = Motion::force;
  study.launch = {.speed = 300, .sight = {.zero_range = 100}};
  study.until = {.ground = {}, .range = 100};
  study.inputs = {input("shot.elevation", NormalDistribution{0, 1e-4})};
  expect_refusal(study, "the zero range gives another");
  study.inputs[0].added = true;
  EXPECT_EQ(refusal(study), "");
}

TEST(BadStudies, targets_on_a_plane_of_no_lengths) {
  Study study = throw_of();
  study.targets = {{"a", CircleTarget{{}, 1}}};
  study.quantities = {StudyQuantity::speed, StudyQuantity::time};
  expect_refusal(study, "ask for two lengths first");
  study.targets.clear();
  const auto result = must(run_study(study));
  EXPECT_FALSE(result.from_aim || result.ellipse || result.zone) << "a speed and a time have no distance";
}

TEST(BadStudies, two_targets_of_one_name) {
  Study study = throw_of();
  study.targets = {{"plate", CircleTarget{{}, 1}}, {"", CircleTarget{{}, 2}}, {"", CircleTarget{{}, 3}}};
  EXPECT_EQ(refusal(study), "");
  study.targets.push_back({"plate", CircleTarget{{}, 4}});
  expect_refusal(study, "targets[3]");
  expect_refusal(study, "has the name \"plate\" of targets[0]");
}

TEST(BadStudies, outlines_that_cross_themselves) {
  Study study = throw_of();
  const auto with = [&](const std::vector<PlanePoint>& corners) -> Study& {
    study.targets = {{"area", PolygonTarget{corners}}};
    return study;
  };
  expect_refusal(with({{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}), "crosses itself");
  expect_refusal(with({{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}}), "crosses itself");
  EXPECT_EQ(refusal(with({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})), "");
  EXPECT_EQ(refusal(with({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})), "") << "a corner that points inwards";
}

TEST(BadStudies, targets_at_the_muzzle_are_told) {
  Study study = throw_of();
  study.targets = {{"plate", CircleTarget{{}, 1}}};
  const auto plan = must(plan_study(study));
  ASSERT_EQ(plan.notes().size(), 1U);
  EXPECT_NE(plan.notes()[0].find("\"plate\" stands at the muzzle"), std::string::npos) << plan.notes()[0];
  study.aim = {0, 75};
  EXPECT_TRUE(plan_study(study)->notes().empty());
  study.aim = {};
  study.targets = {{"plate", RectangleTarget{{}, 500, 10}}};
  EXPECT_EQ(plan_study(study)->notes().size(), 1U);
  study.targets = {{"field", CircleTarget{{}, 500}}, {"strip", RectangleTarget{{}, 10, 500}}};
  EXPECT_TRUE(plan_study(study)->notes().empty()) << "these reach to where shots come down";
}

TEST(BadStudies, targets_at_the_muzzle_are_told_where_shots_scatter_widely) {
  Study study = throw_of(NormalDistribution{30, 3});
  study.targets = {{"plate", CircleTarget{{}, 1}}};
  const auto result = must(run_study(study));
  EXPECT_EQ(result.hits[0].probability.value, 0);
  EXPECT_EQ(plan_study(study)->notes().size(), 1U) << "no shot hits, and something says why";
}

TEST(BadStudies, shots_that_cannot_be_are_no_misses) {
  Study study = throw_of(NormalDistribution{0, 10});
  study.shots = study.shard_shots = 4096;
  study.targets = {{"all there is", CircleTarget{{}, 1e6}}};
  const auto result = must(run_study(study));
  EXPECT_GT(result.refused, 1800U) << "half of the speeds are negative";
  EXPECT_EQ(result.hits[0].probability.value, 1);
  EXPECT_EQ(result.hits[0].high, 1);
}

}  // namespace physim::study_bad_studies_test
