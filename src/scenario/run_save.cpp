// A run of a scenario's world as bytes: magic, format, content, and a check sum of it. The content begins with the
// version that wrote it.
#include <algorithm>
#include <cstring>

#include "base/archive.hpp"
#include "base/written_by.hpp"
#include "scenario/run_state.hpp"

namespace physim {
namespace {

constexpr char kMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'W', '\n'};
constexpr std::uint32_t kRunFormat = 6;
constexpr std::uint32_t kNamelessRunFormat = 5;  // the same without a version; it is read, too
constexpr std::size_t kHead = sizeof kMagic + sizeof kRunFormat;
constexpr std::size_t kSumBytes = 8;

std::uint64_t sum_of(std::span<const std::byte> content) {
  Hash hash;
  hash.add(content);
  return hash.value();
}

Error not_a_run(const std::string& message) { return {message, "save", "`physim run --save` makes them"}; }

/// Everything in it names a group that is there.
bool fits(const RunState& s) {
  const auto known = [&s](std::size_t group) { return group < s.groups.size(); };
  return std::ranges::all_of(s.magazines, [&](const Magazine& m) { return known(m.group); }) &&
         std::ranges::all_of(s.tracks, [&](const Track& t) { return t.generation == 0 || known(t.launched.group); }) &&
         std::ranges::all_of(s.events, [&](const RunEvent& e) { return known(e.launched.group); }) &&
         std::ranges::all_of(s.hits, [&](const WallHit& h) { return known(h.launched.group); }) &&
         std::ranges::all_of(s.thing_hits, [&](const ThingHit& h) { return known(h.launched.group); });
}

}  // namespace

std::vector<std::byte> saved_run(const RunState& state, std::uint64_t scenario, const std::vector<std::byte>& world) {
  const auto magic = std::as_bytes(std::span(kMagic));
  std::vector<std::byte> bytes(magic.begin(), magic.end());
  Writer writer(bytes);
  writer.write(kRunFormat, std::string(kVersion), scenario, state, world);
  PHYSIM_ASSERT(writer.good());
  writer.number(sum_of(std::span(bytes).subspan(kHead)), kSumBytes);
  return bytes;
}

Result<SavedRun> read_run(std::span<const std::byte> save) {
  if (save.size() < kHead + kSumBytes || std::memcmp(save.data(), kMagic, sizeof kMagic) != 0)
    return not_a_run("this is not the save of a run");
  std::uint64_t format = 0, sum = 0;
  Reader(save.subspan(sizeof kMagic)).number(format, sizeof kRunFormat);
  if (format != kRunFormat && format != kNamelessRunFormat)
    return of_other_format("save", "save", format, kRunFormat, version_at(save.subspan(kHead)));
  const auto content = save.subspan(kHead, save.size() - kHead - kSumBytes);
  Reader(save.last(kSumBytes)).number(sum, kSumBytes);
  if (sum != sum_of(content)) return not_a_run("the save is damaged, or was cut");
  SavedRun run;
  Reader reader(content);
  std::string made_by;
  if (format == kRunFormat) reader(made_by);
  reader(run.scenario, run.state, run.world);
  if (!reader.complete() || !fits(run.state))
    return not_a_run("what stands in the save makes no sense" + by_another_version(made_by));
  return run;
}

}  // namespace physim
