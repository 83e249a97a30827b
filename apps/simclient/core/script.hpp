// Script: actions for a client that runs without a person.
//
//   "elevation; fire; wait 30; camera; shot rifle_bullet; fire"
//
// Actions are parted by semicolons or new lines. `wait N` lets N frames pass; all else happens at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simclient/core/actions.hpp"

namespace physim::client {

struct ScriptStep {
  const Action* action = nullptr;  // null: a wait
  std::string argument;
  int frames = 0;  // of a wait
};

class Script {
 public:
  Script() = default;
  /// An error where it asks for something that there is not, with its place.
  [[nodiscard]] static Result<Script> parse(std::string_view text);

  /// Called at the start of each frame: does what is due. The first error ends the script.
  [[nodiscard]] Status run(Client& client);
  /// Frames until everything is done.
  [[nodiscard]] int frames() const;

 private:
  std::vector<ScriptStep> steps_;
  std::size_t next_ = 0;
  int waiting_ = 0;
};

}  // namespace physim::client
