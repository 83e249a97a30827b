// What closed forms cost a world in a step in which nothing happens, and what asking for something costs beside.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <variant>

#include "world_bench.hpp"

namespace physim::bench {
namespace {

/// A volley that falls in a vacuum; none of what is set up in `def` and `body` happens while it is stepped.
World falling(const WorldDef& def, const BodyDef& body = {}) {
  World world = std::move(World::create(def).value());
  const KindId kind = *world.add_kind(world_bullet(Fidelity::arcade()), body);
  world.reserve(kind, kStepped);
  for (std::size_t i = 0; i < kStepped; ++i) world.spawn(kind, volley_launch(i));
  return world;
}

WorldDef with_ground() {
  WorldDef def = free_flight();
  def.ground = {GroundMode::land, -1e5, 0, 0};
  return def;
}

BodyDef with_despawn_rules() {
  BodyDef body;
  body.despawn = {.below = -1e5,
                  .farther = 1e6,
                  .slower = 1,
                  .outside_box = true,
                  .box_low = {-1e6, -1e6, -1e6},
                  .box_high = {1e6, 1e6, 1e6}};
  return body;
}

WorldDef with_detail_rule() {
  WorldDef def = free_flight();
  def.detail.rungs = {{Fidelity::arcade(), 1e6}, {Fidelity::game()}};
  return def;
}

/// The volley, and what is asked for after each step: a function of the world that returns something of it.
SteppedWorld read(std::string name, auto ask) {
  return {std::move(name), falling(free_flight()), [ask, kept = 0.0](World& w) mutable {
            w.step(kFrame);
            kept += static_cast<double>(ask(w));  // so that nothing is left out
          }};
}

/// Reads positions, a page after the other into the same memory, as one that hands them to a graphics card does.
struct Upload {
  std::vector<WorldColumns> columns{};
  std::array<std::byte, 4096> page{};

  double operator()(const World& w) {
    w.columns(columns);
    for (const WorldColumns& some : columns) std::visit([this](const auto& of) { take_all(of.position); }, some);
    return static_cast<double>(page[0]);
  }

 private:
  template <class R>
  void take_all(const std::array<std::span<const R>, 3>& position) {
    for (const std::span<const R>& column : position) take(column);
  }
  template <class R>
  void take(std::span<const R> column) {
    for (auto bytes = std::as_bytes(column); !bytes.empty();
         bytes = bytes.subspan(std::min(page.size(), bytes.size()))) {
      std::memcpy(page.data(), bytes.data(), std::min(page.size(), bytes.size()));
      asm volatile("" : : "r"(page.data()) : "memory");  // it is read
    }
  }
};

std::vector<SteppedWorld> worlds() {
  std::vector<SteppedWorld> list;
  list.push_back({"nothing happens", falling(free_flight())});
  list.push_back(read("all positions", [upload = Upload()](World& w) mutable { return upload(w); }));
  list.push_back(read("all positions by ids",
                      [ids = std::vector<ProjectileId>(), places = std::vector<Vec3d>()](World& w) mutable {
                        if (ids.empty()) ids = w.ids(), places.resize(ids.size());
                        w.render_positions(ids, places);
                        return places.back().y;
                      }));
  list.push_back({"ground below", falling(with_ground())});
  list.push_back(
      {"despawn rules: below, farther, slower, outside a box", falling(free_flight(), with_despawn_rules())});
  list.push_back({"a detail rule", falling(with_detail_rule())});
  list.push_back(with_apexes("apex events", Fidelity::arcade()));
  list.push_back(landing("1 % land and are replaced", Fidelity::arcade()));
  list.push_back(read("its hash", [](World& w) { return w.hash() & 1; }));
  list.push_back(read("a snapshot", [](World& w) { return w.snapshot().time(); }));
  list.push_back(read("all segments", [segments = std::vector<Segment>()](World& w) mutable {
    w.segments(segments);
    return segments.size();
  }));
  return list;
}

}  // namespace

Section closed_forms_section(const Options& options) {
  Section s = steps_section(worlds(), "nothing", "in each step", options);
  s.title = "Worlds: closed forms";
  s.notes = {"The arcade preset. All positions: World::columns(); by ids: World::render_positions()."};
  return s;
}

}  // namespace physim::bench
