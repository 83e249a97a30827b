#include "simclient/core/client.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physim/recording_file.hpp"

namespace physim::client {
namespace {

constexpr double kReach = 12;       // of the mouse [pixels]
constexpr double kMessageTime = 6;  // [s]
constexpr double kRightAngle = 1.5707963267948966;

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Result<Session> open_session(const std::string& file, const std::vector<std::string>& overrides) {
  if (ends_with(file, ".rec") || ends_with(file, ".rec.part")) {
    Result<std::vector<std::byte>> bytes = load_recording(file);
    if (!bytes) return bytes.error();
    return Session::replay(std::move(*bytes), file);
  }
  Result<Scenario> scenario = load_scenario(file, overrides);
  if (!scenario) return scenario.error();
  return Session::create(std::move(*scenario));
}

}  // namespace

Result<Client> open_client(const std::string& file, const std::vector<std::string>& overrides) {
  if (file.empty() && !overrides.empty())
    return Error{"--set changes a scenario, and none is named", "--set", "simclient FILE.toml --set ..."};
  Result<Session> session = file.empty() ? Session::create(open_range()) : open_session(file, overrides);
  if (!session) return session.error();
  return Client(std::move(*session));
}

Client::Client(Session s) : session(std::move(s)), launcher(session.scenario()) { fit_view(); }

void Client::advance(double real_dt) {
  session.advance(real_dt);
  for (Message& message : messages_) message.shown += real_dt;
  while (!messages_.empty() && messages_.front().shown > kMessageTime) messages_.pop_front();
  follow();
}

Status Client::open(const std::string& file) {
  Result<Session> opened = open_session(file, {});
  if (!opened) return opened.error();
  session = std::move(*opened);
  launcher = Launcher(session.scenario());
  selected = {};
  tape = {};
  ++session_version_;
  fit_view();
  say("opened " + file);
  return std::nullopt;
}

Status Client::restart() {
  ++session_version_;
  selected = {};
  return session.restart();
}

Status Client::fire() {
  const Result<ProjectileId> fired = session.fire(launcher.shot());
  if (!fired) return fired.error();
  selected = *fired;
  return std::nullopt;
}

const Prediction& Client::prediction() {
  const bool is_new = predicted_version_ != launcher.version() || predicted_session_ != session_version_;
  if (is_new && !session.is_replay()) prediction_ = predict(session, launcher.shot());
  predicted_version_ = launcher.version();
  predicted_session_ = session_version_;
  return prediction_;
}

const Track* Client::selected_track() const {
  if (const Track* track = session.track(selected)) return track;
  return session.tracks().empty() ? nullptr : &session.tracks().back();
}

void Client::select_next() {
  const auto tracks = session.tracks();
  if (tracks.empty()) return;
  const Track* now = selected_track();
  selected = tracks[(static_cast<std::size_t>(now - tracks.data()) + 1) % tracks.size()].id;
}

// ----------------------------------------------------------------------------------------------------------- the scene
void Client::click(const Pixel& pixel) {
  if (tool == Tool::fire) {
    if (Status bad = fire()) complain(*bad);
    return;
  }
  const std::optional<Vec3d> point = point_under(pixel);
  if (!point) return complain({"there is nothing to measure from", "tape measure", "click on a path or the ground"});
  if (tape.from && !tape.to)
    tape.to = point;
  else
    tape = {point, std::nullopt};
}

std::optional<Vec3d> Client::point_under(const Pixel& pixel) {
  if (const auto found = probe(pixel)) return found->sample.position;
  return at_height(camera.ray(pixel), session.ground().value_or(0));
}

std::optional<Client::Probe> Client::probe(const Pixel& pixel) {
  std::optional<Probe> best;
  double nearest = kReach;
  const auto look = [&](const Track* track, const std::vector<TrackSample>& samples) {
    for (const TrackSample& s : samples) {
      const auto seen = camera.project(s.position);
      const double away = seen ? std::hypot(seen->x - pixel.x, seen->y - pixel.y) : nearest;
      if (away < nearest) nearest = away, best = Probe{track, s};
    }
  };
  for (const Track& track : session.tracks()) look(&track, track.samples);
  if (show.prediction) look(nullptr, prediction().path);
  return best;
}

void Client::fit_view() {
  Vec3d low = launcher.shot().launch.position, high = low;
  const auto include = [&](const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  };
  for (const TrackSample& s : prediction().path) include(s.position);
  for (const Track& track : session.tracks())
    for (const TrackSample& s : track.samples) include(s.position);
  if (const auto height = session.ground()) include({low.x, *height, low.z});
  if (camera.mode == CameraMode::side) {
    camera.yaw = launcher.azimuth() - kRightAngle;
    camera.pitch = 0.05;
  } else {
    camera.yaw = launcher.azimuth() - 0.35;
    camera.pitch = 0.22;
  }
  camera.fit(low, high);
}

void Client::next_camera() {
  camera.mode = static_cast<CameraMode>((static_cast<int>(camera.mode) + 1) % 3);
  if (camera.mode == CameraMode::follow) {
    camera.yaw = launcher.azimuth() - 0.25;
    camera.pitch = 0.15;
    camera.distance = std::min(camera.distance, 25.0);
  } else {
    fit_view();
  }
}

void Client::follow() {
  const Track* track = camera.mode == CameraMode::follow ? selected_track() : nullptr;
  if (track != nullptr && !track->samples.empty())
    camera.target = track->is_flying() ? session.shown_position(track->id) : track->samples.back().position;
}

// ------------------------------------------------------------------------------------------------------------ messages
void Client::say(const std::string& text) { messages_.push_back({text, false, 0}); }
void Client::complain(const Error& error) { messages_.push_back({error.text(), true, 0}); }

}  // namespace physim::client
