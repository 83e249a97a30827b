// Rows that strike the ground, pack by pack: what settling (world/step/settle.cpp) does to each of them alone, for
// those that strike it once in their step and to which nothing else happens. The numbers are the same to the bit: steps
// in the rows' precision, the search for the ground and the contact in double.
#pragma once

#include "model/contact.hpp"
#include "solve/dense.hpp"
#include "world/step/step_rows.hpp"
#include "world/step/strike_job.hpp"

PHYSIM_ISA_BEGIN

/// What semi-implicit Euler's dense output needs of a step: its ends, in double.
template <class W>
struct StrikePath {
  NodeOf<W> n0, n1;

  PHYSIM_INLINE State<W> operator()(const W& theta) const {
    return dense_state(Integrator::semi_implicit_euler, n0, n1, static_cast<const State<W>*>(nullptr), theta);
  }
  PHYSIM_INLINE W time(const W& theta) const { return n0.t + theta * (n1.t - n0.t); }
  /// As DenseLanes gives it.
  PHYSIM_INLINE State<W> moving_at_time(const W& t) const {
    const W theta = place_between(n0, n1, t);
    State<W> s = (*this)(theta);
    move_on(ahead(stagger_of<SemiImplicitEuler>, n0, n1, theta), Vec3<W>{W(0.0), W(1.0), W(0.0)}, s.v, theta, s);
    return s;
  }
};

/// Where in their steps lanes come down to a height, as CrossingFinder finds it; `from` and `to` are how high above it
/// they are at the ends. Behind a call, one for all rungs.
template <class W>
[[gnu::noinline]] void find_strikes(const StrikePath<W>& path, double value, const W& from, const W& to,
                                    const MaskOf<W>& asked, W& theta) {
  const W noise = crossing_noise(value, from, to);
  const auto above = [&](const W& at) PHYSIM_INLINE_LAMBDA { return path(at).x.y - W(value); };
  const W h = path.n1.t - path.n0.t;
  const EndRates<W> rates{path.n0.y.v.y * h, path.n1.y.v.y * h};
  theta = find_roots(above, W(0.0), from, W(1.0), to, kThetaTolerance, noise, asked, &rates);
}

/// The acceleration on a known rung. Behind a call: a step asks four times.
template <class Rung, class R, class S>
[[gnu::noinline]] void find_slope(const Conditions<S>& given, const Body<R>& b, const R& t, const State<R>& s,
                                  const R& h, Vec3<R>& a) {
  const Conditions<S> c = Rung::known(given);
  a = acceleration_over(c, b, t, s, {h, R(ScalarOf<R>(0))});
}

/// A pack of rows on its way through a step. R are numbers of rows, W as many in double.
template <class Rung, class R, class S>
class Strike {
  using W = Cast<double, R>;

 public:
  PHYSIM_INLINE Strike(StrikeJob<S>& job, unsigned first)
      : job_(job), course_(*job.rows.course), first_(first), body_(Rung::template load_body<R>(job.rows, first)) {
    cast_numbers(body_, wide_body_, kBody);
  }

  PHYSIM_INLINE void run() {
    Part part;
    part.t = R(S(0));
    part.h = R(job_.rows.h);
    part.t_end = part.t + part.h;
    part.start = load_state<R>(job_.rows, first_);
    take(part);
    const MaskOf<R> sound = is_finite(part.start) & is_finite(part.end);
    const MaskOf<R> struck = sound & strikes(part);
    if (!any(struck)) return;
    StrikePath<W> path;
    path.n0 = node(part.t, part.start, part.slope);
    path.n1 = node(part.t_end, part.end, slope(part.t_end, part.end, part.h));
    MaskOf<W> plain = cast_mask<double, R>(struck) & (path.n0.y.x.y > W(job_.ground));
    const W t = path.time(place_on_ground(path, part, plain));
    State<W> s = path.moving_at_time(t);
    const W passed = min(t, W(job_.dt));
    plain = plain & (passed > W(0.0));
    const Vec3<W> up{W(0.0), W(1.0), W(0.0)};
    s.x = s.x - up * (s.x.y - W(job_.ground));
    if (job_.bounces) bounce(s, up, passed, plain), go_on(s, passed, plain);
    keep(s, passed, plain);
  }

 private:
  /// One step of semi-implicit Euler, as take_step() takes it.
  struct Part {
    R t, h, t_end;
    State<R> start, end;
    Vec3<R> slope;  // of the velocity, at the start
  };

  static constexpr Fidelity rung() {
    Fidelity f;
    f.drag = Rung::kDrag, f.rotation = RotationModel::none;
    return f;
  }
  static constexpr NumberRuns kBody = parts_read(rung(), Features{}).runs();

  /// The slope that a step of length h takes.
  PHYSIM_INLINE Vec3<R> slope(const R& t, const State<R>& s, const R& h) const {
    Vec3<R> a;
    find_slope<Rung>(*course_.conditions, body_, t, s, h, a);
    return a;
  }
  PHYSIM_INLINE Vec3<W> wide_slope(const W& t, const State<W>& s) const {
    Vec3<W> a;
    find_slope<Rung>(*course_.conditions_double, wide_body_, t, s, W(0.0), a);
    return a;
  }
  PHYSIM_INLINE void take(Part& p) const {
    p.slope = slope(p.t, p.start, p.h);
    go(p);
  }
  PHYSIM_INLINE static void go(Part& p) { p.end = semi_implicit_end(p.start, p.slope, p.h); }
  /// As March::restagger(), where a part ends, from steps of its length to whole ones.
  PHYSIM_INLINE void restagger(Part& p) const {
    constexpr double part = stagger_of<SemiImplicitEuler>;
    const R whole(job_.rows.h);
    const Vec3<R> a = slope(p.t_end, p.end, p.h);
    if constexpr (Rung::kDrag == DragModel::off)
      p.end.v += a * (constant<R>(part) * (p.h - whole));
    else
      p.end.v += lead(a, p.h, part) - lead(slope(p.t_end, p.end, whole), whole, part);
  }
  PHYSIM_INLINE static NodeOf<W> node(const R& t, const State<R>& s, const Vec3<R>& a) {
    NodeOf<W> n;
    n.t = cast<double>(t);
    cast_numbers(s, n.y);
    cast_numbers(a, n.a);
    return n;
  }

  struct Watching {
    R from, to;
    MaskOf<R> once, twice;
  };
  /// As detect() looks at a height.
  PHYSIM_INLINE static Watching watched(const EventSpec& spec, const Part& p) {
    Watching w;
    w.from = p.start.x.y - constant<R>(spec.value), w.to = p.end.x.y - constant<R>(spec.value);
    w.once = crosses(spec.direction, w.from, w.to);
    w.twice = may_cross_twice(w.from, w.to, p.start.v.y, p.end.v.y);
    return w;
  }
  /// Lanes that cross something watched behind the first item of the list.
  PHYSIM_INLINE MaskOf<R> crosses_other(const Part& p) const {
    MaskOf<R> found = R(S(0)) != R(S(0));
    for (int i = 1; i < course_.watch.count; ++i) {
      const Watching w = watched(course_.watch.item[i].spec, p);
      found = found | w.once | w.twice;
    }
    return found;
  }
  /// Lanes that come down to the ground, once, and cross nothing else.
  PHYSIM_INLINE MaskOf<R> strikes(const Part& p) const {
    const Watching w = watched(course_.watch.item[0].spec, p);
    return w.once & !w.twice & !crosses_other(p);
  }

  PHYSIM_INLINE W place_on_ground(const StrikePath<W>& path, const Part& part, const MaskOf<W>& asked) const {
    const double value = course_.watch.item[0].spec.value;
    const Watching w = watched(course_.watch.item[0].spec, part);
    W theta;
    find_strikes(path, value, cast<double>(w.from), cast<double>(w.to), asked, theta);
    return theta;
  }

  /// As GroundContacts lets it bounce, where it flies on.
  PHYSIM_INLINE void bounce(State<W>& s, const Vec3<W>& up, const W& passed, MaskOf<W>& plain) const {
    const SurfaceOf<W> surface{W::load(job_.restitution.data() + first_), W::load(job_.friction.data() + first_),
                               W(0.0)};
    const Vec3<W> v = bounced(s.v, up, surface);
    plain = plain & lifts_off(dot(v, up), dot(wide_slope(passed, s), up), job_.frame);
    s.v = v;
  }
  /// The rest of the step.
  PHYSIM_INLINE void go_on(const State<W>& s, const W& passed, MaskOf<W>& plain) {
    Part part;
    part.t = cast<S>(passed);
    part.h = cast<S>(W(job_.dt) - passed);
    part.t_end = part.t + part.h;
    cast_numbers(s, part.start);
    part.slope = slope(part.t, part.start, part.h);
    part.start.v -= lead(part.slope, part.h, stagger_of<SemiImplicitEuler>);
    go(part);
    const Watching ground = watched(course_.watch.item[0].spec, part);
    const MaskOf<R> quiet = (part.t_end > part.t) & is_finite(part.start) & is_finite(part.end) & !ground.once &
                            !ground.twice & !crosses_other(part);
    restagger(part);
    State<W> end;
    cast_numbers(part.end, end);
    const W speed = length(end.v);
    plain = plain & cast_mask<double, R>(quiet) & (end.x.y >= W(job_.below)) & (speed >= W(job_.slowest));
    const RowColumns<S>& columns = job_.rows.columns;
    store_vector(part.end.x, columns.position, first_);
    store_vector(part.end.v, columns.velocity, first_);
  }

  PHYSIM_INLINE void keep(const State<W>& s, const W& passed, const MaskOf<W>& plain) {
    job_.plain |= lane_bits(plain) << first_;
    passed.store(job_.passed.data() + first_);
    for (unsigned axis = 0; axis < 3; ++axis) {
      s.x[axis].store(job_.at[axis].data() + first_);
      s.v[axis].store(job_.go[axis].data() + first_);
    }
  }

  StrikeJob<S>& job_;
  const Course<S>& course_;
  unsigned first_;
  Body<R> body_;
  Body<W> wide_body_;
};

template <class R, class S>
void strike_packs(StrikeJob<S>& job) {
  PHYSIM_ASSERT(job.count <= job.kRows && job.kRows % unsigned(kLanes<R>) == 0);
  job.plain = 0;
  if constexpr (PHYSIM_KNOWS_RUNGS)
    with_static_rung(job.rows.static_rung, [&](auto rung) {
      using Rung = StaticRung<rung>;
      for (unsigned first = 0; !Rung::kFalls && first < job.count; first += unsigned(kLanes<R>))
        Strike<Rung, R, S>(job, first).run();
    });
}

PHYSIM_ISA_END
