#include "scenario/in_place.hpp"

#include <algorithm>
#include <filesystem>

#include "base/assert.hpp"
#include "scenario/overrides.hpp"
#include "scenario/study_text.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr std::string_view kOfShots = "shot.";

}  // namespace

bool looks_uncertain(const Value& value) {
  if (value.get<Table>() != nullptr) return true;
  const auto* text = value.get<std::string>();
  if (text == nullptr) return false;
  const std::string_view begin = trimmed(*text);
  static constexpr std::string_view kWords[] = {"lognormal ", "one of ", "column ", "added "};
  const auto is_sign = [](char a, char b) { return (a == '+' && b == '-') || (a == '.' && b == '.'); };
  const auto is_first = [begin](std::string_view word) { return is_same_key(begin.substr(0, word.size()), word); };
  return std::ranges::any_of(kWords, is_first) || std::ranges::adjacent_find(*text, is_sign) != text->end();
}

namespace {

// -------------------------------------------------------------------------------------------------------------- tables
constexpr std::string_view kDistributionKeys[] = {"mean",   "deviation", "low",  "high",         "peak",
                                                  "values", "column",    "file", "per_occasion", "lognormal"};

/// A table of a distribution as its text.
class DistributionTable {
 public:
  DistributionTable(std::string path, const Value& table) : path_(std::move(path)), table_(table) {}

  [[nodiscard]] Result<std::string> text() {
    for (const Member& member : *table_.get<Table>())
      if (std::ranges::find(kDistributionKeys, member.key) == std::end(kDistributionKeys))
        return Error{path_ + ": unknown key " + in_quotes(member.key) + " of a distribution", member.key_place.text(),
                     suggestion(member.key, kDistributionKeys, "known keys")};
    for (const std::string_view key : {"lognormal", "per_occasion"})
      if (has(key) && table_.find(key)->get<bool>() == nullptr)
        return Error{path_ + "." + std::string(key) + ": must be true or false", table_.find(key)->place.text(), ""};
    const std::string core = shape();
    if (core.empty())
      return Error{path_ + ": the table is no distribution", table_.place.text(),
                   "write { mean, deviation }, with low or high where it is cut off, { low, high }, { low, high, peak "
                   "}, { lognormal = true, mean, deviation }, { values = [...] } or { column, file }"};
    for (const Member& member : *table_.get<Table>())
      if (std::ranges::find(used_, member.key) == used_.end())
        return Error{path_ + ": " + in_quotes(member.key) + " says nothing beside " + in_quotes(used_.front()),
                     member.key_place.text(), "leave it out"};
    return core + (is_set("per_occasion") ? " per occasion" : "");
  }

 private:
  [[nodiscard]] bool has(std::string_view key) const { return table_.find(key) != nullptr; }
  [[nodiscard]] bool is_set(std::string_view key) const {
    const Value* value = table_.find(key);
    return value != nullptr && value->get<bool>() != nullptr && *value->get<bool>();
  }
  static std::string text_of(const Value& value) {
    if (const auto* text = value.get<std::string>()) return *text;
    if (const auto* integer = value.get<std::int64_t>()) return std::to_string(*integer);
    if (const auto* real = value.get<double>()) return number_text(*real);
    return shown(value);  // not a number: the text is refused where it is read
  }
  [[nodiscard]] std::string at(std::string_view key) const { return has(key) ? text_of(*table_.find(key)) : ""; }

  /// The text of the shape of the keys that exist, which it notes.
  [[nodiscard]] std::string shape() {
    if (has("values")) {
      used_ = {"values", "per_occasion"};
      std::string list;
      if (const Array* values = table_.find("values")->get<Array>())
        for (const Value& value : *values) list += (list.empty() ? "" : ", ") + text_of(value);
      return "one of " + list;
    }
    if (has("column") && has("file")) {
      used_ = {"column", "file", "per_occasion"};
      return "column " + at("column") + " of " + at("file");
    }
    if (has("mean") && has("deviation")) {
      used_ = {"mean", "deviation", "low", "high", "lognormal", "per_occasion"};
      const std::string bell = (is_set("lognormal") ? "lognormal " : "") + at("mean") + " +- " + at("deviation");
      return has("low") || has("high") ? bell + " within " + at("low") + " .. " + at("high") : bell;
    }
    if (!has("low") || !has("high")) return "";
    used_ = {"low", "high", "peak", "per_occasion"};
    return at("low") + " .. " + at("high") + (has("peak") ? " peak " + at("peak") : "");
  }

  std::string path_;
  const Value& table_;
  std::vector<std::string_view> used_;  // keys that its shape knows
};

// ---------------------------------------------------------------------------------------------------------------
// places
/// The value of a path below a table, also of a component of a vector; null if not found.
Value* value_at(Value& table, std::string_view path) {
  PHYSIM_ASSERT(!path.empty());
  Value* here = &table;
  for (bool more = true; more && here != nullptr;) {
    const std::size_t dot = path.find('.');
    const std::string_view key = path.substr(0, dot);
    Array* components = here->get<Array>();
    if (components != nullptr)
      here = components->size() == 3 && key.size() == 1 && key[0] >= 'x' && key[0] <= 'z'
                 ? &(*components)[static_cast<std::size_t>(key[0] - 'x')]
                 : nullptr;
    else
      here = here->find(key);
    more = dot != path.npos;
    if (more) path.remove_prefix(dot + 1);
  }
  return here;
}

/// The number of a point of a list: what stands last in [0.5, 0.23], first where `tail` names its place, or below
/// `tail` in a table. A coefficient that is one number stands for its only point. The angle in the middle of some
/// points is in square degrees, which no distribution is written in.
Value* number_of_point(Value& point, std::string_view tail) {
  if (!tail.empty() && point.get<Table>() != nullptr) return value_at(point, tail);
  Array* numbers = point.get<Array>();
  if (numbers == nullptr) return tail.empty() ? &point : nullptr;
  if (numbers->empty()) return nullptr;
  if (tail.empty()) return &numbers->back();
  return tail == "mach" || tail == "time" ? &numbers->front() : nullptr;
}

struct Spot {
  std::string path;   // "shot.speed"
  std::string named;  // as study.inputs has it: "shot.NAME.speed"
};

/// The text of a distribution that stands at a place, which is left with its mean; empty where it is a number.
Result<std::string> take(const Spot& spot, Value& value, const std::string& folder) {
  PHYSIM_ASSERT(looks_uncertain(value));
  std::string text;
  if (value.get<Table>() != nullptr) {
    const auto table = DistributionTable(spot.path, value).text();
    if (!table) return table.error();
    text = *table;
  } else {
    text = *value.get<std::string>();
  }
  const auto input = parse_study_input_in(folder, spot.path + " = " + text);
  const auto refused = [&](const std::string& message, const std::string& hint) {
    return Error{spot.path + ": " + message, value.place.text(), hint};
  };
  if (!input) return refused(input.error().message, input.error().hint);
  if (input->added)
    return refused(in_quotes(text) + " has no number of its own to be about", "write it as \"800 m/s +- 3 m/s\"");
  if (Status status = check(input->distribution); !status)
    return refused(status.error().place + " " + status.error().message, status.error().hint);
  value.content = mean_of(input->distribution);
  return spot.named + " = " + text;
}

/// What distributions there are, path by path.
class Taker {
 public:
  explicit Taker(std::string folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const Array& taken() const { return taken_; }
  /// The number of a path below a table, or each point of a list where the path has an "N"; `head` stands before it.
  Status look(Value& table, std::string_view below, const Spot& head) {
    if (table.get<Table>() == nullptr) return {};
    const std::size_t at = below.find(".N");
    if (at == below.npos) return take_from(value_at(table, below), head, std::string(below));
    Value* list = value_at(table, below.substr(0, at));
    if (list == nullptr) return {};
    const std::string_view tail = below.substr(at + 2);
    Array* points = list->get<Array>();
    for (std::size_t i = 0; i < (points ? points->size() : 1); ++i) {
      Value* number = number_of_point(points ? (*points)[i] : *list, tail.substr(tail.empty() ? 0 : 1));
      if (number == nullptr || !looks_uncertain(*number)) continue;
      const std::string path = std::string(below.substr(0, at + 1)) + std::to_string(i + 1) + std::string(tail);
      if (Status status = take_from(number, head, path); !status) return status;
    }
    return {};
  }

 private:
  Status take_from(Value* value, const Spot& head, const std::string& below) {
    if (value == nullptr || !looks_uncertain(*value)) return {};
    const auto text = take({head.path + below, head.named + below}, *value, folder_);
    if (!text) return text.error();
    taken_.push_back(Value{*text, value->place, {}, {}});
    return {};
  }

  std::string folder_;
  Array taken_;
};

Value& made_member(Value& table, const char* key, Value otherwise) {
  if (Value* found = table.find(key)) return *found;
  table.get<Table>()->push_back({key, otherwise.place, std::move(otherwise)});
  return table.get<Table>()->back().value;
}

/// Before the inputs that are there.
void put_first(Value& document, const Array& taken) {
  PHYSIM_ASSERT(!taken.empty() && document.get<Table>() != nullptr);
  const auto& place = document.place;
  Value& study = made_member(document, "study", Value{Table{}, place, {}, {}});
  if (study.get<Table>() == nullptr) return;  // refused where it is read
  Value& inputs = made_member(study, "inputs", Value{Array{}, place, {}, {}});
  if (inputs.get<std::string>() != nullptr) inputs.content = Array{inputs};  // one text alone
  if (Array* list = inputs.get<Array>()) list->insert(list->begin(), taken.begin(), taken.end());
}

}  // namespace

bool may_have_distributions(const Value& value, const SchemaNode* node) {
  const Table* table = value.get<Table>();
  if (const Array* array = value.get<Array>())
    return std::ranges::any_of(*array, [node](const Value& each) { return may_have_distributions(each, node); });
  if (table == nullptr || node == nullptr || node->children.empty()) return looks_uncertain(value);
  return std::ranges::any_of(*table, [node](const Member& each) {
    const bool is_leaf = each.value.get<Table>() == nullptr && each.value.get<Array>() == nullptr;
    return may_have_distributions(each.value, is_leaf ? nullptr : node->find(each.key));
  });
}

Status take_distributions(Value& document, const std::string& file) {
  static const std::vector<StudyPath> kPaths = study_paths();
  Taker taker(std::filesystem::path(file).parent_path().string());
  Value* shots = document.find("shot");
  Array* list = shots ? shots->get<Array>() : nullptr;
  for (const StudyPath& known : kPaths) {
    if (!known.path.starts_with(kOfShots)) {
      if (Status status = taker.look(document, known.path, {}); !status) return status;
      continue;
    }
    const std::string below = known.path.substr(kOfShots.size());
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
      const std::string name = list->size() > 1 ? shot_name((*list)[i], i) + "." : "";
      const Spot shot{std::string(kOfShots), std::string(kOfShots) + name};
      if (Status status = taker.look((*list)[i], below, shot); !status) return status;
    }
  }
  if (!taker.taken().empty()) put_first(document, taker.taken());
  return {};
}

}  // namespace physim
