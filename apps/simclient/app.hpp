// App: the window, its events, and the loop of frames.
#pragma once

#include <fstream>
#include <optional>
#include <vector>

#include "simclient/core/input_queue.hpp"
#include "simclient/core/script.hpp"
#include "simclient/film.hpp"
#include "simclient/gl/renderer.hpp"
#include "simclient/gl/target.hpp"
#include "simclient/gl/window.hpp"
#include "simclient/options.hpp"
#include "simclient/ui/painter.hpp"
#include "simclient/ui/ui.hpp"

namespace physim::client {

class App {
 public:
  App(Client client, Script script, const Options& options)
      : options_(options), client_(std::move(client)), script_(std::move(script)) {}
  ~App();
  /// Opens the window and stays until somebody leaves; an error where it cannot.
  [[nodiscard]] Status run();
  /// Something was done to the window: it is drawn again.
  void has_changed() { frames_due_ = kSettling; }

 private:
  static constexpr int kSettling = 3;  // frames until panels show what was done to them

  /// A mouse button that is held down over the scene.
  struct Drag {
    int button = -1;
    double x = 0, y = 0, moved = 0;
  };

  /// A film that is being made, while the session goes through its time.
  struct Filming {
    std::string path;
    Camera camera;
    double scale = 1;
    double begin = 0, each = 0;  // of the world [s]
    int count = 0, taken = 0;    // pictures
    std::uint64_t step = 0;      // of the session, to come back to
    bool was_paused = false;
  };

  [[nodiscard]] Status open();
  void install_callbacks();
  void install_mouse_callbacks();
  void install_window_callbacks();
  [[nodiscard]] bool is_asked_to_close();
  /// Waits until a frame is due. The clock runs on meanwhile; what looks the same is not drawn again.
  void wait_for_frame();
  [[nodiscard]] bool has_to_draw() const;
  [[nodiscard]] bool draws_every_frame() const;
  [[nodiscard]] bool is_at_rest() const;
  /// Pictures, films and what scripts show have everything.
  [[nodiscard]] Quality quality_of_frame() const;
  void watch_frame(double drawn_at);
  void pass_time();
  [[nodiscard]] Status frame();
  [[nodiscard]] Picture picture_of_window(bool of_plots);
  /// Without panels, with a title and a scale bar; an error if it is larger than the machine draws.
  [[nodiscard]] Result<Picture> picture_of_scene(const Camera& camera, double scale);
  void draw_captions(const Scene& scene, const Camera& camera, float scale);
  [[nodiscard]] Status take_pictures();
  [[nodiscard]] Status take_picture(const PictureWish& wish);
  [[nodiscard]] Status begin_film(const std::string& wished);
  /// The next picture of the film.
  [[nodiscard]] Status film_one();
  [[nodiscard]] Status end_film(Status status);
  void on_panel_key(int code, int scancode, int action, int mods);
  void on_key(int code, int scancode, int action, int mods);
  void on_button(int button, int action, double x, double y);
  void on_move(double x, double y);
  void render(const Scene& scene);
  [[nodiscard]] float wanted_scale(double height) const;
  [[nodiscard]] double frame_time();
  [[nodiscard]] bool is_last_frame() const;
  [[nodiscard]] Pixel on_scene(double x, double y) const;
  [[nodiscard]] bool is_over_scene(double x, double y) const;

  const Options options_;
  Client client_;
  Script script_;
  Window window_;
  Renderer renderer_;
  std::optional<Target> target_;
  std::optional<Ui> ui_;
  Painter painter_;
  Film film_;
  std::optional<Filming> filming_;
  Scene scene_;
  std::ofstream state_;
  InputQueue inputs_;
  QualityPicker picker_;
  Drag drag_;
  double mouse_x_ = -1, mouse_y_ = -1, last_time_ = 0, last_drawn_ = 0;
  double last_end_ = 0, waited_ = 0;  // of the last frame; without anything to do since then [s]
  std::uint64_t frame_ = 0;
  int frames_due_ = kSettling;
  std::size_t messages_drawn_ = 0;
  bool has_imgui_ = false;
};

}  // namespace physim::client
