// Client: everything that the windows show and the keys change, without a window.
#pragma once

#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "report/picture.hpp"
#include "simclient/core/beside.hpp"
#include "simclient/core/camera.hpp"
#include "simclient/core/compare.hpp"
#include "simclient/core/history.hpp"
#include "simclient/core/launcher.hpp"
#include "simclient/core/placing.hpp"
#include "simclient/core/plot_data.hpp"
#include "simclient/core/prediction.hpp"
#include "simclient/core/quality.hpp"
#include "simclient/core/recent_files.hpp"
#include "simclient/core/scenery.hpp"
#include "simclient/core/session.hpp"
#include "simclient/core/setting_rows.hpp"
#include "simclient/core/study_desk.hpp"
#include "simclient/core/target_report.hpp"
#include "simclient/core/theme.hpp"

namespace physim::client {

/// The quantity that colours trails.
enum class TrailColour { shot, speed, mach, energy };

/// What is shown.
struct Shown {
  bool settings = true;    // panel of the next shot
  bool statistics = true;  // panel of those in flight
  bool play = true;        // the bar of play
  bool help = false;
  bool emitters = false;    // panel of their curves
  bool panel_keys = false;  // arrows, Enter, Space and Tab belong to the panels
  bool trails = true;
  TrailColour trails_by = TrailColour::shot;
  bool aim = true;       // the arrow, and the predicted path
  bool attitude = true;  // the cone of the yaw of bodies whose attitude is flown
  bool vectors = false;
  bool forces_add_up = false;  // each force begins where the one before ends
  bool prediction = true;
  bool depth = true;  // drop lines, and the ways of projectiles over the ground
  bool marks = true;  // apex, impact, hits on things, and what these are called
};

/// Letters: of 13, 15 and 21 pixels on a usual screen.
enum class TextSize { small, usual, large };
[[nodiscard]] double scale_of(TextSize size);

/// What stands under the scene.
enum class BottomPanel { none, plots, compare, performance, hits, study };

struct Action;

/// The dialog that is open: one that chooses a file, or the gallery.
enum class Dialog { none, open, save, gallery };

/// An action that would lose work: it waits until somebody says yes.
struct Question {
  std::string text;  // what would be lost
  const Action* action = nullptr;
  std::string argument;
  bool can_save = false;  // in another file, and nothing is lost
};

/// Contents of a picture.
enum class PictureOf {
  window,
  plots,  // the panel under the scene alone
  scene,  // without panels
  film,   // of the scene, the last seconds
};

/// A picture that somebody asked for, to be taken of the next frame.
struct PictureWish {
  std::string path;  // empty: the next free name
  PictureOf of = PictureOf::window;
};

/// What a left click on the scene does.
enum class Tool {
  fire,
  tape,    // sets the ends of the tape measure
  wall,    // sets the feet of a wall
  target,  // puts a target there
};

/// The two ends of the tape measure.
struct Tape {
  std::optional<Vec3d> from, to;
};

/// A line that tells what happened.
struct Message {
  std::string text;
  bool is_error = false;
  double shown = 0;  // [s] of the screen
};

class Client {
 public:
  /// `file`: of the scenario; empty where it is of no file.
  explicit Client(Session session, const std::string& file = "");

  Session session;
  Launcher launcher;
  Camera camera;
  Shown show;
  const Theme* theme = &themes()[0];
  TextSize letters = TextSize::usual;
  QualityChoice quality;
  Tool tool = Tool::fire;
  Tape tape;
  Placing placing;
  std::optional<Vec3d> wall_from;  // the foot of a wall that was set first
  std::optional<Pixel> pointer;    // the mouse over the scene
  ProjectileId selected;           // whose numbers are shown in full; null: the last one fired
  BottomPanel bottom = BottomPanel::none;
  std::vector<PlotSpec> plots;
  bool plots_selected_alone = false;
  std::vector<std::string> compared = {"game", "constant_air", "small_arms"};  // presets, beside the reference
  std::vector<PictureWish> pictures;
  int picture_size = 2;          // of pictures of the scene, in windows, from 1 to 4
  double film_length = 10;       // of films [s of the screen]
  std::optional<double> filmed;  // part of a film that is being made
  bool stops_film = false;
  std::optional<Question> question;  // to be answered before anything else
  std::optional<Question> waits;     // what follows when the scenario has been saved
  Dialog dialog = Dialog::none;
  RecentFiles recent;
  StudyDesk study;
  std::deque<float> frame_times;  // that the last frames took [s]
  bool leaves = false;
  bool computes_beside = false;  // slow predictions and comparisons are computed while frames are drawn
  float settings_height = 0;     // that shows all that the panel of settings has now [pixels]; 0: unknown yet
  std::uint64_t slide = 0;       // the number of the slide of a slider that is held, which is one change; 0: none is
  std::optional<double>
      cursor;  // the time of the world that the mouse points at, on a path, a plot or the timeline [s]
  Pixel timeline_from, timeline_to;  // of the bar of play, in the window [pixels]
  Pixel scene_corner;                // of the scene, upper left, in the window [pixels]

  /// Time has passed on the screen [s]. `patience`: what the steps in it may take [s of the machine's clock].
  void advance(double real_dt, double patience = std::numeric_limits<double>::infinity());
  /// The picture changes by itself: something moves, a study counts on, or a picture was asked for.
  [[nodiscard]] bool is_changing() const;
  /// Another scenario or recording instead of this one; what was there stays where it cannot be.
  [[nodiscard]] Status open(const std::string& file);
  [[nodiscard]] Status restart();
  [[nodiscard]] Status fire();
  /// Takes back the last change by hand, and brings back what was taken back.
  [[nodiscard]] Status undo() { return bring_back(history_.undo(), "undo"); }
  [[nodiscard]] Status redo() { return bring_back(history_.redo(), "redo"); }
  [[nodiscard]] const History& history() const { return history_; }
  /// Notes what was changed by hand since the last call, for undo().
  void note_changes();
  /// Computes the flight of the next shot whole, as `physim run` does, and plays it.
  [[nodiscard]] Status fire_whole();
  /// As the scenario says, by a hand: the shots of a scenario without a world and without things are flown whole, to
  /// the end that it sets; others into the world.
  [[nodiscard]] Status fire_by_hand();
  /// The last one that was fired by hand, if the next shot is the same; null: there is none, or its trail is not shown.
  [[nodiscard]] const Track* last_of_this_shot() const;
  /// All shots of the scenario at once.
  [[nodiscard]] Status fire_scenario();
  /// The next shot on every rung of the comparison at once: where the scenario has no world, the flights that were
  /// compared are played.
  [[nodiscard]] Status fire_compared();
  /// The next shot on the rungs that are compared; flown again only when something changed.
  [[nodiscard]] const std::vector<ComparedRung>& comparison();
  /// It is that of a shot before, until that of this one is computed.
  [[nodiscard]] bool is_comparison_old() const { return comparison_.asked_for.has_value(); }
  /// A prediction or a comparison is computed beside the frames.
  [[nodiscard]] bool awaits_answer() const { return foretold_.asked_for || comparison_.asked_for; }
  /// Saves the scenario with the next shot, into the file that it came from where none is named. Nothing is written
  /// that could not be read again.
  [[nodiscard]] Status save(const std::string& file);
  /// Comments, units and expectations of a file that saving would lose, as a sentence; empty if it loses nothing.
  [[nodiscard]] std::string loss_of_saving(const std::string& file) const;
  /// The file of the scenario; empty if it has none.
  [[nodiscard]] const std::string& file() const { return scenario_file_; }
  /// Settings were changed by hand, and not saved.
  [[nodiscard]] bool has_unsaved_settings() const { return unsaved_; }
  void has_changed_settings() { unsaved_ = true; }
  /// The numbers of an assignment are shown and saved with the units that they have there.
  void take_typed(std::string_view assignment);
  /// The units of the file that is open, and of what was typed.
  [[nodiscard]] const FileUnits& units() const { return units_; }
  using Versions = std::pair<std::uint64_t, std::uint64_t>;  // of the shot and of what it is fired into
  [[nodiscard]] Versions versions() const { return {launcher.version(), session_version_}; }
  /// Writes a file that is no scenario; refuses what check_output() refuses.
  [[nodiscard]] Status export_file(const std::string& path, const report::Content& content) const;
  /// An error if the session comes from the file of this path, or records into it. Saving may replace the scenario.
  [[nodiscard]] Status check_output(const std::string& path) const;
  /// Saves all that flew, sample by sample; the format is that of the file's ending.
  [[nodiscard]] Status save_flights(const std::string& file);
  /// Starts again and records everything into a file; completes the file when it is recording.
  [[nodiscard]] Status record(const std::string& file);
  /// Plays what was recorded last, and comes back from it.
  [[nodiscard]] Status replay();
  void show_bottom(BottomPanel panel) { bottom = bottom == panel ? BottomPanel::none : panel; }
  /// Changes a setting of the next shot or of the environment: "shot.mass=170 gr".
  [[nodiscard]] Status set(const std::string& assignment);
  /// Changes the setting of a row.
  [[nodiscard]] Status set(const SettingRow& row, const std::string& text);

  /// Emitters instead of those of the scenario; it starts again, and goes on to the moment at hand.
  [[nodiscard]] Status set_emitters(const std::vector<ScenarioEmitter>& emitters);

  /// The flight of the next shot, computed again if something changed. If the last computation took longer than a frame
  /// and `computes_beside` is set, the former path is returned until the thread has the new one.
  [[nodiscard]] const Prediction& prediction();
  [[nodiscard]] const Track* selected_track() const;
  void select_next();

  // ------------------------------------------------------------------------------------------------------ the scene
  /// The ends of the arrow that shows the aim; nothing where the shot does not move.
  struct Arrow {
    Vec3d from, to;
  };
  [[nodiscard]] std::optional<Arrow> arrow();
  /// A click on the scene that was not a drag: fires, where no world runs by itself; else it selects what is there.
  void click(const Pixel& pixel);
  [[nodiscard]] bool fires_by_click() const { return !session.scenario().world.given && !session.is_replay(); }
  /// The mouse goes on with this; with what it did before where it has it already.
  void use_tool(Tool tool);
  /// Where a pixel meets a thing or the ground, or height 0 where there is none.
  [[nodiscard]] std::optional<Vec3d> surface_under(const Pixel& pixel) const;
  [[nodiscard]] Status place_wall(const Vec3d& from, const Vec3d& to);
  [[nodiscard]] Status place_target(const Vec3d& middle);
  /// The place of a target for a click: on a path if the whole target is above the ground there, else with its lower
  /// edge on the surface under the pixel.
  [[nodiscard]] std::optional<Vec3d> target_under(const Pixel& pixel);
  /// The change of aim by which a shot that missed a target hits it; computed once for each shot and target.
  [[nodiscard]] std::optional<AimChange> aim_change_of(const Track& track, const TargetDisc& target);
  /// The things of the scene as they are drawn.
  [[nodiscard]] const Scenery& scenery();
  /// The nearest moment of a path under the mouse, within 12 pixels.
  struct Probe {
    const Track* track = nullptr;  // null: the predicted path
    TrackSample sample;
  };
  [[nodiscard]] std::optional<Probe> probe(const Pixel& pixel);
  /// Looks at what the scenario is about. It does so again where the view's size or the type of shot changes and where
  /// a projectile leaves the view, until the view is moved by hand.
  void fit_view();
  /// The view was moved by hand, and stays.
  void has_moved_view() { fits_ = false; }
  /// Once a frame: fits the view again if that is due, and keeps the eye above the ground.
  void keep_view();
  /// Places of what the scenario is about.
  [[nodiscard]] std::vector<Vec3d> subject();
  void next_camera();
  /// The camera for a picture of this size [pixels], fitted to it where the view fits itself.
  [[nodiscard]] Camera camera_for(double width, double height);

  void say(const std::string& text);
  void complain(const Error& error);
  [[nodiscard]] const std::deque<Message>& messages() const { return messages_; }

 private:
  void follow();
  void select_under(const Pixel& pixel);
  [[nodiscard]] bool flies_whole() const;
  void take_answers();
  [[nodiscard]] bool comes_beside(double seconds, bool is_first) const;
  void use(Prediction prediction);
  void predict_beside();
  [[nodiscard]] bool foresees_more() const;
  void foresee_more(double patience);
  [[nodiscard]] bool is_out_of_view() const;
  void take_file(const std::string& file);
  [[nodiscard]] Scenario with_next_shot() const;
  [[nodiscard]] bool becomes_world() const;
  [[nodiscard]] bool keeps_no_bodies() const;
  [[nodiscard]] Status use_session(Result<Session> opened);
  [[nodiscard]] Status use(const Scenario& scenario, const ScenarioShot& shot);
  [[nodiscard]] std::optional<Vec3d> point_under(const Pixel& pixel);
  [[nodiscard]] Status place(const Result<Placed>& placed);

  [[nodiscard]] Status bring_back(const Moment* moment, const char* how);
  [[nodiscard]] std::string path_to_save(const std::string& file) const;

  SceneryMaker scenery_;
  struct Missed {
    ProjectileId id;
    std::string target;
    std::uint64_t session_version = 0;
    std::optional<AimChange> change;
  };
  std::deque<Missed> missed_;
  History history_;
  ContentVersions content_;
  std::uint64_t contents_ = 0;  // versions of content that there were
  double since_change_ = 1e9;   // of the screen [s]
  std::optional<Versions> noted_, fired_at_;
  std::uint64_t noted_slide_ = 0;
  ProjectileId fired_;  // by hand, the last one
  Predictor predictor_;
  Prediction prediction_;
  struct Compared {
    Versions at;
    std::vector<std::string> presets;
    bool operator==(const Compared&) const = default;
  };
  /// A computation that may run on a thread: the duration of the last one [s], the request that the thread works on,
  /// and the thread. It is behind a pointer, so that a client can be moved.
  template <class At, class Answer>
  struct Slow {
    double seconds = 0;
    std::optional<At> asked_for;
    std::unique_ptr<Beside<Answer>> beside = std::make_unique<Beside<Answer>>();
    void forget() {
      beside->forget();
      asked_for.reset();
    }
  };
  struct Foretold {
    Versions at;
    Prediction prediction;
    double seconds = 0;
  };
  struct ComparedAnswer {
    Compared of;
    std::vector<ComparedRung> rungs;
    CostTable costs;
    double seconds = 0;
  };
  Slow<Versions, Foretold> foretold_;
  Slow<Compared, ComparedAnswer> comparison_;
  std::vector<ComparedRung> rungs_;
  CostTable costs_;
  std::optional<Compared> compared_at_;   // none: never
  std::optional<Versions> predicted_at_;  // none: never
  bool has_answer_ = false;               // one came with the last advance()
  std::vector<std::string> inputs_;       // files that the scenario and its settings come from
  std::string scenario_file_, text_;      // of the scenario: its file, and what that says
  FileUnits units_;
  bool unsaved_ = false, became_world_ = false;  // became: when it was saved, as its shots ask for one
  bool meets_things_ = false;                    // its file is of flights, and has things
  std::string recorded_;                         // file of the last recording
  std::uint64_t session_version_ = 0;
  std::vector<Vec3d> run_places_, flight_places_;  // of the subject
  std::optional<std::uint64_t> run_at_;            // versions at which they were found; none: never
  std::optional<Versions> flight_at_;
  bool fits_ = true;  // the view, by itself
  struct FittedTo {
    double width = 0, height = 0;
    std::size_t type = 0;
    std::uint64_t restarts = 0;
    bool operator==(const FittedTo&) const = default;
  };
  FittedTo fitted_to_;
  std::deque<Message> messages_;
};

/// "physim_picture_1.png" in the folder where the client was started, or the next number that is free.
[[nodiscard]] std::string free_name(const std::string& what, const std::string& ending);

/// What the command line asks for: a scenario or a recording, or the open range where no file is named.
[[nodiscard]] Result<Client> open_client(const std::string& file, const std::vector<std::string>& overrides);

}  // namespace physim::client
