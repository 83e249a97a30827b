#include "world/step/forced_step.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "solve/judge.hpp"
#include "solve/stages.hpp"
#include "world/step/drive.hpp"
#include "world/step/kernels.hpp"
#include "world/step/struck_rows.hpp"

namespace physim {
namespace {

class ForcedStep {
 public:
  ForcedStep(const SettleContext& context, ForcedScratch& scratch)
      : context_(context),
        s_(scratch),
        rows_(scratch.rows),
        field_(*context.registry, *context.state, scratch.rows, scratch.zones),
        kernel_(world_kernel()),
        has_generators_(!context.state->generators.empty()),
        drives_(context.state->emitters.drive_any()) {}

  std::size_t run() {
    const std::size_t count = list_groups();
    if (!has_generators_ || drives_) s_.driven.find(*context_.registry, *context_.state, context_.time, context_.dt);
    for (const ForcedGroup& group : s_.groups) step(group);
    part_ = {0, ~0u};
    for (const ForcedRun& r : s_.runs) {
      in_precision(r, [&]<class S>(S) {
        if (has_generators_) keep_ends<S>(r);
        if (r.attention) settle<S>(r);
      });
    }
    return count;
  }

  /// Once more, with the step that a row took with the others.
  template <class F>
  void with_taken(std::uint16_t cohort, std::uint32_t row, const F& f) {
    for (const ForcedRun& r : s_.runs) {
      if (r.cohort != cohort) continue;
      in_precision(r, [&]<class S>(S) {
        const TakenStep<S> taken = taken_by<S>(r, row);
        SettleContext context = context_;
        context.taken = &taken;
        f(context);
      });
    }
  }

 private:
  static std::size_t padded(std::size_t rows) { return (rows + kRowsPerWord - 1) / kRowsPerWord * kRowsPerWord; }
  [[nodiscard]] Rows& rows_of(const ForcedRun& r) const { return context_.state->rows[r.cohort]; }
  [[nodiscard]] const CohortKey& key(std::uint16_t cohort) const { return context_.registry->cohort(cohort).key; }

  template <class F>
  void in_precision(const ForcedRun& r, const F& f) {
    if (rows_of(r).layout().float32)
      f(float{});
    else
      f(double{});
  }

  // ------------------------------------------------------------------------------------------- who steps
  std::size_t list_groups() {
    s_.groups.clear();
    s_.runs.clear();
    std::size_t floats = 0;
    std::size_t doubles = 0;
    std::size_t words = 0;
    std::size_t count = 0;
    for (const Integrator integrator : all_rungs<Integrator>()) {
      ForcedGroup group{integrator, s_.runs.size(), 0};
      std::uint32_t first = 0;
      for (std::uint16_t c = 0; c < context_.state->rows.size(); ++c) {
        const std::uint32_t size = context_.state->rows[c].size();
        if (size == 0 || !key(c).forced || key(c).still || key(c).fidelity.integrator != integrator) continue;
        if (steps_with_free(context_, c)) continue;
        std::size_t& memory = context_.state->rows[c].layout().float32 ? floats : doubles;
        s_.runs.push_back({c, first, size, memory, words, false});
        memory += padded(size) * forced_columns(end_slope(integrator), context_.state->rows[c].layout().turning);
        words += padded(size) / kRowsPerWord;
        first += size;
      }
      group.last_run = s_.runs.size();
      if (first > 0) s_.groups.push_back(group);
      count += first;
    }
    if (s_.floats.size() < floats) s_.floats.resize(floats);
    if (s_.doubles.size() < doubles) s_.doubles.resize(doubles);
    if (s_.attention.size() < words) s_.attention.resize(words);
    return count;
  }

  void list_rows(const ForcedGroup& group) {
    rows_.clear();
    rows_.first_of_cohort.assign(context_.state->rows.size(), kNotInStage);
    for (const ForcedRun& r : runs(group)) {
      rows_.first_of_cohort[r.cohort] = r.first;
      for (std::uint32_t row = 0; row < r.count; ++row)
        rows_.add(*context_.registry, *context_.state, rows_of(r).slot(row));
    }
  }
  [[nodiscard]] std::span<ForcedRun> runs(const ForcedGroup& group) const {
    return {s_.runs.data() + group.first_run, group.last_run - group.first_run};
  }

  // ------------------------------------------------------------------------------------------- stages
  void step(const ForcedGroup& group) {
    PHYSIM_ASSERT(group.first_run < group.last_run && group.last_run <= s_.runs.size());
    if (has_generators_) list_rows(group), field_.begin_step(context_.time, context_.dt);
    bool attention = false;
    // If not all rows are needed at once, some rows at a time go through all stages: they stay in the cache.
    for (std::uint32_t first = 0, most = longest(group); first < most; first += part_rows()) {
      part_ = {first, std::min(most - first, part_rows())};
      for (int stage = 0; stage < end_slope(group.integrator); ++stage) {
        push(group, stage, stage_place(group.integrator, stage));
        for (ForcedRun& r : runs(group)) {
          if (part_of(r).count == 0) continue;
          in_precision(r, [&]<class S>(S) {
            if (advance_with(kernel_, job<S>(r, stage))) r.attention = true;
          });
          attention = attention || r.attention;
        }
      }
      if (!has_generators_) keep_ends(group);  // else others see these rows as they were
    }
    // Landings and the like lie on the dense output, which needs the slope at the end; a row that meets another flies
    // the rest of its step between the pushes at both ends.
    part_ = {0, longest(group)};
    if ((attention || context_.pairs) && group.integrator != Integrator::classic)
      push(group, end_slope(group.integrator), 1);
  }
  /// Rows of each cohort that go through the stages together.
  struct Part {
    std::uint32_t first = 0, count = 0;
  };
  [[nodiscard]] std::uint32_t part_rows() const { return has_generators_ ? ~0u : 2048; }
  [[nodiscard]] std::uint32_t longest(const ForcedGroup& group) const {
    std::uint32_t most = 0;
    for (const ForcedRun& r : runs(group)) most = std::max(most, r.count);
    return most;
  }
  [[nodiscard]] Part part_of(const ForcedRun& r) const {
    PHYSIM_ASSERT(part_.first % kRowsPerWord == 0);
    const std::uint32_t first = std::min(part_.first, r.count);
    return {first, std::min(part_.count, r.count - first)};
  }

  /// Gathers the states of a stage, asks all generators, and hands out what they give.
  void push(const ForcedGroup& group, int stage, double place) {
    if (has_generators_) {
      bool sound = true;
      for (const ForcedRun& r : runs(group)) in_precision(r, [&]<class S>(S) { sound = gather<S>(r, stage) && sound; });
      rows_.sound = sound;
      field_.evaluate(place);
    }
    for (const ForcedRun& r : runs(group))
      in_precision(r, [&]<class S>(S) { scatter<S>(r, stage, group.integrator, place); });
  }

  /// The states of a stage.
  template <class S>
  struct StageStates {
    const S* at[6];
    StageStates(const ForcedJob<S>& j, int stage) {
      const RowColumns<S>& c = j.rows.columns;
      for (unsigned k = 0; k < 6; ++k)
        at[k] = stage > 0 ? j.column(kStagePosition + k) : k < 3 ? c.position[k] : c.velocity[k - 3];
    }
    [[nodiscard]] State<double> operator[](std::uint32_t row) const {
      return {{double(at[0][row]), double(at[1][row]), double(at[2][row])},
              {double(at[3][row]), double(at[4][row]), double(at[5][row])}};
    }
  };

  template <class S>
  bool gather(const ForcedRun& r, int stage) {
    const StageStates<S> states(job<S>(r, stage), stage);
    double sum = 0;
    for (std::uint32_t row = 0; row < r.count; ++row) {
      const auto [x, v] = states[row];
      rows_.position[r.first + row] = x;
      rows_.velocity[r.first + row] = v;
      sum += 0 * (((x.x + x.y) + (x.z + v.x)) + (v.y + v.z));
    }
    return sum == 0;  // of anything that is no finite number, nothing is 0
  }

  /// What generators and emitters do to the rows, as accelerations.
  template <class S>
  void scatter(const ForcedRun& r, int stage, Integrator integrator, double place) {
    const ForcedJob<S> j = job<S>(r, stage);
    const StageStates<S> states(j, stage);
    const double time = context_.time + place * context_.dt;
    const unsigned first = stage == 0 ? kFirstPush : kPush;
    S* const to[3] = {j.column(first), j.column(first + 1), j.column(first + 2)};
    S* const to_rate = j.column(stage == 0 ? kFirstPushRate : kPushRate);
    constexpr std::uint32_t kBlock = DrivenBlock::kMost;
    DrivenBlock block{.cohort = r.cohort};
    const Part part = part_of(r);
    for (std::uint32_t row = part.first; row < part.first + part.count; row += kBlock) {
      block.first = row;
      block.count = std::min(kBlock, r.count - row);
      const bool is_seen = stage < end_slope(integrator) || has_generators_ || context_.pairs || is_any_marked(r, row);
      if (!is_seen) continue;  // slopes at the end are for those that are settled
      put_generators(r, block);
      if (drives_) {
        block.put(states.at, row);
        s_.driven.push(*context_.registry, *context_.state, integrator, time, block);
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < kBlock; ++i) to[axis][row + i] = static_cast<S>(block.a[axis][i]);
      for (std::uint32_t i = 0; i < kBlock; ++i) to_rate[row + i] = static_cast<S>(block.drag_rate[i]);
    }
  }
  /// What generators do.
  void put_generators(const ForcedRun& r, DrivenBlock& block) const {
    for (auto& axis : block.a) axis.fill(0);
    block.drag_rate.fill(0);
    for (std::uint32_t i = 0; i < block.count && has_generators_; ++i) {
      const std::uint32_t at = r.first + block.first + i;
      const double per_mass = 1 / rows_.mass[at];
      const Vec3d a = rows_.force[at] * per_mass;
      block.a[0][i] = a.x, block.a[1][i] = a.y, block.a[2][i] = a.z;
      block.drag_rate[i] = rows_.drag_rate[at] * per_mass;
    }
  }
  template <class S>
  ForcedJob<S> job(const ForcedRun& r, int stage) {
    ForcedJob<S> j{rows_job<S>(context_, r.cohort), s_.template memory<S>().data() + r.memory, padded(r.count), stage,
                   key(r.cohort).features.has_applied};
    j.rows.first = part_of(r).first;
    j.rows.last = j.rows.first + part_of(r).count;
    j.rows.attention = s_.attention.data() + r.words;
    return j;
  }

  // ------------------------------------------------------------------------------------------- the end
  [[nodiscard]] bool is_marked(const ForcedRun& r, std::uint32_t row) const {
    return (s_.attention[r.words + row / kRowsPerWord] >> row % kRowsPerWord & 1u) != 0;
  }

  [[nodiscard]] bool is_any_marked(const ForcedRun& r, std::uint32_t row) const {
    return s_.attention[r.words + row / kRowsPerWord] != 0;
  }

  /// Rows to which nothing happened are where the last stage left them.
  void keep_ends(const ForcedGroup& group) {
    for (const ForcedRun& r : runs(group)) in_precision(r, [&]<class S>(S) { keep_ends<S>(r); });
  }
  template <class S>
  void keep_ends(const ForcedRun& r) {
    const auto [first_row, count] = part_of(r);
    const std::uint32_t end = first_row + count;
    const ForcedJob<S> j = job<S>(r, 0);
    const RowColumns<S>& c = j.rows.columns;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const S* const x = j.column(kStagePosition + axis);
      const S* const v = j.column(kStageVelocity + axis);
      const S* const carried = j.column(kSlopes + 3 + axis);
      for (std::uint32_t row = first_row; row < end; ++row) {
        if (r.attention && is_marked(r, row)) continue;
        c.previous[axis][row] = x[row];
        c.velocity[axis][row] = v[row];
        if (c.carried[0]) c.carried[axis][row] = carried[row];
      }
    }
    if (!rows_of(r).layout().turning) return;
    const unsigned first = turn_column(end_slope(key(r.cohort).fidelity.integrator));
    for (unsigned i = 0; i < kNumbers<Turn>; ++i)
      for (std::uint32_t row = first_row; row < end; ++row)
        if (!(r.attention && is_marked(r, row))) c.turn[i][row] = j.column(first + i)[row];
  }

  template <class S>
  void settle(const ForcedRun& r) {
    s_.chunk.cohort = r.cohort;
    each_marked(s_.attention.data() + r.words, 0, r.count, [&](std::uint32_t row) {
      const TakenStep<S> taken = taken_by<S>(r, row);
      SettleContext context = context_;
      context.taken = &taken;
      settle_row(context, s_.chunk, row);
    });
  }

  template <class S>
  TakenStep<S> taken_by(const ForcedRun& r, std::uint32_t row) {
    PHYSIM_ASSERT(row < r.count && r.count <= rows_of(r).size());  // no row left; one that woke may have come
    const ForcedJob<S> j = job<S>(r, 0);
    const RowColumns<S>& c = j.rows.columns;
    const Fidelity& f = key(r.cohort).fidelity;
    const bool original = is_classic(f);
    const int stages = end_slope(f.integrator);
    const auto read = [&](unsigned first, auto& into) {
      for (unsigned i = 0; i < sizeof(into) / sizeof(S); ++i) numbers(into)[i] = j.column(first + i)[row];
    };
    TakenStep<S> taken{.is_stepped = true};
    taken.own_force = j.own_force;
    Step<S>& s = taken.step;
    const auto read_part = [&](auto& part) {
      const PartColumns at = columns_of(part, stages);
      read(at.stage, part.end);
      for (int i = 0; i < stages; ++i) read(at.slope(i), part.slope[original ? 1 : i]);
    };
    for_parts(f, read_part, s);
    s.start = {{c.position[0][row], c.position[1][row], c.position[2][row]},
               {c.velocity[0][row], c.velocity[1][row], c.velocity[2][row]}};
    if (original) s.slope[0] = {s.start.v, {c.carried[0][row], c.carried[1][row], c.carried[2][row]}};
    if (rows_of(r).layout().turning) Rows::get(c.turn, row, s.turn->start);
    const auto read_push = [&](unsigned push, unsigned rate, Pushed<S>& into) {
      read(push, into.a);
      into.drag_rate = j.column(rate)[row];
    };
    read_push(kFirstPush, kFirstPushRate, taken.push[0]);
    taken.push[1] = taken.push[0];
    if (!original) read_push(kPush, kPushRate, taken.push[1]);
    if (!is_finite(State<S>{taken.push[1].a, {}})) taken.push[1] = taken.push[0];  // for the next step to find
    taken.driven = drives_;
    taken.pushed = has_generators_;
    return taken;
  }

  const SettleContext& context_;
  ForcedScratch& s_;
  ForceRows& rows_;
  ForceField field_;
  WorldKernel kernel_;
  bool has_generators_;
  bool drives_;  // some emitter acts on the flight of its particles
  Part part_;    // that is under way
};

}  // namespace

bool steps_with_free(const SettleContext& context, std::uint16_t index) {
  const WorldCohort& cohort = context.registry->cohort(index);
  if (!cohort.key.forced) return true;
  const bool alone = context.state->generators.empty() && !context.pairs;
  return alone && cohort.steps_plainly() && !flies_in_parts(*context.def, context.dt);
}

std::size_t step_forced_rows(const SettleContext& context, ForcedScratch& scratch) {
  scratch.chunk.events.clear();
  scratch.chunk.changes.clear();
  scratch.chunk.traces.clear();
  return ForcedStep(context, scratch).run();
}

void with_taken_step(const SettleContext& context, ForcedScratch& scratch, std::uint16_t cohort, std::uint32_t row,
                     const std::function<void(const SettleContext&)>& f) {
  if (steps_with_free(context, cohort)) return f(context);
  ForcedStep(context, scratch).with_taken(cohort, row, f);
}

}  // namespace physim
