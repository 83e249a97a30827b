// Plots that grow while things fly.
#include <algorithm>
#include <cmath>

#include "simclient/core/actions.hpp"
#include "simclient/core/timeline.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

/// Where a plot draws, inside its axes.
struct PlotFrame {
  ImVec2 low, high;  // upper left and lower right corner
  const Plot* plot = nullptr;
  PlotSpec spec;

  [[nodiscard]] ImVec2 place(const PlotPoint& p) const {
    return {low.x + static_cast<float>(plot->x.part(p.x)) * (high.x - low.x),
            high.y - static_cast<float>(plot->y.part(p.y)) * (high.y - low.y)};
  }
};

/// Each tick has its line; a number only where there is room for it beside the one before.
void draw_x_ticks(ImDrawList& list, const PlotFrame& frame, float gap) {
  const Plot& plot = *frame.plot;
  float taken = frame.low.x - ImGui::GetFontSize() * 2;
  for (const double tick : plot.x.ticks()) {
    const float x = frame.place({tick, plot.y.low}).x;
    const std::string text = plot.x.text(tick);
    list.AddLine({x, frame.low.y}, {x, frame.high.y}, exact(theme_in_use().plot_lines));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float left = std::min(x - width / 2, frame.high.x + ImGui::GetFontSize() - width);  // within its plot
    if (left < taken) continue;
    taken = left + width + 2 * gap;
    list.AddText({left, frame.high.y + gap}, shade(colours::kDim), text.c_str());
  }
}

void draw_axes(ImDrawList& list, const PlotFrame& frame) {
  const Plot& plot = *frame.plot;
  const float gap = ImGui::GetFontSize() * 0.3F;
  list.AddRectFilled(frame.low, frame.high, exact(theme_in_use().plot));
  draw_x_ticks(list, frame, gap);
  for (const double tick : plot.y.ticks()) {
    const float y = frame.place({plot.x.low, tick}).y;
    const std::string text = plot.y.text(tick);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddLine({frame.low.x, y}, {frame.high.x, y}, exact(theme_in_use().plot_lines));
    list.AddText({frame.low.x - size.x - gap, y - size.y / 2}, shade(colours::kDim), text.c_str());
  }
  list.AddRect(frame.low, frame.high, exact(theme_in_use().separator));
  const ImVec2 size = ImGui::CalcTextSize(plot.x.label.c_str());
  list.AddText({(frame.low.x + frame.high.x - size.x) / 2, frame.high.y + gap + size.y}, shade(colours::kText),
               plot.x.label.c_str());
  list.AddText({frame.low.x, frame.low.y - size.y - gap}, shade(colours::kText), plot.y.label.c_str());
}

/// A ring is published, a cross is expected.
void draw_mark(ImDrawList& list, ImVec2 at, bool published) {
  const float scale = ImGui::GetFontSize() / 15;
  if (published) return list.AddCircle(at, 4.5F * scale, shade(colours::kText), 0, 1.6F * scale);
  const float arm = 3.5F * scale;
  list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, shade(colours::kDim), 1.3F * scale);
  list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, shade(colours::kDim), 1.3F * scale);
}

/// A curve up to the moment at hand, faint behind it, and the point of a moment.
void draw_curve(ImDrawList& list, const PlotFrame& frame, const PlotCurve& curve, const Client& client) {
  const float width = 1.8F * ImGui::GetFontSize() / 15;
  const Track& track = *curve.track;
  const auto at = [&](double time) -> std::optional<ImVec2> {
    const auto sample = sample_at(track, time);
    if (!sample) return std::nullopt;
    const auto all = plot_quantities();
    return frame.place({all[frame.spec.x].of(track, *sample), all[frame.spec.y].of(track, *sample)});
  };
  const double now = client.session.shown_time();
  std::vector<ImVec2> before, behind;
  for (const PlotPoint& point : curve.points)
    (track.born + point.time <= now ? before : behind).push_back(frame.place(point));
  if (const auto here = at(now); here && !behind.empty()) before.push_back(*here), behind.insert(behind.begin(), *here);
  list.AddPolyline(behind.data(), static_cast<int>(behind.size()), shade(faded(track.colour, 0.4)), 0, width);
  list.AddPolyline(before.data(), static_cast<int>(before.size()), shade(track.colour), 0, width);
  const auto dot = at(std::min(client.cursor.value_or(now), track.born + track.samples.back().time));
  const bool is_there =
      client.cursor ? sample_at(track, *client.cursor).has_value() : !behind.empty() || track.is_flying();
  if (!dot || !is_there) return;
  const bool is_over_time = plot_quantities()[frame.spec.x].name == "time";
  if (is_over_time && client.cursor)
    list.AddLine({dot->x, frame.low.y}, {dot->x, frame.high.y}, shade(faded(colours::kText, 0.4)));
  list.AddCircleFilled(*dot, 2 * width, shade(track.colour));
}

void draw_curves(ImDrawList& list, const PlotFrame& frame, const Client& client) {
  list.PushClipRect(frame.low, frame.high, true);
  for (const PlotCurve& curve : frame.plot->curves) draw_curve(list, frame, curve, client);
  list.PopClipRect();
  for (const PlotMark& mark : frame.plot->expected) draw_mark(list, frame.place(mark.point), mark.published);
}

/// What the marks stand for, above the right end of the plot; as many as find room beside its name.
void draw_legend(ImDrawList& list, const PlotFrame& frame) {
  const float letter = ImGui::GetFontSize();
  const float left = frame.low.x + ImGui::CalcTextSize(frame.plot->y.label.c_str()).x + letter;
  float right = frame.high.x;
  for (const bool published : {true, false}) {
    const auto& marks = frame.plot->expected;
    if (std::ranges::none_of(marks, [&](const PlotMark& mark) { return mark.published == published; })) continue;
    const char* name = published ? "published" : "expected";
    const ImVec2 size = ImGui::CalcTextSize(name);
    if (right - size.x - letter * 1.2F < left) return;
    const float y = frame.low.y - size.y - letter * 0.3F;
    list.AddText({right - size.x, y}, shade(colours::kDim), name);
    draw_mark(list, {right - size.x - letter * 0.7F, y + size.y / 2}, published);
    right -= size.x + letter * 2;
  }
}

/// What the mouse is at, there and in all plots and the scene. A left drag goes to its time.
void draw_read_out(ImDrawList& list, const PlotFrame& frame, Client& client) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const ImVec2 size = {frame.high.x - frame.low.x, frame.high.y - frame.low.y};
  const PlotPoint place{(mouse.x - frame.low.x) / size.x, (frame.high.y - mouse.y) / size.y};
  const auto hit = nearest_point(*frame.plot, place, size.x / size.y, 0.15);
  if (!hit) return;
  client.cursor = hit->track->born + hit->point.time;
  const ImVec2 pressed = ImGui::GetIO().MouseClickedPos[0];
  const bool began_here =
      pressed.x >= frame.low.x && pressed.x <= frame.high.x && pressed.y >= frame.low.y && pressed.y <= frame.high.y;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && began_here)
    client.session.go_to(step_at(client.session, *client.cursor));
  const ImVec2 at = frame.place(hit->point);
  list.AddLine({at.x, frame.low.y}, {at.x, frame.high.y}, shade(faded(colours::kText, 0.4)));
  list.AddLine({frame.low.x, at.y}, {frame.high.x, at.y}, shade(faded(colours::kText, 0.4)));
  list.AddCircle(at, 5, shade(hit->track->colour), 0, 2);
  ImGui::BeginTooltip();
  ImGui::TextColored(tint(hit->track->colour), "%s", hit->track->title().c_str());
  ImGui::Text("%s  %.6g", frame.plot->x.label.c_str(), hit->point.x);
  ImGui::Text("%s  %.6g", frame.plot->y.label.c_str(), hit->point.y);
  if (plot_quantities()[frame.spec.x].name != "time") ImGui::Text("time [s]  %.6g", hit->point.time);
  ImGui::EndTooltip();
}

void pick_quantity(const char* id, std::size_t& quantity, float width) {
  const auto all = plot_quantities();
  ImGui::SetNextItemWidth(std::min(ImGui::GetFontSize() * 7.4F, width));
  const std::string shown(all[quantity].name);
  const float letters = ImGui::CalcTextSize(shown.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  const ImGuiComboFlags arrow = letters + ImGui::GetFrameHeight() > width ? ImGuiComboFlags_NoArrowButton : 0;
  if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge | arrow)) return;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (ImGui::Selectable(std::string(all[i].name).c_str(), i == quantity)) quantity = i;
  ImGui::EndCombo();
}

/// What is plotted, in its place of the row.
void draw_one(Client& client, PlotSpec& spec, float width, bool bare) {
  ImGui::BeginChild("plot", {width, 0}, false, ImGuiWindowFlags_NoScrollbar);
  if (!bare && ImGui::GetContentRegionAvail().y > ImGui::GetFontSize() * 8) {  // else the curve needs the room
    const float half = (width - ImGui::CalcTextSize("over").x - 8) / 2;
    pick_quantity("##y", spec.y, half);
    ImGui::SameLine(0, 4);
    ImGui::TextDisabled("over");
    ImGui::SameLine(0, 4);
    pick_quantity("##x", spec.x, half);
  }
  const float letter = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const std::span<const Track> tracks = client.session.known_tracks();
  const Track* selected = client.plots_selected_alone ? client.selected_track() : nullptr;
  const auto known = std::ranges::find_if(tracks, [&](const Track& t) { return selected && t.id == selected->id; });
  const Track* alone = known != tracks.end() ? &*known : nullptr;
  const Plot plot =
      make_plot(spec, tracks, alone, client.session.scenario(), std::max(2, static_cast<int>(room.x / (letter * 5))),
                std::max(2, static_cast<int>(room.y / (letter * 2.6F))));
  float wide = letter * 2;
  for (const double tick : plot.y.ticks())
    wide = std::max(wide, ImGui::CalcTextSize(plot.y.text(tick).c_str()).x + letter * 0.6F);
  PlotFrame frame{
      {at.x + wide, at.y + letter * 1.5F}, {at.x + room.x - letter * 1.2F, at.y + room.y - letter * 2.6F}, &plot, spec};
  if (frame.high.x - frame.low.x > letter * 3 && frame.high.y - frame.low.y > letter * 2) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, frame);
    draw_curves(list, frame, client);
    draw_legend(list, frame);
    if (ImGui::IsMouseHoveringRect(frame.low, frame.high) && ImGui::IsWindowHovered())
      draw_read_out(list, frame, client);
  }
  ImGui::EndChild();
}

void button(Client& client, const char* label, const char* action) {
  go_beside(label);
  if (ImGui::Button(label)) run_action(client, *find_action(action));
  tooltip(std::string(find_action(action)->help) + " (" + std::string(find_action(action)->keys) + ")");
}

void draw_buttons(Client& client) {
  ImGui::Checkbox("selected", &client.plots_selected_alone);
  tooltip("curves of the selected one alone");
  ImGui::SameLine();
  if (ImGui::Button("+") && client.plots.size() < 6) client.plots.push_back(client.plots.back());
  tooltip("one plot more");
  ImGui::SameLine();
  if (ImGui::Button("-") && client.plots.size() > 1) client.plots.pop_back();
  tooltip("one plot less");
  for (const auto& [label, plots] : {std::pair{"path", "y/x y/z speed/range"},
                                     {"position", "x y z"},
                                     {"velocity", "vx vy vz"},
                                     {"accel.", "ax ay az"},
                                     {"energy", "speed energy mach"}}) {
    go_beside(label);
    if (ImGui::Button(label)) client.plots = *parse_plots(plots);
  }
  button(client, "CSV", "save-csv");
  button(client, "PNG", "picture-of-plots");
}

}  // namespace

void draw_plots(Client& client, bool bare) {
  if (!bare) draw_buttons(client);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const auto count = static_cast<float>(client.plots.size());
  const float room = ImGui::GetContentRegionAvail().x, least = ImGui::GetFontSize() * 9;
  const float fit = std::max(std::floor((room + gap) / (least + gap)), 1.0F);
  const float seen = bare ? count : std::min(count, fit);  // whole ones; the row is scrolled to the others
  const float width = std::floor((room - gap * (seen - 1)) / seen);
  ImGui::BeginChild("row", {0, 0}, false, seen < count ? ImGuiWindowFlags_HorizontalScrollbar : 0);
  for (std::size_t i = 0; i < client.plots.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    ImGui::PushID(static_cast<int>(i));
    draw_one(client, client.plots[i], width, bare);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

}  // namespace physim::client
