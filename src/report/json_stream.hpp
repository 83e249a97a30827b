// JSON written piece by piece, as json_text() writes a whole tree.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "report/records.hpp"
#include "report/text.hpp"

namespace physim::report {

/// Keeps some members or elements until they make a piece. The code that opens an object or a list closes it.
class JsonStream {
 public:
  using Json = nlohmann::ordered_json;
  explicit JsonStream(const Sink& sink) : sink_(sink) {}

  /// Opens an object or a list: under a key in an object, without one in a list or as the whole.
  void object(std::string_view key = {}) { open(key, "{"); }
  void list(std::string_view key = {}) { open(key, "["); }
  void close();

  /// Members of the object that is open.
  void add(const Json& members);
  /// An element of the list that is open.
  void push(Json element);

 private:
  struct Level {
    bool is_list = false, is_empty = true;
  };
  void open(std::string_view key, std::string_view bracket);
  void new_line();
  void flush();

  const Sink& sink_;
  std::vector<Level> levels_;
  Json kept_;  // elements or members that are not written yet
};

/// A member of the open object for each column, a list.
void add_columns(JsonStream& out, const Records& records);

}  // namespace physim::report
