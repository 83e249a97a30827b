// Assumed: the defaults that mattered to a flight, found by flights with each of them a little different.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json.hpp"
#include "scenario/schema.hpp"
#include "scenario/writer.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

/// Defaults that nobody gave and that mattered to a flight: it ends elsewhere where they are a little different.
class Assumed {
 public:
  Assumed(const FlownScenario& flown, std::size_t shot)
      : flown_(flown), scenario_(flown.scenario), shot_(shot), changed_(flown.scenario), end_(flight().end()) {
    // A flight that exceeds this number of steps ends there: its end differs.
    const FlightCost& cost = flight().cost();
    std::int64_t& most = changed_.tolerance.max_steps;
    most = std::min(most, 1000 + 10 * (cost.steps + cost.rejected));
  }

  [[nodiscard]] Json list() {
    Json all = Json::array();
    for (const char* table : {"environment", "until", "shot"}) look_into(*find_node(table), all);
    return all;
  }

 private:
  [[nodiscard]] const Flight& flight() const { return flown_.shots[shot_].flight; }

  void look_into(const SchemaNode& node, Json& all) {
    for (const SchemaNode& child : node.children) {
      if (child.entry == nullptr) {
        if (child.path != "shot.fidelity") look_into(child, all);  // what was granted is told
      } else if (!child.is_list_of_tables()) {
        look_at(child, all);
      }
    }
  }

  void look_at(const SchemaNode& node, Json& all) {
    constexpr std::string_view kShot = "shot.";
    const std::string path =
        node.path.starts_with(kShot)
            ? std::string(kShot) + scenario_.shots[shot_].projectile.name + "." + node.path.substr(kShot.size())
            : node.path;
    if (is_given(path)) return;
    changed_.environment = scenario_.environment;
    changed_.until = scenario_.until;
    changed_.shots[shot_] = scenario_.shots[shot_];
    const Scope scope{.scenario = &changed_, .shot = &changed_.shots[shot_]};
    const auto value = written(*node.entry, scope);
    if (value && change(*node.entry, scope) && ends_elsewhere()) all.push_back({{"path", path}, {"value", *value}});
  }

  /// A table, or a value that stands for one, gives all that is in it.
  [[nodiscard]] bool is_given(const std::string& path) const {
    for (std::size_t end = path.find('.'); end != path.npos; end = path.find('.', end + 1))
      if (std::ranges::binary_search(scenario_.given, path.substr(0, end), {}, &GivenSetting::path)) return true;
    return std::ranges::binary_search(scenario_.given, path, {}, &GivenSetting::path);
  }

  /// A number that is a little different, within its range; itself where there is none.
  static double another(const Entry& entry, double value) {
    constexpr double kPart = 0.01, kLittle = 0.01;
    const double by = value == 0 ? kLittle : kPart * std::abs(value);
    if (entry.range.contains(value + by)) return value + by;
    return entry.range.contains(value - by) ? value - by : value;
  }

  /// Gives a setting another value; false where there is none to be tried.
  static bool change(const Entry& entry, const Scope& scope) {
    const ValueRef at = entry.slot(scope);
    return std::visit(Overloaded{[&](double* x) { return std::isfinite(*x) && (*x = another(entry, *x), true); },
                                 [&](const OptionalNumber& x) {
                                   const std::optional<double> now = x.get();
                                   if (now && !std::isfinite(*now)) return false;
                                   x.set(now ? another(entry, *now) : usual(entry.quantity));
                                   return true;
                                 },
                                 [&](Vec3d* v) {
                                   for (double* x : {&v->x, &v->y, &v->z}) *x = another(entry, *x);
                                   return true;
                                 },
                                 [&](bool* x) { return *x = !*x, true; },
                                 [&](const Choice& choice) {
                                   const std::optional<std::size_t> now = choice.get();
                                   if (!now || choice.names.size() < 2) return false;
                                   choice.set((*now + 1) % choice.names.size());
                                   return true;
                                 },
                                 [](const auto&) { return false; }},
                      at);
  }
  /// What a number may be that is left to something else.
  static double usual(Quantity quantity) {
    if (quantity == Quantity::temperature) return 280;
    return quantity == Quantity::pressure ? 9e4 : 1;
  }

  [[nodiscard]] bool ends_elsewhere() const {
    const ScenarioShot& shot = changed_.shots[shot_];
    const Flight other = flown_.scene ? fly_shot(changed_, shot, *flown_.scene) : fly_shot(changed_, shot);
    if (other.error()) return false;
    constexpr double kRounding = 1e-7;
    const Sample end = other.end();
    const double moved = length(end.position - end_.position), slower = length(end.velocity - end_.velocity);
    return moved > kRounding * (1 + length(end_.position)) || slower > kRounding * (1 + end_.speed) ||
           std::abs(end.time - end_.time) > kRounding * (1 + end_.time);
  }

  const FlownScenario& flown_;
  const Scenario& scenario_;
  std::size_t shot_;
  Scenario changed_;
  Sample end_;
};

}  // namespace

Json assumed_json(const FlownScenario& flown, std::size_t shot) {
  constexpr std::size_t kMostShots = 20;
  constexpr std::int64_t kMostEvaluations = 200'000;  // of a flight that is flown again for each default
  const bool is_long = flown.shots[shot].flight.cost().evaluations > kMostEvaluations;
  return shot < kMostShots && !is_long ? Assumed(flown, shot).list() : Json();
}

}  // namespace physim::report
