#include "simclient/core/layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/assert.hpp"

namespace physim::client {

double scale_of_screen(double height) {
  constexpr double kLarge = 1600, kUsual = 1080;  // rows
  return height < kLarge ? 1 : std::clamp(std::round(2 * height / kUsual) / 2, 1.0, 4.0);
}

Layout make_layout(const Client& client, float width, float height, float scale) {
  constexpr float kDock = 320, kLeastDock = 200, kBottom = 280, kStudy = 460, kLeastHeight = 320;
  constexpr float kScene = 0.6F;                             // part of the window
  constexpr float kSettings = 0.46F, kMostSettings = 0.56F;  // parts of the dock: what flights leave ...
  constexpr float kWanted = 0.6F;                            // ... or what they take to be seen whole, up to this
  constexpr float kTitle = 32, kFlight = 100;                // of the flights, as high as letters of 15 pixels make it
  constexpr float kOneFlight = 160;                          // in a narrow dock, with a hit ...
  constexpr float kNarrowFlight = 120, kLine = 26;           // ... and without one; of the third its first line is seen
  const float menu = 26 * scale, status = 28 * scale, play = client.show.play ? 34 * scale : 0;
  const float room = std::max(height - menu - status - play, 1.0F);
  float dock = std::min(kDock * scale, width - kScene * width * height / room);
  if (dock < kLeastDock * scale || !(client.show.settings || client.show.statistics)) dock = 0;
  const bool has_both = client.show.settings && client.show.statistics && room >= kLeastHeight * scale;
  const auto flights = static_cast<float>(std::clamp<std::size_t>(client.session.tracks().size(), 1, 3));
  const float rest = room - (kTitle + kFlight * flights) * scale;
  const float seen = kTitle + std::max(kOneFlight, kNarrowFlight * (flights - 1) + kLine);
  const float wanted = std::min(client.settings_height, room - seen * scale);
  const float least = std::max(std::min(wanted, room * kWanted), room * kSettings);
  const float shared = std::round(std::min(std::max(rest, least), std::max({wanted, least, room * kMostSettings})));
  const float upper = !client.show.settings ? 0 : has_both ? shared : room;
  const bool is_study = client.bottom == BottomPanel::study;  // has a picture that is as high as it is wide
  const float bottom = client.bottom == BottomPanel::none ? 0
                       : is_study                         ? std::min(kStudy * scale, room * 0.65F)
                                                          : std::min(kBottom * scale, room * 0.45F);
  const float beside = std::max(width - dock, 1.0F);
  Layout out;
  out.menu = {0, 0, width, menu};
  out.status = {0, height - status, width, status};
  out.play = {0, height - status - play, width, play};
  out.settings = {0, menu, upper > 0 ? dock : 0, upper};
  out.statistics = {0, menu + upper, upper < room && client.show.statistics ? dock : 0, room - upper};
  out.scene = {dock, menu, beside, std::max(room - bottom, 1.0F)};
  out.bottom = {dock, menu + out.scene.height, beside, bottom};
  return out;
}

std::vector<std::size_t> columns_that_fit(std::span<const float> widths, std::span<const int> ranks, float room) {
  PHYSIM_ASSERT(widths.size() == ranks.size());
  std::vector<std::size_t> shown(widths.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  float sum = std::accumulate(widths.begin(), widths.end(), 0.0F);
  while (sum > room) {
    auto least = shown.end();
    for (auto each = shown.begin(); each != shown.end(); ++each)
      if (ranks[*each] > 0 && (least == shown.end() || ranks[*each] >= ranks[*least])) least = each;
    if (least == shown.end()) break;
    sum -= widths[*least];
    shown.erase(least);
  }
  return shown;
}

}  // namespace physim::client
