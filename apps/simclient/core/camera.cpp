#include "simclient/core/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/angles.hpp"

namespace physim::client {
namespace {

constexpr double kHalfView = 0.4;  // half the vertical angle of view [rad]
constexpr double kNearest = 0.2, kFarthest = 2e8;

}  // namespace

void Camera::set_viewport(double width, double height) {
  width_ = std::max(width, 1.0);
  height_ = std::max(height, 1.0);
}

void Camera::orbit(double right, double down) {
  yaw = std::remainder(yaw + right, 2 * kPi);
  pitch = std::clamp(pitch + down, -1.5, 1.5);
}

void Camera::zoom(double factor) { distance = std::clamp(distance * factor, kNearest, kFarthest); }

void Camera::pan(double to_right, double to_up) {
  const double size = pixel_size(target);
  target += right() * (-to_right * size) + up() * (-to_up * size);
}

namespace {

/// A part of the screen, or of what is seen.
struct Rect {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  void add(double x, double y) {
    left = std::min(left, x), right = std::max(right, x), low = std::min(low, y), high = std::max(high, y);
  }
};

}  // namespace

/// From a distance: moves the middle of what is seen to the middle of the view. The part of the room that is used.
double Camera::centre(std::span<const Vec3d> places, double fill) {
  constexpr int kTurns = 10;
  const double room_up = std::tan(kHalfView) * fill, room_aside = room_up * width_ / height_;
  const Vec3d aside = right(), upward = up(), ahead = forward();
  /// The outermost point on one side of the view, and its depth [m].
  struct Rim {
    double at = 0, depth = 1;
  };
  const auto between = [](const Rim& a, const Rim& b) { return (a.at + b.at) / (1 / a.depth + 1 / b.depth); };
  double part = 0;
  for (int i = 0; i < kTurns; ++i) {
    Rim left{1e300}, right_rim{-1e300}, low{1e300}, high{-1e300};
    for (const Vec3d& p : places) {
      const Vec3d way = shown(p) - target;
      const double depth = dot(way, ahead) + distance;
      if (depth < 0.03 * distance) return std::numeric_limits<double>::infinity();  // behind the eye, or nearly
      const double x = dot(way, aside) / depth, y = dot(way, upward) / depth;
      if (x < left.at) left = {x, depth};
      if (x > right_rim.at) right_rim = {x, depth};
      if (y < low.at) low = {y, depth};
      if (y > high.at) high = {y, depth};
    }
    part = std::max(std::max(right_rim.at, -left.at) / room_aside, std::max(high.at, -low.at) / room_up);
    target += aside * between(left, right_rim);
    target += upward * (between(low, high) / stretch);
  }
  return part;
}

void Camera::fit(std::span<const Vec3d> places) {
  constexpr double kFill = 0.67, kAlone = 4;  // kAlone: from a single place [m]
  constexpr int kHalvings = 22;
  if (places.empty()) return;
  Vec3d low = places[0], high = low;
  for (const Vec3d& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3d middle = (low + high) * 0.5;
  const double size = length(Vec3d{high.x - low.x, (high.y - low.y) * stretch, high.z - low.z});
  target = middle;
  distance = kAlone;
  if (size < 1e-6) return;
  double near = std::log(std::max(0.1 * size, kNearest)),
         far = std::log(std::clamp(30 * size, 2 * kNearest, kFarthest));
  for (int i = 0; i < kHalvings; ++i) {
    target = middle;
    distance = std::exp(0.5 * (near + far));
    (centre(places, kFill) > 1 ? near : far) = std::log(distance);
  }
  target = middle;
  distance = std::exp(far);
  (void)centre(places, kFill);
}

double Camera::cover(std::span<const Vec3d> places) const {
  const Projector view = projector();
  Rect seen;
  for (const Vec3d& p : places)
    if (const auto at = view.project(p)) seen.add(std::clamp(at->x, 0.0, width_), std::clamp(at->y, 0.0, height_));
  return std::max({(seen.right - seen.left) / width_, (seen.high - seen.low) / height_, 0.0});
}

void Camera::stay_above(double height) {
  constexpr double kLeast = 0.004;  // above it, in distances from the target
  const double least = shown({0, height, 0}).y + kLeast * distance;
  if (eye().y >= least) return;
  const double sine = (least - target.y) / distance;
  if (sine <= 0.99) {
    pitch = std::max(pitch, std::asin(std::max(sine, -1.0)));
  } else {
    target.y += least - eye().y;
  }
}

Vec3d Camera::forward() const {
  return {std::cos(pitch) * std::cos(yaw), -std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
}
Vec3d Camera::right() const { return {-std::sin(yaw), 0, std::cos(yaw)}; }
Vec3d Camera::up() const { return cross(right(), forward()); }
Vec3d Camera::eye() const { return target - forward() * distance; }
double Camera::near_plane() const { return std::clamp(distance * 0.01, 0.02, 1e4); }

Vec3d Camera::shown(const Vec3d& point) const { return {point.x, target.y + (point.y - target.y) * stretch, point.z}; }

std::optional<Pixel> Projector::project(const Vec3d& point) const {
  const Vec3d way = from_eye(point);
  const double depth = dot(way, forward_);
  if (depth < near_) return std::nullopt;
  const double scale = focal_ / depth;
  return Pixel{x_ + dot(way, right_) * scale, y_ - dot(way, up_) * scale};
}

Projector Camera::projector() const {
  Projector out;
  out.target_ = target, out.stretch_ = stretch, out.eye_ = eye();
  out.forward_ = forward(), out.right_ = right(), out.up_ = up();
  out.near_ = near_plane(), out.focal_ = focal();
  out.x_ = width_ / 2, out.y_ = height_ / 2;
  return out;
}

std::optional<Pixel> Camera::project(const Vec3d& point) const { return projector().project(point); }

Ray Camera::ray(const Pixel& pixel) const {
  const double scale = 1 / focal();
  const Vec3d way = forward() + right() * ((pixel.x - width_ / 2) * scale) + up() * ((height_ / 2 - pixel.y) * scale);
  return {eye(), normalized(way)};
}

double Camera::focal() const { return height_ / (2 * std::tan(kHalfView)); }

double Camera::pixel_size(const Vec3d& point) const {
  return std::max(dot(shown(point) - eye(), forward()), near_plane()) / focal();
}

Mat4 Camera::matrix() const {
  const Vec3d r = right(), u = up(), f = forward();
  const double n = near_plane(), far = std::max(distance * 1e4, 1e5);
  const double sy = 1 / std::tan(kHalfView), sx = sy * height_ / width_;
  const double a = (far + n) / (far - n), b = -2 * far * n / (far - n);
  const auto g = [](double x) { return static_cast<float>(x); };
  return {g(sx * r.x), g(sy * u.x), g(a * f.x), g(f.x), g(sx * r.y), g(sy * u.y), g(a * f.y), g(f.y),
          g(sx * r.z), g(sy * u.z), g(a * f.z), g(f.z), 0,           0,           g(b),       0};
}

std::optional<Vec3d> Camera::at_height(const Pixel& pixel, double height) const {
  const Ray line = ray(pixel);
  const double drop = line.direction.y;
  if (std::abs(drop) < 1e-9) return std::nullopt;
  const double way = (shown({0, height, 0}).y - line.origin.y) / drop;
  if (!(way > 0 && way < 1e9)) return std::nullopt;
  Vec3d point = line.origin + line.direction * way;
  point.y = height;
  return point;
}

}  // namespace physim::client
