// Rows of an Environment.
#pragma once

#include "model/conditions.hpp"
#include "model/station.hpp"
#include "settings/row.hpp"

namespace physim::setting_rows {

inline constexpr Range kGravities = {.low = -1e12, .high = 1e12};   // [m/s^2]
inline constexpr Range kWindSpeeds = {.low = -1e18, .high = 1e18};  // of a component [m/s]

inline constexpr auto kGroundRows = std::tuple{
    PHYSIM_SETTING(altitude, "altitude of the origin of the world frame above sea level, or above the ellipsoid",
                   Quantity::length, between(kLowestAltitude, 1e9), kUncertain),
    PHYSIM_SETTING(gravity.model, "gravity field that is there", kShorthand),
    PHYSIM_SETTING(gravity.acceleration, "gravity at sea level, downwards, of constant and inverse_square",
                   Quantity::acceleration, kGravities, in_files({}), kUncertain),
    PHYSIM_SETTING(gravity.radius, "distance of sea level from the Earth's centre", Quantity::length, above(0)),
};

inline constexpr auto kAirPointRows = std::tuple{
    PHYSIM_SETTING(altitude, "above sea level", Quantity::length, between(kLowestAltitude, kHighestAltitude)),
    PHYSIM_SETTING(temperature, "of the air there", Quantity::temperature, between(150, 350)),
    PHYSIM_SETTING(pressure, "there; none: in equilibrium with the level below", Quantity::pressure,
                   between(0.01, 200000)),
    PHYSIM_SETTING(humidity, "relative humidity there; none: dry", kFraction),
};

inline constexpr auto kAirRows = std::tuple{
    PHYSIM_SETTING(atmosphere.model, "air that is there", kShorthand),
    PHYSIM_SETTING(atmosphere.temperature, "at the station; none: standard", Quantity::temperature, between(150, 350),
                   drawn_into(&Weather::temperature)),
    PHYSIM_SETTING(atmosphere.pressure, "at the station, not reduced to sea level; none: standard", Quantity::pressure,
                   between(100, 120000), drawn_into(&Weather::pressure)),
    PHYSIM_SETTING(atmosphere.humidity, "relative humidity at the station; none: dry", kFraction,
                   drawn_into(&Weather::humidity)),
    PHYSIM_SETTING(atmosphere.station_altitude, "altitude of the station above sea level; none: that of the origin",
                   Quantity::length, between(kLowestAltitude, 80000)),
    PHYSIM_SETTING(atmosphere.density, "at the origin, overrides all else for constant and exponential air",
                   Quantity::density, at_least(0), drawn_into(&Weather::density), kDrawnAboveZero),
    PHYSIM_SETTING(atmosphere.sound_speed, "at the origin, overrides all else for constant and exponential air",
                   Quantity::speed, above(0)),
    PHYSIM_SETTING_LIST(atmosphere.profile, kAirPointRows,
                        "levels of a sounding at rising altitudes, in the place of what a station measures",
                        at_most(kMostLevels)),
};

inline constexpr auto kScaleHeightRows = std::tuple{
    PHYSIM_SETTING(atmosphere.scale_height, "of exponential air", Quantity::length, above(0), kUncertain),
};

inline constexpr auto kWindPointRows = std::tuple{
    PHYSIM_SETTING(at, "height above the origin, or distance downrange", Quantity::length, kPlace),
    PHYSIM_SETTING(velocity, "velocity of the air there", Quantity::speed, kWindSpeeds, in_files({})),
};

inline constexpr auto kWindRows = std::tuple{
    PHYSIM_SETTING(wind.velocity, "velocity of the air; (0, 0, -4) blows from the right", Quantity::speed, kWindSpeeds,
                   in_files({}), drawn_into(&Weather::wind_x, &Weather::wind_y, &Weather::wind_z)),
    PHYSIM_SETTING_LIST(wind.profile, kWindPointRows, "wind by height or range, at rising places, held outside",
                        at_most(kMostLevels), kUncertain),
    PHYSIM_SETTING(wind.by, "what the profile is read by"),
    PHYSIM_SETTING(wind.interpolation, "how the profile is read between its points"),
};

inline constexpr auto kEarthRows = std::tuple{
    PHYSIM_SETTING(earth.latitude, "of the origin, north positive", Quantity::angle, kHalfTurn, kUncertain),
    PHYSIM_SETTING(earth.longitude, "of the origin, east positive", Quantity::angle, in_files(kTurn), kUncertain),
    PHYSIM_SETTING(earth.azimuth, "compass direction of the x axis, clockwise from north", Quantity::angle,
                   in_files(kTurn), kUncertain),
    PHYSIM_SETTING(earth.rotation_rate, "of the Earth", Quantity::angular_rate),
};

}  // namespace physim::setting_rows
