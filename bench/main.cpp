// physim_bench: speed at equal achieved error, against the solvers that people use.
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "sections.hpp"

namespace physim::bench {
namespace {

constexpr const char* kHelp =
    "physim_bench: how fast PhySim flies, against Boost.odeint and SUNDIALS at equal achieved error,\n"
    "and how fast its worlds step, against the original loop and Bullet\n"
    "  --quick            fewer rounds and flights: under a minute\n"
    "  --only SECTION     1mm, 1um, mixed, threads, study, allocations, parts, aim, rotation, rockets, accuracy,\n"
    "                     arcade, engines, world or casts\n"
    "  --rockets FOLDER   of scenario files, whose shots the section rockets flies too\n"
    "  --cpu-time         count the time this thread ran, not the clock on the wall: for busy machines\n"
    "  --rounds N         turns of every contender\n"
    "  --json             print JSON\n"
    "  --markdown FILE    also write a page\n";

struct Arguments {
  Options options;
  std::string only;
  std::string markdown;
  bool json = false;
  std::string command = "./dev bench";
};

/// False where the arguments make no sense.
bool read_arguments(int count, char** given, Arguments& a) {
  for (int i = 1; i < count; ++i) {
    const std::string arg = given[i];
    a.command += " " + arg;
    const auto value = [&] {
      if (i + 1 == count) return std::string();
      a.command += std::string(" ") + given[i + 1];
      return std::string(given[++i]);
    };
    if (arg == "--quick") {
      a.options.quick = true;
      a.options.flights = 5000;
      a.options.rounds = 7;
      a.options.slice = 0.01;
      a.options.per_decade = 6;
    } else if (arg == "--cpu-time") {
      a.options.clock = Clock::cpu;
    } else if (arg == "--json") {
      a.json = true;
    } else if (arg == "--only") {
      a.only = value();
    } else if (arg == "--rockets") {
      a.options.rockets = value();
      if (!std::filesystem::is_directory(a.options.rockets)) return false;
    } else if (arg == "--markdown") {
      a.markdown = value();
      if (a.markdown.empty()) return false;
    } else if (arg == "--rounds") {
      a.options.rounds = std::atoi(value().c_str());
      if (a.options.rounds < 1) return false;
    } else {
      return false;
    }
  }
  return true;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string model, family, number, line;
  while (std::getline(file, line)) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string value = line.substr(colon + 2);
    if (model.empty() && line.rfind("model name", 0) == 0) model = value;
    if (family.empty() && line.rfind("cpu family", 0) == 0) family = value;
    if (number.empty() && line.rfind("model\t", 0) == 0) number = value;
  }
  return model.empty() ? "unknown" : model + " (family " + family + ", model " + number + ")";
}

std::vector<std::pair<std::string, std::string>> facts(const Options& options) {
  std::string names;
  for (const std::string& kernel : kernels()) names += (names.empty() ? "" : ", ") + kernel;
  std::string compiler = "unknown";
#if defined(__VERSION__)
  compiler = __VERSION__;
#endif
  return {{"processor", processor()},
          {"kernels", names},
          {"compiler", compiler},
          {"clock", options.clock == Clock::wall ? "steady_clock, one thread" : "processor time of one thread"},
          {"rounds", std::to_string(options.rounds) + ", contenders in turn; medians and quartiles"}};
}

int run(int count, char** given) {
  Arguments a;
  if (!read_arguments(count, given, a)) {
    std::fputs(kHelp, stderr);
    return 2;
  }
  Report report{facts(a.options), {}};
  if (!a.json) std::fputs(as_text(report).c_str(), stdout);
  const auto wanted = [&](const char* name) { return a.only.empty() || a.only == name; };
  const auto add = [&](Section section) {
    if (!a.json) std::fputs(as_text(section).c_str(), stdout);
    std::fflush(stdout);
    report.sections.push_back(std::move(section));
  };
  double tolerance = 1e-7;
  if (wanted("1mm")) add(equal_error_section(a.options, 1e-3, &tolerance));
  if (wanted("1um")) add(equal_error_section(a.options, 1e-6, nullptr));
  if (wanted("mixed")) add(mixed_section(a.options, tolerance));
  if (wanted("threads")) add(threads_section(a.options));
  if (wanted("study")) add(study_section(a.options));
  if (wanted("allocations")) add(allocation_section(a.options));
  if (wanted("parts")) add(micro_section(a.options));
  if (wanted("aim")) add(aim_section(a.options));
  if (wanted("rotation")) add(rotation_section(a.options));
  if (wanted("rockets")) add(rockets_section(a.options));
  if (wanted("accuracy")) {
    add(switches_section(a.options));
    add(effects_section(a.options));
  }
  if (wanted("arcade")) add(arcade_section(a.options));
  if (wanted("engines")) add(engines_section(a.options));
  if (wanted("world"))
    for (Section& section : world_sections(a.options)) add(std::move(section));
  if (wanted("casts")) {
    add(casts_section(a.options));
    add(build_section(a.options));
    add(scene_worlds_section(a.options));
  }
  if (a.json) std::fputs(as_json(report).c_str(), stdout);
  if (!a.markdown.empty()) std::ofstream(a.markdown) << as_markdown(report, a.command);
  return 0;
}

}  // namespace
}  // namespace physim::bench

int main(int count, char** given) { return physim::bench::run(count, given); }
