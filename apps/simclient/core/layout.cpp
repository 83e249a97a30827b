#include "simclient/core/layout.hpp"

#include <algorithm>

namespace physim::client {

Layout make_layout(const Client& client, float width, float height, float scale) {
  constexpr float kSide = 320, kBottom = 280, kStudy = 460, kLeastScene = 240, kLeastLeft = 220, kLeastRight = 290;
  const float menu = 26 * scale, status = 28 * scale, play = client.show.play ? 34 * scale : 0;
  float left = client.show.settings ? kSide * scale : 0, right = client.show.statistics ? kSide * scale : 0;
  const float most = std::max(width - kLeastScene * scale, 0.0F);
  if (left + right > most) left = std::min(left, most - right);
  if (left < kLeastLeft * scale) left = 0;  // too narrow to read
  if (right > most) right = most < kLeastRight * scale ? 0 : most;
  const float room = std::max(height - menu - status - play, 1.0F);
  const bool is_study = client.bottom == BottomPanel::study;  // has a picture that is as high as it is wide
  const float bottom = client.bottom == BottomPanel::none ? 0
                       : is_study                         ? std::min(kStudy * scale, room * 0.65F)
                                                          : std::min(kBottom * scale, room * 0.45F);
  const float middle = std::max(room - bottom, 1.0F);
  Layout out;
  out.menu = {0, 0, width, menu};
  out.status = {0, height - status, width, status};
  out.play = {0, height - status - play, width, play};
  out.left = {0, menu, left, middle};
  out.right = {width - right, menu, right, middle};
  out.bottom = {0, menu + middle, width, bottom};
  out.scene = {left, menu, std::max(width - left - right, 1.0F), middle};
  return out;
}

}  // namespace physim::client
