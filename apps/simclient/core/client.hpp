// Client: everything that the windows show and the keys change, without a window.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "simclient/core/camera.hpp"
#include "simclient/core/launcher.hpp"
#include "simclient/core/prediction.hpp"
#include "simclient/core/session.hpp"

namespace physim::client {

/// What is shown.
struct Shown {
  bool settings = true;    // panel of the next shot
  bool statistics = true;  // panel of those in flight
  bool plots = false;
  bool compare = false;
  bool performance = false;
  bool help = false;
  bool trails = true;
  bool vectors = false;
  bool prediction = true;
  bool marks = true;  // apex and impact
};

/// What a left click on the scene does.
enum class Tool {
  fire,
  tape,  // sets the ends of the tape measure
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
  explicit Client(Session session);

  Session session;
  Launcher launcher;
  Camera camera;
  Shown show;
  Tool tool = Tool::fire;
  Tape tape;
  ProjectileId selected;     // whose numbers are shown in full; null: the last one fired
  std::string output = ".";  // folder for files without one of their own
  bool leaves = false;

  /// Time has passed on the screen [s].
  void advance(double real_dt);
  /// Another scenario or recording instead of this one; what was there stays where it cannot be.
  Status open(const std::string& file);
  Status restart();
  Status fire();

  /// What the next shot would do; flown again only when something changed.
  [[nodiscard]] const Prediction& prediction();
  [[nodiscard]] const Track* selected_track() const;
  void select_next();

  // ------------------------------------------------------------------------------------------------------ the scene
  /// A click on the scene that was not a drag.
  void click(const Pixel& pixel);
  /// The nearest moment of a path under the mouse, within 12 pixels.
  struct Probe {
    const Track* track = nullptr;  // null: the predicted path
    TrackSample sample;
  };
  [[nodiscard]] std::optional<Probe> probe(const Pixel& pixel);
  void fit_view();
  void next_camera();

  void say(const std::string& text);
  void complain(const Error& error);
  [[nodiscard]] const std::deque<Message>& messages() const { return messages_; }

 private:
  void follow();
  [[nodiscard]] std::optional<Vec3d> point_under(const Pixel& pixel);

  Prediction prediction_;
  std::uint64_t predicted_version_ = ~std::uint64_t{0};
  std::uint64_t session_version_ = 0, predicted_session_ = 0;
  std::deque<Message> messages_;
};

/// What the command line asks for: a scenario or a recording, or the open range where no file is named.
[[nodiscard]] Result<Client> open_client(const std::string& file, const std::vector<std::string>& overrides);

}  // namespace physim::client
