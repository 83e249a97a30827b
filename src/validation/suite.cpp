#include "validation/suite.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "prepare/grant.hpp"

namespace physim::validation {
namespace fs = std::filesystem;
namespace {

/// Does a folder hold figures of a suite? Where that was said, any table will do.
bool holds(const fs::path& folder, const Suite& suite, bool was_said) {
  std::error_code ignored;
  const bool known = std::any_of(suite.files.begin(), suite.files.end(),
                                 [&](std::string_view file) { return fs::is_regular_file(folder / file, ignored); });
  if (known || !was_said || !fs::is_directory(folder, ignored)) return known;
  return !files_in(folder, {}, fs::path(suite.files.front()).extension().string()).empty();
}

/// Path of the figures of a suite in a folder of the user's: in a folder of the suite's name, or right there.
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

double Figure::error() const { return std::abs(actual - expected); }

bool Figure::pass() const { return error() <= gate; }  // false for NaN

double Figure::badness() const {
  const double e = error();
  if (!std::isfinite(e)) return std::numeric_limits<double>::infinity();
  if (gate > 0) return e / gate;
  return e == 0 ? 0 : std::numeric_limits<double>::infinity();
}

void SuiteResult::compare(std::string case_name, std::string figure, double expected, double actual, double gate,
                          std::string problem) {
  PHYSIM_ASSERT(!figure.empty());
  if (!problem.empty()) actual = kNaN;
  figures.push_back({std::move(case_name), std::move(figure), expected, actual, gate, std::move(problem)});
}

std::size_t SuiteResult::missed() const {
  return static_cast<std::size_t>(
      std::count_if(figures.begin(), figures.end(), [](const Figure& f) { return !f.pass(); }));
}

std::vector<CaseSummary> summarize(const SuiteResult& result) {
  std::vector<CaseSummary> cases;
  for (const Figure& figure : result.figures) {
    auto at =
        std::find_if(cases.begin(), cases.end(), [&](const CaseSummary& c) { return c.name == figure.case_name; });
    if (at == cases.end()) at = cases.insert(cases.end(), CaseSummary{.name = figure.case_name, .worst = &figure});
    ++at->figures;
    if (!figure.pass()) ++at->missed;
    if (figure.badness() > at->worst->badness()) at->worst = &figure;
  }
  PHYSIM_ASSERT(cases.empty() == result.figures.empty());
  return cases;
}

std::span<const Suite* const> all_suites() {
  static constexpr const Suite* kSuites[] = {&kClassicSuite,    &kAnalyticSuite, &kUs76Suite,  &kGravitySuite,
                                             &kBallisticsSuite, &kNescSuite,     &kMccoySuite, &kSportsSuite};
  return kSuites;
}

const Suite* find_suite(std::string_view name) {
  for (const Suite* suite : all_suites())
    if (suite->name == name) return suite;
  return nullptr;
}

void compare_tables(const fs::path& folder, std::span<const std::string_view> known, const char* otherwise,
                    SuiteResult& result, const std::function<bool(const CsvFile&, SuiteResult&)>& compare) {
  for (const fs::path& path : files_in(folder, known, ".csv")) {
    const CsvFile file = CsvFile::read(path);
    if (compare(file, result))
      result.sources.push_back({file.name(), file.comments()});
    else
      result.skipped.push_back(file.name() + ": " + otherwise);
  }
}

std::vector<fs::path> files_in(const fs::path& folder, std::span<const std::string_view> known,
                               std::string_view extension) {
  std::vector<fs::path> files, others;
  for (const std::string_view name : known)
    if (fs::is_regular_file(folder / name)) files.push_back(folder / name);
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    if (!is_known && entry.is_regular_file() && name.ends_with(extension)) others.push_back(entry.path());
  }
  if (code) throw DataError{{.message = code.message(), .place = folder.string()}};
  std::sort(others.begin(), others.end());
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

std::string complaint(const Flight& flight, const Fidelity& asked) {
  if (flight.error()) return flight.error()->text();
  if (!ended_as_planned(flight.outcome())) return "the flight ended: " + std::string(name(flight.outcome()));
  const Fidelity& granted = flight.fidelity_in_use().fidelity;
  if (granted.motion != asked.motion) return "granted other motion: " + std::string(name(granted.motion));
  const bool is_named = asked.motion != Motion::closed_form && !is_chosen_by_rotation(asked.integrator);
  if (is_named && granted.integrator != asked.integrator)
    return "granted other integrator: " + std::string(name(granted.integrator));
  if (granted.drag != asked.drag) return "granted other drag: " + std::string(name(granted.drag));
  if (granted.rotation != asked.rotation) return "granted other rotation: " + std::string(name(granted.rotation));
  if (granted.earth != asked.earth) return "granted other earth: " + std::string(name(granted.earth));
  return {};
}

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
