#include "simclient/core/actions.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "scenario/suggest.hpp"
#include "simclient/core/original_tests.hpp"

namespace physim::client {
namespace {

constexpr double kTurn = 0.0174532925199433;  // one degree [rad]

Status done() { return {}; }

Status select_type(Client& client, const std::string& name) {
  if (client.launcher.select(name)) return done();
  std::vector<std::string_view> names;
  for (const ShotType& type : client.launcher.types()) names.push_back(type.name);
  return Error{"there is no shot type " + in_quotes(name), "", suggestion(name, names, "shot types")};
}

template <std::size_t type>
Status original_type(Client& client, const std::string&) {
  return client.launcher.select(type), done();
}

template <bool Shown::*what>
Status toggle(Client& client, const std::string&) {
  client.show.*what = !(client.show.*what);
  return done();
}

template <int right, int up>
Status turn(Client& client, const std::string&) {
  return client.launcher.turn(right * kTurn, up * kTurn), done();
}

Status change_speed(Client& client, double factor) {
  const double scale = std::clamp(client.session.time_scale() * factor, 1.0 / 64, 64.0);
  client.session.set_time_scale(scale);
  return done();
}

template <BottomPanel panel>
Status toggle_bottom(Client& client, const std::string&) {
  return client.show_bottom(panel), done();
}

Status plot(Client& client, const std::string& what) {
  const Result<std::vector<PlotSpec>> plots = parse_plots(what);
  if (!plots) return plots.error();
  client.plots = *plots;
  client.bottom = BottomPanel::plots;
  return done();
}

template <bool of_plots>
Status take_picture(Client& client, const std::string& file) {
  client.pictures.push_back({file, of_plots});
  return done();
}

Status step_back(Client& client, const std::string&) {
  if (client.session.step_back()) return done();
  return Error{"there is nothing to go back to", "", ""};
}

Status open_file(Client& client, const std::string& file) {
  if (!file.empty()) return client.open(file);
  return client.show.open_dialog = true, done();
}

Status use_tape(Client& client, const std::string&) {
  client.tool = client.tool == Tool::tape ? Tool::fire : Tool::tape;
  client.tape = {};
  if (client.tool == Tool::tape) client.say("tape measure: click two points on paths or on the ground");
  return done();
}

Status check_determinism(Client& client, const std::string&) {
  const Result<DeterminismCheck> check = client.session.check_determinism();
  if (!check) return check.error();
  char text[120];
  std::snprintf(text, sizeof text, "%llu steps twice: hash %016llx and %016llx, %s",
                static_cast<unsigned long long>(check->steps), static_cast<unsigned long long>(check->first),
                static_cast<unsigned long long>(check->second), check->passed() ? "the same" : "different");
  if (!check->passed()) return Error{text, "determinism", ""};
  return client.say(text), done();
}

// clang-format off
constexpr Action kActions[] = {
    // the original's
    {"fire", "Enter", "Shot", "fires along the arrow; also a left click on the scene", "",
     [](Client& c, const std::string&) { return c.fire(); }},
    {"elevation", "E", "Shot", "next elevation", "",
     [](Client& c, const std::string&) { return c.launcher.cycle_elevation(), done(); }},
    {"artillery", "1", "Shot", "the original's artillery", "", original_type<0>},
    {"bullet", "2", "Shot", "the original's bullet", "", original_type<1>},
    {"laser", "3", "Shot", "the original's laser", "", original_type<2>},
    {"sphere", "4", "Shot", "a smooth sphere", "", original_type<3>},
    {"next-shot", "S", "Shot", "next type of shot", "",
     [](Client& c, const std::string&) { return c.launcher.next_type(), done(); }},
    {"shot", "", "", "chooses a type of shot", "NAME", select_type},
    {"set", "", "", "changes a setting of the next shot, or of the environment", "PATH=VALUE",
     [](Client& c, const std::string& assignment) { return c.set(assignment); }},
    {"motion", "F", "Shot", "next model of motion", "",
     [](Client& c, const std::string&) { return c.launcher.cycle_motion(), done(); }},
    {"drag", "D", "Shot", "next model of drag", "",
     [](Client& c, const std::string&) { return c.launcher.cycle_drag(), done(); }},
    {"gravity", "G", "Shot", "next model of gravity", "",
     [](Client& c, const std::string&) { return c.launcher.cycle_gravity(), done(); }},
    {"turn-left", "Left", "Shot", "turns the barrel to the left, 1 degree", "", turn<-1, 0>},
    {"turn-right", "Right", "Shot", "turns the barrel to the right, 1 degree", "", turn<1, 0>},
    {"turn-up", "Up", "Shot", "raises the barrel, 1 degree", "", turn<0, 1>},
    {"turn-down", "Down", "Shot", "lowers the barrel, 1 degree", "", turn<0, -1>},
    // time
    {"pause", "P Space", "Time", "pauses, and goes on", "",
     [](Client& c, const std::string&) { return c.session.set_paused(!c.session.is_paused()), done(); }},
    {"step", "N .", "Time", "pauses, and goes one step on", "",
     [](Client& c, const std::string&) { return c.session.single_step(), done(); }},
    {"back", "B ,", "Time", "pauses, and goes one step back", "", step_back},
    {"slower", "-", "Time", "half as fast", "", [](Client& c, const std::string&) { return change_speed(c, 0.5); }},
    {"faster", "+ =", "Time", "twice as fast", "", [](Client& c, const std::string&) { return change_speed(c, 2); }},
    {"restart", "R", "Time", "starts again", "", [](Client& c, const std::string&) { return c.restart(); }},
    // view
    {"camera", "C", "View", "next camera: orbit, follow, side", "",
     [](Client& c, const std::string&) { return c.next_camera(), done(); }},
    {"fit", "Home", "View", "looks at everything", "",
     [](Client& c, const std::string&) { return c.fit_view(), done(); }},
    {"zoom-in", "PageUp", "View", "nearer", "",
     [](Client& c, const std::string&) { return c.camera.zoom(0.8), done(); }},
    {"zoom-out", "PageDown", "View", "farther away", "",
     [](Client& c, const std::string&) { return c.camera.zoom(1.25), done(); }},
    {"select", "Tab", "View", "selects the next projectile", "",
     [](Client& c, const std::string&) { return c.select_next(), done(); }},
    {"trails", "T", "View", "trails", "", toggle<&Shown::trails>},
    {"vectors", "V", "View", "velocity, acceleration and forces of the selected one", "", toggle<&Shown::vectors>},
    {"prediction", "A", "View", "predicted path of the next shot", "", toggle<&Shown::prediction>},
    {"marks", "K", "View", "apex and impact marks", "", toggle<&Shown::marks>},
    {"clear", "X", "View", "forgets those that have left", "",
     [](Client& c, const std::string&) { return c.session.clear_tracks(), done(); }},
    // panels
    {"settings", "F2", "Panels", "settings of the next shot", "", toggle<&Shown::settings>},
    {"statistics", "F3", "Panels", "statistics of those in flight", "", toggle<&Shown::statistics>},
    {"plots", "F4", "Panels", "plots", "", toggle_bottom<BottomPanel::plots>},
    {"plot", "", "", "plots quantities over others: y/x speed/time", "QUANTITIES", plot},
    {"compare", "F5", "Panels", "the next shot on several rungs", "", toggle_bottom<BottomPanel::compare>},
    {"performance", "F7", "Panels", "what steps and frames cost", "", toggle_bottom<BottomPanel::performance>},
    {"panel-keys", "F8", "Panels", "arrows, Space, Enter and Ctrl+Tab go to the panels, Alt to the menu", "",
     toggle<&Shown::panel_keys>},
    {"help", "F1 H", "Help", "keys", "", toggle<&Shown::help>},
    // tools
    {"tape", "M", "Tools", "tape measure: left clicks set its ends", "", use_tape},
    {"fire-compared", "F6", "Tools", "fires the next shot on all rungs of the comparison", "",
     [](Client& c, const std::string&) { return c.fire_compared(); }},
    {"fire-scenario", "", "Tools", "fires all shots of the scenario", "",
     [](Client& c, const std::string&) { return c.fire_scenario(); }},
    {"test", "", "", "opens and fires a test of the original: 1 2 3 3-drag 4 5 6 6-drag", "NAME",
     [](Client& c, const std::string& name) { return open_original_test(c, name); }},
    {"record", "F9", "Tools", "starts again and records; completes the file when it records", "FILE",
     [](Client& c, const std::string& file) { return c.record(file); }},
    {"replay", "F10", "Tools", "plays the last recording, and comes back", "",
     [](Client& c, const std::string&) { return c.replay(); }},
    {"determinism", "F11", "Tools", "steps, goes back, steps again, and compares", "", check_determinism},
    {"open", "Ctrl+O", "File", "opens a scenario or recording; also by dropping it on the window", "FILE", open_file},
    {"save", "Ctrl+S", "File", "saves the scenario with the next shot", "FILE",
     [](Client& c, const std::string& file) { return c.save(file); }},
    {"save-csv", "Ctrl+D", "File", "saves all flights as a table; its format is that of the ending", "FILE",
     [](Client& c, const std::string& file) { return c.save_flights(file); }},
    {"picture", "F12", "File", "saves a picture of the window", "FILE", take_picture<false>},
    {"picture-of-plots", "Ctrl+P", "File", "saves a picture of the plots", "FILE", take_picture<true>},
    {"quit", "Esc", "File", "leaves", "", [](Client& c, const std::string&) { return c.leaves = true, done(); }},
};
// clang-format on

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const Action> actions() { return kActions; }

const Action* find_action(std::string_view name) {
  const auto found =
      std::find_if(std::begin(kActions), std::end(kActions), [&](const Action& a) { return a.name == name; });
  return found == std::end(kActions) ? nullptr : found;
}

const Action* action_of_key(std::string_view key, bool ctrl) {
  const std::string wanted = (ctrl ? "Ctrl+" : "") + std::string(key);
  for (const Action& action : kActions)
    for (std::size_t at = 0; at < action.keys.size();) {
      const std::size_t end = std::min(action.keys.find(' ', at), action.keys.size());
      if (equal_ignoring_case(action.keys.substr(at, end - at), wanted)) return &action;
      at = end + 1;
    }
  return nullptr;
}

std::string actions_table() {
  std::string out = "| action | keys | what it does |\n|---|---|---|\n";
  for (const Action& action : kActions) {
    std::string name(action.name), keys;
    if (!action.argument.empty()) name += " " + std::string(action.argument);
    for (const char c : action.keys) keys += c == ' ' ? std::string("` `") : std::string(1, c);
    out += "| `" + name + "` | " + (keys.empty() ? "-" : "`" + keys + "`") + " | " + std::string(action.help) + " |\n";
  }
  return out;
}

void run_action(Client& client, const Action& action, const std::string& argument) {
  if (Status status = action.run(client, argument); !status) client.complain(status.error());
}

}  // namespace physim::client
