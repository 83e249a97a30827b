// Random worlds, and random calls of the whole public interface: sensible ones, and what nobody should hand in. Bad
// numbers, enumerators beyond their list, ids that are gone or of another world, callbacks that change what calls them,
// saves and recordings with damaged bytes.
//
//   physim_world_fuzz [COUNT [SEED [FIRST]]]
//
// Whatever is asked, nothing crashes, nothing takes long, and numbers that are not finite stay out of the world. A
// world that is loaded or replayed has the hash of the one that was saved or recorded. Meant to run under the
// sanitizers: ./dev fuzz --worlds --asan.
#include <unistd.h>

#include <csignal>

#include "fuzz/arguments.hpp"
#include "fuzz/odd_flights.hpp"
#include "fuzz/odd_session.hpp"

namespace physim::test {
namespace {

// For one world, a thousand times what one takes; searches of up to five million steps are slow under a sanitizer [s].
#ifdef __SANITIZE_ADDRESS__
constexpr unsigned kPatience = 900;
#else
constexpr unsigned kPatience = 120;
#endif

/// Says which world it was before it ends.
extern "C" void give_up(int signal) {
  char text[80];
  const int length = std::snprintf(text, sizeof text, "world %ld: signal %d\n", case_number, signal);
  static_cast<void>(::write(STDOUT_FILENO, text, static_cast<std::size_t>(length)) == length);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void play(long seed, long number) {
  case_number = number;
  alarm(kPatience);
  constexpr int kRarity[] = {0, 200, 40, 8};  // the more is odd, the more is refused at the door
  const std::uint64_t start = static_cast<std::uint64_t>(seed) * 1000003u + static_cast<std::uint64_t>(number);
  Odd r(start, kRarity[number % 4]);
  OddFlights flights(r);
  for (int i = 0; i < 2; ++i) flights.act();
  Session session(r);
  for (int i = 0, n = 20 + r.below(40); i < n; ++i) session.act();
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  using namespace physim::test;
  const auto asked = read_arguments("physim_world_fuzz", argc, argv);
  if (!asked) return 2;
  for (const int signal : {SIGALRM, SIGABRT}) std::signal(signal, give_up);
  for (long i = asked->first; i < asked->first + asked->count; ++i) {
    play(asked->seed, i);
    if (i % 5000 == 4999) std::fprintf(stderr, "%ld worlds\n", i + 1 - asked->first);
  }
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf(
      "%ld worlds: %llu calls, %llu spawned, %llu steps, %llu from inside; %llu saves, %llu damaged ones load; %llu "
      "replays; "
      "%llu of %llu flights flown; %ld wrong\n",
      asked->count, n(tally.calls), n(tally.spawned), n(tally.steps), n(tally.inside), n(tally.saves),
      n(tally.damaged_loads), n(tally.replays), n(tally.flown), n(tally.flights), faults);
  return faults > 0 ? 1 : 0;
}
