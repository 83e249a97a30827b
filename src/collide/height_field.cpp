#include "collide/height_field.hpp"

#include <algorithm>
#include <string>

namespace physim::collide {

constexpr float kNoHeight = std::numeric_limits<float>::infinity();

Result<HeightField> HeightField::make(const HeightFieldShape& shape) {
  const std::size_t points = std::size_t{shape.columns} * shape.rows;
  if (shape.columns < 2 || shape.rows < 2)
    return Error{"needs two columns and two rows at least", "shape.columns", "a cell lies between four points"};
  if (points > std::numeric_limits<std::uint32_t>::max() / 2)
    return Error{"has more than 2^31 points", "shape.columns", "cut it into several"};
  if (shape.heights.size() != points)
    return Error{"has " + std::to_string(shape.heights.size()) + " numbers, not columns times rows", "shape.heights",
                 std::to_string(points) + " of them"};
  for (const double spacing : {shape.spacing_x, shape.spacing_z})
    if (!(spacing >= 1e-9 && spacing * std::max(shape.columns, shape.rows) <= kFarthest))
      return Error{"must be 1e-9 m at least, and the field within 1e15 m", "shape.spacing_x", "in m"};
  for (std::size_t i = 0; i < points; ++i)
    if (!(std::abs(shape.heights[i]) <= kFarthest))
      return Error{"must be a number within 1e15 m", "shape.heights[" + std::to_string(i) + "]", ""};
  HeightField field;
  field.columns_ = shape.columns;
  field.rows_ = shape.rows;
  field.spacing_x_ = shape.spacing_x;
  field.spacing_z_ = shape.spacing_z;
  field.per_spacing_x_ = 1 / shape.spacing_x;
  field.per_spacing_z_ = 1 / shape.spacing_z;
  field.heights_ = shape.heights;
  const auto [least, most] = std::ranges::minmax(shape.heights);
  field.bounds_.take(Vec3d{0, least, 0});
  field.bounds_.take(Vec3d{(shape.columns - 1) * shape.spacing_x, most, (shape.rows - 1) * shape.spacing_z});
  field.extent_ = std::max({field.bounds_.high.x, field.bounds_.high.z, std::abs(least), std::abs(most)});
  field.middle_ = 0.5 * (least + most);
  const std::size_t more = kBlockSide * std::size_t{shape.columns} + kBlockSide;
  field.rounded_.reserve(points + more);
  for (const double height : shape.heights) field.rounded_.push_back(static_cast<float>(height - field.middle_));
  field.rounded_.resize(points + more);
  PHYSIM_ASSERT(field.heights_.size() == points && least <= field.middle_ && field.middle_ <= most);
  field.build_planes();
  field.build_levels();
  return field;
}

std::size_t HeightField::bytes() const {
  std::size_t sum = heights_.capacity() * sizeof(double) + rounded_.capacity() * sizeof(float) +
                    planes_.capacity() * sizeof(FieldPlane);
  for (const Level& level : levels_) sum += level.blocks.capacity() * sizeof(Heights);
  return sum;
}

/// Each as steep as the heights along the sides of its block are in the mean, and no higher than they need it to be.
void HeightField::build_planes() {
  planes_a_row_ = (columns_ - 2) / kBlockSide + 1;
  planes_.reserve(planes_a_row_ * (std::size_t{rows_ - 2} / kBlockSide + 1));
  for (std::uint32_t row = 0; row + 1 < rows_; row += kBlockSide)
    for (std::uint32_t column = 0; column + 1 < columns_; column += kBlockSide)
      planes_.push_back(plane_over(column, row));
}

FieldPlane HeightField::plane_over(std::uint32_t column, std::uint32_t row) const {
  const std::uint32_t columns = std::min(kBlockSide, columns_ - 1 - column),
                      rows = std::min(kBlockSide, rows_ - 1 - row);
  double along_x = 0, along_z = 0;
  for (std::uint32_t j = 0; j <= rows; ++j) along_x += height(column + columns, row + j) - height(column, row + j);
  for (std::uint32_t i = 0; i <= columns; ++i) along_z += height(column + i, row + rows) - height(column + i, row);
  FieldPlane plane{0, static_cast<float>(along_x / (columns * (rows + 1))),
                   static_cast<float>(along_z / (rows * (columns + 1)))};
  double over = -kInfinity;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      over = std::max(over, height(column + i, row + j) - middle_ - i * static_cast<double>(plane.per_column) -
                                j * static_cast<double>(plane.per_row));
  plane.over = float_above(over);
  return plane;
}

void HeightField::build_levels() {
  const auto blocks = [](std::uint32_t cells, std::uint32_t size) { return (cells + size - 1) / size; };
  Level first{blocks(columns_ - 1, kBlock), blocks(rows_ - 1, kBlock), {}};
  first.blocks.reserve(std::size_t{first.columns} * first.rows);
  for (std::uint32_t row = 0; row < first.rows; ++row)
    for (std::uint32_t column = 0; column < first.columns; ++column) {
      double low = kInfinity, high = -kInfinity;
      for (std::uint32_t j = row * kBlock; j <= std::min((row + 1) * kBlock, rows_ - 1); ++j)
        for (std::uint32_t i = column * kBlock; i <= std::min((column + 1) * kBlock, columns_ - 1); ++i) {
          low = std::min(low, height(i, j));
          high = std::max(high, height(i, j));
        }
      first.blocks.push_back({float_below(low), float_above(high)});
    }
  levels_.push_back(std::move(first));
  while (levels_.back().blocks.size() > 1) {
    const Level& fine = levels_.back();
    Level coarse{blocks(fine.columns, 2), blocks(fine.rows, 2), {}};
    coarse.blocks.assign(std::size_t{coarse.columns} * coarse.rows, {kNoHeight, -kNoHeight});
    for (std::uint32_t row = 0; row < fine.rows; ++row)
      for (std::uint32_t column = 0; column < fine.columns; ++column) {
        Heights& into = coarse.blocks[std::size_t{row / 2} * coarse.columns + column / 2];
        const Heights& from = fine.blocks[std::size_t{row} * fine.columns + column];
        into = {std::min(into.low, from.low), std::max(into.high, from.high)};
      }
    levels_.push_back(std::move(coarse));
  }
}

double HeightField::clear_part(Segment s) const {
  double in = 0, out = s.reach;
  FieldWalk walk;
  if (s.reach < 0 || !begin_walk(s, in, out, walk)) return s.reach;
  const FieldKernel& kernel = field_kernel();
  const FieldGrid over = grid();
  const FieldPoints points{heights_.data(), columns_, spacing_x_, spacing_z_};
  const double per_part = out > in ? 1 / (out - in) : 0;
  for (FieldCells cells = kernel.next_cells(over, walk); cells.some != 0; cells = kernel.next_cells(over, walk)) {
    kernel.clear_cells(points, cells, s);
    walk.reach = std::min(walk.reach, (s.reach - in) * per_part);
  }
  return s.reach;
}

bool HeightField::begin_walk(const Segment& s, double& in, double& out, FieldWalk& walk) const {
  const FieldGrid over = grid();
  const double wide = slack_over(over, s.from, s.along * s.reach, s.radius + s.seam);
  const Vec3d to = s.at(s.reach);
  const auto cut = [&](double from, double end, double along, double high) {
    if (std::min(from, end) >= 0 && std::max(from, end) <= high) return;
    const double per = finite_inverse(along), one = (-wide - from) * per, other = (high + wide - from) * per;
    in = std::max(in, std::min(one, other));
    out = std::min(out, std::max(one, other));
  };
  cut(s.from.x, to.x, s.along.x, bounds_.high.x);
  cut(s.from.z, to.z, s.along.z, bounds_.high.z);
  if (!(in <= out)) return false;
  const auto way = way_over(over, s.at(in), s.along * (out - in), wide);
  if (passes(over, way)) return false;
  const auto from_block = [](CellRange<double> cells) {
    cells.first -= static_cast<double>(static_cast<std::uint32_t>(cells.first) % kBlockSide);
    return cells;
  };
  const CellRange<double> columns = from_block(columns_of(way)), rows = from_block(rows_of(way));
  const BlockWay<double> block = way_in_block(over, way, columns.first, rows.first);
  each_number(block, [&](int i, double number) {
    walk.numbers[i] = number;
    walk.rounded[i] = static_cast<float>(number);
  });
  walk.first[0] = static_cast<std::uint32_t>(columns.first), walk.count[0] = count_of(columns);
  walk.first[1] = static_cast<std::uint32_t>(rows.first), walk.count[1] = count_of(rows);
  walk.axis = std::abs(block.along_x) >= std::abs(block.along_z) ? 0 : 1;
  walk.strips = (walk.count[walk.axis] + kBlockSide - 1) / kBlockSide;
  walk.begun = walk.across = walk.some[0] = walk.some[1] = 0;
  walk.within = walk.reach = 1;
  return true;
}

/// About a block; empty where it lies beyond the field.
Bounds HeightField::box(std::size_t level, std::uint32_t column, std::uint32_t row) const {
  PHYSIM_ASSERT(level < levels_.size());
  const Level& of = levels_[level];
  if (column >= of.columns || row >= of.rows) return {};
  const double cells = std::uint64_t{kBlock} << level;
  const Heights& heights = of.blocks[std::size_t{row} * of.columns + column];
  Bounds box;
  box.take(Vec3d{column * cells * spacing_x_, heights.low, row * cells * spacing_z_});
  box.take(Vec3d{std::min((column + 1) * cells, columns_ - 1.0) * spacing_x_, heights.high,
                 std::min((row + 1) * cells, rows_ - 1.0) * spacing_z_});
  return box;
}

Bounds HeightField::cell_box(std::uint32_t column, std::uint32_t row) const {
  Bounds box;
  for (const std::uint32_t j : {row, row + 1})
    for (const std::uint32_t i : {column, column + 1}) box.take(point(i, j));
  return box;
}

double HeightField::clearance(const Vec3d& p) const {
  double within = kFarthest;
  // What is below it or above it is near it, too, where heights are no cliffs: little else is looked at then.
  const double column = std::clamp(p.x * per_spacing_x_, 0.0, columns_ - 2.0);
  const double row = std::clamp(p.z * per_spacing_z_, 0.0, rows_ - 2.0);
  clear_of_cell(p, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), within);
  clear_of(p, levels_.size() - 1, 0, 0, within);
  return within;
}

/// Goes into a block that is not farther than it is large, the nearest quarter first. Of a distance from a triangle
/// half is kept, so that what is not nearer than that need not be looked at.
void HeightField::clear_of(const Vec3d& p, std::size_t level, std::uint32_t column, std::uint32_t row,
                           double& within) const {
  const Bounds about = box(level, column, row);
  if (about.low.x > about.high.x) return;
  const double distance = about.least_distance(p);
  if (distance >= within) return;
  if (distance > length(about.high - about.low)) return void(within = distance);
  if (level > 0) {
    const Vec3d middle = about.middle();
    const std::uint32_t right = p.x > middle.x ? 1 : 0, far = p.z > middle.z ? 1 : 0;
    for (std::uint32_t i = 0; i < 4; ++i)
      clear_of(p, level - 1, 2 * column + (right ^ (i & 1)), 2 * row + (far ^ (i >> 1)), within);
    return;
  }
  for (std::uint32_t j = row * kBlock; j < std::min((row + 1) * kBlock, rows_ - 1); ++j)
    for (std::uint32_t i = column * kBlock; i < std::min((column + 1) * kBlock, columns_ - 1); ++i) {
      const Bounds cell = cell_box(i, j);
      const double beside = cell.least_distance(p);
      if (beside >= within) continue;
      if (beside > length(cell.high - cell.low))
        within = beside;
      else
        clear_of_cell(p, i, j, within);
    }
}

void HeightField::clear_of_cell(const Vec3d& p, std::uint32_t column, std::uint32_t row, double& within) const {
  for (std::uint32_t half = 0; half < 2; ++half)
    within = std::min(within, 0.5 * length(p - nearest_point(triangle(column, row, half), p)));
}

/// Rings of cells about the point, until none can be nearer.
std::optional<NearPlace> HeightField::nearest(const Vec3d& p, double& within) const {
  std::optional<NearPlace> found;
  const auto cell_of = [](double place, double spacing, std::uint32_t points) {
    return static_cast<std::int64_t>(std::clamp(std::floor(place / spacing), 0.0, points - 2.0));
  };
  const std::int64_t column = cell_of(p.x, spacing_x_, columns_), row = cell_of(p.z, spacing_z_, rows_);
  const std::int64_t last_column = columns_ - 2, last_row = rows_ - 2;
  const auto look_at = [&](std::int64_t i, std::int64_t j) {
    if (i < 0 || i > last_column || j < 0 || j > last_row) return;
    const auto of_column = static_cast<std::uint32_t>(i), of_row = static_cast<std::uint32_t>(j);
    if (cell_box(of_column, of_row).least_distance(p) > within) return;
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Triangle cell = triangle(of_column, of_row, half);
      const Nearest near = nearest_to(cell, p);
      if (!(near.distance <= within)) continue;
      within = near.distance;
      found = {p - near.away * within, within > 0 ? near.away : cell.normal(), number(of_column, of_row, half)};
    }
  };
  const auto beside = [](double place, double spacing, std::int64_t cell, std::int64_t last, std::int64_t ring) {
    const double before = cell >= ring ? place - static_cast<double>(cell - ring + 1) * spacing : kInfinity;
    const double behind = cell + ring <= last ? static_cast<double>(cell + ring) * spacing - place : kInfinity;
    return std::min(before, behind);
  };
  const std::int64_t most = std::max({column, last_column - column, row, last_row - row});
  for (std::int64_t ring = 0; ring <= most; ++ring) {
    if (ring > 0 && std::min(beside(p.x, spacing_x_, column, last_column, ring),
                             beside(p.z, spacing_z_, row, last_row, ring)) > within)
      break;
    for (std::int64_t i = -ring; i <= ring; ++i) {
      const bool side = i == -ring || i == ring;
      for (std::int64_t j = -ring; j <= ring; j += side ? 1 : std::max<std::int64_t>(2 * ring, 1))
        look_at(column + i, row + j);
    }
  }
  return found;
}

}  // namespace physim::collide
