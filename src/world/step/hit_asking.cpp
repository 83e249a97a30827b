#include "world/step/hit_asking.hpp"

#include <algorithm>
#include <optional>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "math/vec3.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

bool is_same_hit(const HitQuestion& a, const HitQuestion& b) {
  return a.projectile == b.projectile && a.time == b.time && a.position == b.position && a.velocity == b.velocity &&
         a.instance == b.instance && a.primitive == b.primitive && a.inside == b.inside;
}

/// Why an answer makes no sense; nothing where it does.
std::optional<std::string> fault_of(const HitQuestion& q, const HitAnswer& answer) {
  constexpr double kRounding = 1e-9;  // of the speed, in what a user computes
  if (static_cast<std::size_t>(answer.then) >= names_of<OnHit>().size())
    return "then is none of pass, stop, stick, bounce and impact";
  if (answer.then == OnHit::ask) return "it asks again";
  if (!answer.velocity) return std::nullopt;
  if (answer.then != OnHit::bounce && answer.then != OnHit::pass)
    return "a velocity of its own is for bounce and pass, not for " + std::string(name(answer.then));
  if (!finite(*answer.velocity)) return "its velocity must be finite";
  const Vec3d before = q.velocity - q.surface_velocity, after = *answer.velocity - q.surface_velocity;
  const double speed = length(before), along = dot(after, q.normal);
  if (length(after) > speed * (1 + kRounding))
    return "it gains speed: " + short_text(length(after)) + " m/s, and it came with " + short_text(speed) +
           " m/s, as seen from the surface";
  if (answer.then == OnHit::bounce && along < -kRounding * speed) return "its velocity leads into what it bounces off";
  if (answer.then == OnHit::pass && along >= 0 && !q.inside) return "its velocity leads away from what it passes";
  return std::nullopt;
}

/// In order of time, then of slots, whichever rows reached them.
std::vector<HitQuestion> questions_of(const std::vector<OpenHit>& open) {
  std::vector<HitQuestion> questions;
  questions.reserve(open.size());
  for (const OpenHit& hit : open) questions.push_back(hit.question);
  std::ranges::sort(questions, [](const HitQuestion& a, const HitQuestion& b) {
    return a.time != b.time ? a.time < b.time : a.projectile < b.projectile;
  });
  return questions;
}

/// Once more through the step that the row stands at the start of.
void settle_again(WorldImpl& world, const SettleContext& context, Chunk& chunk, const OpenHit& hit) {
  chunk.cohort = hit.cohort;
  const auto again = [&](const SettleContext& its) { settle_row(its, chunk, hit.row); };
  if (world.registry.cohort(hit.cohort).key.forced)
    with_taken_step(context, world.forced_scratch, hit.cohort, hit.row, again);
  else
    again(context);
}

}  // namespace

void HitAsking::set_function(HitFunction function) {
  function_ = std::move(function);
  gate_.asks = has_function();
}

const HitAnswer* HitAsking::find(const HitQuestion& question) const {
  const auto at = known_.find(question.projectile.index);
  if (at == known_.end()) return nullptr;
  const auto its = std::ranges::find_if(at->second, [&](const Known& k) { return is_same_hit(k.question, question); });
  if (its != at->second.end()) return &its->answer;
  static constexpr HitAnswer kStays{.then = OnHit::stick};
  return at->second.size() < kMostAsked ? nullptr : &kStays;
}

/// Whether the call returned; whatever it does to the world or to the arithmetic of the thread, the step is unaffected.
bool HitAsking::call(std::span<const HitQuestion> questions, std::span<HitAnswer> answers) {
  const Inside inside(gate_);
  try {
    function_({questions, answers});
    return true;
  } catch (...) {
    return false;
  }
}

void HitAsking::ask(std::span<const HitQuestion> questions) {
  PHYSIM_ASSERT(function_ && !questions.empty());
  std::vector<HitAnswer> answers(questions.size());
  const bool came_back = call(questions, answers);
  if (!ModeRegister::is_default(ModeRegister::read())) ModeRegister::set_default();  // it left another one
  ++counts_.calls;
  counts_.questions += questions.size();
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const HitQuestion& q = questions[i];
    const auto fault = came_back ? fault_of(q, answers[i]) : std::optional<std::string>("the function threw something");
    Known known{q, answers[i]};
    if (fault) {
      ++counts_.refused;
      refused_ = "answer " + std::to_string(i + 1) + " of " + std::to_string(questions.size()) + ", projectile " +
                 std::to_string(q.projectile.index) + " at " + short_text(q.time) + " s: " + *fault;
      answers[i] = {.then = OnHit::ask};  // so that a replay counts it, too
      known.answer = {.then = OnHit::stop};
    }
    known_[q.projectile.index].push_back(known);
  }
  if (gate_.recorder) gate_.recorder->frame(Call::answered, answers);
}

void settle_asked(WorldImpl& world, const SettleContext& context) {
  std::vector<std::pair<Chunk*, OpenHit>> rows;
  std::vector<OpenHit> open;
  const auto take = [&](Chunk& chunk) {
    for (const OpenHit& hit : chunk.open) rows.emplace_back(&chunk, hit), open.push_back(hit);
    chunk.open.clear();
  };
  for (;;) {
    rows.clear(), open.clear();
    for (std::size_t i = 0; i < world.scratch.chunk_count; ++i) take(world.scratch.chunks[i]);
    take(world.forced_scratch.chunk);
    if (open.empty()) return;
    world.hit_asking.ask(questions_of(open));
    for (const auto& [chunk, hit] : rows) settle_again(world, context, *chunk, hit);
  }
}

// --------------------------------------------------------------------------------------------------- of a world
Status World::set_hit_function(HitFunction function) {
  WorldImpl& w = impl();
  const Recorded<Call::set_hit_function> call(w, static_cast<bool>(function));
  if (call.is_refused()) return call.refusal();
  if (!function) return Error{"there is nothing to ask", "function", "give one that answers for every hit"};
  w.hit_asking.set_function(std::move(function));
  return {};
}

HitCounts World::hit_counts() const { return impl().hit_asking.counts(); }
std::string World::refused_answer() const { return impl().hit_asking.refused(); }

}  // namespace physim
