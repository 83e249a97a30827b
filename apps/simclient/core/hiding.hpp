// A coarse depth buffer of the things of a scene: it says which lights they hide from the eye.
#pragma once

#include <vector>

#include "simclient/core/camera.hpp"
#include "simclient/core/scenery.hpp"

namespace physim::client {

/// For each cell of the view the nearness of the things that cover its middle, 1 over the distance along the view
/// [1/m], which is linear on the screen. Of a slanted face it is that of the cell's farthest corner, so that what lies
/// on a thing is not hidden by it.
class HidingMap {
 public:
  HidingMap(const Camera& camera, double cell);
  void add(const Scenery& scenery);
  /// True if a thing covers a point at a pixel [pixels] with this nearness [1/m].
  [[nodiscard]] bool hides(const Pixel& at, double nearness) const;

 private:
  struct Corner {
    double x = 0, y = 0, nearness = 0;  // [cells], [cells], [1/m]
  };

  void add(const Corner& a, const Corner& b, const Corner& c);

  const Camera& camera_;
  double cell_;
  int columns_, rows_;
  std::vector<double> nearness_;
};

}  // namespace physim::client
