// Soak of calls: random programs of calls of a world, each played straight, on three threads, saved and loaded in its
// middle, taken back from a detour of other calls, and recorded and replayed. All of these must end in one world: equal
// hashes and events after each call, and equal positions, forces, joints, particles and counters at the end.
//
//   physim_calls_soak [COUNT [SEED [FIRST]]]
//
// A program that differs, crashes or takes too long is told by its number, and shrunk to few calls that still show it.
// Each is played in a process of its own. Meant to run under the sanitizers, too: ./dev soak --calls --asan.
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fuzz/arguments.hpp"
#include "soak/played.hpp"

namespace physim::test {
namespace {

/// Processor time for one way of playing one program, which takes some hundredths of a second [s].
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kPatience = 200;
#else
constexpr int kPatience = 20;
#endif
constexpr int kMostTrials = 400;  // of a program that is shrunk

/// From now on the process may take so much time before it is ended.
void be_patient() {
  itimerval limit{};
  limit.it_value.tv_sec = kPatience;
  setitimer(ITIMER_PROF, &limit, nullptr);
}

void write_line(int to, const std::string& text) {
  const std::string line = text + "\n";
  if (write(to, line.data(), line.size()) < 0) _exit(3);
}

/// In a process of its own: plays a program in all ways, and writes before each which it is, then what is wrong.
void play_all(const CallProgram& program, int to) {
  be_patient();
  write_line(to, kPlayedHow[0]);
  const auto straight = play(program, PlayedHow::straight);
  if (!straight.first.empty()) write_line(to, straight.first), _exit(1);
  for (std::size_t i = 1; i < std::size(kPlayedHow); ++i) {
    be_patient();
    write_line(to, kPlayedHow[i]);
    auto [wrong, marks] = play(program, static_cast<PlayedHow>(i));
    if (wrong.empty()) wrong = difference(straight.second, marks);
    if (!wrong.empty()) write_line(to, wrong), _exit(1);
  }
  _exit(0);
}

struct Verdict {
  bool good = true;
  std::string how, wrong;
};

std::string read_all(int from) {
  std::string text;
  char piece[4096];
  for (ssize_t n = 0; (n = read(from, piece, sizeof piece)) > 0;) text.append(piece, static_cast<std::size_t>(n));
  return text;
}

Verdict verdict_of(const CallProgram& program) {
  int ends[2];
  if (pipe(ends) != 0) return {false, "", "no pipe"};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    play_all(program, ends[1]);
  }
  close(ends[1]);
  const std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return {false, "", "no process"};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  Verdict v{false, "", ""};
  std::size_t from = 0;
  for (std::size_t end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1) {
    v.how = std::exchange(v.wrong, text.substr(from, end - from));
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 1) return v;
  v.how = v.wrong;
  v.wrong = !WIFSIGNALED(status)          ? "it ends with " + std::to_string(WEXITSTATUS(status))
            : WTERMSIG(status) == SIGPROF ? "it takes more than " + std::to_string(kPatience) + " s"
                                          : "signal " + std::to_string(WTERMSIG(status));
  return v;
}

/// Leaves calls out of a program, as long as it goes wrong in the same way of playing.
class Shrinking {
 public:
  Shrinking(const CallProgram& program, std::string how) : program_(program), how_(std::move(how)) {}

  CallProgram run() {
    for (bool smaller = true; smaller && trials_ < kMostTrials;) {
      smaller = false;
      for (auto list : {&CallProgram::after, &CallProgram::detour, &CallProgram::before})
        smaller = shrink(list) || smaller;
    }
    return program_;
  }

 private:
  bool shrink(std::vector<std::uint64_t> CallProgram::*list) {
    bool smaller = false;
    for (std::size_t part = std::max<std::size_t>((program_.*list).size() / 2, 1); part > 0; part /= 2) {
      for (std::size_t at = (program_.*list).size(); at > 0 && trials_ < kMostTrials;) {
        const std::size_t first = at > part ? at - part : 0;
        CallProgram less = program_;
        auto& calls = less.*list;
        calls.erase(calls.begin() + static_cast<std::ptrdiff_t>(first),
                    calls.begin() + static_cast<std::ptrdiff_t>(std::min(at, calls.size())));
        at = first;
        ++trials_;
        const Verdict v = verdict_of(less);
        if (v.good || v.how != how_) continue;
        program_ = std::move(less);
        smaller = true;
      }
    }
    return smaller;
  }

  CallProgram program_;
  std::string how_;
  int trials_ = 0;
};

/// The names of calls, as they would be made one after the other.
void tell_calls(const CallProgram& program) {
  PlayedProgram played(program, {1, 1});
  for (const auto& [title, calls] : {std::pair("before", &program.before), std::pair("detour", &program.detour),
                                     std::pair("after", &program.after)}) {
    std::printf("  %s:", title);
    for (const std::uint64_t seed : *calls) {
      const std::string name = SoakCall(played.world(), played.known(), seed).make();
      std::printf(" %s [%016llx];", name.c_str(), static_cast<unsigned long long>(seed));
    }
    std::printf("\n");
  }
}

/// In a process of its own, as the program may crash.
void tell(const CallProgram& program) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    be_patient();
    tell_calls(program);
    std::fflush(stdout);
    _exit(0);
  }
  if (child > 0) static_cast<void>(waitpid(child, nullptr, 0));
}

bool is_good(const FuzzArguments& asked, long number) {
  const CallProgram program =
      random_program(static_cast<std::uint64_t>(asked.seed) * 1000003u + static_cast<std::uint64_t>(number));
  const Verdict found = verdict_of(program);
  if (found.good) return true;
  std::printf("program %ld of seed %ld, %s: %s\n", number, asked.seed, found.how.c_str(), found.wrong.c_str());
  const CallProgram small = Shrinking(program, found.how).run();
  const Verdict still = verdict_of(small);
  std::printf("  shrunk to %zu, %zu and %zu calls, %s: %s\n", small.before.size(), small.detour.size(),
              small.after.size(), still.how.c_str(), still.wrong.c_str());
  tell(small);
  return false;
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  using namespace physim::test;
  const auto asked = read_arguments("physim_calls_soak", argc, argv);
  if (!asked) return 2;
  long wrong = 0;
  for (long i = asked->first; i < asked->first + asked->count; ++i) {
    if (!is_good(*asked, i)) ++wrong;
    if (i % 500 == 499) std::fprintf(stderr, "%ld programs, %ld wrong\n", i + 1 - asked->first, wrong);
  }
  std::printf("%ld programs of calls, each played in %zu ways; %ld wrong\n", asked->count, std::size(kPlayedHow),
              wrong);
  return wrong > 0 ? 1 : 0;
}
