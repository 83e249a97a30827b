#include "report/kml.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "report/number.hpp"

namespace physim::report {
namespace {

/// The part of a ring on the side of a meridian where `side` times the longitude is larger.
Ring on_one_side(const Ring& ring, double meridian, double side) {
  const auto is_in = [&](const MapPoint& p) { return side * (p.longitude - meridian) >= 0; };
  Ring part;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const MapPoint &a = ring[i], &b = ring[i + 1];
    if (is_in(a)) part.push_back(a);
    if (is_in(a) == is_in(b) || a.longitude == meridian || b.longitude == meridian) continue;
    const double share = (meridian - a.longitude) / (b.longitude - a.longitude);
    part.push_back({meridian, a.latitude + share * (b.latitude - a.latitude)});
  }
  if (!part.empty()) part.push_back(part.front());
  return part;
}

}  // namespace

std::vector<Ring> cut_at_antimeridian(Ring ring) {
  constexpr double kTurn = 360, kHalf = 180, kPole = 90;
  constexpr std::size_t kLeast = 4;  // of a triangle that ends where it begins
  if (ring.size() < kLeast) return {std::move(ring)};
  for (std::size_t i = 1; i < ring.size(); ++i)  // without jumps, beyond the edges of the map where need be
    ring[i].longitude += kTurn * std::round((ring[i - 1].longitude - ring[i].longitude) / kTurn);
  if (std::abs(ring.back().longitude - ring.front().longitude) > kHalf) {
    const double pole = ring.front().latitude > 0 ? kPole : -kPole;
    const MapPoint first = ring.front(), last = ring.back();
    ring.insert(ring.end(), {{last.longitude, pole}, {first.longitude, pole}, first});
  }
  const auto [west, east] = std::ranges::minmax(ring, {}, &MapPoint::longitude);
  PHYSIM_ASSERT(east.longitude - west.longitude < 2 * kTurn);
  std::vector<Ring> parts;
  for (double turn = std::floor((west.longitude + kHalf) / kTurn); turn * kTurn - kHalf < east.longitude; ++turn) {
    const double middle = turn * kTurn;
    Ring part = on_one_side(on_one_side(ring, middle - kHalf, 1), middle + kHalf, -1);
    for (MapPoint& p : part) p.longitude -= middle;
    if (part.size() >= kLeast) parts.push_back(std::move(part));
  }
  return parts;
}

std::string xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    if (!is_control) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return out;
}

std::string kml_coordinates(double longitude, double latitude, double height) {
  return shortest(longitude) + "," + shortest(latitude) + "," + shortest(height);
}

std::string kml_begin(const std::string& name, const std::string& description) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n "
         "<name>" +
         xml(name) + "</name>\n <description>" + xml(description) + "</description>\n";
}

std::string kml_end() { return "</Document>\n</kml>\n"; }

}  // namespace physim::report
