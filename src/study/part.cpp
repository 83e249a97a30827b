#include "study/part.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "base/written_by.hpp"
#include "study/estimates.hpp"
#include "study/shard.hpp"

namespace physim {
namespace {

using Node = StudyPartRecord::Node;

std::string shards_text(std::uint64_t first, std::uint64_t count) {
  if (count == 1) return "shard " + std::to_string(first);
  return "shards " + std::to_string(first) + " to " + std::to_string(first + count - 1);
}

/// A node in its saved form.
struct SavedNode {
  std::uint64_t first = 0, count = 0;
  CommonSums sums;
};
struct SavedPart {
  std::string what;
  std::uint32_t format = 0;
  std::string made_by;  // version of the library
  std::uint64_t hash = 0;
  std::vector<SavedNode> nodes;
};
constexpr const char* kWhat = "physim study part";

Error not_a_part(const char* why) {
  return {std::string("these bytes are no part of a study: ") + why, "part",
          "take another copy of it, or fly it again"};
}

// Joining relies on the shapes that shards of one study have. A part is read from a file, which anyone may have
// written.
bool fits(const CountedCells& cells, const CountedCells& first) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 15;  // beyond all that is counted
  return cells.centre == first.centre && cells.scale == first.scale && cells.first > -kFarthest &&
         cells.first < kFarthest && cells.counts.size() < std::size_t{2 * kFarthest};
}
bool fits(const SampleMoments& moments, std::size_t size) {
  return moments.products.size() == moments.size() * (moments.size() + 1) / 2 &&
         (moments.count == 0 || moments.size() == size);
}
bool fits(const DistanceSums& sums, const DistanceSums& first) {
  return fits(sums.cells, first.cells) && fits(sums.moments, 1);
}
/// Two lists are as long, or one of them is not there.
template <class T>
bool sized(const std::vector<T>& a, const std::vector<T>& b) {
  return a.empty() || b.empty() || a.size() == b.size();
}
bool fits(const IndexSums& sums, const IndexSums& first) {
  return sized(sums.counts, first.counts) && sized(sums.first, first.first) && sized(sums.total, first.total);
}
bool fits(const CommonSums& sums, const CommonSums& first) {
  const auto each = [](const auto& a, const auto& b) { return fits(a, b); };
  const auto of_replicate = [&](const Replicate& part, const Replicate& of_first) {
    return fits(part.moments, sums.cells.size()) && sized(part.hits, first.hits) &&
           fits(part.indices, of_first.indices);
  };
  return sums.replicates.size() == kReplicates && sized(sums.hits, first.hits) && sums.worst.size() <= kWorstShots &&
         std::ranges::equal(sums.cells, first.cells, each) && std::ranges::equal(sums.spreads, first.spreads, each) &&
         std::ranges::equal(sums.replicates, first.replicates, of_replicate) && fits(sums.moments, sums.cells.size()) &&
         fits(sums.from_aim, first.from_aim) && fits(sums.from_centre, first.from_centre) &&
         fits(sums.in_space, first.in_space);
}

bool fits(const std::vector<PartSums>& sums, const std::vector<PartSums>& first) {
  bool sound = sums.size() == first.size() && sums.size() == kReplicates;
  const PartSums* some = nullptr;  // a replicate that has shots
  for (const auto* list : {&first, &sums})
    for (const PartSums& part : *list) {
      if (!some && !part.shots.empty()) some = &part;
      sound = sound && (!some || (sized(part.shots, some->shots) && sized(part.hits, some->hits)));
    }
  return sound;
}

bool fits(const std::vector<ReplicateDistances>& sums, std::size_t spreads) {
  return std::ranges::all_of(sums, [&](const ReplicateDistances& of) {
    return fits(of.from_aim, 1) && fits(of.from_centre, 1) && fits(of.in_space, 1) &&
           (of.spreads.empty() || of.spreads.size() == spreads) &&
           std::ranges::all_of(of.spreads, [](const SampleMoments& moments) { return fits(moments, 1); });
  });
}

/// What sums have besides the common ones.
struct MoreSums {
  std::vector<PartSums> over_inputs;
  std::vector<ReplicateDistances> distances;

  [[nodiscard]] bool empty() const { return over_inputs.empty() && distances.empty(); }
};
struct SavedPlace {
  CommonSums sums;
  MoreSums more;
};
/// What a node has besides the common sums, in its saved form.
struct SavedMore {
  MoreSums own;
  std::vector<SavedPlace> places;

  [[nodiscard]] bool empty() const { return own.empty() && places.empty(); }
};

bool fits(const MoreSums& sums, const MoreSums& first, const CommonSums& common) {
  const bool over_inputs =
      first.over_inputs.empty() ? sums.over_inputs.empty() : fits(sums.over_inputs, first.over_inputs);
  const std::size_t replicates = first.distances.empty() ? 0 : kReplicates;
  return over_inputs && sums.distances.size() == replicates && fits(sums.distances, common.spreads.size());
}
bool fits(const SavedMore& more, const SavedMore& first, const CommonSums& common) {
  bool sound = fits(more.own, first.own, common) && more.places.size() == first.places.size();
  for (std::size_t i = 0; sound && i < first.places.size(); ++i)
    sound = fits(more.places[i].sums, first.places[i].sums) &&
            fits(more.places[i].more, first.places[i].more, first.places[i].sums);
  return sound;
}

SavedMore more_of(const ShardSums& sums) {
  SavedMore more{{sums.over_inputs, sums.distances}, {}};
  for (const ShardSums& place : sums.places) more.places.push_back({place, {place.over_inputs, place.distances}});
  return more;
}

ShardSums sums_of(const CommonSums& common, const MoreSums& more) {
  return {common, more.over_inputs, more.distances, {}};
}
ShardSums sums_of(const CommonSums& common, const SavedMore& more) {
  ShardSums sums = sums_of(common, more.own);
  for (const SavedPlace& place : more.places) sums.places.push_back(sums_of(place.sums, place.more));
  return sums;
}

/// Reads the head and checks the sum. A part of another version is refused: what it flew may differ in last digits.
Status read_head(std::span<const std::byte> bytes, Reader& reader, SavedPart& saved) {
  reader(saved.what, saved.format);
  if (!reader.good() || saved.what != kWhat) return not_a_part("they begin otherwise");
  const std::size_t head = sizeof(std::uint32_t) + saved.what.size() + sizeof saved.format;
  const std::string version = version_at(bytes.subspan(head));
  if (saved.format != kStudyFormat) return of_other_format("part", "part", saved.format, kStudyFormat, version);
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof sum) return not_a_part("they end too early");
  const auto content = bytes.first(bytes.size() - sizeof sum);
  Reader(bytes.last(sizeof sum)).number(sum, sizeof sum);
  if (sum != hash_of(std::vector<std::byte>(content.begin(), content.end()))) return not_a_part("they are damaged");
  reader(saved.made_by);
  if (saved.made_by == kVersion) return {};
  return Error{"the part is" + (version.empty() ? " of another version" : " of PhySim " + version) +
                   ", and this is PhySim " + kVersion,
               "part", "join it with the version that flew it, or fly it again"};
}

}  // namespace

bool StudyPartRecord::has(std::uint64_t shard) const {
  const auto after = nodes.upper_bound(shard);
  if (after == nodes.begin()) return false;
  const auto& [first, node] = *std::prev(after);
  return shard - first < node.count;
}

std::uint64_t StudyPartRecord::missing_from(std::uint64_t shard) const {
  auto at = nodes.upper_bound(shard);
  if (at != nodes.begin()) --at;
  for (; at != nodes.end() && at->first <= shard; ++at) shard = std::max(shard, at->first + at->second.count);
  return shard;
}

void StudyPartRecord::add(std::uint64_t first, Node node) {
  PHYSIM_ASSERT(std::has_single_bit(node.count) && first % node.count == 0 && !has(first));
  for (;;) {
    const std::uint64_t other = first ^ node.count;
    const auto sibling = nodes.find(other);
    if (sibling == nodes.end() || sibling->second.count != node.count) break;
    auto sums = std::make_shared<ShardSums>(other < first ? *sibling->second.sums : *node.sums);
    join(*sums, other < first ? *node.sums : *sibling->second.sums);
    nodes.erase(sibling);
    first &= ~node.count;
    node = {2 * node.count, std::move(sums)};
  }
  nodes.emplace(first, std::move(node));
}

std::map<std::uint64_t, StudyPartRecord::Node>::const_iterator StudyPartRecord::first_in(std::uint64_t first,
                                                                                         std::uint64_t count) const {
  auto at = nodes.upper_bound(first);
  if (at != nodes.begin() && std::prev(at)->second.count > first - std::prev(at)->first) --at;
  return at != nodes.end() && (at->first <= first || at->first - first < count) ? at : nodes.end();
}

Error StudyPartRecord::missing_of(std::uint64_t n) const {
  constexpr int kMostRuns = 20;
  std::string text;
  std::uint64_t at = missing_from(0);
  for (int run = 0; at < n; ++run) {
    const auto next = nodes.upper_bound(at);
    const std::uint64_t end = next == nodes.end() ? n : std::min(next->first, n);
    if (run == kMostRuns) {
      text += " and more";
      break;
    }
    text += (text.empty() ? "" : ", ") + shards_text(at, end - at);
    at = missing_from(end);
  }
  return {text + " of " + std::to_string(n) + " are missing", "part", "fly them, or join the part that has them"};
}

Result<std::shared_ptr<const ShardSums>> StudyPartRecord::first_shards(std::uint64_t n) const {
  if (n == 0) return Error{"no shards are asked for", "part", "fly them, or join the part that has them"};
  if (missing_from(0) < n) return missing_of(n);
  std::uint64_t at = 0;
  std::shared_ptr<ShardSums> sums;
  for (const auto& [first, node] : nodes) {
    if (at == n) break;
    PHYSIM_ASSERT(first == at);
    if (at + node.count > n)
      return Error{shards_text(first, node.count) + " are joined already, and " + std::to_string(n) + " are asked for",
                   "part", "ask for more, or fly them anew"};
    if (sums)
      join(*sums, *node.sums);
    else
      sums = std::make_shared<ShardSums>(*node.sums);
    at += node.count;
  }
  return std::shared_ptr<const ShardSums>(std::move(sums));
}

StudyPart::StudyPart() : record_(std::make_shared<const StudyPartRecord>()) {}

std::uint64_t StudyPart::shards() const {
  std::uint64_t count = 0;
  for (const auto& [first, node] : record_->nodes) count += node.count;
  return count;
}
bool StudyPart::has(std::uint64_t shard) const { return record_->has(shard); }
std::uint64_t StudyPart::first_missing() const { return record_->missing_from(0); }

StudyPart run_shard(const StudyPlan& plan, std::uint64_t shard) {
  const IeeeMode mode;
  auto part = std::make_shared<StudyPartRecord>();
  part->hash = plan.record().hash;
  part->add(shard, {1, std::make_shared<const ShardSums>(ShardFlyer(plan.record()).fly(shard))});
  return StudyPart(std::move(part));
}

namespace {

/// `take` adds what the second part has to what the first one has.
template <class Take>
Result<StudyPart> joined(const StudyPart& a, const StudyPart& b, const Take& take) {
  const IeeeMode mode;
  if (b.record().nodes.empty()) return a;
  if (a.record().nodes.empty()) return b;
  if (a.record().hash != b.record().hash)
    return Error{"the parts are of different studies", "part", "join parts of one study, flown by one version"};
  auto all = std::make_shared<StudyPartRecord>(a.record());
  for (const auto& [first, node] : b.record().nodes)
    if (Status status = take(*all, first, node); !status) return status.error();
  return StudyPart(std::move(all));
}

}  // namespace

Result<StudyPart> merge(const StudyPart& a, const StudyPart& b) {
  return joined(a, b, [&a](StudyPartRecord& all, std::uint64_t first, const auto& node) -> Status {
    if (const auto known = a.record().first_in(first, node.count); known != a.record().nodes.end()) {
      const std::uint64_t low = std::max(first, known->first);
      const std::uint64_t high = std::min(first + node.count, known->first + known->second.count);
      return Error{"both parts have " + shards_text(low, high - low), "part", "join each shard once"};
    }
    all.add(first, node);
    return {};
  });
}

Result<StudyPart> united(const StudyPart& a, const StudyPart& b) {
  return joined(a, b, [](StudyPartRecord& all, std::uint64_t first, const auto& node) -> Status {
    // Nodes begin at multiples of their power of two: of two that overlap, one lies within the other.
    auto known = all.first_in(first, node.count);
    if (known != all.nodes.end() && known->second.count >= node.count) return {};
    for (; known != all.nodes.end(); known = all.first_in(first, node.count)) all.nodes.erase(known);
    all.add(first, node);
    return {};
  });
}

std::vector<std::byte> save_part(const StudyPart& part) {
  SavedPart saved{kWhat, kStudyFormat, kVersion, part.record().hash, {}};
  std::vector<SavedMore> more;
  for (const auto& [first, node] : part.record().nodes) {
    saved.nodes.push_back({first, node.count, *node.sums});
    if (SavedMore of = more_of(*node.sums); !of.empty()) more.push_back(std::move(of));
  }
  PHYSIM_ASSERT(more.empty() || more.size() == saved.nodes.size());
  std::vector<std::byte> bytes;
  Writer writer(bytes);
  writer.write(saved, more);
  const std::uint64_t sum = hash_of(bytes);
  writer.write(sum);
  PHYSIM_ASSERT(writer.good());
  return bytes;
}

Result<StudyPart> load_part(std::span<const std::byte> bytes) {
  SavedPart saved;
  std::uint64_t sum = 0;
  Reader reader(bytes);
  if (const Status status = read_head(bytes, reader, saved); !status) return status.error();
  std::vector<SavedMore> more;
  reader(saved.hash, saved.nodes, more, sum);
  if (!reader.complete()) return not_a_part("they end too early, or too late");
  auto part = std::make_shared<StudyPartRecord>();
  part->hash = saved.hash;
  std::uint64_t end = 0;
  if (!more.empty() && more.size() != saved.nodes.size()) return not_a_part("its shards do not fit together");
  more.resize(saved.nodes.size());
  for (std::size_t i = 0; i < saved.nodes.size(); ++i) {
    const SavedNode& node = saved.nodes[i];
    if (!std::has_single_bit(node.count) || node.first % node.count != 0 || node.first < end ||
        node.count > ~std::uint64_t{0} - node.first || !fits(node.sums, saved.nodes[0].sums) ||
        !fits(more[i], more[0], saved.nodes[0].sums))
      return not_a_part("its shards do not fit together");
    end = node.first + node.count;
    part->add(node.first, {node.count, std::make_shared<const ShardSums>(sums_of(node.sums, more[i]))});
  }
  return StudyPart(std::move(part));
}

Result<StudyResult> result_of(const StudyPlan& plan, const StudyPart& part, std::uint64_t shards) {
  const IeeeMode mode;
  if (part.shards() > 0 && part.record().hash != plan.record().hash)
    return Error{"the part is of another study", "part", "fly this study"};
  const auto sums = part.record().first_shards(shards);
  if (!sums) return sums.error();
  return figures_of(plan.record(), **sums);
}

}  // namespace physim
