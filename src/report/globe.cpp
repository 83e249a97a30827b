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
#include "report/json.hpp"
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

/// Parts of a path that do not cross the antimeridian, of two points at least. A path over a pole jumps too: it runs
/// along the edge of the map there.
using Parts = std::vector<std::vector<GlobePoint>>;

/// The point at which the flight crosses the antimeridian between two samples.
GlobePoint at_antimeridian(const Flight& flight, const EarthFrames& frames, const GlobePoint& from,
                           const GlobePoint& to) {
  PHYSIM_ASSERT(std::abs(to.longitude - from.longitude) > 180);
  double before = from.time, behind = to.time;
  GlobePoint edge = from;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings && before < behind; ++i) {
    const double middle = before + 0.5 * (behind - before);
    const GlobePoint p = point_of(frames, middle, flight.at(middle).position);
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

Parts parts_of(const Flight& flight, const Times& times) {
  const EarthFrames frames = flight.earth_frames();
  Parts parts(1);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const GlobePoint p = point_of(frames, times[i], sample_at(flight, times, i).position);
    if (!parts.back().empty() && std::abs(p.longitude - parts.back().back().longitude) > 180) {
      GlobePoint edge = at_antimeridian(flight, frames, parts.back().back(), p);
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

/// What happened where: the launch, the events and the end.
struct Mark {
  std::string name;
  GlobePoint point;
  double speed;
};

std::vector<Mark> marks_of(const Flight& flight) {
  const EarthFrames frames = flight.earth_frames();
  const auto mark = [&](std::string_view what, double time, const Vec3d& x, const Vec3d& v) {
    return Mark{std::string(what), point_of(frames, time, x), std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z)};
  };
  const Sample start = flight.at(0), end = flight.end();
  std::vector<Mark> marks{mark("launch", 0, start.position, start.velocity)};
  for (const Event& e : flight.events())
    if (e.time < flight.duration()) marks.push_back(mark(name(e.kind), e.time, e.position, e.velocity));
  marks.push_back(mark(name(flight.outcome()), end.time, end.position, end.velocity));
  return marks;
}

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

void write_kml_shot(const Sink& sink, const FlownShot& shot, const Times& times) {
  const Parts parts = parts_of(shot.flight, times);
  const bool is_whole = parts.size() == 1;
  sink(" <Folder>\n  <name>" + xml(shot.name) + "</name>\n  <Placemark>\n   <name>" + xml(shot.name) +
       "</name>\n   <TimeSpan><begin>" + utc(0) + "</begin><end>" + utc(shot.flight.duration()) +
       "</end></TimeSpan>\n   <styleUrl>#path</styleUrl>\n" + (is_whole ? "" : "   <MultiGeometry>\n"));
  for (const std::vector<GlobePoint>& part : parts) {
    sink("   <LineString>\n    <altitudeMode>absolute</altitudeMode>\n    <coordinates>\n");
    for (const GlobePoint& p : part) sink("     " + kml_coordinates(p) + "\n");
    sink("    </coordinates>\n   </LineString>\n");
  }
  sink(std::string(is_whole ? "" : "   </MultiGeometry>\n") + "  </Placemark>\n");
  for (const Mark& mark : marks_of(shot.flight))
    sink("  <Placemark>\n   <name>" + xml(mark.name) + "</name>\n   <description>" + xml(shot.name) + ": " +
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
  struct Point {
    double time;
    Vec3d position;
  };
  std::vector<Point> points;

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
  void refine(const Flight& flight) {
    constexpr double kAllowed = 1e-3;   // [m]
    constexpr double kShortest = 1e-6;  // [s]
    constexpr int kRounds = 20;
    bool is_done = points.size() < 2;
    for (int round = 0; round < kRounds && !is_done && points.size() < kMaxSamples; ++round) {
      std::vector<Point> finer = {points[0]};
      for (std::size_t k = 1; k < points.size(); ++k) {
        const double length_of_step = points[k].time - points[k - 1].time;
        const double middle = points[k - 1].time + 0.5 * length_of_step;
        const Vec3d flown = flight.at(middle).position;
        if (length_of_step > kShortest && length(shown(middle, k) - flown) > kAllowed) finer.push_back({middle, flown});
        finer.push_back(points[k]);
      }
      is_done = finer.size() == points.size();
      points = std::move(finer);
    }
  }
};

/// The parts of a path between its breaks.
std::vector<Smooth> smooth_parts(const Flight& flight, const Times& times) {
  constexpr double kShortest = 1e-9;  // [s]; viewers do not know times better
  const Times breaks = breaks_of(flight);
  std::vector<Smooth> parts(1);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = times[i];
    const Smooth::Point point{time, sample_at(flight, times, i).position};
    std::vector<Smooth::Point>& open = parts.back().points;
    const bool is_again = !open.empty() && open.back().time == time;
    if (is_again && open.size() == 1)
      open.back() = point;
    else if (!is_again)
      open.push_back(point);
    if (open.size() > 1 && time - open.front().time < kShortest) {
      open.resize(1);
      continue;
    }
    const bool is_last = i + 1 == times.size() || times.back() == time;
    if (open.size() > 1 && !is_last && std::ranges::binary_search(breaks, time))
      parts.emplace_back().points.push_back(point);
  }
  if (parts.size() > 1 && parts.back().points.size() == 1) parts.pop_back();
  for (Smooth& part : parts) {
    PHYSIM_ASSERT(!part.points.empty());
    part.thin_out();
    part.refine(flight);
  }
  return parts;
}

void add_czml_part(JsonStream& out, const EarthFrames& frames, const Smooth& part, bool is_whole) {
  if (!is_whole) out.add({{"interval", utc(part.points.front().time) + "/" + utc(part.points.back().time)}});
  out.add({{"epoch", utc(0)},
           {"interpolationAlgorithm", "LAGRANGE"},
           {"interpolationDegree", kPathDegree},
           {"forwardExtrapolationType", "HOLD"},
           {"backwardExtrapolationType", "HOLD"}});
  out.list("cartographicDegrees");
  for (const Smooth::Point& point : part.points) {
    const GlobePoint p = point_of(frames, point.time, point.position);
    for (const double number : {p.time, p.longitude, p.latitude, p.height}) out.push(number);
  }
  out.close();
}

void add_czml_shot(JsonStream& out, const FlownShot& shot, const Times& times) {
  const Json colour = {{"solidColor", {{"color", {{"rgba", {255, 160, 0, 255}}}}}}};
  const std::vector<Smooth> parts = smooth_parts(shot.flight, times);
  const EarthFrames frames = shot.flight.earth_frames();
  const bool is_whole = parts.size() == 1;
  out.object();
  out.add(
      {{"id", "shot/" + shot.name}, {"name", shot.name}, {"availability", utc(0) + "/" + utc(shot.flight.duration())}});
  if (is_whole)
    out.object("position");
  else
    out.list("position");
  for (const Smooth& part : parts) {
    if (!is_whole) out.object();
    add_czml_part(out, frames, part, is_whole);
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

void add_path_feature(JsonStream& out, const FlownShot& shot, const Times& times) {
  const Parts parts = parts_of(shot.flight, times);
  out.object();
  out.add({{"type", "Feature"}});
  out.object("properties");
  out.add({{"shot", shot.name}, {"what", "path"}, {"outcome", name(shot.flight.outcome())}});
  add_parts(out, "times [s]", parts, [](const GlobePoint& p) { return p.time; });
  out.close();
  out.object("geometry");
  out.add({{"type", parts.size() == 1 ? "LineString" : "MultiLineString"}});
  add_parts(out, "coordinates", parts, position_json);
  out.close();
  out.close();
}

Json mark_feature(const FlownShot& shot, const Mark& mark) {
  return {{"type", "Feature"},
          {"properties",
           {{"shot", shot.name}, {"what", mark.name}, {"time [s]", mark.point.time}, {"speed [m/s]", mark.speed}}},
          {"geometry", {{"type", "Point"}, {"coordinates", position_json(mark.point)}}}};
}

}  // namespace

Status check_round(const FlownScenario& flown) {
  for (const FlownShot& shot : flown.shots)
    if (row(shot.flight.fidelity_in_use().fidelity.earth).shape == EarthShape::flat)
      return Error{.message = "shot \"" + shot.name + "\" flew over a flat Earth, which globes do not know",
                   .place = flown.scenario.file,
                   .hint = "shot.fidelity.earth=ellipsoid, or fidelity = { earth = \"ellipsoid\" }"};
  return {};
}

Content globe_kml(const Flights& flights) {
  return [flights](const Sink& sink) {
    const FlownScenario& flown = flights.flown;
    const SampleTimes& times = flights.times;
    PHYSIM_ASSERT(times.size() == flown.shots.size());
    const std::string& source = flown.scenario.source;
    const std::string said = source + (source.empty() ? "" : "\n") + std::string(kHeights) + std::string(kReaders);
    sink(kml_begin(title_of(flown.scenario), said) +
         " <Style id=\"path\"><LineStyle><color>ff00a0ff</color><width>2</width></LineStyle></Style>\n");
    for (std::size_t i = 0; i < flown.shots.size(); ++i) write_kml_shot(sink, flown.shots[i], times[i]);
    sink(kml_end());
  };
}

Content globe_czml(const Flights& flights) {
  return [flights](const Sink& sink) {
    const FlownScenario& flown = flights.flown;
    const SampleTimes& times = flights.times;
    PHYSIM_ASSERT(times.size() == flown.shots.size());
    double last = 0;
    for (const FlownShot& shot : flown.shots) last = std::max(last, shot.flight.duration());
    JsonStream out(sink);
    out.list();
    out.push({{"id", "document"},
              {"name", title_of(flown.scenario)},
              {"version", "1.0"},
              {"description", kHeights},
              {"clock", {{"interval", utc(0) + "/" + utc(last)}, {"currentTime", utc(0)}, {"multiplier", 1}}}});
    for (std::size_t i = 0; i < flown.shots.size(); ++i) add_czml_shot(out, flown.shots[i], times[i]);
    out.close();
  };
}

Content globe_geojson(const Flights& flights) {
  return [flights](const Sink& sink) {
    const FlownScenario& flown = flights.flown;
    const SampleTimes& times = flights.times;
    PHYSIM_ASSERT(times.size() == flown.shots.size());
    JsonStream out(sink);
    out.object();
    out.add({{"type", "FeatureCollection"}, {"name", title_of(flown.scenario)}, {"description", kHeights}});
    out.list("features");
    for (std::size_t i = 0; i < flown.shots.size(); ++i) {
      const FlownShot& shot = flown.shots[i];
      add_path_feature(out, shot, times[i]);
      for (const Mark& mark : marks_of(shot.flight)) out.push(mark_feature(shot, mark));
    }
    out.close();
    out.close();
  };
}

}  // namespace physim::report
