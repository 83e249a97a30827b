#include "world/step/struck_rows.hpp"

#include <algorithm>

#include "collide/contact_rules.hpp"
#include "world/core/blank_event.hpp"
#include "world/core/placement.hpp"
#include "world/step/step_rows.hpp"

namespace physim {
namespace {

/// Whether what a step watches beside the ground is a height that surely stays far away.
bool watches_heights(const WatchList& watch) {
  const auto is_height = [](const Watched& w) { return row_of(w.spec.kind).watch == Watch::height; };
  return watch.count > 0 && watch.item[0].outcome == Outcome::landed &&
         std::all_of(watch.item, watch.item + watch.count, is_height);
}

/// Rows of one cohort. S is its number type.
template <class S>
class StruckRows {
 public:
  StruckRows(const SettleContext& context, const WorldKernel& kernel, Chunk& chunk)
      : context_(context),
        kernel_(kernel),
        chunk_(chunk),
        cohort_(context.registry->cohort(chunk.cohort)),
        rows_(context.state->rows[chunk.cohort]),
        columns_(rows_.columns<S>()) {
    job_.rows = rows_job<S>(context, chunk.cohort);
  }

  /// Whether a strike may be all that happens to some of them.
  [[nodiscard]] bool may_strike() const {
    const Ground& ground = context_.def->ground;
    const bool stands = ground.conveyor == ConveyorDef{};
    const bool bounces = ground.mode == GroundMode::bounce && context_.dt <= kLongestPart && stands;
    if (!bounces && ground.mode != GroundMode::land) return false;
    const RowLayout& layout = rows_.layout();
    const bool plain = !cohort_.key.forced && !layout.clocked && !layout.carried && !layout.turning && !layout.meeting;
    if (!plain || context_.pairs || !job_.rows.watchdog.simple || layout.fields.size() > kMostFields) return false;
    return watches_heights(cohort_.course_double.watch) && cohort_.static_rung != kNoStaticRung;
  }

  void prepare() {
    const CohortRules& rules = cohort_.key.rules;
    const Ground& ground = context_.def->ground;
    job_.dt = context_.dt;
    job_.frame = frame_of_contact(context_.dt);
    job_.ground = ground.height;
    job_.bounces = ground.mode == GroundMode::bounce;
    job_.below = rules.despawn.below;
    job_.slowest = std::max(rules.despawn.slower, rules.sleep_speed);
    RowColumns<S>& c = job_.rows.columns;
    for (std::size_t axis = 0; axis < 3; ++axis) c.position[axis] = x_[axis], c.velocity[axis] = v_[axis];
    const RowMasks& masks = rows_.field_masks();
    PHYSIM_ASSERT(rows_.layout().fields.size() <= kMostFields);
    for (const std::uint8_t field : rows_.layout().fields) {
      if (masks[field] == 0) continue;  // one for all
      gathered_[fields_] = columns_.field[field];
      c.field[field] = field_[fields_++];
    }
  }

  void add(std::uint32_t row) {
    PHYSIM_ASSERT(is_in_place(*context_.registry, *context_.state, chunk_.cohort, row));
    prefetch_at(rows_.slots() + row);
    row_[job_.count++] = row;
    if (job_.count == kRows) settle();
  }
  void settle() {
    if (job_.count < kFewest) {
      job_.plain = 0;
    } else {
      find_slots();
      gather();
      strike_rows_with(kernel_, job_);
    }
    for (unsigned i = 0; i < job_.count; ++i) {
      if (job_.plain >> i & 1u)
        put(i);
      else
        settle_row(context_, chunk_, row_[i]);
    }
    job_.count = 0;
  }

 private:
  static constexpr unsigned kRows = StrikeJob<S>::kRows;
  static constexpr std::size_t kMostFields = 24;
  static constexpr unsigned kFewest = 3;  // fewer are settled one by one

  void find_slots() {
    for (unsigned i = 0; i < job_.count; ++i) {
      slot_[i] = rows_.slot(row_[i]);
      context_.state->slots.prefetch(slot_[i]);
    }
  }
  void gather(const S* from, S* to) const {
    for (unsigned i = 0; i < job_.count; ++i) to[i] = from[row_[i]];
    std::fill(to + job_.count, to + kRows, to[0]);  // what packs read behind the last one are numbers, too
  }
  void gather() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      gather(columns_.position[axis], x_[axis]);
      gather(columns_.velocity[axis], v_[axis]);
    }
    for (unsigned i = 0; i < fields_; ++i) gather(gathered_[i], field_[i]);
    if (job_.bounces) gather_surfaces();
  }
  void gather_surfaces() {
    const Ground& ground = context_.def->ground;
    std::uint32_t last = 0;  // no kind
    Surface surface{};
    for (unsigned i = 0; i < kRows; ++i) {
      const std::uint32_t kind = i < job_.count ? context_.state->slots[slot_[i]].kind : last;
      if (kind != last) {
        surface = surface_between(ground, OwnSurface::of(context_.registry->kind(kind).body));
        last = kind;
      }
      job_.restitution[i] = surface.restitution;
      job_.friction[i] = surface.friction;
    }
  }

  /// Adds the event of a plain strike, and puts the row where it is after the step.
  void put(unsigned i) {
    PHYSIM_ASSERT(i < job_.count && job_.passed[i] >= 0 && job_.passed[i] <= job_.dt);
    const auto vector = [i](const auto& of) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
    const EventKind kind = job_.bounces ? EventKind::bounced : EventKind::landed;
    const PlainEvent strike{kind,
                            Reason::none,
                            context_.state->slots.id_of(slot_[i]),
                            0,
                            context_.time + job_.passed[i],
                            vector(job_.at),
                            vector(job_.go)};
    if (is_watched_)
      put_plain(strike, add_event(chunk_.events));
    else
      chunk_.strikes.push_back(strike);
    if (!job_.bounces) {
      Change& change = chunk_.changes.emplace_back();
      change.slot = slot_[i];
      change.kind = Change::Kind::remove;
      change.status = LifeStatus::landed;
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_.previous[axis][row_[i]] = x_[axis][i];
      columns_.velocity[axis][row_[i]] = v_[axis][i];
    }
  }

  const SettleContext& context_;
  const WorldKernel& kernel_;
  Chunk& chunk_;
  const WorldCohort& cohort_;
  const Rows& rows_;
  const bool is_watched_ = !context_.state->emitters.empty();  // by emitters, which look at whole events
  const RowColumns<S>& columns_;
  StrikeJob<S> job_;
  unsigned fields_ = 0;  // that differ from row to row
  const S* gathered_[kMostFields];
  std::uint32_t row_[kRows];
  std::uint32_t slot_[kRows];
  alignas(64) S x_[3][kRows];
  alignas(64) S v_[3][kRows];
  alignas(64) S field_[kMostFields][kRows];
};

template <class S>
void settle_marked_in(const SettleContext& context, const WorldKernel& kernel, Chunk& chunk,
                      const std::uint32_t* words) {
  StruckRows<S> struck(context, kernel, chunk);
  if (!struck.may_strike())
    return each_marked(words, chunk.first, chunk.last, [&](std::uint32_t row) { settle_row(context, chunk, row); });
  struck.prepare();
  each_marked(words, chunk.first, chunk.last, [&](std::uint32_t row) { struck.add(row); });
  struck.settle();
}

}  // namespace

void settle_marked(const SettleContext& context, const WorldKernel& kernel, Chunk& chunk, const std::uint32_t* words) {
  if (context.state->rows[chunk.cohort].layout().float32)
    settle_marked_in<float>(context, kernel, chunk, words);
  else
    settle_marked_in<double>(context, kernel, chunk, words);
}

}  // namespace physim
