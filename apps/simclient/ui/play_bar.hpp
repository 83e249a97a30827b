// The bar of play: buttons for the clock, its speed, and a timeline over the flights.
#pragma once

#include "simclient/core/timeline.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

class PlayBar {
 public:
  void draw(Client& client, const Box& box, float scale);

 private:
  void draw_timeline(Client& client, const Timeline& line, float scale);

  bool is_held_ = false, runs_on_ = false;  // by the mouse; runs_on: as it ran before
};

}  // namespace physim::client
