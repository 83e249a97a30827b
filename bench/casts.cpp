// Segments cast into scenes, beside Embree 3 and Bullet 3.
#include <cmath>

#include "cast_scenes.hpp"
#include "sections.hpp"

namespace physim::bench {
namespace {

struct Contest {
  std::vector<std::string> names;
  std::vector<std::function<void(std::vector<float>&)>> casts;
  std::vector<CastSegment> segments;
  std::vector<SceneSegment> own_segments;
  std::vector<SceneHit> hits;

  explicit Contest(std::vector<CastSegment> list) : segments(std::move(list)), hits(segments.size()) {
    for (const CastSegment& s : segments)
      own_segments.push_back({{s.from[0], s.from[1], s.from[2]}, {s.to[0], s.to[1], s.to[2]}});
  }
  void add(const std::string& name, const Scene& scene) {
    names.push_back(name);
    casts.emplace_back([this, &scene](std::vector<float>& parts) {
      scene.first_hits(own_segments, hits);
      for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = hits[i] ? static_cast<float>(hits[i].part) : 2;
    });
  }
  void add(const std::string& name, CastPeer* peer) {
    if (!peer) return;
    names.push_back(name);
    casts.emplace_back([this, peer](std::vector<float>& parts) { peer->cast(segments, parts); });
  }
  /// Rows of name, ns, what it is to the first peer and the second, and how many answers differ from the first
  /// contender.
  void run(const std::string& where, const Options& options, Section& s) {
    std::vector<std::vector<float>> parts(casts.size(), std::vector<float>(segments.size()));
    std::vector<std::function<void()>> turns;
    for (std::size_t i = 0; i < casts.size(); ++i) turns.emplace_back([&, i] { casts[i](parts[i]); });
    const auto taken = take_turns(options.clock, options.rounds, turns);
    const auto versus = [&](const char* peer, std::size_t i) -> Cell {
      for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k] == peer) return times(median(ratios(taken[i], taken[k])));
      return "";
    };
    for (std::size_t i = 0; i < casts.size(); ++i) {
      std::size_t hit = 0, other = 0;
      for (std::size_t k = 0; k < segments.size(); ++k) {
        hit += parts[i][k] <= 1 ? 1 : 0;
        other += std::abs(parts[i][k] - parts[0][k]) > 1e-4f ? 1 : 0;
      }
      const auto count = static_cast<double>(segments.size());
      s.rows.push_back({where, names[i], fixed(median(taken[i]) * 1e9 / count, 1), versus("Embree 3", i),
                        versus("Bullet 3", i), percent(static_cast<double>(hit) / count),
                        fixed(static_cast<double>(other), 0)});
    }
  }
};

}  // namespace

Section casts_section(const Options& options) {
  Section s;
  s.title = "Scenes: segments";
  s.intro =
      "Segments of 5 to 15 m, one thread, one after the other: over a terrain of 100 352 triangles, and through a town "
      "of "
      "1000 houses that share a mesh. Times as parts of Embree's and Bullet's; answers that differ from the first "
      "contender's by more than 1e-4 of the way.";
  s.columns = {"scene", "contender", "ns a segment", "of Embree's", "of Bullet's", "hit", "differ"};
  const std::size_t count = options.quick ? 20000 : 100000;
  const CastMesh hills = terrain(kPoints), building = house();
  const std::vector<CastPlace> places = streets(1000);
  const Scene land = scene_of(hills, {}), field = field_scene(), town = scene_of(building, places);
  const auto embree = embree_scene(hills, {}, false), packets = embree_scene(hills, {}, true);
  const auto bullet = bullet_scene(hills, {});
  const auto height = [](double x, double z) {
    return ground(static_cast<std::uint32_t>(x / kSpacing), static_cast<std::uint32_t>(z / kSpacing));
  };
  Contest over(segments_over(count, kSpacing * (kPoints - 1), kSpacing * (kPoints - 1), height));
  over.add("PhySim, mesh", land);
  over.add("PhySim, height field", field);
  over.add("Embree 3", embree.get());
  over.add("Embree 3, packets of 16", packets.get());
  over.add("Bullet 3", bullet.get());
  over.run("terrain", options, s);
  const auto embree_town = embree_scene(building, places, false), packets_town = embree_scene(building, places, true);
  const auto bullet_town = bullet_scene(building, places);
  Contest through(segments_over(count, 32 * 22.0, 32 * 24.0, [](double, double) { return 0.0; }));
  through.add("PhySim", town);
  through.add("Embree 3", embree_town.get());
  through.add("Embree 3, packets of 16", packets_town.get());
  through.add("Bullet 3", bullet_town.get());
  through.run("town", options, s);
  return s;
}

Section build_section(const Options& options) {
  const std::uint32_t points = options.quick ? 225 : 708;  // a million triangles
  const CastMesh mesh = terrain(points);
  const MeshShape shape = as_shape(mesh);
  Section s;
  s.title = "Scenes: building";
  s.intro = "A mesh of a terrain put into its tree, one thread: all that add_shape() does, checks and copies included.";
  s.columns = {"contender", "triangles", "ms", "of Embree's", "bytes a triangle"};
  const auto triangles = static_cast<double>(shape.triangles.size());
  std::size_t bytes = 0;
  const std::vector<std::function<void()>> turns = {[&] {
                                                      Scene scene;
                                                      bytes = scene.info(scene.add_shape(shape).value())->bytes;
                                                    },
                                                    [&] { static_cast<void>(embree_scene(mesh, {}, false)); }};
  const auto taken = take_turns(options.clock, 3, turns);
  s.rows.push_back({"PhySim", fixed(triangles, 0), fixed(1e3 * median(taken[0]), 1),
                    times(median(ratios(taken[0], taken[1]))), fixed(static_cast<double>(bytes) / triangles, 1)});
  s.rows.push_back({"Embree 3", fixed(triangles, 0), fixed(1e3 * median(taken[1]), 1), times(1), ""});
  return s;
}

}  // namespace physim::bench
