// Archives: values taken apart into whole numbers and put together again, structs member by member. So a recording is
// written (Writer) and read (Reader), and definitions are hashed (Hasher). A struct that gains a member changes what
// recordings hold: raise kRecordingFormat (include/physim/world.hpp) with it.
//
// Format: little-endian; doubles as their bits; bool and enumerators 1 byte; texts and lists with their length in
// 4 bytes before them; optionals with a bool before them; variants with their index in 1 byte.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "base/members.hpp"
#include "physim/names.hpp"
#include "physim/world.hpp"

namespace physim {

/// How many enumerators there are: archives refuse others.
template <class Enum>
std::size_t enumerators(Enum) {
  return names_of<Enum>().size();
}
inline std::size_t enumerators(Axes) { return static_cast<std::size_t>(Axes::all) + 1; }
inline std::size_t enumerators(GroundMode) { return static_cast<std::size_t>(GroundMode::bounce) + 1; }
inline std::size_t enumerators(OnHit) { return static_cast<std::size_t>(OnHit::ask) + 1; }
inline std::size_t enumerators(Smoothing) { return static_cast<std::size_t>(Smoothing::extrapolate) + 1; }
inline std::size_t enumerators(WhenFull) { return static_cast<std::size_t>(WhenFull::replace_oldest) + 1; }

inline constexpr std::uint64_t kMostFields = 1u << 14;  // functions of environments in an archive

/// How many functions of one's own there are, of each kind.
struct FunctionCounts {
  std::size_t custom_forces = 0;
  std::size_t wind_fields = 0;
  std::size_t force_fields = 0;
  std::size_t engine_queries = 0;
  bool hit_function = false;  // some kind asks

  FunctionCounts& operator+=(const FunctionCounts& more) {
    custom_forces += more.custom_forces;
    wind_fields += more.wind_fields;
    force_fields += more.force_fields;
    engine_queries += more.engine_queries;
    hit_function = hit_function || more.hit_function;
    return *this;
  }
  bool operator==(const FunctionCounts&) const = default;
};

/// How surfaces act on what touches them: scenes were saved without it, and are still where all of it is default.
template <class T>
concept OfSurfaces = std::same_as<T, CombineDef> || std::same_as<T, ConveyorDef> || std::same_as<T, PassageDef>;

/// What all archives do alike. Self has: `number(bits, bytes, limit)`, which takes an unsigned number below a limit,
/// `count(n)` of a list, `text(string)`, `function(one's own)`, and whether it is reading.
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
  template <class T>
  requires std::is_empty_v<T>
  void take(T&) {}
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
  template <class Batch>
  void take(FieldFunction<Batch>& field) {
    self().function(field);
  }
  void take(Scene& scene) { self().scene(scene); }
  void take(SharedShape& shape) { self().shape(shape); }
  /// Lent for a call: nothing that holds one is kept.
  void take(const Scene*&) {}
  /// It changes no result: a replay may run on another machine.
  void take(Threading&) {}
  template <class T>
  requires(std::is_class_v<T> && !std::is_empty_v<T>) void take(T& x) {
    if constexpr (requires { self().says_nothing(x); })
      if (self().says_nothing(x)) return;
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
  void scene(const Scene& scene) {
    std::vector<std::byte> save = scene.save();
    (*this)(save);
  }
  /// Its number among those written before, each of which follows its number once; 0 means null.
  void shape(const SharedShape& shape) {
    const auto at = std::find(shapes_.begin(), shapes_.end(), shape);
    count(shape ? static_cast<std::size_t>(at - shapes_.begin()) + 1 : 0);
    if (!shape || at != shapes_.end()) return;
    shapes_.push_back(shape);
    std::vector<std::byte> save = shape.save();
    (*this)(save);
  }
  /// What follows has defaults alone for how surfaces act, and is written without them.
  void leave_out_surfaces() { without_surfaces_ = true; }
  template <OfSurfaces T>
  [[nodiscard]] bool says_nothing(const T& def) const {
    PHYSIM_ASSERT(!without_surfaces_ || def == T{});
    return without_surfaces_;
  }
  void function(const CustomForce& force) { number(force.function ? 1 : 0, 1); }
  /// Its number among those written before, each counted once; 0 means null.
  template <class Batch>
  void function(const FieldFunction<Batch>& field) {
    auto& known = std::get<std::vector<FieldFunction<Batch>>>(fields_);
    const auto at = std::find(known.begin(), known.end(), field);
    const auto place = static_cast<std::uint64_t>(at - known.begin());
    if (field && at == known.end()) known.push_back(field);
    number(field ? place + 1 : 0, 2, kMostFields);
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  std::vector<std::byte>& to_;
  std::tuple<std::vector<WindFunction>, std::vector<ForceFunction>> fields_;
  std::vector<SharedShape> shapes_;
  bool good_ = true;
  bool without_surfaces_ = false;
};

/// Reads from bytes. What is not there, or is no value of its type, makes it bad; it reads zeros from then on.
class Reader : public Archive<Reader> {
 public:
  static constexpr bool kReads = true;
  explicit Reader(std::span<const std::byte> from) : from_(from) {}
  /// Functions are those of `options`, behind those of `before`, which others have used.
  Reader(std::span<const std::byte> from, const LoadOptions& options, const FunctionCounts& before = {})
      : from_(from), options_(&options), before_(before) {}

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
  void scene(Scene& scene) {
    std::vector<std::byte> save;
    (*this)(save);
    EngineQuery query = given(&LoadOptions::engine_queries, before_.engine_queries + used_.engine_queries);
    if (!query) query = [](const EngineBatch&) {};  // a reader that only counts has none; a world needs one
    auto loaded = Scene::load(save, query);
    good_ = good_ && loaded;
    if (!good_) return;
    scene = std::move(*loaded);
    if (scene.engine()) ++used_.engine_queries;
  }
  void shape(SharedShape& shape) {
    std::uint64_t place = 0;
    number(place, 4, std::uint64_t{shapes_.size()} + 2);
    shape = {};
    if (place == 0 || !good_) return;
    if (place > shapes_.size()) {
      std::vector<std::byte> save;
      (*this)(save);
      auto loaded = SharedShape::load(save);
      good_ = good_ && loaded;
      if (!good_) return;
      shapes_.push_back(std::move(*loaded));
    }
    shape = shapes_[static_cast<std::size_t>(place) - 1];
  }
  void function(CustomForce& force) {
    std::uint64_t there = 0;
    number(there, 1, 2);
    if (there == 0) return void(force = {});
    force = given(&LoadOptions::custom_forces, before_.custom_forces + used_.custom_forces);
    ++used_.custom_forces;
  }
  void function(WindFunction& wind) { field(wind, &LoadOptions::wind_fields, &FunctionCounts::wind_fields); }
  void function(ForceFunction& force) { field(force, &LoadOptions::force_fields, &FunctionCounts::force_fields); }
  /// What follows was written without how surfaces act: that is left as it is.
  void leave_out_surfaces() { without_surfaces_ = true; }
  template <OfSurfaces T>
  [[nodiscard]] bool says_nothing(const T&) const {
    return without_surfaces_;
  }
  [[nodiscard]] bool good() const { return good_; }
  /// All was read, and nothing is left over.
  [[nodiscard]] bool complete() const { return good_ && from_.empty(); }
  [[nodiscard]] const FunctionCounts& functions_used() const { return used_; }

 private:
  template <class F>
  [[nodiscard]] F given(std::vector<F> LoadOptions::*list, std::size_t place) const {
    return options_ && place < (options_->*list).size() ? (options_->*list)[place] : F{};
  }
  template <class F>
  void field(F& field, std::vector<F> LoadOptions::*list, std::size_t FunctionCounts::*count) {
    std::uint64_t place = 0;
    number(place, 2, kMostFields);
    field = place == 0 ? F{} : given(list, before_.*count + static_cast<std::size_t>(place) - 1);
    used_.*count = std::max(used_.*count, static_cast<std::size_t>(place));
  }

  std::span<const std::byte> from_;
  const LoadOptions* options_ = nullptr;
  FunctionCounts before_;
  FunctionCounts used_;
  std::vector<SharedShape> shapes_;
  bool good_ = true;
  bool without_surfaces_ = false;
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
  void scene(const Scene& scene) { hash_.add(scene.hash()); }
  void shape(const SharedShape& shape) { hash_.add(shape.hash()); }
  /// With default contact settings, hashes are those from before there were scenes.
  [[nodiscard]] static bool says_nothing(const CollisionDef& collision) { return collision == CollisionDef{}; }
  [[nodiscard]] static bool says_nothing(const ContactDef& contact) { return contact == ContactDef{}; }
  template <OfSurfaces T>
  [[nodiscard]] static bool says_nothing(const T& def) {
    return def == T{};
  }
  [[nodiscard]] static bool says_nothing(const EmitSurface& surface) { return surface == EmitSurface{}; }
  [[nodiscard]] static bool says_nothing(const RainDef& rain) { return rain == RainDef{}; }
  [[nodiscard]] static bool says_nothing(const TrailDef& trail) { return trail == TrailDef{}; }
  void function(const CustomForce& force) { hash_.add(std::uint64_t{force.function ? 1u : 0u}); }
  template <class Batch>
  void function(const FieldFunction<Batch>& field) {
    if (field) hash_.add(std::uint64_t{1});  // hashes without any are what they were before there were some
  }
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
