// Settings of [[expect]]: figures that should come out.
#include "scenario/expectation.hpp"
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

ValueRef figure_slot(const Scope& scope) {
  std::string& quantity = scope.expect->quantity;
  return Choice{figure_names(),
                [&quantity] {
                  const Figure* figure = find_figure(quantity);
                  return figure ? std::optional<std::size_t>(figure - figures().data()) : std::nullopt;
                },
                [&quantity](std::size_t i) { quantity = figure_names()[i]; }};
}

/// expect.at.time and the like: present when the expectation looks there.
template <ExpectAt at>
ValueRef at_slot(const Scope& scope) {
  Expectation& expect = *scope.expect;
  return OptionalNumber{[&expect] { return expect.at == at ? std::optional(expect.at_value) : std::nullopt; },
                        [&expect](std::optional<double> value) {
                          if (value) expect.at = at, expect.at_value = *value;
                        }};
}

ValueRef moment_slot(const Scope& scope) {
  static constexpr std::string_view kNames[] = {"end", "apex", "rail_exit", "burnout"};
  static constexpr ExpectAt kMoments[] = {ExpectAt::end, ExpectAt::apex, ExpectAt::rail_exit, ExpectAt::burnout};
  Expectation& expect = *scope.expect;
  return Choice{kNames,
                [&expect]() -> std::optional<std::size_t> {
                  for (std::size_t i = 0; i < std::size(kMoments); ++i)
                    if (expect.at == kMoments[i]) return i;
                  return std::nullopt;
                },
                [&expect](std::size_t i) { expect.at = kMoments[i], expect.at_value = 0; }};
}

Quantity quantity_of_expectation(const Scope& scope) {
  const Figure* figure = find_figure(scope.expect->quantity);
  return figure ? figure->quantity : Quantity::number;
}

constexpr Entry kExpectSettings[] = {
    {.path = "expect",
     .slot = PHYSIM_RECORDS(scenario->expect, expect),
     .doc = "figures that should come out",
     .range = at_most(100000)},
    {.path = "expect.shot", .slot = PHYSIM_FIELD(expect->shot), .doc = "name of the shot; empty: every shot"},
    {.path = "expect.at.moment", .slot = moment_slot, .doc = "where to look: a moment", .shorthand = true},
    {.path = "expect.at.time",
     .slot = at_slot<ExpectAt::time>,
     .doc = "where to look: time since launch",
     .quantity = Quantity::time,
     .range = at_least(0)},
    {.path = "expect.at.range",
     .slot = at_slot<ExpectAt::range>,
     .doc = "where to look: first crossing of a range along the line of sight",
     .quantity = Quantity::length,
     .range = at_least(0)},
    {.path = "expect.at.height",
     .slot = at_slot<ExpectAt::height>,
     .doc = "where to look: first crossing of a height",
     .quantity = Quantity::length},
    {.path = "expect.quantity", .slot = figure_slot, .doc = "figure to look at", .required = true},
    {.path = "expect.equals",
     .slot = PHYSIM_FIELD(expect->equals),
     .doc = "value expected",
     .required = true,
     .quantity_by = quantity_of_expectation,
     .unit_by = "of the quantity"},
    {.path = "expect.within",
     .slot = PHYSIM_FIELD(expect->within),
     .doc = "distance allowed",
     .range = at_least(0),
     .required = true,
     .quantity_by = quantity_of_expectation,
     .unit_by = "of the quantity"},
    {.path = "expect.source", .slot = PHYSIM_FIELD(expect->source), .doc = "why it should be true"},
};

}  // namespace

std::span<const Entry> expect_settings() { return kExpectSettings; }

}  // namespace physim
