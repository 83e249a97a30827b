#include "simclient/ui/play_bar.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "simclient/core/actions.hpp"

namespace physim::client {
namespace {

using Kind = TimelineTick::Kind;

enum class Sign { start, back, play, pause, step };

/// Triangles and bars, as fonts lack some of them.
void draw_sign(Sign sign, ImVec2 middle, float size, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = size * 0.32F, bar = size * 0.11F;
  const auto upright = [&](float x) {
    list.AddRectFilled({middle.x + x - bar, middle.y - r}, {middle.x + x + bar, middle.y + r}, colour);
  };
  const auto triangle = [&](float x, float way) {
    list.AddTriangleFilled({middle.x + x + way * r, middle.y}, {middle.x + x - way * r, middle.y - r},
                           {middle.x + x - way * r, middle.y + r}, colour);
  };
  switch (sign) {
    case Sign::start: return upright(-r), triangle(bar, -1);
    case Sign::back: return triangle(-bar, -1), upright(r);
    case Sign::play: return triangle(bar, 1);
    case Sign::pause: return upright(-1.6F * bar), upright(1.6F * bar);
    case Sign::step: return upright(-r), triangle(bar, 1);
  }
}

void button(Client& client, const char* name, Sign sign) {
  const Action& action = *find_action(name);
  const float size = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name);
  if (ImGui::Button("##sign", {size * 1.25F, size})) run_action(client, action);
  ImGui::PopID();
  draw_sign(sign, {at.x + size * 0.625F, at.y + size / 2}, size, shade(colours::kText));
  tooltip(std::string(action.help) + " (" + std::string(action.keys) + ")");
  ImGui::SameLine(0, size * 0.12F);
}

void pick_speed(Client& client) {
  static constexpr double kSpeeds[] = {1.0 / 64, 1.0 / 16, 0.125, 0.25, 0.5, 1, 2, 4, 8, 16, 64, 256, 1024};
  const double now = client.session.time_scale();
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.6F);
  if (ImGui::BeginCombo("##speed", formatted("\u00d7%.4g", now).c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const double speed : kSpeeds)
      if (ImGui::Selectable(formatted("\u00d7%.4g", speed).c_str(), speed == now)) client.session.set_time_scale(speed);
    ImGui::EndCombo();
  }
  tooltip("seconds of simulation in a second of the screen (+ and -)");
  ImGui::SameLine();
}

/// As many digits as steps of the timeline ask for.
std::string clock_text(double time) { return formatted(std::abs(time) < 1000 ? "%.2f s" : "%.0f s", time); }

void draw_tick(ImDrawList& list, const TimelineTick& tick, float x, float top, float bottom, float scale) {
  const ImU32 colour = shade(tick.colour);
  const float r = 3.5F * scale, middle = (top + bottom) / 2;
  switch (tick.kind) {
    case Kind::launch: return list.AddTriangleFilled({x, top}, {x - r, top + 2 * r}, {x + r, top + 2 * r}, colour);
    case Kind::apex: return list.AddCircle({x, top + r}, r, colour, 0, 1.6F * scale);
    case Kind::burnout:
      return list.AddQuadFilled({x, top}, {x + r, top + r}, {x, top + 2 * r}, {x - r, top + r}, colour);
    case Kind::end: return list.AddLine({x, top}, {x, middle}, colour, 2 * scale);
    case Kind::hit:
      list.AddLine({x - r, top}, {x + r, top + 2 * r}, colour, 1.8F * scale);
      list.AddLine({x + r, top}, {x - r, top + 2 * r}, colour, 1.8F * scale);
  }
}

/// The ticks within a few pixels of a place, for people.
std::string ticks_near(const Timeline& line, double time, double reach) {
  constexpr std::size_t kMost = 6;
  std::string text;
  std::size_t count = 0;
  for (const TimelineTick& tick : line.ticks)
    if (std::abs(tick.time - time) <= reach && count++ < kMost) text += "\n" + tick.text;
  return count > kMost ? text + formatted("\nand %zu more", count - kMost) : text;
}

}  // namespace

void PlayBar::draw(Client& client, const Box& box, float scale) {
  ImGui::SetNextWindowPos({box.x, box.y});
  ImGui::SetNextWindowSize({box.width, box.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * scale, 5 * scale});
  ImGui::Begin("play###play", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  const Timeline line = timeline_of(client);
  button(client, "rewind", Sign::start);
  button(client, "back", Sign::back);
  button(client, "pause", client.session.is_paused() && !(is_held_ && runs_on_) ? Sign::play : Sign::pause);
  button(client, "step", Sign::step);
  pick_speed(client);
  draw_timeline(client, line, scale);
  ImGui::End();
  ImGui::PopStyleVar();
}

void PlayBar::draw_timeline(Client& client, const Timeline& line, float scale) {
  const std::string now = clock_text(line.now), end = clock_text(line.end);
  const float wide = ImGui::CalcTextSize("0000.00 s").x, room = ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(now.c_str());
  ImGui::SameLine(left + wide);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(room - 2 * wide - 16 * scale, 40 * scale), height = ImGui::GetFrameHeight();
  ImGui::InvisibleButton("timeline", {width, height});
  const bool is_hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = 5 * scale, from = at.x + pad, to = at.x + width - pad;
  const float top = at.y + 2 * scale, rail = at.y + height - 6 * scale;
  client.timeline_from = {from, rail}, client.timeline_to = {to, rail};
  const auto x_of = [&](double time) { return from + static_cast<float>(line.part(time)) * (to - from); };
  list.AddRectFilled({from, rail - 2 * scale}, {to, rail + 2 * scale}, exact(theme_in_use().field), 2 * scale);
  list.AddRectFilled({x_of(line.reachable), rail - 2 * scale}, {x_of(line.known), rail + 2 * scale},
                     exact(theme_in_use().active), 2 * scale);
  list.AddRectFilled({x_of(line.reachable), rail - 2 * scale}, {x_of(line.now), rail + 2 * scale},
                     exact(theme_in_use().accent), 2 * scale);
  for (const TimelineTick& tick : line.ticks)
    if (tick.time >= line.begin && tick.time <= line.end)
      draw_tick(list, tick, x_of(tick.time), top, rail - 2 * scale, scale);
  list.AddCircleFilled({x_of(line.now), rail}, 6 * scale, shade(colours::kText));
  const auto time_at = [&](float x) { return line.time(std::clamp((x - from) / (to - from), 0.0F, 1.0F)); };
  const double at_mouse = time_at(ImGui::GetMousePos().x);
  // Its end may lie between two steps, and is reached by the second.
  const double pointed = at_mouse < line.end ? at_mouse : line.end + client.session.step_length() / 2;
  if (ImGui::IsItemActivated()) is_held_ = true, runs_on_ = !client.session.is_paused();
  if (is_held_ && ImGui::IsItemActive()) client.session.go_to(step_at(client.session, pointed));
  if (is_held_ && !ImGui::IsItemActive()) {
    is_held_ = false;
    if (runs_on_) client.session.set_paused(false);
  }
  if (is_hovered && !is_held_) {
    client.cursor = at_mouse;
    list.AddLine({x_of(at_mouse), top}, {x_of(at_mouse), rail}, shade(colours::kDim), scale);
    tooltip(formatted("%.3f s", at_mouse) +
            ticks_near(line, at_mouse, 5 * scale / (to - from) * (line.end - line.begin)));
  }
  ImGui::SameLine(0, 8 * scale);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", end.c_str());
}

}  // namespace physim::client
