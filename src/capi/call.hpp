// Call: one call of the C interface. It finds what handles stand for, looks at arguments, keeps the first error, and
// lets no exception out.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/assert.hpp"
#include "base/memory_lack.hpp"
#include "physim/math.hpp"
#include "physim/physim.h"
#include "physim/result.hpp"

namespace physim::capi {

/// The object that a handle stands for, by the type of the handle.
template <class Handle>
struct Stands;
#define PHYSIM_STANDS(handle, object)        \
  template <>                                \
  struct Stands<handle> {                    \
    using Object = object;                   \
    static constexpr char kName[] = #handle; \
  };

struct Def;
struct WorldObject;
struct SceneObject;
struct FlightObject;
struct SnapshotObject;
struct Bytes;
struct Pool;
struct StudyObject;
struct PartObject;
struct FiguresObject;
PHYSIM_STANDS(physim_def, Def)
PHYSIM_STANDS(physim_flight, FlightObject)
PHYSIM_STANDS(physim_world, WorldObject)
PHYSIM_STANDS(physim_snapshot, SnapshotObject)
PHYSIM_STANDS(physim_scene, SceneObject)
PHYSIM_STANDS(physim_bytes, Bytes)
PHYSIM_STANDS(physim_pool, Pool)
PHYSIM_STANDS(physim_study, StudyObject)
PHYSIM_STANDS(physim_part, PartObject)
PHYSIM_STANDS(physim_figures, FiguresObject)
#undef PHYSIM_STANDS

// ----------------------------------------------------------------------------------------------------------- handles
/// An object with the name of its handle's type.
struct Kept {
  std::shared_ptr<void> object;
  const char* kind = nullptr;
};

/// Keeps an object; returns its handle: the number of a slot, and how often the slot was used.
[[nodiscard]] std::uintptr_t keep(Kept object);
/// What a handle stands for; nothing if it is null, freed or made up.
[[nodiscard]] Kept kept(std::uintptr_t handle);
/// Lets go of it; nothing if there was none.
[[nodiscard]] Kept forget(std::uintptr_t handle);

[[nodiscard]] inline std::uintptr_t number_of(const void* handle) { return std::bit_cast<std::uintptr_t>(handle); }

// -------------------------------------------------------------------------------------------------------------- calls
class Call {
 public:
  [[nodiscard]] bool ok() const { return code_ == PHYSIM_OK; }
  [[nodiscard]] physim_result code() const { return code_; }

  /// Keeps an error, if it is the first.
  void fail(physim_result code, std::string_view message, std::string_view place = {}, std::string_view hint = {});
  void fail(physim_result code, const Error& error) { fail(code, error.message, error.place, error.hint); }
  /// An exception came: what was being changed is lost.
  void threw(physim_result code, std::string_view message);

  /// Whether a result has a value; else its error is that of the call.
  template <class T>
  bool take(const Result<T>& result, physim_result code = PHYSIM_REFUSED) {
    if (!result) fail(code, result.error());
    return result.ok();
  }

  // ---- arguments
  void need(bool is_good, const char* name, const char* message) {
    if (!is_good) fail(PHYSIM_BAD_ARGUMENT, message, name);
  }
  void need(const void* pointer, const char* name) { need(pointer != nullptr, name, "is null"); }
  /// A column may be null if nothing is to be written to it.
  void need_rows(const void* rows, std::size_t count, const char* name) {
    need(count == 0 || rows != nullptr, name, "is null, and there are rows");
    need(count <= kMostRows, name, "has more rows than memory can hold");
  }
  template <class Struct>
  void need_struct(const Struct* pointer, const char* name) {
    need(pointer, name);
    if (pointer != nullptr)
      need(pointer->size >= 2 * sizeof(std::uint32_t) && pointer->size <= kLargestStruct, name,
           "its member size is not the sizeof of the struct");
  }
  /// A struct of the caller's, what it does not know of being zero; all zero if it is null.
  template <class Struct>
  [[nodiscard]] Struct read(const Struct* pointer, const char* name) {
    Struct own{};
    PHYSIM_ASSERT(name != nullptr);
    if (pointer == nullptr) return own;
    need_struct(pointer, name);
    if (ok()) std::memcpy(&own, pointer, std::min<std::size_t>(pointer->size, sizeof own));
    return own;
  }
  /// Writes what the caller knows of a struct; its size stays.
  template <class Struct>
  void write(Struct* into, Struct own) const {
    PHYSIM_ASSERT(into != nullptr && ok());
    PHYSIM_ASSERT(into->size >= sizeof own.size);
    own.size = into->size;
    std::memcpy(into, &own, std::min<std::size_t>(own.size, sizeof own));
  }
  void write_text(std::string_view text, char* into, std::size_t room, std::size_t* length);

  // ---- handles
  /// What a handle stands for; null after an error. A world that is changed is lost if an exception comes.
  template <class Handle>
  auto find(Handle* handle, const char* name) {
    using Type = std::remove_const_t<Handle>;
    using Object =
        std::conditional_t<std::is_const_v<Handle>, const typename Stands<Type>::Object, typename Stands<Type>::Object>;
    const Kept found = kept(number_of(handle));
    if (found.kind != Stands<Type>::kName) {
      fail_to_find(handle, found, name, Stands<Type>::kName);
      return std::shared_ptr<Object>();
    }
    auto object = std::static_pointer_cast<typename Stands<Type>::Object>(found.object);
    PHYSIM_ASSERT(object != nullptr);
    if constexpr (std::is_same_v<Type, physim_world>) look_at(object, !std::is_const_v<Handle>);
    return ok() ? std::shared_ptr<Object>(std::move(object)) : std::shared_ptr<Object>();
  }
  /// What a handle stands for that may be null, too.
  template <class Handle>
  auto find_or_null(Handle* handle, const char* name) {
    return handle != nullptr ? find(handle, name) : decltype(find(handle, name))();
  }
  template <class Handle>
  void give(Handle** into, std::shared_ptr<typename Stands<Handle>::Object> object) {
    PHYSIM_ASSERT(!ok() || (into != nullptr && object != nullptr));
    if (ok()) *into = std::bit_cast<Handle*>(keep({std::move(object), Stands<Handle>::kName}));
  }
  void fail_to_find(const void* handle, const Kept& found, const char* name, const char* wanted);
  void look_at(const std::shared_ptr<WorldObject>& world, bool changes);
  /// A world is lost if an exception comes from here on.
  void will_change(const std::shared_ptr<WorldObject>& world);

 private:
  static constexpr std::size_t kMostRows = std::size_t{1} << (sizeof(void*) == 8 ? 36 : 26);
  static constexpr std::size_t kLargestStruct = 1u << 16;

  physim_result code_ = PHYSIM_OK;
  std::shared_ptr<bool> lost_;  // of the world that is changed
};

/// Does the work of a call.
template <class Work>
physim_result guarded(const Work& work) noexcept {
  Call call;
  memory_lacked = false;
  try {
    work(call);
    if (memory_lacked) call.threw(PHYSIM_OUT_OF_MEMORY, "memory ran out for a projectile");
  } catch (const std::bad_alloc&) {
    call.threw(PHYSIM_OUT_OF_MEMORY, "memory ran out");
  } catch (const std::length_error&) {
    call.threw(PHYSIM_OUT_OF_MEMORY, "more was asked for than memory can hold");
  } catch (const std::exception& exception) {
    call.threw(PHYSIM_FAILED, exception.what());
  } catch (...) {
    call.threw(PHYSIM_FAILED, "an exception of an unknown type");
  }
  return call.code();
}

// --------------------------------------------------------------------------------------------- numbers in the memory
[[nodiscard]] inline Vec3d vector_at(const double* v) { return {v[0], v[1], v[2]}; }
inline void put(double* into, const Vec3d& v) { into[0] = v.x, into[1] = v.y, into[2] = v.z; }
inline void put(float* into, const Vec3d& v) {
  into[0] = static_cast<float>(v.x), into[1] = static_cast<float>(v.y), into[2] = static_cast<float>(v.z);
}
inline void put(double* into, const Quatd& q) { into[0] = q.w, into[1] = q.x, into[2] = q.y, into[3] = q.z; }
/// No rotation if all is zero.
[[nodiscard]] inline Quatd rotation_at(const double* q) {
  const Quatd given{q[0], q[1], q[2], q[3]};
  return given == Quatd{0, 0, 0, 0} ? Quatd{} : given;
}
[[nodiscard]] inline bool is_finite(const double* v, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}

/// A text of at most `size` - 1 bytes, cut between characters.
void put_text(char* into, std::size_t size, std::string_view text);

/// Structs of the library seen as those of the C interface, and back: equal member by member, vectors as three numbers.
template <class To, class From>
[[nodiscard]] To* same_memory(From* from) {
  static_assert(sizeof(From) % sizeof(To) == 0 || sizeof(To) % sizeof(From) == 0);
  return static_cast<To*>(static_cast<std::conditional_t<std::is_const_v<To>, const void, void>*>(from));
}

/// Ids of any kind.
template <class Id>
[[nodiscard]] physim_id put_id(const Id& id) {
  return {id.index, id.generation};
}
template <class Id>
[[nodiscard]] Id id_of(const physim_id& id) {
  return {id.index, id.generation};
}

/// Writes a row of an array whose elements have `each` bytes.
template <class Row>
void put_row(Row* rows, std::size_t each, std::size_t index, const Row& row) {
  PHYSIM_ASSERT(rows != nullptr && each > 0);
  void* const first = rows;
  std::memcpy(static_cast<std::byte*>(first) + index * each, &row, std::min(each, sizeof row));
}

}  // namespace physim::capi
