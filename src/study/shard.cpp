#include "study/shard.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "study/cells.hpp"
#include "study/estimates.hpp"
#include "study/indices.hpp"
#include "study/over_inputs.hpp"
#include "study/shard_job.hpp"
#include "study/targets.hpp"
#include "study/zone.hpp"

namespace physim {
namespace {

/// A function's columns are read, not written.
std::vector<std::span<const double>> read_only(std::span<const std::span<double>> columns) {
  return {columns.begin(), columns.end()};
}

CountedCells empty_cells(double centre, double scale) { return {.centre = centre, .scale = scale}; }

}  // namespace

void ShotBlock::set_size(std::size_t columns_wanted, std::size_t rows) {
  numbers.resize(columns_wanted * rows);
  columns.clear();
  for (std::size_t i = 0; i < columns_wanted; ++i) columns.push_back(std::span(numbers).subspan(i * rows, rows));
}

ModelTold ShardFlyer::evaluate(const ShotBlock& inputs, ShotBlock ShardMemory::*into) {
  const std::size_t shots = inputs.columns[0].size();
  ShotBlock& own = m_.*into;
  own.set_size(plan_.study.quantities.size(), shots);
  if (places_.empty()) return plan_.model->evaluate(read_only(inputs.columns), own.columns, m_.scratch);
  std::vector<std::span<double>> columns = own.columns;
  for (const auto& place : places_) {
    ShotBlock& there = place->m_.*into;
    there.set_size(place->plan_.study.quantities.size(), shots);
    columns.insert(columns.end(), there.columns.begin(), there.columns.end());
  }
  return plan_.model->evaluate(read_only(inputs.columns), columns, m_.scratch);
}

ShardSums ShardFlyer::fly(std::uint64_t shard) {
  const Study& study = plan_.study;
  m_.inputs.set_size(study.inputs.size(), study.shard_shots);
  draw(plan_, {study.sampling, study.seed}, shard, 0, m_.inputs.columns);
  const ModelTold told = evaluate(m_.inputs, &ShardMemory::quantities);
  ShardSums sums = add_up(shard, told, m_.inputs.columns);
  for (const auto& place : places_) sums.places.push_back(place->add_up(shard, told, m_.inputs.columns));
  if (study.indices) add_indices(shard, sums);
  return sums;
}

/// What shots came to that were flown into its block.
ShardSums ShardFlyer::add_up(std::uint64_t shard, const ModelTold& told, Columns inputs) {
  const Study& study = plan_.study;
  ShardSums sums;
  sums.shots = study.shard_shots;
  sums.replicates.resize(kReplicates);
  for (const CellGrid& grid : plan_.grids) sums.cells.push_back(empty_cells(grid.centre, grid.scale));
  sums.from_aim.cells = empty_cells(plan_.aim_distance, plan_.radius_scale);
  sums.from_centre.cells = empty_cells(0, plan_.radius_scale);
  sums.in_space.cells = empty_cells(0, plan_.space_scale);

  sums.refused = told.refused;
  if (told.error && told.first)
    sums.refusal =
        FirstRefusal{shard * study.shard_shots + *told.first, told.error->message, told.error->place, told.error->hint};
  add_arrived(shard, sums);
  if (plan_.has_plane() && study.sampling == Sampling::random) add_spreads(sums);
  const std::span<const double> first[] = {m_.arrived[0]};
  sums.stages = {{sums.shots, sums.hits, plan_.has_plane() ? sums.from_aim.moments : moments_of(first)}};
  Replicate& own = sums.replicates[shard % kReplicates];
  if (study.over_inputs) {
    sums.over_inputs.resize(kReplicates);
    sums.over_inputs[shard % kReplicates] = part_sums_of(plan_, inputs, m_.hits);
  }
  own.shots = sums.shots, own.moments = sums.moments, own.hits = sums.hits;
  if (!plan_.is_plain()) {
    sums.distances.resize(kReplicates);
    ReplicateDistances& distances = sums.distances[shard % kReplicates];
    distances = {sums.from_aim.moments, sums.from_centre.moments, sums.in_space.moments, {}};
    for (const DistanceSums& spread : sums.spreads) distances.spreads.push_back(spread.moments);
  }
  return sums;
}

/// Which shots arrived, and which targets each hit. Things may be hit on the way by shots that do not arrive.
void ShardFlyer::mark_hits() {
  const auto& columns = m_.quantities.columns;
  const std::size_t all = columns[0].size();
  const auto is_whole = [](const auto& column) { return shard_kernel().all_finite(column.data(), column.size()); };
  if (std::ranges::all_of(columns, is_whole)) {
    m_.shots.resize(all);
    std::iota(m_.shots.begin(), m_.shots.end(), 0u);
  } else {
    m_.shots.clear();
    for (std::uint32_t i = 0; i < all; ++i)
      if (std::ranges::all_of(columns, [i](const auto& column) { return is_finite(column[i]); })) m_.shots.push_back(i);
  }
  const std::vector<StudyTarget>& targets = plan_.study.targets;
  m_.hits = m_.scratch.thing_hits;
  if (m_.hits.empty()) m_.hits.assign(targets.size() * all, 0);
  PHYSIM_ASSERT(m_.hits.size() == targets.size() * all);
  for (std::size_t target = 0; target < targets.size(); ++target)
    if (!std::holds_alternative<ThingTarget>(targets[target].shape))
      mark_covered(targets[target], m_.shots, columns[0], columns[1], std::span(m_.hits).subspan(target * all, all));
}

/// Quantities of those that arrived: columns as they are where all did.
void ShardFlyer::gather_arrived() {
  const auto& columns = m_.quantities.columns;
  if (m_.shots.size() == columns[0].size()) return void(m_.arrived = read_only(columns));
  m_.gathered.set_size(columns.size(), m_.shots.size());
  for (std::size_t q = 0; q < columns.size(); ++q)
    for (std::size_t i = 0; i < m_.shots.size(); ++i) m_.gathered.columns[q][i] = columns[q][m_.shots[i]];
  m_.arrived = read_only(m_.gathered.columns);
}

/// Adds up those that arrived.
void ShardFlyer::add_arrived(std::uint64_t shard, ShardSums& sums) {
  mark_hits();
  gather_arrived();
  PHYSIM_ASSERT(m_.shots.size() + sums.refused <= sums.shots);
  sums.not_arrived = sums.shots - sums.refused - m_.shots.size();
  sums.moments = moments_of(m_.arrived);
  for (std::size_t q = 0; q < m_.arrived.size() && !m_.shots.empty(); ++q) {
    const LeastAndMost ends = shard_kernel().least_and_most(m_.arrived[q].data(), m_.shots.size());
    count_into(sums.cells[q], m_.arrived[q], ends);
  }
  m_.distances.resize(m_.shots.size());
  if (plan_.has_plane()) add_plane(shard, sums);
  const auto all = static_cast<std::ptrdiff_t>(sums.shots);
  for (auto hit = m_.hits.begin(); hit != m_.hits.end(); hit += all)
    sums.hits.push_back(static_cast<std::uint64_t>(std::count(hit, hit + all, std::uint8_t{1})));
  if (plan_.in_space.empty()) return;
  for (std::size_t i = 0; i < m_.shots.size(); ++i) {
    double squares = 0;
    for (const std::size_t q : plan_.in_space) {
      const double from = m_.arrived[q][i] - plan_.grids[q].centre;
      squares += from * from;
    }
    m_.distances[i] = std::sqrt(squares);
  }
  add_distances(sums.in_space);
}

void ShardFlyer::add_distances(DistanceSums& sums) const {
  const std::span<const double> column[] = {m_.distances};
  sums.moments = moments_of(column);
  count_into(sums.cells, m_.distances);
}

void ShardFlyer::add_plane(std::uint64_t shard, ShardSums& sums) {
  const Study& study = plan_.study;
  const std::span<const double> right = m_.arrived[0], up = m_.arrived[1];
  const auto measure = [&](const PlanePoint& from) {
    shard_kernel().distances(right.data(), up.data(), from.right, from.up, m_.distances.data(), right.size());
  };
  measure(plan_.centre);
  add_distances(sums.from_centre);
  measure(study.aim);
  add_distances(sums.from_aim);
  add_worst(shard, sums);
  sums.reach = reach_of(right, up);
}

/// Blocks of which no shot is as bad as those that are kept are passed by.
void ShardFlyer::add_worst(std::uint64_t shard, ShardSums& sums) const {
  constexpr std::size_t kBlock = 64;
  const std::span<const double> distances = m_.distances;
  for (std::size_t first = 0; first < distances.size(); first += kBlock) {
    const auto block = distances.subspan(first, std::min(kBlock, distances.size() - first));
    const auto is_worse = [&](double distance) {
      return sums.worst.size() < kWorstShots || distance > sums.worst.back().distance;
    };
    if (!is_worse(shard_kernel().least_and_most(block.data(), block.size()).most)) continue;
    for (std::size_t i = 0; i < block.size(); ++i)
      if (is_worse(block[i])) put_worst(sums.worst, {shard * plan_.study.shard_shots + m_.shots[first + i], block[i]});
  }
}

/// Groups of shots that follow each other within an occasion; those of which a shot did not arrive are left out.
void ShardFlyer::add_spreads(ShardSums& sums) {
  const Study& study = plan_.study;
  const std::span<const double> right = m_.quantities.columns[0], up = m_.quantities.columns[1];
  PHYSIM_ASSERT(right.size() % study.rounds == 0);
  const std::size_t run = study.rounds > 1 ? study.rounds : right.size();
  for (const std::size_t size : study.group_sizes) {
    const std::size_t groups = run / size;
    m_.distances.resize(right.size() / run * groups);
    for (std::size_t start = 0, at = 0; start < right.size(); start += run, at += groups)
      shard_kernel().spreads({right.data() + start, up.data() + start, size, groups, m_.distances.data() + at});
    std::erase_if(m_.distances, [](double spread) { return spread != spread; });
    DistanceSums& spread = sums.spreads.emplace_back();
    spread.cells = empty_cells(0, plan_.radius_scale);
    add_distances(spread);
  }
}

void ShardFlyer::add_indices_of(std::size_t group, ShardSums& sums, std::size_t replicate) const {
  add_index_sums(plan_, group, m_.quantities.columns, m_.other_quantities.columns, m_.mixed_quantities.columns,
                 sums.replicates[replicate].indices);
}

void ShardFlyer::add_indices(std::uint64_t shard, ShardSums& sums) {
  const Study& study = plan_.study;
  const std::size_t inputs = study.inputs.size();
  m_.other_inputs.set_size(inputs, study.shard_shots);
  draw(plan_, {study.sampling, study.seed}, shard, static_cast<unsigned>(inputs), m_.other_inputs.columns);
  evaluate(m_.other_inputs, &ShardMemory::other_quantities);
  for (std::size_t group = 0; group < plan_.groups.size(); ++group) {
    m_.mixed_inputs.set_size(inputs, study.shard_shots);
    for (std::size_t i = 0; i < inputs; ++i)
      std::ranges::copy(m_.inputs.columns[i], m_.mixed_inputs.columns[i].begin());
    for (const std::size_t i : plan_.groups[group].inputs)
      std::ranges::copy(m_.other_inputs.columns[i], m_.mixed_inputs.columns[i].begin());
    evaluate(m_.mixed_inputs, &ShardMemory::mixed_quantities);
    add_indices_of(group, sums, shard % kReplicates);
    for (std::size_t i = 0; i < places_.size(); ++i)
      places_[i]->add_indices_of(group, sums.places[i], shard % kReplicates);
  }
}

StudyShots ShardFlyer::shots_of(std::uint64_t shard) {
  const Study& study = plan_.study;
  m_.inputs.set_size(study.inputs.size(), study.shard_shots);
  draw(plan_, {study.sampling, study.seed}, shard, 0, m_.inputs.columns);
  evaluate(m_.inputs, &ShardMemory::quantities);
  StudyShots shots = shots_told();
  for (const auto& column : m_.inputs.columns) shots.inputs.emplace_back(column.begin(), column.end());
  for (const auto& place : places_) shots.at.push_back(place->shots_told());
  return shots;
}

/// Shots that were flown into its block, without what they drew.
StudyShots ShardFlyer::shots_told() {
  mark_hits();
  StudyShots shots;
  for (const auto& column : m_.quantities.columns) shots.quantities.emplace_back(column.begin(), column.end());
  const auto all = static_cast<std::ptrdiff_t>(plan_.study.shard_shots);
  for (auto hit = m_.hits.begin(); hit != m_.hits.end(); hit += all) shots.hits.emplace_back(hit, hit + all);
  return shots;
}

}  // namespace physim
