// Quick settings: what people change first, as sliders; and accuracy as one slider over the presets of fidelity.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simclient/core/client.hpp"

namespace physim::client {

enum class Quick { speed, elevation, azimuth, mass, drag, wind_along, wind_across };

/// A slider with its reach; drag is off at 0 and on at 1.
struct QuickSetting {
  Quick what = Quick::speed;
  std::string name, unit, doc;
  double low = 0, high = 1, value = 0;  // in the unit
  bool is_logarithmic = false;
  std::string idle;  // why it does nothing; empty: it does
};

/// Sliders of the next shot, as it is set. The reach of a slider holds its value, and stays while that moves within it.
[[nodiscard]] std::vector<QuickSetting> quick_settings(Client& client);
/// Changes one of them, to a value in its unit.
[[nodiscard]] Status set_quick(Client& client, const QuickSetting& setting, double value);

/// A preset of fidelity, from the cheapest to the truest.
struct AccuracyRung {
  std::string_view preset, label, doc;
};
[[nodiscard]] std::span<const AccuracyRung> accuracy_rungs();
/// The rung whose preset has most of a fidelity, and whether it has all.
struct Accuracy {
  std::size_t rung = 0;
  bool is_preset = false;
};
[[nodiscard]] Accuracy accuracy_of(const Fidelity& fidelity);
[[nodiscard]] Status set_accuracy(Client& client, std::size_t rung);

}  // namespace physim::client
