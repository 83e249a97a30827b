// Rockets: single flights of rigid bodies to their apex, a smooth one of our own and those of scenario files.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "scenario/scenario.hpp"
#include "sections.hpp"

namespace physim::bench {
namespace {

struct Rocket {
  std::string name;
  std::function<Flight()> fly;
};

Rocket smooth_rocket() {
  const auto study = std::make_shared<const Study>(rocket_study());
  return {"a constant drag coefficient, five points of thrust, no wind", [study] {
            return fly(study->projectile, study->launch, study->environment, study->fidelity, study->tolerance,
                       study->until);
          }};
}

/// The shots of all scenario files of a folder, in the order of their names.
std::vector<Rocket> rockets_of(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".toml") files.push_back(file.path());
  std::ranges::sort(files);
  std::vector<Rocket> rockets;
  for (const auto& file : files) {
    auto loaded = load_scenario(file);
    if (!loaded) {
      std::fprintf(stderr, "%s\n", loaded.error().text().c_str());
      std::exit(2);
    }
    const auto scenario = std::make_shared<const Scenario>(std::move(*loaded));
    for (const ScenarioShot& shot : scenario->shots)
      rockets.push_back({file.stem().string(), [scenario, &shot] { return fly_shot(*scenario, shot); }});
  }
  return rockets;
}

}  // namespace

Section rockets_section(const Options& options) {
  std::vector<Rocket> rockets{smooth_rocket()};
  if (!options.rockets.empty())
    for (Rocket& rocket : rockets_of(options.rockets)) rockets.push_back(std::move(rocket));
  std::vector<std::function<void()>> turns;
  for (const Rocket& rocket : rockets) turns.emplace_back([&rocket] { static_cast<void>(rocket.fly()); });
  const auto taken = take_turns(options.clock, options.rounds, turns);
  Section s;
  s.title = "Rockets";
  s.intro =
      "One `fly()` each, with preparation and dense output, one thread. Rejected: part of the tried steps. Vs smooth: "
      "time beside that of the first row.";
  s.columns = {"rocket", "steps", "rejected", "evaluations", "ms", "vs smooth"};
  for (std::size_t i = 0; i < rockets.size(); ++i) {
    const FlightCost cost = rockets[i].fly().cost();
    const auto count = [](std::int64_t n) { return fixed(static_cast<double>(n), 0); };
    const double tried = static_cast<double>(cost.steps + cost.rejected);
    s.rows.push_back({rockets[i].name, count(cost.steps), percent(static_cast<double>(cost.rejected) / tried),
                      count(cost.evaluations), fixed(1e3 * median(taken[i]), 2),
                      times(median(ratios(taken[i], taken[0])))});
  }
  if (options.rockets.empty()) s.notes = {"`--rockets FOLDER` adds the shots of the scenario files in a folder."};
  return s;
}

}  // namespace physim::bench
