// The panel of emitters: curves and gradients, drawn with the mouse.
#pragma once

#include <optional>
#include <vector>

#include "simclient/core/client.hpp"
#include "simclient/core/emitter_edit.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

class EmitterPanel {
 public:
  /// Over the upper right of a box.
  void draw(Client& client, const Box& box, float scale);

 private:
  /// Where a line is drawn, and what its height means.
  struct Frame {
    ImVec2 corner, size;  // [pixels]
    double low = 0, high = 1;

    [[nodiscard]] ImVec2 at(double part, double value) const {
      return {corner.x + static_cast<float>(part) * size.x,
              corner.y + static_cast<float>((high - value) / (high - low)) * size.y};
    }
  };

  void choose(std::vector<ScenarioEmitter>& emitters);
  bool draw_curve(Curve& curve, float scale);
  bool draw_gradient(Gradient& gradient, float scale);
  /// Keys under the mouse: pressed, dragged, put in and taken out; true when it is let go and something changed.
  template <class Key, class Made>
  bool edit_keys(std::vector<Key>& keys, const Frame& frame, float scale, const Made& made);

  std::size_t emitter_ = 0, line_ = 9;        // colour over life
  std::optional<std::size_t> held_, chosen_;  // keys: by the mouse, and for the colour below
  bool has_changed_ = false;                  // by a hand that has not let go yet
  std::vector<ScenarioEmitter> edited_;       // as the hand has them
};

}  // namespace physim::client
