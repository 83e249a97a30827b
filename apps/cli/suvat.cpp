// physim suvat: motion under constant acceleration, from any three of its five quantities.
#include <memory>

#include "asked.hpp"
#include "physim/solve.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct SuvatCommand {
  std::vector<std::string> given;
  bool json = false;
};

struct Named {
  std::string_view name;
  std::optional<double> SuvatGiven::*value;
  Quantity quantity;
};
constexpr Named kNamed[] = {{"s", &SuvatGiven::s, Quantity::length},
                            {"u", &SuvatGiven::u, Quantity::speed},
                            {"v", &SuvatGiven::v, Quantity::speed},
                            {"a", &SuvatGiven::a, Quantity::acceleration},
                            {"t", &SuvatGiven::t, Quantity::time}};

constexpr const char* kMeaning = "s displacement, u velocity at the start, v at the end, a acceleration, t time";

/// Adds "u=30m/s" to what is given.
Status add(const std::string& argument, SuvatGiven& given) {
  const std::size_t sign = argument.find('=');
  if (sign == std::string::npos) return Error{in_quotes(argument) + " is no NAME=VALUE", "suvat", "as in u=30m/s"};
  const std::string_view name = trimmed(std::string_view(argument).substr(0, sign));
  for (const Named& named : kNamed) {
    if (named.name != name) continue;
    if (given.*named.value) return Error{std::string(name) + " is given twice", "suvat", ""};
    const auto value = option_value(named.name.data(), argument.substr(sign + 1), named.quantity);
    if (!value) return value.error();
    if (!*value) return Error{"nothing stands behind the =", std::string(name), expected(named.quantity)};
    given.*named.value = **value;
    return {};
  }
  return Error{"there is no quantity " + in_quotes(name), "suvat", kMeaning};
}

Result<int> run(const SuvatCommand& command) {
  SuvatGiven given;
  for (const std::string& argument : command.given)
    if (Status status = add(argument, given); !status) return status.error();
  const auto motions = suvat(given);
  if (!motions) return motions.error();
  const Answer answer = suvat_answer(given, *motions);
  return done(command.json ? print(answer.json) : print(answer.text));
}

}  // namespace

void add_suvat_command(Command& program) {
  Command command =
      program.add_command("suvat", "Motion under constant acceleration: three quantities give the other two");
  auto options = std::make_shared<SuvatCommand>();
  command.add_option("given", options->given, (std::string("three of five, with units: ") + kMeaning).c_str())
      .type_name("NAME=VALUE");
  command.add_flag("--json", options->json, "Print the answer as JSON");
  command.footer(
      "Each motion that has the three is a line; two are there where s and a are given with u or v.\n\n"
      "Examples:\n"
      "  physim suvat u=30m/s a=-9.81m/s^2 s=20m\n"
      "  physim suvat u=0 v=\"100 km/h\" t=\"3.2 s\" --json\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
