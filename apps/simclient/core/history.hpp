// History: what a hand changed, for undo and redo. Every change of the next shot (settings, aim, rungs, type), of the
// environment, of curves and of things is one step.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "simclient/core/launcher.hpp"

namespace physim::client {

/// Numbers that change with parts of a scenario; equal ones stand for equal parts.
struct ContentVersions {
  std::uint64_t environment = 0, scene = 0, emitters = 0;
  bool operator==(const ContentVersions&) const = default;
};

/// All that a hand changes, at one moment.
struct Moment {
  Launcher launcher;
  std::shared_ptr<const Scenario> scenario;  // shared by moments between which it stayed
  ContentVersions content;
  std::string what;  // of a moment to go to: the change in between, for people
};

class History {
 public:
  /// Forgets all, and begins with what there is.
  void start(const Launcher& launcher, const Scenario& scenario, const ContentVersions& content);
  /// Notes what is different since the last call. Changes of the aim that follow one another are one step as long as
  /// `goes_on`; so are changes of any one setting as long as it `slides`.
  void note(const Launcher& launcher, const Scenario& scenario, const ContentVersions& content, bool goes_on,
            bool slides);
  /// The subject of the next undo or redo, such as "aim" or "mass"; empty if there is none.
  [[nodiscard]] std::string undo_text() const { return undo_.empty() ? "" : undo_.back().what; }
  [[nodiscard]] std::string redo_text() const { return redo_.empty() ? "" : redo_.back().what; }
  /// The moment before the last change, or behind the change that was undone last; null: there is none. It becomes the
  /// one at hand: the caller brings it back.
  const Moment* undo() { return go(undo_, redo_); }
  const Moment* redo() { return go(redo_, undo_); }
  /// The versions of the launcher that brought the moment at hand back.
  void adopt(std::uint64_t version) { noted_ = version; }

 private:
  const Moment* go(std::deque<Moment>& from, std::deque<Moment>& to);

  std::deque<Moment> undo_, redo_;
  Moment now_{Launcher(Scenario()), nullptr, {}, ""};
  std::uint64_t noted_ = 0;  // version of the launcher
};

/// The settings in which two shots differ, in one word or two: "aim", "mass", "drag, motion"; empty if none is known.
[[nodiscard]] std::string difference(const Launcher& before, const Launcher& now);

}  // namespace physim::client
