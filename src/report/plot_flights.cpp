#include <algorithm>
#include <array>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "report/fidelity_text.hpp"
#include "report/number.hpp"
#include "report/pictures.hpp"
#include "report/scene_section.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kWidth = 1600, kHeight = 1300;  // [px]
constexpr int kPoints = 400;                  // of each curve, beside its corners
constexpr std::size_t kMaxDrawnShots = 14;

// Columns of a datablock, counted from 1 as gnuplot does: those of a sample row, and then these.
constexpr int kTime = 1, kPosition = 2, kVelocity = 5, kAcceleration = 8, kSpeed = 11;
constexpr int kRange = 13, kHeightColumn = 14, kJerk = 15;
constexpr int kColumns = 17;
static_assert(kSampleColumns.size() <= kHeightColumn);

struct Curve {
  std::string name;
  std::string block;  // of gnuplot: "$shot0"
  std::vector<std::array<double, kColumns>> rows;
  std::string hits;  // rows of distance and height where it hits things; empty: none
};

std::string hits_of(const Flight& flight) {
  std::string rows;
  for (const Event& event : flight.events())
    if (const Vec3d& x = event.position; event.kind == EventKind::hit)
      rows += significant(std::hypot(x.x, x.z), 9) + " " + significant(x.y, 9) + "\n";
  return rows;
}

Curve curve_of(const FlownShot& shot, std::size_t index, bool with_jerk) {
  Curve curve{shot.name, "$shot" + std::to_string(index), {}, hits_of(shot.flight)};
  const double duration = shot.flight.duration();
  Times times;
  for (int k = 0; k <= kPoints; ++k) times.push_back(duration * k / kPoints);
  times = with_breaks(shot.flight, times);
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Sample sample = sample_at(shot.flight, times, k);
    std::array<double, kColumns> row{};
    std::ranges::copy(row_of(sample), row.begin());
    row[kRange - 1] = std::hypot(sample.position.x, sample.position.z);
    row[kHeightColumn - 1] = sample.position.y;
    const Vec3d jerk = with_jerk ? shot.flight.jerk(sample.time) : Vec3d{};
    row[kJerk - 1] = jerk.x, row[kJerk] = jerk.y, row[kJerk + 1] = jerk.z;
    curve.rows.push_back(row);
  }
  return curve;
}

std::vector<TrackPlace> track_of(const Curve& curve) {
  std::vector<TrackPlace> track;
  for (const auto& row : curve.rows)
    track.push_back({row[kRange - 1], row[kPosition - 1], row[kPosition + 1], row[kTime - 1]});
  return track;
}

std::string datablock_of(const Curve& curve) {
  std::string rows;
  for (const auto& row : curve.rows) {
    for (const double value : row) rows += (std::isfinite(value) ? significant(value, 9) : "NaN") + " ";
    rows += "\n";
  }
  const std::string hits = curve.hits.empty() ? "" : datablock(curve.block + "hits", curve.hits);
  return datablock(curve.block, rows) + hits;
}

Extent extent_of(const std::vector<Curve>& curves, int column) {
  PHYSIM_ASSERT(column >= 1 && column <= kColumns);
  Extent extent;
  for (const Curve& curve : curves)
    for (const auto& row : curve.rows) extent.add(row[static_cast<std::size_t>(column - 1)]);
  return extent.or_zero();
}

/// Marks over the curves for what a scenario expects of its shots at times: rings if it was published, else crosses.
class PlotMarks {
 public:
  PlotMarks(std::span<const FlownShot> shots, std::span<const Expectation> expected) {
    for (const Expectation& e : expected) {
      const bool is_drawn = e.shot.empty() || std::ranges::count(shots, e.shot, &FlownShot::name) > 0;
      const std::size_t column = column_of(e.quantity);
      if (e.at != ExpectAt::time || !is_drawn || column == 0) continue;
      PHYSIM_ASSERT(column < marks_.size());
      Marks& marks = marks_[column];
      (e.published ? marks.rings : marks.crosses) += significant(e.at_value, 9) + " " + significant(e.equals, 9) + "\n";
      (e.published ? has_rings_ : has_crosses_) = true;
      marks.extent.add(e.equals);
    }
  }

  [[nodiscard]] bool has_rings() const { return has_rings_; }
  [[nodiscard]] bool has_crosses() const { return has_crosses_; }
  /// Returns the extent of the marks in a panel; columns count from 1, as in kSampleColumns.
  [[nodiscard]] Extent extent(int column) const {
    const auto c = static_cast<std::size_t>(column);
    return c < marks_.size() ? marks_[c].extent : Extent{};
  }
  /// The datablocks that plots() reads.
  [[nodiscard]] std::string blocks() const {
    std::string out;
    for (std::size_t c = 0; c < marks_.size(); ++c) {
      if (!marks_[c].rings.empty()) out += datablock(name_of("rings", c), marks_[c].rings);
      if (!marks_[c].crosses.empty()) out += datablock(name_of("crosses", c), marks_[c].crosses);
    }
    return out;
  }
  /// Drawn over the curves of a panel; begins with a comma.
  [[nodiscard]] std::string plots(int column) const {
    PHYSIM_ASSERT(column >= 1);
    const auto c = static_cast<std::size_t>(column);
    if (c >= marks_.size()) return "";
    std::string out;
    if (!marks_[c].crosses.empty()) out += plot(name_of("crosses", c), kExpectedMark);
    if (!marks_[c].rings.empty()) out += plot(name_of("rings", c), kPublishedMark);
    return out;
  }

 private:
  struct Marks {
    std::string rings, crosses;  // rows of time and value
    Extent extent;
  };

  /// The column of a quantity, from 1; 0: none.
  static std::size_t column_of(const std::string& quantity) {
    for (std::size_t c = 0; c < kSampleColumns.size(); ++c)
      if (kSampleColumns[c].starts_with(quantity + " [")) return c + 1;
    return 0;
  }
  static std::string name_of(const char* kind, std::size_t column) { return "$" + (kind + std::to_string(column)); }
  static std::string plot(const std::string& block, std::string_view mark) {
    return ", " + block + " using 1:2 with points " + std::string(mark) + " notitle";
  }

  std::array<Marks, kSampleColumns.size() + 1> marks_;
  bool has_rings_ = false, has_crosses_ = false;
};

class FlightsPicture {
 public:
  FlightsPicture(const std::string& title, std::span<const FlownShot> shots, const Scene* scene,
                 std::span<const Expectation> expected, bool with_jerk)
      : title_(title),
        scene_(scene),
        shots_(shots.first(std::min(shots.size(), kMaxDrawnShots))),
        all_(shots.size()),
        marks_(shots_, expected),
        rows_(with_jerk ? 4 : 3) {
    for (std::size_t i = 0; i < shots_.size(); ++i) curves_.push_back(curve_of(shots_[i], i, with_jerk));
  }

  /// A further row of panels makes it higher [px].
  [[nodiscard]] int height() const {
    return kHeight + static_cast<int>(std::lround(kHeight * (kRowHeight + kRowGap) * (rows_ - 3)));
  }

  [[nodiscard]] std::string script() const {
    std::string out = axes_style();
    for (const Curve& curve : curves_) out += datablock_of(curve);
    out += marks_.blocks() + "set multiplot\n" + path_panel() + "unset arrow\n" + speed_panel();
    const std::array<std::string_view, 3> axes = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(axes[static_cast<std::size_t>(axis)]);
      out += axis_panel(axis, 0, kPosition + axis, name + " [m]");
      out += axis_panel(axis, 1, kVelocity + axis, "v" + name + " [m/s]");
      out += axis_panel(axis, 2, kAcceleration + axis, "a" + name + " [m/s²]");
      if (rows_ > 3) out += axis_panel(axis, 3, kJerk + axis, "j" + name + " [m/s³]");
    }
    return out + "unset multiplot\n";
  }

 private:
  static constexpr double kLeft = 0.055, kRight = 0.985, kPanelGap = 0.062;  // parts of the width
  static constexpr double kTopLow = 0.665, kTopHigh = 0.875;                 // parts of the height
  static constexpr double kRowLow = 0.055, kRowHeight = 0.141, kRowGap = 0.047;
  static constexpr double kPanelWidth = (kRight - kLeft - 2 * kPanelGap) / 3;

  static constexpr double kHeaderLeft = 0.02, kLegendTop = 0.938, kLegendRow = 0.0215;  // parts of the picture

  /// A height in the picture of three rows, as far from the top of this one.
  [[nodiscard]] double up(double part) const { return 1 - (1 - part) * kHeight / height(); }
  static double column_left(int column) { return kLeft + column * (kPanelWidth + kPanelGap); }

  [[nodiscard]] std::string header() const {
    std::string out = title_at(kHeaderLeft, up(0.968), title_, kWidth);
    if (shots_.size() == 1) {
      const Fidelity& asked = shots_[0].shot->projectile.fidelity;
      const std::string text = one_line(shots_[0].name) + ", fidelity " + preset_name(asked);
      return out + text_at(kHeaderLeft, up(kLegendTop), text, 15, kQuiet) +
             legend(static_cast<double>(text.size()) * 9.5);
    }
    const std::string count =
        all_ == shots_.size() ? std::to_string(all_) + " shots"
                              : "the first " + std::to_string(shots_.size()) + " of " + std::to_string(all_) + " shots";
    return out + text_at(kHeaderLeft, up(kLegendTop), count, 15, kQuiet) +
           legend(static_cast<double>(count.size()) * 10);
  }

  struct LegendItem {
    std::string name, style;
    std::string_view mark;  // empty: a line of the style
    double x = 0;           // [px]
    int row = 0;
  };

  // What lines and marks stand for; a single shot without its own colour has a colour for each row of panels.
  [[nodiscard]] std::vector<LegendItem> legend_names() const {
    std::vector<LegendItem> items;
    for (std::size_t i = 0; i < curves_.size() && curves_.size() > 1; ++i)
      items.push_back({one_line(curves_[i].name), curve_style("2.5", i, colour_of(i, 0)), {}});
    if (curves_.size() == 1 && has_marks() && own_colour(0) != 0)
      items.push_back({"computed", curve_style("2.5", 0, colour_of(0, 0)), {}});
    if (marks_.has_rings()) items.push_back({"published", "", kPublishedMark});
    if (marks_.has_crosses()) items.push_back({"expected", "", kExpectedMark});
    return items;
  }
  [[nodiscard]] bool has_marks() const { return marks_.has_rings() || marks_.has_crosses(); }

  // ... in rows, from `indent` px on; no name longer than `characters`.
  [[nodiscard]] std::vector<LegendItem> legend_items(double indent, std::size_t characters) const {
    std::vector<LegendItem> items = legend_names();
    double x = kHeaderLeft * kWidth + indent + kLegendGap;
    int row = 0;
    for (LegendItem& item : items) {
      item.name = shortened(item.name, characters);
      const double width = legend_width(item.name);
      if (x + width > (1 - kHeaderLeft) * kWidth && &item != items.data()) x = kHeaderLeft * kWidth, ++row;
      item.x = x, item.row = row;
      x += width + kLegendGap;
    }
    return items;
  }

  // Below the title, so that neither is ever in the other's way; names are shortened until they fit into two rows.
  [[nodiscard]] std::string legend(double indent) const {
    std::size_t characters = 60;
    std::vector<LegendItem> items = legend_items(indent, characters);
    while (characters > 4 && !items.empty() && items.back().row > 1) items = legend_items(indent, --characters);
    std::string out;
    for (const LegendItem& item : items) {
      const double y = up(kLegendTop - item.row * kLegendRow);
      out += item.mark.empty() ? legend_entry(item.x, y, item.name, item.style, kWidth)
                               : legend_mark(item.x, y, item.name, item.mark, kWidth);
    }
    return out;
  }

  // The colour that its body is carried along with, RGBA; 0: none was given.
  [[nodiscard]] std::uint32_t own_colour(std::size_t shot) const {
    const std::uint32_t colour = shots_[shot].shot->body.colour;
    return colour == BodyDef{}.colour ? 0 : colour;
  }

  [[nodiscard]] std::string colour_of(std::size_t shot, int row) const {
    if (const std::uint32_t own = own_colour(shot); own != 0) return formatted("#%06X", own >> 8);
    return std::string(kPalette[shots_.size() == 1 ? static_cast<std::size_t>(row) : shot % kPalette.size()]);
  }

  // One curve for each shot, with marks where it hits things in the panel of heights. `row` colours
  // a single shot.
  [[nodiscard]] std::string curves(int x, int y, int row) const {
    std::string out;
    for (std::size_t i = 0; i < curves_.size(); ++i)
      out += (i == 0 ? "" : ", ") + curves_[i].block + " using " + std::to_string(x) + ":" + std::to_string(y) +
             " with lines" + curve_style("2.5", i, colour_of(i, row)) + " notitle";
    for (std::size_t i = 0; i < curves_.size() && y == kHeightColumn; ++i)
      if (!curves_[i].hits.empty())
        out += ", " + curves_[i].block + "hits using 1:2 with points pt 7 ps 1.2 lc rgb " + literal(colour_of(i, row)) +
               " notitle";
    return out + (x == kTime ? marks_.plots(y) : "") + "\n";
  }

  // Height over distance: to scale where the curve keeps a visible shape, else stretched, and the picture says so.
  [[nodiscard]] std::string path_panel() const {
    const double right = column_left(1) + kPanelWidth;
    Extent x = padded(extent_of(curves_, kRange)), y = padded(extent_of(curves_, kHeightColumn));
    const double panel_width = (right - kLeft) * kWidth, panel_height = (kTopHigh - kTopLow) * kHeight;
    std::string note = to_scale(x, y, panel_width, panel_height, 0, {"distances", "heights"});
    const bool is_line = is_constant(extent_of(curves_, kRange)) || is_constant(extent_of(curves_, kHeightColumn));
    if (is_line && note != ", to scale") note = "";
    return panel_at(kLeft, right, up(kTopLow), up(kTopHigh)) + range_of("x", x) + range_of("y", y) +
           "set xlabel 'distance [m]' offset 0,0.5\nunset label\n" + panel_title("height [m] over distance" + note) +
           header() + sections(x, y) + curves(kRange, kHeightColumn, 0);
  }

  // What stands under the ways of shots, each cut along its own; behind the curves.
  [[nodiscard]] std::string sections(Extent x, Extent y) const {
    std::string blocks, plots;
    for (const Curve& curve : curves_) {
      if (!scene_) break;
      const Section section = section_along(*scene_, extended(track_of(curve), x), y);
      blocks += section_blocks(section, curve.block);
      plots += section_plots(section, curve.block);
    }
    return blocks + "plot " + plots;
  }

  [[nodiscard]] std::string time_panel(double left, double low, double high, int column, const std::string& label,
                                       int row) const {
    return panel_at(left, left + kPanelWidth, up(low), up(high)) + range_of("x", time_extent()) +
           range_of("y", padded(with_marks(extent_of(curves_, column), column))) + "unset label\n" +
           panel_title(label) + "plot " + curves(kTime, column, row);
  }

  [[nodiscard]] std::string speed_panel() const {
    return "set xlabel 't [s]' offset 0,0.5\n" +
           time_panel(column_left(2), kTopLow, kTopHigh, kSpeed, "speed [m/s]", 3);
  }

  [[nodiscard]] std::string axis_panel(int column, int row, int data_column, const std::string& label) const {
    const double low = kRowLow + (2 - row) * (kRowHeight + kRowGap);
    const std::string below =  // the three panels of a column share their time axis
        row + 1 == rows_ ? "set xlabel 't [s]' offset 0,0.5\nset format x '%g'\n" : "unset xlabel\nset format x ''\n";
    return below + time_panel(column_left(column), low, low + kRowHeight, data_column, label, row);
  }

  [[nodiscard]] Extent with_marks(Extent extent, int column) const {
    const Extent marks = marks_.extent(column);
    extent.add(marks.low), extent.add(marks.high);
    return extent;
  }

  [[nodiscard]] Extent time_extent() const {
    const Extent extent = extent_of(curves_, kTime);
    return extent.high > 0 ? Extent{0, extent.high} : Extent{0, 1};
  }

  std::string title_;
  const Scene* scene_;  // null: no scene
  std::span<const FlownShot> shots_;
  std::size_t all_;
  PlotMarks marks_;
  int rows_;  // of panels of the axes
  std::vector<Curve> curves_;
};

}  // namespace

Picture shots_picture(const std::string& title, std::span<const FlownShot> shots, const Scene* scene,
                      std::span<const Expectation> expected, bool with_jerk) {
  const FlightsPicture picture(title, shots, scene, expected, with_jerk);
  return {kWidth, picture.height(), picture.script()};
}

Content flights_picture(const Flights& flights) {
  const FlownScenario& flown = flights.flown;
  return shots_picture(title_of(flown.scenario), flown.shots, flown.scene ? &*flown.scene : nullptr,
                       flown.scenario.expect, flights.with_jerk);
}

}  // namespace physim::report
