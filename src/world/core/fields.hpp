// Which numbers of a Body the models of a cohort read: only those get columns.
#pragma once

#include "model/body.hpp"
#include "world/core/rows.hpp"

namespace physim {

/// The columns of a cohort; `launch_place`: a rule asks how far a projectile is from its launch; `meets`:
/// it meets things of a scene.
[[nodiscard]] RowLayout layout_of(const Fidelity& granted, const Features& features, bool launch_place, bool meets);

}  // namespace physim
