// simclient: see it fly.
#include <cstdio>
#include <exception>

#include "scenario/files_in_use.hpp"
#include "scenario/text_file.hpp"
#include "simclient/app.hpp"

namespace physim::client {
namespace {

Result<std::string> script_text(const std::string& option) {
  if (option.empty() || option[0] != '@') return option;
  constexpr std::uintmax_t kLargestScript = 16 << 20;  // [bytes]
  return read_text_file(option.substr(1), kLargestScript, "script");
}

/// The client and its script. What they are read from cannot be written by an option.
struct Opened {
  Client client;
  Script script;
};
Result<Opened> open(const Options& options) {
  FilesInUse files;
  if (Status status = files.add_output(options.state, "--state"); !status) return status.error();
  if (Status status = files.add_output(options.screenshot, "--screenshot"); !status) return status.error();
  const Result<std::string> text = script_text(options.script);
  if (!text) return text.error();
  Result<Script> script = Script::parse(*text);
  if (!script) return script.error();
  Result<Client> client = open_client(options.scenario, options.overrides);
  if (!client) return client.error();
  return Opened{std::move(*client), std::move(*script)};
}

Status run(const Options& options) {
  Result<Opened> opened = open(options);
  if (!opened) return opened.error();
  return App(std::move(opened->client), std::move(opened->script), options).run();
}

int tell(const Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return kExitBadInput;
}

}  // namespace
}  // namespace physim::client

int main(int argc, char** argv) {
  using namespace physim;
  try {
    const auto line = client::parse_command_line(argc, argv);
    if (const int* exit_code = std::get_if<int>(&line)) return *exit_code;
    if (const Status status = client::run(std::get<client::Options>(line)); !status)
      return client::tell(status.error());
    return client::kExitOk;
  } catch (const std::exception& problem) {  // of the libraries: memory is full, ...
    return client::tell({problem.what(), "simclient", ""});
  }
}
