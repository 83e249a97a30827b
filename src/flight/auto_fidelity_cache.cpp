// AutoFidelityCache: answers of cheapest_within() by everything that they depend on, and the classes of launches.
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <unordered_map>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "physim/solve.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"

namespace physim {
namespace {

// ------------------------------------------------------------------------------------------------------------ the key
/// Everything that an answer depends on, as bytes.
std::string key_of(ProjectileDef projectile, const std::vector<Launch>& corners, Environment environment,
                   const Purpose& purpose) {
  // Names and longitude change nothing, and the projectile's own fidelity is not asked.
  projectile.name.clear();
  projectile.motor.name.clear();
  projectile.fidelity = {};
  environment.earth.longitude = 0;
  std::vector<std::byte> bytes;
  Writer writer(bytes);
  writer.write(projectile, corners, environment, purpose);
  for (const void* function :
       {static_cast<const void*>(environment.wind.field.get()), static_cast<const void*>(environment.force.get())})
    writer.number(std::bit_cast<std::uintptr_t>(function), sizeof(function));
  return {static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size()};
}

// -------------------------------------------------------------------------------------------------- classes of launch
struct Bin {
  double low, high;
};
std::vector<double> ends(const Bin& bin) {
  return bin.low == bin.high ? std::vector{bin.low} : std::vector{bin.low, bin.high};
}

/// The part of the error that corners and middle of a class must keep: some launch between them errs by more.
constexpr double kMargin = 0.9;

double middle(const Bin& bin) { return 0.5 * (bin.low + bin.high); }

/// Eight bins between a speed and twice that speed.
Bin speed_bin(double speed) {
  constexpr double kCreeping = 1e-3;  // [m/s]
  if (speed == 0) return {0, 0};
  if (speed < kCreeping) return {0, kCreeping};
  constexpr std::uint64_t kWidth = std::uint64_t{1} << 49;  // the first three binary digits behind the point are kept
  const std::uint64_t low = to_bits(speed) & ~(kWidth - 1);
  const Bin bin{from_bits<double>(low), from_bits<double>(low + kWidth)};
  PHYSIM_ASSERT(bin.low <= speed && speed < bin.high);
  return bin;
}

constexpr double kAngle = 1.0 / 16;  // [rad]
Bin angle_bin(double angle) {
  const double low = std::floor(angle / kAngle) * kAngle;
  return {low, low + kAngle};
}
double rounded(double x, double unit) { return std::round(x / unit) * unit + 0.0; }  // never -0

/// Heights above the ground decide how long a flight lasts: between a power of two and the next. Without a ground they
/// only change the air.
Bin height_bin(double height, std::optional<double> ground) {
  constexpr double kUp = 128, kLow = 0.5;  // [m]
  if (!ground) {
    const double low = std::floor(height / kUp) * kUp;
    return {low, low + kUp};
  }
  if (height <= *ground) return {*ground, *ground};
  double above = kLow;
  while (above < height - *ground) above *= 2;
  return {*ground + (above > kLow ? above / 2 : 0), *ground + above};
}

/// A velocity as speed, elevation and azimuth. The sight then moves nothing.
Launch by_angles(const Launch& launch) {
  if (!launch.velocity) return launch;
  const Vec3d v = *launch.velocity;
  Launch turned;
  turned.position = launch.position;
  turned.speed = length(v);
  turned.elevation = turned.speed == 0 ? 0 : atan2(v.y, length(Vec3d{v.x, 0, v.z}));
  turned.azimuth = turned.speed == 0 ? 0 : atan2(v.z, v.x);
  return turned;
}

}  // namespace

std::vector<Launch> launch_class(const Launch& launch, std::optional<double> ground) {
  const IeeeMode mode;
  if (!check(launch)) return {launch};  // flying it says what is wrong
  Launch corner = by_angles(launch);
  if (!std::isfinite(corner.speed)) return {launch};
  const Bin speed = speed_bin(corner.speed), height = height_bin(corner.position.y, ground);
  Bin elevation = angle_bin(corner.elevation);
  if (corner.sight.zero_range > 0) elevation = {0, 0};  // the zero finds it
  constexpr double kAcross = 1024;  // air, wind and the rounding of floats change slowly with the place [m]
  corner.azimuth = rounded(corner.azimuth, kAngle);
  corner.position.x = rounded(corner.position.x, kAcross);
  corner.position.z = rounded(corner.position.z, kAcross);
  std::vector<Launch> launches;
  const auto add = [&](double s, double e, double y) {
    corner.speed = s;
    corner.elevation = e;
    corner.position.y = y;
    launches.push_back(corner);
  };
  for (const double s : ends(speed))
    for (const double e : ends(elevation))
      for (const double y : ends(height)) add(s, e, y);
  if (launches.size() > 1) add(middle(speed), middle(elevation), middle(height));
  return launches;
}

struct AutoFidelityCache::Impl {
  /// Computed once, by the first caller; others of the same key wait for it, those of other keys do not.
  struct Slot {
    std::once_flag once;
    std::optional<Answer> answer;
    WindFunction wind;  // kept, so that no other function comes to lie where one of the key lay
    ForceFunction force;
    std::uint64_t last_asked = 0;
  };

  std::shared_ptr<Slot> slot(const std::string& key, const Environment& environment) {
    const std::lock_guard lock(mutex);
    std::shared_ptr<Slot>& found = slots[key];
    if (!found) found = std::make_shared<Slot>();
    found->wind = environment.wind.field;
    found->force = environment.force;
    found->last_asked = ++asked;
    const std::shared_ptr<Slot> kept = found;
    while (slots.size() > capacity) {
      auto oldest = slots.begin();
      for (auto it = slots.begin(); it != slots.end(); ++it)
        if (it->second->last_asked < oldest->second->last_asked) oldest = it;
      PHYSIM_ASSERT(oldest->second != kept);
      slots.erase(oldest);
    }
    return kept;
  }

  mutable std::mutex mutex;
  std::unordered_map<std::string, std::shared_ptr<Slot>> slots;
  std::size_t capacity = 0;
  std::uint64_t asked = 0;
  std::uint64_t computed = 0;
};

AutoFidelityCache::AutoFidelityCache(std::size_t capacity) : impl_(std::make_unique<Impl>()) {
  impl_->capacity = capacity > 0 ? capacity : 1;
}
AutoFidelityCache::~AutoFidelityCache() = default;
AutoFidelityCache::AutoFidelityCache(AutoFidelityCache&&) noexcept = default;
AutoFidelityCache& AutoFidelityCache::operator=(AutoFidelityCache&&) noexcept = default;

AutoFidelityCache::Answer AutoFidelityCache::cheapest_within(const ProjectileDef& projectile, const Launch& launch,
                                                             const Environment& environment, const Purpose& purpose) {
  const IeeeMode mode;
  // What a caller's function does near a launch is unknown.
  const auto corners = has_functions(environment) ? std::vector<Launch>{launch} : launch_class(launch, purpose.ground);
  const std::shared_ptr<Impl::Slot> slot = impl_->slot(key_of(projectile, corners, environment, purpose), environment);
  std::call_once(slot->once, [&] {
    Purpose stricter = purpose;
    stricter.error *= kMargin;
    auto found = physim::cheapest_within(projectile, corners, environment, stricter);
    if (found) found->purpose = purpose;
    if (found)
      slot->answer.emplace(std::make_shared<const AutoFidelity>(std::move(*found)));
    else
      slot->answer.emplace(found.error());
    const std::lock_guard lock(impl_->mutex);
    ++impl_->computed;
  });
  PHYSIM_ASSERT(slot->answer.has_value());
  return *slot->answer;
}

std::size_t AutoFidelityCache::size() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->slots.size();
}

std::uint64_t AutoFidelityCache::computed() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->computed;
}

void AutoFidelityCache::clear() {
  const std::lock_guard lock(impl_->mutex);
  impl_->slots.clear();
}

}  // namespace physim
