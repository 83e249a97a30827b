// What emitters fire: soft discs of each particle's own colour, size and rotation, streaks of what is fast, trails.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

constexpr double kExposure = 1.0 / 60;  // of the eye: what comes farther than its own size is a streak [s]
constexpr double kTracer = 1.0 / 25;    // of rounds of a gun, which are hot [s]
constexpr double kSpark = 1.0 / 12;     // of other hot dots: their light stays in the eye [s]
constexpr double kLeastStreak = 2.2, kHotStreak = 3;  // widths [pixels]

/// The particles of one emitter, as a renderer reads them.
struct Columns {
  std::vector<ProjectileId> id;
  std::vector<Vec3d> position, velocity, size, rotation;
  std::vector<Colour> colour;

  Columns(const World& world, EmitterId emitter) {
    const std::size_t count = world.particles(emitter, {});
    id.resize(count);
    for (auto* list : {&position, &velocity, &size, &rotation}) list->resize(count);
    colour.resize(count);
    world.particles(
        emitter,
        {.id = id, .position = position, .velocity = velocity, .size = size, .rotation = rotation, .colour = colour});
  }
};

/// Its own colour, or that of its kind where its emitter says none.
Colour colour_of_particle(const World& world, ProjectileId id, Colour own) {
  if (own != 0xFFFFFFFF) return own;
  const Colour colour = world[id].colour();
  return colour == kNoColour ? colours::kVelocity : colour;
}

void add_particle(const Session& session, const Camera& camera, const EmitterDef& def, const Columns& all,
                  std::size_t i, double scale, Scene& scene) {
  const Colour colour = colour_of_particle(session.world(), all.id[i], all.colour[i]);
  if ((colour & 0xFF) == 0) return;
  const Vec3d at = session.shown_position(all.id[i]);
  const bool is_sized = has_sizes(def), is_round = def.gun.rounds_per_minute > 0;
  const double pixel = camera.pixel_size(at);
  const double size = is_sized ? all.size[i].x : 4.5 * scale * pixel;
  const double hot = heat(colour), speed = length(all.velocity[i]);
  const double exposure = is_round ? kTracer : is_sized ? kExposure : std::lerp(kExposure, kSpark, hot);
  const double way = speed * std::min(exposure, session.world()[all.id[i]].age());
  const bool is_streak = way > 2 * size && way > 2 * scale * pixel;
  const double least = std::lerp(kLeastStreak, kHotStreak, hot) * scale;
  if (hot > 0) {
    const Vec3d tail = is_streak ? all.velocity[i] * (-way / speed) : Vec3d{};
    const double pixels = std::max(is_streak ? least : 3.5 * scale, is_sized ? size / pixel : 0);
    scene.lights.push_back({at + tail, at, colour, static_cast<float>(pixels)});
  }
  const Colour core = scene.theme->is_light || is_sized ? colour : core_of(colour);
  if (is_streak) {
    const Vec3d back = all.velocity[i] * (-way / speed);
    const double width = std::max(is_sized ? size / pixel : 0, least);
    constexpr int kParts = 4;  // fainter and thinner towards its end
    for (int k = 0; k < kParts; ++k) {
      const double from = 1 - static_cast<double>(k) / kParts, part = (k + 1.0) / kParts;
      scene.line(at + back * from, at + back * (from - 1.0 / kParts), faded(core, part * part),
                 std::max(width * (0.4 + 0.6 * part), scale));
    }
    return;
  }
  const Vec3d part = is_sized ? all.size[i] : Vec3d{size, size, size};
  scene.sprites.push_back({at, core, static_cast<float>(part.x), static_cast<float>(part.y),
                           static_cast<float>(all.rotation[i].x), static_cast<float>(3.5 * scale)});
}

/// From where each particle was to where it is drawn, fading towards its oldest place.
void add_trails(const Session& session, const Camera& camera, EmitterId emitter, const Columns& all, double scale,
                Scene& scene) {
  const World& world = session.world();
  const TrailCounts counts = world.trails(emitter, {});
  std::vector<std::uint32_t> first(counts.particles), count(counts.particles);
  std::vector<Vec3d> place(counts.places);
  world.trails(emitter, {.first = first, .count = count, .position = place});
  for (std::size_t i = 0; i < counts.particles; ++i) {
    const Colour colour = colour_of_particle(world, all.id[i], all.colour[i]);
    const Vec3d shown = session.shown_position(all.id[i]);
    const double wide = std::clamp(0.5 * all.size[i].x / camera.pixel_size(shown), 1.2 * scale, 6 * scale);
    for (std::uint32_t k = 1; k < count[i]; ++k) {
      const Vec3d& from = place[first[i] + k - 1];
      const Vec3d& to = k + 1 == count[i] ? shown : place[first[i] + k];
      scene.line(from, to, faded(colour, 0.8 * k / count[i]), wide);
    }
  }
}

void add_dot(const Session& session, const Columns& all, std::size_t i, Scene& scene) {
  const Colour colour = colour_of_particle(session.world(), all.id[i], all.colour[i]);
  if ((colour & 0xFF) != 0) scene.crowd.push_back({session.shown_position(all.id[i]), colour});
}

/// From far to near.
void sort_sprites(const Camera& camera, Scene& scene) {
  const Vec3d eye = camera.eye();
  std::vector<std::pair<double, std::size_t>> order;
  for (const SceneSprite& sprite : scene.sprites)
    order.emplace_back(-length_squared(camera.shown(sprite.at) - eye), order.size());
  std::ranges::sort(order);
  std::vector<SceneSprite> sorted;
  sorted.reserve(order.size());
  for (const auto& [distance, number] : order) sorted.push_back(scene.sprites[number]);
  scene.sprites = std::move(sorted);
}

}  // namespace

bool has_sizes(const EmitterDef& def) { return def.start.size != DrawnNumber{1} || def.life.size != DrawnNumber{1}; }

void build_particles(const Client& client, double scale, Scene& scene) {
  const Session& session = client.session;
  for (const EmitterId emitter : session.world().emitters()) {
    const EmitterDef* def = session.world().emitter(emitter);
    const Columns all(session.world(), emitter);
    if (client.show.trails && def->trail.points > 0) add_trails(session, client.camera, emitter, all, scale, scene);
    const bool are_dots = scene.quality != Quality::high && all.id.size() >= kCrowdedEmitter;
    for (std::size_t i = 0; i < all.id.size(); ++i)
      if (are_dots)
        add_dot(session, all, i, scene);
      else
        add_particle(session, client.camera, *def, all, i, scale, scene);
    scene.drawn.insert(scene.drawn.end(), all.id.begin(), all.id.end());
  }
  std::ranges::sort(scene.drawn);
  sort_sprites(client.camera, scene);
}

void thin_crowd(const Camera& camera, Scene& scene) {
  const double cell = std::max(1.0, static_cast<double>(scene.crowd_size)) * (scene.quality == Quality::low ? 1.5 : 1);
  const double width = std::ceil(camera.width() / cell), height = std::ceil(camera.height() / cell);
  constexpr float kEmpty = std::numeric_limits<float>::infinity();
  std::vector<float> distances(static_cast<std::size_t>(width * height), kEmpty);  // of the nearest in each cell
  std::vector<std::size_t> cells(scene.crowd.size(), distances.size());            // its size: beyond the view
  std::vector<float> away(scene.crowd.size());
  const Projector view = camera.projector();
  const Vec3d eye = camera.eye();
  for (std::size_t i = 0; i < scene.crowd.size(); ++i) {
    const Vec3d& at = scene.crowd[i].at;
    const std::optional<Pixel> seen = view.project(at);
    if (!seen || !(seen->x >= 0 && seen->y >= 0 && seen->x < camera.width() && seen->y < camera.height())) continue;
    cells[i] = static_cast<std::size_t>(std::floor(seen->y / cell) * width + std::floor(seen->x / cell));
    PHYSIM_ASSERT(cells[i] < distances.size());
    away[i] = static_cast<float>(length_squared(camera.shown(at) - eye));
    distances[cells[i]] = std::min(distances[cells[i]], away[i]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scene.crowd.size(); ++i) {
    if (cells[i] == distances.size() || away[i] > distances[cells[i]]) continue;
    distances[cells[i]] = -1;  // of two that are as far the first stays
    scene.crowd[kept++] = scene.crowd[i];
  }
  scene.crowd.resize(kept);
}

void build_glow(const Camera& camera, double scale, Scene& scene) {
  if (scene.theme->is_light) return;
  if (scene.lights.empty() && scene.crowd.empty()) return;
  GlowMaker glow(camera, scale, haze_of(camera), scene.scenery);
  for (const Light& light : scene.lights) glow.add(light);
  for (SceneDot& dot : scene.crowd) {
    if (heat(dot.colour) <= 0) continue;
    glow.add({dot.at, dot.at, dot.colour, scene.crowd_size});
    dot.colour = core_of(dot.colour);
  }
  glow.make(scene.glow);
}

}  // namespace physim::client
