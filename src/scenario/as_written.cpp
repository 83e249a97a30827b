#include "scenario/as_written.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/assert.hpp"

namespace physim {
namespace {

std::string_view last_key(std::string_view path) { return path.substr(path.rfind('.') + 1); }  // npos + 1 is 0

/// Texts of other settings are no numbers, though they may look like some: a shot may be named "2 m".
bool has_numbers(const Entry& entry) {
  Defaults defaults;
  const ValueRef slot = entry.slot(defaults.scope());
  return std::holds_alternative<double*>(slot) || std::holds_alternative<OptionalNumber>(slot) ||
         std::holds_alternative<Vec3d*>(slot) || std::holds_alternative<std::optional<Vec3d>*>(slot) ||
         std::holds_alternative<Points>(slot) || std::holds_alternative<DrawnNumber*>(slot) ||
         std::holds_alternative<AeroCoefficient*>(slot) || std::holds_alternative<std::vector<double>*>(slot) ||
         std::holds_alternative<std::vector<Vec3d>*>(slot);
}

/// A number of a value, with what it measures.
struct Number {
  double value = 0;
  Quantity quantity = Quantity::number;
};

/// A number as a writer has it: in SI, or an angle in degrees. Nothing if the value is no number.
std::optional<Number> written_number(const Value& value) {
  if (const auto* integer = value.get<std::int64_t>()) return Number{static_cast<double>(*integer), Quantity::number};
  if (const auto* real = value.get<double>()) return Number{*real, Quantity::number};
  const auto* text = value.get<std::string>();
  if (text == nullptr) return std::nullopt;
  const std::string_view unit = trimmed(behind_number(*text));
  const Quantity quantity = unit == "deg" ? Quantity::angle : quantity_of_si_unit(unit);
  const Result<double> number = parse_quantity(*text, quantity);
  return number ? std::optional(Number{*number, quantity}) : std::nullopt;
}

/// Whether a value of a file reads back as the number, bit for bit.
bool says(const Value& value, const Number& number) {
  if (const auto* text = value.get<std::string>()) {
    const Result<double> read = parse_quantity(*text, number.quantity);
    return read && is_same_number(*read, number.value);
  }
  const std::optional<Number> bare = written_number(value);
  return bare && is_same_number(bare->value, number.value);
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// The texts of new values, made by a walk through them and through those of a file.
class Revision {
 public:
  Revision(TextPlaces now, TextPlaces old, const TypedNumbers& typed, ReadsAs wanted = ReadsAs::same)
      : now_(now), old_(old), typed_(typed), wanted_(wanted) {}

  /// The setting to which a value belongs; none: of numbers that have no names of their own.
  struct Of {
    const SchemaNode* node = nullptr;
    std::string_view key;
    bool has_numbers = false;
  };
  static Of setting(const SchemaNode& node) {
    const SchemaNode* named = node.entry || node.shorthand.empty() ? &node : node.find(node.shorthand);
    PHYSIM_ASSERT(named != nullptr);
    return {&node, named->name, named->entry != nullptr && has_numbers(*named->entry)};
  }

  /// The text of a value in the place of one of the file.
  std::string replaced(const Value& now, const Value& old, const Of& of) {
    const Array* arrays[] = {now.get<Array>(), old.get<Array>()};
    if (arrays[0] && arrays[1] && !arrays[0]->empty() && !arrays[1]->empty()) return replaced_array(now, old, of);
    if (has_same_keys(now, old)) return replaced_table(now, old, of);
    if (arrays[0] || now.get<Table>()) return added(now, &old, of);
    const auto number = of.has_numbers ? written_number(now) : std::nullopt;
    const bool is_same = number ? says(old, *number) : now.content.index() == old.content.index() && is_equal(now, old);
    return is_same ? std::string(old_.said_of(old)) : added(now, &old, of);
  }

  /// The text of a value that is new, with the units of one that stands near it; null: nothing does.
  std::string added(const Value& now, const Value* like, const Of& of) {
    std::size_t at = now_.begin_of(now);
    std::string out;
    const auto add = [&](const Value& child, const Value* like_child, const Of& of_child) {
      const std::size_t begin = now_.begin_of(child);
      out += now_.text().substr(at, begin - at);
      out += added(child, like_child, of_child);
      at = now_.end_of(child);
    };
    if (const Array* array = now.get<Array>()) {
      const Array* others = like ? like->get<Array>() : nullptr;
      for (std::size_t i = 0; i < array->size(); ++i)
        add((*array)[i], others && !others->empty() ? &(*others)[std::min(i, others->size() - 1)] : like, of);
    } else if (const Table* table = now.get<Table>()) {
      for (const Member& member : *table) {
        const Value* other = like && like->get<Table>() ? like->find(member.key) : nullptr;
        const bool has_own_settings = of.node && !of.node->children.empty();
        add(member.value, other || has_own_settings ? other : like, child_of(of, member.key));
      }
    } else {
      return leaf(now, like, of);
    }
    return out + std::string(now_.text().substr(at, now_.end_of(now) - at));
  }

 private:
  /// Tables of numbers, as { value, to }, have keys that are no settings.
  static Of child_of(const Of& of, const std::string& key) {
    const SchemaNode* child = of.node ? of.node->find(key) : nullptr;
    return child ? setting(*child) : Of{nullptr, of.key, of.has_numbers};
  }

  static bool is_equal(const Value& a, const Value& b) {
    if (const auto* text = a.get<std::string>()) return *text == *b.get<std::string>();
    if (const auto* flag = a.get<bool>()) return *flag == *b.get<bool>();
    if (const auto* integer = a.get<std::int64_t>()) return *integer == *b.get<std::int64_t>();
    if (const auto* real = a.get<double>()) return is_same_number(*real, *b.get<double>());
    return false;
  }

  bool has_same_keys(const Value& now, const Value& old) {
    const Table *all = now.get<Table>(), *others = old.get<Table>();
    if (!all || !others || all->size() != others->size() || !old_.is_inline(old)) return false;
    return std::ranges::all_of(*others, [&](const Member& member) {
      const bool is_whole = member.value.get<Table>() == nullptr || old_.is_inline(member.value);
      return is_whole && now.find(member.key) != nullptr;
    });
  }

  std::string replaced_table(const Value& now, const Value& old, const Of& of) {
    std::size_t at = old_.begin_of(old);
    std::string out;
    for (const Member& member : *old.get<Table>()) {
      const std::size_t begin = old_.begin_of(member.value);
      out += old_.text().substr(at, begin - at);
      out += replaced(*now.find(member.key), member.value, child_of(of, member.key));
      at = old_.end_of(member.value);
    }
    return out + std::string(old_.text().substr(at, old_.end_of(old) - at));
  }

  std::string replaced_array(const Value& now, const Value& old, const Of& of) {
    const Array &all = *now.get<Array>(), &others = *old.get<Array>();
    std::size_t at = old_.begin_of(old);
    std::string out, between = ", ";
    for (std::size_t i = 0; i < others.size(); ++i) {
      const std::size_t begin = old_.begin_of(others[i]);
      const std::string_view before = old_.text().substr(at, begin - at);
      if (i > 0 && before.find('#') == before.npos) between = before;
      if (i < all.size()) out += std::string(before) + replaced(all[i], others[i], of);
      at = old_.end_of(others[i]);
    }
    for (std::size_t i = others.size(); i < all.size(); ++i) out += between + added(all[i], &others.back(), of);
    return out + std::string(old_.text().substr(at, old_.end_of(old) - at));
  }

  std::string leaf(const Value& now, const Value* like, const Of& of) {
    const std::string own(now_.said_of(now));
    const std::optional<Number> number = of.has_numbers ? written_number(now) : std::nullopt;
    if (!number) return own;
    if (const std::string typed = typed_.find(of.key, number->value, number->quantity); !typed.empty())
      return quoted(typed);
    const std::string of_file = like ? unit_of(*like, number->quantity) : "";
    const std::string units[] = {of_file, number->quantity == Quantity::angle ? " deg" : ""};
    for (const std::string& unit : units) {
      if (unit.empty()) continue;
      if (const auto text = number_with(number->value, number->quantity, unit, wanted_)) return quoted(*text);
    }
    return own;
  }

  TextPlaces now_, old_;
  const TypedNumbers& typed_;
  ReadsAs wanted_;
};

constexpr std::string_view kBefore = "value = ";

/// Calls with the text of a value, and with the value as it stands there.
template <class Use>
std::string with_parsed(const std::string& now, const Use& use) {
  const std::string text = std::string(kBefore) + now;
  const Result<Value> parsed = parse_document(text, "");
  PHYSIM_ASSERT(parsed.ok());  // what is written can be read
  return use(TextPlaces(text), parsed->get<Table>()->front().value);
}

void add_lines(const Value& table, const SchemaNode& node, Revision& revision, TextPlaces& places, std::size_t& at,
               std::string& out) {
  for (const Member& member : *table.get<Table>()) {
    const SchemaNode* child = node.find(member.key);
    PHYSIM_ASSERT(child != nullptr);
    const Array* array = member.value.get<Array>();
    const bool is_list = array && child->is_list_of_tables() && !array->empty() && !places.is_inline(array->front());
    if (is_list) {
      for (const Value& each : *array) add_lines(each, *child, revision, places, at, out);
    } else if (member.value.get<Table>() && !places.is_inline(member.value)) {
      add_lines(member.value, *child, revision, places, at, out);
    } else {
      const std::size_t begin = places.begin_of(member.value);
      out += places.text().substr(at, begin - at);
      out += revision.added(member.value, nullptr, Revision::setting(*child));
      at = places.end_of(member.value);
    }
  }
}

}  // namespace

void TypedNumbers::take(std::string_view path, std::string_view text) {
  constexpr std::string_view kEnds = ",[]\"";
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = rest.find_first_of(kEnds);
    const std::string_view number = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    const std::string_view unit = behind_number(number);
    if (unit.empty() || unit.size() == number.size()) continue;
    const Typed typed{std::string(last_key(path)), std::string(number)};
    std::erase(all_, typed);
    all_.push_back(typed);
  }
}

std::string TypedNumbers::find(std::string_view key, double value, Quantity quantity) const {
  const auto is_it = [&](const Typed& typed) {
    if (typed.key != key) return false;
    const Result<double> read = parse_quantity(typed.text, quantity);
    return read && is_same_number(*read, value);
  };
  const auto found = std::find_if(all_.rbegin(), all_.rend(), is_it);
  return found == all_.rend() ? "" : found->text;
}

std::string unit_of(const Value& value, Quantity quantity) {
  if (const auto* text = value.get<std::string>()) {
    if (parse_quantity(*text, quantity)) return std::string(behind_number(trimmed(*text)));
    const Unit* last = last_unit(*text, quantity);  // of "100 yd .. 1000 yd step 100 yd"
    return last ? " " + std::string(last->name) : "";
  }
  std::string unit;
  if (const Array* array = value.get<Array>())
    for (std::size_t i = 0; unit.empty() && i < array->size(); ++i) unit = unit_of((*array)[i], quantity);
  if (const Table* table = value.get<Table>())
    for (std::size_t i = 0; unit.empty() && i < table->size(); ++i) unit = unit_of((*table)[i].value, quantity);
  return unit;
}

std::string in_manner_of(const Value& old, std::string_view text, const std::string& now, const SchemaNode& node,
                         const TypedNumbers& typed) {
  return with_parsed(now, [&](const TextPlaces& places, const Value& value) {
    return Revision(places, TextPlaces(text), typed).replaced(value, old, Revision::setting(node));
  });
}

std::string as_typed(const std::string& now, const SchemaNode& node, const TypedNumbers& typed, const Value* like,
                     ReadsAs wanted) {
  return with_parsed(now, [&](const TextPlaces& places, const Value& value) {
    return Revision(places, TextPlaces(""), typed, wanted).added(value, like, Revision::setting(node));
  });
}

std::string document_as_typed(const std::string& text, const TypedNumbers& typed) {
  const Result<Value> document = parse_document(text, "");
  if (!document) return text;
  TextPlaces places(text);
  Revision revision(places, TextPlaces(""), typed);
  std::string out;
  std::size_t at = 0;
  add_lines(*document, schema(), revision, places, at, out);
  return out + text.substr(at);
}

std::size_t TextPlaces::offset_of(const Value::Position& position) {
  if (std::tie(position.line, position.column) < std::tie(last_.line, last_.column)) last_ = {1, 1}, at_ = 0;
  for (; last_.line < position.line; ++last_.line, last_.column = 1)
    at_ = text_.empty() ? 0 : std::min(text_.find('\n', at_), text_.size() - 1) + 1;
  const auto is_inside = [this](std::size_t i) { return i < text_.size() && (text_[i] & 0xC0) == 0x80; };
  for (; last_.column < position.column && at_ < text_.size(); ++last_.column) do
      ++at_;
    while (is_inside(at_));
  PHYSIM_ASSERT(at_ <= text_.size());
  return at_;
}

std::string_view TextPlaces::said_of(const Value& value) {
  const std::size_t begin = begin_of(value), end = end_of(value);
  PHYSIM_ASSERT(begin <= end);
  return text_.substr(begin, end - begin);
}

bool TextPlaces::is_inline(const Value& table) {
  const std::size_t at = begin_of(table);
  return at < text_.size() && text_[at] == '{';
}

}  // namespace physim
