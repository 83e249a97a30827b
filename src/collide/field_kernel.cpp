// Compiled once per instruction set, in a namespace of its name.
#include "collide/field_walk.hpp"
#include "collide/triangle.hpp"

PHYSIM_ISA_BEGIN

namespace {

constexpr std::size_t kWide = kNativeBytes / 8;
using Numbers = Pack<double, int(kWide)>;
static_assert(collide::kFieldSegments % kWide == 0);

/// Numbers of the segments, each in a column of its own.
struct Columns {
  double from[3][collide::kFieldSegments], along[3][collide::kFieldSegments], radius[collide::kFieldSegments];

  PHYSIM_INLINE static Vec3<Numbers> load(const double (&columns)[3][collide::kFieldSegments], std::size_t i) {
    return {Numbers::load(columns[0] + i), Numbers::load(columns[1] + i), Numbers::load(columns[2] + i)};
  }
};

/// The last one is there once more where a pack wants so many.
PHYSIM_INLINE void put_columns(const collide::FieldJob& job, Columns& columns) {
  for (std::size_t i = 0; i < (job.count + kWide - 1) / kWide * kWide; ++i) {
    const SceneSegment& s = job.segments[job.numbers[i < job.count ? i : job.count - 1]];
    columns.from[0][i] = s.from.x, columns.from[1][i] = s.from.y, columns.from[2][i] = s.from.z;
    columns.along[0][i] = s.to.x - s.from.x, columns.along[1][i] = s.to.y - s.from.y;
    columns.along[2][i] = s.to.z - s.from.z;
    columns.radius[i] = s.radius;
  }
}

/// As seen from the field.
PHYSIM_INLINE Vec3<Numbers> turned_back(const collide::FieldJob& job, const Vec3<Numbers>& v) {
  const auto along = [&](const Vec3d& axis) PHYSIM_INLINE_LAMBDA {
    return (v.x * Numbers(axis.x) + v.y * Numbers(axis.y) + v.z * Numbers(axis.z)) * Numbers(job.per_scale);
  };
  return {along(job.x), along(job.y), along(job.z)};
}

/// What is known of a pack of segments.
struct Looks {
  float numbers[kBlockWayNumbers][kWide];
  double first_column[kWide], last_column[kWide], first_row[kWide], last_row[kWide];
  unsigned pass, far;  // a bit for each
};

PHYSIM_INLINE void put_looks(const collide::FieldJob& job, const Columns& columns, std::size_t i, Looks& looks) {
  const collide::FieldGrid& grid = job.grid;
  const Vec3<Numbers> position{Numbers(job.position.x), Numbers(job.position.y), Numbers(job.position.z)};
  const Vec3<Numbers> start = Columns::load(columns.from, i), way_in_world = Columns::load(columns.along, i);
  const Vec3<Numbers> from = turned_back(job, start - position);
  const Vec3<Numbers> along = turned_back(job, way_in_world);
  const auto extent_of = [](const Vec3<Numbers>& v)
                             PHYSIM_INLINE_LAMBDA { return max(abs(v.x), max(abs(v.y), abs(v.z))); };
  const Numbers own = Numbers::load(columns.radius + i), extent = extent_of(start) + extent_of(way_in_world) + own;
  // With the seam that a Placement gives a segment.
  const Numbers seam = max(extent, extent_of(position)) * Numbers(8 * std::numeric_limits<double>::epsilon());
  const Numbers radius = (own + seam) * Numbers(job.per_scale);
  const FieldWay<Numbers> way = way_over(grid, from, along, slack_over(grid, from, along, radius));
  const CellRange<Numbers> over_x = cells_between(way.from.x, way.from.x + way.along.x, way.wide_x, grid.columns);
  const CellRange<Numbers> over_z = cells_between(way.from.z, way.from.z + way.along.z, way.wide_z, grid.rows);
  const BlockWay<Numbers> block = way_in_block(grid, way, over_x.first, over_z.first);
  const Numbers* number = &block.x;
  static_assert(sizeof block == kBlockWayNumbers * sizeof(Numbers));
  PHYSIM_ASSERT(i % kWide == 0 && i < job.count && all(radius >= Numbers(0.0)));
  for (int k = 0; k < kBlockWayNumbers; ++k) cast<float>(number[k]).store(looks.numbers[k]);
  over_x.first.store(looks.first_column);
  over_x.last.store(looks.last_column);
  over_z.first.store(looks.first_row);
  over_z.last.store(looks.last_row);
  const Numbers most(collide::kBlockSide - 1.0);
  looks.pass = lane_bits(passes(grid, way));
  looks.far = lane_bits((over_x.last - over_x.first > most) | (over_z.last - over_z.first > most) |
                        (way.size(over_x.first, over_z.first) > Numbers(collide::kManyCells)));
}

using Four = Pack<double, 4>;

/// A corner of each half of two cells, as HeightField::triangle() has them: by its coordinates in the one cell and in
/// the other.
struct TwoCells {
  double x[2][2], z[2][2];       // of the near and the far side of each cell
  double near[2][2], far[2][2];  // heights at its near row, left and right, and at its far row

  PHYSIM_INLINE void put(const collide::FieldPoints& points, std::uint32_t column, std::uint32_t row,
                         std::size_t cell) {
    const double* from = points.heights + std::size_t{row} * points.columns + column;
    x[cell][0] = column * points.spacing_x, x[cell][1] = (column + 1) * points.spacing_x;
    z[cell][0] = row * points.spacing_z, z[cell][1] = (row + 1) * points.spacing_z;
    near[cell][0] = from[0], near[cell][1] = from[1];
    far[cell][0] = from[points.columns], far[cell][1] = from[points.columns + 1];
  }
  PHYSIM_INLINE Vec3<Four> first() const {
    return {collide::four<Four>(x[0][0], x[0][1], x[1][0], x[1][1]),
            collide::four<Four>(near[0][0], near[0][1], near[1][0], near[1][1]),
            collide::four<Four>(z[0][0], z[0][0], z[1][0], z[1][0])};
  }
  PHYSIM_INLINE Vec3<Four> second() const {
    return {collide::four<Four>(x[0][0], x[0][0], x[1][0], x[1][0]),
            collide::four<Four>(far[0][0], far[0][0], far[1][0], far[1][0]),
            collide::four<Four>(z[0][1], z[0][1], z[1][1], z[1][1])};
  }
  PHYSIM_INLINE Vec3<Four> third() const {
    return {collide::four<Four>(x[0][1], x[0][1], x[1][1], x[1][1]),
            collide::four<Four>(near[0][1], far[0][1], near[1][1], far[1][1]),
            collide::four<Four>(z[0][0], z[0][1], z[1][0], z[1][1])};
  }
};

}  // namespace

collide::FieldCells next_cells(const collide::FieldGrid& grid, collide::FieldWalk& walk) {
  for (;;) {
    while ((walk.some[0] | walk.some[1]) == 0) {
      if (walk.begun >= walk.strips) return {0, 0, 0};
      look_at_strips(grid, walk);
    }
    collide::FieldCells block = next_block(walk);
    if (block.some == 0) continue;
    const auto columns = static_cast<float>(block.column), rows = static_cast<float>(block.row);
    block.column += walk.first[0];
    block.row += walk.first[1];
    block.some = cells_met(grid, walk.rounded, 1, block, columns, rows);
    if (block.some != 0) return block;
  }
}

std::uint32_t cells_in_block(const collide::FieldGrid& grid, const float* way, const collide::FieldCells& block) {
  return cells_met(grid, way, 1, block);
}

void clear_cells(const collide::FieldPoints& points, const collide::FieldCells& cells, collide::Segment& segment) {
  for (std::uint32_t some = cells.some; some != 0;) {
    // The halves of two cells; the last one comes twice where it is alone.
    TwoCells two;
    std::uint32_t cell = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (some != 0) cell = static_cast<std::uint32_t>(std::countr_zero(some));
      some &= some - 1;
      two.put(points, cells.column + cell % collide::kBlockSide, cells.row + cell / collide::kBlockSide, i);
    }
    Four part(0.0);
    const auto touched = collide::may_touch(segment, two.first(), two.second(), two.third(), part);
    if (!any(touched)) continue;
    double reach[4];
    select(touched, part, Four(segment.reach)).store(reach);
    for (const double each : reach) segment.reach = min(segment.reach, each);
  }
}

void find_cells(collide::FieldJob& job) {
  PHYSIM_ASSERT(job.count <= collide::kFieldSegments && job.near != nullptr && job.numbers != nullptr);
  Columns columns;
  put_columns(job, columns);
  job.found = 0;
  for (std::size_t i = 0; i < job.count; i += kWide) {
    Looks looks;
    put_looks(job, columns, i, looks);
    const std::size_t here = job.count - i < kWide ? job.count - i : kWide;
    for (std::size_t lane = 0; lane < here; ++lane) {
      const auto column = static_cast<std::uint32_t>(looks.first_column[lane]);
      const auto row = static_cast<std::uint32_t>(looks.first_row[lane]);
      std::uint32_t some = collide::FieldCells::kFar;
      if ((looks.far >> lane & 1u) == 0)
        some = cells_met(job.grid, &looks.numbers[0][lane], kWide,
                         {column, row,
                          block_of(static_cast<std::uint32_t>(looks.last_column[lane]) - column + 1,
                                   static_cast<std::uint32_t>(looks.last_row[lane]) - row + 1)});
      some &= (looks.pass >> lane & 1u) - 1u;
      job.near[job.found] = {job.numbers[i + lane], {column, row, some}};
      job.found += some != 0 ? 1 : 0;
    }
  }
}

PHYSIM_ISA_END
