#include "command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

#include "scenario/files_in_use.hpp"
#include "scenario/suggest.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

// What nobody expected: the first option among it, else the first word; empty where all was expected.
std::string unexpected(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::ranges::find_if(words, [](const std::string& word) { return word.starts_with("-"); });
  return option != words.end() ? *option : words.empty() ? "" : words.front();
}

// "; did you mean "speed"?" for the nearest of the names, or nothing.
std::string guess(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string_view found = nearest(word, candidates);
  return found.empty() ? "" : "did you mean \"" + std::string(found) + "\"? ";
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11's message as one of ours: "error: unknown option "--plott"; did you mean "--plot"? see physim run --help".
Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string words = app.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    words += " " + command->get_name();
  }
  std::vector<std::string> subcommands;
  for (const CLI::App* each : command->get_subcommands([](const CLI::App*) { return true; }))
    subcommands.push_back(each->get_name());

  std::string message = error.what(), hint;
  if (const std::string word = unexpected(app); word.size() > 1 && word.front() == '-') {
    message = "unknown option " + in_quotes(word);
    hint = guess(word.substr(0, word.find('=')), options_of(*command));
  } else if (!word.empty() && !subcommands.empty()) {
    const std::string group = command == &app ? "" : command->get_name() + " ";
    message = "there is no command " + in_quotes(group + word);
    hint = guess(word, subcommands);
  } else if (!word.empty()) {
    message = "unexpected argument " + in_quotes(word);
  }
  if (message.size() > 1 && std::isupper(static_cast<unsigned char>(message[1])) == 0)
    message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return {.message = message, .hint = hint + "see " + words + " --help"};
}

}  // namespace

Option& Option::type_name(const char* name) {
  option_.type_name(name);
  return *this;
}

Option& Option::required() {
  option_.required();
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_.check(CLI::IsMember(words));
  return *this;
}

Option& Option::within(int low, int high) {
  option_.check(CLI::Range(low, high));
  return *this;
}

Option& Option::within(unsigned low, unsigned high) {
  option_.check(CLI::Range(low, high));
  return *this;
}

Option& Option::one_value_each() {
  option_.type_size(1)->allow_extra_args(false);
  return *this;
}

/// The output options of a command.
struct Command::Outputs {
  struct Each {
    std::string option;
    const std::string& path;
    OutputKind kind;
  };
  std::vector<Each> list;

  [[nodiscard]] Status announce(FilesInUse& files) const {
    for (const Each& each : list) {
      if (each.path.empty()) continue;
      Status status = each.kind.is_folder ? files.add_folder(each.path, each.option)
                                          : files.add_output(each.path, each.option, each.kind.replaces);
      if (status && *each.kind.incomplete != 0)
        status = files.add_output(each.path + each.kind.incomplete, each.option);
      if (!status) return status;
    }
    return {};
  }
};

Command::Command(CLI::App& app, int& exit_code)
    : app_(app), exit_code_(exit_code), outputs_(std::make_shared<Outputs>()) {}

Command Command::add_command(const char* name, const char* doc) {
  return {*app_.add_subcommand(name, doc), exit_code_};
}

Option Command::add_option(const char* name, std::string& value, const char* doc) {
  return Option(*app_.add_option(name, value, doc));
}

Option Command::add_option(const char* name, std::vector<std::string>& values, const char* doc) {
  return Option(*app_.add_option(name, values, doc));
}

namespace {

template <class Value>
Option add_nonempty(CLI::App& app, const char* name, Value& value, const char* type, const char* doc) {
  const auto refuse_empty = [](const std::string& text) {
    return std::string(text.empty() ? "the value is empty" : "");
  };
  return Option(*app.add_option(name, value, doc)->check(refuse_empty)->type_name(type));
}

}  // namespace

Option Command::add_option(const char* name, std::string& value, const char* type, const char* doc) {
  return add_nonempty(app_, name, value, type, doc);
}

Option Command::add_option(const char* name, std::vector<std::string>& values, const char* type, const char* doc) {
  return add_nonempty(app_, name, values, type, doc);
}

Option Command::add_output(const char* name, std::string& path, const char* type, const char* doc,
                           const OutputKind& kind) {
  outputs_->list.push_back({name, path, kind});
  return add_option(name, path, type, doc);
}

Option Command::add_option(const char* name, std::optional<std::uint32_t>& value, const char* doc) {
  return Option(*app_.add_option(name, value, doc));
}

Option Command::add_option(const char* name, std::optional<std::uint64_t>& value, const char* doc) {
  return Option(*app_.add_option(name, value, doc));
}

void Command::add_flag(const char* name, bool& value, const char* doc) { app_.add_flag(name, value, doc); }

void Command::require_command() { app_.require_subcommand(1); }

void Command::footer(const char* text) { app_.footer(text); }

void Command::action(std::function<Result<int>()> run) {
  app_.callback([run = std::move(run), outputs = outputs_, &exit_code = exit_code_] {
    FilesInUse files;
    const Status announced = outputs->announce(files);
    const Result<int> result = announced ? run() : announced.error();
    if (!result) print_error(result.error());
    exit_code = result ? *result : kExitBadInput;
  });
}

Result<int> done(const Status& last, int code) { return last ? Result<int>(code) : last.error(); }

int run_program(const Program& program, int argc, char** argv) {
  CLI::App app(program.doc, program.name);
  int exit_code = kExitOk;
  app.set_version_flag("--version", program.version);
  app.get_formatter()->column_width(34);
  Command root(app, exit_code);
  root.require_command();
  root.footer(program.footer);
  program.add_commands(root);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    std::ostringstream text;
    const int code = app.exit(help_or_version, text, text);
    const Status status = print(text.str());
    if (!status) print_error(status.error());
    return status ? code : kExitBadInput;
  } catch (const CLI::ParseError& error) {
    print_error(usage_error(app, error));
    return kExitBadInput;
  }
  return exit_code;
}

}  // namespace physim::cli
