// Every shipped scenario is edited in each panel, saved, and opened again: nothing is lost.
#include <cmath>
#include <functional>
#include <set>

#include "base/text.hpp"
#include "cli/program.hpp"
#include "client/support.hpp"
#include "scenario/revise.hpp"
#include "shipped.hpp"
#include "simclient/core/emitter_edit.hpp"
#include "simclient/core/layout.hpp"
#include "simclient/core/quick_settings.hpp"

namespace physim::client::client_panels {
namespace {

/// Types another number into a row, in the unit that it has there; false where it has none, or is refused.
bool change_number(Client& client, const SettingRow& row) {
  const auto text = row_text(row, client.session.scenario(), client.launcher.shot(), client.units());
  if (row.unit.empty() || row.kind != SettingRow::Kind::text || !text) return false;
  char* end = nullptr;
  const double value = std::strtod(text->c_str(), &end);
  const bool is_number = end != text->c_str() && std::isfinite(value) && value != 0 && (*end == 0 || *end == ' ');
  const double rounded = std::strtod(formatted("%.4g", value * 1.0625).c_str(), nullptr);
  return is_number && client.set(row, formatted("%.15g", rounded) + end);
}

int change_numbers(Client& client, const char* table) {
  int changed = 0;
  for (const SettingRow& row : setting_rows(table)) changed += change_number(client, row);
  return changed;
}

/// The panels. Each changes what it can of a scenario; how many changes that were.
struct Panel {
  const char* name;
  std::function<int(Client&)> edit;
};

int edit_quick(Client& client) {
  int changed = 0;
  for (const QuickSetting& setting : quick_settings(client)) {
    const bool is_zero = setting.what == Quick::elevation && client.launcher.is_zeroed();  // no part of the file
    if (is_zero || setting.what == Quick::drag) continue;
    const double to =
        setting.is_logarithmic ? std::sqrt(setting.low * setting.high) : setting.low * 0.3 + setting.high * 0.7;
    changed += static_cast<bool>(set_quick(client, setting, to));
  }
  return changed;
}

int edit_curves(Client& client) {
  std::vector<ScenarioEmitter> emitters = client.session.scenario().emitters;
  int changed = 0;
  for (ScenarioEmitter& emitter : emitters)
    for (EmitterLine& line : lines_of(emitter.def)) {
      const bool is_size = line.title == "size over life", is_colour = line.title == "colour over life";
      if (is_size) changed += add_key(*line.curve, CurveKey{0.4375, value_of(*line.curve, 0.4375) * 0.5}).has_value();
      if (is_colour) changed += add_key(*line.gradient, ColourKey{0.4375, 0x4080C0FF}).has_value();
    }
  return changed > 0 && client.set_emitters(emitters) ? changed : 0;
}

int edit_rungs(Client& client) {
  int changed = 0;
  for (const SettingRow& row : setting_rows("shot.fidelity")) {
    const auto text = row_text(row, client.session.scenario(), client.launcher.shot(), client.units());
    const bool is_of_emitter = row.name == "motion" && !client.session.scenario().emitters.empty();
    if (row.kind != SettingRow::Kind::choice || !text || is_of_emitter) continue;
    const auto now = std::ranges::find(row.choices, *text);
    if (now == row.choices.end()) continue;
    changed += static_cast<bool>(client.set(row, std::string(*(now == row.choices.begin() ? now + 1 : now - 1))));
  }
  return changed;
}

int edit_things(Client& client) {
  const Vec3d at = client.launcher.shot().launch.position;
  client.placing.material = "oak";
  return static_cast<bool>(client.place_target(at + Vec3d{40, 1, 3})) +
         static_cast<bool>(client.place_wall(at + Vec3d{60, 0, -3}, at + Vec3d{60, 0, 3}));
}

const Panel kPanels[] = {
    {"settings", [](Client& c) { return change_numbers(c, "shot"); }},
    {"sliders", edit_quick},
    {"curves", edit_curves},
    {"rungs", edit_rungs},
    {"environment",
     [](Client& c) {
       return change_numbers(c, "environment") + (c.set("environment.wind.velocity=3 kn, 1 kn, -2 kn") ? 1 : 0);
     }},
    {"things", edit_things},
};

/// Comments of a file, as far as they stand on lines of their own.
std::multiset<std::string> comments_of(const std::string& text) {
  std::multiset<std::string> comments;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (text[at] == '#') comments.insert(text.substr(at, end - at));
    at = end + 1;
  }
  return comments;
}

/// What the rows of the panels say of the next shot and its environment.
std::vector<std::string> rows_of(const Client& client) {
  std::vector<std::string> rows;
  for (const char* table : {"shot", "environment"})
    for (const SettingRow& row : setting_rows(table))
      rows.push_back(row.path + " = " +
                     row_text(row, client.session.scenario(), client.launcher.shot(), client.units()).value_or(""));
  return rows;
}

/// Bodies are those of worlds: a file of flights says nothing of them.
bool is_of_world(const Client& client, const std::string& row) {
  return row.starts_with("shot.body.") && !client.session.scenario().world.given;
}

/// What a file has to say after a change.
Scenario expected_of(const Client& client, const Scenario& before) {
  Scenario expected = client.session.scenario();
  ScenarioShot next = client.launcher.shot();
  const auto same = [&](const ScenarioShot& s) { return s.projectile.name == next.projectile.name; };
  const auto namesake = std::ranges::find_if(expected.shots, same);
  if (!before.world.given && expected.things.size() == before.things.size())
    next.body = namesake != expected.shots.end() ? namesake->body : BodyDef();
  if (namesake != expected.shots.end())
    *namesake = next;
  else if (!before.world.given)
    expected.shots.push_back(next);
  const bool becomes_world = !before.world.given && before.things.empty() && !expected.things.empty();
  if (!becomes_world) return expected;
  expected.expect.clear();
  return with_world(expected);
}

class Panels : public testing::TestWithParam<std::string> {
 protected:
  /// What the client cannot put into the text of a file, and asks about: a number in whose place a distribution stands,
  /// and a material among those that things of a house name.
  static bool is_asked_about(const Panel& panel) {
    const std::string_view name = panel.name;
    return (GetParam() == "study_model_rocket" && name == "sliders") ||
           (GetParam() == "house_of_wood" && name == "things");
  }
};

TEST_P(Panels, LoseNothing) {
  const std::string shipped = PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml";
  const Scenario before = load_scenario(shipped).value();
  for (const Panel& panel : kPanels) {
    SCOPED_TRACE(panel.name);
    const testing_cli::Folder folder;
    std::filesystem::create_directory_symlink(PHYSIM_SOURCE_DIR "/scenarios/motors", folder / "motors");
    const std::string file = folder / "edited.toml";
    Client client = client_of(GetParam());
    const int changed = panel.edit(client);
    const bool has_part = std::string_view(panel.name) != "curves" || !before.emitters.empty();
    ASSERT_EQ(changed > 0, has_part);
    if (!has_part) continue;
    const Status saved = client.save(file);
    ASSERT_TRUE(saved) << saved.error().text();
    Client again = must(open_client(file, {}));
    const Scenario &set = client.session.scenario(), &found = again.session.scenario();
    const bool becomes_world = !before.world.given && before.things.empty() && !set.things.empty();
    const bool is_of_shots = std::ranges::count(before.shots, client.launcher.shot().projectile.name,
                                                [](const ScenarioShot& s) { return s.projectile.name; }) > 0;
    if (is_of_shots) {
      ASSERT_TRUE(again.launcher.select(client.launcher.shot().projectile.name));
      const std::vector<std::string> rows = rows_of(client), later = rows_of(again);
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (!becomes_world && !is_asked_about(panel) && !is_of_world(client, rows[i])) {
          EXPECT_EQ(later[i], rows[i]);
        }
    }
    EXPECT_EQ(found.shots.size(), std::max<std::size_t>(before.shots.size(), before.world.given ? 0 : 1));
    EXPECT_TRUE(found.environment == set.environment);
    EXPECT_EQ(found.things.size(), set.things.size());
    EXPECT_EQ(found.volleys.size(), before.volleys.size());
    ASSERT_EQ(found.emitters.size(), set.emitters.size());
    for (std::size_t i = 0; i < set.emitters.size(); ++i)
      EXPECT_TRUE(have_same_lines(found.emitters[i].def, set.emitters[i].def)) << i;
    EXPECT_TRUE(say_the_same(found, expected_of(client, before)));
    if (!becomes_world) {  // else the client asks first
      EXPECT_EQ(found.expect.size(), before.expect.size());
      EXPECT_EQ(client.loss_of_saving("").empty(), !is_asked_about(panel));
    }
    if (!becomes_world && !is_asked_about(panel)) {
      EXPECT_EQ(comments_of(testing_cli::read(file)), comments_of(testing_cli::read(shipped)));
    }
  }
}

/// Smoke that forces act on cannot fly a closed form: such a file would not open.
TEST(PanelsOfAFile, AreNotSavedIfTheyCouldNotBeOpened) {
  const testing_cli::Folder folder;
  Client client = client_of("emit_embers");
  ASSERT_TRUE(client.set("shot.fidelity.motion=closed_form"));
  const Status saved = client.save(folder / "edited.toml");
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().text().find("closed form"), std::string::npos) << saved.error().text();
  EXPECT_FALSE(std::filesystem::exists(folder / "edited.toml"));
}

/// Two settings of a table that the file has none of yet: the second one stands beside the first.
TEST(PanelsOfAFile, AddSettingsToANewTable) {
  const std::string text = testing_cli::read(PHYSIM_SOURCE_DIR "/scenarios/308_168gr_g7.toml");
  const testing_cli::File file("mine.toml", text);
  Client client = std::move(open_client(file, {}).value());
  ASSERT_TRUE(client.set("environment.gravity.acceleration=9.7 m/s^2"));
  ASSERT_TRUE(client.set("environment.gravity.radius=6400 km"));
  EXPECT_EQ(client.loss_of_saving(""), "");
  ASSERT_TRUE(client.save(""));
  const std::string saved = testing_cli::read(file);
  EXPECT_EQ(comments_of(saved), comments_of(text));
  EXPECT_NE(saved.find("gravity.acceleration = \"9.7 m/s^2\"\ngravity.radius = \"6400 km\"\n"), std::string::npos)
      << saved;
}

INSTANTIATE_TEST_SUITE_P(Shipped, Panels, testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& test) { return test.param; });

TEST(Layout, ColumnsOfATableGiveWayByTheirRank) {
  const float widths[] = {100, 80, 60, 40};
  const int ranks[] = {0, 2, 1, 2};
  using Shown = std::vector<std::size_t>;
  EXPECT_EQ(columns_that_fit(widths, ranks, 280), (Shown{0, 1, 2, 3}));
  EXPECT_EQ(columns_that_fit(widths, ranks, 279), (Shown{0, 1, 2})) << "of equal ones the last";
  EXPECT_EQ(columns_that_fit(widths, ranks, 239), (Shown{0, 2}));
  EXPECT_EQ(columns_that_fit(widths, ranks, 159), (Shown{0}));
  EXPECT_EQ(columns_that_fit(widths, ranks, 10), (Shown{0})) << "it stays";
}

}  // namespace
}  // namespace physim::client::client_panels
