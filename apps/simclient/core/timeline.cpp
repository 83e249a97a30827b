#include "simclient/core/timeline.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "simclient/core/client.hpp"

namespace physim::client {
namespace {

using Kind = TimelineTick::Kind;

/// When a track ends, as far as that is known or foreseen [s].
double end_of(Client& client, const Track& track, double known) {
  if (!track.is_flying()) return track.born + track.samples.back().time;
  if (track.whole) return track.born + track.whole->duration();
  const Track* last = client.last_of_this_shot();
  if (last == nullptr || last->id != track.id) return known;
  const Prediction& ahead = client.prediction();
  const bool is_foreseen = !ahead.error && !ahead.is_cut && !ahead.path.empty() && !track.edited;
  return is_foreseen ? std::max(known, track.born + ahead.path.back().time) : known;
}

void add(Timeline& line, const Track& track, Kind kind, double age) {
  const double time = track.born + age;
  line.ticks.push_back(
      {time, kind, track.colour, formatted("%.3f s: %s, %s", time, track.title().c_str(), name(kind).data())});
}

void add_ticks(Timeline& line, const Track& track) {
  add(line, track, Kind::launch, 0);
  const double last = track.whole ? track.whole->duration() : track.samples.back().time;
  if (track.burnout && *track.burnout <= last) add(line, track, Kind::burnout, *track.burnout);
  if (!track.whole) {
    if (track.apex) add(line, track, Kind::apex, track.apex->time);
    if (track.impact) add(line, track, Kind::hit, track.impact->time);
    return;
  }
  for (const Event& event : track.whole->events())
    if (event.kind == EventKind::apex) add(line, track, Kind::apex, event.time);
  add(line, track, track.whole->outcome() == Outcome::landed ? Kind::hit : Kind::end, last);
}

/// Those of tracks have one for their first hit already.
void add_hits(Timeline& line, const Session& session) {
  for (const Hit& hit : session.known_hits().hits()) {
    const bool is_there = std::ranges::any_of(line.ticks, [&](const TimelineTick& tick) {
      return tick.kind == Kind::hit && std::abs(tick.time - hit.time) < 1e-9;
    });
    if (is_there || is_passed(hit)) continue;
    line.ticks.push_back({hit.time, Kind::hit, session.colour_of(hit),
                          formatted("%.3f s: %s hits %s", hit.time, session.title_of(hit).c_str(), hit.thing.c_str())});
  }
}

}  // namespace

std::string_view name(Kind kind) {
  switch (kind) {
    case Kind::launch: return "launch";
    case Kind::burnout: return "burnout";
    case Kind::apex: return "apex";
    case Kind::hit: return "hit";
    case Kind::end: return "end";
  }
  return "";
}

double Timeline::part(double time) const {
  PHYSIM_ASSERT(end > begin);
  return std::clamp((time - begin) / (end - begin), 0.0, 1.0);
}

Timeline timeline_of(Client& client) {
  const Session& session = client.session;
  const Scenario& scenario = session.scenario();
  const double h = session.step_length();
  const auto time_of = [&](std::uint64_t step) {
    return session.time() + (static_cast<double>(step) - static_cast<double>(session.step())) * h;
  };
  Timeline line;
  line.known = time_of(session.last_step());
  line.reachable = std::min(std::max(time_of(session.first_step()), 0.0), line.known);
  const auto tracks = session.known_tracks();
  const bool runs_by_itself = session.is_replay() || scenario.world.given;
  if (!runs_by_itself && !tracks.empty()) line.begin = std::ranges::min_element(tracks, {}, &Track::born)->born;
  const bool is_empty = tracks.empty() && !runs_by_itself;
  if (is_empty || session.flies_at_last() || session.is_replay()) line.end = line.known;
  if (scenario.world.given && std::isfinite(scenario.world.duration))
    line.end = std::max(line.end, scenario.world.duration);
  for (const Track& track : tracks) {
    line.end = std::max(line.end, end_of(client, track, line.known));
    add_ticks(line, track);
  }
  add_hits(line, session);
  line.end = std::max(line.end, line.begin + h);
  std::ranges::stable_sort(line.ticks, {}, &TimelineTick::time);
  line.now = std::clamp(session.shown_time(), line.begin, line.end);
  return line;
}

std::uint64_t step_at(const Session& session, double time) {
  const double steps = std::round((time - session.time()) / session.step_length());
  const double step = static_cast<double>(session.step()) + steps;
  return step > 0 ? static_cast<std::uint64_t>(step) : 0;
}

std::optional<TrackSample> sample_at(const Track& track, double time) {
  PHYSIM_ASSERT(!track.samples.empty());
  const double age = time - track.born;
  const auto& samples = track.samples;
  if (!(age >= samples.front().time && age <= samples.back().time)) return std::nullopt;
  if (track.whole) return sample_of(*track.whole, age);
  const auto after = std::ranges::lower_bound(samples, age, {}, &TrackSample::time);
  if (after == samples.begin()) return samples.front();
  const TrackSample &a = *std::prev(after), &b = *after;
  return b.time > a.time ? between(a, b, (age - a.time) / (b.time - a.time)) : b;
}

}  // namespace physim::client
