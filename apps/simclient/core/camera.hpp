// Camera: looks at a point of the scene from a distance, in perspective. Pixels have their origin at the top left.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "physim/math.hpp"

namespace physim::client {

/// A point on the screen [pixels].
struct Pixel {
  double x = 0, y = 0;
};

/// A half-line out of the eye.
struct Ray {
  Vec3d origin, direction;
};

enum class CameraMode {
  orbit,   // about a point that stays
  follow,  // about a projectile
  side,    // from the right of the plane of fire
};

/// Column-major, as OpenGL reads it.
using Mat4 = std::array<float, 16>;

/// Projects many points through one camera, whose directions are computed once.
class Projector {
 public:
  [[nodiscard]] std::optional<Pixel> project(const Vec3d& point) const;
  /// Distance of a drawn point from the eye along the view [m].
  [[nodiscard]] double depth(const Vec3d& point) const { return dot(from_eye(point), forward_); }

 private:
  [[nodiscard]] Vec3d from_eye(const Vec3d& point) const {
    return Vec3d{point.x, target_.y + (point.y - target_.y) * stretch_, point.z} - eye_;
  }

  friend class Camera;
  Vec3d target_, eye_, forward_, right_, up_;
  double stretch_ = 1, near_ = 0, focal_ = 1, x_ = 0, y_ = 0;
};

class Camera {
 public:
  CameraMode mode = CameraMode::orbit;
  Vec3d target{12, 2, 0};
  double yaw = 0;        // of the view, from x towards z [rad]
  double pitch = 0.25;   // down [rad]
  double distance = 32;  // of the eye from the target [m]
  double stretch = 1;    // heights are drawn so many times as large, from the target up and down

  void set_viewport(double width, double height);
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  void orbit(double right, double down);  // [rad]
  void zoom(double factor);
  void pan(double right, double up);  // [pixels]
  /// Looks at all of these places, so that they cover two thirds of the view's width or height.
  void fit(std::span<const Vec3d> places);
  /// The part of the view's width or height, whichever is larger, that places cover.
  [[nodiscard]] double cover(std::span<const Vec3d> places) const;
  /// Raises the eye, by a steeper look, if it is not above a height.
  void stay_above(double height);

  /// Where a point is drawn: its height is stretched.
  [[nodiscard]] Vec3d shown(const Vec3d& point) const;
  /// A way in the world that is drawn as this one.
  [[nodiscard]] Vec3d drawn_as(const Vec3d& way) const { return {way.x, way.y / stretch, way.z}; }
  [[nodiscard]] Vec3d eye() const;
  [[nodiscard]] Vec3d forward() const;
  [[nodiscard]] Vec3d right() const;
  [[nodiscard]] Vec3d up() const;
  /// Where a point is seen; nothing behind the eye.
  [[nodiscard]] std::optional<Pixel> project(const Vec3d& point) const;
  [[nodiscard]] Projector projector() const;
  /// Among the points as they are drawn.
  [[nodiscard]] Ray ray(const Pixel& pixel) const;
  /// Where a pixel meets a height, within sight.
  [[nodiscard]] std::optional<Vec3d> at_height(const Pixel& pixel, double height) const;
  /// The size of a pixel at a point [m].
  [[nodiscard]] double pixel_size(const Vec3d& point) const;
  /// The size of a metre at a distance of a metre [pixels].
  [[nodiscard]] double focal() const;
  /// Takes positions as they are drawn, relative to the eye, to clip space.
  [[nodiscard]] Mat4 matrix() const;
  [[nodiscard]] double near_plane() const;

 private:
  double centre(std::span<const Vec3d> places, double fill);

  double width_ = 1280, height_ = 720;
};

}  // namespace physim::client
