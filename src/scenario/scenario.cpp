// Scenario files: text to document, overrides into it, settings out of it, contradictions.
#include "physim/scenario.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include "scenario/checks.hpp"
#include "scenario/checks_world.hpp"
#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"

namespace physim {
namespace {

constexpr std::int64_t kFormat = 1;               // of scenario files
constexpr std::uintmax_t kMostBytes = 256 << 20;  // a scenario is written by people; this is a wrong file

/// The version comes first: in another version any other complaint could be wrong.
Status check_format(const Value& document, const std::string& file) {
  const Value* format = document.find("physim");
  if (format == nullptr) return Error{"the format version is missing", file + ":1:1", "write physim = 1 at the top"};
  const auto* version = format->get<std::int64_t>();
  if (version == nullptr || *version != kFormat)
    return Error{"physim: unknown format version " + shown(*format), format->place.text(),
                 "this program reads version 1"};
  return std::nullopt;
}

/// What a table cannot say about itself: default names, and where expectations stand.
void complete(Scenario& scenario, const Value& document) {
  const Array& shots = *document.find("shot")->get<Array>();
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    scenario.shots[i].projectile.name = shot_name(shots[i], i);
    // A velocity takes the place of the speed that a preset brought along.
    if (shots[i].find("preset") && shots[i].find("velocity") && !shots[i].find("speed"))
      scenario.shots[i].launch.speed = 0;
  }
  complete_world(scenario, document);
  if (const Value* expect = document.find("expect"))
    for (std::size_t i = 0; i < scenario.expect.size(); ++i)
      scenario.expect[i].place = (*expect->get<Array>())[i].place.text();
}

/// The text of a file; every way in which that can fail is named.
Result<std::string> read_file(const std::string& file) {
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status)) return Error{"there is no such file", file, ""};
  if (std::filesystem::is_directory(status)) return Error{"this is a folder", file, "name a scenario file in it"};
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(file, failure) > kMostBytes)
    return Error{"larger than 256 MiB", file, "this cannot be a scenario file"};
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::vector<char> block(1 << 16);
  while (in.good() && text.size() <= kMostBytes) {  // a device or a pipe may have no end
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || !in.is_open()) return Error{"the file cannot be read", file, ""};
  if (text.size() > kMostBytes) return Error{"larger than 256 MiB", file, "this cannot be a scenario file"};
  return text;
}

}  // namespace

Result<Scenario> parse_scenario(const std::string& text, const std::string& file,
                                std::span<const std::string> overrides) {
  Result<Value> document = parse_document(text, file);
  if (!document) return document.error();
  for (const std::string& override_text : overrides)
    if (Status bad = apply_override(*document, override_text)) return *bad;
  if (Status bad = check_format(*document, file)) return *bad;
  const Value* shots = document->find("shot");
  const Array* array = shots ? shots->get<Array>() : nullptr;
  if (shots == nullptr || (array != nullptr && array->empty()))
    return Error{"the scenario has no shot", shots ? shots->place.text() : file + ":1:1", "add a [[shot]]"};
  Scenario scenario;
  scenario.file = file;
  std::int64_t format = kFormat;
  Scope scope;
  scope.format = &format;
  scope.scenario = &scenario;
  if (Status bad = read_table(schema(), scope, *document)) return *bad;
  complete(scenario, *document);
  if (Status bad = check_scenario(scenario, *document)) return *bad;
  return scenario;
}

Result<Scenario> load_scenario(const std::string& file, std::span<const std::string> overrides) {
  const Result<std::string> text = read_file(file);
  if (!text) return text.error();
  return parse_scenario(*text, file, overrides);
}

}  // namespace physim
