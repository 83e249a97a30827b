#include "simclient/core/labels.hpp"

#include <algorithm>

namespace physim::client {
namespace {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool holds(const Box& scene, const Box& label) {
  return label.x + 3 >= scene.x && label.x + label.width - 3 <= scene.x + scene.width && label.y >= scene.y &&
         label.y + label.height <= scene.y + scene.height;
}

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<SceneLabel>& labels, const Camera& camera, const Box& scene,
                                      float line, float scale, const TextWidth& width_of, std::vector<Box> taken) {
  struct Move {
    float lines, aside;  // of its height, of its width
  };
  constexpr Move kMoves[] = {{0, 0}, {-1, 0},     {1, 0},     {-2, 0},     {2, 0},    {-3, 0},
                             {3, 0}, {1, -0.55F}, {1, 0.55F}, {2, -0.55F}, {2, 0.55F}};
  std::vector<PlacedLabel> placed;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    const auto at = camera.project(label->at);
    if (!at) continue;
    const float width = width_of(label->text);
    const float x = scene.x + static_cast<float>(at->x) - (label->centred ? width / 2 : -4 * scale) +
                    static_cast<float>(label->side) * width / 2;
    const float y = scene.y + static_cast<float>(at->y) + (label->line >= 0 ? 6 * scale : -6 * scale) +
                    static_cast<float>(label->line) * line - (label->centred ? 0 : line);
    for (const Move& move : kMoves) {
      if (move.lines != 0 && (!label->centred || label->gives_way)) break;
      const Box box{x - 3 + move.aside * width, y + move.lines * line + 1, width + 6, line - 2};
      if (!holds(scene, box)) continue;  // half a number says the wrong thing
      if (std::ranges::any_of(taken, [&](const Box& other) { return overlap(box, other); })) continue;
      taken.push_back(box);
      placed.push_back({&*label, box.x + 3, box.y - 1});
      break;
    }
  }
  return placed;
}

}  // namespace physim::client
