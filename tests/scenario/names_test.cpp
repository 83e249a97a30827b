// Names within a scenario lead where a search of the whole list leads.
#include "scenario/names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scenario/scene_maker.hpp"

namespace physim::scenario_names_test {

TEST(NameIndex, finds_the_first_of_a_name) {
  const std::vector<std::string> list = {"a", "b", "a", "", "c"};
  NameIndex index;
  std::vector<bool> is_new;
  for (const std::string& name : list) is_new.push_back(index.add(name));
  EXPECT_EQ(is_new, (std::vector<bool>{true, true, false, true, true}));
  for (const char* name : {"a", "b", "", "c", "d"}) {
    const auto at = std::ranges::find(list, name);
    EXPECT_EQ(index.has(name), at != list.end()) << name;
    if (at != list.end()) {
      EXPECT_EQ(index.find(name), static_cast<std::size_t>(at - list.begin())) << name;
    }
  }
  EXPECT_EQ(index.all().size(), 5U);
}

TEST(Names, of_the_library_become_those_of_files) {
  EXPECT_EQ(in_files("launch.sight.zero_range"), "shot.sight.zero_range");
  EXPECT_EQ(in_files("of 64 shots: projectile.mass: is heavy; see `launch.speed`"),
            "of 64 shots: shot.mass: is heavy; see `shot.speed`");
  for (const char* same : {"launch", "the launch. It", "relaunch.speed", "environment.wind", ""})
    EXPECT_EQ(in_files(same), same);
}

TEST(ScenarioNames, know_who_fires_which_shot) {
  const std::string text =
      "physim = 1\n[world]\nduration = 1\n[[shot]]\nname = \"a\"\n[[shot]]\nname = \"b\"\n[[shot]]\nname = \"c\"\n"
      "[[volley]]\nname = \"v\"\nshot = \"b\"\n[[emitter]]\nname = \"e\"\nshot = \"c\"\n";
  const Scenario scenario = parse_scenario(text, "f.toml").value();
  const ScenarioNames names(scenario);
  EXPECT_TRUE(names.is_alone("a"));
  EXPECT_FALSE(names.is_alone("b"));
  EXPECT_FALSE(names.is_alone("c"));
  EXPECT_EQ(names.lone_shots(), (std::vector<std::string_view>{"a"}));
  EXPECT_EQ(names.groups(), (std::vector<std::string_view>{"a", "v", "e"}));
}

/// Rounds over the list, each of which takes the emitters whose subs are there by then: the order by its definition.
std::vector<std::size_t> in_rounds(const std::vector<std::vector<std::size_t>>& subs) {
  std::vector<std::size_t> order;
  std::vector<bool> is_in(subs.size());
  for (std::size_t before = order.size() + 1; before != order.size();) {
    before = order.size();
    for (std::size_t i = 0; i < subs.size(); ++i) {
      const auto may_come = [&](std::size_t fires) { return fires == i || is_in[fires]; };
      if (!is_in[i] && std::ranges::all_of(subs[i], may_come)) order.push_back(i), is_in[i] = true;
    }
  }
  return order;
}

TEST(EmitterOrder, is_that_of_rounds_over_the_list) {
  std::mt19937 random(7);
  int circles = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t count = 1 + random() % 9;
    Scenario scenario;
    std::vector<std::vector<std::size_t>> subs(count);
    NameIndex names;
    for (std::size_t i = 0; i < count; ++i) {
      ScenarioEmitter& emitter = scenario.emitters.emplace_back();
      emitter.def.name = "e" + std::to_string(i);
      for (unsigned k = random() % 3; k > 0; --k) {
        subs[i].push_back(random() % count);
        emitter.subs.emplace_back().emitter = "e" + std::to_string(subs[i].back());
      }
    }
    for (const ScenarioEmitter& emitter : scenario.emitters) names.add(emitter.def.name);
    const std::vector<std::size_t> expected = in_rounds(subs);
    const auto order = order_of_emitters(scenario, names);
    EXPECT_EQ(order.ok(), expected.size() == count) << trial;
    if (order) {
      EXPECT_EQ(*order, expected) << trial;
    }
    circles += order.ok() ? 0 : 1;
    if (order) continue;
    std::size_t left = 0;  // the first that never comes
    while (std::ranges::count(expected, left) > 0) ++left;
    EXPECT_EQ(order.error().place, "e" + std::to_string(left)) << trial;
  }
  EXPECT_GT(circles, 30);
  EXPECT_LT(circles, 270);
}

}  // namespace physim::scenario_names_test
