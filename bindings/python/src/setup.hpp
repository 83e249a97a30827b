// Setup: a scenario as Python has it: the tree of what was given, what was read of it, and functions of Python.
#pragma once

#include "common.hpp"
#include "scenario/document.hpp"
#include "scenario/scenario.hpp"

namespace physim::python {

/// It never changes once it is made, so that any number of threads may read it.
struct Setup {
  Value document;
  Scenario scenario;
  std::optional<Scene> scene;  // of its things, where single flights meet them
  std::optional<Function> wind_field, force;

  /// Reads a tree of settings; `file` names it in errors, and other files are looked for beside it.
  [[nodiscard]] static std::shared_ptr<const Setup> make(Value document, const std::string& file,
                                                         std::optional<Function> wind_field = {},
                                                         std::optional<Function> force = {});
  /// One shot with nothing but defaults.
  [[nodiscard]] static std::shared_ptr<const Setup> plain();
  /// The setup of a scenario that was changed.
  [[nodiscard]] std::shared_ptr<const Setup> with(const Scenario& changed) const;

  [[nodiscard]] const ScenarioShot& shot(const std::string& name) const;
  /// The projectile as single flights see it.
  [[nodiscard]] ProjectileDef projectile(const std::string& name) const { return projectile_of(shot(name)); }
  /// End conditions, with the scene that flights meet.
  [[nodiscard]] Until until(const ScenarioShot& shot) const;
  /// Raises what a function of Python raised.
  void raise_kept() const;
};

using SetupPtr = std::shared_ptr<const Setup>;

/// The value of a setting as Python gave it.
[[nodiscard]] Value value_of_python(nb::handle object, const std::string& path);
/// A table of a shot out of settings by path; an error for a path that is none of a shot.
[[nodiscard]] Value shot_of_settings(const nb::dict& settings);

}  // namespace physim::python
