// What a study comes to: figures with their errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/macros.hpp"
#include "physim/result.hpp"

namespace physim {

/// A number that a flight ends with.
enum class StudyQuantity {
  time,   ///< of flight [s]
  x,      ///< of the end, downrange [m]
  y,      ///< upwards [m]
  z,      ///< to the right [m]
  vx,     ///< velocity at the end [m/s]
  vy,     ///< [m/s]
  vz,     ///< [m/s]
  speed,  ///< at the end [m/s]
  right,  ///< of the line of sight of the shot without uncertainty [m]
  up,     ///< above that line of sight, perpendicular to it [m]
  along,  ///< along it [m]
  // The first impact counts: on a thing of Study::scene that the shot hits, whatever becomes of it then, else on the
  // ground on which it ends. All as the surface sees it: the velocity of a thing in motion is taken off. A shot that
  // meets nothing does not arrive.
  impact_speed,   ///< [m/s]
  obliquity,      ///< between the velocity and the normal into the surface: 0 straight on, pi/2 along it [rad]
  impact_energy,  ///< kinetic, with the mass that it has then [J]
};

PHYSIM_UNORDERED(StudyQuantity)

/// A bar of a histogram.
struct HistogramBar {
  double low = 0;           ///< numbers counted here are not below it [unit of the quantity]
  double high = 0;          ///< numbers counted here are not above it [unit of the quantity]
  std::uint64_t count = 0;  ///< [-]

  bool operator==(const HistogramBar&) const = default;
};

/// Numbers counted in cells: as many bytes for a thousand as for 10^12, and joined without rounding. A cell around x is
/// (1 + |x - centre| / scale) / 256 of the scale wide, or less: so far can a quantile be off.
struct CountedCells {
  double centre = 0;                    ///< [unit of the quantity]
  double scale = 1;                     ///< about a standard deviation [unit of the quantity]
  std::int64_t first = 0;               ///< number of the first cell with a count [-]
  std::vector<std::uint64_t> counts{};  ///< of cells from there on [-]

  /// Numbers counted.
  [[nodiscard]] std::uint64_t count() const;
  /// The number that a part 0 <= p <= 1 lies below, in straight lines within a cell; NaN where there are none [unit].
  [[nodiscard]] double quantile(double p) const;
  /// The part that lies below x [-].
  [[nodiscard]] double part_below(double x) const;
  /// The largest error that quantile() can have near x [unit].
  [[nodiscard]] double error_at(double x) const;
  /// Low edge of cell `first` + i, also for i = counts.size() [unit].
  [[nodiscard]] double edge(std::size_t i) const;
  /// The most bars of a histogram [-].
  static constexpr std::size_t kMostBars = 100'000;
  /// A histogram of `bars` bars, three to kMostBars (fewer count as three, more as so many): one at each end for about
  /// 0.1 % that lie beyond, 0.2 % at most, those between about equally wide. No bar at an end whose outermost cell has
  /// more than that, as where few values are drawn: then all bars are about equally wide there. Ends of bars are edges
  /// of cells, so counts are exact, and widths are to a cell. Fewer bars where cells are wider than they would be; none
  /// where nothing was counted.
  [[nodiscard]] std::vector<HistogramBar> histogram(std::size_t bars) const;

  bool operator==(const CountedCells&) const = default;
};

/// A figure and how well it is known.
struct Estimate {
  double value = 0;  ///< [unit of the figure]
  double error = 0;  ///< standard error; NaN: not known [unit of the figure]

  bool operator==(const Estimate&) const = default;
};

/// One quantity over all shots that arrived.
struct QuantityResult {
  StudyQuantity quantity = StudyQuantity::time;  ///< [-]
  Estimate mean{};                               ///< [unit]
  double deviation = 0;                          ///< [unit]
  double least = 0;                              ///< [unit]
  double most = 0;                               ///< [unit]
  CountedCells cells{};                          ///< quantiles and histograms [-]

  /// It has a variance beyond rounding errors: its deviation is more than 1e-12 of its farthest number.
  [[nodiscard]] bool varies() const;

  bool operator==(const QuantityResult&) const = default;
};

/// Distances from a point.
struct RadiusResult {
  Estimate mean{};       ///< mean radius [m]
  double r50 = 0;        ///< half of the shots lie within: CEP, in space SEP [m]
  double r90 = 0;        ///< [m]
  double r95 = 0;        ///< [m]
  CountedCells cells{};  ///< [-]

  bool operator==(const RadiusResult&) const = default;
};

/// An ellipse about the mean point of impact, one deviation wide; at 2 and 3 it is so many times as large.
struct EllipseResult {
  double right = 0;       ///< of the centre [m]
  double up = 0;          ///< or along [m]
  double long_axis = 0;   ///< half, of one deviation [m]
  double short_axis = 0;  ///< [m]
  double angle = 0;       ///< of the long axis from the first axis of the plane towards the second [rad]

  bool operator==(const EllipseResult&) const = default;
};

/// A place on the plane of impact: its first axis is a study's first quantity, its second the second.
struct PlanePoint {
  double right = 0;  ///< [m]
  double up = 0;     ///< or along [m]

  bool operator==(const PlanePoint&) const = default;
};

/// A convex polygon that holds next to all shots that arrive, those that were not flown included.
struct ZoneResult {
  std::vector<PlanePoint> corners{};  ///< counter-clockwise [m]
  double holds = 0;                   ///< at least this part of all shots, ... [-]
  double confidence = 0.95;           ///< ... in so many of all studies [-]

  bool operator==(const ZoneResult&) const = default;
};

/// The largest distance between two shots of a group.
struct SpreadResult {
  std::uint32_t size = 0;    ///< shots of a group [-]
  std::uint64_t groups = 0;  ///< [-]
  Estimate mean{};           ///< [m]
  double deviation = 0;      ///< from group to group [m]
  CountedCells cells{};      ///< [-]

  bool operator==(const SpreadResult&) const = default;
};

/// How likely a target is hit, shots that do not arrive included.
struct HitResult {
  std::string name{};      ///< [-]
  std::uint64_t hits = 0;  ///< [-]
  Estimate probability{};  ///< [-]
  double low = 0;          ///< of the 95 % interval: Wilson's for random shots, else by the replicates [-]
  double high = 0;         ///< [-]

  bool operator==(const HitResult&) const = default;
};

/// Shots whose number of one input lies within a part of its distribution.
struct InputPart {
  double low = 0;           ///< from here on; -infinity: no end [unit of the input]
  double middle = 0;        ///< as many of the distribution lie below within the part as above [unit of the input]
  double high = 0;          ///< and below here; infinity: no end [unit of the input]
  std::uint64_t shots = 0;  ///< [-]
  std::vector<HitResult> hits{};  ///< of each target [-]

  bool operator==(const InputPart&) const = default;
};
/// How likely targets are hit over one input, the others as uncertain as ever.
struct HitsOverInput {
  std::size_t input = 0;           ///< index in Study::inputs [-]
  std::vector<InputPart> parts{};  ///< rising; without those that no shot has [-]

  bool operator==(const HitsOverInput&) const = default;
};

/// What the first shots of a study came to: a point of the way to its figures.
struct StudyStage {
  std::uint64_t shots = 0;        ///< [-]
  Estimate distance{};            ///< mean distance from the aim; without a plane the mean of the first quantity [unit]
  std::vector<HitResult> hits{};  ///< of each target; without an interval where replicates tell errors [-]

  bool operator==(const StudyStage&) const = default;
};

/// A shot far from the aim.
struct WorstShot {
  std::uint64_t shot = 0;       ///< its number [-]
  double distance = 0;          ///< from the aim [m]
  std::vector<double> draws{};  ///< what it drew, in the order of the inputs [unit of each]

  bool operator==(const WorstShot&) const = default;
};

/// Sobol indices of a group of inputs: each input that is correlated with none, or all of a correlation. They are NaN
/// for a quantity that does not vary (QuantityResult::varies()).
struct IndexResult {
  std::vector<std::size_t> inputs{};  ///< indices in Study::inputs [-]
  std::vector<Estimate> first{};      ///< for each quantity: share of the variance by itself [-]
  std::vector<Estimate> total{};      ///< ... and together with others [-]

  bool operator==(const IndexResult&) const = default;
};

/// All figures of a study.
struct StudyResult {
  std::uint64_t shards = 0;                   ///< [-]
  std::uint64_t shots = 0;                    ///< flown [-]
  std::uint64_t refused = 0;                  ///< of them: what they drew cannot be [-]
  std::uint64_t not_arrived = 0;              ///< of them: ended before the range, or in no planned way [-]
  std::optional<Error> first_refusal{};       ///< [-]
  std::vector<QuantityResult> quantities{};   ///< [-]
  std::vector<double> covariance{};           ///< of the quantities, row by row [unit of each, multiplied]
  std::optional<RadiusResult> from_aim{};     ///< distances on the plane from the aim [m]
  std::optional<RadiusResult> from_centre{};  ///< ... from the mean point of impact of a study of 1024 shots [m]
  std::optional<RadiusResult> in_space{};     ///< ... in x, y and z, where all of these are asked for [m]
  std::optional<EllipseResult> ellipse{};     ///< [m]
  std::vector<SpreadResult> spreads{};        ///< of random shots [-]
  std::optional<ZoneResult> zone{};           ///< of random shots without occasions [m]
  std::vector<HitResult> hits{};              ///< of each target [-]
  std::vector<WorstShot> worst{};             ///< ten at most, the worst first [-]
  std::vector<IndexResult> indices{};         ///< where they are asked for [-]
  std::vector<HitsOverInput> over_inputs{};   ///< of each input, where Study::over_inputs asks for it [-]
  std::vector<StudyStage> stages{};           ///< from the first shard on, each a tenth more than the one before [-]
  bool width_reached = false;                 ///< Study::until_width ended it [-]
  bool time_was_up = false;                   ///< StudyOptions::time_is_up ended it [-]
  std::vector<StudyResult> at{};              ///< all of this at each of Study::at [-]
};

/// What one input does to the result, by its slope.
struct LinearRow {
  std::size_t input = 0;         ///< index in Study::inputs [-]
  double deviation = 0;          ///< of the input [unit of the input]
  std::vector<double> slope{};   ///< of each quantity [unit of the quantity / unit of the input]
  std::vector<double> effect{};  ///< of one deviation: slope times deviation [unit of the quantity]
  std::vector<double> share{};   ///< of the variance of each quantity; a correlated group's stands in its first row [-]
  /// Which part of the shots that miss a target of Study::targets would hit if this input stood at its mean: by slopes,
  /// as if impacts were normal. Parts need not add up to 1, and are negative where the spread brings hits. A correlated
  /// group has its parts in its first row and 0 in the others; NaN of things, and where fewer than one shot in 460
  /// misses; empty without a plane. Rows that hold a NaN compare unequal, also with themselves [-].
  std::vector<double> misses{};

  bool operator==(const LinearRow&) const = default;
};

/// Covariances by slopes.
struct LinearResult {
  std::vector<double> mean{};        ///< quantities of the shot with the mean of each input [unit of each]
  std::vector<double> covariance{};  ///< row by row [unit of each, multiplied]
  std::vector<LinearRow> rows{};     ///< of each input [-]

  bool operator==(const LinearResult&) const = default;
};

}  // namespace physim
