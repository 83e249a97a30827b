#include "simclient/core/glow.hpp"

#include <algorithm>
#include <cmath>

namespace physim::client {
namespace {

constexpr double kCell = 5;                    // [pixels of a usual screen]
constexpr int kNear = 1, kFar = 5;             // radii of the boxes whose means make the halo [cells]
constexpr int kMargin = 2 * (kNear + kFar);    // [cells]
constexpr double kStrength = 4, kOfFar = 0.7;  // of a light of one cell; of the wide halo over the near one
constexpr double kBrightest = 0.85;

/// A coarse picture: red, green and blue, cell by cell.
struct Layer {
  int columns, rows;
  std::vector<float> at;
};

/// The mean of each box of 2 radius + 1 cells along a row, by a sum that moves on; beyond the rims it is dark.
void blur_rows(const Layer& in, Layer& out, int radius) {
  const float part = 1.0F / static_cast<float>(2 * radius + 1);
  for (int y = 0; y < in.rows; ++y) {
    const float* from = &in.at[static_cast<std::size_t>(y) * static_cast<std::size_t>(in.columns) * 3];
    float* to = &out.at[static_cast<std::size_t>(y) * static_cast<std::size_t>(in.columns) * 3];
    float sum[3] = {};
    for (int x = -radius; x < in.columns; ++x) {
      for (int c = 0; c < 3; ++c) {
        if (x + radius < in.columns) sum[c] += from[3 * (x + radius) + c];
        if (x - radius > 0) sum[c] -= from[3 * (x - radius - 1) + c];
        if (x >= 0) to[3 * x + c] = std::max(sum[c], 0.0F) * part;
      }
    }
  }
}

/// The mean of each box along a column; sums of a whole row move on together.
void blur_columns(const Layer& in, Layer& out, int radius) {
  const float part = 1.0F / static_cast<float>(2 * radius + 1);
  const std::size_t width = static_cast<std::size_t>(in.columns) * 3;
  std::vector<float> sum(width, 0.0F);
  const auto row = [&](int y) { return &in.at[static_cast<std::size_t>(y) * width]; };
  for (int y = -radius; y < in.rows; ++y) {
    const float* comes = y + radius < in.rows ? row(y + radius) : nullptr;
    const float* goes = y - radius > 0 ? row(y - radius - 1) : nullptr;
    if (comes != nullptr)
      for (std::size_t i = 0; i < width; ++i) sum[i] += comes[i];
    if (goes != nullptr)
      for (std::size_t i = 0; i < width; ++i) sum[i] -= goes[i];
    if (y < 0) continue;
    float* to = &out.at[static_cast<std::size_t>(y) * width];
    for (std::size_t i = 0; i < width; ++i) to[i] = std::max(sum[i], 0.0F) * part;
  }
}

/// Twice: nearly round.
void blur(Layer& layer, Layer& spare, int radius) {
  for (int i = 0; i < 2; ++i) {
    blur_rows(layer, spare, radius);
    blur_columns(spare, layer, radius);
  }
}

}  // namespace

double heat(Colour colour) {
  const double red = static_cast<double>(colour >> 24U) / 255, green = static_cast<double>(colour >> 16U & 0xFFU) / 255,
               blue = static_cast<double>(colour >> 8U & 0xFFU) / 255,
               opacity = static_cast<double>(colour & 0xFFU) / 255;
  if (!(red >= green && green >= blue && red > 0)) return 0;
  const double warm = std::clamp(((red - blue) / red - 0.1) / 0.3, 0.0, 1.0);
  return warm * red * red * opacity;
}

Colour core_of(Colour colour) {
  constexpr double kWhite[] = {255, 246, 214};  // of what is very hot
  const double part = 0.45 * heat(colour);
  Colour out = colour & 0xFFU;
  for (int c = 0; c < 3; ++c) {
    const int shift = 24 - 8 * c;
    const auto from = static_cast<double>(colour >> shift & 0xFFU);
    out |= static_cast<Colour>(std::lround(std::lerp(from, std::max(from, kWhite[c]), part))) << shift;
  }
  return out;
}

GlowMaker::GlowMaker(const Camera& camera, double scale, double haze, const Scenery* scenery)
    : camera_(camera),
      view_(camera.projector()),
      eye_(camera.eye()),
      cell_(kCell * scale),
      haze_(haze),
      columns_(static_cast<int>(std::ceil(camera.width() / cell_))),
      rows_(static_cast<int>(std::ceil(camera.height() / cell_))),
      left_(columns_),
      top_(rows_),
      sums_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * 3) {
  if (scenery != nullptr) hiding_.emplace(camera, cell_).add(*scenery);
}

/// Between the middles of four cells.
void GlowMaker::add_at(double x, double y, double heat, const float (&colour)[3]) {
  const double u = x / cell_ - 0.5, v = y / cell_ - 0.5;
  if (!(u >= 0 && v >= 0 && u < columns_ - 1 && v < rows_ - 1)) return;
  const int i = static_cast<int>(u), k = static_cast<int>(v);
  const double s = u - i, t = v - k;
  for (int corner = 0; corner < 4; ++corner) {
    const int dx = corner & 1, dy = corner >> 1;
    const auto part = static_cast<float>(heat * (dx == 1 ? s : 1 - s) * (dy == 1 ? t : 1 - t));
    float* at = &sums_[(static_cast<std::size_t>(k + dy) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(i + dx)) *
                       3];
    for (int c = 0; c < 3; ++c) at[c] += part * colour[c];
  }
  left_ = std::min(left_, i), right_ = std::max(right_, i + 1);
  top_ = std::min(top_, k), bottom_ = std::max(bottom_, k + 1);
}

void GlowMaker::add(const Light& light) {
  const double hot = heat(light.colour);
  if (hot <= 0) return;
  const auto from = view_.project(light.from), to = light.to == light.from ? from : view_.project(light.to);
  if (!from || !to) return;
  const double away = length(camera_.shown(light.to) - eye_);
  const double size = light.pixels / cell_, reach = std::hypot(to->x - from->x, to->y - from->y) / cell_;
  constexpr double kMost = 64;  // pieces of a streak
  const double pieces = std::clamp(std::ceil(reach), 1.0, kMost);
  const double strength = kStrength * hot * std::exp2(-away / haze_) * size * std::max(size, reach) / pieces;
  const float colour[3] = {static_cast<float>(light.colour >> 24U) / 255,
                           static_cast<float>(light.colour >> 16U & 0xFFU) / 255,
                           static_cast<float>(light.colour >> 8U & 0xFFU) / 255};
  const double first = hiding_ ? 1 / view_.depth(light.from) : 0, last = hiding_ ? 1 / view_.depth(light.to) : 0;
  for (double k = 1; k <= pieces; ++k) {
    const double part = k / pieces;
    const Pixel at{std::lerp(from->x, to->x, part), std::lerp(from->y, to->y, part)};
    if (!hiding_ || !hiding_->hides(at, std::lerp(first, last, part))) add_at(at.x, at.y, strength * part, colour);
  }
}

void GlowMaker::make(GlowMap& map) {
  map.clear();
  if (right_ < left_) return;
  map.cell = cell_;
  map.left = left_ - kMargin, map.top = top_ - kMargin;
  map.columns = right_ - left_ + 1 + 2 * kMargin, map.rows = bottom_ - top_ + 1 + 2 * kMargin;
  const std::size_t count = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows) * 3;
  Layer near{map.columns, map.rows, std::vector<float>(count)}, spare = near;
  for (int y = top_; y <= bottom_; ++y) {
    const auto from = sums_.begin() + (static_cast<std::ptrdiff_t>(y) * columns_ + left_) * 3;
    std::copy_n(from, (right_ - left_ + 1) * 3,
                near.at.begin() + (static_cast<std::ptrdiff_t>(y - map.top) * map.columns + kMargin) * 3);
  }
  blur(near, spare, kNear);
  Layer far = near;
  blur(far, spare, kFar);
  map.light.resize(count);
  for (std::size_t i = 0; i < count; i += 3) {
    float sum[3];
    for (std::size_t c = 0; c < 3; ++c) sum[c] = near.at[i + c] + static_cast<float>(kOfFar) * far.at[i + c];
    const float white = 0.12F * sum[0] * sum[0];  // what is very bright has no colour
    for (std::size_t c = 0; c < 3; ++c) {
      const float light = sum[c] + white;
      map.light[i + c] = static_cast<std::uint8_t>(255 * static_cast<float>(kBrightest) * light / (1 + light));
    }
  }
}

}  // namespace physim::client
