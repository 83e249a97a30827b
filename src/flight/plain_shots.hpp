// Shots of a batch of columns with launches and weather that lanes compute, as none needs a separate look.
#pragma once

#include <vector>

#include "flight/batch_job.hpp"
#include "flight/shot_list.hpp"

namespace physim {

/// A run of shots of a task that has columns.
class PlainShots {
 public:
  PlainShots(const BatchTask& task, const Fidelity& granted, std::size_t first, std::size_t count);
  PlainShots(const PlainShots&) = delete;  // the launches point to the weather
  PlainShots& operator=(const PlainShots&) = delete;
  ~PlainShots() = default;

  /// Whether no check of a shot would refuse any, none is over where it begins, and all numbers are some in float32.
  [[nodiscard]] bool are_all() const;
  [[nodiscard]] const LaunchSource& launches() const { return launches_; }
  /// Whether their air is that of stations, in layers, and without air about them all would stay in the lowest one:
  /// lanes may then do without the others (BatchJob::left_low_air).
  [[nodiscard]] bool seem_to_stay_low(const Conditions<double>& conditions) const;
  /// Whether lanes prepare no more of such air than that.
  void prepare_low_air_alone(bool alone) { weather_.place.low_alone = alone; }

 private:
  [[nodiscard]] NumberColumn column(std::span<const double> numbers, double common) const;
  [[nodiscard]] bool within(std::span<const double> numbers, double low, double high) const;
  [[nodiscard]] bool plain_launches() const;
  [[nodiscard]] bool plain_drag() const;
  [[nodiscard]] bool plain_weather() const;
  void put_weather(const Fidelity& granted);
  void put_drag();

  const BatchTask& task_;
  std::size_t first_, count_;
  AirNumbers<double> no_station_{};
  WeatherSource weather_{};
  std::vector<double> half_areas_;
  LaunchSource launches_{};
};

}  // namespace physim
