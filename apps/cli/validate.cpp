// `physim validate`: runs suites of published and exact figures and says which gates hold.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "outputs.hpp"
#include "terminal.hpp"
#include "validation/validate.hpp"

namespace physim::cli {
namespace {
namespace fs = std::filesystem;
using namespace validation;

struct Options {
  std::vector<std::string> suites;
  std::string data;
  std::string report;
  bool json = false;
  bool every_figure = false;
};

/// The folder that PHYSIM_DATA names; else that of the installation this program lies in; else that of the sources.
fs::path own_data() {
  if (const char* named = std::getenv("PHYSIM_DATA")) return fs::path(named) / "validation";
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path installed = program.parent_path().parent_path() / PHYSIM_INSTALLED_DATA / "validation";
  if (!failure && fs::is_directory(installed, failure)) return installed;
  return fs::path(PHYSIM_DATA_DIR) / "validation";
}

std::string command_text(const Options& options) {
  std::string text = "physim validate";
  for (const std::string& suite : options.suites) text += " " + suite;
  if (!options.data.empty()) text += " --data " + options.data;
  std::string report = options.report;
  if (report.ends_with(".tmp")) report.resize(report.size() - 4);  // written beside its place, to be moved there
  return text + " --report " + report;
}

std::string text_of(const Options& options, const std::vector<SuiteResult>& results) {
  if (options.json) return json_text(results);
  const report::Style style = style_of(stdout);
  std::string text;
  for (const SuiteResult& result : results) text += table_text(result, options.every_figure, style) + "\n";
  for (const SuiteResult& result : results) text += summary_text(result, style);
  return text;
}

Result<int> run(const Options& options) {
  if (!options.report.empty())
    if (Status status = check_output(options.report); !status) return status.error();
  const bool has_own = options.data.empty();
  const auto results =
      validate({options.suites, has_own ? own_data() : fs::path(options.data), has_own}, progress_bar("validating"));
  if (!results) return results.error();
  Status status = print(text_of(options, *results));
  if (status && !options.report.empty())
    status = write_output(options.report, as_text(report_text(command_text(options), *results)));
  const bool pass = std::ranges::all_of(*results, [](const SuiteResult& r) { return r.missed() == 0; });
  return done(status, pass ? kExitOk : kExitCheckMissed);
}

}  // namespace

void add_validate_command(Command& program) {
  Command command = program.add_command("validate", "check computed figures against published and exact ones");
  auto options = std::make_shared<Options>();
  command.add_option("suites", options->suites, (names_of_suites() + "; none: all").c_str()).type_name("SUITE");
  command.add_option("--data", options->data, "folder with figures of one suite, or with a folder per suite")
      .type_name("DIR");
  command.add_flag("--json", options->json, "print results as JSON");
  command.add_output("--report", options->report, "FILE.md", "write a Markdown report");
  command.add_flag("--all,-v", options->every_figure, "print every figure, not the worst of each case");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
