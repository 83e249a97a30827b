// The panel of a study: where shots end on the target face, how figures settle, and what they are.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "physim/names.hpp"
#include "report/number.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/study_view.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

constexpr Colour kFace = 0xF1ECE222, kRim = 0xC9BCA0FF;
constexpr Colour kHitInk = 0x56B4E9FF, kMissInk = 0xD55E00FF, kCells = 0x56B4E955;

/// Colours of bars with letters on them.
Colour study_bar() { return theme_in_use().is_light ? 0xA8CBE6FF : 0x2F6F97FF; }
Colour done_bar() { return theme_in_use().is_light ? 0xA5D6BDFF : 0x2E7D5BFF; }

/// Where something is drawn: upper left and lower right corner.
struct Frame {
  ImVec2 low, high;
  const PlotAxis *x = nullptr, *y = nullptr;

  [[nodiscard]] float width() const { return high.x - low.x; }
  [[nodiscard]] float height() const { return high.y - low.y; }
  [[nodiscard]] ImVec2 at_parts(double right, double up) const {
    return {low.x + static_cast<float>(right) * width(), high.y - static_cast<float>(up) * height()};
  }
  [[nodiscard]] ImVec2 at(const PlanePoint& p) const { return at_parts(x->part(p.right), y->part(p.up)); }
};

float letter() { return ImGui::GetFontSize(); }

void text_at(ImDrawList& list, const ImVec2& at, Colour colour, const std::string& text) {
  list.AddText(at, shade(colour), text.c_str());
}

void draw_y_ticks(ImDrawList& list, const Frame& frame, const PlotAxis& axis) {
  for (const double tick : axis.ticks()) {
    const float y = frame.at_parts(0, axis.part(tick)).y;
    const std::string text = axis.text(tick);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddLine({frame.low.x, y}, {frame.high.x, y}, exact(theme_in_use().plot_lines));
    text_at(list, {frame.low.x - size.x - letter() * 0.3F, y - size.y / 2}, colours::kDim, text);
  }
}

/// A number under its line, where there is room beside the one before.
void draw_x_tick(ImDrawList& list, const Frame& frame, float x, const std::string& text, float& taken) {
  list.AddLine({x, frame.low.y}, {x, frame.high.y}, exact(theme_in_use().plot_lines));
  const float wide = ImGui::CalcTextSize(text.c_str()).x;
  const float left = std::min(x - wide / 2, frame.high.x + letter() * 0.5F - wide);
  if (left < taken) return;
  taken = left + wide + letter() * 0.6F;
  text_at(list, {left, frame.high.y + letter() * 0.2F}, colours::kDim, text);
}

// ------------------------------------------------------------------------------------------------------ target face
void draw_rim(ImDrawList& list, const Frame& frame, const std::vector<PlanePoint>& rim, Colour line, float thick) {
  std::vector<ImVec2> points;
  for (const PlanePoint& p : rim) points.push_back(frame.at(p));
  if (!points.empty()) list.AddPolyline(points.data(), static_cast<int>(points.size()), shade(line), 0, thick);
}

/// Bars along the lower and the left edge: how shots spread over each axis.
void draw_cells(ImDrawList& list, const Frame& frame, const StudyFace& face, double part) {
  const auto most = [](const std::vector<double>& cells) {
    return cells.empty() ? 1.0 : std::max(*std::ranges::max_element(cells), 1e-9);
  };
  const auto count = static_cast<double>(face.cells_across.size());
  for (std::size_t i = 0; i < face.cells_across.size(); ++i) {
    const double left = static_cast<double>(i) / count, right = static_cast<double>(i + 1) / count;
    const bool alone = face.cells_up.empty();
    const double up =
        alone ? face.up.part(face.cells_across[i]) : part * face.cells_across[i] / most(face.cells_across);
    const ImVec2 a = frame.at_parts(left, up), b = frame.at_parts(right, 0);
    list.AddRectFilled(a, {b.x - 1, b.y}, shade(alone ? kHitInk : kCells));
  }
  for (std::size_t i = 0; i < face.cells_up.size(); ++i) {
    const auto rows = static_cast<double>(face.cells_up.size());
    const double low = static_cast<double>(i) / rows, high = static_cast<double>(i + 1) / rows;
    const ImVec2 a = frame.at_parts(0, high), b = frame.at_parts(part * face.cells_up[i] / most(face.cells_up), low);
    list.AddRectFilled(a, {b.x, b.y - 1}, shade(kCells));
  }
}

void draw_dots(ImDrawList& list, const Frame& frame, const StudyTold& told) {
  const StudyShots& shots = told.dots;
  const std::size_t count = told.dots_shown;
  const bool has_targets = !shots.hits.empty();
  const float scale = letter() / 15;
  const float half = (count > 4000 ? 0.6F : count > 500 ? 0.9F : 1.5F) * scale;
  const double opacity = count > 4000 ? 0.55 : 0.85;
  for (std::size_t i = 0; i < count; ++i) {
    const PlanePoint p{shots.quantities[0][i], shots.quantities[1][i]};
    if (!std::isfinite(p.right) || !std::isfinite(p.up)) continue;
    const bool hit = std::ranges::any_of(shots.hits, [i](const std::vector<bool>& target) { return target[i]; });
    const ImVec2 at = frame.at(p);
    list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half},
                       shade(faded(hit || !has_targets ? kHitInk : kMissInk, opacity)));
  }
}

void draw_impacts(ImDrawList& list, const Frame& frame, const StudyFace& face, const StudyTold& told) {
  const float scale = letter() / 15;
  const std::vector<StudyTarget>& targets = told.study.targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (std::holds_alternative<PolygonTarget>(targets[i].shape)) continue;  // need not be convex: its rim alone
    std::vector<ImVec2> points;
    for (const PlanePoint& p : face.targets[i]) points.push_back(frame.at(p));
    if (points.size() > 3) list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), shade(kFace));
  }
  draw_cells(list, frame, face, 0.12);
  draw_dots(list, frame, told);
  for (const auto& rim : face.targets) draw_rim(list, frame, rim, kRim, 1.6F * scale);
  for (std::size_t i = 0; i < face.ellipses.size(); ++i) {
    draw_rim(list, frame, face.ellipses[i], colours::kText, 1.4F * scale);
    const std::string text = std::to_string(i + 1) + "\u03c3";
    const ImVec2 at = frame.at(face.ellipses[i].front()), size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 corner{at.x - size.x / 2, at.y - size.y / 2};
    list.AddRectFilled({corner.x - 2, corner.y}, {corner.x + size.x + 2, corner.y + size.y},
                       exact(faded(theme_in_use().plot, 0.8)), 3);
    text_at(list, corner, colours::kText, text);
  }
  const ImVec2 aim = frame.at(face.aim);
  const float arm = 7 * scale;
  for (const auto& [colour, thick] : {std::pair{exact(theme_in_use().plot), 4.5F}, {shade(colours::kForce), 2.0F}}) {
    list.AddLine({aim.x - arm, aim.y}, {aim.x + arm, aim.y}, colour, thick * scale);
    list.AddLine({aim.x, aim.y - arm}, {aim.x, aim.y + arm}, colour, thick * scale);
  }
}

void draw_legend(ImDrawList& list, const Frame& frame, const StudyFace& face, const StudyTold& told) {
  std::vector<std::pair<std::string, Colour>> words;
  if (!face.ellipses.empty()) {
    const bool has_targets = !told.study.targets.empty();
    words = {{has_targets ? "\u25a0 hits" : "\u25a0 shots", kHitInk}};
    if (has_targets) words.emplace_back("\u25a0 misses", kMissInk);
    if (face.shows(face.aim)) words.emplace_back("+ aim", colours::kForce);
    if (told.dots_shown > 0) words.emplace_back(formatted("the first %zu shots", told.dots_shown), colours::kDim);
    if (face.stretch != 1) words.emplace_back(formatted("heights \u00d7%.2g", face.stretch), colours::kWarning);
  }
  float x = frame.low.x + letter() * 0.5F;
  for (const auto& [text, colour] : words) {
    const std::string shown = text.starts_with("\u25a0") ? text.substr(std::string("\u25a0").size() + 1) : text;
    if (x + ImGui::CalcTextSize(shown.c_str()).x > frame.high.x) break;
    if (shown.size() != text.size()) {
      const float side = letter() * 0.55F, top = frame.low.y - letter() * 0.95F;
      list.AddRectFilled({x, top}, {x + side, top + side}, shade(colour));
      x += side + letter() * 0.3F;
    }
    text_at(list, {x, frame.low.y - letter() * 1.25F}, colour, shown);
    x += ImGui::CalcTextSize(shown.c_str()).x + letter();
  }
}

void draw_face(const StudyTold& told, float width) {
  ImGui::BeginChild("face", {width, 0}, false, ImGuiWindowFlags_NoScrollbar);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  Frame frame{{at.x + letter() * 3.4F, at.y + letter() * 2.7F},
              {at.x + room.x - letter() * 0.6F, at.y + room.y - letter() * 2.6F}};
  if (frame.width() > letter() * 4 && frame.height() > letter() * 4) {
    const StudyFace face = face_of(told.study, told.result, static_cast<double>(frame.width()) / frame.height());
    frame.x = &face.across, frame.y = &face.up;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(frame.low, frame.high, exact(theme_in_use().plot));
    draw_y_ticks(list, frame, face.up);
    float taken = frame.low.x - letter() * 2;
    for (const double tick : face.across.ticks())
      draw_x_tick(list, frame, frame.at_parts(face.across.part(tick), 0).x, face.across.text(tick), taken);
    list.PushClipRect(frame.low, frame.high, true);
    if (face.ellipses.empty())
      draw_cells(list, frame, face, 1);
    else
      draw_impacts(list, frame, face, told);
    list.PopClipRect();
    list.AddRect(frame.low, frame.high, exact(theme_in_use().separator));
    text_at(list, {at.x + letter() * 0.3F, at.y}, colours::kText, face.up.label);
    const ImVec2 size = ImGui::CalcTextSize(face.across.label.c_str());
    text_at(list, {(frame.low.x + frame.high.x - size.x) / 2, frame.high.y + letter() * 1.3F}, colours::kText,
            face.across.label);
    draw_legend(list, frame, face, told);
  }
  ImGui::EndChild();
}

// -------------------------------------------------------------------------------------------------------- settling
std::string count_text(double count) {
  if (count >= 1e9) return formatted("%.3g G", count / 1e9);
  if (count >= 1e6) return formatted("%.3g M", count / 1e6);
  return count >= 1e3 ? formatted("%.3g k", count / 1e3) : formatted("%.0f", count);
}

void draw_band(ImDrawList& list, const Frame& frame, const Settling& settling) {
  const float scale = letter() / 15;
  const auto at = [&](double shots, double value) {
    return frame.at_parts(settling.part(shots), settling.value.part(value));
  };
  std::vector<ImVec2> line;
  const auto& points = settling.points;
  list.PushClipRect(frame.low, frame.high, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0)
      list.AddQuadFilled(at(points[i - 1].shots, points[i - 1].low), at(points[i - 1].shots, points[i - 1].high),
                         at(points[i].shots, points[i].high), at(points[i].shots, points[i].low),
                         shade(faded(kHitInk, 0.22)));
    line.push_back(at(points[i].shots, points[i].value));
  }
  list.AddPolyline(line.data(), static_cast<int>(line.size()), shade(kHitInk), 0, 2 * scale);
  const Settling::Point& last = points.back();
  list.AddLine(at(last.shots, last.low), at(last.shots, last.high), shade(colours::kText), 1.6F * scale);
  list.AddCircleFilled(line.back(), 3.5F * scale, shade(colours::kText));
  list.PopClipRect();
}

void draw_settling(const Settling& settling, const ImVec2& size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy(size);
  const Frame frame{{at.x + letter() * 3.6F, at.y + letter() * 1.4F},
                    {at.x + size.x - letter() * 1.2F, at.y + size.y - letter() * 2.3F}};
  if (frame.width() < letter() * 4 || frame.height() < letter() * 2) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(frame.low, frame.high, exact(theme_in_use().plot));
  draw_y_ticks(list, frame, settling.value);
  float taken = frame.low.x - letter() * 2;
  for (double power = 1; power <= settling.shots.high; power *= 10)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double count = digit * power;
      if (count >= settling.shots.low * 0.999 && count <= settling.shots.high * 1.001)
        draw_x_tick(list, frame, frame.at_parts(settling.part(count), 0).x, count_text(count), taken);
    }
  draw_band(list, frame, settling);
  list.AddRect(frame.low, frame.high, exact(theme_in_use().separator));
  const auto write = [&](float y, Colour colour, const std::string& text) {  // from the axis, or farther left
    const float wide = ImGui::CalcTextSize(text.c_str()).x;
    text_at(list, {std::max(at.x, std::min(frame.low.x, at.x + size.x - wide)), y}, colour, text);
  };
  write(at.y, colours::kText, settling.label);
  write(frame.high.y + letter() * 1.2F, colours::kDim, "shots, with the 95 % interval");
}

void draw_all_settling(const StudyResult& result, float width) {
  ImGui::BeginChild("settling", {width, 0}, false, ImGuiWindowFlags_NoScrollbar);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const std::vector<Settling> list = settling_of(result, 4);
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const auto count = static_cast<float>(std::max<std::size_t>(list.size(), 1));
  for (const Settling& each : list) draw_settling(each, {room.x, (room.y - gap * (count - 1)) / count});
  ImGui::EndChild();
}

// --------------------------------------------------------------------------------------------------------- figures
void draw_figures(const StudyResult& result) {
  if (!ImGui::BeginTable("figures", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("what");
  ImGui::TableSetupColumn("value");
  ImGui::TableSetupColumn("error", ImGuiTableColumnFlags_WidthStretch);  // has two lines where it has no room
  for (const StudyFigure& figure : figures_of(result)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", figure.what.c_str());
    cell("%s", figure.value.c_str());
    ImGui::TableNextColumn();
    std::string error = figure.error;
    const std::size_t comma = error.find(", ");
    if (comma != error.npos && ImGui::CalcTextSize(error.c_str()).x > ImGui::GetContentRegionAvail().x)
      error[comma + 1] = '\n';
    ImGui::TextDisabled("%s", error.c_str());
  }
  ImGui::EndTable();
}

/// "shot.speed" as "speed", "environment.wind.velocity.z" as "velocity.z".
std::string short_path(const std::string& path) {
  std::size_t dot = path.rfind('.');
  if (dot != path.npos && path.size() - dot <= 2) dot = path.rfind('.', dot - 1);
  return dot == path.npos ? path : path.substr(dot + 1);
}

/// What each input does, as bars of its share of the variance.
void draw_inputs(const StudyTold& told) {
  const StudyResult& result = told.result;
  const std::size_t shown = std::min<std::size_t>(2, result.quantities.size());
  if (!told.linear || !ImGui::BeginTable("inputs", 1 + static_cast<int>(shown),
                                         ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame))
    return;
  const bool is_narrow = ImGui::GetContentRegionAvail().x < letter() * 23;
  ImGui::TableSetupColumn(is_narrow ? "of" : "a deviation of", ImGuiTableColumnFlags_WidthStretch,
                          is_narrow ? 0.7F : 1.15F);
  for (std::size_t q = 0; q < shown; ++q)
    ImGui::TableSetupColumn(("does to " + std::string(name(result.quantities[q].quantity))).c_str());
  ImGui::TableHeadersRow();
  for (const StudyInputRow& row : input_rows(told.study, result, *told.linear)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(short_path(row.path).c_str());
    tooltip(row.path + ": " + row.deviation);
    if (!is_narrow) {
      ImGui::SameLine();
      ImGui::TextDisabled("%s", row.deviation.c_str());
    }
    for (std::size_t q = 0; q < shown; ++q) {
      ImGui::TableNextColumn();
      if (row.share[q] < 0.0005) {
        ImGui::TextDisabled("-");
        continue;
      }
      const std::string share = report::readable(100 * row.share[q], 2) + " %", whole = row.effect[q] + "  " + share;
      const bool has_room = ImGui::CalcTextSize(whole.c_str()).x + letter() * 0.6F <= ImGui::GetContentRegionAvail().x;
      const std::string& text = has_room ? whole : share;
      ImGui::PushStyleColor(ImGuiCol_PlotHistogram, exact_tint(study_bar()));
      ImGui::ProgressBar(static_cast<float>(std::clamp(row.share[q], 0.0, 1.0)), {-1, letter() * 1.1F}, "");
      ImGui::PopStyleColor();
      const ImVec2 low = ImGui::GetItemRectMin();
      if (!has_room) tooltip(whole);
      text_at(*ImGui::GetWindowDrawList(), {low.x + letter() * 0.3F, low.y}, colours::kText, text);
    }
  }
  ImGui::EndTable();
}

// --------------------------------------------------------------------------------------------------- what is asked
/// Texts of one kind, each with a button that takes it out, and a line for one more; true where one was taken out.
std::optional<std::size_t> draw_texts(const std::vector<std::string>& texts) {
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::SmallButton("\u00d7")) out = i;
    tooltip("takes it out");
    ImGui::SameLine();
    ImGui::TextWrapped("%s", texts[i].c_str());
    ImGui::PopID();
  }
  return out;
}

/// Texts of one kind, and the action that takes another.
struct AskedTexts {
  const char* title;
  std::vector<std::string> ScenarioStudy::*list;
  const char *action, *hint;
};
constexpr AskedTexts kAsked[] = {
    {"uncertain", &ScenarioStudy::inputs, "study-input", "shot.speed = +- 3 m/s, then Enter"},
    {"targets", &ScenarioStudy::targets, "study-target", "plate: rectangle 45 cm x 75 cm"},
    {"told at the end, and at", &ScenarioStudy::at, "study-at", "500 m, or apex: y, time"},
};

/// A text that is refused stays, to be mended.
void draw_line(Client& client, const AskedTexts& asked, std::string& typed) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::InputTextWithHint("##text", asked.hint, &typed, ImGuiInputTextFlags_EnterReturnsTrue) || typed.empty())
    return;
  if (const Status status = find_action(asked.action)->run(client, typed); !status)
    client.complain(status.error());
  else
    typed.clear();
}

void draw_asked(Client& client) {
  static std::string typed[std::size(kAsked)];
  for (std::size_t i = 0; i < std::size(kAsked); ++i) {
    const AskedTexts& asked = kAsked[i];
    ImGui::TextDisabled("%s", asked.title);
    ImGui::PushID(asked.title);
    if (const auto out = draw_texts(client.study.asked.*asked.list)) remove_study_text(client, asked.list, *out);
    draw_line(client, asked, typed[i]);
    ImGui::PopID();
  }
}

/// A value that is typed, put in with Enter.
void draw_value(Client& client, const char* label, const char* action, const std::string& now, float wide) {
  std::string text = now;
  ImGui::SameLine();
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(0, 4);
  ImGui::SetNextItemWidth(letter() * wide);
  ImGui::PushID(action);
  if (ImGui::InputTextWithHint("##value", "-", &text, ImGuiInputTextFlags_EnterReturnsTrue))
    run_action(client, *find_action(action), text);
  tooltip(std::string(find_action(action)->help));
  ImGui::PopID();
}

/// Where the study is shown: its end, or one of its places.
void draw_places(Client& client) {
  const std::vector<std::string> names = place_names(client.study);
  if (names.empty()) return;
  const auto shown = shown_place(client.study);
  ImGui::SameLine();
  ImGui::TextDisabled("told at");
  ImGui::SameLine(0, 4);
  ImGui::SetNextItemWidth(letter() * 9);
  if (!ImGui::BeginCombo("##place", shown ? names[*shown].c_str() : "end")) return;
  const auto choice = [&](const std::string& name, bool is_shown) {
    if (ImGui::Selectable(name.c_str(), is_shown)) run_action(client, *find_action("study-show"), name);
  };
  choice("end", !shown);
  for (std::size_t i = 0; i < names.size(); ++i) choice(names[i], shown == i);
  ImGui::EndCombo();
}

void draw_buttons(Client& client) {
  const StudyRun& run = client.study.run;
  static constexpr const char* kLabels[] = {"Start", "Pause", "Go on", "Start anew"};
  if (ImGui::Button(kLabels[static_cast<int>(run.state())], {letter() * 6, 0}))
    run_action(client, *find_action("study-run"));
  tooltip("Z");
  ImGui::SameLine();
  if (ImGui::Button("Reset")) client.study.run.clear();
  draw_value(client, "shots", "study-shots", std::to_string(client.study.asked.shots), 6);
  draw_value(client, "or until known to", "study-width", client.study.width, 4);
  draw_places(client);
  if (!run.plan()) return;
  ImGui::SameLine();
  const double done = run.result() ? static_cast<double>(run.result()->shards) : 0;
  const auto all = static_cast<double>(std::max<std::uint64_t>(run.plan()->shards(), 1));
  const bool is_done = run.state() == StudyRun::State::done;
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, exact_tint(is_done ? done_bar() : study_bar()));
  const float bar = std::clamp(ImGui::GetContentRegionAvail().x, letter() * 4, letter() * 9);
  ImGui::ProgressBar(is_done ? 1 : static_cast<float>(done / all), {bar, 0},
                     is_done ? "done" : formatted("%.0f %%", 100 * done / all).c_str());
  ImGui::PopStyleColor();
  if (client.study.begun_at && *client.study.begun_at != client.versions()) {
    static constexpr const char* kChanged = "the shot was changed since";
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(kChanged).x) ImGui::NewLine();
    ImGui::TextColored(tint(colours::kWarning), "%s", kChanged);
  }
}

}  // namespace

void draw_study(Client& client) {
  const StudyRun& run = client.study.run;
  draw_buttons(client);
  if (!run.problem().empty()) coloured_text(colours::kWarning, run.problem());
  if (!run.result()) {
    ImGui::TextWrapped(
        "Every measured number is uncertain. Say which numbers of the next shot and its place are, and how "
        "much, and what is to be hit; then start: the shots are flown with other numbers each time.");
    return draw_asked(client);
  }
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const bool has_settling = room.x > letter() * 44;  // else figures and the face need the room
  const float face = std::min(room.x * (has_settling ? 0.36F : 0.42F), room.y * 1.35F);
  const float settling = (room.x - face) * 0.42F - gap;
  const auto place = shown_place(client.study);
  const StudyTold told = run.told(place);
  draw_face(told, face);
  ImGui::SameLine();
  if (has_settling) {
    draw_all_settling(told.result, settling);
    ImGui::SameLine();
  }
  ImGui::BeginChild("figures");
  if (const std::string lacking = place ? lacking_at(told, run.plan()->study()) : ""; !lacking.empty())
    coloured_text(colours::kDim, lacking);
  draw_figures(told.result);
  draw_inputs(told);
  draw_asked(client);
  ImGui::EndChild();
}

}  // namespace physim::client
