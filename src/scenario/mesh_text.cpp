#include "scenario/mesh_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/assert.hpp"

namespace physim {
namespace {

std::string_view blanks_off(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r");
  return at == text.npos ? std::string_view{} : text.substr(at);
}
/// Takes the next word off the front; empty if there is none.
std::string_view take_word(std::string_view& text) {
  text = blanks_off(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r"));
  text.remove_prefix(word.size());
  return word;
}
/// Takes the next line off the front, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return line;
}
bool read_number(std::string_view word, double& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(number);
}

/// The lines that hold corners, by their first word or, in PLY, by their numbers; and which of their words are x, y
/// and z.
struct Layout {
  std::string_view keyword{};  // "v" or "vertex"; empty: lines by their number
  std::size_t first = 0, count = 0;
  std::array<std::size_t, 3> words{0, 1, 2};
};

/// The layout of a PLY in digits whose corners come first.
std::optional<Layout> layout_of_ply(std::string_view text) {
  constexpr double kMostCorners = 1e9;
  Layout layout;
  bool in_corners = false, in_digits = false, has_elements = false;
  std::size_t property = 0, found = 0;
  for (std::size_t number = 0; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    const std::string_view word = take_word(line);
    if (word == "format") in_digits = take_word(line) == "ascii";
    if (word == "element") {
      in_corners = take_word(line) == "vertex";
      double count = 0;
      if (in_corners && (has_elements || !read_number(take_word(line), count))) return std::nullopt;
      if (!(count >= 0 && count <= kMostCorners)) return std::nullopt;
      if (in_corners) layout.count = static_cast<std::size_t>(count);
      has_elements = true;
    }
    if (word == "property" && in_corners) {
      if (take_word(line) == "list") return std::nullopt;
      const std::string_view name = take_word(line);
      PHYSIM_ASSERT(found < 3 || property >= 3);
      if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') {
        layout.words[static_cast<std::size_t>(name[0] - 'x')] = property;
        ++found;
      }
      ++property;
    }
    if (word != "end_header") continue;
    layout.first = number + 1;
    return in_digits && found == 3 ? std::optional(layout) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<Layout> layout_of(std::string_view text) {
  if (text.find('\0') != text.npos) return std::nullopt;  // numbers in bytes
  if (text.starts_with("ply")) return layout_of_ply(text);
  if (blanks_off(text).starts_with("solid") && text.find("vertex") != text.npos) return Layout{.keyword = "vertex"};
  if (text.starts_with("v ") || text.find("\nv ") != text.npos) return Layout{.keyword = "v"};
  return std::nullopt;
}

/// The three numbers of a line of a corner, as views into it; nothing if the line has no corner.
std::optional<std::array<std::string_view, 3>> corner_of(std::string_view line, const Layout& layout,
                                                         std::size_t number) {
  if (layout.keyword.empty() ? number < layout.first || number - layout.first >= layout.count
                             : take_word(line) != layout.keyword)
    return std::nullopt;
  std::array<std::string_view, 3> words;
  for (std::size_t i = 0, taken = 0; taken < 3; ++i) {
    const std::string_view word = take_word(line);
    if (word.empty()) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (layout.words[axis] == i) words[axis] = word, ++taken;
  }
  return words;
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
bool read_place(const std::array<std::string_view, 3>& words, FilePlace& place) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!read_number(words[axis], place[axis])) return false;
  return true;
}

/// The first corner, and how much a whole number is worth; nothing if a corner has a word that is no number.
struct Grid {
  std::optional<FilePlace> origin{};
  double step = 0;
};
std::optional<Grid> grid_of(std::string_view text, const Layout& layout) {
  Grid grid;
  bool sound = true;
  each_line(text, layout, [&](std::string_view, const auto& words) {
    FilePlace at{};
    if (!words || !(sound = sound && read_place(*words, at))) return;
    if (!grid.origin) grid.origin = at;
    for (std::size_t axis = 0; axis < 3; ++axis)
      grid.step = std::max(grid.step, std::abs(at[axis] - (*grid.origin)[axis]) / (1 << 23));
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
      FilePlace at{};
      read_place(*words, at);
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
