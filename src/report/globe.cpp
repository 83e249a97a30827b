#include "report/globe.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/vec3.hpp"
#include "model/ladder.hpp"
#include "physim/names.hpp"
#include "prepare/grant.hpp"
#include "report/kml.hpp"
#include "report/number.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180 / kPi;

/// A place at a time, in degrees as files have it.
struct GlobePoint {
  double time, longitude, latitude, height;
};

GlobePoint point_of(const EarthFrames& frames, double time, const Vec3d& position) {
  const Geodetic g = frames.geodetic(position);
  PHYSIM_ASSERT(!(std::abs(g.longitude) * kDegrees > 181));
  PHYSIM_ASSERT(!(std::abs(g.latitude) * kDegrees > 91));
  return {time, g.longitude * kDegrees, g.latitude * kDegrees, g.height};
}

/// What happened where.
struct Mark {
  std::string name;
  GlobePoint point;
  double speed;
};

struct PathPoint {
  double time;
  Vec3d position;
};

/// A path over the globe: samples, and what lies between them. Times are those of the file.
struct Track {
  std::string name;
  std::string outcome;
  EarthFrames frames;
  std::vector<PathPoint> points;               // in order of time
  Times breaks;                                // of the path or its slope
  std::function<Vec3d(double time)> position;  // in W, at a time between the first point and the last
  std::vector<Mark> marks;                     // launch, events and end

  [[nodiscard]] GlobePoint at(const PathPoint& point) const { return point_of(frames, point.time, point.position); }
  [[nodiscard]] Mark mark(std::string_view what, double time, const BodyState& state) const {
    return {std::string(what), point_of(frames, time, state.position), length(state.velocity)};
  }
};

Track track_of(const FlownShot& shot, const Times& times) {
  const Flight& flight = shot.flight;
  const Sample start = flight.at(0), end = flight.end();
  Track track{.name = shot.name,
              .outcome = std::string(name(flight.outcome())),
              .frames = flight.earth_frames(),
              .points = {},
              .breaks = breaks_of(flight),
              .position = [&flight](double time) { return flight.at(time).position; },
              .marks = {}};
  for (std::size_t i = 0; i < times.size(); ++i)
    track.points.push_back({times[i], sample_at(flight, times, i).position});
  track.marks.push_back(track.mark("launch", 0, {start.position, start.velocity}));
  for (const Event& e : flight.events())
    if (e.time < flight.duration()) track.marks.push_back(track.mark(name(e.kind), e.time, {e.position, e.velocity}));
  track.marks.push_back(track.mark(track.outcome, end.time, {end.position, end.velocity}));
  return track;
}

/// What a log has of one projectile of a world. Between two samples its path is the parabola of their places and of a
/// velocity that is that of the launch or no corner's: a corner's may be the one before or the one behind a bounce.
struct WorldPath {
  struct Point {
    double time;
    BodyState state;
    bool is_corner;
  };
  Launched launched{};
  std::vector<Point> points;
  std::vector<const LoggedEvent*> events;

  [[nodiscard]] Vec3d position(double time) const {
    PHYSIM_ASSERT(!points.empty());
    const auto next = std::ranges::lower_bound(points, time, {}, &Point::time);
    if (next == points.end()) return points.back().state.position;
    if (next == points.begin() || next->time == time) return next->state.position;
    const Point &from = *std::prev(next), &to = *next;
    const double span = to.time - from.time, part = (time - from.time) / span;
    const Vec3d way = to.state.position - from.state.position, straight = from.state.position + way * part;
    Vec3d bend;  // the parabola's: how far it ends from where its first velocity leads
    if (!from.is_corner || &from == &points.front())
      bend = way - from.state.velocity * span;
    else if (!to.is_corner)
      bend = to.state.velocity * span - way;
    return straight - bend * (part * (1 - part));
  }
};

/// By number of the launch; those without points were never logged.
std::vector<WorldPath> paths_of(const WorldLog& log) {
  std::vector<WorldPath> paths;
  const auto path_of = [&](const Launched& launched) -> WorldPath& {
    if (paths.size() <= launched.number) paths.resize(launched.number + 1);
    WorldPath& path = paths[launched.number];
    path.launched = launched;
    return path;
  };
  log.each_sample([&](const WorldSample& sample, bool is_corner) {
    path_of(sample.launched).points.push_back({sample.time, sample.state, is_corner});
  });
  for (const LoggedEvent& event : log.events) path_of(event.launched).events.push_back(&event);
  return paths;
}

Track track_of(const WorldLog& log, const WorldPath& path) {
  const WorldGroup& group = log.groups[path.launched.group];
  const ScenarioShot& shot = log.scenario.shots[group.shot];
  const Environment& environment = log.scenario.environment;
  const EarthModel earth = grant(shot.projectile.fidelity, shot.projectile, environment).fidelity.earth;
  const bool is_alone = group.spawned == 1 && group.name == shot.projectile.name;
  Track track{.name = group.name + (is_alone ? "" : " " + std::to_string(path.launched.number)),
              .outcome = std::string(name(LifeStatus::in_flight)),
              .frames = EarthFrames(environment, earth),
              .points = {},
              .breaks = {},
              .position = [&path](double time) { return path.position(time); },
              .marks = {}};
  for (const WorldPath::Point& point : path.points) {
    track.points.push_back({point.time, point.state.position});
    if (point.is_corner) track.breaks.push_back(point.time);
  }
  for (const LoggedEvent* event : path.events) {
    const bool is_launch = event->kind == EventKind::spawned;
    track.marks.push_back(track.mark(is_launch ? "launch" : name(event->kind), event->time, event->state));
    if (event->kind == EventKind::landed || event->kind == EventKind::expired || event->kind == EventKind::retired)
      track.outcome = std::string(name(event->kind));
  }
  return track;
}

/// Parts of a path that do not cross the antimeridian, of two points at least. A path over a pole jumps too: it runs
/// along the edge of the map there.
using Parts = std::vector<std::vector<GlobePoint>>;

/// The point at which the path crosses the antimeridian between two samples.
GlobePoint at_antimeridian(const Track& track, const GlobePoint& from, const GlobePoint& to) {
  PHYSIM_ASSERT(std::abs(to.longitude - from.longitude) > 180);
  double before = from.time, behind = to.time;
  GlobePoint edge = from;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings && before < behind; ++i) {
    const double middle = before + 0.5 * (behind - before);
    const GlobePoint p = track.at({middle, track.position(middle)});
    if (std::abs(p.longitude - from.longitude) > 180) {
      behind = middle;
    } else {
      before = middle;
      edge = p;
    }
  }
  edge.longitude = from.longitude > 0 ? 180 : -180;
  return edge;
}

Parts parts_of(const Track& track) {
  Parts parts(1);
  for (const PathPoint& point : track.points) {
    const GlobePoint p = track.at(point);
    if (!parts.back().empty() && std::abs(p.longitude - parts.back().back().longitude) > 180) {
      GlobePoint edge = at_antimeridian(track, parts.back().back(), p);
      parts.back().push_back(edge);
      edge.longitude = -edge.longitude;
      parts.push_back({edge});
    }
    parts.back().push_back(p);
  }
  for (std::vector<GlobePoint>& part : parts)
    if (part.size() == 1) part.push_back(part[0]);
  return parts;
}

/// The datum of heights, for the header of a file.
constexpr std::string_view kHeights =
    "Heights are metres above the ellipsoid (WGS 84) or the sphere that was flown over, with environment.altitude as "
    "the height of the origin above it.";
constexpr std::string_view kReaders = " Programs that read KML take them as metres above the sea.";

// -------------------------------------------------------------------------------------------------------------- times
/// A time since the launch, which a file without a date puts at noon of 1 January 2000: "2000-01-01T12:00:01.25Z", with
/// the digits of the number.
std::string utc(double seconds) {
  using namespace std::chrono;
  PHYSIM_ASSERT(seconds >= 0 && std::isfinite(seconds));
  const double whole_seconds = std::floor(seconds);
  const auto whole = sys_days{2000y / January / 1} + hours{12} + std::chrono::seconds{std::llround(whole_seconds)};
  const auto day = floor<days>(whole);
  const year_month_day date{day};
  const hh_mm_ss clock{whole - day};
  char text[40];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()));
  const std::string digits = plain(seconds);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  return text + digits.substr(point) + "Z";
}

// ---------------------------------------------------------------------------------------------------------------- KML
std::string kml_coordinates(const GlobePoint& p) { return report::kml_coordinates(p.longitude, p.latitude, p.height); }

void write_kml_track(const Sink& sink, const Track& track) {
  const Parts parts = parts_of(track);
  const bool is_whole = parts.size() == 1;
  sink(" <Folder>\n  <name>" + xml(track.name) + "</name>\n  <Placemark>\n   <name>" + xml(track.name) +
       "</name>\n   <TimeSpan><begin>" + utc(track.points.front().time) + "</begin><end>" +
       utc(track.points.back().time) + "</end></TimeSpan>\n   <styleUrl>#path</styleUrl>\n" +
       (is_whole ? "" : "   <MultiGeometry>\n"));
  for (const std::vector<GlobePoint>& part : parts) {
    sink("   <LineString>\n    <altitudeMode>absolute</altitudeMode>\n    <coordinates>\n");
    for (const GlobePoint& p : part) sink("     " + kml_coordinates(p) + "\n");
    sink("    </coordinates>\n   </LineString>\n");
  }
  sink(std::string(is_whole ? "" : "   </MultiGeometry>\n") + "  </Placemark>\n");
  for (const Mark& mark : track.marks)
    sink("  <Placemark>\n   <name>" + xml(mark.name) + "</name>\n   <description>" + xml(track.name) + ": " +
         significant(mark.point.time, 6) + " s, " + significant(mark.speed, 6) +
         " m/s</description>\n   <TimeStamp><when>" + utc(mark.point.time) +
         "</when></TimeStamp>\n   <Point>\n    <altitudeMode>absolute</altitudeMode>\n    <coordinates>" +
         kml_coordinates(mark.point) + "</coordinates>\n   </Point>\n  </Placemark>\n");
  sink(" </Folder>\n");
}

// --------------------------------------------------------------------------------------------------------------- CZML
constexpr std::size_t kPathDegree = 3;  // of the polynomial that viewers lay through samples

/// A part of a path without a break, as samples between which a viewer finds the places by a polynomial.
struct Smooth {
  std::vector<PathPoint> points;

  /// The position that viewers interpolate between samples k - 1 and k, by the samples around.
  [[nodiscard]] Vec3d shown(double time, std::size_t k) const {
    PHYSIM_ASSERT(k > 0 && k < points.size());
    const std::size_t count = std::min(kPathDegree + 1, points.size());
    const std::size_t first = std::min(k - std::min(k, (count - 1) / 2 + 1), points.size() - count);
    Vec3d place;
    for (std::size_t i = first; i < first + count; ++i) {
      double weight = 1;
      for (std::size_t j = first; j < first + count; ++j)
        if (j != i) weight *= (time - points[j].time) / (points[i].time - points[j].time);
      place += (points[i].position - points[first].position) * weight;
    }
    return points[first].position + place;
  }

  /// Removes samples so close to their neighbours that interpolation through them is ill-conditioned.
  void thin_out() {
    constexpr double kClose = 1e-4;
    for (std::size_t i = 1; i + 1 < points.size();) {
      const double before = points[i].time - points[i - 1].time, behind = points[i + 1].time - points[i].time;
      const bool is_close = std::min(before, behind) < kClose * std::max(before, behind);
      if (is_close)
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
  }

  /// Adds samples until what viewers show between them is the path.
  void refine(const Track& track) {
    constexpr double kAllowed = 1e-3;   // [m]
    constexpr double kShortest = 1e-6;  // [s]
    constexpr int kRounds = 20;
    bool is_done = points.size() < 2;
    for (int round = 0; round < kRounds && !is_done && points.size() < kMaxSamples; ++round) {
      std::vector<PathPoint> finer = {points[0]};
      for (std::size_t k = 1; k < points.size(); ++k) {
        const double length_of_step = points[k].time - points[k - 1].time;
        const double middle = points[k - 1].time + 0.5 * length_of_step;
        const Vec3d flown = track.position(middle);
        if (length_of_step > kShortest && length(shown(middle, k) - flown) > kAllowed) finer.push_back({middle, flown});
        finer.push_back(points[k]);
      }
      is_done = finer.size() == points.size();
      points = std::move(finer);
    }
  }
};

/// The parts of a path between its breaks.
std::vector<Smooth> smooth_parts(const Track& track) {
  constexpr double kShortest = 1e-9;  // [s]; viewers do not know times better
  std::vector<Smooth> parts(1);
  const double last = track.points.back().time;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    const PathPoint& point = track.points[i];
    std::vector<PathPoint>& open = parts.back().points;
    const bool is_again = !open.empty() && open.back().time == point.time;
    if (is_again && open.size() == 1)
      open.back() = point;
    else if (!is_again)
      open.push_back(point);
    if (open.size() > 1 && point.time - open.front().time < kShortest) {
      open.resize(1);
      continue;
    }
    const bool is_last = i + 1 == track.points.size() || last == point.time;
    if (open.size() > 1 && !is_last && std::ranges::binary_search(track.breaks, point.time))
      parts.emplace_back().points.push_back(point);
  }
  if (parts.size() > 1 && parts.back().points.size() == 1) parts.pop_back();
  for (Smooth& part : parts) {
    PHYSIM_ASSERT(!part.points.empty());
    part.thin_out();
    part.refine(track);
  }
  return parts;
}

void add_czml_part(JsonStream& out, const Track& track, const Smooth& part, bool is_whole) {
  if (!is_whole) out.add({{"interval", utc(part.points.front().time) + "/" + utc(part.points.back().time)}});
  out.add({{"epoch", utc(0)},
           {"interpolationAlgorithm", "LAGRANGE"},
           {"interpolationDegree", kPathDegree},
           {"forwardExtrapolationType", "HOLD"},
           {"backwardExtrapolationType", "HOLD"}});
  out.list("cartographicDegrees");
  for (const PathPoint& point : part.points) {
    const GlobePoint p = track.at(point);
    for (const double number : {p.time, p.longitude, p.latitude, p.height}) out.push(number);
  }
  out.close();
}

void add_czml_track(JsonStream& out, const Track& track) {
  const Json colour = {{"solidColor", {{"color", {{"rgba", {255, 160, 0, 255}}}}}}};
  const std::vector<Smooth> parts = smooth_parts(track);
  const bool is_whole = parts.size() == 1;
  out.object();
  out.add({{"id", "shot/" + track.name},
           {"name", track.name},
           {"availability", utc(track.points.front().time) + "/" + utc(track.points.back().time)}});
  if (is_whole)
    out.object("position");
  else
    out.list("position");
  for (const Smooth& part : parts) {
    if (!is_whole) out.object();
    add_czml_part(out, track, part, is_whole);
    if (!is_whole) out.close();
  }
  out.close();
  out.add({{"point", {{"pixelSize", 8}, {"color", {{"rgba", {255, 160, 0, 255}}}}}},
           {"path", {{"width", 2}, {"material", colour}}}});
  out.close();
}

// ------------------------------------------------------------------------------------------------------------ GeoJSON
Json position_json(const GlobePoint& p) { return Json::array({p.longitude, p.latitude, p.height}); }

/// What is said of each point: a list of it, or where there are several parts a list for each.
template <class Say>
void add_parts(JsonStream& out, std::string_view key, const Parts& parts, const Say& say) {
  const bool whole = parts.size() == 1;
  if (!whole) out.list(key);
  for (const std::vector<GlobePoint>& part : parts) {
    out.list(whole ? key : "");
    for (const GlobePoint& p : part) out.push(say(p));
    out.close();
  }
  if (!whole) out.close();
}

void add_path_feature(JsonStream& out, const Track& track) {
  const Parts parts = parts_of(track);
  out.object();
  out.add({{"type", "Feature"}});
  out.object("properties");
  out.add({{"shot", track.name}, {"what", "path"}, {"outcome", track.outcome}});
  add_parts(out, "times [s]", parts, [](const GlobePoint& p) { return p.time; });
  out.close();
  out.object("geometry");
  out.add({{"type", parts.size() == 1 ? "LineString" : "MultiLineString"}});
  add_parts(out, "coordinates", parts, position_json);
  out.close();
  out.close();
}

Json mark_feature(const Track& track, const Mark& mark) {
  return {{"type", "Feature"},
          {"properties",
           {{"shot", track.name}, {"what", mark.name}, {"time [s]", mark.point.time}, {"speed [m/s]", mark.speed}}},
          {"geometry", {{"type", "Point"}, {"coordinates", position_json(mark.point)}}}};
}

// -------------------------------------------------------------------------------------------------------------- files
/// The content of a file: tracks one after the other, so that only one is in memory.
struct Shown {
  const Scenario& scenario;
  double end;  // of its clock [s]
  std::function<void(const std::function<void(const Track&)>& take)> each;
};

Shown shown(const Flights& flights) {
  double last = 0;
  for (const FlownShot& shot : flights.flown.shots) last = std::max(last, shot.flight.duration());
  return {flights.flown.scenario, last, [flights](const auto& take) {
            PHYSIM_ASSERT(flights.times.size() == flights.flown.shots.size());
            for (std::size_t i = 0; i < flights.times.size(); ++i)
              take(track_of(flights.flown.shots[i], flights.times[i]));
          }};
}
Shown shown(const WorldLog& log) {
  return {log.scenario, log.time, [&log](const auto& take) {
            for (const WorldPath& path : paths_of(log))
              if (!path.points.empty()) take(track_of(log, path));
          }};
}

Content kml_of(const Shown& shown) {
  return [shown](const Sink& sink) {
    const std::string& source = shown.scenario.source;
    const std::string said = source + (source.empty() ? "" : "\n") + std::string(kHeights) + std::string(kReaders);
    sink(kml_begin(title_of(shown.scenario), said) +
         " <Style id=\"path\"><LineStyle><color>ff00a0ff</color><width>2</width></LineStyle></Style>\n");
    shown.each([&](const Track& track) { write_kml_track(sink, track); });
    sink(kml_end());
  };
}

Content czml_of(const Shown& shown) {
  return [shown](const Sink& sink) {
    JsonStream out(sink);
    out.list();
    out.push({{"id", "document"},
              {"name", title_of(shown.scenario)},
              {"version", "1.0"},
              {"description", kHeights},
              {"clock", {{"interval", utc(0) + "/" + utc(shown.end)}, {"currentTime", utc(0)}, {"multiplier", 1}}}});
    shown.each([&](const Track& track) { add_czml_track(out, track); });
    out.close();
  };
}

Content geojson_of(const Shown& shown) {
  return [shown](const Sink& sink) {
    JsonStream out(sink);
    out.object();
    out.add({{"type", "FeatureCollection"}, {"name", title_of(shown.scenario)}, {"description", kHeights}});
    out.list("features");
    shown.each([&](const Track& track) {
      add_path_feature(out, track);
      for (const Mark& mark : track.marks) out.push(mark_feature(track, mark));
    });
    out.close();
    out.close();
  };
}

}  // namespace

Status check_round(EarthModel earth, const std::string& shot, const Scenario& scenario) {
  if (row(earth).shape != EarthShape::flat) return {};
  return Error{.message = "shot \"" + shot + "\" flies over a flat Earth, which globes do not know",
               .place = scenario.file,
               .hint = "shot.fidelity.earth=ellipsoid, or fidelity = { earth = \"ellipsoid\" }"};
}

Status check_round(const FlownScenario& flown) {
  Status status;
  for (const FlownShot& shot : flown.shots)
    if (status) status = check_round(shot.flight.fidelity_in_use().fidelity.earth, shot.name, flown.scenario);
  return status;
}

Status check_round_world(const Scenario& scenario) {
  Status status;
  for (const ScenarioShot& shot : scenario.shots) {
    const Fidelity granted = grant(shot.projectile.fidelity, shot.projectile, scenario.environment).fidelity;
    if (status) status = check_round(granted.earth, shot.projectile.name, scenario);
  }
  return status;
}

Content globe_kml(const Flights& flights) { return kml_of(shown(flights)); }
Content globe_kml(const WorldLog& log) { return kml_of(shown(log)); }
Content globe_czml(const Flights& flights) { return czml_of(shown(flights)); }
Content globe_czml(const WorldLog& log) { return czml_of(shown(log)); }
Content globe_geojson(const Flights& flights) { return geojson_of(shown(flights)); }
Content globe_geojson(const WorldLog& log) { return geojson_of(shown(log)); }

}  // namespace physim::report
