// How settings and flights share their column.
#include "simclient/core/layout.hpp"

#include "client/support.hpp"

namespace physim::client {
namespace {

/// The sliders of a shot with three lines that say what was granted instead take some 410 pixels.
TEST(Layout, SettingsAreSeenWholeBesideFlights) {
  Client client = client_of("golf_drive");
  client.settings_height = 410;
  for (const int shots : {1, 3}) {
    while (client.session.tracks().size() < static_cast<std::size_t>(shots)) ASSERT_TRUE(run(client, "fire; wait 1"));
    const Layout large = make_layout(client, 1280, 800, 1);
    EXPECT_GE(large.settings.height, 410) << shots << " shots";
    EXPECT_GE(large.statistics.height, 132) << "a flight is seen";
    const Layout small = make_layout(client, 800, 600, 1);
    EXPECT_GE(small.settings.height, shots == 1 ? 300 : 230) << shots << " shots";
    EXPECT_GE(small.statistics.height, 190) << "a flight with a hit is seen, in a narrow column";
  }
  client.settings_height = 5000;  // all settings are open
  EXPECT_GE(make_layout(client, 1280, 800, 1).statistics.height, 232);
}

}  // namespace
}  // namespace physim::client
