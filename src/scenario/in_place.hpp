// Distributions that stand in the place of numbers, speed = "800 m/s +- 3 m/s", taken into the inputs of the study.
#pragma once

#include "scenario/document.hpp"
#include "scenario/schema.hpp"

namespace physim {

/// Whether a document, or a part of it with its node, may have a distribution in the place of a number. Most have none,
/// and looking for them path by path takes longer than reading all settings.
[[nodiscard]] bool may_have_distributions(const Value& value, const SchemaNode* node);

/// Puts each of them into study.inputs, before those that are there, and leaves its mean in its place: so `physim run`
/// flies the mean, and other code needs no change. One of several shots is named: "shot.NAME.speed".
[[nodiscard]] Status take_distributions(Value& document, const std::string& file);

/// Whether a value may be a distribution: some tables and texts.
[[nodiscard]] bool looks_uncertain(const Value& value);

}  // namespace physim
