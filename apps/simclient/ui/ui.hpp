// Ui: panels, menus and labels around and over the scene, with Dear ImGui. It only shows the client, and runs actions.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "simclient/core/client.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/ui/emitter_panel.hpp"
#include "simclient/ui/file_dialog.hpp"
#include "simclient/ui/gallery_panel.hpp"
#include "simclient/ui/play_bar.hpp"
#include "simclient/ui/settings_panel.hpp"

namespace physim::client {

class Ui {
 public:
  explicit Ui(float scale);
  void draw(Client& client, const Scene& scene);
  /// Between frames; true if letters changed, which are drawn out of a new texture then.
  bool set_scale(float scale);
  /// The menu of a right click on the scene.
  void open_menu() { opens_menu_ = true; }
  /// Esc: closes what is open; false where there was nothing.
  bool close_something(Client& client);
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// The plots were drawn without buttons, as somebody asked for a picture of them.
  [[nodiscard]] bool has_bare_plots() const { return has_bare_plots_; }
  [[nodiscard]] Thumbnails& thumbnails() { return gallery_.thumbnails(); }
  /// A picture of the gallery is still to come.
  [[nodiscard]] bool is_busy() const { return gallery_.is_busy(); }
  [[nodiscard]] float scale() const { return scale_; }
  /// Where the mouse is on the scene, to show what is under it.
  void set_mouse(const Pixel& pixel, bool on_scene) { mouse_ = pixel, mouse_on_scene_ = on_scene; }

 private:
  static constexpr const char *kSettings = "###settings", *kStatistics = "###statistics";

  void steer(const Client& client);
  void draw_menu_bar(Client& client);
  void draw_tests_menu(Client& client);
  void draw_context_menu(Client& client);
  /// A piece of the line at the foot of the window.
  struct Item {
    std::string what, value;
    Colour colour = colours::kText;
    std::string note;        // shown while the mouse rests on it
    bool is_detail = false;  // is left out where there is no room for all
  };
  [[nodiscard]] std::vector<Item> status_items(Client& client) const;
  void draw_status(Client& client);
  void draw_labels(const Client& client, const Scene& scene);
  void draw_messages(const Client& client);
  void draw_placing(Client& client);
  void draw_probe(Client& client);
  void draw_help(Client& client);
  void draw_question(Client& client);
  void draw_film(Client& client);
  void draw_picture_menus(Client& client);
  void draw_recent_menu(Client& client);

  float scale_;
  SettingsPanel settings_;
  EmitterPanel emitters_;
  PlayBar play_;
  FileDialog files_;
  GalleryPanel gallery_;
  Layout layout_;
  Pixel mouse_;
  bool mouse_on_scene_ = false, opens_menu_ = false, has_bare_plots_ = false;
};

}  // namespace physim::client
