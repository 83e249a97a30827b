// PhySim: projectile motion with dynamic accuracy. This header brings everything.
#pragma once

#include "physim/body.hpp"
#include "physim/emitter.hpp"
#include "physim/environment.hpp"
#include "physim/event.hpp"
#include "physim/fidelity.hpp"
#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "physim/names.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"
#include "physim/solve.hpp"
#include "physim/study.hpp"
#include "physim/units.hpp"
#include "physim/world.hpp"
