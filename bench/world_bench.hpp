// What the sections about worlds share: the projectiles, and worlds full of them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "physim/world.hpp"
#include "sections.hpp"
#include "world_peers.hpp"

namespace physim::bench {

/// Steps are those of a game that draws 240 frames a second: nothing comes to rest or leaves the air meanwhile.
inline constexpr double kFrame = 1.0 / 240;

/// A .308 bullet with data for every rung.
[[nodiscard]] ProjectileDef world_bullet(const Fidelity& fidelity);
[[nodiscard]] PeerPhysics peer_physics();
/// The i-th shot of a volley: all directions and speeds differ.
[[nodiscard]] Launch volley_launch(std::size_t i);
[[nodiscard]] std::vector<Launch> volley(std::size_t count);
[[nodiscard]] std::vector<PeerProjectile> peer_volley(std::size_t count);

/// One thread, no ground.
[[nodiscard]] WorldDef free_flight();
/// The volley; fidelities take turns.
[[nodiscard]] World world_of(const WorldDef& def, std::span<const Fidelity> fidelities, std::size_t count);

/// G7 drag in the standard atmosphere, float.
[[nodiscard]] Fidelity curve_fidelity(Integrator integrator);
/// Sixteen rungs: two integrators, four models of drag, two of gravity; float.
[[nodiscard]] std::vector<Fidelity> sixteen_fidelities();

inline constexpr std::size_t kStepped = 100000;  // projectiles of each of the worlds below

/// A world that is stepped again and again, with what else is done in each step.
struct SteppedWorld {
  std::string name;
  World world;
  std::function<void(World&)> step = [](World& w) { w.step(kFrame); };
  double events = 0;  // in all steps that were timed
  std::vector<double> each = {};
};
/// A volley that rises and falls: apexes are told.
[[nodiscard]] SteppedWorld with_apexes(std::string name, const Fidelity& fidelity);
/// A machine gun: a hundredth of the projectiles lands in every step and as many are spawned.
[[nodiscard]] SteppedWorld landing(std::string name, const Fidelity& fidelity);
/// Steps of worlds, by one thread and in turn, beside those of the first. `first` and `what` head the columns: a short
/// name of that one, and what the names of worlds say.
[[nodiscard]] Section steps_section(std::vector<SteppedWorld> worlds, const std::string& first, const std::string& what,
                                    const Options& options);

/// Times for each of `count` things [ns].
[[nodiscard]] std::vector<double> each_ns(const std::vector<double>& seconds, double count);
[[nodiscard]] Cell nanoseconds(double value);
[[nodiscard]] Cell quartiles(const std::vector<double>& values);

[[nodiscard]] Section free_flight_section(const Options& options);
[[nodiscard]] Section rungs_section(const Options& options);
[[nodiscard]] Section closed_forms_section(const Options& options);
[[nodiscard]] Section operations_section(const Options& options);
/// Emitters: births and deaths beside bulk spawns, frames of a million sparks, sixteen at once.
[[nodiscard]] std::vector<Section> emitter_sections(const Options& options);

}  // namespace physim::bench
