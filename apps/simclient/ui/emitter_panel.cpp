#include "simclient/ui/emitter_panel.hpp"

#include <algorithm>
#include <cmath>

namespace physim::client {
namespace {

constexpr float kGrip = 6;    // radius of a key [pixels]
constexpr int kPieces = 160;  // that a line is drawn in

ImU32 packed(std::uint32_t rgba) {
  return IM_COL32(rgba >> 24 & 0xff, rgba >> 16 & 0xff, rgba >> 8 & 0xff, rgba & 0xff);
}

void draw_grid(ImDrawList* list, const ImVec2& corner, const ImVec2& size) {
  list->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, exact(theme_in_use().plot), 3);
  for (int i = 0; i <= 4; ++i) {
    const float x = corner.x + size.x * static_cast<float>(i) / 4, y = corner.y + size.y * static_cast<float>(i) / 4;
    list->AddLine({x, corner.y}, {x, corner.y + size.y}, exact(theme_in_use().plot_lines));
    list->AddLine({corner.x, y}, {corner.x + size.x, y}, exact(theme_in_use().plot_lines));
  }
}

/// What shows how far a colour lets through.
void draw_chequers(ImDrawList* list, const ImVec2& corner, const ImVec2& size, float field) {
  list->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, IM_COL32(58, 62, 70, 255));
  for (int row = 0; static_cast<float>(row) * field < size.y; ++row)
    for (int column = row % 2; static_cast<float>(column) * field < size.x; column += 2) {
      const ImVec2 at{corner.x + static_cast<float>(column) * field, corner.y + static_cast<float>(row) * field};
      list->AddRectFilled(at, {std::min(at.x + field, corner.x + size.x), std::min(at.y + field, corner.y + size.y)},
                          IM_COL32(92, 98, 108, 255));
    }
}

}  // namespace

void EmitterPanel::draw(Client& client, const Box& box, float scale) {
  if (!held_ && !has_changed_) edited_ = client.session.scenario().emitters;
  const float width = std::min(box.width - 20 * scale, 360 * scale);
  ImGui::SetNextWindowPos({box.x + box.width - 10 * scale, box.y + 10 * scale}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSize({width, 0});
  if (ImGui::Begin("Emitters###emitters", &client.show.emitters,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    if (edited_.empty() || client.session.is_replay()) {
      ImGui::TextWrapped("There are no emitters here: a scenario has them as [[emitter]].");
    } else {
      choose(edited_);
      EmitterLine line = lines_of(edited_[emitter_].def)[line_];
      const bool is_done = line.curve ? draw_curve(*line.curve, scale) : draw_gradient(*line.gradient, scale);
      if (is_done)
        if (Status status = client.set_emitters(edited_); !status) client.complain(status.error());
    }
  }
  ImGui::End();
}

void EmitterPanel::choose(std::vector<ScenarioEmitter>& emitters) {
  emitter_ = std::min(emitter_, emitters.size() - 1);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.42F);
  if (ImGui::BeginCombo("##emitter", emitters[emitter_].def.name.c_str())) {
    for (std::size_t i = 0; i < emitters.size(); ++i)
      if (ImGui::Selectable(emitters[i].def.name.c_str(), i == emitter_)) emitter_ = i, held_.reset(), chosen_.reset();
    ImGui::EndCombo();
  }
  const auto lines = lines_of(emitters[emitter_].def);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##line", std::string(lines[line_].title).c_str(), ImGuiComboFlags_HeightLarge)) return;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (ImGui::Selectable(std::string(lines[i].title).c_str(), i == line_)) line_ = i, held_.reset(), chosen_.reset();
  ImGui::EndCombo();
}

template <class Key, class Made>
bool EmitterPanel::edit_keys(std::vector<Key>& keys, const Frame& frame, float scale, const Made& made) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const double at = std::clamp((mouse.x - frame.corner.x) / frame.size.x, 0.0F, 1.0F);
  const double grip = 1.5 * kGrip * scale / frame.size.x;
  const bool is_over = ImGui::IsItemHovered();
  if (is_over && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    held_ = key_near(keys, at, grip);
    has_changed_ = !held_;
    if (!held_) held_ = add_key(keys, made(at, mouse));
    chosen_ = held_;
  }
  if (is_over && !held_ && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    const auto gone = key_near(keys, at, grip);
    if (!gone) return false;
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(*gone));
    chosen_.reset();
    return true;
  }
  if (!held_ || *held_ >= keys.size()) return held_.reset(), false;
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const Key before = keys[*held_];
    Key moved = made(at, mouse);
    moved.at = before.at;
    if constexpr (requires { moved.colour; }) moved.colour = before.colour;
    keys[*held_] = moved;
    move_key(keys, *held_, at);
    has_changed_ = has_changed_ || keys[*held_] != before;
  }
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return false;
  held_.reset();
  return std::exchange(has_changed_, false);
}

bool EmitterPanel::draw_curve(Curve& curve, float scale) {
  Frame frame{ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x, 150 * scale}};
  double least = 0, most = 1;
  for (const CurveKey& key : curve) least = std::min(least, key.value), most = std::max(most, key.value);
  frame.low = least < 0 ? 1.15 * least : 0, frame.high = 1.15 * most;
  ImGui::InvisibleButton("curve", frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool is_done = edit_keys(curve, frame, scale, [&](double at, const ImVec2& mouse) {
    const double up = 1 - (mouse.y - frame.corner.y) / frame.size.y;
    const double value = frame.low + (frame.high - frame.low) * std::clamp(up, 0.0, 1.0);
    return CurveKey{at, std::round(value * 1000) / 1000};
  });
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_grid(list, frame.corner, frame.size);
  list->PushClipRect(frame.corner, {frame.corner.x + frame.size.x, frame.corner.y + frame.size.y}, true);
  std::vector<ImVec2> points;
  for (int i = 0; i <= kPieces; ++i) {
    const double at = static_cast<double>(i) / kPieces;
    points.push_back(frame.at(at, value_of(curve, at)));
  }
  const ImU32 colour = shade(curve.empty() ? colours::kDim : colours::kVelocity);
  list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 2 * scale);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const ImVec2 at = frame.at(curve[i].at, curve[i].value);
    list->AddCircleFilled(at, kGrip * scale * 0.8F, shade(held_ == i ? colours::kForce : colours::kArrow));
    list->AddCircle(at, kGrip * scale * 0.8F, exact(theme_in_use().plot), 0, 1.5F * scale);
  }
  list->PopClipRect();
  const std::optional<std::size_t> told = chosen_ && *chosen_ < curve.size() ? chosen_ : std::nullopt;
  if (told)
    ImGui::Text("at %.3f: times %.3f", curve[*told].at, curve[*told].value);
  else
    ImGui::TextDisabled(curve.empty() ? "no keys: 1 everywhere" : "0 .. 1 of the span; up to %.3g", frame.high);
  ImGui::TextDisabled("left: puts in and moves keys; right: takes out");
  return is_done;
}

bool EmitterPanel::draw_gradient(Gradient& gradient, float scale) {
  const Frame frame{ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x, 46 * scale}};
  const float bar = 30 * scale;
  ImGui::InvisibleButton("gradient", frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  bool is_done = edit_keys(gradient, frame, scale, [&](double at, const ImVec2&) {
    return ColourKey{at, colour_of(gradient, at)};
  });
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_chequers(list, frame.corner, {frame.size.x, bar}, 6 * scale);
  for (int i = 0; i < kPieces; ++i) {
    const double from = static_cast<double>(i) / kPieces, to = static_cast<double>(i + 1) / kPieces;
    const ImU32 a = packed(colour_of(gradient, from)), b = packed(colour_of(gradient, to));
    const float x = frame.at(from, 0).x, next = frame.at(to, 0).x;
    list->AddRectFilledMultiColor({x, frame.corner.y}, {next, frame.corner.y + bar}, a, b, b, a);
  }
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const float x = frame.at(gradient[i].at, 0).x, top = frame.corner.y + bar + 2 * scale, half = kGrip * scale;
    const ImU32 rim = shade(chosen_ == i ? colours::kForce : colours::kText);
    list->AddTriangleFilled({x, top}, {x - half, top + 2 * half}, {x + half, top + 2 * half},
                            packed(gradient[i].colour | 0xff));
    list->AddTriangle({x, top}, {x - half, top + 2 * half}, {x + half, top + 2 * half}, rim, 1.5F * scale);
  }
  if (chosen_ && *chosen_ < gradient.size() && !held_) {
    ColourKey& key = gradient[*chosen_];
    const auto part = [&key](int shift) { return static_cast<float>(key.colour >> shift & 0xff) / 255; };
    float rgba[4] = {part(24), part(16), part(8), part(0)};
    ImGui::SetNextItemWidth(-1);
    if (ImGui::ColorEdit4("##colour", rgba, ImGuiColorEditFlags_AlphaPreviewHalf)) {
      key.colour = 0;
      for (const float each : rgba) key.colour = key.colour << 8 | static_cast<std::uint32_t>(std::lround(each * 255));
      has_changed_ = true;
    }
    // The run starts again with the colour that is let go, not with each on the way.
    if (has_changed_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive())
      is_done = !(has_changed_ = false);
  } else {
    ImGui::TextDisabled(gradient.empty() ? "no keys: white everywhere" : "choose a key to see its colour");
  }
  ImGui::TextDisabled("left: puts in and moves keys; right: takes out");
  return is_done;
}

}  // namespace physim::client
