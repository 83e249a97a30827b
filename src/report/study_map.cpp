#include "report/study_answer.hpp"

#include <cmath>
#include <vector>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/vec3.hpp"
#include "model/sight.hpp"
#include "physim/environment.hpp"
#include "report/globe.hpp"
#include "report/kml.hpp"
#include "report/number.hpp"
#include "report/study_pictures.hpp"

namespace physim::report {
namespace {

constexpr std::size_t kMapShots = 1000;

/// Places on the ground, at the height where the shot without uncertainty comes down.
class Ground {
 public:
  Ground(const Study& study, const Flight& flight)
      : frames_(flight.earth_frames()),
        sight_(sight_frame(study.launch)),
        height_(frames_.geodetic(flight.end().position).height) {}

  [[nodiscard]] MapPoint place_of(const PlanePoint& at) const {
    const Vec3d above = sight_.start - sight_.muzzle;
    Vec3d place = sight_.muzzle + sight_.forward * at.up + sight_.right * (at.right + dot(above, sight_.right));
    for (int i = 0; i < 3; ++i) place.y -= frames_.geodetic(place).height - height_;  // the ground curves down
    return place_of(place);
  }
  [[nodiscard]] MapPoint place_of(const Vec3d& place) const {
    const Geodetic g = frames_.geodetic(place);
    return {g.longitude / kDegree, g.latitude / kDegree};
  }

 private:
  EarthFrames frames_;
  SightFrame sight_;
  double height_;
};

std::string kml_place(const std::string& name, const std::string& geometry, const std::string& style = "") {
  return " <Placemark>\n  <name>" + xml(name) + "</name>\n" +
         (style.empty() ? "" : "  <styleUrl>#" + style + "</styleUrl>\n") + geometry + " </Placemark>\n";
}

std::string coordinates_of(const MapPoint& p) { return kml_coordinates(p.longitude, p.latitude, 0); }

std::string kml_point(const MapPoint& p) {
  return "  <Point><altitudeMode>clampToGround</altitudeMode><coordinates>" + coordinates_of(p) +
         "</coordinates></Point>\n";
}

std::string kml_ring(const Ground& ground, const std::vector<PlanePoint>& rim) {
  Ring whole;
  for (const PlanePoint& p : rim) whole.push_back(ground.place_of(p));
  const std::vector<Ring> parts = cut_at_antimeridian(std::move(whole));
  std::string out;
  for (const Ring& ring : parts) {
    out +=
        "  <Polygon><tessellate>1</tessellate><altitudeMode>clampToGround</altitudeMode><outerBoundaryIs><LinearRing>"
        "<coordinates>\n";
    for (const MapPoint& p : ring) out += "   " + coordinates_of(p) + "\n";
    out += "  </coordinates></LinearRing></outerBoundaryIs></Polygon>\n";
  }
  return parts.size() == 1 ? out : "  <MultiGeometry>\n" + out + "  </MultiGeometry>\n";
}

std::string kml_style(const char* id, const char* line, const char* fill) {
  return std::string(" <Style id=\"") + id + "\"><LineStyle><color>" + line +
         "</color><width>2</width></LineStyle><PolyStyle><color>" + fill + "</color></PolyStyle></Style>\n";
}

/// Shots as one place with many points, so that globes do not label each.
std::string kml_shots(const Ground& ground, const StudyPlan& plan) {
  const StudyShots shots = fly_shots_of(plan, 0);
  std::string points = "  <MultiGeometry>\n";
  for (std::size_t i = 0; i < std::min(kMapShots, shots.quantities[0].size()); ++i) {
    const PlanePoint at{shots.quantities[0][i], shots.quantities[1][i]};
    if (std::isfinite(at.right) && std::isfinite(at.up)) points += kml_point(ground.place_of(at));
  }
  return kml_place("shots", points + "  </MultiGeometry>\n", "shots");
}

Status check_map(const AskedShot& asked, const Study& study, const Flight& flight) {
  if (study.until.range || study.quantities.size() < 2 || study.quantities[0] != StudyQuantity::right ||
      study.quantities[1] != StudyQuantity::along)
    return Error{.message = "a map is of shots that come down on the ground",
                 .place = asked.scenario.file,
                 .hint = "leave until.range and study.quantities out"};
  if (flight.error()) return *flight.error();
  return check_round(flight.fidelity_in_use().fidelity.earth, asked.shot().projectile.name, asked.scenario);
}

}  // namespace

Result<Text> study_kml(const AskedShot& asked, const FlownStudy& flown) {
  const Study& study = flown.plan.study();
  const Flight flight =
      fly(study.projectile, study.launch, study.environment, study.fidelity, study.tolerance, study.until);
  if (Status status = check_map(asked, study, flight); !status) return status.error();
  PHYSIM_ASSERT(flown.result.ellipse.has_value());
  const Ground ground(study, flight);
  const EllipseResult& ellipse = *flown.result.ellipse;
  std::string out = kml_begin(title_of_shot(asked), asked.scenario.source);
  out += kml_style("ellipse", "ff0000ff", "260000ff") + kml_style("zone", "ff303030", "1a303030") +
         kml_style("target", "ffb27200", "40b27200") +
         " <Style id=\"shots\"><IconStyle><scale>0.3</scale></IconStyle></Style>\n";
  out += kml_place("launch", kml_point(ground.place_of(study.launch.position))) +
         kml_place("mean impact", kml_point(ground.place_of(PlanePoint{ellipse.right, ellipse.up})));
  for (const StudyTarget& target : study.targets)
    if (!std::holds_alternative<ThingTarget>(target.shape))
      out += kml_place(target.name, kml_ring(ground, rim_of(target)), "target");
  for (int deviations = 1; deviations <= 3; ++deviations)
    out += kml_place(std::to_string(deviations) + (deviations == 1 ? " deviation" : " deviations"),
                     kml_ring(ground, rim_of(ellipse, deviations)), "ellipse");
  if (flown.result.zone) {
    std::vector<PlanePoint> rim = flown.result.zone->corners;
    rim.push_back(rim.front());
    out += kml_place("zone that holds " + significant(100 * flown.result.zone->holds, 7) + " %, 95 % sure",
                     kml_ring(ground, rim), "zone");
  }
  out += kml_shots(ground, flown.plan) + kml_end();
  return Text([out](const Sink& sink) { sink(out); });
}

}  // namespace physim::report
