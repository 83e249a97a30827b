// Settings of [[volley]]: shots fired many times, scattered.
#include "scenario/settings_parts.hpp"

namespace physim {

template <>
std::span<const std::string_view> names_of<SpreadShape>() {
  static constexpr std::string_view names[] = {"normal", "uniform"};
  return names;
}

namespace {

/// Another way to say interval, which says all that it says.
ValueRef rate_slot(const Scope& scope) {
  Volley& volley = *scope.volley;
  return OptionalNumber{[] { return std::optional<double>(); },
                        [&volley](std::optional<double> rate) {
                          if (rate) volley.interval = 1 / *rate;
                        }};
}

constexpr Entry kVolleySettings[] = {
    {.path = "volley",
     .slot = PHYSIM_RECORDS(scenario->volleys, volley),
     .doc = "shots fired many times; a shot of no volley is fired once, at the start",
     .range = at_most(100000)},
    {.path = "volley.name", .slot = PHYSIM_FIELD(volley->name), .doc = "in tables; default: volley-1, volley-2, ..."},
    {.path = "volley.shot", .slot = PHYSIM_FIELD(volley->shot), .doc = "name of the shot", .required = true},
    {.path = "volley.count", .slot = PHYSIM_FIELD(volley->count), .doc = "launches", .range = between(1, 1e8)},
    {.path = "volley.interval",
     .slot = PHYSIM_FIELD(volley->interval),
     .doc = "time between launches; 0: all at once",
     .quantity = Quantity::time,
     .range = at_least(0)},
    {.path = "volley.rate",
     .slot = rate_slot,
     .doc = "launches in a time, instead of interval",
     .quantity = Quantity::frequency,
     .range = above(0)},
    {.path = "volley.start",
     .slot = PHYSIM_FIELD(volley->start),
     .doc = "time of the first launch",
     .quantity = Quantity::time,
     .range = at_least(0)},
    {.path = "volley.spread.shape",
     .slot = PHYSIM_FIELD(volley->spread.shape),
     .doc = "normal: the numbers are standard deviations; uniform: bounds"},
    {.path = "volley.spread.horizontal",
     .slot = PHYSIM_FIELD(volley->spread.horizontal),
     .doc = "of the direction, to both sides",
     .quantity = Quantity::angle,
     .range = {.low = 0, .high = 2 * kRightAngle, .words = "0 .. 180 deg"}},
    {.path = "volley.spread.vertical",
     .slot = PHYSIM_FIELD(volley->spread.vertical),
     .doc = "of the direction, up and down",
     .quantity = Quantity::angle,
     .range = {.low = 0, .high = 2 * kRightAngle, .words = "0 .. 180 deg"}},
    {.path = "volley.spread.speed",
     .slot = PHYSIM_FIELD(volley->spread.speed),
     .doc = "of the speed; never below 0",
     .quantity = Quantity::speed,
     .range = at_least(0)},
    {.path = "volley.spread.position",
     .slot = PHYSIM_FIELD(volley->spread.position),
     .doc = "of the muzzle, by axis",
     .quantity = Quantity::length,
     .range = at_least(0)},
    {.path = "volley.seed",
     .slot = PHYSIM_FIELD(volley->seed),
     .doc = "of the spread: another seed, another scatter; each launch has numbers of its own",
     .range = between(0, 9007199254740992.0)},
};

}  // namespace

std::span<const Entry> volley_settings() { return kVolleySettings; }

}  // namespace physim
