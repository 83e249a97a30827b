// Study: many flights of one shot with uncertain numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "physim/names.hpp"
#include "physim/result.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Distribution: how likely each value of an uncertain number is.

/// The bell curve.
struct NormalDistribution {
  double mean = 0;       ///< [unit of the number]
  double deviation = 1;  ///< standard deviation, above 0 [unit of the number]

  bool operator==(const NormalDistribution&) const = default;
};

/// As likely everywhere between two ends.
struct UniformDistribution {
  double low = 0;   ///< [unit of the number]
  double high = 1;  ///< above low [unit of the number]

  bool operator==(const UniformDistribution&) const = default;
};

/// From nothing at the ends up to a peak, in straight lines.
struct TriangularDistribution {
  double low = 0;     ///< [unit of the number]
  double peak = 0.5;  ///< most likely; low <= peak <= high [unit of the number]
  double high = 1;    ///< above low [unit of the number]

  bool operator==(const TriangularDistribution&) const = default;
};

/// A number above zero with a normal logarithm, by its own mean and deviation.
struct LognormalDistribution {
  double mean = 1;       ///< of the number, above 0 [unit of the number]
  double deviation = 1;  ///< of the number, above 0 [unit of the number]

  bool operator==(const LognormalDistribution&) const = default;
};

/// A bell curve of which only the part between two ends is there. Mean and deviation are those of the whole curve.
struct TruncatedNormalDistribution {
  double mean = 0;          ///< [unit of the number]
  double deviation = 1;     ///< above 0 [unit of the number]
  double low = -kInfinity;  ///< -infinity: none [unit of the number]
  double high = kInfinity;  ///< above low; infinity: none [unit of the number]

  bool operator==(const TruncatedNormalDistribution&) const = default;
};

/// Some values, such as a column of measurements.
struct DiscreteDistribution {
  std::vector<double> values{};   ///< at least one, in any order [unit of the number]
  std::vector<double> weights{};  ///< probability of each, as a part of their sum; empty: all the same [-]

  bool operator==(const DiscreteDistribution&) const = default;
};

using Distribution = std::variant<NormalDistribution, UniformDistribution, TriangularDistribution,
                                  LognormalDistribution, TruncatedNormalDistribution, DiscreteDistribution>;

/// Says what is wrong with a distribution, by its member.
[[nodiscard]] Status check(const Distribution& distribution);

// The following are defined for a distribution that passes check(); for others they are NaN.

/// [unit of the number]
[[nodiscard]] double mean_of(const Distribution& distribution);
/// [unit of the number, squared]
[[nodiscard]] double variance_of(const Distribution& distribution);
/// The value that a part 0 < p < 1 of all numbers lies below [unit of the number]; p outside: NaN.
[[nodiscard]] double quantile_of(const Distribution& distribution, double p);
/// The part of all numbers that is not above x [-].
[[nodiscard]] double probability_up_to(const Distribution& distribution, double x);

// ---------------------------------------------------------------------------------------------------------------------
// The results of a study: figures with their errors.

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
/// (1 + |x - centre| / scale) / 256 of the scale wide, or less: this is the largest error of a quantile.
struct CountedCells {
  double centre = 0;                    ///< [unit of the quantity]
  double scale = 1;                     ///< about a standard deviation [unit of the quantity]
  std::int64_t first = 0;               ///< number of the first cell with a count [-]
  std::vector<std::uint64_t> counts{};  ///< of cells from there on [-]
  double least = -kInfinity;            ///< of the numbers counted [unit of the quantity]
  double most = kInfinity;              ///< [unit of the quantity]

  /// Numbers counted.
  [[nodiscard]] std::uint64_t count() const;
  /// The number that a part 0 <= p <= 1 lies below, in straight lines within a cell, from `least` to `most`; NaN if
  /// there are none [unit].
  [[nodiscard]] double quantile(double p) const;
  /// The part that lies below x [-].
  [[nodiscard]] double part_below(double x) const;
  /// The largest error that quantile() can have near x [unit].
  [[nodiscard]] double error_at(double x) const;
  /// Low edge of cell `first` + i, also for i = counts.size() [unit].
  [[nodiscard]] double edge(std::size_t i) const;
  /// The most bars of a histogram [-].
  static constexpr std::size_t kMostBars = 100'000;
  /// A histogram of `bars` bars, three to kMostBars (fewer count as three, more as kMostBars): one at each end for
  /// about 0.1 % that lie beyond, 0.2 % at most, those between about equally wide. No bar at an end if its outermost
  /// cell has more than that, as with few values: then all bars are about equally wide there. Ends of bars are edges of
  /// cells, so counts are exact, and widths are to a cell. Fewer bars where cells are wider than they would be; none
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

/// An ellipse about the mean point of impact, one deviation wide; at 2 and 3 deviations it is 2 and 3 times as large.
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
  double confidence = 0.95;           ///< ... in this part of all studies [-]

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

/// The hit probability of a target, shots that do not arrive included.
struct HitResult {
  std::string name{};      ///< [-]
  std::uint64_t hits = 0;  ///< [-]
  Estimate probability{};  ///< [-]
  double low = 0;          ///< of the 95 % interval: Wilson's for random shots, else by the replicates [-]
  double high = 0;         ///< [-]

  bool operator==(const HitResult&) const = default;
};

/// Shots with the number of one input within a part of its distribution.
struct InputPart {
  double low = 0;           ///< from here on; -infinity: no end [unit of the input]
  double middle = 0;        ///< as many of the distribution lie below within the part as above [unit of the input]
  double high = 0;          ///< and below here; infinity: no end [unit of the input]
  std::uint64_t shots = 0;  ///< [-]
  std::vector<HitResult> hits{};  ///< of each target [-]

  bool operator==(const InputPart&) const = default;
};
/// The hit probability of targets over one input, the others as uncertain as ever.
struct HitsOverInput {
  std::size_t input = 0;           ///< index in Study::inputs [-]
  std::vector<InputPart> parts{};  ///< rising; without those that no shot has [-]

  bool operator==(const HitsOverInput&) const = default;
};

/// The result of the first shots of a study: a point of the way to its figures.
struct StudyStage {
  std::uint64_t shots = 0;        ///< [-]
  Estimate distance{};            ///< mean distance from the aim; without a plane the mean of the first quantity [unit]
  std::vector<HitResult> hits{};  ///< of each target; without an interval if replicates give errors [-]

  bool operator==(const StudyStage&) const = default;
};

/// A shot far from the aim.
struct WorstShot {
  std::uint64_t shot = 0;       ///< its number [-]
  double distance = 0;          ///< from the aim [m]
  std::vector<double> draws{};  ///< numbers that it drew, in the order of the inputs [unit of each]

  bool operator==(const WorstShot&) const = default;
};

/// Sobol indices of a group of inputs: each input that is correlated with none, or all of a correlation. They are NaN
/// for a quantity that does not vary (QuantityResult::varies()).
struct IndexResult {
  std::vector<std::size_t> inputs{};  ///< indices in Study::inputs [-]
  std::vector<Estimate> first{};      ///< for each quantity: share of the variance alone [-]
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
  std::vector<IndexResult> indices{};         ///< if they are asked for [-]
  std::vector<HitsOverInput> over_inputs{};   ///< of each input, if Study::over_inputs is set [-]
  std::vector<StudyStage> stages{};           ///< from the first shard on, each a tenth more than the one before [-]
  bool width_reached = false;                 ///< Study::until_width ended it [-]
  bool time_was_up = false;                   ///< StudyOptions::time_is_up ended it [-]
  std::vector<StudyResult> at{};              ///< all of this at each of Study::at [-]
};

/// The effect of one input on the result, by its slope.
struct LinearRow {
  std::size_t input = 0;         ///< index in Study::inputs [-]
  double deviation = 0;          ///< of the input [unit of the input]
  std::vector<double> slope{};   ///< of each quantity [unit of the quantity / unit of the input]
  std::vector<double> effect{};  ///< of one deviation: slope times deviation [unit of the quantity]
  std::vector<double> share{};   ///< of the variance of each quantity; a correlated group's stands in its first row [-]
  /// The part of the misses of a target of Study::targets that would hit if this input stood at its mean: by slopes,
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

// ---------------------------------------------------------------------------------------------------------------------
// Study: many flights of one shot with uncertain numbers, and the probability of each end.

class Scene;
class TaskRunner;

/// The sampling method of a study.
enum class Sampling {
  random,           ///< each shot alone
  latin_hypercube,  ///< evenly over each input within a shard
  sobol,            ///< evenly over all inputs at once: Sobol's sequence, scrambled
};

PHYSIM_UNORDERED(Sampling)

/// The frequency of draws of an uncertain number.
enum class DrawnFor {
  round,     ///< for each shot
  occasion,  ///< once for all shots of an occasion: Study::rounds of them
};

PHYSIM_UNORDERED(DrawnFor)

/// A number that is not known for sure. Several entries may name one number; then all but one are `added`.
struct StudyInput {
  std::string path{};                    ///< of the number: one of study_paths(), "shot.speed" [-]
  Distribution distribution{};           ///< of the number [unit of the number]
  DrawnFor drawn_for = DrawnFor::round;  ///< frequency of its draws [-]
  bool added = false;                    ///< to what is there, instead of taking its place [-]

  bool operator==(const StudyInput&) const = default;
};

/// Inputs that go with each other. The correlations are those of the normal numbers that they are made of: exact for
/// normal distributions, near for others.
struct StudyCorrelation {
  std::vector<std::size_t> inputs{};  ///< indices in Study::inputs, drawn equally often [-]
  std::vector<double> matrix{};       ///< of correlations, row by row: symmetric, positive definite [-]

  bool operator==(const StudyCorrelation&) const = default;
};

struct CircleTarget {
  PlanePoint centre{};  ///< [m]
  double radius = 0.1;  ///< [m]

  bool operator==(const CircleTarget&) const = default;
};
struct RectangleTarget {
  PlanePoint centre{};  ///< [m]
  double width = 1;     ///< [m]
  double height = 1;    ///< [m]

  bool operator==(const RectangleTarget&) const = default;
};
/// A closed outline, which may cross itself: inside is what it goes round an odd number of times.
struct PolygonTarget {
  std::vector<PlanePoint> corners{};  ///< three or more [m]

  bool operator==(const PolygonTarget&) const = default;
};
/// A thing of Study::scene, or all that have its name. A shot that meets it hits it, whatever becomes of the shot then;
/// a shot that passes a sensor hits it.
struct ThingTarget {
  std::string thing{};  ///< InstanceDef::name [-]

  bool operator==(const ThingTarget&) const = default;
};
/// A target of the shots. A shot on the rim hits a circle; of other shapes the left and the lower edge belong to them.
struct StudyTarget {
  std::string name{};                                                               ///< [-]
  std::variant<CircleTarget, RectangleTarget, PolygonTarget, ThingTarget> shape{};  ///< [-]

  bool operator==(const StudyTarget&) const = default;
};

/// A figure known to a width ends a study.
struct StudyWidth {
  std::optional<std::size_t> target{};  ///< the hit probability of this target; none: the mean of `quantity` [-]
  std::size_t quantity = 0;             ///< index in the list of quantities [-]
  double width = 0;                     ///< of the 95 % interval, from end to end [unit of the figure]

  bool operator==(const StudyWidth&) const = default;
};

/// A place on the way that also gets results: where a shot first meets an event. Range lines stand where planes of
/// impact do: all shots are seen on that of the shot without uncertainty.
struct StudyPlace {
  EventSpec event{};                        ///< `terminal` is not read; an apex without a direction is a highest
                                            ///< point (falling) [-]
  std::vector<StudyQuantity> quantities{};  ///< none of an impact; where the first two are lengths, its plane; empty:
                                            ///< right, up, time and speed on a range line, else right, along, y, time
                                            ///< and speed without the one that is crossed; never empty where a study
                                            ///< is of a function [-]
};

/// A projectile, a launch and a place of which some numbers are uncertain, and what is asked of their flights.
struct Study {
  ProjectileDef projectile{};  ///< [-]
  /// A zero range is put into an elevation once, without uncertainty [-]
  Launch launch{};
  Environment environment{};                   ///< [-]
  Fidelity fidelity{};                         ///< [-]
  Tolerance tolerance{};                       ///< [-]
  Until until{};                               ///< with a range the plane of impact stands there; its scene is null [-]
  std::vector<StudyInput> inputs{};            ///< at most 64 [-]
  std::vector<StudyCorrelation> correlated{};  ///< each input in one of them at most [-]
  std::uint32_t rounds = 1;                    ///< of an occasion; divides shard_shots [-]
  Sampling sampling = Sampling::random;        ///< [-]
  std::uint64_t seed = 1;                      ///< [-]
  std::uint64_t shots = 100'000;               ///< at least; the last shard is flown to its end [-]
  std::optional<StudyWidth> until_width{};     ///< ends it earlier, at one of a row of shard counts [-]
  std::uint32_t shard_shots = 4096;            ///< 16 to 65536; for Sobol's sequence a power of two [-]
  std::vector<StudyQuantity> quantities{};     ///< two for the plane of impact, then others; empty: right, up
                                               ///< (without a range: along), time, speed; with a scene
                                               ///< right, up, along, time, speed [-]
  PlanePoint aim{};                            ///< intended end of the shots, on the plane of impact [m]
  std::vector<StudyTarget> targets{};          ///< [-]
  std::vector<std::uint32_t> group_sizes = {3, 5, 10};  ///< of extreme spreads, 2 to 100 shots [-]
  bool indices = false;                                 ///< Sobol indices: each shot is flown once more for each
                                                        ///< group of inputs, and once besides [-]
  /// Things that shots meet as until.contact says, each shot alone; random effects of materials are drawn for each
  /// shot. It has no engine. Null: none [-]
  std::shared_ptr<const Scene> scene{};
  /// Hit probability over each input: the number of equally likely parts of its distribution, 2 to 100; none: off [-]
  std::optional<std::uint32_t> over_inputs{};
  /// Places on the way of the same flights, with all figures that their ends have; with until.events 24 at most.
  /// `targets` and `aim` are those of a place that has the study's first two quantities [-]
  std::vector<StudyPlace> at{};
};

/// A number that may be uncertain.
struct StudyPath {
  std::string path{};   ///< as in scenarios; "N" of a point of a list: its number, from 1 [-]
  std::string unit{};   ///< [-]
  std::string about{};  ///< [-]
};
/// All of them.
[[nodiscard]] std::vector<StudyPath> study_paths();
/// The one that a path names, such as "shot.drag.curve.3"; nothing if there is no such path.
[[nodiscard]] std::optional<StudyPath> study_path(std::string_view path);

/// Correlates the points of a list that a study draws by their distance d, exp(-d / length): points near each other are
/// off by much the same, as in curves that were measured. `list`: a path of study_paths() with its N,
/// "shot.drag.curve.N", of points that stand at a Mach number, a time, a height or a speed each; `length`: above 0
/// [unit of these]. A point that is drawn more than once goes by its first input. An error for any other list, for two
/// points at one place, and for fewer than two. Source: C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for
/// Machine Learning (2006), sec. 4.2.1.
[[nodiscard]] Result<StudyCorrelation> correlated_by_distance(const Study& study, std::string_view list, double length);

/// A model of one's own in the place of flights: a column of each input comes in, one of each quantity goes out, behind
/// them one of each quantity of each of Study::at; its events are ignored. NaN: the shot is not counted as one that
/// arrived there. It depends on its columns alone, shot by shot, and is called
/// from several threads at once.
using StudyFunction =
    std::function<void(std::span<const std::span<const double>> inputs, std::span<const std::span<double>> quantities)>;

struct StudyPlanRecord;

/// A study that was checked and prepared by plan_study(). Cheap to copy; to move one is to copy it.
class StudyPlan {
 public:
  StudyPlan(const StudyPlan&) = default;
  StudyPlan& operator=(const StudyPlan&) = default;
  ~StudyPlan() = default;

  [[nodiscard]] const Study& study() const;
  /// Shards of Study::shots; whole rounds of replicates for Latin hypercubes and Sobol's sequence.
  [[nodiscard]] std::uint64_t shards() const;
  /// Notes to be known before it is flown: the frequency of impossible draws ...
  [[nodiscard]] const std::vector<std::string>& notes() const;
  /// A plan for each of Study::at, of a study that ends there: with its quantities, targets and aim. Flown alone it
  /// gives the bits that StudyResult::at has; shots fly on to the end of this one.
  [[nodiscard]] std::vector<StudyPlan> places() const;
  [[nodiscard]] const StudyPlanRecord& record() const { return *record_; }

 private:
  friend struct StudyPlanRecord;
  explicit StudyPlan(std::shared_ptr<const StudyPlanRecord> record) : record_(std::move(record)) {}
  std::shared_ptr<const StudyPlanRecord> record_;
};

/// Checks and prepares a study: it flies the shot without uncertainty and a few with it.
[[nodiscard]] Result<StudyPlan> plan_study(const Study& study);
/// ... of a function: its inputs have paths of one's own, and projectile, launch and place are not looked at. Functions
/// are not distinguished, so parts of two functions are joined without an error.
[[nodiscard]] Result<StudyPlan> plan_study(const Study& study, const StudyFunction& function);

struct StudyPartRecord;

/// Results of some shards of a study. A copy is cheap; a move copies.
class StudyPart {
 public:
  /// No shards.
  StudyPart();
  /// Those of a record; no shards if it is null.
  explicit StudyPart(std::shared_ptr<const StudyPartRecord> record) : StudyPart() {
    if (record) record_ = std::move(record);
  }
  StudyPart(const StudyPart&) = default;
  StudyPart& operator=(const StudyPart&) = default;
  ~StudyPart() = default;

  [[nodiscard]] std::uint64_t shards() const;
  [[nodiscard]] bool has(std::uint64_t shard) const;
  /// The first shard that is missing, counted from 0.
  [[nodiscard]] std::uint64_t first_missing() const;
  [[nodiscard]] const StudyPartRecord& record() const { return *record_; }

 private:
  std::shared_ptr<const StudyPartRecord> record_;
};

/// Flies a shard. The result depends on nothing but the study and the number.
[[nodiscard]] StudyPart run_shard(const StudyPlan& plan, std::uint64_t shard);
/// Joins parts of one study; an error where both have a shard, or they are of different studies. In whatever order
/// parts are joined, the bits of the result are the same.
[[nodiscard]] Result<StudyPart> merge(const StudyPart& a, const StudyPart& b);
/// A part as bytes, and back, with all its bits; an error if the bytes are no part, damaged, or flown by another
/// version.
[[nodiscard]] std::vector<std::byte> save_part(const StudyPart& part);
[[nodiscard]] Result<StudyPart> load_part(std::span<const std::byte> bytes);

/// Options of the run of a study.
struct StudyOptions {
  StudyPart so_far{};  ///< shards that were flown before [-]
  /// Called after each shard, by one thread at a time, with all that is there; false stops. May be empty. [-]
  std::function<bool(const StudyPart&)> after_shard{};
  /// Asked before each shard, by one thread at a time; true: the study ends with the shards under way. Evenly spread
  /// draws, occasions and indices end with a whole round of 16 shards; one is always flown. So time chooses nothing but
  /// the count of shots: Study::shots of that many gives the same bits. May be empty. [-]
  std::function<bool()> time_is_up{};
};

/// Flies what is missing of a study, and returns its result. Its bits do not depend on the runner's threads. If
/// stopped, or out of time, it covers the shards from the first to the first that is missing.
[[nodiscard]] Result<StudyResult> run_study(const StudyPlan& plan, TaskRunner* runner = nullptr,
                                            const StudyOptions& options = {});
/// ... checked, prepared and flown.
[[nodiscard]] Result<StudyResult> run_study(const Study& study, TaskRunner* runner = nullptr);
/// Flies those of the shards first ... first + count - 1 that options.so_far has not; gives all that is there then.
[[nodiscard]] Result<StudyPart> run_shards(const StudyPlan& plan, std::uint64_t first, std::uint64_t count,
                                           TaskRunner* runner = nullptr, const StudyOptions& options = {});
/// The result of the first `shards` of a part; an error, which names them, where some are missing.
[[nodiscard]] Result<StudyResult> result_of(const StudyPlan& plan, const StudyPart& part, std::uint64_t shards);

/// The numbers that a shot draws, in the order of Study::inputs, with what its path has besides.
[[nodiscard]] std::vector<double> draws_of(const StudyPlan& plan, std::uint64_t shot);
/// The result of a shot: each quantity; NaN where it did not arrive.
[[nodiscard]] std::vector<double> fly_shot_of(const StudyPlan& plan, std::uint64_t shot);

/// Shots as they were drawn and as they ended, column by column.
struct StudyShots {
  std::vector<std::vector<double>> inputs{};      ///< in the order of Study::inputs [unit of each]
  std::vector<std::vector<double>> quantities{};  ///< NaN where a shot did not arrive [unit of each]
  std::vector<std::vector<bool>> hits{};          ///< of each target [-]
  std::vector<StudyShots> at{};                   ///< the same at each of Study::at, without inputs [-]
};
/// Flies a shard again and keeps its shots, to be drawn or looked at one by one: shots shard * shard_shots and on.
[[nodiscard]] StudyShots fly_shots_of(const StudyPlan& plan, std::uint64_t shard);

/// Covariances carried through the flight by its slopes, without sampling.
[[nodiscard]] Result<LinearResult> propagate_linearly(const StudyPlan& plan);

template <>
std::span<const std::string_view> names_of<Sampling>();
template <>
std::span<const std::string_view> names_of<DrawnFor>();
template <>
std::span<const std::string_view> names_of<StudyQuantity>();

}  // namespace physim
