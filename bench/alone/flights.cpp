// Flies the .308 to 1000 m again and again and does nothing else: for counts of instructions, and for times that other
// programs disturb.
//
//   g++ -std=c++20 -O2 -Iinclude bench/alone/flights.cpp build/release/libphysim.a -o flights
//   valgrind --tool=callgrind ./flights 200 5.6e-6      flights, tolerance
//   ./flights 2000 5.6e-6 50                            ... and how often: the shortest time is told
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "physim/physim.hpp"
#include "physim/units.hpp"

using namespace physim;
using namespace physim::units;

int main(int count, char** arguments) {
  const int flights = count > 1 ? std::atoi(arguments[1]) : 200;
  const double error = count > 2 ? std::atof(arguments[2]) : 5.6e-6;
  const int rounds = count > 3 ? std::atoi(arguments[3]) : 1;
  ProjectileDef bullet;
  bullet.name = ".308 168 gr";
  bullet.mass = 168_gr;
  bullet.diameter = 7.82_mm;
  bullet.drag.table = DragTable::g7;
  bullet.drag.ballistic_coefficient = 0.218_lb_in2;
  Environment environment;
  environment.gravity.model = GravityModel::constant;
  Until until;
  until.ground.reset();
  until.range = 1000;
  until.time = 60;
  Fidelity fidelity;
  fidelity.interpolation = Interpolation::cubic;
  fidelity.wind = WindModel::off;
  Tolerance tolerance;
  tolerance.relative = tolerance.absolute = error;
  double least = 1e9, drops = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < flights; ++i) {
      Launch launch;
      launch.speed = 823 + 15 * std::sin(1.7 * i);
      launch.elevation = 0.0122 + 0.005 * std::sin(2.3 * i);
      drops += fly(bullet, launch, environment, fidelity, tolerance, until).end().position.y;
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count() / flights);
  }
  std::printf("%.0f ns a flight; sum of heights %.17g m\n", least, drops);
}
