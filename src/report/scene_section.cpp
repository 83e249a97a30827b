#include "report/scene_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "report/number.hpp"

namespace physim::report {
namespace {

constexpr int kCutColumns = 800, kCutRows = 400;  // of casts, over a panel: dots of rows make a line

std::string cut_row(std::initializer_list<double> numbers) {
  std::string out;
  for (const double number : numbers) out += significant(number, 7) + " ";
  return out + "\n";
}

TrackPlace between(const TrackPlace& a, const TrackPlace& b, double part) {
  const auto at = [part](double from, double to) { return from + (to - from) * part; };
  return {at(a.across, b.across), at(a.x, b.x), at(a.z, b.z), std::clamp(at(a.time, b.time), 0.0, 1e9)};
}

/// What stands in an upright line at a place, from above: entries and exits of each thing belong together.
void cut_column(const Scene& scene, const TrackPlace& at, Extent heights, Section& into) {
  const Vec3d top{at.x, heights.high, at.z}, bottom{at.x, heights.low, at.z};
  std::map<InstanceId, double> open;  // from what height on the line is inside of a thing
  for (const InstanceId instance : scene.overlaps(top, 0, {}, at.time)) open[instance] = heights.high;
  const auto close = [&](InstanceId instance, double height) {
    const auto begun = open.find(instance);
    if (begun == open.end()) return;
    into.solids += cut_row({at.across, height, 0, begun->second - height});
    open.erase(begun);
  };
  for (const SceneHit& hit : scene.all_hits({top, bottom, 0, at.time, 0})) {
    if (hit.starts_inside) continue;
    into.surfaces += cut_row({at.across, hit.position.y});
    if (hit.entering)
      open.try_emplace(hit.instance, hit.position.y);
    else
      close(hit.instance, hit.position.y);
  }
  // Sheets have no inside: what was entered there ends nowhere.
  for (const InstanceId instance : scene.overlaps(bottom, 0, {}, at.time)) close(instance, heights.low);
}

/// Surfaces that stand upright, which upright lines miss.
void cut_rows(const Scene& scene, const TrackPlace& a, const TrackPlace& b, Extent heights, Section& into) {
  if (a.x == b.x && a.z == b.z) return;
  for (int i = 0; i <= kCutRows; ++i) {
    const double y = heights.low + heights.span() * i / kCutRows;
    for (const SceneHit& hit : scene.all_hits({{a.x, y, a.z}, {b.x, y, b.z}, 0, a.time, 0}))
      if (!hit.starts_inside) into.surfaces += cut_row({between(a, b, hit.part).across, y});
  }
}

}  // namespace

std::vector<TrackPlace> extended(const std::vector<TrackPlace>& track, Extent across) {
  PHYSIM_ASSERT(across.low <= across.high);
  std::vector<TrackPlace> ends = track;
  const auto goes_on = [&](const TrackPlace& from, const TrackPlace& to, double until) {
    TrackPlace end = between(from, to, (until - from.across) / (to.across - from.across));
    end.time = to.time;
    return end;
  };
  // The first and the last place that are elsewhere than their end give its direction beyond.
  const auto second = std::ranges::find_if(track, [&](const TrackPlace& p) { return p.across > track[0].across; });
  if (second == track.end()) return track;
  const auto last = std::ranges::find_if(track.rbegin(), track.rend(),
                                         [&](const TrackPlace& p) { return p.across < track.back().across; });
  if (across.low < track[0].across) ends.insert(ends.begin(), goes_on(*second, track[0], across.low));
  if (last != track.rend() && across.high > track.back().across)
    ends.push_back(goes_on(*last, track.back(), across.high));
  std::vector<TrackPlace> fine;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double parts = std::ceil(std::abs(ends[i + 1].across - ends[i].across) / (across.span() / kCutColumns));
    for (double k = 0; k < std::max(parts, 1.0); ++k)
      fine.push_back(between(ends[i], ends[i + 1], k / std::max(parts, 1.0)));
  }
  fine.push_back(ends.back());
  return fine;
}

Section section_along(const Scene& scene, const std::vector<TrackPlace>& track, Extent heights) {
  PHYSIM_ASSERT(heights.low <= heights.high);
  Section section;
  for (std::size_t i = 0; i < track.size(); ++i) {
    cut_column(scene, track[i], heights, section);
    if (i > 0) cut_rows(scene, track[i - 1], track[i], heights, section);
  }
  return section;
}

std::string section_blocks(const Section& section, const std::string& block) {
  return (section.solids.empty() ? "" : datablock(block + "solids", section.solids)) +
         (section.surfaces.empty() ? "" : datablock(block + "surfaces", section.surfaces));
}

std::string section_plots(const Section& section, const std::string& block) {
  std::string out;
  if (!section.solids.empty())
    out += block + "solids using 1:2:3:4 with vectors nohead lw 2.5 lc rgb '#DDDDDD' notitle, ";
  if (!section.surfaces.empty())
    out += block + "surfaces using 1:2 with points pt 7 ps 0.22 lc rgb '#8A8A8A' notitle, ";
  return out;
}

}  // namespace physim::report
