#include "simclient/ui/ui.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>

#include "physim/names.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/labels.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/ui/legend.hpp"

namespace physim::client {
namespace {

constexpr const char *kMenu = "scene menu", *kQuestion = "Is that meant?", *kFilm = "Filming";

const char* mode_text(CameraMode mode) {
  switch (mode) {
    case CameraMode::orbit: return "orbit";
    case CameraMode::follow: return "follow";
    case CameraMode::side: return "side";
  }
  return "";
}

/// The change that undo or redo is about, empty if there is none; nothing for other actions.
std::optional<std::string> change_of(const Client& client, const Action& action) {
  if (action.name == "undo") return client.history().undo_text();
  if (action.name == "redo") return client.history().redo_text();
  return std::nullopt;
}

/// A line of a menu: ticked where it is on, grey where it would do nothing, with what it does beside the pointer.
void action_item(Client& client, const Action& action, const std::string& label) {
  const std::optional<std::string> change = change_of(client, action);
  const bool is_on = action.is_on != nullptr && action.is_on(client), is_idle = change && change->empty();
  if (ImGui::MenuItem(label.c_str(), std::string(action.keys).c_str(), is_on, !is_idle)) run_action(client, action);
  const std::string help = std::string(action.help) + (change && !is_idle ? ": " + *change : "");
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", help.c_str());
}
void action_item(Client& client, const char* name, const char* label) {
  action_item(client, *find_action(name), label);
}

}  // namespace

Ui::Ui(float scale) : scale_(scale) {
  load_fonts(scale);
  use_theme(themes().front(), scale);
}

bool Ui::set_scale(float scale) {
  if (scale_ == scale) return false;
  scale_ = scale;
  ImGui::GetIO().Fonts->Clear();
  load_fonts(scale);
  use_theme(theme_in_use(), scale);
  return true;
}

void Ui::draw(Client& client, const Scene& scene) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  layout_ = make_layout(client, size.x, size.y, scale_);
  has_bare_plots_ =
      client.bottom == BottomPanel::plots &&
      std::ranges::any_of(client.pictures, [](const PictureWish& wish) { return wish.of == PictureOf::plots; });
  client.cursor.reset();
  steer(client);
  draw_labels(client, scene);
  draw_menu_bar(client);
  if (layout_.settings.width > 0) settings_.draw(client, layout_.settings);
  if (layout_.statistics.width > 0) draw_statistics_panel(client, layout_.statistics);
  if (layout_.bottom.height > 0) draw_bottom_panel(client, layout_.bottom, has_bare_plots_);
  if (layout_.play.height > 0) play_.draw(client, layout_.play, scale_);
  draw_status(client);
  draw_messages(client);
  draw_probe(client);
  draw_placing(client);
  draw_context_menu(client);
  if (client.show.emitters) emitters_.draw(client, layout_.scene, scale_);
  if (client.show.help) draw_help(client);
  files_.draw(client, {0, 0, size.x, size.y}, scale_);
  gallery_.draw(client, {0, 0, size.x, size.y}, scale_);
  draw_question(client);
  draw_film(client);
}

/// Lets the keyboard into the panels, and out again.
void Ui::steer(const Client& client) {
  ImGuiIO& io = ImGui::GetIO();
  const bool was_on = (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
  if (was_on == client.show.panel_keys) return;
  io.ConfigFlags ^= ImGuiConfigFlags_NavEnableKeyboard;
  if (client.show.panel_keys && layout_.settings.width > 0)
    ImGui::SetWindowFocus(kSettings);
  else
    ImGui::SetWindowFocus(client.show.panel_keys ? kStatistics : nullptr);
}

bool Ui::close_something(Client& client) {
  if (client.dialog != Dialog::none) return client.dialog = Dialog::none, true;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
    ImGui::ClosePopupsOverWindow(nullptr, false);
    return true;
  }
  if (client.show.help) return client.show.help = false, true;
  if (client.show.emitters) return client.show.emitters = false, true;
  if (client.show.panel_keys) return client.show.panel_keys = false, true;
  if (client.tool != Tool::fire) return client.use_tool(client.tool), true;
  return false;
}

// --------------------------------------------------------------------------------------------------------------- menus
void Ui::draw_menu_bar(Client& client) {
  if (!ImGui::BeginMainMenuBar()) return;
  for (const char* menu : {"File", "Shot", "Time", "View", "Panels", "Tools", "Help"}) {
    if (!ImGui::BeginMenu(menu)) continue;
    for (const Action& action : actions())
      if (action.menu == menu) action_item(client, action, label_of(action));
    if (std::string_view(menu) == "Tools") draw_tests_menu(client);
    if (std::string_view(menu) == "File") draw_picture_menus(client), draw_recent_menu(client);
    ImGui::EndMenu();
  }
  const std::string& title = client.session.scenario().title;
  const float at = ImGui::GetWindowWidth() - ImGui::CalcTextSize(title.c_str()).x - 12 * scale_;
  if (at > ImGui::GetCursorPosX() + 8 * scale_) {  // left out where there is no room for it
    ImGui::SetCursorPosX(at);
    ImGui::TextDisabled("%s", title.c_str());
  }
  ImGui::EndMainMenuBar();
}

void Ui::draw_tests_menu(Client& client) {
  ImGui::Separator();
  if (!ImGui::BeginMenu("Tests of the original")) return;
  for (const OriginalTest& test : original_tests())
    if (ImGui::MenuItem(std::string(test.title).c_str()))
      run_action(client, *find_action("test"), std::string(test.name));
  ImGui::EndMenu();
}

void Ui::draw_picture_menus(Client& client) {
  ImGui::Separator();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (ImGui::BeginMenu("Size of pictures")) {
    for (const int times : {1, 2, 3, 4}) {
      const std::string text = formatted("%d\u00d7: %.0fx%.0f", times, static_cast<double>(window.x) * times,
                                         static_cast<double>(window.y) * times);
      if (ImGui::MenuItem(text.c_str(), "", client.picture_size == times)) client.picture_size = times;
    }
    ImGui::EndMenu();
  }
  if (!ImGui::BeginMenu("Length of films")) return;
  for (const int seconds : {3, 5, 10, 30, 60})
    if (ImGui::MenuItem(formatted("%d s", seconds).c_str(), "", client.film_length == seconds))
      client.film_length = seconds;
  ImGui::EndMenu();
}

void Ui::draw_recent_menu(Client& client) {
  const std::vector<std::string> files(client.recent.files().begin(), client.recent.files().end());
  ImGui::Separator();
  if (!ImGui::BeginMenu("Recent files", !files.empty())) return;
  for (const std::string& file : files)
    if (ImGui::MenuItem(file.c_str())) run_action(client, *find_action("open"), file);
  ImGui::EndMenu();
}

void Ui::draw_context_menu(Client& client) {
  if (opens_menu_) ImGui::OpenPopup(kMenu);
  opens_menu_ = false;
  if (!ImGui::BeginPopup(kMenu)) return;
  ImGui::TextDisabled("the original left here: see the last line");
  ImGui::Separator();
  action_item(client, "fire", "Fire");
  action_item(client, "pause", client.session.is_paused() ? "Go on" : "Pause");
  action_item(client, "restart", "Start again");
  action_item(client, "fit", "Look at everything");
  action_item(client, "camera", "Next camera");
  action_item(client, "tape", "Tape measure");
  action_item(client, "wall", "Put up a wall");
  action_item(client, "target", "Put up a target");
  ImGui::Separator();
  action_item(client, "quit", "Leave");
  ImGui::EndPopup();
}

void Ui::draw_help(Client& client) {
  centre_window(layout_.scene, 560 * scale_, 620 * scale_);
  if (ImGui::Begin("Keys", &client.show.help, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::TextWrapped(
        "Left click: fires; selects, in a scenario that runs by itself. Right drag: turns the view. Middle drag: moves "
        "it. Wheel: nearer, farther. "
        "Letters count in either case.");
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
      ImGui::TableSetupColumn("key");
      ImGui::TableSetupColumn("what it does", ImGuiTableColumnFlags_WidthStretch);
      for (const Action& action : actions()) {
        if (action.keys.empty()) continue;
        cell("%s", std::string(action.keys).c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", std::string(action.help).c_str());
      }
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

/// How far a film is, while the session goes through its time.
void Ui::draw_film(Client& client) {
  if (client.filmed && !ImGui::IsPopupOpen(kFilm)) ImGui::OpenPopup(kFilm);
  const Box& s = layout_.scene;
  ImGui::SetNextWindowPos({s.x + s.width / 2, s.y + s.height / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(s.width, 320 * scale_), 0});
  if (!ImGui::BeginPopupModal(kFilm, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) return;
  if (!client.filmed) {
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  ImGui::ProgressBar(static_cast<float>(*client.filmed), {-1, 0});
  if (ImGui::Button("give up (Esc)")) client.stops_film = true;
  ImGui::EndPopup();
}

void Ui::draw_question(Client& client) {
  if (client.question && !ImGui::IsPopupOpen(kQuestion)) ImGui::OpenPopup(kQuestion);
  const Box& s = layout_.scene;
  ImGui::SetNextWindowPos({s.x + s.width / 2, s.y + s.height / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(s.width, 420 * scale_), 0});
  if (!ImGui::BeginPopupModal(kQuestion, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) return;
  if (!client.question) {
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  ImGui::TextWrapped("%s", client.question->text.c_str());
  const bool is_of_file = client.question->action->loss == Loss::file, can_save = client.question->can_save;
  const std::string yes = std::string(client.question->action->name) + " (Enter)";
  if (ImGui::Button(yes.c_str())) answer(client, Answer::yes);
  if (can_save) {
    const std::string saves = is_of_file ? "save as ..." : "save, then " + std::string(client.question->action->name);
    go_beside(saves.c_str());
    if (ImGui::Button(saves.c_str())) answer(client, Answer::save);
  }
  go_beside("no (Esc)");
  if (client.question && ImGui::Button("no (Esc)")) answer(client, Answer::no);
  ImGui::EndPopup();
}

// ------------------------------------------------------------------------------------------- what is always to be seen
std::vector<Ui::Item> Ui::status_items(Client& client) const {
  const Launcher& launcher = client.launcher;
  const Session& session = client.session;
  std::vector<Item> items = {{"", formatted("%.2f s%s", session.time(), session.is_paused() ? "  PAUSED" : ""),
                              session.is_paused() ? colours::kWarning : colours::kText, "time of the simulation"}};
  if (session.is_recording()) items.push_back({"", "RECORDING", colours::kAcceleration, ""});
  if (session.is_replay()) items.push_back({"", session.is_over() ? "REPLAY ENDED" : "REPLAY", colours::kVelocity, ""});
  if (client.show.panel_keys) items.push_back({"", "KEYS: PANELS", colours::kForce, ""});
  const double asked = session.time_scale(), reached = session.time_scale_reached();
  const bool is_slow = reached < 0.97 * asked;
  items.push_back({"", is_slow ? formatted("\u00d7%.2g of \u00d7%g", reached, asked) : formatted("\u00d7%g", asked),
                   is_slow ? colours::kWarning : colours::kText,
                   "seconds of simulation in a second; where two are shown the steps take too long for what is asked"});
  if (!session.is_replay()) {
    if (!client.fires_by_click()) items.push_back({"", "Enter fires", colours::kDim, "a click selects", true});
    items.push_back({"shot", launcher.types()[launcher.type()].name, colours::kText, ""});
    items.push_back({"elevation", launcher.elevation_text(), colours::kText, ""});
    const Fidelity& wanted = launcher.shot().projectile.fidelity;
    const Prediction& next = client.prediction();
    const Fidelity& granted = next.error ? wanted : next.granted.fidelity;
    const auto rung = [&](const char* effect, auto Fidelity::*of_effect) {
      const bool is_as_asked = granted.*of_effect == wanted.*of_effect;
      std::string note = is_as_asked ? "" : std::string(name(wanted.*of_effect)) + " was asked for";
      for (const FidelityNote& each : next.granted.notes)
        if (!is_as_asked && each.effect == effect) note += ": " + each.reason;
      items.push_back({effect, std::string(name(granted.*of_effect)), is_as_asked ? colours::kText : colours::kWarning,
                       std::move(note), is_as_asked});
    };
    rung("motion", &Fidelity::motion);
    if (launcher.is_original()) {
      const auto effect = [&](const char* label, OriginalEffect acts_by, const char* what) {
        const bool is_idle = acts_by == OriginalEffect::force && launcher.original_motion() != Motion::force;
        items.push_back({label, std::string(name(acts_by)), is_idle ? colours::kWarning : colours::kText,
                         is_idle ? "does nothing: motion 'velocity' knows no forces" : what});
      };
      effect("drag", launcher.original_drag(), "of the original: off, damping, or a force by k1 and k2");
      effect("gravity", launcher.original_gravity(), "of the original: off, the shot's own, or a force of 4 m/s\u00b2");
    } else {
      rung("drag", &Fidelity::drag);
      rung("gravity", &Fidelity::gravity);
    }
  }
  items.push_back({"camera",
                   formatted(client.camera.stretch != 1 ? "%s, heights \u00d7%g" : "%s", mode_text(client.camera.mode),
                             client.camera.stretch),
                   colours::kText, "", client.camera.stretch == 1});
  if (client.quality.is_told())
    items.push_back({"quality", client.quality.text(), colours::kText,
                     "of what is drawn, not of what flies; View changes it, and pictures have all of it"});
  items.push_back({"in flight", std::to_string(session.in_flight()), colours::kText, ""});
  return items;
}

void Ui::draw_status(Client& client) {
  const Box& b = layout_.status;
  ImGui::SetNextWindowPos({b.x, b.y});
  ImGui::SetNextWindowSize({b.width, b.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * scale_, 5 * scale_});
  ImGui::Begin("status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings);
  std::vector<Item> items = status_items(client);
  const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float gap = 14 * scale_, total = 16 * scale_;
  const auto width_of = [&](const Item& item) {
    return width(item.what) + (item.what.empty() ? 0 : 4 * scale_) + width(item.value) + gap;
  };
  for (const Item& item : items) total += width_of(item);
  for (auto item = items.rbegin(); item != items.rend() && total > b.width; ++item) {  // what matters least goes first
    if (!item->is_detail) continue;
    total -= width_of(*item);
    item->value.clear();
  }
  std::erase_if(items, [](const Item& item) { return item.value.empty(); });
  const bool has_room = total <= b.width;  // else what things are called gives way to what they are
  if (!has_room) gap = 8 * scale_;
  for (const Item& item : items) {
    if (has_room && !item.what.empty()) {
      ImGui::TextDisabled("%s", item.what.c_str());
      ImGui::SameLine(0, 4 * scale_);
    }
    ImGui::TextColored(tint(item.colour), "%s", item.value.c_str());
    tooltip(item.note.empty() ? item.what : item.note);
    ImGui::SameLine(0, gap);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void Ui::draw_labels(const Client& client, const Scene& scene) {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const Box& s = layout_.scene;
  list->PushClipRect({s.x, s.y}, {s.x + s.width, s.y + s.height});
  const float line = ImGui::GetTextLineHeight();
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  std::vector<Box> taken;
  if (scene.legend) taken.push_back(draw_legend(*list, *scene.legend, s.x + s.width, s.y, scale_));
  for (const PlacedLabel& each :
       place_labels(scene.labels, client.camera, s, line, scale_, width_of, std::move(taken))) {
    const std::string& text = each.label->text;
    list->AddRectFilled({each.x - 2, each.y}, {each.x + width_of(text) + 2, each.y + line},
                        exact(theme_in_use().label));
    list->AddText({each.x, each.y}, shade(each.label->colour), text.c_str());
  }
  list->PopClipRect();
}

void Ui::draw_messages(const Client& client) {
  if (client.messages().empty()) return;
  const Box& s = layout_.scene;
  ImGui::SetNextWindowPos({s.x + s.width / 2, s.y + 10 * scale_}, ImGuiCond_Always, {0.5F, 0});
  ImGui::SetNextWindowSize({std::min(s.width - 20 * scale_, 620 * scale_), 0});
  ImGui::SetNextWindowBgAlpha(0.9F);
  ImGui::Begin("messages", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const auto& messages = client.messages();
  for (std::size_t i = messages.size() > 3 ? messages.size() - 3 : 0; i < messages.size(); ++i)
    coloured_text(messages[i].is_error ? colours::kWarning : colours::kText, messages[i].text);
  ImGui::End();
}

/// What a wall or a target will be like, while the mouse puts one up.
void Ui::draw_placing(Client& client) {
  if (client.tool != Tool::wall && client.tool != Tool::target) return;
  const bool is_wall = client.tool == Tool::wall;
  const Box& s = layout_.scene;
  ImGui::SetNextWindowPos({s.x + 10 * scale_, s.y + s.height - 10 * scale_}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({std::min(s.width - 20 * scale_, 270 * scale_), 0});
  ImGui::Begin(is_wall ? "A wall###placing" : "A target###placing", nullptr,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  const std::string& material = client.placing.material;
  ImGui::SetNextItemWidth(150 * scale_);
  if (ImGui::BeginCombo("material", material.empty() ? "any" : material.c_str())) {
    for (const std::string& each : materials_to_choose(client.session.scenario()))
      if (ImGui::Selectable(each.c_str(), each == material)) client.placing.material = each;
    ImGui::EndCombo();
  }
  const auto length = [&](const char* what, double& value) {
    double typed = value;
    ImGui::SetNextItemWidth(150 * scale_);
    if (ImGui::InputDouble(what, &typed, 0, 0, "%.4g") && typed > 0 && typed < 1e6) value = typed;
  };
  if (is_wall) length("height [m]", client.placing.height);
  if (is_wall) length("thickness [m]", client.placing.thickness);
  if (!is_wall) length("radius [m]", client.placing.radius);
  ImGui::TextDisabled("Esc: puts up nothing");
  ImGui::End();
}

void Ui::draw_probe(Client& client) {
  if (!mouse_on_scene_ || client.tool == Tool::wall || client.tool == Tool::target) return;
  const auto found = client.probe(mouse_);
  if (!found) return;
  const TrackSample& s = found->sample;
  if (found->track != nullptr) client.cursor = found->track->born + s.time;
  const Colour colour = found->track ? found->track->colour : colours::kText;
  if (const auto at = client.camera.project(s.position))
    ImGui::GetBackgroundDrawList()->AddCircle(
        {layout_.scene.x + static_cast<float>(at->x), layout_.scene.y + static_cast<float>(at->y)}, 6 * scale_,
        shade(colour), 0, 2 * scale_);
  ImGui::BeginTooltip();
  ImGui::TextColored(tint(colour), "%s", found->track ? found->track->title().c_str() : "predicted");
  ImGui::Text("time      %.3f s", s.time);
  ImGui::Text("position  %.3f, %.3f, %.3f m", s.position.x, s.position.y, s.position.z);
  ImGui::Text("speed     %.3f m/s", length(s.velocity));
  ImGui::EndTooltip();
}

}  // namespace physim::client
