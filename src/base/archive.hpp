// Archives: values taken apart into whole numbers and put together again, structs member by member. So a recording is
// written (Writer) and read (Reader), and definitions are hashed (Hasher). A struct that gains a member changes what
// recordings hold: raise kRecordingFormat (include/physim/recording.hpp) with it.
//
// Format: little-endian; doubles as their bits; bool and enumerators 1 byte; texts and lists with their length in
// 4 bytes before them; optionals with a bool before them; variants with their index in 1 byte.
#pragma once

#include <bit>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "base/members.hpp"
#include "physim/forces.hpp"
#include "physim/names.hpp"
#include "physim/world_def.hpp"

namespace physim {

/// How many enumerators there are: archives refuse others.
template <class Enum>
std::size_t enumerators(Enum) {
  return names_of<Enum>().size();
}
inline std::size_t enumerators(Axes) { return static_cast<std::size_t>(Axes::all) + 1; }
inline std::size_t enumerators(GroundMode) { return static_cast<std::size_t>(GroundMode::bounce) + 1; }
inline std::size_t enumerators(Smoothing) { return static_cast<std::size_t>(Smoothing::extrapolate) + 1; }
inline std::size_t enumerators(WhenFull) { return static_cast<std::size_t>(WhenFull::replace_oldest) + 1; }

/// What all archives do alike. Self has: `number(bits, bytes, limit)`, which takes an unsigned number below a limit,
/// `count(n)` of a list, `text(string)`, `function(force)`, and whether it is reading.
template <class Self>
class Archive {
 public:
  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }

 private:
  Self& self() { return static_cast<Self&>(*this); }

  void bits(std::uint64_t& x, unsigned bytes, std::uint64_t limit = ~std::uint64_t{0}) {
    self().number(x, bytes, limit);
  }
  void take(double& x) {
    auto word = std::bit_cast<std::uint64_t>(x);
    bits(word, 8);
    if constexpr (Self::kReads) x = std::bit_cast<double>(word);
  }
  template <class T>
  requires std::integral<T> || std::is_enum_v<T>
  void take(T& x) {
    auto word = static_cast<std::uint64_t>(x);
    if constexpr (std::is_same_v<T, bool>)
      bits(word, 1, 2);
    else if constexpr (std::is_enum_v<T>)
      bits(word, 1, enumerators(x));
    else
      bits(word, sizeof(T));
    if constexpr (Self::kReads) x = static_cast<T>(word);  // what is written may be a constant
  }
  void take(std::string& text) { self().text(text); }
  void take(std::vector<std::byte>& bytes) {
    std::string text(static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size());
    self().text(text);
    if constexpr (!Self::kReads) return;
    const auto read = std::as_bytes(std::span(text));
    bytes.assign(read.begin(), read.end());
  }
  template <class T>
  void take(std::optional<T>& x) {
    bool there = x.has_value();
    take(there);
    if (!there) return x.reset();
    if (!x) x.emplace();
    take(*x);
  }
  template <class T>
  void take(std::vector<T>& list) {
    std::size_t n = list.size();
    self().count(n);
    if constexpr (Self::kReads) list.clear();
    // One by one, so that a list that claims to be longer than its file takes no memory.
    for (std::size_t i = 0; i < n && self().good(); ++i) {
      if constexpr (Self::kReads) list.emplace_back();
      take(list[i]);
    }
  }
  template <class T>
  void take(std::span<const T>& list) {
    static_assert(!Self::kReads, "a span has no memory to read into");
    std::size_t n = list.size();
    self().count(n);
    for (const T& item : list) take(const_cast<T&>(item));
  }
  template <class... T>
  void take(std::variant<T...>& v) {
    std::uint64_t index = v.index();  // of one that lost its value to an exception: beyond the limit
    bits(index, 1, sizeof...(T));
    if constexpr (Self::kReads) select(v, index, std::index_sequence_for<T...>());
    if (!v.valueless_by_exception()) std::visit([this](auto& x) { this->take(x); }, v);
  }
  template <class V, std::size_t... I>
  static void select(V& v, std::uint64_t index, std::index_sequence<I...>) {
    ((I == index ? static_cast<void>(v.template emplace<I>()) : void()), ...);
  }
  void take(CustomForce& force) { self().function(force); }
  /// It changes no result: who replays has another machine.
  void take(Threading&) {}
  template <class T>
  requires std::is_class_v<T>
  void take(T& x) {
    with_members(x, [this](auto&... members) { (this->take(members), ...); });
  }
};

/// Appends to bytes. What is no value of its type, such as a number that no enumerator has, makes it bad: it could not
/// be read again.
class Writer : public Archive<Writer> {
 public:
  static constexpr bool kReads = false;
  explicit Writer(std::vector<std::byte>& to) : to_(to) {}

  /// Writes values; it does not change them.
  template <class... T>
  void write(const T&... values) {
    (*this)(const_cast<T&>(values)...);
  }
  void number(std::uint64_t x, unsigned bytes, std::uint64_t limit = ~std::uint64_t{0}) {
    PHYSIM_ASSERT(bytes <= 8);
    good_ = good_ && (limit == ~std::uint64_t{0} || x < limit);
    std::byte piece[8];
    for (unsigned i = 0; i < 8; ++i) piece[i] = static_cast<std::byte>(x >> (8 * i));
    to_.insert(to_.end(), piece, piece + bytes);
  }
  void count(std::size_t n) { number(n, 4); }
  void text(const std::string& s) {
    count(s.size());
    const auto bytes = std::as_bytes(std::span(s));
    to_.insert(to_.end(), bytes.begin(), bytes.end());
  }
  void function(const CustomForce& force) { number(force.function ? 1 : 0, 1); }
  [[nodiscard]] bool good() const { return good_; }

 private:
  std::vector<std::byte>& to_;
  bool good_ = true;
};

/// Reads from bytes. What is not there, or is no value of its type, makes it bad; it reads zeros from then on.
class Reader : public Archive<Reader> {
 public:
  static constexpr bool kReads = true;
  /// `functions`: of custom forces, in the order in which they were recorded.
  explicit Reader(std::span<const std::byte> from, std::span<const CustomForce> functions = {})
      : from_(from), functions_(functions) {}

  void number(std::uint64_t& x, unsigned bytes, std::uint64_t limit = ~std::uint64_t{0}) {
    PHYSIM_ASSERT(bytes <= 8);
    x = 0;
    if (!good_ || from_.size() < bytes) return void(good_ = false);
    for (unsigned i = 0; i < bytes; ++i) x |= std::to_integer<std::uint64_t>(from_[i]) << (8 * i);
    from_ = from_.subspan(bytes);
    if (bytes == 8 || x < limit) return;
    x = 0;
    good_ = false;
  }
  void count(std::size_t& n) {
    std::uint64_t x = 0;
    number(x, 4);
    good_ = good_ && x <= from_.size();  // everything takes a byte or more
    n = good_ ? static_cast<std::size_t>(x) : 0;
  }
  void text(std::string& s) {
    std::size_t n = 0;
    count(n);
    PHYSIM_ASSERT(n <= from_.size());
    s.assign(static_cast<const char*>(static_cast<const void*>(from_.data())), n);
    from_ = from_.subspan(n);
  }
  void function(CustomForce& force) {
    std::uint64_t there = 0;
    number(there, 1, 2);
    force = there != 0 && functions_used_ < functions_.size() ? functions_[functions_used_] : CustomForce{};
    functions_used_ += there;
  }
  [[nodiscard]] bool good() const { return good_; }
  /// All was read, and nothing is left over.
  [[nodiscard]] bool complete() const { return good_ && from_.empty(); }
  [[nodiscard]] std::size_t functions_used() const { return functions_used_; }

 private:
  std::span<const std::byte> from_;
  std::span<const CustomForce> functions_;
  std::size_t functions_used_ = 0;
  bool good_ = true;
};

/// Hashes what it is given.
class Hasher : public Archive<Hasher> {
 public:
  static constexpr bool kReads = false;
  template <class... T>
  void add(const T&... values) {
    (*this)(const_cast<T&>(values)...);
  }
  void number(std::uint64_t x, unsigned, std::uint64_t = 0) { hash_.add(x); }
  void count(std::size_t n) { hash_.add(std::uint64_t{n}); }
  void text(const std::string& s) { hash_.add(std::as_bytes(std::span(s))); }
  void function(const CustomForce& force) { hash_.add(std::uint64_t{force.function ? 1u : 0u}); }
  [[nodiscard]] static bool good() { return true; }
  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  Hash hash_;
};

template <class... T>
[[nodiscard]] std::uint64_t hash_of(const T&... values) {
  Hasher hasher;
  hasher.add(values...);
  return hasher.value();
}

}  // namespace physim
