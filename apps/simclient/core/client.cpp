#include "simclient/core/client.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/assert.hpp"
#include "flight/zero.hpp"
#include "math/angles.hpp"
#include "model/ladder.hpp"
#include "physim/scenario.hpp"
#include "report/file.hpp"
#include "report/format.hpp"
#include "scenario/checks.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/measured_column.hpp"
#include "scenario/new_file.hpp"
#include "scenario/revise.hpp"
#include "scenario/text_file.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/stopwatch.hpp"
#include "simclient/core/subject.hpp"

namespace physim::client {
namespace {

constexpr double kReach = 12;        // of the mouse [pixels]
constexpr double kMessageTime = 6;   // [s]
constexpr double kForeseen = 200;    // [s]
constexpr double kOfAFrame = 0.008;  // that predictions may take [s]

bool is_recording(const std::string& file) { return file.ends_with(".rec") || file.ends_with(".rec.part"); }

/// A file is read again, as when the session is restarted or saved. A pipe can be read once.
Result<Session> open_session(const std::string& file, const std::vector<std::string>& overrides) {
  constexpr std::uintmax_t kAnySize = ~std::uintmax_t{0};  // who reads it has a limit
  if (Status status = check_file(file, kAnySize, is_recording(file) ? "recording" : "scenario file"); !status)
    return status.error();
  if (is_recording(file)) {
    Result<std::vector<std::byte>> bytes = load_recording(file);
    if (!bytes) return bytes.error();
    return Session::replay(std::move(*bytes), file);
  }
  Result<Scenario> scenario = load_scenario(file, overrides);
  if (!scenario) return scenario.error();
  return Session::create(std::move(*scenario));
}

}  // namespace

double scale_of(TextSize size) {
  switch (size) {
    case TextSize::small: return 13.0 / 15;
    case TextSize::usual: return 1;
    case TextSize::large: return 1.4;
  }
  return 1;
}

std::string free_name(const std::string& what, const std::string& ending) {
  int number = 1;
  const auto path = [&] { return "physim_" + what + "_" + std::to_string(number) + ending; };
  while (std::filesystem::exists(path())) ++number;
  return path();
}

Result<Client> open_client(const std::string& file, const std::vector<std::string>& overrides) {
  if (file.empty() && !overrides.empty())
    return Error{"--set changes a scenario, and none is named", "--set", "simclient FILE.toml --set ..."};
  Result<Session> session = file.empty() ? Session::create(open_range()) : open_session(file, overrides);
  if (!session) return session.error();
  Client client(std::move(*session), file);
  for (const std::string& each : overrides) client.take_typed(each);
  return client;
}

Client::Client(Session s, const std::string& file)
    : session(std::move(s)), launcher(session.scenario()), plots(*parse_plots("y/range y speed acceleration")) {
  study.asked = session.scenario().study;
  take_file(file);
  history_.start(launcher, session.scenario(), content_);
  fit_view();
}

void Client::note_changes() {
  constexpr double kGoesOn = 0.8;  // between changes of the aim that belong together [s]
  const Versions before{launcher.version(), contents_};
  if (noted_ == before) return;
  noted_ = before;
  const bool slides = slide != 0 && slide == noted_slide_;
  noted_slide_ = slide;
  history_.note(launcher, session.scenario(), content_, since_change_ < kGoesOn, slides);
  since_change_ = 0;
}

Status Client::bring_back(const Moment* moment, const char* how) {
  if (moment == nullptr) return Error{"nothing was changed by hand", how, ""};
  if (session.is_replay()) return Error{"a replay cannot be changed", how, "come back from it first: replay"};
  const Scenario& then = *moment->scenario;
  Status status;
  if (moment->content.environment != content_.environment) status = session.set_environment(then.environment);
  if (status && moment->content.scene != content_.scene) status = session.set_scene(then);
  if (status && moment->content.emitters != content_.emitters) status = session.set_emitters(then.emitters);
  if (!status) return status;
  if (moment->content != content_) ++session_version_;
  content_ = moment->content;
  launcher.bring_back(moment->launcher);
  history_.adopt(launcher.version());
  noted_ = {launcher.version(), contents_};
  unsaved_ = true;
  return {};
}

/// Remembers which file the session is of. That of a scenario is come back to from a replay.
void Client::take_file(const std::string& file) {
  if (!file.empty()) recent.add(file);
  if (session.is_replay()) return;
  constexpr std::uintmax_t kMostBytes = 1 << 24;  // others are written anew, where they are saved
  scenario_file_ = file;
  inputs_ = session.scenario().files;
  const Result<std::string> text = read_text_file(file, kMostBytes, "scenario file");
  text_ = text ? *text : "";
  units_ = FileUnits(text_);
  unsaved_ = became_world_ = false;
  const Scenario& scenario = session.scenario();
  meets_things_ = !scenario.world.given && !scenario.things.empty();
}

void Client::advance(double real_dt, double patience) {
  note_changes();
  since_change_ += real_dt;
  if (dialog != Dialog::save && !question) waits.reset();
  session.advance(real_dt, patience);
  study.run.advance(patience == std::numeric_limits<double>::infinity());
  if (foresees_more()) foresee_more(patience);
  take_answers();
  for (Message& message : messages_) message.shown += real_dt;
  while (!messages_.empty() && messages_.front().shown > kMessageTime) messages_.pop_front();
  follow();
}

bool Client::is_changing() const {
  return session.is_moving() || study.run.state() == StudyRun::State::running || !pictures.empty() || foresees_more() ||
         has_answer_;
}

Status Client::open(const std::string& file) {
  if (Status status = use_session(open_session(file, {})); !status) return status;
  take_file(file);
  return say("opened " + file), Status();
}

Status Client::use_session(Result<Session> opened) {
  if (!opened) return opened.error();
  session = std::move(*opened);
  launcher = Launcher(session.scenario(), launcher.version());
  study = StudyDesk();
  study.asked = session.scenario().study;
  selected = {};
  tape = {};
  tool = Tool::fire;
  wall_from.reset();
  ++session_version_;
  foretold_.forget();
  comparison_.forget();
  predicted_at_.reset();
  compared_at_.reset();
  history_.start(launcher, session.scenario(), content_);
  fit_view();
  return {};
}

Status Client::restart() {
  ++session_version_;
  selected = {};
  return session.restart();
}

Status Client::fire() {
  const Result<ProjectileId> fired = session.fire(launcher.shot());
  if (!fired) return fired.error();
  selected = fired_ = *fired;
  fired_at_ = versions();
  return {};
}

Status Client::fire_whole() {
  if (session.scenario().world.given)
    return Error{"its shots fly in a world", "fire-whole", "fire it into the world, as its scenario does"};
  if (!session.scenario().things.empty())
    return Error{"whole flights know no things", "fire-whole", "fire it, or take away what was put up: Ctrl+Z"};
  const ScenarioShot& shot = launcher.shot();
  const Result<ProjectileId> played = session.play(shot, fly_shot(session.scenario(), shot));
  if (!played) return played.error();
  selected = fired_ = *played;
  fired_at_ = versions();
  return {};
}

const Track* Client::last_of_this_shot() const {
  return show.trails && fired_at_ == versions() ? session.track(fired_) : nullptr;
}

/// As shots of a scenario without a world and without things do.
bool Client::flies_whole() const {
  const Scenario& scenario = session.scenario();
  const bool is_of_flights = !scenario.world.given && scenario.things.empty() && !scenario.shots.empty();
  return is_of_flights && !session.is_replay() && !session.is_recording();
}

Status Client::fire_by_hand() { return flies_whole() ? fire_whole() : fire(); }

Status Client::fire_scenario() {
  for (const ScenarioShot& shot : session.scenario().shots)
    if (const Result<ProjectileId> fired = session.fire(shot); !fired) return fired.error();
  if (session.scenario().shots.empty()) return Error{"the scenario has no shots", session.scenario().file, ""};
  selected = {};
  fit_view();
  return {};
}

Status Client::fire_compared() {
  ScenarioShot shot = launcher.shot();
  shot.cheapest_within.reset();
  const bool waits_not = std::exchange(computes_beside, false);
  const std::vector<ComparedRung> rungs = comparison();
  computes_beside = waits_not;
  for (const ComparedRung& rung : rungs) {
    shot.projectile.fidelity = rung.asked;
    shot.projectile.name = rung.name;
    shot.body.colour = rung.colour;
    const bool plays = rung.flight && !session.scenario().world.given && session.scenario().things.empty();
    const Result<ProjectileId> fired = plays ? session.play(shot, *rung.flight) : session.fire(shot);
    if (!fired) return fired.error();
  }
  return {};
}

const std::vector<ComparedRung>& Client::comparison() {
  const Compared now{versions(), compared};
  if (compared_at_ == now || session.is_replay()) return rungs_;
  const auto work = [now, scenario = session.scenario(), world = bare_world(session), shot = launcher.shot(),
                     costs = costs_] {
    const Stopwatch watch;
    ComparedAnswer answer{.of = now, .costs = costs};
    answer.rungs = compare_rungs(scenario, world, shot, now.presets, answer.costs);
    answer.seconds = watch.seconds();
    return answer;
  };
  if (comes_beside(comparison_.seconds, !compared_at_)) {
    if (comparison_.asked_for != now) comparison_.beside->ask(work);
    comparison_.asked_for = now;
    return rungs_;
  }
  comparison_.forget();
  ComparedAnswer answer = work();
  rungs_ = std::move(answer.rungs), costs_ = std::move(answer.costs), comparison_.seconds = answer.seconds;
  compared_at_ = now;
  return rungs_;
}

/// True if a computation whose last run took `seconds` runs on a thread; the first one of a scenario never does.
bool Client::comes_beside(double seconds, bool is_first) const {
  return computes_beside && !is_first && seconds > kOfAFrame;
}

/// An answer to an older question than the newest gives its paths, which are shown until the newest is answered.
void Client::take_answers() {
  has_answer_ = false;
  if (std::optional<Foretold> told = foretold_.beside->take()) {
    has_answer_ = true;
    foretold_.seconds = told->seconds;
    if (told->at == versions()) {
      use(std::move(told->prediction));
    } else if (!told->prediction.error) {
      prediction_.path = std::move(told->prediction.path);
      prediction_.apsides = told->prediction.apsides;
    }
  }
  if (std::optional<ComparedAnswer> answer = comparison_.beside->take()) {
    has_answer_ = true;
    rungs_ = std::move(answer->rungs), costs_ = std::move(answer->costs), comparison_.seconds = answer->seconds;
    compared_at_ = answer->of;
    if (comparison_.asked_for == compared_at_) comparison_.asked_for.reset();
  }
}

// --------------------------------------------------------------------------------------------------------------- files
/// The scenario with the next shot in the place of its namesake. A world is not given more to fire than it had.
Scenario Client::with_next_shot() const {
  Scenario scenario = session.scenario();
  scenario.study = study.asked;
  ScenarioShot next = launcher.shot();
  const auto is_namesake = [&](const ScenarioShot& s) { return s.projectile.name == next.projectile.name; };
  const auto namesake = std::find_if(scenario.shots.begin(), scenario.shots.end(), is_namesake);
  if (keeps_no_bodies())
    next.body = namesake != scenario.shots.end() ? namesake->body : launcher.types()[launcher.type()].shot.body;
  if (namesake != scenario.shots.end())
    *namesake = next;
  else if (!scenario.world.given || scenario.shots.empty())
    scenario.shots.push_back(next);
  if (becomes_world() && !scenario.world.given) scenario.expect.clear();
  return becomes_world() ? with_world(scenario) : scenario;
}

/// Flights that had things keep theirs; what is put up beside other flights stands in a world, where expectations of
/// flights would not be read.
bool Client::becomes_world() const { return became_world_ || (!session.scenario().things.empty() && !meets_things_); }

/// A file of flights says nothing of bodies: they are those of worlds.
bool Client::keeps_no_bodies() const {
  return !scenario_file_.empty() && !session.scenario().world.given && !becomes_world();
}

std::string Client::path_to_save(const std::string& file) const {
  const std::string own = scenario_file_.empty() ? free_name("scenario", ".toml") : scenario_file_;
  return file.empty() ? own : file;
}

/// A file that cannot be revised is written anew, by what is set alone.
std::string Client::loss_of_saving(const std::string& file) const {
  const std::string path = path_to_save(file);
  if (session.is_replay() || text_.empty() || !is_same_file(path, scenario_file_)) return "";
  const Scenario changed = with_next_shot();
  const std::size_t expected = session.scenario().expect.size();
  std::string lost;
  if (!revised_text(text_, path, changed, units_.typed())) lost = "its comments and its own units";
  if (changed.expect.size() < expected)
    lost += (lost.empty() ? "" : ", and ") + formatted("its %zu expectations", expected);
  return lost.empty() ? "" : path + " would be written anew, as a world: " + lost + " would be lost. ";
}

Status Client::save(const std::string& file) {
  if (session.is_replay()) return Error{"a replay has no scenario", "save", "come back from it first: replay"};
  const std::string path = path_to_save(file);
  Scenario scenario = with_next_shot();
  const auto text_of = [&] {
    const auto revised = text_.empty() ? std::nullopt : revised_text(text_, path, scenario, units_.typed());
    return revised ? *revised : document_as_typed(scenario_text(scenario), units_.typed());
  };
  std::string text = text_of();
  Result<Scenario> again = parse_scenario(text, path);
  if (!again) return Error{"what is set is no scenario: " + again.error().message, "save", again.error().hint};
  std::string left_out;
  const Scenario& own_scenario = session.scenario();
  if (scenario.world.given && !own_scenario.world.given && !own_scenario.things.empty())
    left_out =
        own_scenario.expect.empty() ? ", as a world" : ", as a world, without what its flights were expected to do";
  if (!say_the_same(*again, scenario)) {  // the body of the first shot of a new file
    PHYSIM_ASSERT(!keeps_no_bodies());
    became_world_ = true;
    scenario = with_world(scenario), text = text_of();
  }
  const auto has_this_body = [&](const ScenarioShot& s) { return s.body == launcher.shot().body; };
  if (keeps_no_bodies() && std::ranges::none_of(scenario.shots, has_this_body))
    left_out = ", but for shot.body: its flights know no world";
  const auto is_next = [&](const ScenarioShot& s) { return s.projectile.name == launcher.shot().projectile.name; };
  if (std::ranges::none_of(scenario.shots, is_next)) left_out = ", but for the next shot: its world would fire it";
  const Result<Session> opened = Session::create(*again);
  if (!opened) return Error{"what is set could not be opened: " + opened.error().message, "save", opened.error().hint};
  const bool is_own_file = is_same_file(path, scenario_file_) || is_same_file(path, own_scenario.file);
  if (Status status = is_own_file ? Status() : check_output(path); !status) return status;
  if (Status status = report::write_file(path, text); !status) return status;
  scenario_file_ = path;
  if (text_.empty()) text_ = text, units_ = FileUnits(text);  // else changes are put into what its author wrote
  unsaved_ = false;
  recent.add(path);
  return say("saved " + path + left_out), Status();
}

Status Client::check_output(const std::string& path) const {
  std::vector<std::string> taken = inputs_;
  taken.push_back(scenario_file_);
  if (session.is_replay()) taken.push_back(session.scenario().file);
  if (session.is_recording()) taken.insert(taken.end(), {recorded_, recorded_ + kIncomplete});
  for (const std::string& input : study.asked.inputs)
    if (const std::string_view file = file_of_column(input); !file.empty())
      taken.push_back(beside_scenario(session.scenario(), std::string(file)));
  for (const std::string& file : taken)
    if (is_same_file(file, path))
      return Error{"cannot write: this session reads or records " + file, path, "name another file"};
  return {};
}

Status Client::export_file(const std::string& path, const report::Content& content) const {
  if (Status status = check_output(path); !status) return status;
  return report::write_content(path, content);
}

Status Client::save_flights(const std::string& file) {
  const std::string path = file.empty() ? free_name("flights", ".csv") : file;
  const bool has_ending = std::filesystem::path(path).has_extension();  // else what the action's name says
  const auto format = report::format_of_file(has_ending ? path : ".csv", report::Subject::records);
  if (!format) return format.error();
  const report::Content content = report::content_of(**format, records_of(session.tracks()));
  if (Status status = export_file(path, content); !status) return status;
  return say("saved " + path), Status();
}

Status Client::record(const std::string& file) {
  if (session.is_recording()) {
    if (Status status = session.stop_recording(); !status) return status;
    return say("recorded " + recorded_), Status();
  }
  if (session.is_replay()) return Error{"a replay cannot be recorded", "record", "come back from it first: replay"};
  const std::string path = file.empty() ? free_name("recording", ".rec") : file;
  for (const std::string& each : {path, path + kIncomplete})
    if (Status status = check_output(each); !status) return status;
  if (Status status = session.restart(path); !status) return status;
  recorded_ = path;
  selected = {};
  ++session_version_;
  return say("started again, recording into " + path), Status();
}

Status Client::replay() {
  if (session.is_replay()) {
    if (!scenario_file_.empty()) return open(std::string(scenario_file_));
    return use_session(Session::create(open_range()));
  }
  if (recorded_.empty()) return Error{"nothing was recorded yet", "replay", "record first, or open FILE.rec"};
  if (session.is_recording())
    if (Status status = session.stop_recording(); !status) return status;
  return open(recorded_);
}

void Client::take_typed(std::string_view assignment) {
  const std::size_t equals = std::min(assignment.find('='), assignment.size());
  units_.take_typed(trimmed(assignment.substr(0, equals)), assignment.substr(std::min(equals + 1, assignment.size())));
}

Status Client::set(const std::string& assignment) {
  const FilesInUse read;
  Scenario scenario = session.scenario();
  ScenarioShot shot = launcher.shot();
  if (Status status = set_value(assignment, scenario, shot); !status) return status;
  take_typed(assignment);
  std::ranges::copy(read.inputs(), std::back_inserter(inputs_));
  return use(scenario, shot);
}

Status Client::set(const SettingRow& row, const std::string& text) {
  const FilesInUse read;
  Scenario scenario = session.scenario();
  ScenarioShot shot = launcher.shot();
  if (Status status = set_value(row, text, scenario, shot); !status) return status;
  units_.take_typed(row.path, text);
  std::ranges::copy(read.inputs(), std::back_inserter(inputs_));
  return use(scenario, shot);
}

Status Client::set_emitters(const std::vector<ScenarioEmitter>& emitters) {
  if (Status status = session.set_emitters(emitters); !status) return status;
  selected = {};
  unsaved_ = true;
  ++session_version_;
  content_.emitters = ++contents_;
  note_changes();
  return {};
}

Status Client::use(const Scenario& scenario, const ScenarioShot& shot) {
  launcher.set_shot(shot);
  unsaved_ = true;
  Status status;
  if (!(scenario.environment == session.scenario().environment)) {
    ++session_version_;
    status = session.set_environment(scenario.environment);
    if (status) content_.environment = ++contents_;
  }
  note_changes();
  return status;
}

const Prediction& Client::prediction() {
  if (predicted_at_ == versions()) return prediction_;
  if (!predicted_at_ || predicted_at_->second != session_version_) predictor_.forget_world();
  const bool is_slow = comes_beside(foretold_.seconds, !predicted_at_);
  if (flies_whole() && is_slow) return predict_beside(), prediction_;
  const Stopwatch watch;
  Prediction next = session.is_replay() ? prediction_ : Prediction();
  if (flies_whole())
    next = prediction_of(fly_shot(session.scenario(), launcher.shot()), session.scenario());
  else if (!session.is_replay())
    next = predictor_.predict(session, launcher.shot(), kForeseen,
                              is_slow ? kOfAFrame : std::numeric_limits<double>::infinity());
  if (!is_slow) foretold_.seconds = watch.seconds();
  use(std::move(next));
  return prediction_;
}

void Client::use(Prediction prediction) {
  foretold_.forget();
  prediction_ = std::move(prediction);
  predicted_at_ = versions();
}

/// The aim is at once that of the shot, and its path comes later.
void Client::predict_beside() {
  if (foretold_.asked_for == versions()) return;
  foretold_.asked_for = versions();
  Prediction next = beginning_of(session.scenario(), launcher.shot());
  if (next.error) return use(std::move(next));
  next.path = std::move(prediction_.path);
  next.apsides = prediction_.apsides;
  next.is_cut = prediction_.is_cut;
  next.is_old = true;
  prediction_ = std::move(next);
  foretold_.beside->ask([at = versions(), scenario = session.scenario(), shot = launcher.shot()] {
    const Stopwatch watch;
    Foretold told{.at = at, .prediction = prediction_of(fly_shot(scenario, shot), scenario)};
    told.seconds = watch.seconds();
    return told;
  });
}

/// The prediction at hand is of a long flight in the world, and goes on.
bool Client::foresees_more() const { return prediction_.grows && predicted_at_ == versions() && !session.is_replay(); }

void Client::foresee_more(double patience) {
  const bool has_time = patience == std::numeric_limits<double>::infinity();
  predictor_.go_on(prediction_, has_time ? patience : std::min(patience, kOfAFrame));
  if (prediction_.grows) return;
  flight_at_.reset();
  prediction_.apsides = apsides_of(prediction_.path, session.scenario().environment, prediction_.granted.fidelity);
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
std::optional<Client::Arrow> Client::arrow() {
  const Prediction& flight = prediction();
  const double speed = length(flight.velocity);
  const bool at_rest = !(speed > 0);  // and pushed along the barrel
  if (session.is_replay() || flight.error || (at_rest && launcher.shot().projectile.force == Vec3d{}))
    return std::nullopt;
  const double size = std::max(camera.distance * 0.16, 60 * camera.pixel_size(flight.muzzle));
  return Arrow{
      flight.muzzle,
      flight.muzzle + (at_rest ? normalized(launcher.shot().projectile.force) : flight.velocity * (1 / speed)) * size};
}

std::optional<Client::Probe> Client::probe(const Pixel& pixel) {
  std::optional<Probe> best;
  double nearest = kReach;
  const Projector view = camera.projector();
  const auto look = [&](const Track* track, const std::vector<TrackSample>& samples) {
    std::optional<Pixel> last;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::optional<Pixel> seen = view.project(samples[i].position);
      if (!seen) {
        last.reset();
        continue;
      }
      const Pixel from = i > 0 && last ? *last : *seen;
      const double x = seen->x - from.x, y = seen->y - from.y, size = x * x + y * y;
      const double along = (pixel.x - from.x) * x + (pixel.y - from.y) * y;
      const double part = size > 0 ? std::clamp(along / size, 0.0, 1.0) : 1;
      const double away = std::hypot(from.x + part * x - pixel.x, from.y + part * y - pixel.y);
      if (away < nearest) {
        nearest = away;
        best = Probe{track, part < 1 ? between(samples[i - 1], samples[i], part) : samples[i]};
      }
      last = seen;
    }
  };
  for (const Track& track : session.tracks()) look(&track, track.samples);
  if (show.prediction && !prediction().is_old) look(nullptr, prediction().path);
  return best;
}

std::vector<Vec3d> Client::subject() {
  const Scenario& scenario = session.scenario();
  if (run_at_ != session_version_) {
    run_places_ = session.is_replay() ? std::vector<Vec3d>() : places_of_run(scenario);
    run_at_ = session_version_;
  }
  if (flight_at_ != versions() && run_places_.empty() && !session.is_replay() && !prediction().is_old) {
    flight_places_ = places_of_flight(scenario, launcher.shot(), {prediction().path, prediction().is_cut});
    flight_at_ = versions();
  }
  std::vector<Vec3d> places = run_places_;  // what it fires is among them
  if (places.empty()) {
    if (!session.is_replay()) {
      places = flight_places_;
      places.push_back(launcher.shot().launch.position);
    }
    for (const Track& track : session.tracks())
      for (const TrackSample& s : track.samples) places.push_back(s.position);
  }
  return subject_of(std::move(places), scenery(), session.ground());
}

void Client::fit_view() {
  fits_ = true;
  fitted_to_ = {camera.width(), camera.height(), launcher.type(), session_version_};
  const std::vector<Vec3d> places = subject();
  const bool has_things = !scenery().is_empty();
  if (camera.mode == CameraMode::side) {
    camera.yaw = launcher.azimuth() - kRightAngle;
    camera.pitch = 0.05;
    const double steepness = height_over_length(places);
    camera.stretch = steepness > 0 ? std::clamp(scale_step(1 / steepness, 5), 1.0, 1000.0) : 1;
  } else {
    // Flat flights are seen more from the side, and things stand one behind the other.
    constexpr double kFromBehind = 0.35, kFromAside = 1.1, kOfThings = 0.8;  // [rad]
    const double flatness = std::clamp(1 - 4 * height_over_length(places), 0.0, 1.0);
    const std::optional<double> along = run_places_.empty() ? std::nullopt : long_side_of(places);
    camera.stretch = 1;
    if (has_things)
      camera.yaw = launcher.azimuth() - kOfThings;
    else if (along)
      camera.yaw = *along - kFromAside;
    else
      camera.yaw = launcher.azimuth() - std::lerp(kFromBehind, kFromAside, flatness);
    camera.pitch = has_things ? 0.3 : 0.22;
  }
  camera.fit(places);
}

/// A projectile that flies, in a view that looks at all.
bool Client::is_out_of_view() const {
  const Projector view = camera.projector();
  return std::ranges::any_of(session.tracks(), [&](const Track& track) {
    const auto at = view.project(track.samples.back().position);
    const bool is_seen = at && at->x >= 0 && at->y >= 0 && at->x <= camera.width() && at->y <= camera.height();
    return track.is_flying() && !is_seen;
  });
}

void Client::keep_view() {
  const FittedTo now{camera.width(), camera.height(), launcher.type(), session_version_};
  const bool is_due = now != fitted_to_ || (run_places_.empty() && is_out_of_view());
  if (fits_ && camera.mode != CameraMode::follow && is_due) fit_view();
  const bool is_round = row(launcher.shot().projectile.fidelity.earth).shape != EarthShape::flat;
  if (const auto ground = session.ground(); ground && !is_round) camera.stay_above(*ground);
}

Camera Client::camera_for(double width, double height) {
  const Camera now = camera;
  const FittedTo fitted_to = fitted_to_;
  camera.set_viewport(width, height);
  if (fits_ && camera.mode != CameraMode::follow) fit_view();
  keep_view();
  const Camera fitted = std::exchange(camera, now);
  fitted_to_ = fitted_to;
  return fitted;
}

void Client::next_camera() {
  camera.mode = static_cast<CameraMode>((static_cast<int>(camera.mode) + 1) % 3);
  if (camera.mode == CameraMode::follow) {
    camera.yaw = launcher.azimuth() - 0.25;
    camera.pitch = 0.15;
    camera.distance = std::min(camera.distance, 25.0);
    camera.stretch = 1;
  } else {
    fit_view();
  }
}

void Client::follow() {
  const Track* track = camera.mode == CameraMode::follow ? selected_track() : nullptr;
  if (track != nullptr && !track->samples.empty())
    camera.target = track->is_flying() ? session.shown(*track).position : track->samples.back().position;
}

// ------------------------------------------------------------------------------------------------------------ messages
void Client::say(const std::string& text) { messages_.push_back({text, false, 0}); }
void Client::complain(const Error& error) { messages_.push_back({error.text(), true, 0}); }

}  // namespace physim::client
