#include "validation/validate.hpp"

#include <algorithm>
#include <optional>

#include "validation/suite.hpp"

namespace physim::validation {
namespace {
namespace fs = std::filesystem;

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

struct Job {
  const Suite* suite;
  fs::path folder;
};

/// The job of a suite; none where there are no figures of it. Throws DataError where there must be.
std::optional<Job> job_of(const fs::path& data, const Suite& suite, bool is_wanted) {
  if (const auto folder = folder_in(data, suite, is_wanted)) return Job{&suite, *folder};
  if (!is_wanted) return std::nullopt;
  std::string files;
  for (const std::string_view file : suite.files) files += (files.empty() ? "" : ", ") + std::string(file);
  throw DataError{{.message = "no figures of the suite \"" + std::string(suite.name) + "\" in this folder",
                   .place = data.string(),
                   .hint = "any of these would do: " + files}};
}

/// The suites to run and where their figures lie; throws DataError.
std::vector<Job> find_jobs(const Request& request) {
  const fs::path& data = request.data;
  std::error_code ignored;
  if (!fs::is_directory(data, ignored)) {
    const bool is_file = fs::exists(data, ignored);
    throw DataError{{.message = is_file ? "it is a file, not a folder" : "no such folder", .place = data.string()}};
  }
  std::vector<std::string> names = request.suites;
  if (names.empty())
    for (const Suite* suite : all_suites()) names.emplace_back(suite->name);
  const bool is_wanted = !request.suites.empty() || request.must_be_complete;
  std::vector<Job> jobs;
  for (const std::string& name : names) {
    const Suite* suite = find_suite(name);
    if (suite == nullptr)
      throw DataError{{.message = "no suite \"" + name + "\"", .hint = "there are: " + names_of_suites()}};
    if (std::ranges::count(jobs, suite, &Job::suite) > 0) continue;
    if (const auto job = job_of(data, *suite, is_wanted)) jobs.push_back(*job);
  }
  if (jobs.empty())
    throw DataError{{.message = "no figures of any suite in this folder",
                     .place = data.string(),
                     .hint = "name the suite, or give a folder that holds folders of suites: " + names_of_suites()}};
  return jobs;
}

std::vector<SuiteResult> run_all(const std::vector<Job>& jobs, const Progress& progress) {
  std::vector<SuiteResult> results;
  for (const Job& job : jobs) {
    SuiteResult& result = results.emplace_back();
    result.name = job.suite->name;
    result.folder = job.folder;
    job.suite->run(job.folder, result);
    if (result.figures.empty())
      throw DataError{{.message = "no figure to compare in this folder", .place = job.folder.string()}};
    if (progress) progress(results.size(), jobs.size());
  }
  return results;
}

}  // namespace

std::string names_of_suites() {
  std::string names;
  for (const Suite* suite : all_suites()) names += (names.empty() ? "" : ", ") + std::string(suite->name);
  return names;
}

Result<std::vector<SuiteResult>> validate(const Request& request, const Progress& progress) try {
  return run_all(find_jobs(request), progress);
} catch (const DataError& error) {
  return error.error;
}

}  // namespace physim::validation
