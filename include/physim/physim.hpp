// PhySim: projectile motion with dynamic accuracy. This header brings everything.
#pragma once

#include "physim/air.hpp"
#include "physim/drag_curve.hpp"
#include "physim/environment.hpp"
#include "physim/fidelity.hpp"
#include "physim/flight.hpp"
#include "physim/frames.hpp"
#include "physim/geodesy.hpp"
#include "physim/names.hpp"
#include "physim/projectile.hpp"
#include "physim/quat.hpp"
#include "physim/result.hpp"
#include "physim/units.hpp"
#include "physim/vec3.hpp"
#include "physim/version.hpp"
