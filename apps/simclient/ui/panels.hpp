// Panels without a state of their own.
#pragma once

#include "simclient/core/client.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

void draw_statistics_panel(Client& client, const Box& box);
/// Under the scene: plots, comparison or performance.
void draw_bottom_panel(Client& client, const Box& box);

void draw_plots(Client& client);
void draw_comparison(Client& client);
void draw_performance(Client& client);

}  // namespace physim::client
