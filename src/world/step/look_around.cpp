#include "world/step/look_around.hpp"

#include <algorithm>
#include <cmath>

namespace physim {
namespace {

/// Where a row is after its step, if that was not settled: it lies on a path from one end to the other, which is a
/// cubic with its velocities there, by and large.
template <class S>
struct Way {
  Vec3d from, to, started, ended;

  Way(const RowColumns<S>& c, std::uint32_t row)
      : from(Rows::at(c.position, row)),
        to(Rows::at(c.previous, row)),
        started(Rows::at(c.started, row)),
        ended(Rows::at(c.velocity, row)) {}

  /// Nearer to something it may lie on it [m].
  [[nodiscard]] double touch() const { return std::max(touch_at<S>(from), touch_at<S>(to)); }
  /// Twice as far as that cubic is from its chord [m].
  [[nodiscard]] double beside(double dt) const { return beside_chord(from, started, to, ended, dt); }
  [[nodiscard]] Vec3d at(double part, double dt) const {
    const double rest = 1 - part;
    return from + (to - from) * (part * part * (3 - 2 * part)) + (started * rest - ended * part) * (dt * part * rest);
  }
};

/// Whether a step stays inside of a tube.
template <class S>
bool is_in(const ClearTube<S>& tube, const Way<S>& way, double dt) {
  const auto in = [](const Vec3d& v) { return vec_cast<S>(v); };
  return stays_inside(tube, in(way.from), in(way.started), in(way.to), in(way.ended), static_cast<S>(dt));
}

template <class S>
ClearTube<S> tube_of(const RowColumns<S>& c, std::uint32_t row) {
  ClearTube<S> tube;
  Rows::get(c.tube, row, tube);
  return tube;
}

/// What is known of the things at rest on the way of a step.
enum class Ahead { clear, met, unknown };

/// Where a row looks for a tube from the start of a step on.
template <class S>
TubeAhead ahead_of_step(const SettleContext& context, const Way<S>& way, const CollisionDef& collision) {
  const double dt = context.dt;
  const Vec3d acceleration = (way.ended - way.started) * (1 / dt);
  // With which, at this acceleration, it comes to the end of the step.
  const Vec3d velocity = (way.to - way.from) * (1 / dt) - acceleration * (0.5 * dt);
  return way_ahead<S>(context, {way.from, velocity}, acceleration, way.beside(dt), collision);
}
/// Keeps a tube that holds the step for those that follow.
template <class S>
Ahead judged(const SettleContext& context, const RowColumns<S>& c, std::uint32_t row, const Way<S>& way,
             const ClearTube<S>& tube) {
  if (is_in(tube, way, context.dt)) {
    Rows::put(c.tube, row, tube);
    return Ahead::clear;
  }
  const double part = dot(way.to - way.from, vec_cast<double>(tube.along)) * static_cast<double>(tube.per_square_along);
  return part > 1 ? Ahead::met : Ahead::unknown;
}

/// What a row has found about the things at rest on its way.
template <class S>
Ahead known_of_rest(const SettleContext& context, const RowColumns<S>& c, std::uint32_t row, const Way<S>& way,
                    double beside, const CollisionDef& collision) {
  S& clear = c.clear[row];
  if (context.restless && (clear > 0 || is_in(tube_of(c, row), way, context.dt))) return Ahead::clear;
  const double gone = length(way.to - way.from);
  if (is_look_due(clear, gone)) {
    clear = clear_way<S>(context, {way.to, (way.to - way.from) * (1 / context.dt)}, collision);
    // As far around its end as it came from nothing can be: then nothing was in its way either.
    if (static_cast<double>(clear) > gone + beside) return Ahead::clear;
  } else {
    clear = waited(clear, row, gone);
  }
  return Ahead::unknown;
}

/// Whether a way meets something, by what is known of the things at rest on it.
template <class S>
bool meets(const SettleContext& context, const SceneSegment& way, Ahead rest, const CollisionDef& collision) {
  const SceneFilter filter{.layers = collision.layers};
  if (rest == Ahead::unknown) return context.scene->any_hit(way, filter);
  if (!context.restless) return false;
  collide::Bounds box;
  box.take(way.from), box.take(way.to);
  box.widen(way.radius + 16 * (spacing_at<S>(way.from) + spacing_at<S>(way.to)));
  if (context.restless->may_have_come(box)) return context.scene->any_hit(way, filter);
  return SceneByMotion(*context.scene).meets_mover(way, filter);
}

/// As it was when the step began.
template <class S>
void put_back(const RowColumns<S>& c, std::uint32_t row) {
  for (int axis = 0; axis < 3; ++axis) c.velocity[axis][row] = c.started[axis][row];
}

/// Calls f with the columns of a row and how it collides.
template <class F>
auto with_row(const SettleContext& context, const Chunk& chunk, std::uint32_t row, const F& f) {
  const Rows& rows = context.state->rows[chunk.cohort];
  const Slot& slot = context.state->slots[rows.slot(row)];
  return rows.visit([&](const auto& columns) { return f(columns, context.registry->kind(slot.kind).body.collision); });
}

}  // namespace

namespace {

/// Whether a row that came near meets something, by what is known of the things at rest on its way: what stands close
/// ahead it mostly meets, and settling finds out.
template <class S>
bool may_meet(const SettleContext& context, const Way<S>& way, Ahead rest, const CollisionDef& collision) {
  const double beside = way.beside(context.dt) + 1e-9 + way.touch();
  const SceneSegment segment{way.from, way.to, collision.radius + beside, context.time, context.dt};
  return rest == Ahead::met || meets<S>(context, segment, rest, collision);
}

}  // namespace

void LookAround::add(std::uint32_t row) {
  if (waiting_.is_full()) look_at_waiting();
  with_row(context_, chunk_, row, [&]<class S>(const RowColumns<S>& c, const CollisionDef& collision) {
    const Way way(c, row);
    const double beside = way.beside(context_.dt) + 1e-9;
    if (context_.scene && beside < kInfinity) {  // else it left what numbers can hold, which settling reports
      const Ahead rest = known_of_rest(context_, c, row, way, beside, collision);
      if (rest == Ahead::unknown && knows_rest(context_)) {
        const TubeAhead ahead = ahead_of_step(context_, way, collision);
        if (ahead.room > 0) return waiting_.add(row, ahead);
      }
      if (!may_meet(context_, way, rest, collision)) return;
    }
    look_at_waiting();  // those before it come first
    put_back(c, row);
    settle_row(context_, chunk_, row, settled_);
  });
}

void LookAround::finish() {
  look_at_waiting();
  put_tubes(context_, chunk_, settled_);
}

void LookAround::look_at_waiting() {
  if (waiting_.is_empty()) return;
  waiting_.look(*context_.scene, [&](std::uint32_t row, const TubeAhead& ahead) {
    with_row(context_, chunk_, row, [&]<class S>(const RowColumns<S>& c, const CollisionDef& collision) {
      const Way way(c, row);
      const Ahead rest = judged(context_, c, row, way, tube_along<S>(ahead));
      if (!may_meet(context_, way, rest, collision)) return;
      put_back(c, row);
      settle_row(context_, chunk_, row, settled_);
    });
  });
}

void put_tubes(const SettleContext& context, const Chunk& chunk, RowsAhead& waiting) {
  if (waiting.is_empty()) return;
  waiting.look(*context.scene, [&](std::uint32_t row, const TubeAhead& ahead) {
    with_row(context, chunk, row, [&]<class S>(const RowColumns<S>& c, const CollisionDef&) {
      Rows::put(c.tube, row, tube_along<S>(ahead));
    });
  });
}

namespace {

/// What an engine is asked about near rows.
struct Question {
  NearRow row;
  std::uint32_t layers;
  std::size_t pieces;  // 0: settling asks
};

/// Chords so short that the path stays within half of a skin of them.
template <class S>
std::size_t add_pieces(const SettleContext& context, const Way<S>& way, double radius,
                       std::vector<SceneSegment>& into) {
  constexpr double kMostPieces = 16;
  PHYSIM_ASSERT(context.dt > 0 && radius >= 0);
  const double reach = radius > 0 ? radius + way.touch() : 0;  // a point asks for a ray
  const double pieces = std::max(std::ceil(std::sqrt(way.beside(context.dt) / context.scene->skin())), 1.0);
  if (!(pieces <= kMostPieces)) return 0;
  Vec3d from = way.from;
  for (double i = 0; i < pieces; ++i) {
    const Vec3d to = i + 1 == pieces ? way.to : way.at((i + 1) / pieces, context.dt);
    into.push_back({from, to, reach, context.time + i / pieces * context.dt, context.dt / pieces});
    from = to;
  }
  return static_cast<std::size_t>(pieces);
}

std::vector<Question> questions_about(const SettleContext& context, const std::vector<NearRow>& rows) {
  std::vector<Question> questions;
  for (const NearRow& near : rows)
    with_row(context, *near.chunk, near.row, [&](const auto&, const CollisionDef& collision) {
      questions.push_back({near, collision.layers, 0});
    });
  std::ranges::stable_sort(questions, {}, &Question::layers);
  return questions;
}

/// What the pieces of all questions meet, one behind another.
std::vector<SceneHit> answers_to(const SettleContext& context, std::vector<Question>& questions) {
  std::vector<SceneSegment> pieces;
  std::vector<SceneHit> hits;
  for (std::size_t first = 0, end = 0; first < questions.size(); first = end) {
    const std::size_t begin = pieces.size();
    for (; end < questions.size() && questions[end].layers == questions[first].layers; ++end) {
      const NearRow& near = questions[end].row;
      with_row(context, *near.chunk, near.row, [&](const auto& c, const CollisionDef& collision) {
        // A row that passes also gets the event of leaving what it began in.
        if (collision.on_hit == OnHit::pass) return;
        questions[end].pieces = add_pieces(context, Way(c, near.row), collision.radius, pieces);
      });
    }
    hits.resize(pieces.size());
    context.scene->first_hits(std::span(pieces).subspan(begin), std::span(hits).subspan(begin),
                              {.layers = questions[first].layers});
  }
  return hits;
}

}  // namespace

void look_around(const SettleContext& context, const std::vector<NearRow>& rows) {
  PHYSIM_ASSERT(rows.empty() || context.scene->engine() != nullptr);
  std::vector<Question> questions = questions_about(context, rows);
  const std::vector<SceneHit> hits = answers_to(context, questions);
  std::size_t at = 0;
  for (const Question& question : questions) {
    const auto own = std::span(hits).subspan(at, question.pieces);
    at += question.pieces;
    const bool is_clear = !own.empty() && std::ranges::none_of(own, [](const SceneHit& hit) { return bool(hit); });
    const NearRow& near = question.row;
    with_row(context, *near.chunk, near.row, [&](const auto& c, const CollisionDef&) {
      if (!is_clear) {
        put_back(c, near.row);
        return settle_row(context, *near.chunk, near.row);
      }
      c.clear[near.row] = 0;  // the distance to its things is unknown
    });
  }
  PHYSIM_ASSERT(at == hits.size());
}

}  // namespace physim
