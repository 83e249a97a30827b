// The calls of a recording as types: from the one list in recorded_calls.hpp come their numbers, their names, what they
// take, and how they are made again.
#pragma once

#include <string_view>
#include <tuple>
#include <unordered_map>

#include "base/archive.hpp"
#include "physim/body.hpp"
#include "physim/world.hpp"

namespace physim {

/// What a frame of a recording holds: a call, or one of the first five.
enum class Call : std::uint8_t {
  begin,     // the world's definition
  end,       // nothing follows
  stepped,   // the hash after a step
  returned,  // what the call before it handed out
  answered,  // what its function said about hits that ask
#define PHYSIM_CALL(name, ...) name,
#include "world/core/recorded_calls.hpp"
#undef PHYSIM_CALL
  count
};
inline constexpr auto kCalls = static_cast<std::size_t>(Call::count);

[[nodiscard]] constexpr std::string_view name(Call call) {
  constexpr std::string_view names[] = {
      "begin", "end", "stepped", "returned", "answered",
#define PHYSIM_CALL(name, ...) #name,
#include "world/core/recorded_calls.hpp"
#undef PHYSIM_CALL
  };
  return names[static_cast<std::size_t>(call)];
}

/// What the calls of a replay need beside their arguments: a function that answers hits as recorded, and snapshots by
/// their numbers in the recording. Each is kept until the last call that restores it: a session of
/// rollback netcode takes one in every frame.
class Moments {
 public:
  /// A moment is gone back to once more.
  void expect_restore(std::uint64_t number) { ++moments_[number].restores; }
  void take(const World& world, std::uint64_t number) {
    Snapshot snapshot = world.snapshot();
    if (const auto at = moments_.find(number); at != moments_.end()) at->second.snapshot = std::move(snapshot);
  }
  void restore(World& world, std::uint64_t number) {
    const auto at = moments_.find(number);
    if (at == moments_.end()) return;
    world.restore(at->second.snapshot);
    if (--at->second.restores == 0) moments_.erase(at);
  }

  HitFunction hits;

 private:
  struct Moment {
    Snapshot snapshot;
    std::size_t restores = 0;  // to come
  };
  std::unordered_map<std::uint64_t, Moment> moments_;
};

/// World::spawn() of many; its caller had room for `ids` ids.
inline void spawn_many(World& world, KindId kind, const std::vector<Launch>& launches, std::uint64_t ids) {
  std::vector<ProjectileId> room(static_cast<std::size_t>(std::min<std::uint64_t>(ids, launches.size())));
  world.spawn(kind, launches, room);
}

/// kAgain<Call::despawn>(world, moments, id) makes the call.
template <Call>
inline constexpr int kAgain = 0;
#define PHYSIM_CALL(name, again, ...)                                                            \
  template <>                                                                                    \
  inline constexpr auto kAgain<Call::name> = []([[maybe_unused]] World& w,                       \
                                                [[maybe_unused]] Moments& moments __VA_OPT__(, ) \
                                                    __VA_ARGS__) { static_cast<void>(again); };
#include "world/core/recorded_calls.hpp"
#undef PHYSIM_CALL

template <class F>
struct ArgumentsOfFunction;
template <class F, class... T>
struct ArgumentsOfFunction<void (F::*)(World&, Moments&, T...) const> {
  using Tuple = std::tuple<std::remove_cvref_t<T>...>;
};
/// What a call takes, as values.
template <Call call>
using ArgumentsOf = typename ArgumentsOfFunction<decltype(&decltype(kAgain<call>)::operator())>::Tuple;

/// As what an argument is recorded: spans as lists.
template <class T>
struct RecordedAs {
  using Type = T;
};
template <class T>
struct RecordedAs<std::span<T>> {
  using Type = std::vector<std::remove_const_t<T>>;
};

}  // namespace physim
