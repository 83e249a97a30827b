// Memory runs out in the C interface, at every allocation once: the n-th fails, for every n of a flight, a batch and a
// small world. Each time an error code comes, and what is freed is freed. Prints what does otherwise.
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "physim/physim.h"

namespace {

std::atomic<long> left{-1};     // allocations until one fails; negative: none does
std::atomic<long> standing{0};  // allocations that were not given back
std::atomic<bool> failed{false};

void* allocated(std::size_t size, std::size_t alignment) {
  if (left >= 0 && left-- == 0) {
    failed = true;
    return nullptr;
  }
  void* const memory = alignment > alignof(std::max_align_t)
                           ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                           : std::malloc(size != 0 ? size : 1);
  if (memory != nullptr) ++standing;
  return memory;
}

void* allocated_or_throw(std::size_t size, std::size_t alignment) {
  void* const memory = allocated(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void given_back(void* memory) {
  if (memory != nullptr) --standing;
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return allocated_or_throw(size, 0); }
void* operator new[](std::size_t size) { return allocated_or_throw(size, 0); }
void* operator new(std::size_t size, std::align_val_t to) {
  return allocated_or_throw(size, static_cast<std::size_t>(to));
}
void* operator new[](std::size_t size, std::align_val_t to) {
  return allocated_or_throw(size, static_cast<std::size_t>(to));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocated(size, 0); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocated(size, 0); }
void operator delete(void* memory) noexcept { given_back(memory); }
void operator delete[](void* memory) noexcept { given_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { given_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { given_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { given_back(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { given_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { given_back(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { given_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { given_back(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { given_back(memory); }

namespace {

constexpr const char* kShot =
    "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"175 gr\"\ndiameter = \"7.82 mm\"\nspeed = \"100 m/s\"\n"
    "elevation = \"10 deg\"\nfidelity = \"small_arms\"\n"
    "drag = { table = \"g7\", ballistic_coefficient = \"0.243 lb/in^2\" }\n";
constexpr const char* kWorld =
    "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"10 cm\"\nspeed = \"20 m/s\"\n"
    "elevation = \"45 deg\"\nfidelity = \"game\"\nbody.collision = { on_hit = \"bounce\", radius = \"5 cm\" }\n"
    "[world]\nstep = \"10 ms\"\nthreads = 1\n[[shape]]\nname = \"box\"\nbox = { half = [0.5, 5, 5] }\n"
    "[[thing]]\nname = \"wall\"\nshape = \"box\"\nposition = [3, 5, 0]\n"
    "[[emitter]]\nname = \"sparks\"\nshot = \"ball\"\nper_second = 100\nseed = 1\n";

/// The first code of some calls that is not PHYSIM_OK.
class Steps {
 public:
  void operator()(physim_result code) {
    if (code_ == PHYSIM_OK) code_ = code;
  }
  [[nodiscard]] bool ok() const { return code_ == PHYSIM_OK; }
  [[nodiscard]] physim_result code() const { return code_; }

 private:
  physim_result code_ = PHYSIM_OK;
};

double answer = 0;  // of the last calls that were good

physim_result flight() {
  Steps step;
  physim_def* def = nullptr;
  physim_flight* made = nullptr;
  physim_sample at{};
  at.size = sizeof at;
  step(physim_def_create(kShot, nullptr, &def));
  if (step.ok()) step(physim_set(def, "mass", "150 gr"));
  if (step.ok()) step(physim_fly(def, nullptr, nullptr, &made));
  if (step.ok()) step(physim_flight_at(made, PHYSIM_AT_RANGE, 50, &at));
  physim_free(made);
  physim_free(def);
  answer = at.speed;
  return step.code();
}

/// On the caller's thread alone, or on two.
physim_result batch_on(std::uint32_t threads, std::size_t count) {
  Steps step;
  physim_def* def = nullptr;
  physim_pool* pool = nullptr;
  static double speed[5000], x[5000];
  for (std::size_t i = 0; i < count; ++i) speed[i] = 90 + 1e-3 * static_cast<double>(i);
  physim_launches launches{};
  physim_ends ends{};
  launches.size = sizeof launches, launches.speed = speed;
  ends.size = sizeof ends, ends.x = x;
  step(physim_def_create(kShot, nullptr, &def));
  if (step.ok() && threads > 1) step(physim_pool_create(threads, &pool));
  if (step.ok()) step(physim_batch(def, nullptr, count, &launches, nullptr, &ends, pool, nullptr));
  physim_free(pool);
  physim_free(def);
  answer = x[count - 1];
  return step.code();
}

physim_result batch() { return batch_on(1, 40); }
physim_result threads() { return batch_on(2, 5000); }

physim_result world() {
  Steps step;
  physim_def* def = nullptr;
  physim_world* made = nullptr;
  physim_snapshot* moment = nullptr;
  physim_bytes* save = nullptr;
  physim_id emitter, balls[3];
  std::uint32_t kind = 0;
  std::uint64_t hash = 0;
  step(physim_def_create(kWorld, nullptr, &def));
  if (step.ok()) step(physim_world_create(def, PHYSIM_FIRE_NOTHING, &made));
  if (step.ok()) step(physim_world_add_kind(made, def, nullptr, 0, 0, &kind));
  if (step.ok()) step(physim_world_spawn(made, kind, 3, nullptr, balls, nullptr));
  if (step.ok()) step(physim_world_add_emitter(made, def, nullptr, nullptr, &emitter));
  if (step.ok()) step(physim_world_step(made, 30, 0));
  if (step.ok()) step(physim_world_snapshot(made, &moment));
  if (step.ok()) step(physim_world_step(made, 5, 0));
  if (step.ok()) step(physim_world_restore(made, moment));
  if (step.ok()) step(physim_save(made, &save));
  if (step.ok()) step(physim_world_hash(made, &hash));
  answer = static_cast<double>(hash);
  if (step.code() == PHYSIM_OUT_OF_MEMORY && made != nullptr) {
    const physim_result after = physim_world_step(made, 1, 0);
    if (after != PHYSIM_LOST && after != PHYSIM_OK) std::printf("after memory ran out: %s\n", physim_last_error());
  }
  physim_free(save);
  physim_free(moment);
  physim_free(made);
  physim_free(def);
  return step.code();
}

/// Whether a scene of calls ends with an error whenever one of its allocations fails; prints where it does not.
bool survives(const char* name, physim_result (*calls)()) {
  if (calls() != PHYSIM_OK)
    return std::printf("%s: %s\n", name, physim_last_error()), false;  // and what is kept is made
  if (calls() != PHYSIM_OK) return std::printf("%s: %s\n", name, physim_last_error()), false;
  const double right = answer;
  const long before = standing;
  long n = 0, wrong = 0;
  for (bool more = true; more; ++n) {
    failed = false;
    left = n;
    const physim_result code = calls();
    left = -1;
    more = failed;
    // Some can be done without, as the buffer of std::stable_sort(): then the answer is right.
    // A stream that toml++ reads a number by takes it for a bad number, which is refused.
    const bool good = code == PHYSIM_OK ? answer == right : failed.load();
    if (!good && wrong++ < 10) std::printf("%s: allocation %ld: code %d, %s\n", name, n, code, physim_last_error());
    if (standing != before && wrong++ < 10)
      std::printf("%s: allocation %ld: %ld are not given back\n", name, n, standing - before);
    if (standing != before) return false;
  }
  std::printf("%s: %ld allocations, each failed once: %ld wrong\n", name, n - 1, wrong);
  return wrong == 0 && n > 10;
}

}  // namespace

int main(int count, char** names) {
  struct Scene {
    const char* name;
    physim_result (*calls)();
  };
  bool good = true;
  for (const Scene& scene :
       {Scene{"flight", flight}, Scene{"batch", batch}, Scene{"threads", threads}, Scene{"world", world}})
    if (count < 2 || std::strcmp(names[1], scene.name) == 0) good = survives(scene.name, scene.calls) && good;
  return good ? 0 : 1;
}
