#include "report/json_stream.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "report/json.hpp"

namespace physim::report {
namespace {

constexpr std::size_t kKept = 64;  // looking through the keys of this many members costs less than writing them

}  // namespace

void JsonStream::new_line() { sink_("\n" + std::string(levels_.size(), ' ')); }

void JsonStream::open(std::string_view key, std::string_view bracket) {
  flush();
  PHYSIM_ASSERT(key.empty() == (levels_.empty() || levels_.back().is_list));
  if (!levels_.empty()) {
    if (!levels_.back().is_empty) sink_(",");
    levels_.back().is_empty = false;
    new_line();
  }
  if (!key.empty()) sink_(json_line(key) + ": ");
  sink_(bracket);
  levels_.push_back({.is_list = bracket == "["});
  kept_ = bracket == "[" ? Json::array() : Json::object();
}

void JsonStream::close() {
  flush();
  PHYSIM_ASSERT(!levels_.empty());
  const Level closed = levels_.back();
  levels_.pop_back();
  if (!closed.is_empty) new_line();
  sink_(closed.is_list ? "]" : "}");
  if (levels_.empty()) return sink_("\n");
  kept_ = levels_.back().is_list ? Json::array() : Json::object();
}

void JsonStream::add(const Json& members) {
  PHYSIM_ASSERT(!levels_.empty() && !levels_.back().is_list);
  PHYSIM_ASSERT(members.is_object());
  kept_.update(members);
  if (kept_.size() >= kKept) flush();
}

void JsonStream::push(Json element) {
  PHYSIM_ASSERT(!levels_.empty() && levels_.back().is_list);
  kept_.push_back(std::move(element));
  if (kept_.size() >= kKept) flush();
}

/// Writes what is kept as a tree is written, without its brackets and further to the right.
void JsonStream::flush() {
  if (kept_.empty()) return;
  PHYSIM_ASSERT(!levels_.empty());
  const std::string text = json_text(kept_);
  constexpr std::string_view kEnd = "\n}\n";
  const std::string_view inside = std::string_view(text).substr(1, text.size() - 1 - kEnd.size());
  const std::string margin(levels_.size() - 1, ' ');
  std::string out = levels_.back().is_empty ? "" : ",";
  for (std::size_t begin = 0, end = 0; begin < inside.size(); begin = end) {
    end = std::min(inside.find('\n', begin), inside.size() - 1) + 1;
    out += inside.substr(begin, end - begin);
    if (out.back() == '\n') out += margin;
  }
  sink_(out);
  levels_.back().is_empty = false;
  kept_.clear();
}

void add_columns(JsonStream& out, const Records& records) {
  for (std::size_t i = 0; i < records.columns.size(); ++i) {
    out.list(records.columns[i]);
    records.rows([&](Row row) {
      PHYSIM_ASSERT(row.size() == records.columns.size());
      const auto push = [&]<class Value>(const Value& value) {
        if constexpr (std::is_same_v<Value, std::monostate>)
          out.push(nullptr);
        else
          out.push(value);
      };
      std::visit(push, row[i]);
    });
    out.close();
  }
}

}  // namespace physim::report
