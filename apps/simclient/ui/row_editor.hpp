// The field of a setting: a choice, a box to tick or a text, by its row of the list of settings.
#pragma once

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
  /// No field holds a refused value any more.
  void accept() { refused_.clear(); }

 private:
  std::optional<std::string> draw_text(const SettingRow& row, const std::string& value);

  std::string editing_, typed_;          // the row that is being typed into
  std::string refused_, entered_, why_;  // the row that holds a refused value; empty: none
};

}  // namespace physim::client
