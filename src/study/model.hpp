// What turns the inputs of shots into quantities: flights, or a function of one's own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physim/study.hpp"
#include "study/impacts.hpp"

namespace physim {

/// Where the shots of a block were: at their ends, or at a place on the way.
struct SeenColumns {
  std::span<double> time, x, y, z, vx, vy, vz;
};

/// Memory of one thread, used again from block to block.
struct ModelScratch {
  std::vector<double> numbers;
  std::vector<Outcome> outcomes;
  std::vector<Shot> shots;
  std::vector<Launch> launches;
  BatchResult batch;
  std::vector<double> place_numbers;
  std::vector<SeenColumns> places;       // of Study::at, where they are asked for
  std::vector<ShotImpact> impacts;       // of each shot, where they are asked for
  std::vector<std::uint8_t> thing_hits;  // of each target of the study, each shot: whether it met that thing; of models
                                         // that know things alone
};

/// What a model reports beside its columns.
struct ModelTold {
  std::uint64_t refused = 0;
  std::optional<Error> error{};        // of the first shot that was refused
  std::optional<std::size_t> first{};  // that shot, by its place in the block
};

using InputColumns = std::span<const std::span<const double>>;
using QuantityColumns = std::span<const std::span<double>>;

class ShotModel {
 public:
  virtual ~ShotModel() = default;
  /// One column of each input of the study in, one of each quantity out, then of each quantity of each of Study::at;
  /// NaN where a shot does not arrive.
  virtual ModelTold evaluate(InputColumns inputs, QuantityColumns quantities, ModelScratch& scratch) const = 0;
};

/// Flights. An error for what all shots would be refused for.
[[nodiscard]] Result<std::shared_ptr<const ShotModel>> flight_model(const Study& study);
[[nodiscard]] std::shared_ptr<const ShotModel> function_model(const StudyFunction& function);
/// Some of the columns of a model: `first` of `all` and on.
[[nodiscard]] std::shared_ptr<const ShotModel> part_of_model(std::shared_ptr<const ShotModel> whole, std::size_t first,
                                                             std::size_t all);

}  // namespace physim
