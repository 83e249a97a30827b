// Places on the way of a study's shots: the events that they stand for, among those of flights.
#pragma once

#include <vector>

#include "physim/study.hpp"
#include "study/model.hpp"

namespace physim {

class Places {
 public:
  explicit Places(std::vector<StudyPlace> at) : at_(std::move(at)) {}

  [[nodiscard]] bool empty() const { return at_.empty(); }
  [[nodiscard]] std::size_t size() const { return at_.size(); }
  /// Makes flights report them.
  void watch(Until& until) const;
  /// When a flight first comes to a place; where it does not, its end [s].
  [[nodiscard]] double time_of(const Flight& flight, std::size_t place) const;
  /// Columns for each of them, of shots that came nowhere yet, in memory that holds them.
  [[nodiscard]] std::vector<SeenColumns> columns(std::size_t shots, std::vector<double>& memory) const;
  /// Notes where a shot is at an event, at each place that it is the first of. Events of a shot are in order of time.
  void take(const Event& event, std::size_t shot, std::span<const SeenColumns> seen) const;

 private:
  std::vector<StudyPlace> at_;
};

/// The default quantities of places that name none.
void fill_places(Study& study);
/// Says what is wrong with Study::at. `of_flights`: their events are looked at.
[[nodiscard]] Status check_places(const Study& study, bool of_flights);
/// Whether the first two are lengths.
[[nodiscard]] bool has_plane_axes(const std::vector<StudyQuantity>& quantities);
/// A study moved to one of its places: its plane of impact stands there.
[[nodiscard]] Study study_at(const Study& study, std::size_t place);

}  // namespace physim
