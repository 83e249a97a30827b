// The field of a setting: a choice, a box to tick or a text, by its row of the list of settings.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "physim/result.hpp"
#include "simclient/core/setting_rows.hpp"

namespace physim::client {

class RowEditor {
 public:
  /// Name and field of a row; what was entered, once it is.
  std::optional<std::string> draw(const SettingRow& row, const std::string& value, bool is_changed);

  /// What was entered last was refused: it stays in its field, which turns red and says why.
  void refuse(const SettingRow& row, const std::string& entered, const Error& why);
  /// This field, or no field, holds a refused value any more.
  void accept(const SettingRow& row) { refused_.erase(row.path); }
  void accept() { refused_.clear(); }

 private:
  std::optional<std::string> draw_text(const SettingRow& row, const std::string& value);

  struct Refused {
    std::string entered, why;
  };

  std::string editing_, typed_;             // the row that is being typed into
  std::map<std::string, Refused> refused_;  // by the paths of rows
};

}  // namespace physim::client
