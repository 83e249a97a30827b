// Changes a projectile while it flies: a separate act from setting up the next one.
#pragma once

#include "simclient/core/client.hpp"
#include "simclient/ui/row_editor.hpp"

namespace physim::client {

class FlightEditor {
 public:
  FlightEditor();
  void draw(Client& client);

 private:
  void take(const World& world, const Track& track);
  void draw_fidelity(Client& client, const Track& track);
  void draw_state(Client& client, const Track& track);
  void draw_body(Client& client, const Track& track);

  ProjectileId id_;  // whose numbers are below
  Fidelity fidelity_;
  Vec3d position_, velocity_, impulse_;
  ScenarioShot shot_;             // what it is to become
  std::vector<SettingRow> rows_;  // of what is live
  RowEditor editor_;
};

}  // namespace physim::client
