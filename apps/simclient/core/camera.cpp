#include "simclient/core/camera.hpp"

#include <algorithm>
#include <cmath>

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

/// As near as lets each corner of the box into the middle 85 % of the view.
void Camera::fit(const Vec3d& low, const Vec3d& high) {
  target = (low + high) * 0.5;
  const double slope = std::tan(kHalfView) * 0.85, aspect = width_ / height_;
  double wanted = 4;
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner{(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
    const Vec3d way = shown(corner) - target;
    const double aside = std::max(std::abs(dot(way, right())) / aspect, std::abs(dot(way, up()))) / slope;
    wanted = std::max(wanted, aside - dot(way, forward()));
  }
  distance = std::min(wanted, kFarthest);
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
  const Vec3d way = Vec3d{point.x, target_.y + (point.y - target_.y) * stretch_, point.z} - eye_;
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
