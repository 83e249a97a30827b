#include "scenario/mesh_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/assert.hpp"
#include "scenario/text_file.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

/// The lines that hold corners, by their first word or, in PLY, by their numbers; and which of their words are x, y
/// and z.
struct Layout {
  std::string_view keyword{};  // "v" or "vertex"; empty: lines by their number
  std::size_t first = 0, count = 0;
  std::array<std::size_t, 3> words{1, 2, 3};
};

/// The layout of a PLY in digits whose corners come first.
std::optional<Layout> layout_of_ply(std::string_view text) {
  constexpr double kMostCorners = 1e9;
  Layout layout;
  bool in_corners = false, in_digits = false, has_elements = false;
  std::size_t property = 0;
  unsigned found = 0;  // a bit for each axis
  for (std::size_t number = 0; !text.empty(); ++number) {
    std::vector<std::string_view> words = words_of(take_line(text));
    if (!words.empty() && words[0] == "end_header") {
      layout.first = number + 1;
      return in_digits && found == 7 ? std::optional(layout) : std::nullopt;
    }
    if (words.size() < 3) continue;
    if (words[0] == "format") in_digits = words[1] == "ascii";
    if (words[0] == "element") {
      in_corners = words[1] == "vertex";
      const std::optional<double> count = finite_number(words[2]);
      const bool is_count = count && *count >= 0 && *count <= kMostCorners;
      if (in_corners && (has_elements || !is_count)) return std::nullopt;
      if (in_corners) layout.count = static_cast<std::size_t>(*count);
      has_elements = true;
    }
    if (words[0] != "property" || !in_corners) continue;
    if (words[1] == "list") return std::nullopt;
    if (const std::size_t axis = std::string_view("xyz").find(words[2]); words[2].size() == 1 && axis < 3) {
      if ((found >> axis & 1u) != 0) return std::nullopt;  // named twice
      layout.words[axis] = property;
      found |= 1u << axis;
    }
    ++property;
  }
  return std::nullopt;
}

std::optional<Layout> layout_of(std::string_view text) {
  if (text.find('\0') != text.npos) return std::nullopt;  // numbers in bytes
  if (text.starts_with("ply")) return layout_of_ply(text);
  if (trimmed(text).starts_with("solid") && text.find("vertex") != text.npos) return Layout{.keyword = "vertex"};
  if (text.starts_with("v ") || text.find("\nv ") != text.npos) return Layout{.keyword = "v"};
  return std::nullopt;
}

/// The three numbers of a line of a corner, as views into it; nothing if the line has no corner.
std::optional<std::array<std::string_view, 3>> corner_of(std::string_view line, const Layout& layout,
                                                         std::size_t number) {
  const std::vector<std::string_view> words = words_of(line);
  const bool has_corner = layout.keyword.empty() ? number >= layout.first && number - layout.first < layout.count
                                                 : !words.empty() && words[0] == layout.keyword;
  if (!has_corner || words.size() <= std::ranges::max(layout.words)) return std::nullopt;
  return std::array{words[layout.words[0]], words[layout.words[1]], words[layout.words[2]]};
}

/// Calls `take` with each line, and with the words of its corner where it has one.
template <class Take>
void each_line(std::string_view text, const Layout& layout, const Take& take) {
  for (std::size_t number = 0; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    take(line, corner_of(line, layout, number));
  }
}

using FilePlace = std::array<double, 3>;
std::optional<FilePlace> place_of(const std::array<std::string_view, 3>& words) {
  FilePlace place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double> number = finite_number(words[axis]);
    if (!number) return std::nullopt;
    place[axis] = *number;
  }
  return place;
}

/// The whole numbers that stand for places.
struct Grid {
  std::optional<FilePlace> origin{};  // the first corner [unit of the file]
  double step = 0;                    // the worth of one [unit of the file]
};
/// Nothing if a corner has a word that is no number.
std::optional<Grid> grid_of(std::string_view text, const Layout& layout) {
  Grid grid;
  bool sound = true;
  each_line(text, layout, [&](std::string_view, const auto& words) {
    if (!words || !sound) return;
    const std::optional<FilePlace> at = place_of(*words);
    sound = at.has_value();
    if (!at) return;
    if (!grid.origin) grid.origin = at;
    for (std::size_t axis = 0; axis < 3; ++axis)
      grid.step = std::max(grid.step, std::abs((*at)[axis] - (*grid.origin)[axis]) / (1 << 23));
  });
  if (!sound || !grid.origin || !std::isfinite(grid.step)) return std::nullopt;
  if (grid.step == 0) grid.step = 1;
  return grid;
}

}  // namespace

std::optional<NumberedMesh> numbered_mesh(const std::string& text) {
  const std::optional<Layout> layout = layout_of(text);
  const std::optional<Grid> grid = layout ? grid_of(text, *layout) : std::nullopt;
  if (!grid) return std::nullopt;
  PHYSIM_ASSERT(grid->step > 0);
  NumberedMesh mesh;
  each_line(text, *layout, [&](std::string_view line, const auto& words) {
    const char* done = line.data();
    if (words) {
      const FilePlace at = *place_of(*words);
      NumberedMesh::Corner corner{};
      std::array<std::size_t, 3> order{0, 1, 2};  // of the words in the line
      std::ranges::sort(order, {}, [&](std::size_t axis) { return (*words)[axis].data(); });
      for (const std::size_t axis : order) {
        const long number = std::lround((at[axis] - (*grid->origin)[axis]) / grid->step);
        PHYSIM_ASSERT(std::abs(number) <= 1 << 23);  // a float holds it
        corner[axis] = static_cast<float>(number);
        mesh.text.append(done, (*words)[axis].data()).append(std::to_string(number));
        done = (*words)[axis].data() + (*words)[axis].size();
      }
      mesh.places.try_emplace(corner, Vec3d{at[0], at[1], at[2]});
    }
    mesh.text.append(done, line.data() + line.size()).push_back('\n');
  });
  return mesh;
}

}  // namespace physim
