// With every instruction of this machine and fused multiply-add; see cmake/bench.cmake.
#include "peer_odeint.hpp"

namespace physim::bench {
void fly_odeint_dopri5(PeerTask& task) { fly_dopri5(task); }
void fly_odeint_dopri5_apex(PeerTask& task) { fly_dopri5<AirBy::polynomials, ApexToo::yes>(task); }
void fly_odeint_dopri5_laws(PeerTask& task) { fly_dopri5<AirBy::laws>(task); }
}  // namespace physim::bench
