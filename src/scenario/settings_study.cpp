// Settings of [study].
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

constexpr Range kCount = between(1, 1e15);

constexpr Entry kStudySettings[] = {
    PHYSIM_SCENARIO(study.inputs,
                    "what `physim study` draws: \"shot.speed = 800 m/s +- 3 m/s\", see docs/uncertainty.md",
                    at_most(64)),
    PHYSIM_SCENARIO(study.correlated, "\"shot.speed with shot.mass = 0.5\", \"shot.drag.curve.N by distance = 0.3\"",
                    at_most(1000)),
    PHYSIM_SCENARIO(study.targets,
                    "\"plate: rectangle 30 cm x 50 cm at 0 m, 1 m\" (width x height), \"circle 10 cm\" (radius), "
                    "\"thing wall\"",
                    at_most(1000)),
    PHYSIM_SCENARIO(
        study.quantities,
        "what is asked of the ends of flights, two of the plane first, as [\"right\", \"up\"]; empty: right, "
        "up (without a range along), time, speed; impact_speed, obliquity and impact_energy are of the first impact on "
        "a "
        "thing or the ground",
        at_most(14)),
    PHYSIM_SCENARIO(study.at,
                    "places on the way that the same flights are told at, too: \"800 m\", \"apex\", \"height 100 m "
                    "falling\", with other quantities \"apex: y, time\"",
                    at_most(24)),
    PHYSIM_SCENARIO(study.aim, "where shots should end on the plane of impact, \"0 m, 1 m\"; empty: its origin"),
    PHYSIM_SCENARIO(study.sampling, "how draws are spread"),
    PHYSIM_SCENARIO(study.shots, "at least; the last shard is flown to its end", kCount),
    PHYSIM_SCENARIO(study.until_time,
                    "`physim study` ends when so much time is up, instead of after so many shots; how many it flew is "
                    "printed",
                    Quantity::time, above(0)),
    PHYSIM_SCENARIO(study.seed, "of the draws; equal seeds draw equally", between(0, 9007199254740992)),
    PHYSIM_SCENARIO(study.rounds, "shots of an occasion", between(1, 65536)),
    PHYSIM_SCENARIO(study.over_inputs, "parts of each input over which hits are told; 0: none", between(0, 100)),
    PHYSIM_SCENARIO(study.histograms, "bars of a histogram of each quantity, 3 or more; 0: none", between(0, 1000)),
    PHYSIM_SCENARIO(study.indices, "Sobol indices, for which every shot is flown again for each input"),
};

}  // namespace

std::span<const Entry> study_settings() { return kStudySettings; }

}  // namespace physim
