// simclient: see it fly.
#include <cstdio>
#include <exception>

#include "scenario/text_file.hpp"
#include "simclient/app.hpp"

namespace physim::client {
namespace {

Result<std::string> script_text(const std::string& option) {
  if (option.empty() || option[0] != '@') return option;
  constexpr std::uintmax_t kLargestScript = 16 << 20;  // [bytes]
  return read_text_file(option.substr(1), kLargestScript, "script");
}

Status run(const Options& options) {
  const Result<std::string> text = script_text(options.script);
  if (!text) return text.error();
  Result<Script> script = Script::parse(*text);
  if (!script) return script.error();
  Result<Client> client = open_client(options.scenario, options.overrides);
  if (!client) return client.error();
  return App(std::move(*client), std::move(*script), options).run();
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
