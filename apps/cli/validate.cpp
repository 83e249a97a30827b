// `physim validate`: runs suites of published and exact figures and says which gates hold.
#include "validate.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>

#include "command.hpp"
#include "commands.hpp"
#include "output_file.hpp"
#include "progress.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {
namespace fs = std::filesystem;
using namespace validate;

struct Options {
  std::vector<std::string> suites;
  std::string data;
  std::string report;
  bool json = false;
  bool every_figure = false;
};

/// Does a folder hold figures of a suite? Where that was said, any table will do.
bool holds(const fs::path& folder, const Suite& suite, bool was_said) {
  std::error_code ignored;
  const bool known = std::any_of(suite.files.begin(), suite.files.end(),
                                 [&](std::string_view file) { return fs::is_regular_file(folder / file, ignored); });
  if (known || !was_said || !fs::is_directory(folder, ignored)) return known;
  return !files_in(folder, {}, fs::path(suite.files.front()).extension().string()).empty();
}

/// Where the figures of a suite lie in a folder of the user's: in a folder of the suite's name, or right there.
std::optional<fs::path> folder_in(const fs::path& data, const Suite& suite, bool is_wanted) {
  for (const fs::path& folder : {data / suite.name, data / suite.folder})
    if (holds(folder, suite, true)) return folder;
  return holds(data, suite, is_wanted) ? std::optional(data) : std::nullopt;
}

/// The folder that PHYSIM_DATA names; else that of the installation this program lies in; else that of the sources.
fs::path own_data() {
  if (const char* named = std::getenv("PHYSIM_DATA")) return fs::path(named) / "validation";
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path installed = program.parent_path().parent_path() / PHYSIM_INSTALLED_DATA / "validation";
  if (!failure && fs::is_directory(installed, failure)) return installed;
  return fs::path(PHYSIM_DATA_DIR) / "validation";
}

struct Job {
  const Suite* suite;
  fs::path folder;
};

std::string names_of_suites() {
  std::string names;
  for (const Suite* suite : all_suites()) names += (names.empty() ? "" : ", ") + std::string(suite->name);
  return names;
}

void add_job(const fs::path& data, const Suite& suite, bool is_wanted, std::vector<Job>& jobs) {
  const bool is_there = std::any_of(jobs.begin(), jobs.end(), [&](const Job& job) { return job.suite == &suite; });
  if (is_there) return;
  if (const auto folder = folder_in(data, suite, is_wanted)) {
    jobs.push_back({&suite, *folder});
    return;
  }
  if (!is_wanted) return;
  std::string files;
  for (const std::string_view file : suite.files) files += (files.empty() ? "" : ", ") + std::string(file);
  throw DataError{{.message = "no figures of the suite \"" + std::string(suite.name) + "\" in this folder",
                   .place = data.string(),
                   .hint = "any of these would do: " + files}};
}

/// The suites to run and where their figures lie; throws DataError.
std::vector<Job> find_jobs(const Options& options) {
  const fs::path data = options.data.empty() ? own_data() : fs::path(options.data);
  std::error_code ignored;
  if (!fs::is_directory(data, ignored)) {
    const bool is_file = fs::exists(data, ignored);
    throw DataError{{.message = is_file ? "it is a file, not a folder" : "no such folder", .place = data.string()}};
  }
  std::vector<Job> jobs;
  for (const std::string& name : options.suites) {
    const Suite* suite = find_suite(name);
    if (suite == nullptr)
      throw DataError{{.message = "no suite \"" + name + "\"", .hint = "there are: " + names_of_suites()}};
    add_job(data, *suite, true, jobs);
  }
  if (options.suites.empty())
    for (const Suite* suite : all_suites()) add_job(data, *suite, options.data.empty(), jobs);
  if (jobs.empty())
    throw DataError{{.message = "no figures of any suite in this folder",
                     .place = data.string(),
                     .hint = "name the suite, or give a folder that holds folders of suites: " + names_of_suites()}};
  return jobs;
}

std::vector<SuiteResult> run_all(const std::vector<Job>& jobs) {
  Progress progress("validating", jobs.size());
  std::vector<SuiteResult> results;
  for (const Job& job : jobs) {
    SuiteResult& result = results.emplace_back();
    result.name = job.suite->name;
    result.folder = job.folder;
    job.suite->run(job.folder, result);
    if (result.figures.empty())
      throw DataError{{.message = "no figure to compare in this folder", .place = job.folder.string()}};
    progress.advance();
  }
  return results;
}

std::string command_text(const Options& options) {
  std::string text = "physim validate";
  for (const std::string& suite : options.suites) text += " " + suite;
  if (!options.data.empty()) text += " --data " + options.data;
  std::string report = options.report;
  if (report.ends_with(".tmp")) report.resize(report.size() - 4);  // written beside its place, to be moved there
  return text + " --report " + report;
}

Status show(const Options& options, const std::vector<SuiteResult>& results) {
  if (options.json) return print(json_text(results));
  std::string text;
  for (const SuiteResult& result : results) text += table_text(result, options.every_figure) + "\n";
  for (const SuiteResult& result : results) text += summary_text(result);
  return print(text);
}

int run(const Options& options) try {
  if (!options.report.empty())
    if (const Status status = check_writable(options.report); !status)
      return print_error(status.error()), kExitBadInput;
  const std::vector<SuiteResult> results = run_all(find_jobs(options));
  Status status = show(options, results);
  if (status && !options.report.empty())
    status = write_output(options.report, report_text(command_text(options), results));
  if (!status) return print_error(status.error()), kExitBadInput;
  const bool pass = std::all_of(results.begin(), results.end(), [](const SuiteResult& r) { return r.missed() == 0; });
  return pass ? kExitOk : kExitCheckMissed;
} catch (const DataError& error) {
  print_error(error.error);
  return kExitBadInput;
}

}  // namespace

void add_validate_command(Command& program) {
  Command command = program.add_command("validate", "check computed figures against published and exact ones");
  auto options = std::make_shared<Options>();
  command
      .add_option("suites", options->suites,
                  "classic, analytic, us76, gravity, ballistics, nesc, mccoy, sports; none: all")
      .type_name("SUITE");
  command.add_option("--data", options->data, "folder with figures of one suite, or with a folder per suite")
      .type_name("DIR");
  command.add_flag("--json", options->json, "print results as JSON");
  command.add_option("--report", options->report, "write a Markdown report").type_name("FILE.md");
  command.add_flag("--all,-v", options->every_figure, "print every figure, not the worst of each case");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
