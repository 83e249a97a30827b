#include "simclient/core/labels.hpp"

#include <algorithm>

namespace physim::client {
namespace {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<SceneLabel>& labels, const Camera& camera, const Box& scene,
                                      float line, float scale, const TextWidth& width_of, std::vector<Box> taken) {
  constexpr int kLinesAway[] = {0, -1, 1, -2, 2, -3, 3};  // from where it should stand
  std::vector<PlacedLabel> placed;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    const auto at = camera.project(label->at);
    if (!at) continue;
    const float width = width_of(label->text);
    const float x = scene.x + static_cast<float>(at->x) - (label->centred ? width / 2 : -4 * scale) +
                    static_cast<float>(label->side) * width / 2;
    const float y = scene.y + static_cast<float>(at->y) + (label->line >= 0 ? 6 * scale : -6 * scale) +
                    static_cast<float>(label->line) * line - (label->centred ? 0 : line);
    if (x < scene.x || x + width > scene.x + scene.width) continue;  // half a number says the wrong thing
    for (const int away : kLinesAway) {
      if (away != 0 && !label->centred) break;
      const Box box{x - 3, y + static_cast<float>(away) * line + 1, width + 6, line - 2};
      if (std::ranges::any_of(taken, [&](const Box& other) { return overlap(box, other); })) continue;
      taken.push_back(box);
      placed.push_back({&*label, x, box.y - 1});
      break;
    }
  }
  return placed;
}

}  // namespace physim::client
