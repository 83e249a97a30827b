#include "report/kml.hpp"

#include "report/number.hpp"

namespace physim::report {

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
