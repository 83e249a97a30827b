#include "report/format.hpp"

#include "base/assert.hpp"
#include "report/file.hpp"
#include "report/globe.hpp"
#include "report/gnuplot.hpp"
#include "report/pictures.hpp"
#include "report/world_hits.hpp"

namespace physim::report {
namespace {

constexpr Format kFormats[] = {
    {.name = "csv", .ending = ".csv", .doc = "as CSV", .world_parts = {.samples = true}, .records = csv_text},
    {.name = "json",
     .ending = ".json",
     .doc = "as JSON",
     .world_parts = {.samples = true, .events = true, .hits = true},
     .flights = flights_json,
     .world = world_json,
     .ladder = ladder_json,
     .replay = replay_json,
     .records = columns_json},
    {.name = "plot",
     .ending = ".png",
     .other_ending = ".svg",
     .doc = "as a picture",
     .world_parts = {.paths = true},
     .is_picture = true,
     .flights = flights_picture,
     .world = world_picture,
     .ladder = ladder_picture},
    {.name = "kml",
     .ending = ".kml",
     .doc = "as KML, for globes",
     .world_parts = {.samples = true, .events = true},
     .flights = globe_kml,
     .world = globe_kml,
     .check = check_round,
     .check_world = check_round_world},
    {.name = "czml",
     .ending = ".czml",
     .doc = "as CZML, moving in time, for Cesium",
     .world_parts = {.samples = true, .events = true},
     .flights = globe_czml,
     .world = globe_czml,
     .check = check_round,
     .check_world = check_round_world},
    {.name = "geojson",
     .ending = ".geojson",
     .doc = "as GeoJSON",
     .world_parts = {.samples = true, .events = true},
     .flights = globe_geojson,
     .world = globe_geojson,
     .check = check_round,
     .check_world = check_round_world},
    {.name = "events",
     .ending = "_events.csv",
     .what = "what happened",
     .doc = "as CSV",
     .world_parts = {.events = true},
     .world = world_events_csv},
    {.name = "hits",
     .ending = "_hits.csv",
     .what = "what was hit in a scene",
     .doc = "as CSV",
     .world_parts = {.hits = true},
     .flights = flight_hits_csv,
     .world = world_hits_csv,
     .scenario_has = has_scene},
};

template <class S>
Content made(Content (*own)(const S&), const Format& format, const S& subject) {
  if (own != nullptr) return own(subject);
  PHYSIM_ASSERT(format.records != nullptr);
  return format.records(records_of(subject));
}

}  // namespace

std::span<const Format> formats() { return kFormats; }

bool can_write(const Format& format, Subject subject) {
  if (format.records != nullptr) return true;
  switch (subject) {
    case Subject::flights: return format.flights != nullptr;
    case Subject::world: return format.world != nullptr;
    case Subject::ladder: return format.ladder != nullptr;
    case Subject::replay: return format.replay != nullptr;
    case Subject::records: return false;
  }
  PHYSIM_UNREACHABLE();
}

Result<const Format*> format_of_file(const std::string& path, Subject subject) {
  std::string endings;
  for (const Format& format : kFormats) {
    if (!can_write(format, subject)) continue;
    for (const std::string_view ending : {format.ending, format.other_ending}) {
      if (ending.empty()) continue;
      if (path.ends_with(ending)) return &format;
      endings += (endings.empty() ? "" : ", ") + std::string(ending);
    }
  }
  return Error{"cannot tell the format from the file name", path, "it may end with " + endings};
}

Content content_of(const Format& format, const Flights& flights) { return made(format.flights, format, flights); }
Content content_of(const Format& format, const WorldLog& log) { return made(format.world, format, log); }
Content content_of(const Format& format, const LadderOfShot& ladder) { return made(format.ladder, format, ladder); }
Content content_of(const Format& format, const ReplayLog& log) { return made(format.replay, format, log); }
Content content_of(const Format& format, Records records) {
  PHYSIM_ASSERT(format.records != nullptr);
  return format.records(std::move(records));
}

Status write_content(const std::string& path, const Content& content) {
  if (const auto* picture = std::get_if<Picture>(&content)) return draw(path, *picture);
  return write_file(path, std::get<Text>(content));
}

}  // namespace physim::report
