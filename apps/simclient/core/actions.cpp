#include "simclient/core/actions.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "scenario/suggest.hpp"
#include "simclient/core/gallery.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/core/timeline.hpp"
#include "simclient/core/trail_colours.hpp"

namespace physim::client {
namespace {

/// An action out of what it does, a lambda that may leave out the argument and may answer nothing.
template <class Deed>
constexpr auto act(Deed) {
  return +[](Client& client, const std::string& argument) -> Status {
    const auto deed = [&] {
      if constexpr (std::is_invocable_v<Deed, Client&>)
        return Deed{}(client);
      else
        return Deed{}(client, argument);
    };
    if constexpr (std::is_same_v<decltype(deed()), Status>)
      return deed();
    else
      return deed(), Status();
  };
}

using Text = std::string_view;

/// Shows something and hides it.
template <bool Shown::*what>
constexpr Action toggle(Text name, Text keys, Text menu, Text help) {
  return {name,       keys,
          menu,       help,
          "",         act([](Client& c) { c.show.*what = !(c.show.*what); }),
          Loss::none, [](const Client& c) { return c.show.*what; }};
}
/// Opens a panel at the bottom and closes it.
template <BottomPanel panel>
constexpr Action bottom(Text name, Text keys, Text help) {
  return {name,       keys,
          "Panels",   help,
          "",         act([](Client& c) { c.show_bottom(panel); }),
          Loss::none, [](const Client& c) { return c.bottom == panel; }};
}
template <Tool tool>
constexpr auto kInHand = +[](const Client& client) { return client.tool == tool; };
template <int right, int up>
constexpr auto kTurn = act([](Client& client) { client.launcher.turn(right * kDegree, up * kDegree); });

Status select_type(Client& client, const std::string& name) {
  if (client.launcher.select(name)) return {};
  std::vector<std::string_view> names;
  for (const ShotType& type : client.launcher.types()) names.push_back(type.name);
  return Error{"there is no shot type " + in_quotes(name), "", suggestion(name, names, "shot types")};
}

void zoom(Client& client, double factor) {
  client.camera.zoom(factor);
  client.has_moved_view();
}

constexpr double kSlowest = 1.0 / 64, kFastest = 1024;  // [s/s]

void change_speed(Client& client, double factor) {
  client.session.set_time_scale(std::clamp(client.session.time_scale() * factor, kSlowest, kFastest));
}

Status plot(Client& client, const std::string& what) {
  const Result<std::vector<PlotSpec>> plots = parse_plots(what);
  if (!plots) return plots.error();
  client.plots = *plots;
  client.bottom = BottomPanel::plots;
  return {};
}

Status step_back(Client& client) {
  if (client.session.step_back()) return {};
  return Error{"there is nothing to go back to", "", ""};
}

/// Keeps the clock running if it runs.
void go_to(Client& client, double time) {
  const bool was_paused = client.session.is_paused();
  client.session.go_to(step_at(client.session, time));
  client.session.set_paused(was_paused);
}

void leap(Client& client, double part) {
  const Timeline line = timeline_of(client);
  go_to(client, std::clamp(line.now + part * (line.end - line.begin), line.begin, line.end));
}

Result<double> number_of(const std::string& text, const char* what) {
  double value = 0;
  char more = 0;
  if (std::sscanf(text.c_str(), "%lf %c", &value, &more) == 1 && std::isfinite(value)) return value;
  return Error{std::string(what) + " needs a number, not " + in_quotes(text), "", ""};
}

Status seek(Client& client, const std::string& text) {
  const Result<double> time = number_of(text, "seek");
  if (!time) return time.error();
  constexpr double kMost = 1e7;  // [s]
  if (!(*time >= 0 && *time <= kMost)) return Error{"a time is 0 to 1e7 s, not " + in_quotes(text), "", "seek 1.5"};
  return client.session.go_to(step_at(client.session, *time)), Status();
}

Status set_picture_size(Client& client, const std::string& text) {
  const Result<double> size = number_of(text, "picture-size");
  if (!size) return size.error();
  if (!(*size == 1 || *size == 2 || *size == 3 || *size == 4))
    return Error{"a picture is 1, 2, 3 or 4 windows wide, not " + in_quotes(text), "", "picture-size 2"};
  return client.picture_size = static_cast<int>(*size), Status();
}

Status set_film_length(Client& client, const std::string& text) {
  const Result<double> length = number_of(text, "film-length");
  if (!length) return length.error();
  if (!(*length >= 1 && *length <= 120))
    return Error{"a film has 1 to 120 s, not " + in_quotes(text), "", "film-length 10"};
  return client.film_length = *length, Status();
}

Status set_speed(Client& client, const std::string& text) {
  const Result<double> speed = number_of(text, "speed");
  if (!speed) return speed.error();
  if (!(*speed >= kSlowest && *speed <= kFastest))
    return Error{"a speed is 1/64 to 1024, not " + in_quotes(text), "", "speed 0.5"};
  return client.session.set_time_scale(*speed), Status();
}

Status open_file(Client& client, const std::string& file) {
  if (!file.empty()) return client.open(file);
  return client.dialog = Dialog::open, Status();
}

Status use_gallery(Client& client, const std::string& scenario) {
  if (!scenario.empty()) return open_from_gallery(client, scenario);
  return client.dialog = Dialog::gallery, Status();
}

Status save_as(Client& client, const std::string& file) {
  if (!file.empty()) return client.save(file);
  return client.dialog = Dialog::save, Status();
}

/// Four numbers, or nothing: then the mouse sets the ends.
Status wall(Client& client, const std::string& ends) {
  if (ends.empty()) return client.use_tool(Tool::wall), Status();
  double x[4] = {};
  char more = 0;
  if (std::sscanf(ends.c_str(), "%lf %lf %lf %lf %c", &x[0], &x[1], &x[2], &x[3], &more) != 4)
    return Error{"wall needs four numbers, not " + in_quotes(ends), "",
                 "x and z of its two ends in metres: 50 -2 50 2"};
  const double ground = client.session.ground().value_or(0);
  return client.place_wall({x[0], ground, x[1]}, {x[2], ground, x[3]});
}

Status target(Client& client, const std::string& middle) {
  if (middle.empty()) return client.use_tool(Tool::target), Status();
  Vec3d at;
  char more = 0;
  if (std::sscanf(middle.c_str(), "%lf %lf %lf %c", &at.x, &at.y, &at.z, &more) != 3)
    return Error{"target needs three numbers, not " + in_quotes(middle), "",
                 "x, y and z of its middle in metres: 50 1 0"};
  return client.place_target(at);
}

Status choose_material(Client& client, const std::string& name) {
  const std::vector<std::string> choices = materials_to_choose(client.session.scenario());
  if (std::ranges::count(choices, name) == 0) {
    const std::vector<std::string_view> names(choices.begin(), choices.end());
    return Error{"no material is named " + in_quotes(name), "", suggestion(name, names, "materials")};
  }
  return client.placing.material = name, Status();
}

/// By hand or by a script. `what`: the change.
Status tell(Client& client, const std::string& done, const std::string& what, const Status& status) {
  if (status) client.say(done + ": " + what);
  return status;
}

Status undo(Client& client, const std::string&) {
  client.note_changes();
  const std::string what = client.history().undo_text();
  return tell(client, "taken back", what, client.undo());
}

Status redo(Client& client, const std::string&) {
  client.note_changes();
  const std::string what = client.history().redo_text();
  return tell(client, "changed again", what, client.redo());
}

/// The one of a name, or the next one.
Status choose_theme(Client& client, const std::string& name) {
  const std::span<const Theme> all = themes();
  const auto next = static_cast<std::size_t>(client.theme - all.data() + 1) % all.size();
  const Theme* wanted = name.empty() ? &all[next] : find_theme(name);
  if (wanted != nullptr) {
    client.theme = wanted;
    if (name.empty()) client.say("theme " + std::string(wanted->name) + ": " + std::string(wanted->doc));
    return {};
  }
  std::vector<std::string_view> names;
  for (const Theme& theme : all) names.push_back(theme.name);
  return Error{"there is no theme " + in_quotes(name), "", suggestion(name, names, "themes")};
}

/// The quality of a name, or the next one.
Status choose_quality(Client& client, const std::string& wanted) {
  constexpr std::optional<Quality> kAll[] = {Quality::high, Quality::medium, Quality::low, std::nullopt};
  const auto word = [](const std::optional<Quality>& each) { return each ? name(*each) : "picked"; };
  std::optional<Quality>& chosen = client.quality.by_hand;
  if (wanted.empty()) {
    chosen = kAll[(std::ranges::find(kAll, chosen) - kAll + 1) % std::ssize(kAll)];
    return client.say("quality: " + (chosen ? std::string(word(chosen)) : "as frames allow")), Status();
  }
  std::vector<std::string_view> names;
  for (const std::optional<Quality>& each : kAll) {
    if (word(each) == wanted) return chosen = each, Status();
    names.push_back(word(each));
  }
  return Error{"there is no quality " + in_quotes(wanted), "", suggestion(wanted, names, "qualities")};
}

/// By the one of a name, or by the next one.
Status colour_trails(Client& client, const std::string& by) {
  constexpr TrailColour kAll[] = {TrailColour::shot, TrailColour::speed, TrailColour::mach, TrailColour::energy};
  TrailColour& now = client.show.trails_by;
  if (by.empty()) return now = kAll[(static_cast<std::size_t>(now) + 1) % std::size(kAll)], Status();
  std::vector<std::string_view> names;
  for (const TrailColour each : kAll) {
    if (name(each) == by) return now = each, Status();
    names.push_back(name(each));
  }
  return Error{"trails have no colours by " + in_quotes(by), "trail-colour", suggestion(by, names, "they are")};
}

Status check_determinism(Client& client) {
  const Result<DeterminismCheck> check = client.session.check_determinism();
  if (!check) return check.error();
  const std::string told =
      formatted("%llu steps twice: hash %016llx and %016llx, %s", static_cast<unsigned long long>(check->steps),
                static_cast<unsigned long long>(check->first), static_cast<unsigned long long>(check->second),
                check->passed() ? "the same" : "different");
  if (!check->passed()) return Error{told, "determinism", ""};
  return client.say(told), Status();
}

// clang-format off
constexpr Action kActions[] = {
    // the original's
    {"fire", "Enter", "Shot", "fires along the arrow; also a left click, where no world runs by itself", "",
     act([](Client& c) { return c.fire(); })},
    {"fire-whole", "W", "Shot", "computes the whole flight of the next shot, as physim run does, and plays it", "",
     act([](Client& c) { return c.fire_whole(); })},
    {"fire-into-world", "Ctrl+Enter", "Shot", "fires into the world, where it can be changed in flight", "",
     act([](Client& c) { return c.fire(); })},
    {"elevation", "E", "Shot", "next elevation", "", act([](Client& c) { c.launcher.cycle_elevation(); })},
    {"artillery", "1", "Shot", "the original's artillery", "",
     act([](Client& c) { c.launcher.select(0U); })},
    {"bullet", "2", "Shot", "the original's bullet", "", act([](Client& c) { c.launcher.select(1U); })},
    {"laser", "3", "Shot", "the original's laser", "", act([](Client& c) { c.launcher.select(2U); })},
    {"sphere", "4", "Shot", "a smooth sphere", "", act([](Client& c) { c.launcher.select(3U); })},
    {"next-shot", "S", "Shot", "next type of shot", "", act([](Client& c) { c.launcher.next_type(); })},
    {"shot", "", "", "chooses a type of shot", "NAME", select_type},
    {"set", "", "", "changes a setting of the next shot, or of the environment", "PATH=VALUE",
     act([](Client& c, auto& s) { return c.set(s); })},
    {"motion", "F", "Shot", "next model of motion; of the original's shots: velocity, force", "",
     act([](Client& c) { c.launcher.cycle_motion(); })},
    {"drag", "D", "Shot", "next model of drag; of the original's shots: off, constant, force", "",
     act([](Client& c) { c.launcher.cycle_drag(); })},
    {"gravity", "G", "Shot", "next model of gravity; of the original's shots: off, constant, force", "",
     act([](Client& c) { c.launcher.cycle_gravity(); })},
    {"turn-left", "Left", "Shot", "turns the barrel to the left, 1 degree", "", kTurn<-1, 0>},
    {"turn-right", "Right", "Shot", "turns the barrel to the right, 1 degree", "", kTurn<1, 0>},
    {"turn-up", "Up", "Shot", "raises the barrel, 1 degree", "", kTurn<0, 1>},
    {"turn-down", "Down", "Shot", "lowers the barrel, 1 degree", "", kTurn<0, -1>},
    // time
    {"pause", "P Space", "Time", "pauses, and goes on", "",
     act([](Client& c) { c.session.set_paused(!c.session.is_paused()); }), Loss::none,
     +[](const Client& c) { return c.session.is_paused(); }},
    {"step", "N .", "Time", "pauses, and goes one step on", "", act([](Client& c) { c.session.single_step(); })},
    {"back", "B ,", "Time", "pauses, and goes one step back", "", act([](Client& c) { return step_back(c); })},
    {"rewind", "Ctrl+Home", "Time", "goes back to the start of the timeline; what was fired comes again", "",
     act([](Client& c) { go_to(c, timeline_of(c).begin); })},
    {"leap-back", "Ctrl+Left", "Time", "goes back by a twentieth of the timeline", "",
     act([](Client& c) { leap(c, -0.05); })},
    {"leap-on", "Ctrl+Right", "Time", "goes on by a twentieth of the timeline", "",
     act([](Client& c) { leap(c, 0.05); })},
    {"seek", "", "", "pauses, and goes back or on to a time in s", "TIME", seek},
    {"speed", "", "", "seconds of simulation in a second: 0.5", "FACTOR", set_speed},
    {"slower", "-", "Time", "half as fast", "", act([](Client& c) { change_speed(c, 0.5); })},
    {"faster", "+ =", "Time", "twice as fast", "", act([](Client& c) { change_speed(c, 2); })},
    {"restart", "R", "Time", "starts again, and forgets what was fired by hand", "",
     act([](Client& c) { return c.restart(); }), Loss::flights},
    // view
    {"camera", "C", "View", "next camera: orbit, follow, side", "", act([](Client& c) { c.next_camera(); })},
    {"fit", "Home", "View", "looks at everything", "", act([](Client& c) { c.fit_view(); })},
    {"zoom-in", "PageUp", "View", "nearer", "", act([](Client& c) { zoom(c, 0.8); })},
    {"zoom-out", "PageDown", "View", "farther away", "", act([](Client& c) { zoom(c, 1.25); })},
    {"select", "Tab", "View", "selects the next projectile", "", act([](Client& c) { c.select_next(); })},
    toggle<&Shown::trails>("trails", "T", "View", "trails"),
    {"trail-colour", "Ctrl+K", "View", "trails in colours by the next of: shot, speed, mach, energy", "NAME",
     colour_trails},
    toggle<&Shown::attitude>("attitude", "Q", "View",
                             "the cone of the yaw of the selected one, where its attitude is flown"),
    toggle<&Shown::vectors>("vectors", "V", "View", "velocity, acceleration and forces of the selected one"),
    {"add-up", "U", "View", "forces of the selected one from tip to tip: they add up to mass times acceleration", "",
     act([](Client& c) {
       c.show.forces_add_up = !c.show.forces_add_up || !c.show.vectors;
       c.show.vectors = true;
     }),
     Loss::none, +[](const Client& c) { return c.show.forces_add_up && c.show.vectors; }},
    toggle<&Shown::prediction>("prediction", "A", "View", "predicted path of the next shot"),
    toggle<&Shown::marks>("marks", "K", "View", "marks of apex and impact, hits on things, and their names"),
    toggle<&Shown::depth>("drop-lines", "Ctrl+L", "View", "lines down to the ground, and the ways over it"),
    {"theme", "Ctrl+T", "View", "next light and colours: day, dusk, chart, night", "NAME", choose_theme},
    {"quality", "Ctrl+U", "View", "how much is drawn: the next of high, medium, low, picked by how long frames take",
     "NAME", choose_quality},
    {"larger-text", "Ctrl++ Ctrl+=", "View", "larger letters: one of three sizes", "",
     act([](Client& c) { c.letters = c.letters == TextSize::small ? TextSize::usual : TextSize::large; })},
    {"smaller-text", "Ctrl+-", "View", "smaller letters", "",
     act([](Client& c) { c.letters = c.letters == TextSize::large ? TextSize::usual : TextSize::small; })},
    {"clear", "X", "View", "forgets those that have left", "", act([](Client& c) { c.session.clear_tracks(); })},
    // panels
    toggle<&Shown::settings>("settings", "F2", "Panels", "settings of the next shot"),
    toggle<&Shown::statistics>("statistics", "F3", "Panels", "statistics of those in flight"),
    bottom<BottomPanel::plots>("plots", "F4", "plots"),
    {"plot", "", "", "plots quantities over others: y/x speed/time", "QUANTITIES", plot},
    bottom<BottomPanel::compare>("compare", "F5", "the next shot on several rungs"),
    bottom<BottomPanel::performance>("performance", "F7", "what steps and frames cost"),
    bottom<BottomPanel::hits>("hits", "L", "what was hit: where, how fast, and what became of it"),
    bottom<BottomPanel::study>("study", "Y",
                               "how likely is a hit: many flights of the next shot, with numbers that are uncertain"),
    {"study-run", "Z", "Tools", "starts the study of the next shot, pauses it, goes on", "",
     act([](Client& c) { return start_or_pause_study(c); })},
    {"study-again", "", "Tools", "throws away what was flown, and begins the study anew", "",
     act([](Client& c) { return c.bottom = BottomPanel::study, begin_study(c); })},
    {"study-input", "", "", "a number that is uncertain: shot.speed = +- 3 m/s", "TEXT",
     act([](Client& c, auto& s) { return add_study_input(c, s); })},
    {"study-target", "", "", "a target of the study: plate: rectangle 45 cm x 75 cm", "TEXT",
     act([](Client& c, auto& s) { return add_study_target(c, s); })},
    {"study-at", "", "", "a place on the way that the study is told at, too: 500 m, or apex: y, time", "TEXT",
     act([](Client& c, auto& s) { return add_study_at(c, s); })},
    {"study-show", "", "", "shows the study at one of its places, 500 m or apex, or at its end", "PLACE",
     act([](Client& c, auto& s) { return show_study_at(c, s); })},
    {"study-shots", "", "", "how many shots a study has", "N",
     act([](Client& c, auto& s) { return set_study_shots(c, s); })},
    {"study-width", "", "", "a study ends when its figure is known to so much: 1 % of hits, 2 mm of a mean", "WIDTH",
     act([](Client& c, auto& s) { return set_study_width(c, s); })},
    toggle<&Shown::emitters>("emitters", "J", "Panels", "curves and gradients of emitters, drawn with the mouse"),
    toggle<&Shown::panel_keys>("panel-keys", "F8", "Panels",
                               "arrows, Space, Enter and Ctrl+Tab go to the panels, Alt to the menu"),
    toggle<&Shown::play>("play-bar", "Ctrl+B", "Panels", "the bar of play, with the timeline"),
    toggle<&Shown::help>("help", "F1 H", "Help", "keys"),
    // tools
    {"tape", "M", "Tools", "tape measure: left clicks set its ends", "",
     act([](Client& c) { c.use_tool(Tool::tape); }), Loss::none, kInHand<Tool::tape>},
    {"wall", "I", "Tools", "puts up a wall: left clicks set its two ends", "X Z X Z", wall,
     Loss::none, kInHand<Tool::wall>},
    {"target", "O", "Tools", "puts up a target: a left click on a path or the ground", "X Y Z", target,
     Loss::none, kInHand<Tool::target>},
    {"material", "", "", "what the next wall or target is made of", "NAME", choose_material},
    {"undo", "Ctrl+Z", "Tools", "takes back the last change of setting, aim, curve, thing or environment", "",
     undo},
    {"redo", "Ctrl+Y Ctrl+Shift+Z", "Tools", "changes again what was taken back", "", redo},
    {"fire-compared", "F6", "Tools", "fires the next shot on all rungs of the comparison", "",
     act([](Client& c) { return c.fire_compared(); })},
    {"fire-scenario", "", "Tools", "fires all shots of the scenario", "",
     act([](Client& c) { return c.fire_scenario(); })},
    {"test", "", "", "opens and fires a test of the original: 1 2 3 3-drag 4 5 6 6-drag", "NAME",
     act([](Client& c, auto& s) { return open_original_test(c, s); }), Loss::session},
    {"record", "F9", "Tools", "starts again and records; completes the file when it records", "FILE",
     act([](Client& c, auto& s) { return c.record(s); }), Loss::flights},
    {"replay", "F10", "Tools", "plays the last recording, and comes back", "",
     act([](Client& c) { return c.replay(); }), Loss::session},
    {"determinism", "F11", "Tools", "steps, goes back, steps again, and compares", "",
     act([](Client& c) { return check_determinism(c); })},
    {"open", "Ctrl+O", "File", "opens a scenario or recording; also by dropping it on the window", "FILE", open_file,
     Loss::session},
    {"gallery", "Ctrl+G", "File", "shows the scenarios that ship, with pictures; one that is opened flies",
     "SCENARIO", use_gallery, Loss::session},
    {"save", "Ctrl+S", "File", "saves the scenario with the next shot, in its own file", "FILE",
     act([](Client& c, auto& s) { return c.save(s); }), Loss::file},
    {"save-as", "Ctrl+Shift+S", "File", "saves the scenario with the next shot in another file", "FILE", save_as,
     Loss::file},
    {"save-csv", "Ctrl+D", "File", "saves all flights as a table; its format is that of the ending", "FILE",
     act([](Client& c, auto& s) { return c.save_flights(s); })},
    {"picture-of-scene", "F12", "File", "saves a picture of the scene without panels, with title and scale bar", "FILE",
     act([](Client& c, auto& s) { c.pictures.push_back({s, PictureOf::scene}); })},
    {"picture-size", "", "", "pictures of the scene are so many times as wide as the window: 1 to 4", "N",
     set_picture_size},
    {"film", "Ctrl+F12", "File", "films the last seconds as the clock ran, with ffmpeg: .mp4 or .gif", "FILE",
     act([](Client& c, auto& s) { c.pictures.push_back({s, PictureOf::film}); })},
    {"film-length", "", "", "how many seconds of the screen films have, 1 to 120", "SECONDS", set_film_length},
    {"picture", "Shift+F12", "File", "saves a picture of the window", "FILE",
     act([](Client& c, auto& s) { c.pictures.push_back({s, PictureOf::window}); })},
    {"picture-of-plots", "Ctrl+P", "File", "saves a picture of the plots", "FILE",
     act([](Client& c, auto& s) { c.pictures.push_back({s, PictureOf::plots}); })},
    {"quit", "Esc", "File", "leaves", "", act([](Client& c) { c.leaves = true; }), Loss::session},
};
// clang-format on

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const Action> actions() { return kActions; }

std::string label_of(const Action& action) {
  PHYSIM_ASSERT(!action.name.empty());
  std::string label(action.name);
  std::ranges::replace(label, '-', ' ');
  label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
  return label;
}

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

namespace {

bool saves(const Action& action) { return action.name == "save" || action.name == "save-as"; }

/// By a hand. Scripts say whether shots fly whole, and name the file of a new scenario.
Status run_by_hand(Client& client, const Action& action, const std::string& argument) {
  if (action.name == "fire") return client.fire_by_hand();
  const bool has_no_file = action.name == "save" && argument.empty() && client.file().empty();
  if (has_no_file && !client.session.is_replay()) return save_as(client, "");
  return action.run(client, argument);
}

void run_at_once(Client& client, const Action& action, const std::string& argument) {
  const Status status = run_by_hand(client, action, argument);
  if (!status) client.complain(status.error());
  client.note_changes();
  const bool is_saved = status && saves(action) && client.dialog == Dialog::none;
  if (!is_saved || !client.waits) return;
  const Question next = *std::exchange(client.waits, std::nullopt);
  run_at_once(client, *next.action, next.argument);
}

/// What would be lost, for people; empty where nothing would.
std::string loss_of(const Client& client, const Action& action, const std::string& argument) {
  if (action.loss == Loss::none) return "";
  if (action.loss == Loss::file) {
    if (action.name == "save-as" && argument.empty()) return "";  // a file is chosen first
    const bool replaces = !argument.empty() && argument != client.file() && std::filesystem::exists(argument);
    return replaces ? argument + " is there already, and would be replaced." : client.loss_of_saving(argument);
  }
  if ((action.name == "open" || action.name == "gallery") && argument.empty()) return "";  // a file is chosen first
  std::string lost;
  const Session& session = client.session;
  if (action.name == "record" && session.is_recording()) return lost;  // completes it
  const bool is_kept = session.is_recording() && action.name == "replay";
  if (session.is_recording() && !is_kept) lost += "The recording is not complete. ";
  const auto changes = static_cast<unsigned long long>(session.changes_by_hand());
  if (changes > 0 && !is_kept)
    lost += changes == 1 ? "A shot or change by hand since the start is forgotten. "
                         : formatted("%llu shots and changes by hand since the start are forgotten. ", changes);
  if (action.loss == Loss::session && client.has_unsaved_settings())
    lost += "Settings were changed and not saved (Ctrl+S saves). ";
  return lost;
}

}  // namespace

void run_action(Client& client, const Action& action, const std::string& argument) {
  std::string lost = loss_of(client, action, argument);
  if (lost.empty()) return run_at_once(client, action, argument);
  const bool has_changes = action.loss == Loss::file || client.has_unsaved_settings();
  const bool can_save = has_changes && action.loss != Loss::flights && !client.session.is_replay();
  client.question = Question{std::move(lost), &action, argument, can_save};
}

void answer(Client& client, Answer answer) {
  const std::optional<Question> asked = std::exchange(client.question, std::nullopt);
  if (!asked || answer == Answer::no) return;
  if (answer == Answer::yes) return run_at_once(client, *asked->action, asked->argument);
  PHYSIM_ASSERT(asked->can_save);
  if (!saves(*asked->action)) client.waits = asked;
  const bool loses = saves(*asked->action) || !client.loss_of_saving("").empty();
  run_at_once(client, *find_action(loses ? "save-as" : "save"), "");
}

}  // namespace physim::client
