// App: the window, its events, and the loop of frames.
#pragma once

#include <fstream>
#include <optional>
#include <vector>

#include "simclient/core/script.hpp"
#include "simclient/gl/renderer.hpp"
#include "simclient/gl/target.hpp"
#include "simclient/gl/window.hpp"
#include "simclient/options.hpp"
#include "simclient/ui/ui.hpp"

namespace physim::client {

class App {
 public:
  App(Client client, Script script, const Options& options)
      : options_(options), client_(std::move(client)), script_(std::move(script)) {}
  ~App();
  /// Opens the window and stays until somebody leaves; an error where it cannot.
  [[nodiscard]] Status run();

 private:
  /// Something that a hand did, in the order in which it was done.
  struct Input {
    enum class Kind { key, button, move, scroll } kind;
    int code = 0, scancode = 0, action = 0, mods = 0;
    double x = 0, y = 0;
  };
  /// A mouse button that is held down over the scene.
  struct Drag {
    int button = -1;
    double x = 0, y = 0, moved = 0;
  };

  [[nodiscard]] Status open();
  void install_callbacks();
  [[nodiscard]] Status frame();
  [[nodiscard]] Picture picture(bool of_plots);
  [[nodiscard]] Status take_pictures();
  void read_inputs();
  void on_key(const Input& input);
  void on_button(const Input& input);
  void on_move(const Input& input);
  void on_scroll(const Input& input);
  void render(const Scene& scene);
  [[nodiscard]] double frame_time();
  [[nodiscard]] bool is_last_frame() const;
  [[nodiscard]] Pixel on_scene(double x, double y) const;
  [[nodiscard]] bool is_over_scene(double x, double y) const;

  const Options options_;
  Client client_;
  Script script_;
  Glfw glfw_;
  Window window_;
  Renderer renderer_;
  std::optional<Target> target_;
  std::optional<Ui> ui_;
  Scene scene_;
  std::ofstream state_;
  std::vector<Input> inputs_;
  Drag drag_;
  double mouse_x_ = -1, mouse_y_ = -1, last_time_ = 0;
  std::uint64_t frame_ = 0;
  bool has_imgui_ = false;
};

}  // namespace physim::client
