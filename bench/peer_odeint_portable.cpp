// With the flags of our own portable files: any x86-64, no fused multiply-add; see cmake/bench.cmake.
#include "peer_odeint.hpp"

namespace physim::bench {
void fly_odeint_dopri5_portable(PeerTask& task) { fly_dopri5(task); }
}  // namespace physim::bench
