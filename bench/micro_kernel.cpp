// Compiled once per instruction set, as the batch kernels are.
#include "flight/batch_driver.hpp"
#include "micro.hpp"

PHYSIM_ISA_BEGIN

namespace {

using bench::MicroJob;
using bench::Part;

/// Makes the compiler believe that x was read and written.
template <class R>
PHYSIM_INLINE void touch(R& x) {
  asm volatile("" : : "r"(&x) : "memory");
}

template <class R, class S, class F>
std::size_t repeat(const MicroJob<S>& job, R& result, const F& f) {
  for (int i = 0; i < job.repeats; ++i) {
    f();
    touch(result);
  }
  std::memcpy(job.sink, &result, sizeof result);
  return static_cast<std::size_t>(job.repeats) * kLanes<R>;
}

/// One step tried from where the lanes are, again and again.
template <class R, class S>
std::size_t repeat_step(const MicroJob<S>& job, const Lanes<R>& from, Integrator integrator) {
  Conditions<S> c = *job.course->conditions;
  c.fidelity.integrator = integrator;
  Course<S> course = *job.course;
  course.conditions = &c;
  March<R> march(course);
  march.lanes = from;
  return repeat(job, march.lanes.step.end.x.x, [&] {
    march.lanes.control.h = R(S(0.05));
    march.try_step();
  });
}

template <class R, class S>
std::size_t run(Part part, const MicroJob<S>& job) {
  const Course<S>& course = *job.course;
  const Conditions<S>& c = *course.conditions;
  static March<R> march;
  march = March<R>(course);
  Lanes<R>& lanes = march.lanes;
  for (int lane = 0; lane < kLanes<R>; ++lane) copy_lane(job.bodies[lane], 0, lanes.body, lane);
  march.launch();
  lanes.control.h = R(S(0.05));
  march.try_step();
  R x = lanes.step.start.v.x * S(1.0 / 300);
  R y = x;
  switch (part) {
    case Part::exp: return repeat(job, y, [&] { touch(x), y = exp(x); });
    case Part::log: return repeat(job, y, [&] { touch(x), y = log(x); });
    case Part::cd_lookup: return repeat(job, y, [&] { touch(x), y = curve_cd(c, lanes.body, R(S(1)), x); });
    case Part::air:
      return repeat(job, y, [&] {
        touch(x);
        const AirState<R> air = air_at_altitude<R>(c, c.air.common, x);
        y = air.density + air.per_sound_speed;
      });
    case Part::rhs: {
      Vec3<R> a;
      return repeat(job, y, [&] {
        touch(lanes);
        evaluate(c, lanes.body, lanes.step.t, lanes.step.start, no_step<R>(), a);
        y = a.x + a.y;
      });
    }
    case Part::rk4_step: return repeat_step(job, lanes, Integrator::rk4);
    case Part::tsit5_step: return repeat_step(job, lanes, Integrator::tsit5);
    case Part::dop853_step: return repeat_step(job, lanes, Integrator::dop853);
    case Part::watch: {
      const unsigned all_lanes = lane_bits(x == x);
      StandingWatch<R> watch;
      watch.begin(c, course.watch, lanes);
      return repeat(job, y, [&] {
        touch(lanes);
        const Detected found = watch.pass(c, course.watch, lanes, last_slope(c.fidelity), all_lanes);
        y = needs_attention(course, lanes, all_lanes, found).special != 0 ? x : y;
      });
    }
    case Part::accept: {
      const MaskOf<R> all_lanes = x == x;
      return repeat(job, lanes.step.start.x.x, [&] { march.accept(all_lanes); });
    }
    case Part::enter:
      return repeat(job, lanes.step.start.x.x, [&] {
        for (int lane = 0; lane < kLanes<R>; ++lane) copy_lane(job.bodies[lane], 0, lanes.body, lane);
        march.launch();
      });
  }
  return 0;
}

}  // namespace

std::size_t micro(Part part, const MicroJob<double>& job) { return run<Pack<double, 2 * kNativeBytes / 8>>(part, job); }
std::size_t micro(Part part, const MicroJob<float>& job) { return run<Pack<float, 2 * kNativeBytes / 4>>(part, job); }

PHYSIM_ISA_END
