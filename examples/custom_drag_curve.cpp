// Your own drag curve, Cd by Mach number: from radar or a wind tunnel, or a standard curve changed.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  ProjectileDef bullet{.mass = 168_gr, .diameter = 0.308_in};
  bullet.drag.table = DragTable::custom;
  bullet.drag.curve = {{0.0, 0.14}, {0.8, 0.14}, {0.95, 0.25}, {1.05, 0.40}, {1.3, 0.38}, {2.0, 0.32}, {3.0, 0.26}};
  const Launch launch{.speed = 2700_fps, .elevation = 0.3_deg};
  const Until until{.ground = std::nullopt, .range = 900};

  const char* names[] = {"linear", "pchip", "cubic"};
  const Interpolation readings[] = {Interpolation::linear, Interpolation::pchip, Interpolation::cubic};
  for (int i = 0; i < 3; ++i) {
    Fidelity fidelity = Fidelity::small_arms();
    fidelity.interpolation = readings[i];
    const Flight flight = fly(bullet, launch, {}, fidelity, {}, until);
    if (flight.error()) return std::puts(flight.error()->text().c_str()), 1;
    std::printf("read as %-6s: Cd(1.1) = %.4f, height at 900 m %.4f m, %lld evaluations\n", names[i],
                drag_coefficient(bullet.drag, readings[i], 1.1), flight.end().position.y,
                static_cast<long long>(flight.cost().evaluations));
  }

  // The points of a standard function are there to be changed; unchanged they fly as the table itself.
  const auto g7 = drag_points(DragTable::g7);
  bullet.drag.curve.assign(g7.begin(), g7.end());
  const Flight copied = fly(bullet, launch, {}, Fidelity::small_arms(), {}, until);
  bullet.drag.table = DragTable::g7;
  const Flight table = fly(bullet, launch, {}, Fidelity::small_arms(), {}, until);
  const double difference = length(copied.end().position - table.end().position);
  std::printf("a copy of G7 lands %g m from G7 itself\n", difference);
  return difference < 1e-9 ? 0 : 1;
}
