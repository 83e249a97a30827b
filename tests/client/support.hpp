// What tests of the client share.
#pragma once

#include "must.hpp"
#include "simclient/core/script.hpp"

namespace physim::client {

/// SimClient without a window, on a shipped scenario or on none.
inline Client client_of(const std::string& scenario = "") {
  const std::string file = scenario.empty() ? "" : PHYSIM_SOURCE_DIR "/scenarios/" + scenario + ".toml";
  return std::move(open_client(file, {}).value());
}

/// Runs a script, frame by frame.
inline Status run(Client& client, const std::string& text) {
  Script script = Script::parse(text).value();
  for (int i = 0; i < script.frames(); ++i) {
    if (Status status = script.run(client); !status) return status;
    client.advance(1.0 / 60);
  }
  return {};
}

}  // namespace physim::client
