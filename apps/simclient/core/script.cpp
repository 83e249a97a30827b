#include "simclient/core/script.hpp"

#include <charconv>

#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim::client {
namespace {

constexpr int kMaxWait = 1'000'000;

std::vector<std::string_view> action_names() {
  std::vector<std::string_view> names = {"wait"};
  for (const Action& action : actions()) names.push_back(action.name);
  return names;
}

Result<ScriptStep> parse_step(std::string_view text, const std::string& place) {
  const std::size_t space = text.find_first_of(" \t");
  const std::string_view name = text.substr(0, space);
  const std::string_view argument = space == text.npos ? std::string_view() : trimmed(text.substr(space));
  if (name == "wait") {
    int frames = 0;
    const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), frames);
    const bool good = error == std::errc() && end == argument.data() + argument.size();
    if (!good || frames < 1 || frames > kMaxWait)
      return Error{"wait needs a number of frames, not " + in_quotes(argument), place, "wait 30"};
    return ScriptStep{nullptr, "", frames};
  }
  const Action* action = find_action(name);
  if (action == nullptr)
    return Error{"there is no action " + in_quotes(name), place, suggestion(name, action_names(), "actions")};
  if (action->argument.empty() && !argument.empty())
    return Error{std::string(name) + " takes nothing, but was given " + in_quotes(argument), place, ""};
  return ScriptStep{action, std::string(argument), 0};
}

}  // namespace

Result<Script> Script::parse(std::string_view text) {
  Script script;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(";\n"), text.size());
    const std::string_view part = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (part.empty() || part.front() == '#') continue;
    Result<ScriptStep> step = parse_step(part, "script, action " + std::to_string(number));
    if (!step) return step.error();
    script.steps_.push_back(std::move(*step));
  }
  return script;
}

Status Script::run(Client& client) {
  if (waiting_ > 0 && --waiting_ > 0) return {};
  while (next_ < steps_.size()) {
    const ScriptStep& step = steps_[next_++];
    if (step.action == nullptr) {
      waiting_ = step.frames;
      return {};
    }
    if (Status status = step.action->run(client, step.argument); !status) {
      Error error = status.error();
      if (error.place.empty()) error.place = "script: " + std::string(step.action->name);
      return error;
    }
    client.note_changes();
  }
  return {};
}

int Script::frames() const {
  int frames = 1;
  for (const ScriptStep& step : steps_) frames += step.frames;
  return frames;
}

}  // namespace physim::client
