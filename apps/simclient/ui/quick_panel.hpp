// The first rows of the settings: sliders of what people change first, and accuracy as one of them.
#pragma once

#include <optional>

#include "simclient/core/quick_settings.hpp"

namespace physim::client {

class QuickPanel {
 public:
  void draw(Client& client);

 private:
  void draw_slider(Client& client, const QuickSetting& setting, float label);
  void draw_accuracy(Client& client, float label);

  /// Behind each slider.
  void note_slide(Client& client);

  std::uint64_t slides_ = 0;   // how many sliders have been taken hold of
  std::optional<Quick> held_;  // a wind that is dragged: it is set where it is let go
  double dragged_ = 0;
};

}  // namespace physim::client
