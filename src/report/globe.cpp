#include "report/globe.hpp"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "math/angles.hpp"
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

template <class Take>
void each_point(const Flight& flight, const std::vector<double>& times, const Take& take) {
  const EarthFrames frames = flight.earth_frames();
  for (const double time : times) take(point_of(frames, time, flight.at(time).position));
}

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

// ---------------------------------------------------------------------------------------------------------------- KML
std::string kml_coordinates(const GlobePoint& p) { return report::kml_coordinates(p.longitude, p.latitude, p.height); }

void write_kml_shot(const Sink& sink, const FlownShot& shot, const std::vector<double>& times) {
  sink(" <Folder>\n  <name>" + xml(shot.name) +
       "</name>\n  <Placemark>\n   <name>path</name>\n   <styleUrl>#path</styleUrl>\n"
       "   <LineString>\n    <altitudeMode>absolute</altitudeMode>\n    <coordinates>\n");
  each_point(shot.flight, times, [&sink](const GlobePoint& p) { sink("     " + kml_coordinates(p) + "\n"); });
  sink("    </coordinates>\n   </LineString>\n  </Placemark>\n");
  for (const Mark& mark : marks_of(shot.flight))
    sink("  <Placemark>\n   <name>" + xml(mark.name) + "</name>\n   <description>" + significant(mark.point.time, 6) +
         " s, " + significant(mark.speed, 6) +
         " m/s</description>\n   <Point>\n    <altitudeMode>absolute</altitudeMode>\n    <coordinates>" +
         kml_coordinates(mark.point) + "</coordinates>\n   </Point>\n  </Placemark>\n");
  sink(" </Folder>\n");
}

// --------------------------------------------------------------------------------------------------------------- CZML
/// A time since the launch, which a file without a date puts at noon of 1 January 2000.
std::string utc(double seconds) {
  using namespace std::chrono;
  const auto whole = sys_days{2000y / January / 1} + hours{12} + std::chrono::seconds{std::llround(std::ceil(seconds))};
  const auto day = floor<days>(whole);
  const year_month_day date{day};
  const hh_mm_ss clock{whole - day};
  char text[40];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()));
  return text;
}

void add_czml_shot(JsonStream& out, const FlownShot& shot, const std::vector<double>& times) {
  const Json colour = {{"solidColor", {{"color", {{"rgba", {255, 160, 0, 255}}}}}}};
  out.object();
  out.add(
      {{"id", "shot/" + shot.name}, {"name", shot.name}, {"availability", utc(0) + "/" + utc(shot.flight.duration())}});
  out.object("position");
  out.add({{"epoch", utc(0)}, {"interpolationAlgorithm", "LAGRANGE"}, {"interpolationDegree", 3}});
  out.list("cartographicDegrees");
  each_point(shot.flight, times, [&out](const GlobePoint& p) {
    for (const double number : {p.time, p.longitude, p.latitude, p.height}) out.push(number);
  });
  out.close();
  out.close();
  out.add({{"point", {{"pixelSize", 8}, {"color", {{"rgba", {255, 160, 0, 255}}}}}},
           {"path", {{"width", 2}, {"material", colour}}}});
  out.close();
}

// ------------------------------------------------------------------------------------------------------------ GeoJSON
Json position_json(const GlobePoint& p) { return Json::array({p.longitude, p.latitude, p.height}); }

/// The point between two others where the path leaves the map, on the side of the first.
GlobePoint at_antimeridian(const GlobePoint& from, const GlobePoint& to) {
  const double side = from.longitude > 0 ? 180 : -180;
  const double beyond = to.longitude + 2 * side;  // the second without the jump
  PHYSIM_ASSERT(std::abs(to.longitude - from.longitude) > 180);
  const double part = (side - from.longitude) / (beyond - from.longitude);
  return {from.time + part * (to.time - from.time), side, from.latitude + part * (to.latitude - from.latitude),
          from.height + part * (to.height - from.height)};
}

/// Parts that do not cross the antimeridian, of two points at least. A path over a pole jumps too: it runs along the
/// edge of the map there.
using Parts = std::vector<std::vector<GlobePoint>>;
Parts parts_of(const Flight& flight, const std::vector<double>& times) {
  Parts parts(1);
  each_point(flight, times, [&parts](const GlobePoint& p) {
    if (!parts.back().empty() && std::abs(p.longitude - parts.back().back().longitude) > 180) {
      GlobePoint edge = at_antimeridian(parts.back().back(), p);
      parts.back().push_back(edge);
      edge.longitude = -edge.longitude;
      parts.push_back({edge});
    }
    parts.back().push_back(p);
  });
  for (std::vector<GlobePoint>& part : parts)
    if (part.size() == 1) part.push_back(part[0]);
  return parts;
}

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

void add_path_feature(JsonStream& out, const FlownShot& shot, const std::vector<double>& times) {
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
    sink(kml_begin(title_of(flown.scenario), flown.scenario.source) +
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
    out.add({{"type", "FeatureCollection"}});
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
