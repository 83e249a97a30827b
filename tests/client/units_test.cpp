// Units as typed survive Save: what is changed keeps the unit that it has in its file, what is typed the unit that it
// was typed with, and angles that have neither are in degrees. All else of the file stays as it is.
#include <map>

#include "cli/program.hpp"
#include "client/support.hpp"
#include "math/angles.hpp"
#include "physim/units.hpp"
#include "scenario/document.hpp"
#include "scenario/revise.hpp"
#include "scenario/units.hpp"
#include "settings/units.hpp"
#include "shipped.hpp"
#include "simclient/core/quick_settings.hpp"
#include "simclient/core/study_desk.hpp"

namespace physim::client::client_units {
namespace {

using testing_cli::Folder;
using testing_cli::lines_of;

constexpr const char* kShipped = PHYSIM_SOURCE_DIR "/scenarios/";

/// A client on a copy of a shipped scenario, beside the motors that it may name.
Client client_on_copy(const Folder& folder, const std::string& scenario, const std::string& file) {
  if (!std::filesystem::exists(folder / "motors"))
    std::filesystem::copy(std::string(kShipped) + "motors", folder / "motors");
  std::filesystem::copy_file(kShipped + scenario + ".toml", file);
  return std::move(open_client(file, {}).value());
}

std::vector<SettingRow> all_rows() {
  std::vector<SettingRow> rows = setting_rows("shot"), more = setting_rows("environment");
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

/// The number with unit that a file has for a row; empty if it has another value.
std::string said_with_unit(const FileUnits& file, const SettingRow& row, const std::string& shot) {
  const Value* value = file.find(row.path, shot);
  const auto* text = value && row.kind == SettingRow::Kind::text ? value->get<std::string>() : nullptr;
  const Quantity quantity = row.node->entry->quantity;
  const bool has_unit = text && si_unit(quantity) != "" && !trimmed(behind_number(*text)).empty();
  return has_unit && parse_quantity(*text, quantity) ? *text : "";
}

/// Every value reads back with the same bits.
void expect_saved(const Client& client, const std::string& file) {
  Scenario wanted = client.session.scenario();
  const ScenarioShot& next = client.launcher.shot();
  for (ScenarioShot& shot : wanted.shots)
    if (shot.projectile.name == next.projectile.name) shot = next;
  const Scenario saved = must(load_scenario(file));
  EXPECT_EQ(effective_settings(saved), effective_settings(wanted)) << testing_cli::read(file);
}

class ScenarioWithUnits : public testing::TestWithParam<std::string> {};

/// A setting of each unit, changed as a row of the panel is: with the unit, and by the bare number in SI.
TEST_P(ScenarioWithUnits, KeepsThemWhenSettingsAreChanged) {
  for (const bool is_bare : {false, true}) {
    const Folder folder;
    const std::string file = folder / "mine.toml", before = testing_cli::read(kShipped + GetParam() + ".toml");
    Client client = client_on_copy(folder, GetParam(), file);
    const std::string shot = client.launcher.shot().projectile.name;
    const std::size_t expected = client.session.scenario().expect.size();
    const FileUnits was = client.units();
    std::map<std::string, std::pair<SettingRow, std::string>> changed;  // of each unit
    for (const SettingRow& row : all_rows()) {
      const std::string said = said_with_unit(was, row, shot), unit(behind_number(said));
      const Quantity quantity = row.node->entry->quantity;
      if (said.empty() || changed.contains(unit)) continue;
      const double number = std::stod(said);
      const std::string wanted = number_text(number == 0 ? 0.25 : number * 1.03125) + unit;
      const std::string typed = is_bare ? number_text(parse_quantity(wanted, quantity).value()) : wanted;
      if (!client.set(row, typed)) continue;  // of another setting's range
      changed[unit] = {row, wanted};
      EXPECT_NEAR(std::stod(row_text(row, client.session.scenario(), client.launcher.shot(), client.units()).value()),
                  std::stod(wanted), 1e-6 * std::abs(std::stod(wanted)))
          << "the row shows it in its unit: " << row.path;
    }
    ASSERT_TRUE(client.save("")) << GetParam();
    const std::string after = testing_cli::read(file);
    const FileUnits now(after);
    for (const auto& [unit, change] : changed)
      EXPECT_EQ(said_with_unit(now, change.first, shot), change.second) << change.first.path << "\n" << after;
    EXPECT_EQ(load_scenario(file).value().expect.size(), expected);
    expect_saved(client, file);
    const std::vector<std::string> old_lines = lines_of(before), new_lines = lines_of(after);
    ASSERT_EQ(new_lines.size(), old_lines.size()) << after;
    std::size_t others = 0;
    for (std::size_t i = 0; i < old_lines.size(); ++i) others += old_lines[i] != new_lines[i];
    EXPECT_LE(others, changed.size()) << after;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ScenarioWithUnits, testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& test) { return test.param; });

// ----------------------------------------------------------------------------------------------------------- one by
// one
/// What a file says behind a key, up to the end of the line.
std::string said(const std::string& file, const std::string& key) {
  const std::string text = testing_cli::read(file);
  const std::size_t at = text.find(key + " = ");
  return at == text.npos ? "" : text.substr(at, text.find('\n', at) - at);
}

TEST(Units, ThatAreTypedAreKept) {
  const Folder folder;
  const std::string file = folder / "mine.toml";
  Client client = client_on_copy(folder, "308_168gr_g7", file);
  ASSERT_TRUE(run(client, "set shot.sight.height=2 in; set shot.twist=25cm; set shot.mass=11 g; save"));
  EXPECT_NE(said(file, "height").find("\"2 in\""), std::string::npos) << testing_cli::read(file);
  EXPECT_EQ(said(file, "twist").find("twist = \"25cm\""), 0U) << testing_cli::read(file);
  EXPECT_EQ(said(file, "mass").find("mass = \"11 g\""), 0U) << testing_cli::read(file);
  ASSERT_TRUE(client.undo());
  ASSERT_TRUE(client.save(""));
  EXPECT_EQ(said(file, "mass"), said(kShipped + std::string("308_168gr_g7.toml"), "mass")) << "as it was";
}

TEST(Units, ThatAreTypedAreKeptInNewFiles) {
  const Folder folder;
  const std::string file = folder / "a.toml";
  Client client = client_of();
  ASSERT_TRUE(run(client, "bullet; set shot.mass=170 gr; set shot.position=1 ft, 2, 3 yd; save " + file));
  EXPECT_EQ(said(file, "mass"), "mass = \"170 gr\"") << testing_cli::read(file);
  EXPECT_EQ(said(file, "position"), "position = [\"1 ft\", \"2 m\", \"3 yd\"]") << testing_cli::read(file);
}

/// Options of the command line are typed, too.
TEST(Units, OfOptionsAreKept) {
  const testing_cli::File file(
      "a.toml", "physim = 1\n[world]\nduration = \"2 s\"\n[[shot]]\nmass = \"170 gr\"\nlength = \"1 in\"\n");
  Client client =
      std::move(open_client(file, {"world.duration=0.1 min", "shot.mass=10 g", "shot.length=0.0508"}).value());
  ASSERT_TRUE(client.save(""));
  EXPECT_EQ(said(file, "length"), "length = \"2 in\"") << testing_cli::read(file);
  EXPECT_EQ(said(file, "duration"), "duration = \"0.1 min\"");
  EXPECT_EQ(said(file, "mass"), "mass = \"10 g\"");
}

/// A text of "0.5 m" is a name.
TEST(Units, AreOfNumbersAlone) {
  const testing_cli::File file("a.toml", "physim = 1\ntitle = \"2 ft\"\n[[shot]]\nlength = \"2 ft\"\n");
  Client client = std::move(open_client(file, {"title=0.6096 m", "shot.length=1.2192"}).value());
  ASSERT_TRUE(client.save(""));
  EXPECT_EQ(said(file, "title"), "title = \"0.6096 m\"");
  EXPECT_EQ(said(file, "length"), "length = \"4 ft\"");
}

TEST(Units, OfComponentsAndListsAreKept) {
  const testing_cli::File file("a.toml",
                               "physim = 1\n[environment]\nwind.velocity = [ \"2 mph\", 0, \"1 kn\" ] # wind\n"
                               "[[shot]]\n[output]\nranges = [\n  \"100 yd\",  # near\n  \"200 yd\",\n]\n");
  Client client = std::move(open_client(file, {"output.ranges=[91.44, 274.32, 365.76]"}).value());
  ASSERT_TRUE(client.set("environment.wind.velocity=[1.34112, 0, \"1 kn\"]"));
  ASSERT_TRUE(client.save(""));
  EXPECT_EQ(said(file, "wind.velocity"), "wind.velocity = [ \"3 mph\", 0, \"1 kn\" ] # wind");
  EXPECT_NE(testing_cli::read(file).find("ranges = [\n  \"100 yd\",  # near\n  \"300 yd\", \"400 yd\",\n]\n"),
            std::string::npos)
      << testing_cli::read(file);
}

/// A slider goes to numbers that there are in the unit of the file.
TEST(Units, OfSlidersAreThoseOfTheFile) {
  const testing_cli::File file("a.toml",
                               "physim = 1\n[environment]\nwind.velocity = [\"1 mph\", \"0.1 mph\", \"2 "
                               "mph\"]\n[[shot]]\nname = \"a\"\nmass = \"170 gr\"\n"
                               "speed = \"2700 ft/s\"\nelevation = \"3 mil\"\n");
  Client client = std::move(open_client(file, {}).value());
  for (const QuickSetting& setting : quick_settings(client))
    if (setting.what != Quick::drag) {
      ASSERT_TRUE(set_quick(client, setting, setting.low + 0.377 * (setting.high - setting.low))) << setting.name;
    }
  ASSERT_TRUE(client.save(""));
  const std::pair<const char*, const char*> wanted[] = {{"mass", " gr\""},
                                                        {"speed", " ft/s\""},
                                                        {"elevation", " mil\""},
                                                        {"azimuth", " deg\""},
                                                        {"wind.velocity", " mph\""}};
  for (const auto& [key, unit] : wanted) {
    EXPECT_NE(said(file, key).find(unit), std::string::npos) << testing_cli::read(file);
  }
  EXPECT_NE(said(file, "wind.velocity").find("\"0.1 mph\""), std::string::npos) << "it did not change";
  expect_saved(client, file);
}

/// Whatever its last digits are, a value reads back as the same bits.
TEST(Units, NeverChangeAValue) {
  const testing_cli::File file(
      "a.toml", "physim = 1\n[[shot]]\nmass = \"170 gr\"\nelevation = \"3 deg\"\nazimuth = 0.1\ntwist = \"10 in\"\n");
  Client client = std::move(open_client(file, {}).value());
  ScenarioShot shot = client.launcher.shot();
  std::size_t kept = 0;
  constexpr std::size_t kTimes = 60;
  for (std::size_t i = 1; i <= kTimes; ++i) {
    shot.projectile.mass = 0.01 + 1e-4 / static_cast<double>(i);
    shot.launch.elevation = 0.3 / static_cast<double>(i);
    shot.launch.azimuth = -0.7 / static_cast<double>(i);
    shot.projectile.twist = 0.3 / static_cast<double>(i);
    client.launcher.set_shot(shot);
    ASSERT_TRUE(client.save(""));
    expect_saved(client, file);
    kept += said(file, "twist").ends_with(" in\"");
  }
  EXPECT_GE(kept, kTimes / 2) << "where a number of inches has the same bits";
}

TEST(Units, OfAnglesAreDegrees) {
  const Folder folder;
  const std::string file = folder.write("a.toml", "physim = 1\n[[shot]]\nelevation = 0.5\n");
  Client client = std::move(open_client(file, {}).value());
  client.launcher.point(-20 * kDegree, 12.5 * kDegree);
  for (const SettingRow& row : setting_rows("shot")) {
    const auto text = row_text(row, client.session.scenario(), client.launcher.shot(), client.units());
    if (row.path == "shot.elevation") {
      EXPECT_EQ(text, "12.5 deg");
    }
    if (row.path == "shot.azimuth") {
      EXPECT_EQ(text, "-20 deg");
    }
    if (row.path == "shot.sight.cant") {
      EXPECT_EQ(text, "0 deg");
    }
  }
  ASSERT_TRUE(client.save(""));
  EXPECT_EQ(said(file, "elevation"), "elevation = \"12.5 deg\"");
  EXPECT_EQ(said(file, "azimuth"), "azimuth = \"-20 deg\"");
  Client fresh = client_of();
  fresh.launcher.point(0, 12.5 * kDegree);
  ASSERT_TRUE(fresh.save(folder / "b.toml"));
  EXPECT_EQ(said(folder / "b.toml", "elevation"), "elevation = \"12.5 deg\"") << testing_cli::read(folder / "b.toml");
}

/// Inputs of a study are texts, kept as they are typed; those that were there keep their lines and comments.
TEST(Units, OfStudiesAreKept) {
  const Folder folder;
  const std::string file = folder / "mine.toml", before = testing_cli::read(kShipped + std::string("study_308.toml"));
  Client client = client_on_copy(folder, "study_308", file);
  ASSERT_TRUE(add_study_input(client, "shot.mass = +- 0.5 gr"));
  ASSERT_TRUE(client.save(""));
  const std::string after = testing_cli::read(file);
  EXPECT_NE(after.find("\n  \"shot.mass = +- 0.5 gr\",\n]"), after.npos) << after;
  for (const std::string& line : lines_of(before)) EXPECT_NE(after.find(line + "\n"), after.npos) << line;
}

/// Distributions in the place of numbers stay where they are.
TEST(Units, OfStudiesAreKeptBesideDistributionsInPlace) {
  const Folder folder;
  const std::string file = folder / "mine.toml";
  Client client = client_on_copy(folder, "study_model_rocket", file);
  const std::string before = testing_cli::read(file);
  ASSERT_TRUE(add_study_input(client, "shot.mass = +- 0.5 gr"));
  EXPECT_EQ(client.loss_of_saving(""), "");
  ASSERT_TRUE(client.save(""));
  const std::string after = testing_cli::read(file);
  EXPECT_NE(after.find("\n  \"shot.mass = +- 0.5 gr\",\n]"), after.npos) << after;
  for (const std::string& line : lines_of(before)) EXPECT_NE(after.find(line + "\n"), after.npos) << line;
  EXPECT_EQ(load_scenario(file).value().study.inputs, client.study.asked.inputs);
}

/// Things and emitters are put into the file key by key.
TEST(Units, OfListsOfTablesAreKept) {
  const Folder folder;
  const std::string file = folder / "mine.toml";
  Client client = client_on_copy(folder, "emit_machine_gun", file);
  std::vector<ScenarioEmitter> emitters = client.session.scenario().emitters;
  const std::string before = testing_cli::read(file);
  emitters[0].def.start.speed.value *= 2;
  ASSERT_TRUE(client.set_emitters(emitters));
  ASSERT_TRUE(client.save(""));
  const std::string after = testing_cli::read(file);
  EXPECT_TRUE(load_scenario(file).value().emitters[0].def.start.speed == emitters[0].def.start.speed);
  std::size_t others = 0;
  const auto old_lines = lines_of(before), new_lines = lines_of(after);
  for (const std::string& line : new_lines) others += std::ranges::count(old_lines, line) == 0;
  EXPECT_LE(others, 1U) << after;
}

}  // namespace
}  // namespace physim::client::client_units
