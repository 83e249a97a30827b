#include "simclient/core/history.hpp"

#include <utility>
#include <vector>

#include "simclient/core/setting_rows.hpp"

namespace physim::client {
namespace {

constexpr std::size_t kMostMoments = 100;

std::string content_difference(const Moment& before, const Scenario& scenario, const ContentVersions& now) {
  if (before.content.scene != now.scene) {
    const auto &was = before.scenario->things, &is = scenario.things;
    if (is.size() != was.size()) return (is.size() > was.size() ? is : was).back().name;
    return "things";
  }
  return before.content.emitters != now.emitters ? "curves of emitters" : "environment";
}

}  // namespace

std::string difference(const Launcher& before, const Launcher& now) {
  if (before.type() != now.type()) return "shot " + now.types()[now.type()].name;
  ScenarioShot was = before.shot();
  const ScenarioShot& is = now.shot();
  was.launch.azimuth = is.launch.azimuth, was.launch.elevation = is.launch.elevation;
  was.launch.sight.dial = is.launch.sight.dial;
  static const auto* const rows = new std::vector<SettingRow>(setting_rows("shot"));
  std::string names;
  const Scenario none;
  std::size_t count = 0;
  for (const SettingRow& row : *rows) {
    if (row_text(row, none, was) == row_text(row, none, is) || ++count > 2) continue;
    names += (names.empty() ? "" : ", ") + row.name;
  }
  if (count > 2) names += ", ...";
  const bool turns = before.azimuth() != now.azimuth() || before.elevation() != now.elevation();
  return !names.empty() ? names : turns ? "aim" : "";
}

void History::start(const Launcher& launcher, const Scenario& scenario, const ContentVersions& content) {
  undo_.clear();
  redo_.clear();
  now_ = {launcher, std::make_shared<const Scenario>(scenario), content, ""};
  noted_ = launcher.version();
}

void History::note(const Launcher& launcher, const Scenario& scenario, const ContentVersions& content, bool goes_on,
                   bool slides) {
  const bool is_same_content = content == now_.content;
  if (noted_ == launcher.version() && is_same_content) return;
  noted_ = launcher.version();
  std::string what =
      is_same_content ? difference(now_.launcher, launcher) : content_difference(now_, scenario, content);
  if (is_same_content && what.empty()) return void(now_.launcher = launcher);
  Moment before = std::exchange(
      now_, {launcher, is_same_content ? now_.scenario : std::make_shared<const Scenario>(scenario), content, ""});
  redo_.clear();
  if ((slides || (goes_on && what == "aim")) && undo_text() == what) return;
  before.what = std::move(what);
  undo_.push_back(std::move(before));
  if (undo_.size() > kMostMoments) undo_.pop_front();
}

const Moment* History::go(std::deque<Moment>& from, std::deque<Moment>& to) {
  if (from.empty()) return nullptr;
  Moment there = std::move(from.back());
  from.pop_back();
  now_.what = there.what;
  to.push_back(std::exchange(now_, std::move(there)));
  return &now_;
}

}  // namespace physim::client
