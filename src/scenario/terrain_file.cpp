// The only file that knows GDAL.
#include "physim/scenario.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/libraries.hpp"
#include "scenario/text_file.hpp"
#include "settings/units.hpp"

#if PHYSIM_HAS_GDAL
#include <dlfcn.h>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <gdalwarper.h>
#include <ogr_srs_api.h>
#endif

namespace physim {

bool reads_terrain_files() { return PHYSIM_HAS_GDAL != 0; }

#if PHYSIM_HAS_GDAL

namespace {

// clang-format off
#define PHYSIM_GDAL_FUNCTIONS(F) \
  F(CPLGetLastErrorMsg) F(CPLPopErrorHandler) F(CPLPushErrorHandler) F(CPLQuietErrorHandler) F(CSLDestroy) \
  F(GDALAllRegister) F(GDALAutoCreateWarpedVRT) F(GDALClose) F(GDALCreate) F(GDALFillRaster) \
  F(GDALGetDatasetDriver) F(GDALGetDriverByName) F(GDALGetDriverShortName) F(GDALGetFileList) \
  F(GDALGetGeoTransform) F(GDALGetMaskBand) F(GDALGetRasterBand) F(GDALGetRasterColorInterpretation) \
  F(GDALGetRasterCount) F(GDALGetRasterNoDataValue) F(GDALGetRasterOffset) F(GDALGetRasterScale) \
  F(GDALGetRasterUnitType) F(GDALGetRasterXSize) F(GDALGetRasterYSize) F(GDALGetSpatialRef) F(GDALOpenEx) \
  F(GDALRasterIO) F(GDALReprojectImage) F(GDALSetGeoTransform) F(GDALSetRasterNoDataValue) \
  F(GDALSetSpatialRef) F(OCTDestroyCoordinateTransformation) F(OCTNewCoordinateTransformation) F(OCTTransform) \
  F(OSRDestroySpatialReference) F(OSRExportToWkt) F(OSRIsGeographic) F(OSRNewSpatialReference) \
  F(OSRSetAxisMappingStrategy) F(OSRSetWellKnownGeogCS) F(VSIFree)
// clang-format on

/// What is used of GDAL. It is loaded when the first file of terrain is read: with all that it needs it is a hundred
/// libraries, which would make every start of a program 40 ms longer.
struct Gdal {
#define PHYSIM_GDAL_MEMBER(name) decltype(&::name) name = nullptr;
  PHYSIM_GDAL_FUNCTIONS(PHYSIM_GDAL_MEMBER)
#undef PHYSIM_GDAL_MEMBER
  std::string fault{};  // why it is not there; empty: it is

  Gdal() {
    void* const library = dlopen(PHYSIM_GDAL_FILE, RTLD_NOW | RTLD_LOCAL);
    if (!library) {
      fault = dlerror();
      return;
    }
    const auto find = [&]<class F>(F& function, const char* name) {
      function = std::bit_cast<F>(dlsym(library, name));
      if (!function) fault = std::string(PHYSIM_GDAL_FILE) + " has no " + name;
    };
#define PHYSIM_FIND(name) find(name, #name);
    PHYSIM_GDAL_FUNCTIONS(PHYSIM_FIND)
#undef PHYSIM_FIND
  }
};
const Gdal& gdal() {
  static const Gdal loaded;
  return loaded;
}

constexpr double kDegree = 3.141592653589793 / 180;  // [rad]
constexpr double kEarthRadius = 6371008.8;           // the mean one: how far about a place counts by it [m]
constexpr double kMostPoints = 2e7, kMostWarped = 1e8;
constexpr double kNoHeight = -1e30;                   // where another projection has no height
constexpr double kDeepest = -12e3, kHighest = 9.2e3;  // the Mariana Trench, Mount Everest, and room [m]
constexpr double kSamePlace = 1e-6;                   // 0.1 m: frames that differ by less are one [degrees]

struct Close {
  void operator()(void* dataset) const { gdal().GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

/// What GDAL says goes into our errors instead of the terminal.
class Quiet {
 public:
  Quiet() { gdal().CPLPushErrorHandler(gdal().CPLQuietErrorHandler); }
  ~Quiet() { gdal().CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  [[nodiscard]] static std::string words() {
    const std::string text = gdal().CPLGetLastErrorMsg();
    return text.empty() ? "GDAL does not say why" : text;
  }
};

Status check(const TerrainCut& cut) {
  Checker c;
  c.require(std::abs(cut.latitude) <= 90.0001 * kDegree, "latitude", "must lie between the poles");
  c.require(std::abs(cut.longitude) <= 180.0001 * kDegree, "longitude", "must lie between -180 and 180 degrees");
  c.require(cut.reach > 0, "reach", "must be above 0 m", "leave it out for all that the file has");
  c.require(cut.every >= 1, "every", "must be at least 1", "1 takes every point");
  c.require(std::abs(cut.geoid) <= 200, "geoid", "must lie within 200 m",
            "sea level is -107 to 86 m off the ellipsoid");
  if (cut.missing) c.require(std::abs(*cut.missing) <= 1e5, "missing", "must be a number within 1e5 m");
  return c.status();
}

/// Where points of a raster lie, on an axis: the first one, and how far the next one is. Degrees.
struct Axis {
  double first = 0;
  double step = 0;
  int count = 0;
};

/// Those points of an axis that are taken.
struct Span {
  int first = 0;
  int count = 0;
};

/// All within `half` of a middle, widened to whole cells. `around`: how many columns are once around the Earth, so that
/// the span may go over the end of the axis; 0: it ends there.
Span cut_of(const Axis& axis, double middle, double half, int around) {
  PHYSIM_ASSERT(axis.step != 0 && axis.count > 0);
  const double one = (middle - half - axis.first) / axis.step, other = (middle + half - axis.first) / axis.step;
  const double low = std::floor(std::min(one, other)), high = std::ceil(std::max(one, other));
  if (around > 0 && high - low < around && (low < 0 || high >= axis.count))
    return {static_cast<int>(low), static_cast<int>(high - low) + 1};
  const double last = axis.count - 1.0;
  const double from = std::clamp(low, 0.0, last), to = std::clamp(high, 0.0, last);
  return {static_cast<int>(from), static_cast<int>(to - from) + 1};
}

std::string by(int wide, int high) { return std::to_string(wide) + " by " + std::to_string(high); }
std::string degrees(double from, double to) { return std::to_string(from) + " to " + std::to_string(to); }

/// A raster with its geometry, on axes of latitude and longitude.
class Raster {
 public:
  static Result<Raster> open(const std::string& file) {
    // Names that are no files mean places on the web and more to GDAL. It reads of large files what it needs.
    constexpr std::uintmax_t kAnySize = ~std::uintmax_t{0};
    if (const Status status = check_file(file, kAnySize, "file of terrain"); !status) return status.error();
    gdal().GDALAllRegister();
    Raster raster(file);
    raster.file_ = opened(file, nullptr);
    if (raster.file_ && raster.is_text_grid()) {
      // Whole numbers would be read as integers, and "nan" among them as 0.
      constexpr const char* kAsDoubles[] = {"DATATYPE=Float64", nullptr};
      raster.file_ = opened(file, kAsDoubles);
    }
    if (!raster.file_) return Error{"it is no terrain: " + Quiet::words(), file, "GeoTIFF and .hgt are read, and more"};
    if (Status begun = raster.begin_reading_companions(); !begun) return begun.error();
    if (gdal().GDALGetRasterCount(raster.file_.get()) < 1) return Error{"it holds no raster", file, ""};
    const OGRSpatialReferenceH projection = gdal().GDALGetSpatialRef(raster.file_.get());
    if (!projection) return Error{"it does not say where on the Earth it lies", file, "gdal_edit.py -a_srs adds that"};
    raster.use(raster.file_.get());
    if (int says_so = 0; raster.is_text_grid()) {
      constexpr double kNothingOfFormat = -9999;  // of a grid without NODATA_value
      gdal().GDALGetRasterNoDataValue(raster.band_, &says_so);
      if (says_so == 0) raster.nothing_ = kNothingOfFormat;
    }
    if (const Status status = raster.take_unit(); !status) return status.error();
    if (!raster.is_upright_ || !raster.lies_in_wgs84(projection))
      if (const Status status = raster.warp(projection); !status) return status.error();
    return raster;
  }

  [[nodiscard]] Result<GeodeticGrid> read(const TerrainCut& cut) const {
    const double half = cut.reach / kEarthRadius / kDegree;
    const double wide = half / std::max(std::cos(cut.latitude), 1e-6);
    const double latitude = cut.latitude / kDegree, longitude = turned_towards(cut.longitude / kDegree);
    const bool is_beside = latitude + half < south() || latitude - half > north() ||
                           (around() == 0 && (longitude + wide < west() || longitude - wide > east()));
    if (is_beside) {
      const std::string has = "it has latitudes of " + degrees(south(), north()) + " and longitudes of " +
                              degrees(west(), east()) + " degrees";
      return Error{"it has nothing about " + std::to_string(latitude) + ", " + std::to_string(longitude), file_name_,
                   has};
    }
    return read(cut_of(columns_, longitude, wide, around()), cut_of(rows_, latitude, half, 0), cut);
  }

 private:
  explicit Raster(std::string file) : file_name_(std::move(file)) {}

  static Dataset opened(const std::string& file, const char* const* options) {
    return Dataset(gdal().GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, options, nullptr));
  }
  /// Whether it is an ASCII grid of Esri (.asc).
  [[nodiscard]] bool is_text_grid() const {
    const GDALDriverH driver = gdal().GDALGetDatasetDriver(file_.get());
    return driver != nullptr && std::string_view(gdal().GDALGetDriverShortName(driver)) == "AAIGrid";
  }

  /// Files that GDAL reads beside the file: projections, masks, parts of a mosaic.
  [[nodiscard]] Status begin_reading_companions() const {
    char** const list = gdal().GDALGetFileList(file_.get());
    Status status;
    for (char** each = list; each != nullptr && *each != nullptr && status; ++each)
      status = begin_reading(*each, "terrain");
    gdal().CSLDestroy(list);
    return status;
  }

  void use(GDALDatasetH dataset) {
    std::array<double, 6> at{};
    gdal().GDALGetGeoTransform(dataset, at.data());
    is_upright_ = at[1] > 0 && at[5] < 0 && at[2] == 0 && at[4] == 0;
    // Points are the middles of cells.
    columns_ = {at[0] + at[1] / 2, at[1], gdal().GDALGetRasterXSize(dataset)};
    rows_ = {at[3] + at[5] / 2, at[5], gdal().GDALGetRasterYSize(dataset)};
    band_ = gdal().GDALGetRasterBand(dataset, 1);
    alpha_ = nullptr;  // GDALGetMaskBand() sees alpha bands of bytes and 16 bits alone
    for (int i = 2; i <= gdal().GDALGetRasterCount(dataset); ++i)
      if (const GDALRasterBandH band = gdal().GDALGetRasterBand(dataset, i);
          gdal().GDALGetRasterColorInterpretation(band) == GCI_AlphaBand)
        alpha_ = band;
  }

  [[nodiscard]] Error refused() const {
    return Error{"it cannot be brought to latitude and longitude: " + Quiet::words(), file_name_, ""};
  }

  /// Whether latitudes and longitudes are those of WGS 84, in degrees: NAD83 and ETRS89 are within a metre, the datum
  /// of Tokyo is 450 m off, and some count in grads from Paris.
  [[nodiscard]] bool lies_in_wgs84(OGRSpatialReferenceH projection) const {
    if (!gdal().OSRIsGeographic(projection)) return false;
    const OGRSpatialReferenceH there = new_wgs84();
    const OGRCoordinateTransformationH transform = gdal().OCTNewCoordinateTransformation(projection, there);
    bool is_same = transform != nullptr;
    for (const double x : {west(), east()})
      for (const double y : {south(), north()}) {
        if (std::abs(y) > 89.9) continue;  // a longitude means nothing at a pole
        double longitude = x, latitude = y;
        is_same = is_same && gdal().OCTTransform(transform, 1, &longitude, &latitude, nullptr) != 0 &&
                  std::abs(within_half_turn(longitude - x)) < kSamePlace && std::abs(latitude - y) < kSamePlace;
      }
    if (transform) gdal().OCTDestroyCoordinateTransformation(transform);
    gdal().OSRDestroySpatialReference(there);
    return is_same;
  }

  /// A raster in memory where another projection is worked on; kNoHeight is nothing.
  [[nodiscard]] Result<Dataset> in_memory(int wide, int high, std::array<double, 6> at) const {
    if (static_cast<double>(wide) * high > kMostWarped)
      return Error{"has " + by(wide, high) + " points in another projection", file_name_,
                   "at most 1e8 are brought to latitude and longitude: gdalwarp -t_srs EPSG:4326 does it"};
    Dataset made(gdal().GDALCreate(gdal().GDALGetDriverByName("MEM"), "", wide, high, 1, GDT_Float64, nullptr));
    if (!made || gdal().GDALSetGeoTransform(made.get(), at.data()) != CE_None) return refused();
    gdal().GDALSetRasterNoDataValue(gdal().GDALGetRasterBand(made.get(), 1), kNoHeight);
    return made;
  }

  /// A copy of the file in memory: heights in metres, kNoHeight where there is none. The warper sees masks of some
  /// kinds alone.
  Result<Dataset> clean_copy(OGRSpatialReferenceH projection) const {
    const int wide = columns_.count, high = rows_.count;
    std::array<double, 6> at{};
    gdal().GDALGetGeoTransform(file_.get(), at.data());
    Result<Dataset> copy = in_memory(wide, high, at);
    if (!copy) return copy;
    if (gdal().GDALSetSpatialRef(copy->get(), projection) != CE_None) return refused();
    const GDALRasterBandH band = gdal().GDALGetRasterBand(copy->get(), 1);
    Line line(wide);
    for (int row = 0; row < high; ++row) {
      if (const Status status = read(0, row, wide, 0, line); !status) return status.error();
      for (double& height : line.heights)
        if (!std::isfinite(height)) height = kNoHeight;
      if (gdal().GDALRasterIO(band, GF_Write, 0, row, wide, 1, line.heights.data(), wide, 1, GDT_Float64, 0, 0) !=
          CE_None)
        return refused();
    }
    return copy;
  }

  /// Another frame is brought to latitude and longitude; where the file has nothing, there is nothing.
  Status warp(OGRSpatialReferenceH projection) {
    Result<Dataset> clean = clean_copy(projection);
    if (!clean) return clean.error();
    const Dataset copy = std::move(*clean);
    const Dataset plan(gdal().GDALAutoCreateWarpedVRT(copy.get(), nullptr, wgs84().c_str(), GRA_Bilinear, 0, nullptr));
    if (!plan) return refused();
    // GDAL keeps the diagonal of cells. Neither side may be longer than that of the file: its bilinear interpolation is
    // none where points are left out.
    const int wide = finer(gdal().GDALGetRasterXSize(plan.get())), high = finer(gdal().GDALGetRasterYSize(plan.get()));
    std::array<double, 6> at{};
    gdal().GDALGetGeoTransform(plan.get(), at.data());
    at[1] *= static_cast<double>(gdal().GDALGetRasterXSize(plan.get())) / wide;
    at[5] *= static_cast<double>(gdal().GDALGetRasterYSize(plan.get())) / high;
    Result<Dataset> warped = in_memory(wide, high, at);
    if (!warped) return warped.error();
    warped_ = std::move(*warped);
    gdal().GDALFillRaster(gdal().GDALGetRasterBand(warped_.get(), 1), kNoHeight, 0);
    if (gdal().GDALReprojectImage(copy.get(), nullptr, warped_.get(), wgs84().c_str(), GRA_Bilinear, 0, 0, nullptr,
                                  nullptr, nullptr) != CE_None)
      return refused();
    unit_ = {};
    nothing_.reset();
    use(warped_.get());
    return {};
  }
  static int finer(int count) { return static_cast<int>(std::ceil(count * 1.4142135623730951)); }
  static OGRSpatialReferenceH new_wgs84() {
    const OGRSpatialReferenceH frame = gdal().OSRNewSpatialReference(nullptr);
    gdal().OSRSetWellKnownGeogCS(frame, "WGS84");
    gdal().OSRSetAxisMappingStrategy(frame, OAMS_TRADITIONAL_GIS_ORDER);
    return frame;
  }
  static std::string wgs84() {
    const OGRSpatialReferenceH frame = new_wgs84();
    char* text = nullptr;
    gdal().OSRExportToWkt(frame, &text);
    const std::string wkt = text ? text : "";
    gdal().VSIFree(text);
    gdal().OSRDestroySpatialReference(frame);
    return wkt;
  }

  [[nodiscard]] Result<GeodeticGrid> read(const Span& columns, const Span& rows, const TerrainCut& cut) const {
    const int every = static_cast<int>(std::min(cut.every, 1u << 30));
    const int wide = (columns.count - 1) / every + 1, high = (rows.count - 1) / every + 1;
    if (wide < 2 || high < 2) return Error{"two points of it at least are needed each way", file_name_, ""};
    if (static_cast<double>(wide) * high > kMostPoints)
      return Error{"has " + by(wide, high) + " points there", file_name_,
                   "at most 2e7 are read: give a smaller reach, or take every second point"};
    GeodeticGrid grid;
    grid.columns = static_cast<std::uint32_t>(wide);
    grid.rows = static_cast<std::uint32_t>(high);
    grid.heights.resize(std::size_t{grid.columns} * grid.rows);
    Line line(columns.count);
    for (int row = 0; row < high; ++row) {
      const int of_file = rows.first + (high - 1 - row) * every;  // rows of the grid go northwards
      if (const Status status = read_around(columns, of_file, line); !status) return status.error();
      for (int i = 0; i < wide; ++i) {
        double height = line.heights[static_cast<std::size_t>(i * every)];
        const bool is_impossible = !(height >= kDeepest && height <= kHighest);  // or NaN
        if (is_impossible && !cut.missing) return without_height(columns.first + i * every, of_file, height);
        if (is_impossible && !std::isnan(height) && grid.impossible++ == 0) grid.impossible_height = height;
        if (is_impossible) height = *cut.missing;
        grid.heights[static_cast<std::size_t>(row) * grid.columns + static_cast<std::size_t>(i)] = height + cut.geoid;
      }
    }
    grid.longitude = within_half_turn(columns_.first + columns.first * columns_.step) * kDegree;
    grid.latitude = (rows_.first + (rows.first + (high - 1) * every) * rows_.step) * kDegree;
    grid.longitude_step = columns_.step * every * kDegree;
    grid.latitude_step = -rows_.step * every * kDegree;
    return grid;
  }

  /// Part of a row: heights in metres, NaN where there is none.
  struct Line {
    explicit Line(int count) : heights(static_cast<std::size_t>(count)), there(heights.size()) {}
    std::vector<double> heights;
    std::vector<double> there;  // of a mask: 0 where there is nothing
  };

  /// Reads `count` points from a column on to `into` and behind. A point that the file's number for nothing, its mask
  /// or its alpha band leaves out has no height.
  [[nodiscard]] Status read(int column, int row, int count, int into, Line& line) const {
    const auto take = [&](GDALRasterBandH band, double* to) -> Status {
      if (gdal().GDALRasterIO(band, GF_Read, column, row, count, 1, to, count, 1, GDT_Float64, 0, 0) == CE_None)
        return {};
      return Error{"the file is damaged: " + Quiet::words(), file_name_, ""};
    };
    double* const heights = line.heights.data() + into;
    double* const there = line.there.data() + into;
    if (Status status = take(band_, heights); !status) return status;
    for (int i = 0; i < count; ++i)
      heights[i] =
          heights[i] == nothing_ ? std::numeric_limits<double>::quiet_NaN() : heights[i] * unit_.scale + unit_.offset;
    for (const GDALRasterBandH mask : {gdal().GDALGetMaskBand(band_), alpha_}) {
      if (mask == nullptr) continue;
      if (Status status = take(mask, there); !status) return status;
      for (int i = 0; i < count; ++i)
        if (there[i] == 0) heights[i] = std::numeric_limits<double>::quiet_NaN();
    }
    return {};
  }

  /// Reads a row of a span that may go over the end of the axis.
  [[nodiscard]] Status read_around(const Span& columns, int row, Line& line) const {
    for (int done = 0; done < columns.count;) {
      int column = columns.first + done;
      if (const int whole = around(); whole > 0) column = ((column % whole) + whole) % whole;
      const int count = std::min(columns.count - done, columns_.count - column);
      if (Status status = read(column, row, count, done, line); !status) return status;
      done += count;
    }
    return {};
  }

  [[nodiscard]] Error without_height(int column, int row, double height) const {
    const double longitude = within_half_turn(columns_.first + column * columns_.step);
    const std::string where =
        warped_ ? "" : "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) + ": ";
    const std::string what = std::isnan(height)
                                 ? "has points without a height: "
                                 : "has points with a height of " + number_text(height) + " m, which no ground has: ";
    return Error{what + where + "latitude " + std::to_string(rows_.first + row * rows_.step) + ", longitude " +
                     std::to_string(longitude),
                 file_name_, "say which one they get, 0 for the sea; or give a smaller reach"};
  }

  /// Metres of what the file holds.
  struct Unit {
    double scale = 1;
    double offset = 0;
  };
  [[nodiscard]] Status take_unit() {
    constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937;
    struct Length {
      double metres;
      std::vector<std::string_view> names;
    };
    static const Length kUnits[] = {
        {1, {"", "m", "metre", "meter", "metres", "meters"}},
        {1e-3, {"mm"}},
        {1e-2, {"cm"}},
        {0.1, {"dm"}},
        {1e3, {"km"}},
        {kFoot, {"ft", "foot", "feet", "international foot"}},
        {0.9144, {"yd"}},
        {1.8288, {"fathom", "fathoms"}},
        {kSurveyFoot, {"us-ft", "ftus", "us survey foot", "us_survey_foot", "us survey feet", "us foot", "sft"}}};
    const std::string said = gdal().GDALGetRasterUnitType(band_);
    std::string name = said;
    for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    const auto* const unit =
        std::ranges::find_if(kUnits, [&](const Length& each) { return std::ranges::count(each.names, name) > 0; });
    if (unit == std::end(kUnits))
      return Error{"its heights are in \"" + said + "\", which is no unit of length here", file_name_,
                   "m, dm, cm, mm, km, ft, us-ft, yd and fathom are: gdal_edit.py -units sets it"};
    int has_scale = 0, has_offset = 0;
    const double scale = gdal().GDALGetRasterScale(band_, &has_scale),
                 offset = gdal().GDALGetRasterOffset(band_, &has_offset);
    unit_ = {(has_scale != 0 ? scale : 1) * unit->metres, (has_offset != 0 ? offset : 0) * unit->metres};
    return {};
  }

  /// How many columns are once around the Earth, if the file has all of them; else 0.
  [[nodiscard]] int around() const {
    const double whole = std::round(360 / columns_.step);
    const bool is_whole = std::abs(whole * columns_.step - 360) < 1e-3 * columns_.step;
    return is_whole && columns_.count >= whole ? static_cast<int>(whole) : 0;
  }

  static double end(const Axis& axis) { return axis.first + (axis.count - 1) * axis.step; }
  [[nodiscard]] double south() const { return end(rows_); }
  [[nodiscard]] double north() const { return rows_.first; }
  [[nodiscard]] double west() const { return columns_.first; }
  [[nodiscard]] double east() const { return end(columns_); }

  /// A longitude as the raster counts it: some go from 0 to 360 degrees.
  [[nodiscard]] double turned_towards(double longitude) const {
    const double middle = (west() + east()) / 2;
    return longitude + 360 * std::round((middle - longitude) / 360);
  }
  static double within_half_turn(double longitude) { return longitude - 360 * std::round(longitude / 360); }

  std::string file_name_;
  Dataset file_{};
  Dataset warped_{};  // goes before the file that it reads
  GDALRasterBandH band_ = nullptr;
  GDALRasterBandH alpha_ = nullptr;  // null: there is none
  Axis columns_{}, rows_{};
  Unit unit_{};
  std::optional<double> nothing_{};  // a number that means no height, which GDAL does not know of
  bool is_upright_ = false;          // columns go east and rows south
};

}  // namespace

Result<GeodeticGrid> read_terrain_file(const std::string& file, const TerrainCut& cut) {
  const IeeeMode mode;
  if (const Status status = check(cut); !status) return status.error();
  if (!gdal().fault.empty()) return Error{"GDAL cannot be loaded: " + gdal().fault, file, "install libgdal-dev again"};
  const Quiet quiet;
  const Result<Raster> raster = Raster::open(file);
  if (!raster) return raster.error();
  return raster->read(cut);
}

#else

Result<GeodeticGrid> read_terrain_file(const std::string& file, const TerrainCut&) {
  return Error{"this build reads no terrain from files", file,
               "build it with GDAL (libgdal-dev), or write heights into the scenario"};
}

#endif

}  // namespace physim
