#include "simclient/core/scenery.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <unordered_map>

#include "math/angles.hpp"
#include "physim/scene.hpp"
#include "simclient/core/plane_axes.hpp"

namespace physim::client {
namespace {

constexpr double kSmooth = 0.8;         // cosine of the largest angle between faces that are one round surface
constexpr std::size_t kMostNames = 40;  // more would hide each other
constexpr std::size_t kMostEdges = 4000;
constexpr int kSidesOfTarget = 48;
constexpr Colour kTerrain = 254;  // opacity of what has lines of equal height
constexpr double kAnyReach = 0;   // without planes nothing depends on it

struct Face {
  Vec3d corners[3], normal;
  Colour colour = 0;
};

/// Corners that faces share, by their place.
struct PlaceHash {
  std::size_t operator()(const Vec3d& p) const {
    const std::hash<double> hash;
    return hash(p.x) ^ (hash(p.y) * 0x9E3779B97F4A7C15U) ^ (hash(p.z) * 0xC2B2AE3D27D4EB4FU);
  }
};
struct SamePlace {
  bool operator()(const Vec3d& a, const Vec3d& b) const { return a == b; }
};

/// Takes what is drawn, thing by thing.
class Gatherer final : public SceneCanvas {
 public:
  Gatherer(const physim::Scene& scene, double time, std::optional<double> ground, Scenery& into)
      : scene_(scene), time_(time), ground_(ground), into_(into) {}

  void begin(InstanceId thing) override {
    finish();
    id_ = thing;
    thing_ = scene_.instance(thing);
  }
  void material(MaterialId of) override { colour_ = colour_of_material(scene_.material(of).name); }
  void line(const Vec3d&, const Vec3d&, SceneInk) override {}
  void text(const Vec3d&, std::string_view) override {}
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, SceneInk ink) override {
    const Vec3d facing = cross(b - a, c - a);
    if (!(length(facing) > 0)) return;
    is_sensor_ = ink == SceneInk::sensor;
    faces_.push_back({{a, b, c}, normalized(facing), is_sensor_ ? faded(colour_, 0.3) : colour_});
  }

  /// The faces of the thing become vertices.
  void finish() {
    if (thing_ && !faces_.empty()) add_thing();
    faces_.clear();
    thing_.reset();
  }
  [[nodiscard]] bool has_planes() const { return has_planes_; }
  [[nodiscard]] std::vector<SceneryPart> take_parts() { return std::move(parts_); }
  /// Sensors come last.
  void end() {
    finish();
    into_.solid = into_.vertices.size();
    into_.vertices.insert(into_.vertices.end(), sensors_.begin(), sensors_.end());
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (of_sensors_[i]) parts_[i].vertex += into_.solid;
  }

 private:
  void add_thing() {
    const auto shape = scene_.info(thing_->shape);
    const bool is_plane = faces_.size() == 2 && shape && shape->triangles == 0;  // else a mesh of two triangles
    has_planes_ |= is_plane;
    const std::vector<LitVertex>& vertices = is_sensor_ ? sensors_ : into_.vertices;
    SceneryPart part{id_,
                     scene_.state(id_, time_).value_or(MotionState{}),
                     vertices.size(),
                     0,
                     into_.edges.size(),
                     0,
                     into_.names.size(),
                     0};
    if (into_.vertices.empty() && sensors_.empty()) into_.origin = faces_[0].corners[0];
    Vec3d low = faces_[0].corners[0], high = low;
    for (const Face& face : faces_)
      for (const Vec3d& p : face.corners) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    if (!is_plane) include(low, high);
    const auto disc = is_plane || is_sensor_ ? std::nullopt : target_disc();
    if (disc) make_round(*disc);
    if (is_terrain())
      for (Face& face : faces_) face.colour = (face.colour & ~0xFFU) | kTerrain;
    const Vec3d top = is_plane ? thing_->transform.position : Vec3d{(low.x + high.x) / 2, high.y, (low.z + high.z) / 2};
    if (!thing_->name.empty() && into_.names.size() < kMostNames) into_.names.push_back({top, thing_->name});
    add_faces();
    if (disc) add_rings(*disc), add_stand(*disc);
    if (!is_plane && !is_sensor_ && faces_.size() < kMostEdges) add_edges();
    part.vertices = vertices.size() - part.vertex;
    part.edges = into_.edges.size() - part.edge;
    part.names = into_.names.size() - part.name;
    if (std::holds_alternative<AtRest>(thing_->motion)) return;
    parts_.push_back(part);
    of_sensors_.push_back(is_sensor_);
  }

  struct Disc {
    Vec3d middle, axis;
    double radius = 0, half = 0;  // half: of its height [m]
  };
  /// A target is a flat disc with that word in its name.
  [[nodiscard]] std::optional<Disc> target_disc() const {
    if (thing_->name.find("target") == std::string::npos) return std::nullopt;
    Disc disc{thing_->transform.position, rotate(thing_->transform.rotation, Vec3d{0, 1, 0})};
    for (const Face& face : faces_)
      for (const Vec3d& p : face.corners) {
        const Vec3d way = p - disc.middle;
        disc.half = std::max(disc.half, std::abs(dot(way, disc.axis)));
        disc.radius = std::max(disc.radius, length(way - disc.axis * dot(way, disc.axis)));
      }
    return disc.half < kFlatDisc * disc.radius ? std::optional(disc) : std::nullopt;
  }

  /// Its faces anew, with more corners than things have for debugging.
  void make_round(const Disc& disc) {
    const PlaneAxes plane = axes_across(disc.axis);
    const Colour colour = faces_[0].colour;
    faces_.clear();
    const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
      const Vec3d middle = (a + b + c) * (1.0 / 3) - disc.middle, facing = cross(b - a, c - a);
      faces_.push_back({{a, b, c}, normalized(dot(facing, middle) < 0 ? -facing : facing), colour});
    };
    for (int i = 0; i < kSidesOfTarget; ++i) {
      const auto rim = [&](int k, double side) {
        const double angle = 2 * kPi * (k % kSidesOfTarget) / kSidesOfTarget;
        return disc.middle + disc.axis * (side * disc.half) +
               (plane.right * std::cos(angle) + plane.up * std::sin(angle)) * disc.radius;
      };
      for (const double side : {-1.0, 1.0})
        add(disc.middle + disc.axis * (side * disc.half), rim(i, side), rim(i + 1, side));
      add(rim(i, -1), rim(i + 1, -1), rim(i + 1, 1));
      add(rim(i, -1), rim(i + 1, 1), rim(i, 1));
    }
  }

  /// Two posts from the rim of a target that stands upright, down to a thing or to the ground.
  void add_stand(const Disc& disc) {
    constexpr double kAside = 0.5, kWidth = 0.035;  // parts of the radius
    constexpr Colour kWood = 0x8A6A45FF;
    if (std::abs(disc.axis.y) > 0.5 || !std::holds_alternative<AtRest>(thing_->motion)) return;
    const PlaneAxes plane = axes_across(disc.axis);
    const double below_rim = std::sqrt(1 - kAside * kAside) * disc.radius;
    for (const double side : {-kAside, kAside}) {
      const Vec3d top = disc.middle + plane.right * (side * disc.radius) - plane.up * (below_rim + 0.01 * disc.radius);
      const SceneHit hit = scene_.first_hit({.from = top, .to = top - Vec3d{0, 1e3 * disc.radius, 0}, .time = time_},
                                            {.sensors = false});
      const std::optional<double> foot = hit ? std::optional(hit.position.y) : ground_;
      if (foot && *foot < top.y) add_post(top + plane.up * (0.02 * disc.radius), *foot, kWidth * disc.radius, kWood);
    }
  }
  void add_post(const Vec3d& top, double foot, double half_width, Colour colour) {
    constexpr double kCorners[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (int i = 0; i < 4; ++i) {
      const auto corner = [&](int k, double y) {
        return Vec3d{top.x + kCorners[k][0] * half_width, y, top.z + kCorners[k][1] * half_width};
      };
      const Vec3d out{(kCorners[i][0] + kCorners[i + 1][0]) / 2, 0, (kCorners[i][1] + kCorners[i + 1][1]) / 2};
      for (const Vec3d& p : {corner(i, top.y), corner(i + 1, top.y), corner(i + 1, foot), corner(i, top.y),
                             corner(i + 1, foot), corner(i, foot)})
        into_.vertices.push_back(lit_vertex(p - into_.origin, out, colour));
    }
  }

  /// Rings of a target: before both faces, from the rim to the middle.
  void add_rings(const Disc& disc) {
    constexpr double kBefore = 0.002;  // part of the radius
    constexpr int kRings = 5, kSides = kSidesOfTarget;
    constexpr Colour kColours[kRings] = {0xF2F2EEFF, 0x2B2E33FF, 0x3B8FC2FF, 0xC9403AFF, 0xF0CF3AFF};
    const PlaneAxes plane = axes_across(disc.axis);
    for (const double side : {-1.0, 1.0})
      for (int ring = 0; ring < kRings; ++ring)
        for (int i = 0; i < kSides; ++i) {
          const auto at = [&](int rim, int k) {
            const double angle = 2 * kPi * k / kSides, r = 0.98 * disc.radius * (kRings - rim) / kRings;
            return disc.middle + disc.axis * (side * (disc.half + kBefore * disc.radius)) +
                   (plane.right * std::cos(angle) + plane.up * std::sin(angle)) * r;
          };
          const Vec3d corners[] = {at(ring, i), at(ring, i + 1),     at(ring + 1, i + 1),
                                   at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)};
          for (const Vec3d& p : corners)
            into_.vertices.push_back(lit_vertex(p - into_.origin, disc.axis * side, kColours[ring]));
        }
  }

  /// Many faces that all look up: a height field or a mesh of one.
  [[nodiscard]] bool is_terrain() const {
    constexpr std::size_t kMany = 50;
    return !is_sensor_ && faces_.size() > kMany &&
           std::ranges::all_of(faces_, [](const Face& face) { return std::abs(face.normal.y) > 0.1; });
  }

  static Colour darker(Colour colour) {
    Colour out = colour & 0xFF;
    for (const int shift : {8, 16, 24}) out |= ((colour >> shift & 0xFF) * 2 / 5) << shift;
    return out;
  }

  /// Those that are no part of a round surface.
  void add_edges() {
    std::map<std::array<double, 6>, std::vector<const Face*>> faces;  // at each edge
    for (const Face& face : faces_)
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<double, 3> a = {face.corners[i].x, face.corners[i].y, face.corners[i].z};
        const Vec3d& next = face.corners[(i + 1) % 3];
        std::array<double, 3> b = {next.x, next.y, next.z};
        if (b < a) std::swap(a, b);
        faces[{a[0], a[1], a[2], b[0], b[1], b[2]}].push_back(&face);
      }
    for (const auto& [ends, at] : faces) {
      const bool is_round = at.size() == 2 && dot(at[0]->normal, at[1]->normal) > kSmooth;
      if (is_round || into_.edges.size() >= kMostEdges) continue;
      into_.edges.push_back({{ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}, darker(at[0]->colour)});
    }
  }

  void include(const Vec3d& low, const Vec3d& high) {
    if (!into_.has_size) into_.low = low, into_.high = high, into_.has_size = true;
    into_.low = {std::min(low.x, into_.low.x), std::min(low.y, into_.low.y), std::min(low.z, into_.low.z)};
    into_.high = {std::max(high.x, into_.high.x), std::max(high.y, into_.high.y), std::max(high.z, into_.high.z)};
  }

  void add_faces() {
    std::unordered_map<Vec3d, std::vector<std::uint32_t>, PlaceHash, SamePlace> around;
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
      for (const Vec3d& p : faces_[i].corners) around[p].push_back(i);
    std::vector<LitVertex>& to = is_sensor_ ? sensors_ : into_.vertices;
    for (const Face& face : faces_)
      for (const Vec3d& p : face.corners) {
        Vec3d normal;
        for (const std::uint32_t i : around[p])
          if (dot(faces_[i].normal, face.normal) > kSmooth) normal += faces_[i].normal;
        to.push_back(lit_vertex(p - into_.origin, normalized(normal), face.colour));
      }
  }

  const physim::Scene& scene_;
  const double time_;
  const std::optional<double> ground_;
  Scenery& into_;
  InstanceId id_;
  std::optional<InstanceDef> thing_;
  std::vector<SceneryPart> parts_;
  std::vector<bool> of_sensors_;  // of each part
  std::vector<Face> faces_;
  std::vector<LitVertex> sensors_;
  Colour colour_ = 0;  // of what is drawn
  bool is_sensor_ = false, has_planes_ = false;
};

/// A version that no scenery has had: one renderer draws the sceneries of the client and of the gallery's pictures.
std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

/// From where each thing was when all was made, so that no errors add up.
void SceneryMaker::move_things(const physim::Scene& scene, double time) {
  time_ = time;
  scenery_.version = next_version();
  for (const SceneryPart& part : parts_) {
    const std::optional<MotionState> now = scene.state(part.thing, time);
    if (!now) continue;
    const Quatd turn = now->rotation * conjugate(part.made.rotation);
    const auto moved = [&](const Vec3d& p) { return now->position + rotate(turn, p - part.made.position); };
    const auto set = [](float(&to)[3], const Vec3d& v) {
      to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z);
    };
    for (std::size_t i = part.vertex; i < part.vertex + part.vertices; ++i) {
      const LitVertex& was = made_.vertices[i];
      set(scenery_.vertices[i].at, moved(scenery_.origin + Vec3d{was.at[0], was.at[1], was.at[2]}) - scenery_.origin);
      set(scenery_.vertices[i].normal, rotate(turn, Vec3d{was.normal[0], was.normal[1], was.normal[2]}));
    }
    for (std::size_t i = part.edge; i < part.edge + part.edges; ++i)
      scenery_.edges[i] = {moved(made_.edges[i].a), moved(made_.edges[i].b), made_.edges[i].colour};
    for (std::size_t i = part.name; i < part.name + part.names; ++i)
      scenery_.names[i].at = made_.names[i].at + (now->position - part.made.position);
  }
}

Colour colour_of_material(const std::string& name) {
  constexpr std::pair<const char*, Colour> kKnown[] = {
      {"water", 0x2E6E8EFF},    {"fir", 0xC9A06EFF},   {"oak", 0x9C6E42FF},    {"wood", 0xB08856FF},
      {"concrete", 0xA3A39DFF}, {"steel", 0x7E8B98FF}, {"armour", 0x6C7683FF}, {"aluminium", 0xB9C1C9FF},
      {"soil", 0x7D664CFF},     {"sand", 0xC4B088FF},  {"grass", 0x63824EFF},  {"rock", 0x857F78FF},
      {"ice", 0xB5D3E2FF},      {"brick", 0xA5604AFF}, {"rubber", 0x4A4A4EFF}, {"clay", 0xAD7A55FF},
  };
  for (const auto& [part, colour] : kKnown)
    if (name.find(part) != name.npos) return colour;
  if (name.empty()) return 0x95A1ADFF;
  constexpr Colour kOthers[] = {0x4F8464FF, 0xA4695DFF, 0x657CA3FF, 0x9C8B58FF, 0x806896FF};
  std::size_t sum = 0;
  for (const char c : name) sum += static_cast<unsigned char>(c);
  return kOthers[sum % std::size(kOthers)];
}

const Scenery& SceneryMaker::make(const physim::Scene* scene, std::uint64_t version, double time, double reach,
                                  std::optional<double> ground) {
  if (scene == nullptr) {
    if (!scenery_.is_empty()) scenery_ = Scenery{.version = next_version()};
    is_made_ = false;
    return scenery_;
  }
  const bool is_as_before =
      is_made_ && made_at_ == version && changes_ == scene->changes() && (reach_ == reach || reach_ == kAnyReach);
  if (is_as_before) {
    if (time_ != time && scene->has_motion()) move_things(*scene, time);
    return scenery_;
  }
  scenery_ = Scenery{.version = next_version()};
  is_made_ = true, made_at_ = version, changes_ = scene->changes(), time_ = time, reach_ = reach;
  Gatherer gatherer(*scene, time, ground, scenery_);
  scene->draw(gatherer, {.plane_faces = true, .time = time, .plane_size = reach});
  gatherer.end();
  if (!gatherer.has_planes()) reach_ = kAnyReach;
  parts_ = gatherer.take_parts();
  made_ = scene->has_motion() ? scenery_ : Scenery{};
  return scenery_;
}

}  // namespace physim::client
