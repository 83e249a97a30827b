// A scenario's changes put into the text of its file: what did not change stays as its author wrote it, comments, units
// and presets too.
#include "scenario/revise.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "scenario/as_written.hpp"
#include "scenario/document.hpp"
#include "scenario/published_materials.hpp"
#include "scenario/schema.hpp"
#include "scenario/writer.hpp"

namespace physim {
namespace {

/// A setting that is to have another value.
struct Change {
  std::string path;   // "shot.NAME.mass"
  std::string value;  // as in a file
};

std::size_t begin_of(std::string_view text, const Value& value) { return TextPlaces(text).begin_of(value); }
std::size_t end_of(std::string_view text, const Value& value) { return TextPlaces(text).end_of(value); }

/// [table] and [[table]] stand in lines of their own; other values beside their keys.
bool has_header(std::string_view text, const Value& value) {
  const Array* array = value.get<Array>();
  if (array != nullptr) return !array->empty() && array->front().get<Table>() && has_header(text, array->front());
  const std::size_t at = begin_of(text, value);
  return value.get<Table>() != nullptr && at < text.size() && text[at] == '[';
}

bool is_inline(std::string_view text, const Value& table) { return TextPlaces(text).is_inline(table); }

void insert_line(std::string& text, std::size_t after, const std::string& line) {
  const std::size_t end = std::min(text.find('\n', after), text.size());
  text.insert(end, "\n" + line);
}

/// Puts a key into a table that has none of it; false where the table is made of dotted keys.
bool add_key(std::string& text, const Value& table, bool is_root, const std::string& key, const std::string& value) {
  const std::string line = key + " = " + value;
  const Table& members = *table.get<Table>();
  if (!is_root && is_inline(text, table)) {
    const std::size_t brace = end_of(text, table) - 1;
    const std::size_t last = text.find_last_not_of(" \t", brace - 1) + 1;
    return text.replace(last, brace - last, members.empty() ? " " + line + " " : ", " + line + " "), true;
  }
  if (!is_root && !has_header(text, table)) return false;
  std::size_t after = is_root ? 0 : end_of(text, table);
  for (const Member& member : members)
    if (!has_header(text, member.value)) after = std::max(after, end_of(text, member.value));
  return insert_line(text, after, line), true;
}

/// The node of a path below a table's node.
const SchemaNode* setting_below(const SchemaNode& table, std::string_view path) {
  const SchemaNode* node = find_node(table.path.empty() ? std::string(path) : table.path + "." + std::string(path));
  PHYSIM_ASSERT(node != nullptr);  // the path is one of a setting
  return node;
}

/// Walks from a table to the setting, and puts its value there.
bool put(std::string& text, const Value& table, const SchemaNode& node, std::string_view rest, const std::string& value,
         const TypedNumbers& typed) {
  const std::size_t dot = rest.find('.');
  const std::string key(rest.substr(0, dot));
  const SchemaNode* child = node.find(key);
  PHYSIM_ASSERT(child != nullptr);  // the path is one of a setting
  const Value* found = table.find(key);
  const bool is_root = node.path.empty();
  if (found == nullptr) {
    const std::string said = as_typed(value, *setting_below(node, rest), typed);
    if (!is_root || dot == rest.npos) return add_key(text, table, is_root, std::string(rest), said);
    text += "\n[" + key + "]\n" + std::string(rest.substr(dot + 1)) + " = " + said + "\n";
    return true;
  }
  const std::size_t begin = begin_of(text, *found), length = end_of(text, *found) - begin;
  if (dot == rest.npos) {
    if (has_header(text, *found)) return false;
    return text.replace(begin, length, in_manner_of(*found, text, value, *child, typed)), true;
  }
  rest.remove_prefix(dot + 1);
  if (found->get<Table>() != nullptr) {
    if (put(text, *found, *child, rest, value, typed)) return true;
    const bool is_dotted = !has_header(text, *found) && !is_inline(text, *found);  // it takes no key, but gets one more
    return is_dotted && add_key(text, table, is_root, key + "." + std::string(rest),
                                as_typed(value, *setting_below(*child, rest), typed));
  }
  const std::string bare = text.substr(begin, length);  // stands for the table
  const SchemaNode& setting = *setting_below(*child, rest);
  text.replace(begin, length,
               rest == child->shorthand ? in_manner_of(*found, text, value, setting, typed)
                                        : "{ " + child->shorthand + " = " + bare + ", " + std::string(rest) + " = " +
                                              as_typed(value, setting, typed) + " }");
  return true;
}

bool put(std::string& text, const Value& document, const Scenario& scenario, const Change& change,
         const TypedNumbers& typed) {
  constexpr std::string_view kShotPath = "shot.";
  if (!change.path.starts_with(kShotPath)) return put(text, document, schema(), change.path, change.value, typed);
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const std::string prefix = std::string(kShotPath) + scenario.shots[i].projectile.name + ".";
    if (!change.path.starts_with(prefix)) continue;
    const std::string rest = change.path.substr(prefix.size());
    if (find_node(std::string(kShotPath) + rest) == nullptr) continue;  // another shot, with a longer name
    return put(text, element(document, "shot", i), *find_node("shot"), rest, change.value, typed);
  }
  return false;
}

/// A scenario as its file says it: distributions that stand in the place of numbers, which a reader has before the
/// other inputs of the study, stay there.
Scenario said_in_file(const Value& document, const Scenario& before, const Scenario& now) {
  const Value* study = document.find("study");
  const Value* inputs = study ? study->find("inputs") : nullptr;
  const Array* list = inputs ? inputs->get<Array>() : nullptr;
  const std::size_t written = list ? list->size() : inputs ? 1 : 0;
  const std::vector<std::string>& all = before.study.inputs;
  PHYSIM_ASSERT(written <= all.size());
  const auto in_place = static_cast<std::ptrdiff_t>(all.size() - written);
  Scenario said = now;
  std::vector<std::string>& wanted = said.study.inputs;
  const bool are_kept =
      std::ssize(wanted) >= in_place && std::equal(all.begin(), all.begin() + in_place, wanted.begin());
  if (are_kept) wanted.erase(wanted.begin(), wanted.begin() + in_place);
  return said;
}

/// What is to be changed in the file of a scenario; nothing where a setting is gone, which no value can say.
std::optional<std::vector<Change>> changes(const Value& document, const Scenario& before, const Scenario& now) {
  const auto old = effective_settings(before), wanted = effective_settings(now);
  const auto in_file = settings_in_file(said_in_file(document, before, now));
  PHYSIM_ASSERT(wanted.size() == in_file.size());
  if (old.size() != wanted.size()) return std::nullopt;
  std::vector<Change> all;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old[i].first != wanted[i].first) return std::nullopt;
    if (old[i].second != wanted[i].second) all.push_back({wanted[i].first, in_file[i].second});
  }
  return all;
}

/// What a table's text says beside a key.
std::string said_by(std::string_view text, const Value& value) { return std::string(TextPlaces(text).said_of(value)); }

/// A table and the text that it was read from.
struct TableText {
  std::string_view text;
  const Value* table;  // null: none

  [[nodiscard]] const Value* find(const std::string& key) const { return table ? table->find(key) : nullptr; }
};

/// What is to be changed in the tables of a file that say `old` until now, key by key. Changes without a value: the key
/// goes.
void compare_keys(const TableText& in_file, const TableText& old, const TableText& now, const std::string& path,
                  std::vector<Change>& changes) {
  PHYSIM_ASSERT(in_file.table != nullptr && now.table != nullptr);
  for (const Member& member : *now.table->get<Table>()) {
    const std::string value = said_by(now.text, member.value);
    const Value *was = old.find(member.key), *there = in_file.find(member.key);
    if (was != nullptr && said_by(old.text, *was) == value) continue;
    const bool is_table = there != nullptr && there->get<Table>() && has_header(in_file.text, *there);
    if (is_table && member.value.get<Table>())
      compare_keys({in_file.text, there}, {old.text, was != nullptr && was->get<Table>() ? was : nullptr},
                   {now.text, &member.value}, path + member.key + ".", changes);
    else
      changes.push_back({path + member.key, value});
  }
  if (old.table == nullptr) return;
  for (const Member& member : *old.table->get<Table>())
    if (now.find(member.key) == nullptr) changes.push_back({path + member.key, ""});
}

/// Takes a key out of a table, or of one in it, with its line.
bool take_out(std::string& text, const Value& table, std::string_view path) {
  const std::size_t dot = path.find('.');
  const Value* found = table.find(std::string(path.substr(0, dot)));
  if (found == nullptr) return true;
  if (dot != path.npos) return take_out(text, *found, path.substr(dot + 1));
  if (has_header(text, *found) || is_inline(text, table)) return false;
  const std::size_t begin = text.rfind('\n', begin_of(text, *found)) + 1;
  text.erase(begin, std::min(text.find('\n', end_of(text, *found)), text.size() - 1) + 1 - begin);
  return true;
}

/// Key by key: lists of tables are one setting each, of which little changes at a time.
bool put_element(std::string& text, const std::string& file, const std::string& list, std::size_t index,
                 const std::string& old_text, const std::string& new_text, const TypedNumbers& typed) {
  const Result<Value> old = parse_document(old_text, file), wanted = parse_document(new_text, file);
  const Result<Value> all = parse_document(text, file);
  if (!old || !wanted || !all) return false;
  std::vector<Change> changes;
  compare_keys({text, &element(*all, list, index)}, {old_text, &*old}, {new_text, &*wanted}, "", changes);
  for (const Change& change : changes) {
    const Result<Value> document = parse_document(text, file);
    if (!document) return false;
    const Value& table = element(*document, list, index);
    const bool is_put = change.value.empty() ? take_out(text, table, change.path)
                                             : put(text, table, *find_node(list), change.path, change.value, typed);
    if (!is_put) return false;
  }
  return true;
}

/// A list of tables with headers of their own, as [[emitter]].
bool put_elements(std::string& text, const std::string& file, const std::string& list, const Scenario& before,
                  const Scenario& now, const TypedNumbers& typed) {
  const std::vector<std::string> old = element_texts(before, list), wanted = element_texts(now, list);
  if (wanted.size() != old.size()) return false;
  for (std::size_t i = 0; i < old.size(); ++i)
    if (wanted[i] != old[i] && !put_element(text, file, list, i, old[i], wanted[i], typed)) return false;
  return true;
}

bool put(std::string& text, const std::string& file, const Change& change, const Scenario& before, const Scenario& now,
         const TypedNumbers& typed) {
  const Result<Value> document = parse_document(text, file);
  if (!document) return false;
  const SchemaNode* node = find_node(change.path);
  const Value* list = document->find(change.path);
  if (node != nullptr && node->is_list_of_tables() && list != nullptr && has_header(text, *list))
    return put_elements(text, file, change.path, before, now, typed);
  return put(text, *document, before, change, typed);
}

/// Takes the elements that a list has more than before out of it; as tables of their own.
template <class List>
std::string more_of(List Scenario::*list, const char* name, const Scenario& before, const Scenario& now,
                    Scenario& kept) {
  List& all = kept.*list;
  if (all.size() <= (before.*list).size()) return {};
  const std::vector<std::string> texts = element_texts(now, name);
  std::string added;
  for (std::size_t i = (before.*list).size(); i < all.size(); ++i)
    added += "\n[[" + std::string(name) + "]]\n" + texts[i];
  all.resize((before.*list).size());
  return added;
}

/// Takes materials that are more than before out of the list; a reader of things, parts or meshes that are made of
/// published ones has those anyway.
std::string more_materials(const Scenario& before, const Scenario& now, Scenario& kept) {
  if (kept.materials.size() <= before.materials.size()) return {};
  const std::vector<std::string> texts = element_texts(now, "material");
  std::string added;
  for (auto& all = kept.materials; all.size() > before.materials.size(); all.pop_back()) {
    auto published = published_material(all.back().name);
    if (published) published->name = all.back().name;
    const auto names_it = [&name = all.back().name](const ScenarioShape& shape) {
      return std::ranges::count(shape.materials, name) +
                 std::ranges::count(shape.parts, name, &ScenarioPart::material) >
             0;
    };
    const bool is_made_of = std::ranges::count(now.things, all.back().name, &ScenarioThing::material) > 0 ||
                            std::ranges::any_of(now.shapes, names_it);
    if (published == all.back() && is_made_of) continue;
    added = "\n[[material]]\n" + texts[all.size() - 1] + added;
  }
  return added;
}

}  // namespace

bool say_the_same(const Scenario& a, const Scenario& b) {
  const auto same_body = [](const ScenarioShot& x, const ScenarioShot& y) { return x.body == y.body; };
  return effective_settings(a) == effective_settings(b) && std::ranges::equal(a.shots, b.shots, same_body);
}

std::optional<std::string> revised_text(const std::string& text, const std::string& file, const Scenario& now,
                                        const TypedNumbers& typed) {
  const Result<Scenario> before = parse_scenario(text, file);
  const Result<Value> document = parse_document(text, file);
  if (!before || !document) return std::nullopt;
  Scenario kept = now;
  std::string revised = text, added = more_of(&Scenario::shots, "shot", *before, now, kept);
  added += more_materials(*before, now, kept);
  added += more_of(&Scenario::shapes, "shape", *before, now, kept);
  added += more_of(&Scenario::things, "thing", *before, now, kept);
  added += more_of(&Scenario::emitters, "emitter", *before, now, kept);
  added += more_of(&Scenario::joints, "joint", *before, now, kept);
  const auto wanted = changes(*document, *before, kept);
  if (!wanted) return std::nullopt;
  for (const Change& change : *wanted)
    if (!put(revised, file, change, *before, kept, typed)) return std::nullopt;
  revised += document_as_typed(added, typed);
  const Result<Scenario> after = parse_scenario(revised, file);
  return after && say_the_same(*after, now) ? std::optional(revised) : std::nullopt;
}

}  // namespace physim
