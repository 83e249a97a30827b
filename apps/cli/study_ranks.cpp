#include "study_ranks.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <future>
#include <thread>

#include "base/assert.hpp"
#include "scenario/libraries.hpp"
#include "terminal.hpp"

#if PHYSIM_HAS_MPI
#include <mpi.h>
#endif

namespace physim::cli {

#if PHYSIM_HAS_MPI

namespace {

constexpr int kResultTag = 1, kFailureTag = 2, kOrderTag = 3;
constexpr std::uint64_t kMostShards = 64;       // of an order
constexpr std::chrono::microseconds kNap{200};  // between looks for a message: waiting ranks leave their cores alone
constexpr std::chrono::seconds kLongOrder{5};   // about so long an order takes at most: a study ends with those
                                                // under way, and a rank that dies loses one

/// The launcher asks for the end of all ranks when one of them died.
volatile std::sig_atomic_t asked_to_end = 0;
extern "C" void note_end(int) { asked_to_end = 1; }

/// What another rank sent.
struct Message {
  int from, tag;
  std::vector<std::byte> bytes;
};
/// The message that was probed.
Message receive(MPI_Status& probed) {
  int size = 0;
  MPI_Get_count(&probed, MPI_BYTE, &size);
  Message message{probed.MPI_SOURCE, probed.MPI_TAG, std::vector<std::byte>(static_cast<std::size_t>(size))};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, message.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

/// MPI's own waiting would keep a core busy.
void nap_until_told() {
  int is_there = 0;
  MPI_Iprobe(0, kOrderTag, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
  while (is_there == 0) {
    std::this_thread::sleep_for(kNap);
    MPI_Iprobe(0, kOrderTag, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
  }
}

}  // namespace

/// What the first rank does until a number of shards is flown.
struct Ranks::Round {
  const StudyPlan& plan;
  StudyPartRecord& part;
  const StudyOptions& options;
  ShardsToFly to_fly;
  std::uint64_t next = 0;
  std::size_t in_flight = 0;  // of other ranks
  bool stopped = false;
  std::uint64_t in_time = 1;            // so many shards take about kLongOrder
  std::chrono::nanoseconds nap = kNap;  // between looks for messages: each costs 0.02 ms of processor time

  /// The next shards that are missing: 1, 2, 4 ... of them, which make up a node of the tree, so that they are joined
  /// where they are flown and travel as one. The fewer are left, the fewer at once: all ranks end at about one time.
  Order take(std::uint64_t most) {
    next = part.missing_from(next);
    if (stopped || next >= to_fly.end()) return {};
    to_fly.look_at_time(next);
    if (next >= to_fly.end()) return {};
    std::uint64_t count = 1;
    while (2 * count <= most && next % (2 * count) == 0 && are_missing(next + count, count)) count *= 2;
    next += count;
    return {next - count, count};
  }
  [[nodiscard]] bool are_missing(std::uint64_t first, std::uint64_t count) const {
    if (first + count > to_fly.end()) return false;
    for (std::uint64_t i = 0; i < count; ++i)
      if (part.has(first + i)) return false;
    return true;
  }
  /// For one of so many ranks, which should each come back some times.
  [[nodiscard]] std::uint64_t share(unsigned ranks) const {
    return std::clamp<std::uint64_t>((to_fly.end() - std::min(next, to_fly.end())) / (std::uint64_t{8} * ranks), 1,
                                     in_time);
  }
  /// An order that took so long says how many shards the next ones may have.
  void note_time(std::uint64_t shards, std::chrono::steady_clock::duration taken) {
    const double per_shard = std::chrono::duration<double>(taken).count() / static_cast<double>(shards);
    const double most = std::chrono::duration<double>(kLongOrder).count() / std::max(per_shard, 1e-9);
    in_time = static_cast<std::uint64_t>(std::clamp(most, 1.0, static_cast<double>(kMostShards)));
    nap = std::clamp<std::chrono::nanoseconds>(taken / 100, kNap, 10 * kNap);
  }
};

Ranks::Ranks() {
  if (!job_is_there()) return;
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
  joined_ = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &number_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  if (number_ == 0 && count_ > 1) std::signal(SIGTERM, note_end);
}

Ranks::~Ranks() {
  if (!joined_ || asked_to_end != 0) return;  // with a rank missing, nothing that all of them do would end
  if (number_ == 0)
    for (int others = count_ - 1; others > 0; --others) {
      if (idle_.empty()) {
        MPI_Status status;
        MPI_Probe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &status);
        idle_.push_back(receive(status).from);
      }
      order(idle_.back(), {});
      idle_.pop_back();
    }
  MPI_Finalize();
}

Status Ranks::status() const { return {}; }

void Ranks::order(int rank, const Order& order) {
  PHYSIM_ASSERT(rank > 0 && rank < count_);
  const std::uint64_t words[] = {order.first, order.count};
  MPI_Send(words, 2, MPI_UINT64_T, rank, kOrderTag, MPI_COMM_WORLD);
}

void Ranks::keep(Round& round, const StudyPart& flown) {
  for (const auto& [first, node] : flown.record().nodes) round.part.add(first, node);
  const StudyPart so_far(std::make_shared<const StudyPartRecord>(round.part));
  const auto& after_shard = round.options.after_shard;
  if (!round.stopped && after_shard && !after_shard(so_far)) round.stopped = true;
}

/// Shards that a rank flew; nothing where it only asks for its first.
void Ranks::take_in(Round& round, int from, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  --round.in_flight;
  const auto flown = load_part(bytes);
  const bool is_ours = flown && flown->record().hash == round.part.hash && flown->record().nodes.size() == 1;
  if (is_ours) return keep(round, *flown);
  round.stopped = true;
  failed_ = Error{"rank " + std::to_string(from) + (flown ? " flies another study" : ": " + flown.error().message),
                  "mpirun", "give all nodes the same files and the same physim"};
}

/// One message, where there is one.
bool Ranks::hear(Round& round) {
  MPI_Status status;
  int is_there = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) return false;
  const Message message = receive(status);
  idle_.push_back(message.from);
  if (message.tag != kFailureTag) return take_in(round, message.from, message.bytes), true;
  std::string text;
  for (const std::byte byte : message.bytes) text += static_cast<char>(byte);
  round.stopped = true;
  failed_ = Error{"rank " + std::to_string(message.from) + " cannot fly: " + text, "mpirun", ""};
  return true;
}

Flown Ranks::fly(const StudyPlan& plan, StudyPartRecord& part, std::uint64_t end, const StudyOptions& options) {
  PHYSIM_ASSERT(number_ == 0);
  Round round{plan, part, options, {plan.record(), end, options.time_is_up}, part.missing_from(0)};
  struct OwnOrder {
    StudyPart part;
    std::chrono::steady_clock::duration taken;
  };
  std::future<OwnOrder> own;  // an order of its own, which this rank flies beside its messages as others fly theirs
  std::uint64_t own_shards = 0;
  for (;;) {
    if (asked_to_end != 0) {
      failed_ = Error{"the job was ended: a rank died, or somebody ended it", "mpirun", ""};
      was_ended_ = true;
      static_cast<void>(new std::future<OwnOrder>(std::move(own)));  // nobody has the time to wait for it
      return Flown::stopped;
    }
    if (own.valid() && own.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      const OwnOrder flown = own.get();
      round.note_time(own_shards, flown.taken);
      keep(round, flown.part);
    }
    if (!own.valid())
      if (const Order mine = round.take(round.share(count())); mine.count > 0) {
        own_shards = mine.count;
        own = std::async(std::launch::async, [&plan, mine] {
          const auto begun = std::chrono::steady_clock::now();
          const auto flown = run_shards(plan, mine.first, mine.count);
          PHYSIM_ASSERT(flown.ok());
          return OwnOrder{*flown, std::chrono::steady_clock::now() - begun};
        });
      }
    while (!idle_.empty()) {
      const Order next = round.take(round.share(count()));
      if (next.count == 0) break;
      order(idle_.back(), next);
      idle_.pop_back();
      ++round.in_flight;
    }
    if (!own.valid() && round.in_flight == 0) return round.to_fly.flown(round.stopped);
    if (hear(round)) continue;
    if (own.valid())
      own.wait_for(round.nap);  // ends early when it is flown
    else
      std::this_thread::sleep_for(kNap);
  }
}

void Ranks::serve(const StudyPlan& plan) {
  PHYSIM_ASSERT(number_ > 0);
  std::vector<std::byte> flown;  // none yet
  for (;;) {
    MPI_Send(flown.data(), static_cast<int>(flown.size()), MPI_BYTE, 0, kResultTag, MPI_COMM_WORLD);
    std::uint64_t words[] = {0, 0};
    nap_until_told();
    MPI_Recv(words, 2, MPI_UINT64_T, 0, kOrderTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const Order order{words[0], words[1]};
    if (order.count == 0) return;
    const auto part = run_shards(plan, order.first, order.count);
    PHYSIM_ASSERT(part.ok() && part->record().nodes.size() == 1);
    flown = save_part(*part);
  }
}

void Ranks::give_up(const Error& error) {
  PHYSIM_ASSERT(number_ > 0);
  const std::string text = error.text();
  std::uint64_t over[] = {0, 0};
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, 0, kFailureTag, MPI_COMM_WORLD);
  MPI_Recv(over, 2, MPI_UINT64_T, 0, kOrderTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

Status Ranks::status() const {
  if (!job_is_there()) return {};
  return Error{"this physim was built without MPI, and each rank of the job would fly the whole study", "mpirun",
               "build it where Open MPI is, on Debian libopenmpi-dev; or fly parts with --shards"};
}
Flown Ranks::fly(const StudyPlan&, StudyPartRecord&, std::uint64_t, const StudyOptions&) { PHYSIM_UNREACHABLE(); }
void Ranks::serve(const StudyPlan&) { PHYSIM_UNREACHABLE(); }
void Ranks::give_up(const Error&) { PHYSIM_UNREACHABLE(); }

#endif

}  // namespace physim::cli
