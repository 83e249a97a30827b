#include "study_ranks.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <future>
#include <limits>
#include <optional>
#include <thread>

#include "base/assert.hpp"

#if PHYSIM_HAS_MPI
#include <mpi.h>
#endif

namespace physim::cli {
namespace {

/// Launchers tell how many there are: Open MPI's mpirun, Slurm's srun with PMIx or PMI-2.
bool job_is_there() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace

#if PHYSIM_HAS_MPI

namespace {

constexpr int kResultTag = 1, kFailureTag = 2, kOrderTag = 3;
constexpr std::uint64_t kOver = std::numeric_limits<std::uint64_t>::max();

/// The launcher asks for the end of all ranks when one of them died.
volatile std::sig_atomic_t asked_to_end = 0;
extern "C" void note_end(int) { asked_to_end = 1; }

}  // namespace

/// What the first rank does until a number of shards is flown.
struct Ranks::Round {
  const StudyPlan& plan;
  StudyPartRecord& part;
  std::uint64_t end;
  const std::function<bool(const StudyPart&)>& after_shard;
  std::uint64_t next = 0;
  std::size_t in_flight = 0;  // of other ranks
  bool stopped = false;

  /// The next shard that is missing.
  std::optional<std::uint64_t> take() {
    next = part.missing_from(next);
    if (stopped || next >= end) return std::nullopt;
    return next++;
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
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        std::vector<std::byte> bytes(static_cast<std::size_t>(size));
        MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, &status);
        idle_.push_back(status.MPI_SOURCE);
      }
      order(idle_.back(), kOver);
      idle_.pop_back();
    }
  MPI_Finalize();
}

Status Ranks::status() const { return {}; }

void Ranks::order(int rank, std::uint64_t shard) {
  PHYSIM_ASSERT(rank > 0 && rank < count_);
  MPI_Send(&shard, 1, MPI_UINT64_T, rank, kOrderTag, MPI_COMM_WORLD);
}

void Ranks::keep(Round& round, const StudyPart& flown) {
  for (const auto& [first, node] : flown.record().nodes) round.part.add(first, node);
  const StudyPart so_far(std::make_shared<const StudyPartRecord>(round.part));
  if (!round.stopped && round.after_shard && !round.after_shard(so_far)) round.stopped = true;
}

/// A shard that a rank flew; nothing where it only asks for its first.
void Ranks::take_in(Round& round, int from, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  --round.in_flight;
  const auto flown = load_part(bytes);
  const bool is_ours = flown && flown->record().hash == round.part.hash && flown->shards() == 1;
  if (is_ours) return keep(round, *flown);
  round.stopped = true;
  failed_ = Error{"rank " + std::to_string(from) + " flies another study, or is of another version", "mpirun",
                  "give all nodes the same files and the same physim"};
}

/// One message, where there is one.
void Ranks::hear(Round& round) {
  MPI_Status status;
  int is_there = 0, size = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    return;
  }
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, &status);
  idle_.push_back(status.MPI_SOURCE);
  if (status.MPI_TAG != kFailureTag) return take_in(round, status.MPI_SOURCE, bytes);
  std::string text;
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
  round.stopped = true;
  failed_ = Error{"rank " + std::to_string(status.MPI_SOURCE) + " cannot fly: " + text, "mpirun", ""};
}

bool Ranks::fly(const StudyPlan& plan, StudyPartRecord& part, std::uint64_t end,
                const std::function<bool(const StudyPart&)>& after_shard) {
  PHYSIM_ASSERT(number_ == 0);
  Round round{plan, part, end, after_shard, part.missing_from(0)};
  std::future<StudyPart> own;  // a shard that this rank flies beside its messages
  for (;;) {
    if (asked_to_end != 0) {
      failed_ = Error{"the job was ended: a rank died, or somebody ended it", "mpirun", ""};
      was_ended_ = true;
      static_cast<void>(new std::future<StudyPart>(std::move(own)));  // nobody has the time to wait for it
      return false;
    }
    if (own.valid() && own.wait_for(std::chrono::seconds(0)) == std::future_status::ready) keep(round, own.get());
    if (!own.valid())
      if (const auto shard = round.take())
        own = std::async(std::launch::async, [&plan, number = *shard] { return run_shard(plan, number); });
    while (!idle_.empty()) {
      const auto shard = round.take();
      if (!shard) break;
      order(idle_.back(), *shard);
      idle_.pop_back();
      ++round.in_flight;
    }
    if (!own.valid() && round.in_flight == 0) return !round.stopped;
    hear(round);
  }
}

void Ranks::serve(const StudyPlan& plan) {
  PHYSIM_ASSERT(number_ > 0);
  std::vector<std::byte> flown;  // none yet
  for (;;) {
    MPI_Send(flown.data(), static_cast<int>(flown.size()), MPI_BYTE, 0, kResultTag, MPI_COMM_WORLD);
    std::uint64_t shard = kOver;
    MPI_Recv(&shard, 1, MPI_UINT64_T, 0, kOrderTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (shard == kOver) return;
    flown = save_part(run_shard(plan, shard));
  }
}

void Ranks::give_up(const Error& error) {
  PHYSIM_ASSERT(number_ > 0);
  const std::string text = error.text();
  std::uint64_t over = 0;
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, 0, kFailureTag, MPI_COMM_WORLD);
  MPI_Recv(&over, 1, MPI_UINT64_T, 0, kOrderTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

Status Ranks::status() const {
  if (!job_is_there()) return {};
  return Error{"this physim was built without MPI, and each rank of the job would fly the whole study", "mpirun",
               "build it where Open MPI is, on Debian libopenmpi-dev; or fly parts with --shards"};
}
bool Ranks::fly(const StudyPlan&, StudyPartRecord&, std::uint64_t, const std::function<bool(const StudyPart&)>&) {
  PHYSIM_UNREACHABLE();
}
void Ranks::serve(const StudyPlan&) { PHYSIM_UNREACHABLE(); }
void Ranks::give_up(const Error&) { PHYSIM_UNREACHABLE(); }

#endif

}  // namespace physim::cli
