// Lack of memory that worlds take for a refusal: a projectile that is not spawned, particles that are not born.
#pragma once

namespace physim {

/// Set in the thread where it happened, for borders that must tell it from other refusals; they clear it.
inline thread_local bool memory_lacked = false;

}  // namespace physim
