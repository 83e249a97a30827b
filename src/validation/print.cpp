// What came out of suites: tables for people, JSON, the Markdown report.
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "physim/result.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using namespace report;
using nlohmann::ordered_json;
namespace {

std::string number_text(double value) { return significant(value, 9); }
std::string small_text(double value) { return std::isnan(value) ? "-" : formatted("%.1e", value); }

std::string figures_text(std::size_t count) { return count == 1 ? "1 figure" : formatted("%zu figures", count); }

std::string verdict_text(const Style& style, std::size_t missed) {
  return missed == 0 ? style.good("pass") : style.bad(missed == 1 ? "MISSED" : formatted("%zu MISSED", missed));
}

std::vector<std::string> cells_of(const Figure& figure) {
  return {figure.figure, number_text(figure.expected), number_text(figure.actual), small_text(figure.error()),
          small_text(figure.gate)};
}

Table figure_table(const SuiteResult& result, const Style& style) {
  Table table({"case", "figure", "expected", "got", "error", "gate", "verdict"}, "llrrrrl");
  for (const Figure& figure : result.figures) {
    std::vector<std::string> cells = cells_of(figure);
    cells.insert(cells.begin(), figure.case_name);
    cells.push_back(verdict_text(style, figure.pass() ? 0 : 1));
    table.add_row(std::move(cells));
  }
  return table;
}

Table case_table(const SuiteResult& result, const Style& style) {
  Table table({"case", "figures", "worst figure", "expected", "got", "error", "gate", "verdict"}, "lrlrrrrl");
  for (const CaseSummary& summary : summarize(result)) {
    PHYSIM_ASSERT(summary.worst != nullptr);
    PHYSIM_ASSERT(summary.missed <= summary.figures);
    std::vector<std::string> cells = cells_of(*summary.worst);
    cells.insert(cells.begin(), {summary.name, formatted("%zu", summary.figures)});
    cells.push_back(verdict_text(style, summary.missed));
    table.add_row(std::move(cells));
  }
  return table;
}

/// Notes of figures that could not be computed, each once.
std::string notes_of(const SuiteResult& result) {
  std::string text, last;
  for (const Figure& figure : result.figures) {
    if (figure.note.empty() || figure.note == last) continue;
    text += "  " + figure.case_name + ": " + figure.note + "\n";
    last = figure.note;
  }
  return text;
}

/// Rows with equal columns.
Table row_table(const std::vector<StateRow>& rows, const char* number) {
  PHYSIM_ASSERT(!rows.empty());
  std::vector<std::string> columns = {""};
  for (const auto& [name, value] : rows.front().columns) columns.push_back(name);
  Table table(columns, "l");
  for (const StateRow& row : rows) {
    PHYSIM_ASSERT(row.columns.size() == rows.front().columns.size());
    std::vector<std::string> cells = {row.name};
    for (const auto& [name, value] : row.columns) cells.push_back(std::isnan(value) ? "-" : formatted(number, value));
    table.add_row(std::move(cells));
  }
  return table;
}

/// JSON knows no NaN.
ordered_json json_number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json json_of(const std::string& suite, const Figure& figure) {
  ordered_json row = {{"suite", suite},
                      {"case", figure.case_name},
                      {"figure", figure.figure},
                      {"expected", json_number(figure.expected)},
                      {"actual", json_number(figure.actual)},
                      {"error", json_number(figure.error())},
                      {"gate", json_number(figure.gate)},
                      {"pass", figure.pass()}};
  if (!figure.note.empty()) row["note"] = figure.note;
  return row;
}

ordered_json json_of(const std::string& suite, const StateRow& row) {
  ordered_json out = {{"suite", suite}, {"case", row.name}};
  for (const auto& [name, value] : row.columns) out[name] = json_number(value);
  return out;
}

Table misprint_table(const SuiteResult& result) {
  Table table({"misprint", "printed", "instead", "reason"}, "lrrl");
  for (const Misprint& misprint : result.misprints)
    table.add_row({misprint.figure, misprint.printed, misprint.instead, misprint.reason});
  return table;
}

/// All misprints, or how many there are.
std::string misprints_text(const SuiteResult& result, bool all) {
  if (result.misprints.empty()) return "";
  if (all) return "\n" + misprint_table(result).text(2);
  return formatted("  %zu of the published figures are misprints; --all names them\n", result.misprints.size());
}

Table report_table(const SuiteResult& result) {
  Table table({"case", "figures", "worst figure", "expected", "error", "gate", "error / gate", "verdict"}, "lrlrrrrl");
  for (const CaseSummary& summary : summarize(result)) {
    const Figure& worst = *summary.worst;
    table.add_row({summary.name, formatted("%zu", summary.figures), worst.figure, number_text(worst.expected),
                   small_text(worst.error()), small_text(worst.gate), formatted("%.2g", worst.badness()),
                   summary.missed == 0 ? "pass" : formatted("**%zu missed**", summary.missed)});
  }
  return table;
}

std::string report_of(const SuiteResult& result) {
  PHYSIM_ASSERT(find_suite(result.name) != nullptr);
  const Suite& suite = *find_suite(result.name);
  std::string text = "\n## " + result.name + "\n\n" + std::string(suite.title) + ". Gates: " + std::string(suite.gate) +
                     ".\n\n" + report_table(result).markdown();
  for (const std::string& skipped : result.skipped) text += "\nSkipped: " + skipped + ".\n";
  if (!result.misprints.empty())
    text += formatted("\n%zu figures are misprints, and were compared with what should stand there:\n\n",
                      result.misprints.size()) +
            misprint_table(result).markdown();
  if (!result.beside.empty())
    text += "\nHow far others lie from these solutions:\n\n" + row_table(result.beside, "%.1e").markdown();
  text += "\nSources:\n\n";
  for (const Source& source : result.sources)
    text += "- `" + source.file + "`: " + (source.text.empty() ? "not named" : source.text) + "\n";
  return text;
}

}  // namespace

std::string table_text(const SuiteResult& result, bool every_figure, const Style& style) {
  std::string text = style.bold(result.name) + ": " + std::string(find_suite(result.name)->title) + "\n";
  if (!result.figures.empty()) text += (every_figure ? figure_table(result, style) : case_table(result, style)).text(2);
  text += notes_of(result);
  text += misprints_text(result, every_figure);
  for (const std::string& skipped : result.skipped) text += style.dim("  skipped: " + skipped) + "\n";
  if (!result.beside.empty())
    text += "\n  how far others lie from these solutions\n" + row_table(result.beside, "%.1e").text(2);
  if (!result.states.empty()) text += "\n  where they end\n" + row_table(result.states, "%.9g").text(2);
  return text;
}

std::string summary_text(const SuiteResult& result, const Style& style) {
  const std::size_t missed = result.missed();
  const std::string verdict = missed == 0 ? style.good("all pass") : style.bad(formatted("%zu MISSED", missed));
  return style.bold(result.name) + ": " + figures_text(result.figures.size()) + ", " + verdict + "\n";
}

std::string json_text(const std::vector<SuiteResult>& results) {
  ordered_json rows = ordered_json::array(), suites = ordered_json::array();
  ordered_json states = ordered_json::array(), beside = ordered_json::array(), misprints = ordered_json::array();
  std::size_t figures = 0, missed = 0;
  for (const SuiteResult& result : results) {
    for (const Figure& figure : result.figures) rows.push_back(json_of(result.name, figure));
    suites.push_back({{"suite", result.name},
                      {"folder", result.folder.string()},
                      {"figures", result.figures.size()},
                      {"missed", result.missed()},
                      {"skipped", result.skipped}});
    for (const Misprint& misprint : result.misprints)
      misprints.push_back({{"suite", result.name},
                           {"figure", misprint.figure},
                           {"printed", misprint.printed},
                           {"instead", misprint.instead},
                           {"reason", misprint.reason}});
    for (const StateRow& row : result.states) states.push_back(json_of(result.name, row));
    for (const StateRow& row : result.beside) beside.push_back(json_of(result.name, row));
    figures += result.figures.size();
    missed += result.missed();
  }
  ordered_json all = {
      {"version", kVersion},
      {"results", std::move(rows)},
      {"summary", {{"figures", figures}, {"missed", missed}, {"pass", missed == 0}, {"suites", std::move(suites)}}}};
  if (!misprints.empty()) all["misprints"] = std::move(misprints);
  if (!states.empty()) all["states"] = std::move(states);
  if (!beside.empty()) all["beside"] = std::move(beside);
  return report::json_text(all);
}

std::string report_text(const std::string& command, const std::vector<SuiteResult>& results) {
  std::string text = "# Validation\n\nMade by `" + command + "`; do not edit. PhySim " + kVersion +
                     ". Every figure that PhySim is checked against, the worst of each case shown; `physim validate "
                     "--all` prints them all. SI units; the figure's name tells which.\n\n";
  Table table({"suite", "figures", "missed"}, "l");
  for (const SuiteResult& result : results)
    table.add_row({result.name, formatted("%zu", result.figures.size()), formatted("%zu", result.missed())});
  text += table.markdown();
  for (const SuiteResult& result : results) text += report_of(result);
  return text;
}

}  // namespace physim::validation
