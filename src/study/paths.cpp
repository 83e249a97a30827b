#include "study/paths.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "model/standard_atmosphere.hpp"
#include "physim/study.hpp"
#include "settings/environment_rows.hpp"
#include "settings/shot_rows.hpp"

namespace physim {
namespace {

using namespace setting_rows;

// ------------------------------------------------------------------------------------------------- where numbers are
template <class Owner>
Owner& owner_in(Shot* shot, Environment* place) {
  PHYSIM_ASSERT(std::is_same_v<Owner, Environment> ? place != nullptr : shot != nullptr);
  if constexpr (std::is_same_v<Owner, ProjectileDef>)
    return shot->projectile;
  else if constexpr (std::is_same_v<Owner, Launch>)
    return shot->launch;
  else
    return *place;
}

template <std::size_t axis>
double* part_of(double& number) {
  return &number;
}
template <std::size_t axis>
double* part_of(Vec3d& v) {
  return axis == 0 ? &v.x : axis == 1 ? &v.y : &v.z;
}
/// The air is known where no station measures it, too: see air_there().
template <std::size_t axis>
double* part_of(std::optional<double>&) {
  return nullptr;
}

/// Whether a drag curve is of a table that is not read.
bool is_unread(const ProjectileDef& projectile, const std::vector<DragPoint>& curve) {
  return &curve == &projectile.drag.curve && projectile.drag.table != DragTable::custom;
}
bool is_unread(const auto&, const auto&) { return false; }

// -------------------------------------------------------------------------------------------------------------- paths
template <std::size_t i>
using Index = std::integral_constant<std::size_t, i>;

/// Calls f with each index of a tuple.
template <class Tuple>
void for_each_index(const Tuple&, const auto& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(Index<i>()), ...); }
  (std::make_index_sequence<std::tuple_size_v<Tuple>>());
}

/// Calls f with the components of a member of type T: the number itself is one.
template <class T>
void for_each_component(const auto& f) {
  if constexpr (std::is_same_v<T, Vec3d>)
    f(Index<0>(), ".x"), f(Index<1>(), ".y"), f(Index<2>(), ".z");
  else
    f(Index<0>(), "");
}

template <class T>
inline constexpr bool kIsList = requires {
  typename T::iterator;
};

class PathList {
 public:
  /// Adds all numbers that are no points of lists, and factors of such points.
  template <class Owner, const auto& rows>
  void add_numbers(const std::string& head) {
    for_each_index(rows, [&]<std::size_t i>(Index<i>) {
      static constexpr auto& row = std::get<i>(rows);
      using Member = std::decay_t<decltype(row.get(std::declval<Owner&>()))>;
      const std::string path = head + std::string(row.path);
      if constexpr (row.uncertain && !kIsList<Member>)
        for_each_component<Member>([&]<std::size_t axis>(Index<axis>, const char* component) {
          add(path + component, row.doc, row, [](Shot* shot, Environment* place, std::size_t) {
            return part_of<axis>(row.get(owner_in<Owner>(shot, place)));
          });
          list_.back().launches = row.launch_columns[axis], list_.back().weather = row.weather_columns[axis];
        });
      if constexpr (row.by_factor) {
        add(path, "times the values of all points", row, nullptr);
        list_.back().unit = "-", list_.back().above_zero = true;
        list_.back().scale = [](Shot& shot, double factor) {
          for (auto& point : row.get(shot.projectile)) std::get<1>(kItemRows<rows, i>).get(point) *= factor;
        };
      }
    });
  }
  /// Adds the points of all lists: first their values, then what these depend on.
  template <class Owner, const auto& rows>
  void add_points(const std::string& head) {
    for_each_index(rows, [&]<std::size_t i>(Index<i>) {
      ++lists_;
      for (const bool keys : {false, true})
        for_each_index(kItemRows<rows, i>, [&]<std::size_t k>(Index<k>) {
          if (std::get<k>(kItemRows<rows, i>).is_key == keys) add_point<Owner, rows, i, k>(head);
        });
    });
  }
  void add_wind_by_compass() {
    add("environment.wind.speed", "of the air along the ground, by compass with wind.from",
        {.quantity = Quantity::speed}, nullptr);
    list_.back().compass = CompassWind::speed;
    add("environment.wind.from", "where the wind comes from, clockwise from north; see earth.azimuth",
        {.quantity = Quantity::angle}, nullptr);
    list_.back().compass = CompassWind::from;
  }
  [[nodiscard]] std::vector<PathRow> rows() && { return std::move(list_); }

 private:
  using Find = double* (*)(Shot*, Environment*, std::size_t);

  void add(std::string path, std::string_view about, const SettingRow& row, Find find) {
    PHYSIM_ASSERT(!path.empty() && !about.empty());
    PathRow& added = list_.emplace_back();
    added.is_of_environment = path.starts_with("environment.");
    added.is_wind = path.starts_with("environment.wind.");
    added.path = std::move(path), added.about = about;
    added.unit = unit_of(row).empty() ? "-" : unit_of(row);
    added.above_zero = row.is_above_zero();
    added.find = find;
  }
  template <class Owner, const auto& rows, std::size_t i, std::size_t k>
  void add_point(const std::string& head) {
    static constexpr auto& row = std::get<i>(rows);
    static constexpr auto& item = std::get<k>(kItemRows<rows, i>);
    using Item = typename std::decay_t<decltype(row.get(std::declval<Owner&>()))>::value_type;
    const std::string path = head + std::string(row.path) + (item.path.empty() ? ".N" : ".N.") + std::string(item.path);
    for_each_component<std::decay_t<decltype(item.get(std::declval<Item&>()))>>(
        [&]<std::size_t axis>(Index<axis>, const char* component) {
          add(path + component, item.doc, item, [](Shot* shot, Environment* place, std::size_t point) -> double* {
            auto& owner = owner_in<Owner>(shot, place);
            auto& list = row.get(owner);
            return point < list.size() && !is_unread(owner, list) ? part_of<axis>(item.get(list[point])) : nullptr;
          });
          list_.back().about.append(", of a point: ").append(row.doc);
          list_.back().is_place = item.is_place, list_.back().list = lists_;
        });
  }

  std::vector<PathRow> list_;
  std::size_t lists_ = 0;
};

/// The order decides which draws a number gets that a scenario makes uncertain in its place: it must not change.
std::vector<PathRow> make_paths() {
  PathList paths;
  paths.add_numbers<Launch, kLaunchRows>("shot.");
  paths.add_numbers<Launch, kMuzzleRows>("shot.");
  paths.add_numbers<Environment, kWindRows>("environment.");
  paths.add_wind_by_compass();
  paths.add_numbers<Environment, kAirRows>("environment.");
  paths.add_numbers<Environment, kGroundRows>("environment.");
  paths.add_numbers<Environment, kScaleHeightRows>("environment.");
  paths.add_numbers<Environment, kEarthRows>("environment.");
  paths.add_numbers<ProjectileDef, kProjectileRows>("shot.");
  paths.add_numbers<ProjectileDef, kMagnusRows>("shot.");
  paths.add_numbers<ProjectileDef, kInertiaRows>("shot.");
  paths.add_numbers<ProjectileDef, kMotorRows>("shot.");
  paths.add_numbers<Launch, kSightRows>("shot.");
  paths.add_numbers<Launch, kAttitudeRows>("shot.");
  paths.add_points<ProjectileDef, kProjectileRows>("shot.");
  paths.add_points<ProjectileDef, kMotorRows>("shot.");
  paths.add_points<ProjectileDef, kMagnusRows>("shot.");
  paths.add_points<ProjectileDef, kAeroRows>("shot.");
  paths.add_points<Environment, kWindRows>("environment.");
  return std::move(paths).rows();
}

/// What a column of the weather has where it is not drawn.
double air_there(const Environment& place, WeatherColumn column) {
  if (column == &Weather::density) return prepare_air_numbers(place, AirModel::constant).density;
  const Readings<double> air = station_air(place);
  if (column == &Weather::temperature) return air.temperature;
  if (column == &Weather::pressure) return air.pressure;
  PHYSIM_ASSERT(column == &Weather::humidity);
  return air.humidity;
}

double wind_there(const Environment& place, CompassWind part) {
  const Vec3d& v = place.wind.velocity;
  return part == CompassWind::speed ? std::sqrt(v.x * v.x + v.z * v.z) : place.earth.azimuth + atan2(-v.z, -v.x);
}

/// Which point a path names by a row with ".N" in it; nothing if it does not match the row.
std::optional<std::size_t> point_named(std::string_view path, const PathRow& row) {
  const std::size_t at = row.path.find(".N");
  PHYSIM_ASSERT(at != row.path.npos);
  const std::string_view whole = row.path, head = whole.substr(0, at + 1), tail = whole.substr(at + 2);
  if (!path.starts_with(head) || !path.ends_with(tail) || path.size() <= head.size() + tail.size()) return std::nullopt;
  const std::string_view digits = path.substr(head.size(), path.size() - head.size() - tail.size());
  if (digits.size() > 1 && digits[0] == '0') return std::nullopt;  // one name for each
  std::size_t point = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), point);
  if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size()) return std::nullopt;
  return point;
}

StudyPath path_of(std::string_view path, const PathRow& row) {
  return {std::string(path), std::string(row.unit), row.about};
}

}  // namespace

double* FoundPath::point_of(Shot& shot, Environment& place) const {
  PHYSIM_ASSERT(row != nullptr && row->is_of_list());
  return point == 0 ? nullptr : row->find(&shot, &place, point - 1);
}

std::size_t FoundPath::points(Shot& shot, Environment& place) const {
  std::size_t count = 0;
  while (FoundPath{row, count + 1}.point_of(shot, place)) ++count;
  return count;
}

bool FoundPath::is(Environment& place, const double& number) const {
  PHYSIM_ASSERT(row != nullptr);
  return row->is_of_place() && row->find(nullptr, &place, point - 1) == &number;
}

double FoundPath::there(Shot shot, Environment place) const {
  PHYSIM_ASSERT(row != nullptr && (!row->is_of_list() || point_of(shot, place)));
  if (row->scale) return 1;
  if (row->compass != CompassWind::none) return wind_there(place, row->compass);
  const double* number = row->find(&shot, &place, point - 1);
  return number ? *number : air_there(place, row->weather);
}

void FoundPath::put(Shot& shot, double number) const {
  if (!row->is_of_environment && !row->scale) *row->find(&shot, nullptr, point - 1) = number;
}

void FoundPath::put(Environment& place, double number) const {
  PHYSIM_ASSERT(row != nullptr && (point > 0 || !row->is_of_list()));
  if (row->is_of_place()) *row->find(nullptr, &place, point - 1) = number;
}

std::span<const PathRow> all_paths() {
  static const std::vector<PathRow> paths = make_paths();
  return paths;
}

const PathRow* find_list(std::string_view path) {
  const auto row = std::ranges::find(all_paths(), path, &PathRow::path);
  return row != all_paths().end() && row->is_of_list() ? &*row : nullptr;
}

Result<const PathRow*> places_of_list(std::string_view path) {
  if (const PathRow* row = find_list(path))
    for (const PathRow& other : all_paths())
      if (other.list == row->list && other.is_place) return &other;
  return Error{"\"" + std::string(path) + "\" is no list of points, each at a place", "list",
               "name one with its N, as study_paths() has it: \"shot.drag.curve.N\""};
}

FoundPath find_path(std::string_view path) {
  for (const PathRow& row : all_paths()) {
    PHYSIM_ASSERT(row.find || row.scale || row.compass != CompassWind::none);
    if (!row.is_of_list() && row.path == path) return {&row, 0};
    if (!row.is_of_list()) continue;
    if (const auto point = point_named(path, row)) return {&row, *point};
  }
  return {};
}

std::vector<StudyPath> study_paths() {
  std::vector<StudyPath> list;
  for (const PathRow& row : all_paths()) list.push_back(path_of(row.path, row));
  return list;
}

std::optional<StudyPath> study_path(std::string_view path) {
  const FoundPath found = find_path(path);
  return found ? std::optional(path_of(path, *found.row)) : std::nullopt;
}

}  // namespace physim
