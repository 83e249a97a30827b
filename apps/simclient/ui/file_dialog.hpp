// The dialogue that chooses a file to open or to save in: folders, a filter, files that were used lately.
#pragma once

#include <string>

#include "simclient/core/client.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

class FileDialog {
 public:
  /// In the middle of a box, over all else, while the client asks for a file.
  void draw(Client& client, const Box& box, float scale);

 private:
  void begin(const Client& client);
  void draw_places(Client& client);
  void draw_entries(Client& client);
  void choose(Client& client, const std::string& path);

  Dialog shown_ = Dialog::none;  // in the frame before
  std::string folder_, text_;    // that is looked at; what was typed
  bool shows_recent_ = false;
};

}  // namespace physim::client
