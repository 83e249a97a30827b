// What suites of figures share: judging a number, summing up, finding files.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "prepare/grant.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace fs = std::filesystem;

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

}  // namespace physim::validation
