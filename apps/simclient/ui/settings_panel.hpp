// The panel at the left: the shot that is fired next, the environment, and what is changed in flight. Every row comes
// from the list of settings.
#pragma once

#include <string>
#include <vector>

#include "simclient/core/client.hpp"
#include "simclient/ui/flight_editor.hpp"
#include "simclient/ui/panel.hpp"
#include "simclient/ui/quick_panel.hpp"

namespace physim::client {

class SettingsPanel {
 public:
  SettingsPanel();
  void draw(Client& client, const Box& box);

 private:
  /// Rows of one table with their values, read anew when something changed.
  struct Sheet {
    std::vector<SettingRow> rows;
    std::vector<std::string> values, usual;  // usual: of the type of shot as it came
    std::uint64_t version = ~std::uint64_t{0};
  };

  void draw_shot(Client& client);
  void draw_type(Client& client);
  void draw_sheet(Client& client, Sheet& sheet, bool is_shot);
  void draw_groups(Client& client, const Sheet& sheet, bool is_shot);
  void draw_group(Client& client, const Sheet& sheet, const std::string& group, bool is_shot);
  void draw_row(Client& client, const SettingRow& row, const std::string& value, bool is_changed);
  [[nodiscard]] bool passes(const SettingRow& row) const;

  Sheet shot_, environment_;
  FlightEditor flight_;
  QuickPanel quick_;
  std::string filter_;
  RowEditor editor_;
};

}  // namespace physim::client
