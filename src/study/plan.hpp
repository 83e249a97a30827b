// A study checked and prepared: what shards read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/distributions.hpp"
#include "study/sampling.hpp"
#include "study/shard_memory.hpp"

namespace physim {

/// Raised whenever the bytes of parts change. Results of shards may differ between versions without it: parts name the
/// version that flew them, and others refuse them.
inline constexpr std::uint32_t kStudyFormat = 6;

/// Inputs that are drawn together: one that is correlated with none, or all of a correlation.
struct InputGroup {
  std::vector<std::size_t> inputs;
  std::vector<double> root;  // of the correlations; empty: one input
};

/// What cells are counted about.
struct CellGrid {
  double centre = 0, scale = 1;
};

struct StudyPlanRecord {
  Study study;  // with its quantities
  std::uint64_t hash = 0;
  std::vector<Quantiles> quantiles;  // of each input
  std::vector<InputGroup> groups;
  std::shared_ptr<const ShotModel> model;
  std::vector<CellGrid> grids;             // of each quantity
  PlanePoint centre;                       // mean point of impact of the pilot
  double aim_distance = 0;                 // ... from the aim [m]
  double radius_scale = 1;                 // of distances on the plane [m]
  std::vector<std::size_t> in_space;       // indices of x, y and z; empty: not all are asked for
  double space_scale = 1;                  // of distances in space [m]
  std::vector<std::vector<double>> edges;  // of each input, between the parts of Study::over_inputs
  std::vector<std::string> notes;
  std::uint64_t shards = 0;
  std::shared_ptr<SpareMemory> spare = std::make_shared<SpareMemory>();
  std::vector<StudyPlanRecord> places;  // of each of Study::at: of a study that ends there
  bool takes_plane = true;              // false: its first two quantities are those of a place, and no lengths

  [[nodiscard]] static StudyPlan plan_of(StudyPlanRecord&& record) {
    return StudyPlan(std::make_shared<const StudyPlanRecord>(std::move(record)));
  }
  /// Columns that its model fills: of its quantities, then of those of each place.
  [[nodiscard]] std::size_t columns() const;
  [[nodiscard]] bool has_plane() const { return takes_plane && study.quantities.size() >= 2; }
  /// Random shots that know nothing of each other.
  [[nodiscard]] bool is_plain() const { return study.sampling == Sampling::random && study.rounds == 1; }
  /// How many shots of an occasion have a number in common; 1: none, as all of them draw each input.
  [[nodiscard]] std::uint32_t shots_in_common() const;
  /// A study ends at a multiple of this number of shards: at one of them, or where each replicate has as many.
  [[nodiscard]] std::uint64_t shards_at_once() const;
};

/// Draws the inputs of a shard. Dimensions of the sampler from `first_dimension` on: another set of shots.
void draw(const StudyPlanRecord& plan, const Sampler& sampler, std::uint64_t shard, unsigned first_dimension,
          std::span<const std::span<double>> columns);
/// What one shot of the study draws, computed alone: the numbers that its place in draw() gets.
[[nodiscard]] std::vector<double> drawn_by(const StudyPlanRecord& plan, std::uint64_t shot);

/// All but what flights refuse. `of_flights`: its inputs are those of study_paths(). `all`: filled with every mistake
/// where it is not null; the first is returned.
[[nodiscard]] Status check(const Study& study, bool of_flights, std::vector<Error>* all = nullptr);
/// Inputs that are drawn together; an error for correlations that cannot be.
[[nodiscard]] Result<std::vector<InputGroup>> groups_of(const Study& study);

}  // namespace physim
