#include "capi/call.hpp"

#include <algorithm>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include "capi/objects.hpp"

namespace physim::capi {
namespace {

// ------------------------------------------------------------------------------------------------------------ handles
constexpr unsigned kIndexBits = sizeof(void*) == 8 ? 24 : 16;
constexpr std::uintptr_t kIndexMask = (std::uintptr_t{1} << kIndexBits) - 1;
constexpr std::uintptr_t kLastUse = ~std::uintptr_t{0} >> kIndexBits;

/// Slots of objects. One whose uses are all spent is left aside, so that no handle comes again.
class Table {
 public:
  std::uintptr_t add(Kept object) {
    const std::unique_lock lock(mutex_);
    if (free_.empty()) {
      if (slots_.size() == kIndexMask) throw std::bad_alloc();
      free_.reserve(slots_.size() + 1);  // so that giving back never allocates
      slots_.emplace_back();
      free_.push_back(slots_.size() - 1);
    }
    const std::size_t index = free_.back();
    free_.pop_back();
    PHYSIM_ASSERT(index < slots_.size());
    Slot& slot = slots_[index];
    PHYSIM_ASSERT(slot.kept.object == nullptr);
    slot.kept = std::move(object);
    return slot.use << kIndexBits | (index + 1);
  }
  Kept find(std::uintptr_t handle) const {
    const std::shared_lock lock(mutex_);
    const Slot* slot = slot_of(handle);
    return slot != nullptr ? slot->kept : Kept{};
  }
  Kept remove(std::uintptr_t handle) {
    const std::unique_lock lock(mutex_);
    Slot* slot = const_cast<Slot*>(slot_of(handle));  // of this table
    if (slot == nullptr) return {};
    Kept kept = std::exchange(slot->kept, {});
    PHYSIM_ASSERT(free_.size() < free_.capacity());  // giving back does not allocate
    if (slot->use++ < kLastUse) free_.push_back(static_cast<std::size_t>(slot - slots_.data()));
    return kept;
  }

 private:
  struct Slot {
    Kept kept;
    std::uintptr_t use = 1;
  };
  [[nodiscard]] const Slot* slot_of(std::uintptr_t handle) const {
    const std::size_t index = handle & kIndexMask;
    if (index == 0 || index > slots_.size()) return nullptr;
    const Slot& slot = slots_[index - 1];
    return slot.kept.object != nullptr && slot.use == handle >> kIndexBits ? &slot : nullptr;
  }

  mutable std::shared_mutex mutex_;
  std::vector<Slot> slots_;
  std::vector<std::size_t> free_;
};

/// It is never destroyed: other threads, and objects of other libraries, may call while the program ends.
Table& table() {
  static Table& all = *new Table;
  return all;
}

// ------------------------------------------------------------------------------------------------------------- errors
struct LastError {
  char text[1024];
  char place[512];
  char hint[512];
};
thread_local constinit LastError last_error{};

constexpr char kGone[] = "is no handle: it was freed, or none was ever made";

}  // namespace

std::uintptr_t keep(Kept object) {
  PHYSIM_ASSERT(object.object != nullptr && object.kind != nullptr);
  return table().add(std::move(object));
}
Kept kept(std::uintptr_t handle) { return table().find(handle); }
Kept forget(std::uintptr_t handle) { return table().remove(handle); }

void put_text(char* into, std::size_t size, std::string_view text) {
  PHYSIM_ASSERT(size > 0);
  std::size_t length = std::min(text.size(), size - 1);
  if (length < text.size())
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;  // inside a character
  std::copy_n(text.data(), length, into);
  PHYSIM_ASSERT(length < size);
  into[length] = '\0';
}

void Call::fail(physim_result code, std::string_view message, std::string_view place, std::string_view hint) {
  PHYSIM_ASSERT(code != PHYSIM_OK);
  if (!ok()) return;
  code_ = code;
  put_text(last_error.place, sizeof last_error.place, place);
  put_text(last_error.hint, sizeof last_error.hint, hint);
  std::size_t used = 0;
  const auto append = [&used](std::string_view text) {
    put_text(last_error.text + used, sizeof last_error.text - used, text);
    used += std::strlen(last_error.text + used);
  };
  append(place);
  append(place.empty() ? "error: " : ": error: ");
  append(message);
  append(hint.empty() ? "" : "; ");
  append(hint);
}

void Call::threw(physim_result code, std::string_view message) {
  if (lost_ != nullptr) *lost_ = true;
  code_ = PHYSIM_OK;
  fail(code, message);
}

void Call::fail_to_find(const void* handle, const Kept& found, const char* name, const char* wanted) {
  const char* const message = handle == nullptr ? "is null" : found.kind == nullptr ? kGone : "is of another kind";
  PHYSIM_ASSERT(found.kind != wanted);
  fail(PHYSIM_BAD_HANDLE, message, name, found.kind == nullptr ? "" : wanted);
}

void Call::will_change(const std::shared_ptr<WorldObject>& world) {
  lost_ = std::shared_ptr<bool>(world, &world->lost);
}

void Call::look_at(const std::shared_ptr<WorldObject>& world, bool changes) {
  PHYSIM_ASSERT(world != nullptr);
  if (world->lost) return fail(PHYSIM_LOST, "memory ran out while this world was being changed", "world", "free it");
  if (changes && world->replay)
    return fail(PHYSIM_REFUSED, "a recording moves this world", "world",
                "physim_replay_next() and physim_replay_seek() do");
  if (changes) will_change(world);
}

void Call::write_text(std::string_view text, char* into, std::size_t room, std::size_t* length) {
  if (length != nullptr) *length = text.size();
  if (into != nullptr && room > 0) put_text(into, room, text);
  if (into != nullptr && text.size() >= room) fail(PHYSIM_TOO_SMALL, "the text does not fit", "into", "look at length");
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

const char* physim_version(void) { return kVersion; }
const char* physim_last_error(void) { return last_error.text; }
const char* physim_last_place(void) { return last_error.place; }
const char* physim_last_hint(void) { return last_error.hint; }

physim_result physim_free(const void* handle) {
  return guarded([&](Call& call) {
    if (handle == nullptr) return;
    const Kept gone = forget(number_of(handle));
    if (gone.object == nullptr) call.fail(PHYSIM_BAD_HANDLE, kGone, "handle");
  });
}
