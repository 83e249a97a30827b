// State: what the client shows, as a line of JSON; for tests that watch it from outside.
#pragma once

#include <string>

#include "simclient/core/client.hpp"

namespace physim::client {

[[nodiscard]] std::string state_line(Client& client, std::uint64_t frame);

}  // namespace physim::client
