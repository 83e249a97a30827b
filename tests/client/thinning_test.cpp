// What is kept of paths shows them: against every step of the flights of all shipped scenarios.
#include "simclient/core/thinning.hpp"

#include <cmath>
#include <random>

#include "client/support.hpp"
#include "shipped.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/stroke.hpp"

namespace physim::client::client_thinning {
namespace {

/// A track and all of its steps.
struct Flown {
  Client client;
  std::vector<TrackSample> steps;  // of the first track
};

/// The first shot, or the first that the scenario fires, for so many steps.
Flown flown(const std::string& scenario, int steps) {
  Flown out{client_of(scenario), {}};
  Session& session = out.client.session;
  if (session.tracks().empty() && !session.scenario().world.given) (void)out.client.fire();
  for (int i = 0; i < steps; ++i) {
    session.single_step();
    if (session.tracks().empty()) continue;
    const Track& first = session.tracks()[0];
    if (first.is_flying() || out.steps.empty() || out.steps.back().time < first.samples.back().time)
      out.steps.push_back(first.samples.back());
  }
  return out;
}

double span(const std::vector<TrackSample>& steps) {
  Vec3d low = steps[0].position, high = low;
  for (const TrackSample& s : steps) {
    low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y), std::min(low.z, s.position.z)};
    high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y), std::max(high.z, s.position.z)};
  }
  return length(high - low);
}

/// On the line in time between kept samples.
Vec3d shown_at(const std::vector<TrackSample>& kept, double time) {
  const auto next = std::ranges::lower_bound(kept, time, {}, &TrackSample::time);
  if (next == kept.begin()) return kept.front().position;
  if (next == kept.end()) return kept.back().position;
  const TrackSample &a = *(next - 1), &b = *next;
  return a.position + (b.position - a.position) * ((time - a.time) / (b.time - a.time));
}

double worst_of_kept(const Flown& flown) {
  double worst = 0;
  for (const TrackSample& s : flown.steps)
    worst = std::max(worst, length(s.position - shown_at(flown.client.session.tracks()[0].samples, s.time)));
  return worst;
}

double distance(const Pixel& p, const Pixel& a, const Pixel& b) {
  const double x = b.x - a.x, y = b.y - a.y, size = x * x + y * y;
  const double part = size > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / size, 0.0, 1.0) : 0;
  return std::hypot(a.x + part * x - p.x, a.y + part * y - p.y);
}

/// Pixels between the steps and the trail that is drawn.
double worst_of_drawn(const Flown& flown, std::size_t every) {
  const Camera& camera = flown.client.camera;
  Scene scene;
  scene.polyline(flown.client.session.tracks()[0].samples, camera, 0xFFFFFFFF, 1);
  double worst = 0;
  for (std::size_t i = 0; i < flown.steps.size(); i += every) {
    const auto at = camera.project(flown.steps[i].position);
    if (!at) continue;
    double nearest = 1e9;
    for (const SceneLine& line : scene.lines) {
      const auto a = camera.project(line.a), b = camera.project(line.b);
      if (a && b) nearest = std::min(nearest, distance(*at, *a, *b));
    }
    if (!scene.lines.empty()) worst = std::max(worst, nearest);
  }
  return worst;
}

/// 141 000 steps of half a millisecond: the whole of it, at its beginning too.
TEST(Thinning, ALongFlightIsShownFromItsBeginning) {
  Flown shell = flown("105mm_m1_six_dof", 150'000);
  const Track& track = shell.client.session.tracks()[0];
  ASSERT_EQ(track.status, LifeStatus::landed);
  ASSERT_GT(shell.steps.size(), 130'000U);
  EXPECT_LT(track.samples.size(), 20'000U);
  EXPECT_LT(worst_of_kept(shell), 1e-4 * span(shell.steps));
  shell.client.fit_view();
  EXPECT_LT(worst_of_drawn(shell, 50), 0.5);
}

class OfEach : public testing::TestWithParam<std::string> {};

TEST_P(OfEach, TrailsAreWhereThingsFlew) {
  Flown flight = flown(GetParam(), 3000);
  if (flight.steps.size() < 2) return;  // it fires nothing by itself
  EXPECT_LE(worst_of_kept(flight), 1e-4 * span(flight.steps) + 1e-9);
  flight.client.fit_view();
  EXPECT_LT(worst_of_drawn(flight, 10), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Shipped, OfEach, testing::ValuesIn(test::shipped_scenarios()), [](const auto& test) {
  std::string name = test.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Thinning, KeepsCornersAndOtherQuantities) {
  std::vector<TrackSample> samples;
  for (int i = 0; i <= 4000; ++i) {
    TrackSample s{.time = i * 1e-3};
    s.position = {s.time, std::abs(s.time - 2), 0};  // a corner at 2 s
    s.mach = std::sin(20 * s.time);
    samples.push_back(s);
  }
  std::vector<TrackSample> kept = samples;
  thin_out(kept, 0);
  EXPECT_LT(kept.size(), samples.size() / 4);
  EXPECT_EQ(kept.front(), samples.front());
  EXPECT_EQ(kept.back(), samples.back());
  std::size_t k = 1;
  for (const TrackSample& s : samples) {
    while (k + 1 < kept.size() && kept[k].time < s.time) ++k;
    const TrackSample line =
        between(kept[k - 1], kept[k], (s.time - kept[k - 1].time) / (kept[k].time - kept[k - 1].time));
    EXPECT_LT(length(line.position - s.position), 1e-4 * std::hypot(4, 2));
    EXPECT_LT(std::abs(line.mach - s.mach), 1.1e-3);
  }
}

TEST(Thinning, TracksStayBoundedHoweverOftenTheyTurn) {
  std::mt19937 random(7);
  Track track;
  for (int i = 0; i < 200'000; ++i) {
    TrackSample s{.time = double(i)};
    s.position = {static_cast<double>(random() % 1000), static_cast<double>(random() % 1000), 0};
    add_sample(track, s);
  }
  EXPECT_LT(track.samples.size(), 40'000U);
  EXPECT_EQ(track.samples.front().time, 0);
  EXPECT_EQ(track.samples.back().time, 199'999);
}

TEST(Stroke, PassesEveryPoint) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    std::vector<Pixel> points = {{0, 0}};
    double way = 0;
    for (int i = 0; i < 3000; ++i) {
      way += (static_cast<double>(random() % 1000) / 1000 - 0.5) * (round % 8) * 0.2;
      const double step = (round % 5 + 1) * 0.15;
      points.push_back({points.back().x + step * std::cos(way), points.back().y + step * std::sin(way)});
    }
    const auto kept = points_of_stroke(points.size(), [&](std::size_t i) { return std::optional(points[i]); });
    ASSERT_EQ(kept.front(), 0U);
    ASSERT_EQ(kept.back(), points.size() - 1);
    for (std::size_t k = 1; k < kept.size(); ++k)
      for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i)
        EXPECT_LT(distance(points[i], points[kept[k - 1]], points[kept[k]]), 2 * kStrokeError) << round << " " << i;
    if (round % 8 == 0) {
      EXPECT_LE(kept.size(), 3U) << "a straight line";
    }
  }
}

}  // namespace
}  // namespace physim::client::client_thinning
