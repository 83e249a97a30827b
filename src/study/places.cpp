#include "study/places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/checker.hpp"
#include "base/event_table.hpp"
#include "study/impacts.hpp"
#include "study/quantities.hpp"

namespace physim {
namespace {

constexpr std::size_t kNumbersSeen = 7;  // time, place and velocity

/// Whether an event is what a place stands for. Where a thing turned the flight, the value crossed is a sum.
bool is_at(const Event& event, const EventSpec& place) {
  if (event.kind != place.kind) return false;
  if (place.direction != Crossing::any && event.direction != place.direction) return false;
  return !row_of(place.kind).waits_for_value ||
         std::abs(event.value - place.value) <= 1e-9 * std::max(std::abs(place.value), 1.0);
}

/// The apex is the highest point, unless a low one is asked for.
Crossing direction_of(const EventSpec& event) {
  return event.kind == EventKind::apex && event.direction == Crossing::any ? Crossing::falling : event.direction;
}

bool is_one_place(const EventSpec& a, const EventSpec& b) {
  return a.kind == b.kind && direction_of(a) == direction_of(b) &&
         (a.value == b.value || !row_of(a.kind).waits_for_value);
}

Status check_event(const EventSpec& event, const std::string& place) {
  Checker c;
  c.require(is_watchable(event.kind), place + ".event.kind", "is nothing that a flight watches",
            "name a range, a height, a time, a speed, a Mach number, or apex, ignition, burnout or rail_exit");
  c.named(event.direction, place + ".event.direction");
  if (!c.status_so_far()) return c.status();
  const bool is_way = event.kind == EventKind::range || event.kind == EventKind::time;
  c.require(std::isfinite(event.value), place + ".event.value", "is no number");
  c.require(!is_way || event.value > 0, place + ".event.value", "must be above 0: shots begin there");
  return c.status();
}

/// Some columns of a model, for a caller that needs no others.
class PartOfModel : public ShotModel {
 public:
  PartOfModel(std::shared_ptr<const ShotModel> whole, std::size_t first, std::size_t all)
      : whole_(std::move(whole)), first_(first), all_(all) {}
  ModelTold evaluate(InputColumns inputs, QuantityColumns quantities, ModelScratch&) const override {
    PHYSIM_ASSERT(first_ + quantities.size() <= all_);
    const std::size_t count = quantities[0].size();
    std::vector<double> others((all_ - quantities.size()) * count);
    std::vector<std::span<double>> columns;
    for (std::size_t i = 0, other = 0; i < all_; ++i)
      columns.push_back(i >= first_ && i - first_ < quantities.size()
                            ? quantities[i - first_]
                            : std::span(others).subspan(count * other++, count));
    ModelScratch own;  // the caller's would have hits on things, which are reported at the end alone
    return whole_->evaluate(inputs, columns, own);
  }

 private:
  std::shared_ptr<const ShotModel> whole_;
  std::size_t first_, all_;
};

}  // namespace

void Places::watch(Until& until) const {
  for (const StudyPlace& place : at_) {
    until.events.push_back(place.event);
    until.events.back().terminal = false;
  }
}

double Places::time_of(const Flight& flight, std::size_t place) const {
  PHYSIM_ASSERT(place < at_.size());
  for (const Event& event : flight.events())
    if (is_at(event, at_[place].event)) return event.time;
  return flight.duration();
}

std::vector<SeenColumns> Places::columns(std::size_t shots, std::vector<double>& memory) const {
  memory.assign(at_.size() * kNumbersSeen * shots, std::numeric_limits<double>::quiet_NaN());
  std::vector<SeenColumns> seen;
  std::size_t taken = 0;
  const auto room = [&] { return std::span(memory).subspan(shots * taken++, shots); };
  for (std::size_t i = 0; i < at_.size(); ++i) seen.push_back({room(), room(), room(), room(), room(), room(), room()});
  return seen;
}

void Places::take(const Event& event, std::size_t shot, std::span<const SeenColumns> seen) const {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const SeenColumns& at = seen[i];
    if (!is_at(event, at_[i].event) || std::isfinite(at.time[shot])) continue;
    at.time[shot] = event.time;
    at.x[shot] = event.position.x, at.y[shot] = event.position.y, at.z[shot] = event.position.z;
    at.vx[shot] = event.velocity.x, at.vy[shot] = event.velocity.y, at.vz[shot] = event.velocity.z;
  }
}

void fill_places(Study& study) {
  using Q = StudyQuantity;
  for (StudyPlace& place : study.at) {
    place.event.direction = direction_of(place.event);
    if (!place.quantities.empty()) continue;
    const EventKind kind = place.event.kind;
    if (kind == EventKind::range) {
      place.quantities = {Q::right, Q::up, Q::time, Q::speed};
      continue;
    }
    place.quantities = {Q::right, Q::along};  // a place itself gives the value that is crossed there
    if (kind != EventKind::height) place.quantities.push_back(Q::y);
    if (kind != EventKind::time) place.quantities.push_back(Q::time);
    if (kind != EventKind::speed) place.quantities.push_back(Q::speed);
  }
}

Status check_places(const Study& study, bool of_flights) {
  Checker c;
  c.require(study.at.size() + study.until.events.size() <= 24, "at", "are more than 24 places, with until.events",
            "ask for fewer at once");
  for (std::size_t i = 0; i < study.at.size() && c.status_so_far(); ++i) {
    const StudyPlace& place = study.at[i];
    const std::string name = "at[" + std::to_string(i) + ']';
    if (of_flights) c.also(check_event(place.event, name));
    for (std::size_t j = 0; j < i && of_flights; ++j)
      c.require(!is_one_place(study.at[j].event, place.event), name,
                "is the place of at[" + std::to_string(j) + "] again", "name all quantities at one of them");
    c.require(of_flights || !place.quantities.empty(), name + ".quantities",
              "must name the columns that the function fills");
    for (std::size_t q = 0; q < place.quantities.size() && c.status_so_far(); ++q) {
      const std::string of = name + ".quantities[" + std::to_string(q) + ']';
      c.named(place.quantities[q], of);
      c.require(!of_flights || !is_of_impact(place.quantities[q]), of,
                "is of the first impact, wherever that is, and not of a place on the way", "ask for it at the end");
      const auto before = place.quantities.begin() + static_cast<std::ptrdiff_t>(q);
      c.require(std::find(place.quantities.begin(), before, place.quantities[q]) == before, of, "is asked for twice");
    }
  }
  return c.status();
}

bool has_plane_axes(const std::vector<StudyQuantity>& quantities) {
  using Q = StudyQuantity;
  constexpr Q kLengths[] = {Q::x, Q::y, Q::z, Q::right, Q::up, Q::along};
  const auto is_length = [&](Q quantity) { return std::ranges::find(kLengths, quantity) != std::end(kLengths); };
  return quantities.size() >= 2 && is_length(quantities[0]) && is_length(quantities[1]);
}

Study study_at(const Study& study, std::size_t place) {
  PHYSIM_ASSERT(place < study.at.size());
  const StudyPlace& at = study.at[place];
  Study there = study;
  there.at.clear();
  there.until_width.reset();
  there.quantities = at.quantities;
  there.until.range.reset();
  if (at.event.kind == EventKind::range) there.until.range = at.event.value;
  const bool same_plane = has_plane_axes(there.quantities) && study.quantities.size() >= 2 &&
                          std::equal(there.quantities.begin(), there.quantities.begin() + 2, study.quantities.begin());
  if (!same_plane) there.targets.clear(), there.aim = {};
  std::erase_if(there.targets, [](const StudyTarget& target) {  // things are hit wherever they stand
    return std::holds_alternative<ThingTarget>(target.shape);
  });
  if (there.targets.empty()) there.over_inputs.reset();
  return there;
}

std::shared_ptr<const ShotModel> part_of_model(std::shared_ptr<const ShotModel> whole, std::size_t first,
                                               std::size_t all) {
  PHYSIM_ASSERT(whole != nullptr && first < all);
  return std::make_shared<PartOfModel>(std::move(whole), first, all);
}

}  // namespace physim
