// Chooses a scenario or recording: out of those at hand, or by its path.
#pragma once

#include <string>
#include <vector>

#include "simclient/core/client.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

class OpenDialog {
 public:
  void draw(Client& client, const Box& scene, float scale);

 private:
  void open(Client& client, const std::string& path);

  std::vector<std::string> files_;
  std::string path_;
  bool was_open_ = false;
};

}  // namespace physim::client
