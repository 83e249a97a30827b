#include <algorithm>
#include <cstdio>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/pictures.hpp"
#include "report/scene_section.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kWorldWidth = 1600, kWorldHeight = 1200;  // [px]
constexpr double kLeft = 0.06, kRight = 0.985;
constexpr std::uint32_t kNoColour = 0xffffffff;
constexpr AxisNames kAxes = {"horizontal axis", "vertical axis"};

using Axis = double Vec3d::*;

std::string rows_of(const std::vector<Vec3d>& points) {
  std::string out;
  for (const Vec3d& p : points)
    out += significant(p.x, 7) + " " + significant(p.y, 7) + " " + significant(p.z, 7) + "\n";
  return out;
}

void add(const std::vector<Vec3d>& points, Axis axis, Extent& extent) {
  for (const Vec3d& point : points) extent.add(point.*axis);
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
    PHYSIM_ASSERT(log.impacts.size() == log.groups.size());
    PHYSIM_ASSERT(log.hits.size() == log.groups.size());
    PHYSIM_ASSERT(log.alive.size() == log.groups.size());
    for (const WorldGroup& group : log.groups)
      if (group.spawned > 0) shown_.push_back(static_cast<std::size_t>(&group - log.groups.data()));
    colours_ = colours();
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
      std::string paths;
      for (const LoggedPath& path : log_.paths)
        if (path.group == g) paths += rows_of(path.points) + "\n";
      out += datablock("$path" + index, paths) + datablock("$impact" + index, rows_of(log_.impacts[g])) +
             datablock("$hit" + index, rows_of(log_.hits[g])) + datablock("$alive" + index, rows_of(log_.alive[g]));
    }
    return out;
  }

  [[nodiscard]] Extent extent_of(Axis axis) const {
    Extent bounds;
    for (const LoggedPath& path : log_.paths) add(path.points, axis, bounds);
    for (const auto* list : {&log_.impacts, &log_.hits, &log_.alive})
      for (const auto& points : *list) add(points, axis, bounds);
    if (axis == &Vec3d::y && has_ground()) bounds.add(log_.scenario.world.def.ground.height);
    return bounds.or_zero();
  }
  [[nodiscard]] Extent hit_extent(Axis axis) const {
    Extent bounds;
    for (const auto& points : log_.hits) add(points, axis, bounds);
    return bounds.or_zero();
  }
  [[nodiscard]] bool has_ground() const { return log_.scenario.world.def.ground.mode != GroundMode::none; }

  // ------------------------------------------------------------------------------------------------------------- looks
  // Among the groups that are shown.
  [[nodiscard]] std::size_t place_of(std::size_t group) const {
    const auto found = std::ranges::find(shown_, group);
    PHYSIM_ASSERT(found != shown_.end());
    return static_cast<std::size_t>(found - shown_.begin());
  }
  // An emitter's particles have the colour that the scenario gives them at their start, others that of their shot.
  [[nodiscard]] std::uint32_t own_colour(const WorldGroup& group) const {
    const auto& emitters = log_.scenario.emitters;
    const auto fires = std::ranges::find(emitters, group.name, [](const auto& emitter) { return emitter.def.name; });
    if (!group.emitter || fires == emitters.end()) return log_.scenario.shots[group.shot].body.colour;
    return fires->def.start.colour.colour;
  }
  // Colours of the groups that are shown: their own, where they have one; others have that of their place, or the first
  // that is left where another group has it.
  [[nodiscard]] std::vector<std::string> colours() const {
    std::vector<std::string> list(shown_.size());
    const auto give_those_left = [&](const auto& wanted) {
      for (std::size_t i = 0; i < list.size(); ++i)
        if (std::string colour = list[i].empty() ? wanted(i) : ""; !colour.empty()) list[i] = std::move(colour);
    };
    const auto if_free = [&](std::string_view colour) {
      return std::ranges::count(list, colour) == 0 ? std::string(colour) : std::string();
    };
    give_those_left([&](std::size_t i) {
      const std::uint32_t own = own_colour(log_.groups[shown_[i]]);
      char text[8] = "";
      if (own != kNoColour) std::snprintf(text, sizeof text, "#%06X", own >> 8);
      return std::string(text);
    });
    give_those_left([&](std::size_t i) { return i < kPalette.size() ? if_free(kPalette[i]) : ""; });
    give_those_left([&](std::size_t) {
      for (const std::string_view colour : kPalette)
        if (std::string free = if_free(colour); !free.empty()) return free;
      return std::string();
    });
    give_those_left([&](std::size_t i) { return std::string(kPalette[i % kPalette.size()]); });
    return list;
  }
  [[nodiscard]] const std::string& colour(std::size_t group) const { return colours_[place_of(group)]; }
  // Many paths let each other shine through.
  [[nodiscard]] std::string path_style(std::size_t group) const {
    const auto count = std::ranges::count(log_.paths, group, &LoggedPath::group);
    const char* veil = count > 100 ? "#A0" : count > 20 ? "#70" : count > 5 ? "#30" : "#00";
    return curve_style(count > 20 ? "1" : "1.8", place_of(group), veil + colour(group).substr(1));
  }
  [[nodiscard]] std::string mark_style(std::size_t group, std::size_t count) const {
    const char* size = count > 2000 ? "0.25" : count > 200 ? "0.45" : "0.8";
    return std::string(" pt 7 ps ") + size + " lc rgb " +
           literal((count > 200 ? "#60" : "#00") + colour(group).substr(1));
  }

  [[nodiscard]] std::string header() const {
    std::string out = title_at(0.02, 0.968, title_of(log_.scenario), kWorldWidth);
    double x = 0.02 * kWorldWidth;
    for (const std::size_t g : shown_) {
      const std::string name = shortened(one_line(log_.groups[g].name), 40);
      const double width = legend_width(name);
      if (x + width > 0.98 * kWorldWidth) {
        out += text_at(x / kWorldWidth, 0.93, "...", 13, kInk);
        break;
      }
      out += legend_entry(x, 0.93, name, curve_style("2.5", place_of(g), colour(g)), kWorldWidth);
      x += width + kLegendGap;
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
    std::string out;
    const auto add = [&](const std::string& block, std::size_t group, const std::string& style) {
      out += (out.empty() ? "$" : ", $") + block + std::to_string(group) + columns + " with " + style + " notitle";
    };
    for (const std::size_t g : shown_)
      if (with_paths && std::ranges::count(log_.paths, g, &LoggedPath::group) > 0)
        add("path", g, "lines" + path_style(g));
    for (const std::size_t g : shown_) {
      const std::size_t impacts = log_.impacts[g].size(), hits = log_.hits[g].size(), alive = log_.alive[g].size();
      if (with_impacts && impacts > 0) add("impact", g, "points" + mark_style(g, impacts));
      if (hits > 0) add("hit", g, "points" + mark_style(g, hits));
      if (with_paths && alive > 0) add("alive", g, "points" + mark_style(g, alive));
    }
    return out.empty() ? "NaN notitle\n" : out + "\n";
  }

  static std::string frame(const Axes& axes, Extent x, Extent y, Extent across, Extent up) {
    const bool is_from_above = axes.up.axis == &Vec3d::z;  // z grows to the right of a viewer along x: downwards
    return "unset label\nunset arrow\n" + panel_at(x.low, x.high, y.low, y.high) + range_of("x", across) +
           range_of("y", is_from_above ? Extent{up.high, up.low} : up) + "set xlabel " + literal(axes.across.label) +
           " offset 0,0.5\nset ylabel " + literal(axes.up.label) + " offset 1,0\n";
  }

  [[nodiscard]] std::string panel(const Axes& axes, Extent x, Extent y, const std::string& title,
                                  const std::string& extra) const {
    Extent across = padded(extent_of(axes.across.axis)), up = padded(extent_of(axes.up.axis));
    const bool is_from_above = axes.up.axis == &Vec3d::z;
    const std::string note =
        to_scale(across, up, x.span() * kWorldWidth, y.span() * kWorldHeight, is_from_above ? 0.5 : 0, kAxes);
    const Section section = is_from_above ? Section{} : section_of(across, up);
    return frame(axes, x, y, across, up) + guides(axes) + panel_title(title + note) + extra +
           section_blocks(section, "$things") + "plot " + section_plots(section, "$things") + curves(axes, true, true);
  }

  // What stands where most of what flies does: a cut along x, as things are in the end.
  [[nodiscard]] Section section_of(Extent across, Extent up) const {
    if (log_.scenario.things.empty()) return {};
    const Result<Scene> scene = scene_of(log_.scenario);
    if (!scene) return {};  // it ran with it
    double sum = 0, count = 0;
    for (const LoggedPath& path : log_.paths)
      for (const Vec3d& point : path.points) sum += point.z, ++count;
    const double z = count > 0 ? sum / count : 0;
    const std::vector<TrackPlace> track = {{across.low, across.low, z, log_.time},
                                           {across.high, across.high, z, log_.time}};
    return section_along(*scene, extended(track, across), up);
  }

  [[nodiscard]] std::string wall_panel(Extent x, Extent y) const {
    const Axes axes{kZ, kY};
    Extent across = padded(hit_extent(&Vec3d::z)), up = padded(hit_extent(&Vec3d::y));
    const std::string note = to_scale(across, up, x.span() * kWorldWidth, y.span() * kWorldHeight, 0.5, kAxes);
    return frame(axes, x, y, across, up) + guides(axes) + panel_title("hits on the wall" + note) + "plot " +
           curves(axes, false, false);
  }

  const WorldLog& log_;
  std::vector<std::size_t> shown_;    // groups that fired
  std::vector<std::string> colours_;  // theirs
  bool has_hits_ = false;
};

}  // namespace

Content world_picture(const WorldLog& log) { return Picture{kWorldWidth, kWorldHeight, WorldPicture(log).script()}; }

}  // namespace physim::report
