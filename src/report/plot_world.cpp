#include "report/plot_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/number.hpp"
#include "report/plot_extent.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kWidth = 1600, kHeight = 1200;  // [px]
constexpr double kLeft = 0.06, kRight = 0.985;
constexpr std::uint32_t kNoColour = 0xffffffff;
constexpr AxisNames kAxes = {"horizontal axis", "vertical axis"};

using Axis = double Vec3d::*;

std::string numbers(const Vec3d& p) {
  return significant(p.x, 7) + " " + significant(p.y, 7) + " " + significant(p.z, 7) + "\n";
}

// Which column of a datablock an axis is, and how panels call it.
struct AxisText {
  Axis axis;
  int column;
  const char* label;
};
constexpr AxisText kX{&Vec3d::x, 1, "downrange x [m]"}, kY{&Vec3d::y, 2, "height y [m]"},
    kZ{&Vec3d::z, 3, "right z [m]"};

class WorldPicture {
 public:
  explicit WorldPicture(const WorldLog& log) : log_(log) {
    for (const WorldGroup& group : log.groups)
      if (group.spawned > 0) shown_.push_back(static_cast<std::size_t>(&group - log.groups.data()));
    has_hits_ = std::ranges::any_of(log.hits, [](const auto& hits) { return !hits.empty(); });
  }

  [[nodiscard]] std::string script() const {
    std::string out = axes_style() + datablocks() + "set multiplot\n";
    const double split = has_hits_ ? 0.62 : kRight;
    out += panel({kX, kY}, {kLeft, kRight}, {0.535, 0.875}, "from the side: height over distance", header());
    out += panel({kX, kZ}, {kLeft, split}, {0.07, 0.44}, "from above (to the right is down)", "");
    if (has_hits_) out += wall_panel({split + 0.075, kRight}, {0.07, 0.44});
    return out + "unset multiplot\n";
  }

 private:
  struct Axes {
    AxisText across, up;
  };

  // -------------------------------------------------------------------------------------------------------------- data
  [[nodiscard]] std::string datablocks() const {
    std::string out;
    for (const std::size_t g : shown_) {
      const std::string index = std::to_string(g);
      out += "$path" + index + " << EndOfData\n";
      for (const LoggedPath& path : log_.paths) {
        if (path.group != g) continue;
        for (const Vec3d& point : path.points) out += numbers(point);
        out += "\n";
      }
      out += "EndOfData\n" + block("$impact" + index, log_.impacts[g]) + block("$hit" + index, log_.hits[g]);
    }
    return out;
  }
  static std::string block(const std::string& name, const std::vector<Vec3d>& points) {
    std::string out = name + " << EndOfData\n";
    for (const Vec3d& point : points) out += numbers(point);
    return out + "EndOfData\n";
  }

  [[nodiscard]] Extent extent_of(Axis axis) const {
    Extent bounds;
    for (const LoggedPath& path : log_.paths)
      for (const Vec3d& point : path.points) bounds.add(point.*axis);
    for (const auto& list : {log_.impacts, log_.hits})
      for (const auto& points : list)
        for (const Vec3d& point : points) bounds.add(point.*axis);
    if (axis == &Vec3d::y && has_ground()) bounds.add(log_.scenario.world.def.ground.height);
    return bounds.or_zero();
  }
  [[nodiscard]] Extent hit_extent(Axis axis) const {
    Extent bounds;
    for (const auto& points : log_.hits)
      for (const Vec3d& point : points) bounds.add(point.*axis);
    return bounds.or_zero();
  }
  [[nodiscard]] bool has_ground() const { return log_.scenario.world.def.ground.mode != GroundMode::none; }

  // ------------------------------------------------------------------------------------------------------------- looks
  // A shot's own colour where it has one.
  [[nodiscard]] std::string colour(std::size_t group) const {
    const std::uint32_t own = log_.scenario.shots[log_.groups[group].shot].body.colour;
    if (own == kNoColour) {
      const auto at = static_cast<std::size_t>(std::ranges::find(shown_, group) - shown_.begin());
      return std::string(kPalette[at % kPalette.size()]);
    }
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", own >> 8);
    return text;
  }
  // The second round of the palette is dashed.
  [[nodiscard]] std::string dash(std::size_t group) const {
    const bool is_second = std::ranges::find(shown_, group) - shown_.begin() >= static_cast<long>(kPalette.size());
    return is_second ? " dt (14,6)" : " dt 1";
  }
  // Many paths let each other shine through.
  [[nodiscard]] std::string path_style(std::size_t group) const {
    const auto count = std::ranges::count(log_.paths, group, &LoggedPath::group);
    const char* veil = count > 100 ? "#A0" : count > 20 ? "#70" : count > 5 ? "#30" : "#00";
    return std::string(" lw ") + (count > 20 ? "1" : "1.8") + dash(group) + " lc rgb " +
           literal(veil + colour(group).substr(1));
  }
  [[nodiscard]] std::string mark_style(std::size_t group, std::size_t count) const {
    const char* size = count > 2000 ? "0.25" : count > 200 ? "0.45" : "0.8";
    return std::string(" pt 7 ps ") + size + " lc rgb " +
           literal((count > 200 ? "#60" : "#00") + colour(group).substr(1));
  }

  [[nodiscard]] std::string header() const {
    std::string out = title_at(0.02, 0.968, title_of(log_.scenario), kWidth);
    constexpr double kCharacter = 13 * 0.72, kLine = 40, kGap = 26;  // [px]
    double x = 0.02 * kWidth;
    for (const std::size_t g : shown_) {
      const std::string name = shortened(one_line(log_.groups[g].name), 40);
      const double width = kLine + static_cast<double>(display_width(name)) * kCharacter;
      if (x + width > 0.98 * kWidth) {
        out += text_at(x / kWidth, 0.93, "...", 13, kInk);
        break;
      }
      out += "set arrow from screen " + shortest(x / kWidth) + ",0.93 to screen " + shortest((x + kLine - 8) / kWidth) +
             ",0.93 nohead lw 2.5" + dash(g) + " lc rgb " + literal(colour(g)) + "\n" +
             text_at((x + kLine) / kWidth, 0.93, name, 13, kInk);
      x += width + kGap;
    }
    return out;
  }

  // ------------------------------------------------------------------------------------------------------------ panels
  static std::string guide(const std::string& from, const std::string& to) {
    return "set arrow from " + from + " to " + to + " nohead lw 2 lc rgb " + literal("#9A9A9A") + " back\n";
  }

  // Lines where the ground and the wall are.
  [[nodiscard]] std::string guides(const Axes& axes) const {
    std::string out;
    const std::string height = shortest(log_.scenario.world.def.ground.height);
    if (axes.up.axis == &Vec3d::y && has_ground()) out += guide("graph 0,first " + height, "graph 1,first " + height);
    if (axes.across.axis == &Vec3d::x && log_.scenario.world.wall) {
      const std::string wall = shortest(*log_.scenario.world.wall);
      out += guide("first " + wall + ",graph 0", "first " + wall + ",graph 1");
    }
    return out;
  }

  // Paths below, marks above.
  [[nodiscard]] std::string curves(const Axes& axes, bool with_paths, bool with_impacts) const {
    const std::string columns = " using " + std::to_string(axes.across.column) + ":" + std::to_string(axes.up.column);
    std::vector<std::string> parts;
    for (const std::size_t g : shown_)
      if (with_paths && std::ranges::any_of(log_.paths, [g](const LoggedPath& p) { return p.group == g; }))
        parts.push_back("$path" + std::to_string(g) + columns + " with lines" + path_style(g) + " notitle");
    for (const std::size_t g : shown_) {
      if (with_impacts && !log_.impacts[g].empty())
        parts.push_back("$impact" + std::to_string(g) + columns + " with points" +
                        mark_style(g, log_.impacts[g].size()) + " notitle");
      if (!log_.hits[g].empty())
        parts.push_back("$hit" + std::to_string(g) + columns + " with points" + mark_style(g, log_.hits[g].size()) +
                        " notitle");
    }
    std::string out = "plot ";
    for (const std::string& part : parts) out += (&part == parts.data() ? "" : ", ") + part;
    return parts.empty() ? "plot NaN notitle\n" : out + "\n";
  }

  static std::string frame(const Axes& axes, Extent x, Extent y, Extent across, Extent up) {
    const bool is_from_above = axes.up.axis == &Vec3d::z;  // z grows to the right of who looks along x: downwards
    return "unset label\nunset arrow\n" + panel_at(x.low, x.high, y.low, y.high) + range_of("x", across) +
           range_of("y", is_from_above ? Extent{up.high, up.low} : up) + "set xlabel " + literal(axes.across.label) +
           " offset 0,0.5\nset ylabel " + literal(axes.up.label) + " offset 1,0\n";
  }

  [[nodiscard]] std::string panel(const Axes& axes, Extent x, Extent y, const std::string& title,
                                  const std::string& extra) const {
    Extent across = padded(extent_of(axes.across.axis)), up = padded(extent_of(axes.up.axis));
    const bool is_from_above = axes.up.axis == &Vec3d::z;
    const std::string note =
        to_scale(across, up, x.span() * kWidth, y.span() * kHeight, is_from_above ? 0.5 : 0, kAxes);
    return frame(axes, x, y, across, up) + guides(axes) + panel_title(title + note) + extra + curves(axes, true, true);
  }

  [[nodiscard]] std::string wall_panel(Extent x, Extent y) const {
    const Axes axes{kZ, kY};
    Extent across = padded(hit_extent(&Vec3d::z)), up = padded(hit_extent(&Vec3d::y));
    const std::string note = to_scale(across, up, x.span() * kWidth, y.span() * kHeight, 0.5, kAxes);
    return frame(axes, x, y, across, up) + guides(axes) + panel_title("hits on the wall" + note) +
           curves(axes, false, false);
  }

  const WorldLog& log_;
  std::vector<std::size_t> shown_;  // groups that fired
  bool has_hits_ = false;
};

}  // namespace

Content world_picture(const WorldLog& log) { return Picture{kWidth, kHeight, WorldPicture(log).script()}; }

}  // namespace physim::report
