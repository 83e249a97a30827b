#include "simclient/core/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "simclient/core/folder.hpp"

namespace physim::client {
namespace {

// Lengths in diameters where none is given, and of fins across.
constexpr double kBulletLength = 3.6, kShellLength = 4.6, kRocketLength = 14, kFins = 2.6;
constexpr double kArrowLength = 0.75, kArrowFins = 0.04;  // [m]

bool between(double x, double low, double high) { return x >= low && x <= high; }

/// The sides of a box of this mass with these moments; nothing if there is none, or if it is as high as it is long.
std::optional<Vec3d> box_of(const Inertia& inertia, double mass) {
  const Vec3d& i = inertia.moments;
  if (!(std::min({i.x, i.y, i.z}) > 0) || !(mass > 0) || !std::isfinite(mass)) return std::nullopt;
  const Vec3d squares{i.y + i.z - i.x, i.x + i.z - i.y, i.x + i.y - i.z};
  if (!(std::min({squares.x, squares.y, squares.z}) > 0)) return std::nullopt;
  if (std::max({i.x, i.y, i.z}) < 1.01 * std::min({i.x, i.y, i.z})) return std::nullopt;
  return Vec3d{std::sqrt(6 / mass * squares.x), std::sqrt(6 / mass * squares.y), std::sqrt(6 / mass * squares.z)};
}

BodyLook slender(BodyShape form, const ProjectileDef& p) {
  const double wide = form == BodyShape::rocket ? kFins * p.diameter : p.diameter;
  const double usual = form == BodyShape::bullet  ? kBulletLength
                       : form == BodyShape::shell ? kShellLength
                                                  : kRocketLength;
  return {form, {p.length > 0 ? p.length : usual * p.diameter, wide, wide}};
}

/// A word that says what it is.
std::optional<BodyShape> form_by_name(std::string_view name) {
  constexpr std::pair<const char*, BodyShape> kWords[] = {
      {"arrow", BodyShape::arrow},         {"rocket", BodyShape::rocket},
      {"shuttle", BodyShape::shuttlecock}, {"brick", BodyShape::brick},
      {"golf", BodyShape::golf_ball},      {"baseball", BodyShape::baseball},
      {"football", BodyShape::football},   {"artillery", BodyShape::shell},
      {"bullet", BodyShape::bullet},       {"tennis_ball", BodyShape::tennis_ball}};
  for (const auto& [word, form] : kWords)
    if (passes_filter(name, word)) return form;
  return std::nullopt;
}

/// Balls of sports have sizes and masses by their rules.
std::optional<BodyShape> form_of_ball(const ProjectileDef& p) {
  if (between(p.diameter, 0.0415, 0.0435) && between(p.mass, 0.040, 0.050)) return BodyShape::golf_ball;
  if (between(p.diameter, 0.070, 0.077) && between(p.mass, 0.130, 0.155)) return BodyShape::baseball;
  if (between(p.diameter, 0.063, 0.069) && between(p.mass, 0.052, 0.062)) return BodyShape::tennis_ball;
  if (between(p.diameter, 0.21, 0.225) && between(p.mass, 0.39, 0.46)) return BodyShape::football;
  return std::nullopt;
}

bool has_nose(const DragDef& drag) {
  return drag.ballistic_coefficient > 0 || !drag.bands.empty() ||
         (drag.table != DragTable::constant && drag.table != DragTable::sphere && drag.table != DragTable::custom);
}

BodyShape form_of(const ProjectileDef& p) {
  constexpr double kCalibre = 0.0201;  // of the largest bullets [m]
  constexpr double kOfArrows = 450;    // mass over area, more than a bullet of lead has [kg/m^2]
  const double area = kPi / 4 * p.diameter * p.diameter;
  if (!p.motor.thrust.empty()) return BodyShape::rocket;
  if (const auto ball = form_of_ball(p)) return *ball;
  const bool is_shaft = p.drag.table == DragTable::constant && p.drag.coefficient >= 1 && p.diameter < 0.015;
  if (is_shaft && p.mass > kOfArrows * area) return BodyShape::arrow;
  const Vec3d& moments = p.inertia.moments;
  if (box_of(p.inertia, p.mass) && std::abs(moments.y - moments.z) > 0.01 * moments.y) return BodyShape::brick;
  const bool is_long = has_nose(p.drag) || p.twist != 0 || p.length > 1.5 * p.diameter;
  if (is_long) return p.diameter < kCalibre ? BodyShape::bullet : BodyShape::shell;
  return form_by_name(p.name).value_or(BodyShape::ball);
}

}  // namespace

BodyLook look_of(const ProjectileDef& p) {
  const BodyShape form = form_of(p);
  const Vec3d round{p.diameter, p.diameter, p.diameter};
  switch (form) {
    case BodyShape::bullet:
    case BodyShape::shell:
    case BodyShape::rocket: return slender(form, p);
    case BodyShape::arrow: return {form, {p.length > 0 ? p.length : kArrowLength, kArrowFins, kArrowFins}};
    case BodyShape::shuttlecock: return {form, {1.3 * p.diameter, p.diameter, p.diameter}};
    case BodyShape::brick:
      return {form, box_of(p.inertia, p.mass).value_or(Vec3d{2 * p.diameter, 0.5 * p.diameter, p.diameter})};
    case BodyShape::ball:
    case BodyShape::golf_ball:
    case BodyShape::baseball:
    case BodyShape::football:
    case BodyShape::tennis_ball: break;
  }
  return {form, round};
}

// -------------------------------------------------------------------------------------------------------------- meshes
namespace {

constexpr int kSides = 20, kRings = 14;
constexpr Colour kOfTrack = 0xFFFFFFFE;  // opacity 254
constexpr Colour kCopper = 0xC07A4AFF, kBrass = 0xD2B15CFF, kOlive = 0x6E7550FF, kSteel = 0xA8B0B8FF,
                 kCharcoal = 0x3A3D42FF;
constexpr Colour kWhite = 0xF4F4F0FF, kDimple = 0xD2D2CEFF, kRed = 0xC23B33FF, kFelt = 0xD6E34AFF, kCork = 0xC9A06EFF,
                 kClay = 0xA5604AFF;

using Mesh = std::vector<LitVertex>;

/// A place on a contour about the x axis.
struct Contour {
  double x = 0, radius = 0;
  Colour colour = kWhite;  // of the band up to the next
};

Vec3d about_axis(double x, double radius, double angle) {
  return {x, radius * std::cos(angle), radius * std::sin(angle)};
}

/// A contour that is turned about the x axis, each band with a slope of its own.
void turn(Mesh& mesh, std::initializer_list<Contour> contour) {
  const Contour* from = contour.begin();
  for (const Contour* to = from + 1; to != contour.end(); from = to++) {
    const Vec3d slope = normalized(Vec3d{from->radius - to->radius, to->x - from->x, 0});
    for (int i = 0; i < kSides; ++i) {
      const double a = 2 * kPi * i / kSides, b = 2 * kPi * (i + 1) / kSides;
      const auto corner = [&](const Contour& rim, double angle) {
        return lit_vertex(about_axis(rim.x, rim.radius, angle), about_axis(slope.x, slope.y, angle), from->colour);
      };
      for (const LitVertex& each :
           {corner(*from, a), corner(*to, a), corner(*to, b), corner(*from, a), corner(*to, b), corner(*from, b)})
        mesh.push_back(each);
    }
  }
}

/// Flat fins about the x axis: from the shaft at a radius out to the rim of the box.
void add_fins(Mesh& mesh, int count, double from, double to, double radius, Colour colour) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count + kPi / 6;
    const Vec3d normal = about_axis(0, 1, angle + kPi / 2);
    const double slant = 0.45 * (to - from);
    const Vec3d corners[] = {about_axis(to, radius, angle), about_axis(to - slant, 0.5, angle),
                             about_axis(from, 0.5, angle), about_axis(from, radius, angle)};
    for (const std::size_t k : {0, 1, 2, 0, 2, 3})
      mesh.push_back(lit_vertex(corners[k], normal, i == 0 ? kOfTrack : colour));
  }
}

/// A ball whose colour is a function of the direction.
template <class ColourAt>
Mesh ball_of(const ColourAt& colour_at, int rings = 2 * kRings, int sides = 2 * kSides) {
  Mesh mesh;
  const auto at = [&](int ring, int side) {
    const double up = kPi * ring / rings, around = 2 * kPi * side / sides;
    return Vec3d{std::sin(up) * std::cos(around), std::cos(up), std::sin(up) * std::sin(around)};
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const Vec3d corners[] = {at(ring, side), at(ring + 1, side), at(ring + 1, side + 1), at(ring, side + 1)};
      const Vec3d middle = normalized(corners[0] + corners[1] + corners[2] + corners[3]);
      for (const std::size_t k : {0, 1, 2, 0, 2, 3})
        mesh.push_back(lit_vertex(corners[k] * 0.5, corners[k], colour_at(middle)));
    }
  return mesh;
}

/// The seam of a baseball and of a tennis ball: where this is 0.
double seam(const Vec3d& d) { return d.x * d.x - d.y * d.y + 1.4 * d.z * (1 - d.z * d.z); }

/// The cosine between a direction and the nearest corner of an icosahedron, where a football's black patches are.
double nearest_corner(const Vec3d& d) {
  const double g = (1 + std::sqrt(5.0)) / 2, size = std::sqrt(1 + g * g);
  double most = 0;
  for (const double s : {-1.0, 1.0})
    for (const Vec3d& corner : {Vec3d{0, s, g}, Vec3d{s, g, 0}, Vec3d{g, 0, s}})
      most = std::max(most, std::abs(dot(d, corner)) / size);
  return most;
}

Mesh box() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      const auto turned = [axis](double a, double b, double c) {
        return axis == 0 ? Vec3d{a, b, c} : axis == 1 ? Vec3d{c, a, b} : Vec3d{b, c, a};
      };
      const Colour colour = axis == 0 && side > 0 ? kOfTrack : kClay;  // its front
      const Vec3d corners[] = {turned(side, -0.5, -0.5), turned(side, 0.5, -0.5), turned(side, 0.5, 0.5),
                               turned(side, -0.5, 0.5)};
      for (const std::size_t k : {0, 1, 2, 0, 2, 3})
        mesh.push_back(lit_vertex(corners[k], turned(2 * side, 0, 0), colour));
    }
  return mesh;
}

Mesh mesh_of_bullet() {
  Mesh mesh;
  turn(mesh, {{-0.5, 0, kCharcoal},
              {-0.5, 0.4, kCopper},
              {-0.34, 0.5, kCopper},
              {-0.12, 0.5, kOfTrack},
              {-0.05, 0.5, kCopper},
              {0.1, 0.485, kCopper},
              {0.25, 0.4, kCopper},
              {0.38, 0.26, kCopper},
              {0.46, 0.12, kCharcoal},
              {0.5, 0, kCharcoal}});
  return mesh;
}

/// With a driving band, and a fuse at its nose.
Mesh mesh_of_shell() {
  Mesh mesh;
  turn(mesh, {{-0.5, 0, kCharcoal},
              {-0.5, 0.42, kOlive},
              {-0.4, 0.49, kOlive},
              {-0.34, 0.5, kBrass},
              {-0.28, 0.5, kOlive},
              {-0.02, 0.49, kOfTrack},
              {0.04, 0.48, kOlive},
              {0.2, 0.42, kOlive},
              {0.34, 0.3, kSteel},
              {0.45, 0.14, kSteel},
              {0.5, 0.03, kSteel},
              {0.5, 0, kSteel}});
  return mesh;
}

Mesh mesh_of_arrow() {
  Mesh mesh;
  turn(mesh,
       {{-0.5, 0.16, kOfTrack}, {-0.47, 0.16, kCharcoal}, {0.44, 0.16, kSteel}, {0.46, 0.2, kSteel}, {0.5, 0, kSteel}});
  add_fins(mesh, 3, -0.45, -0.33, 0.16, kWhite);
  return mesh;
}

Mesh mesh_of_rocket() {
  Mesh mesh;
  turn(mesh, {{-0.5, 0, kCharcoal},
              {-0.5, 0.13, kCharcoal},
              {-0.46, 0.19, kWhite},
              {0.1, 0.19, kOfTrack},
              {0.16, 0.19, kWhite},
              {0.28, 0.19, kRed},
              {0.38, 0.155, kRed},
              {0.46, 0.08, kRed},
              {0.5, 0, kRed}});
  add_fins(mesh, 4, -0.5, -0.3, 0.18, kRed);
  return mesh;
}

Mesh mesh_of_shuttlecock() {
  Mesh mesh;
  turn(mesh, {{-0.5, 0.5, kWhite},
              {-0.1, 0.34, kOfTrack},
              {-0.04, 0.31, kWhite},
              {0.25, 0.2, kCork},
              {0.36, 0.2, kCork},
              {0.46, 0.13, kCork},
              {0.5, 0, kCork}});
  return mesh;
}

/// Rows of spots for dimples, and a stripe in the colour of its track.
Colour colour_of_golf_ball(const Vec3d& d) {
  if (std::abs(d.y) < 0.06) return kOfTrack;
  const double row = std::acos(std::clamp(d.y, -1.0, 1.0)) * 9 / kPi;
  const double spot = std::atan2(d.z, d.x) * 8 / kPi * std::max(std::sqrt(1 - d.y * d.y), 0.2);
  return (std::lround(row) + std::lround(spot)) % 2 == 0 ? kWhite : kDimple;
}

Mesh make_mesh(BodyShape shape) {
  switch (shape) {
    case BodyShape::ball: break;
    case BodyShape::bullet: return mesh_of_bullet();
    case BodyShape::shell: return mesh_of_shell();
    case BodyShape::arrow: return mesh_of_arrow();
    case BodyShape::rocket: return mesh_of_rocket();
    case BodyShape::shuttlecock: return mesh_of_shuttlecock();
    case BodyShape::golf_ball: return ball_of(colour_of_golf_ball);
    case BodyShape::baseball: return ball_of([](const Vec3d& d) { return std::abs(seam(d)) < 0.13 ? kRed : kWhite; });
    case BodyShape::tennis_ball:
      return ball_of([](const Vec3d& d) { return std::abs(seam(d)) < 0.12 ? kWhite : kFelt; });
    case BodyShape::football:
      return ball_of([](const Vec3d& d) { return nearest_corner(d) > 0.93 ? kCharcoal : kWhite; });
    case BodyShape::brick: return box();
  }
  return {};
}

}  // namespace

std::span<const LitVertex> mesh_of(BodyShape shape) {
  static const auto* const meshes = new std::array<Mesh, kBodyShapes>([] {
    std::array<Mesh, kBodyShapes> all;
    for (std::size_t i = 0; i < kBodyShapes; ++i) all[i] = make_mesh(static_cast<BodyShape>(i));
    return all;
  }());
  PHYSIM_ASSERT(static_cast<std::size_t>(shape) < kBodyShapes);
  return (*meshes)[static_cast<std::size_t>(shape)];
}

Quatd turn_about(const Vec3d& axis, double angle) {
  const Vec3d part = axis * std::sin(angle / 2);
  return {std::cos(angle / 2), part.x, part.y, part.z};
}

Quatd nose_along(const Vec3d& way) {
  const double size = length(way);
  if (!(size > 0)) return {};
  const double up = std::asin(std::clamp(way.y / size, -1.0, 1.0)), right = std::atan2(way.z, way.x);
  return turn_about({0, 1, 0}, -right) * turn_about({0, 0, 1}, up);
}

Vec3d spin_in_world(const Launch& launch) {
  const LaunchSpin& spin = launch.spin;
  const double azimuth = launch.velocity ? std::atan2(launch.velocity->z, launch.velocity->x) : launch.azimuth;
  const double up = launch.velocity || launch.sight.zero_range > 0 ? 0 : launch.elevation;
  const Vec3d along{std::cos(up), std::sin(up), 0}, above{-std::sin(up), std::cos(up), 0};
  const Vec3d in_plane = Vec3d{0, 0, 1} * spin.backspin - above * spin.sidespin + along * spin.gyrospin;
  return rotate(turn_about({0, 1, 0}, -azimuth), in_plane);
}

}  // namespace physim::client
