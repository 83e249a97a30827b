// Actions: everything that can be done, once. Keys, menus, scripts and the documentation are made from this table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "simclient/core/client.hpp"

namespace physim::client {

/// What an action gives up.
enum class Loss {
  none,
  flights,  // what was fired and changed by hand
  session,  // that, and settings that were not saved
  file,     // what stands in the file that it writes
};

struct Action {
  std::string_view name;      // in scripts: "fire"
  std::string_view keys;      // "E", "P Space", "Ctrl+S": any of them; empty: none
  std::string_view menu;      // under which it stands: "Shot"
  std::string_view help;      // one line
  std::string_view argument;  // what a script may give to it, "FILE"; empty: nothing
  Status (*run)(Client& client, const std::string& argument) = nullptr;
  Loss loss = Loss::none;
  bool (*is_on)(const Client& client) = nullptr;  // the menu ticks it then; null: it has no tick
};

[[nodiscard]] std::span<const Action> actions();
[[nodiscard]] const Action* find_action(std::string_view name);
/// The label of an action in menus: "Fire into world".
[[nodiscard]] std::string label_of(const Action& action);
/// The action of a key. Letters count in either case: Shift and Caps Lock change nothing for those without Shift in
/// their name. `key` is "E", "Space", "F5"...; `ctrl` whether Ctrl is held.
[[nodiscard]] const Action* action_of_key(std::string_view key, bool ctrl);

/// All actions as a table in Markdown, for the documentation.
[[nodiscard]] std::string actions_table();

/// Runs an action as a hand asks for it: where work would be lost the client asks first. What goes wrong is shown.
void run_action(Client& client, const Action& action, const std::string& argument = "");
enum class Answer {
  no,
  yes,
  save,  // first: in the scenario's own file where that loses nothing, else in one that is chosen
};
/// Answers the question that the client asks.
void answer(Client& client, Answer answer);

}  // namespace physim::client
