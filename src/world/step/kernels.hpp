// The world's kernel of the instruction set in use (see use_kernel()).
#pragma once

#include "world/step/forced_job.hpp"
#include "world/step/strike_job.hpp"

namespace physim {

struct WorldKernel {
  bool (*step_float)(const WorldJob<float>& job);
  bool (*step_double)(const WorldJob<double>& job);
  bool (*advance_float)(const ForcedJob<float>& job);
  bool (*advance_double)(const ForcedJob<double>& job);
  void (*strike_float)(StrikeJob<float>& job);
  void (*strike_double)(StrikeJob<double>& job);
};

[[nodiscard]] WorldKernel world_kernel();

inline bool step_rows_with(const WorldKernel& kernel, const WorldJob<float>& job) { return kernel.step_float(job); }
inline bool step_rows_with(const WorldKernel& kernel, const WorldJob<double>& job) { return kernel.step_double(job); }
inline bool advance_with(const WorldKernel& kernel, const ForcedJob<float>& job) { return kernel.advance_float(job); }
inline bool advance_with(const WorldKernel& kernel, const ForcedJob<double>& job) { return kernel.advance_double(job); }
/// Rows that may have struck the ground.
inline void strike_rows_with(const WorldKernel& kernel, StrikeJob<float>& job) { kernel.strike_float(job); }
inline void strike_rows_with(const WorldKernel& kernel, StrikeJob<double>& job) { kernel.strike_double(job); }

}  // namespace physim
