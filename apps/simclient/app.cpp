#include "simclient/app.hpp"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "simclient/core/actions.hpp"
#include "simclient/core/state_log.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

constexpr double kFrame = 1.0 / 60;          // of a hidden window [s]
constexpr double kShortestFrame = 1.0 / 62;  // of a window: screens show no more
constexpr double kTick = 1.0 / 30;           // between looks at the clock while nothing is drawn [s]
constexpr double kPausedTick = 0.25;         // [s]
constexpr double kClockDrawn = 2;            // the time of the simulation is drawn so often while nothing moves [s]
constexpr double kRest = 0.3;                // after which a still picture has everything [s]
constexpr double kLongestFrame = 0.25;       // of simulation, after a hitch [s]
constexpr double kClickReach = 4;            // a mouse that moves further drags [pixels]
constexpr double kTurnPerPixel = 0.006;      // [rad]
constexpr double kPatience = 0.03;           // with the steps of one frame [s]
constexpr float kLeastWidth = 480, kLeastHeight = 320;

}  // namespace

App::~App() {
  if (!has_imgui_) return;
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

Status App::run() {
  if (Status status = open(); !status) return status;
  while (!client_.leaves) {
    wait_for_frame();
    if (is_asked_to_close()) run_action(client_, *find_action("quit"));
    if (Status status = frame(); !status) return status;
    if (is_last_frame()) break;
  }
  return {};
}

/// Without a person: frames are counted there.
bool App::draws_every_frame() const {
  return options_.hidden || options_.frames > 0 || frame_ < static_cast<std::uint64_t>(script_.frames());
}

bool App::has_to_draw() const {
  if (glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED) == GLFW_TRUE) return false;
  const bool has_clock = !client_.session.is_paused() && !client_.session.is_over();
  const bool is_clock_due = has_clock && glfwGetTime() - last_drawn_ > kClockDrawn;
  return frames_due_ > 0 || !inputs_.is_empty() || drag_.button >= 0 || ImGui::IsAnyMouseDown() ||
         client_.is_changing() || filming_ || ui_->is_busy() || client_.messages().size() != messages_drawn_ ||
         is_clock_due || (is_at_rest() && glfwGetTime() - last_drawn_ > kRest && client_.quality.now != Quality::high);
}

/// Nothing moves and nothing was done. Such a picture is looked at, and has everything.
bool App::is_at_rest() const {
  return frames_due_ == 0 && inputs_.is_empty() && drag_.button < 0 && !client_.is_changing() &&
         !client_.quality.by_hand;
}

void App::wait_for_frame() {
  if (draws_every_frame()) return glfwPollEvents();
  do {
    const double rest = last_drawn_ + kShortestFrame - glfwGetTime();
    const bool is_calm = client_.session.is_paused() && !client_.awaits_answer();
    const double calm = is_calm ? kPausedTick : kTick;
    const double wait = has_to_draw() ? rest : std::max(rest, calm);
    const double before = glfwGetTime();
    if (wait > 0)
      glfwWaitEventsTimeout(wait);
    else
      glfwPollEvents();
    waited_ += glfwGetTime() - before;
    if (glfwWindowShouldClose(window_.get()) == GLFW_TRUE) return has_changed();
    pass_time();
  } while (!has_to_draw() || glfwGetTime() < last_drawn_ + kShortestFrame);
}

/// Advances the clock. A frame follows if something moved in this time, or came to rest.
void App::pass_time() {
  if (filming_) return;
  client_.computes_beside = !draws_every_frame();
  const bool was_changing = client_.is_changing();
  client_.advance(frame_time(), options_.hidden ? std::numeric_limits<double>::infinity() : kPatience);
  if (was_changing || client_.is_changing()) frames_due_ = std::max(frames_due_, 1);
}

/// By the button of the window's frame. Whether it closes is for the client to say.
bool App::is_asked_to_close() {
  const bool is_asked = glfwWindowShouldClose(window_.get()) == GLFW_TRUE;
  glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
  return is_asked;
}

Status App::open() {
  if (!options_.state.empty()) {
    state_.open(options_.state);
    if (!state_) return Error{"cannot write the file", options_.state, "is there such a folder?"};
  }
  Result<Window> window = open_window(options_.width, options_.height, options_.hidden);
  if (!window) return window.error();
  window_ = std::move(*window);
  const float scale = wanted_scale(options_.height);
  glfwSetWindowSizeLimits(window_.get(), static_cast<int>(kLeastWidth * scale), static_cast<int>(kLeastHeight * scale),
                          GLFW_DONT_CARE, GLFW_DONT_CARE);
  if (Status status = renderer_.make(); !status) return status;
  install_callbacks();
  install_mouse_callbacks();
  install_window_callbacks();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigInputTextCursorBlink = false;   // a field that waits is not drawn again and again
  ImGui_ImplGlfw_InitForOpenGL(window_.get(), false);  // events come through the queue
  ImGui_ImplOpenGL3_Init("#version 330 core");
  has_imgui_ = true;
  ui_.emplace(scale);
  const Layout layout =
      make_layout(client_, static_cast<float>(options_.width), static_cast<float>(options_.height), scale);
  client_.camera.set_viewport(layout.scene.width, layout.scene.height);
  client_.fit_view();
  if (!options_.hidden) client_.recent = RecentFiles(list_of_recent_files());
  if (!options_.scenario.empty()) client_.recent.add(options_.scenario);
  const bool is_bare = options_.scenario.empty() && options_.script.empty() && options_.frames == 0;
  if (is_bare && !options_.hidden && !options_.range) client_.dialog = Dialog::gallery;
  last_time_ = glfwGetTime();
  return {};
}

/// As asked for; else as the screen says, or by its rows where it says nothing.
float App::wanted_scale(double height) const {
  float of_screen = 1, unused = 1;
  if (!options_.hidden) glfwGetWindowContentScale(window_.get(), &of_screen, &unused);
  const double scale = options_.scale > 0 ? options_.scale : of_screen > 1 ? of_screen : scale_of_screen(height);
  return static_cast<float>(scale * scale_of(client_.letters));
}

// --------------------------------------------------------------------------------------------------------------- frame
Status App::frame() {
  const double start = glfwGetTime();
  const std::vector<InputEvent> inputs = inputs_.take();
  for (const InputEvent& input : inputs)
    if (input.to_panels) input.to_panels();
  int columns = 0, rows = 0;
  glfwGetWindowSize(window_.get(), &columns, &rows);
  if (ui_->set_scale(wanted_scale(rows)))
    ImGui_ImplOpenGL3_DestroyFontsTexture(), ImGui_ImplOpenGL3_CreateFontsTexture();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  if (options_.hidden) ImGui::GetIO().DeltaTime = static_cast<float>(kFrame);
  if (&theme_in_use() != client_.theme) use_theme(*client_.theme, ui_->scale());
  ImGui::NewFrame();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout = make_layout(client_, size.x, size.y, ui_->scale());
  client_.camera.set_viewport(layout.scene.width, layout.scene.height);
  client_.scene_corner = {layout.scene.x, layout.scene.y};
  for (const InputEvent& input : inputs)
    if (input.to_client) input.to_client();
  if (Status status = script_.run(client_); !status) return status;
  if (filming_) {
    if (Status status = film_one(); !status) client_.complain(status.error());
  } else {
    pass_time();
  }
  client_.keep_view();
  client_.quality.now = quality_of_frame();
  const bool points = is_over_scene(mouse_x_, mouse_y_) && drag_.button < 0;
  client_.pointer = points ? std::optional(on_scene(mouse_x_, mouse_y_)) : std::nullopt;
  build_scene(client_, ui_->scale(), scene_);
  ui_->set_mouse(on_scene(mouse_x_, mouse_y_), points);
  ui_->draw(client_, scene_);
  ImGui::Render();
  if (ui_->thumbnails().advance(renderer_, *client_.theme, ui_->scale(), options_.hidden)) frames_due_ = kSettling;
  render(scene_);
  ++frame_;
  frames_due_ = std::max(frames_due_ - 1, 0);
  messages_drawn_ = client_.messages().size();
  last_drawn_ = start;
  if (Status status = take_pictures(); !status) return status;
  if (!target_) glfwSwapBuffers(window_.get());
  client_.frame_times.push_back(static_cast<float>(glfwGetTime() - start));
  watch_frame(start);
  if (client_.frame_times.size() > 240) client_.frame_times.pop_front();
  if (state_.is_open()) state_ << state_line(client_, frame_) << std::endl;
  return {};
}

Quality App::quality_of_frame() const {
  if (draws_every_frame() || !client_.pictures.empty() || filming_) return Quality::high;
  if (is_at_rest()) return Quality::high;
  return client_.quality.by_hand.value_or(picker_.now());
}

/// Takes the time of a frame, from the end of the one before, for the quality of the next.
void App::watch_frame(double drawn_at) {
  constexpr double kIdle = 0.5;  // frames after which nothing is known of the next [s]
  const double now = glfwGetTime(), worked = now - last_end_ - waited_;
  const bool is_usual = client_.quality.now == picker_.now() && now - last_end_ < kIdle;
  if (is_usual && !draws_every_frame()) picker_.add(std::max(worked, now - drawn_at));
  last_end_ = now;
  waited_ = 0;
}

double App::frame_time() {
  if (options_.hidden) return kFrame;
  const double now = glfwGetTime();
  const double passed = std::min(now - last_time_, kLongestFrame);
  last_time_ = now;
  return passed;
}

bool App::is_last_frame() const {
  if (options_.frames > 0) return frame_ >= static_cast<std::uint64_t>(options_.frames);
  const bool ends_alone = options_.hidden || !options_.screenshot.empty();
  return ends_alone && frame_ >= static_cast<std::uint64_t>(script_.frames());
}

void App::render(const Scene& scene) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  if (options_.hidden && !target_) target_.emplace(width, height);
  if (target_) target_->bind();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const double part = size.x > 0 ? width / static_cast<double>(size.x) : 1;  // pixels of the screen for one of ours
  const Box& box = ui_->layout().scene;
  const auto pixels = [part](float x) { return static_cast<int>(std::lround(x * part)); };
  const Viewport viewport{pixels(box.x), height - pixels(box.y + box.height), pixels(box.width), pixels(box.height)};
  const ImVec4 bar = exact_tint(client_.theme->bar);
  glClearColor(bar.x, bar.y, bar.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  renderer_.draw(scene, client_.camera, viewport);
  glViewport(0, 0, width, height);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

// --------------------------------------------------------------------------------------------------------------- input
namespace {

App& app_of(GLFWwindow* window) { return *static_cast<App*>(glfwGetWindowUserPointer(window)); }

InputEvent::Kind kind_of(int action) {
  return action == GLFW_PRESS     ? InputEvent::Kind::press
         : action == GLFW_RELEASE ? InputEvent::Kind::release
                                  : InputEvent::Kind::repeat;
}

}  // namespace

void App::install_callbacks() {
  GLFWwindow* window = window_.get();
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    app_of(w).has_changed();
    const bool is_plain = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) == 0;
    app_of(w).inputs_.push({.kind = kind_of(action),
                            .code = key,
                            .writes = is_plain && key > GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE,
                            .modifies = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER,
                            .to_panels = [=] { app_of(w).on_panel_key(key, scancode, action, mods); },
                            .to_client = [=] { app_of(w).on_key(key, scancode, action, mods); }});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned letter) {
    app_of(w).has_changed();
    app_of(w).inputs_.push(
        {.kind = InputEvent::Kind::text, .to_panels = [=] { ImGui_ImplGlfw_CharCallback(w, letter); }});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    app_of(w).has_changed();
    if (count > 0) run_action(app_of(w).client_, *find_action("open"), paths[0]);
  });
}

/// After each of them the window looks different.
void App::install_window_callbacks() {
  GLFWwindow* window = window_.get();
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int is_focused) {
    app_of(w).has_changed();
    ImGui_ImplGlfw_WindowFocusCallback(w, is_focused);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int has_entered) {
    app_of(w).has_changed();
    ImGui_ImplGlfw_CursorEnterCallback(w, has_entered);
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { app_of(w).has_changed(); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { app_of(w).has_changed(); });
  glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { app_of(w).has_changed(); });
}

void App::install_mouse_callbacks() {
  GLFWwindow* window = window_.get();
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
    double x = 0, y = 0;
    glfwGetCursorPos(w, &x, &y);
    app_of(w).has_changed();
    app_of(w).inputs_.push({.kind = InputEvent::Kind::button,
                            .code = button,
                            .to_panels = [=] { ImGui_ImplGlfw_MouseButtonCallback(w, button, action, mods); },
                            .to_client = [=] { app_of(w).on_button(button, action, x, y); }});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    app_of(w).has_changed();
    app_of(w).inputs_.push({.to_panels = {}, .to_client = [=] { app_of(w).on_move(x, y); }});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    App& app = app_of(w);
    app.has_changed();
    app.inputs_.push({.to_panels = [=] { ImGui_ImplGlfw_ScrollCallback(w, x, y); },
                      .to_client =
                          [=, &app] {
                            if (!app.is_over_scene(app.mouse_x_, app.mouse_y_)) return;
                            app.client_.camera.zoom(std::pow(0.88, y));
                            app.client_.has_moved_view();
                          }});
  });
}

/// Tab selects a projectile, but for where the keys belong to the panels or to a field.
void App::on_panel_key(int code, int scancode, int action, int mods) {
  const bool enters_panels = client_.show.panel_keys || ImGui::GetIO().WantTextInput || action == GLFW_RELEASE;
  if (code == GLFW_KEY_TAB && !enters_panels) return;
  ImGui_ImplGlfw_KeyCallback(window_.get(), code, scancode, action, mods);
}

void App::on_key(int code, int scancode, int action, int mods) {
  static const std::set<std::string> kOfPanels = {"Left", "Right", "Up",   "Down",   "Space",
                                                  "Tab",  "Enter", "Home", "PageUp", "PageDown"};
  const bool leaves_dialog = client_.dialog != Dialog::none && code == GLFW_KEY_ESCAPE && !client_.question;
  if (action == GLFW_PRESS && leaves_dialog) return void(ui_->close_something(client_));
  if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
  const auto key = key_name(code, scancode);
  if (!key || (client_.show.panel_keys && kOfPanels.count(*key) != 0)) return;
  if (filming_) return void(client_.stops_film |= *key == "Esc");
  if (client_.question) {
    if (*key == "Esc" || *key == "Enter") answer(client_, *key == "Enter" ? Answer::yes : Answer::no);
    return;
  }
  if (client_.dialog != Dialog::none) return;  // nothing goes on behind it
  if (*key == "Esc" && ui_->close_something(client_)) return;
  const bool has_ctrl = (mods & GLFW_MOD_CONTROL) != 0, has_shift = (mods & GLFW_MOD_SHIFT) != 0;
  const Action* meant = has_shift ? action_of_key("Shift+" + *key, has_ctrl) : nullptr;
  if (meant == nullptr && !(has_ctrl && has_shift)) meant = action_of_key(*key, has_ctrl);
  if (meant == nullptr) return;
  const bool repeats = meant->menu == "View" || meant->name.starts_with("turn") || meant->name == "step" ||
                       meant->name == "back" || meant->name.starts_with("leap");
  if (action == GLFW_PRESS || repeats) run_action(client_, *meant);
}

Pixel App::on_scene(double x, double y) const { return {x - ui_->layout().scene.x, y - ui_->layout().scene.y}; }

bool App::is_over_scene(double x, double y) const {
  const Pixel p = on_scene(x, y);
  const Box& s = ui_->layout().scene;
  return p.x >= 0 && p.y >= 0 && p.x < s.width && p.y < s.height && !ImGui::GetIO().WantCaptureMouse;
}

void App::on_button(int button, int action, double x, double y) {
  mouse_x_ = x, mouse_y_ = y;
  if (filming_) return;
  if (action == GLFW_PRESS) {
    if (drag_.button < 0 && is_over_scene(x, y)) drag_ = {button, x, y, 0};
    return;
  }
  if (button != drag_.button) return;
  const bool is_click = drag_.moved <= kClickReach * ui_->scale();
  drag_ = {};
  if (!is_click) return;
  if (button == GLFW_MOUSE_BUTTON_LEFT) client_.click(on_scene(x, y));
  if (button == GLFW_MOUSE_BUTTON_RIGHT) ui_->open_menu();
}

void App::on_move(double x, double y) {
  const double dx = x - mouse_x_, dy = y - mouse_y_;
  mouse_x_ = x, mouse_y_ = y;
  if (drag_.button < 0) return;
  drag_.moved = std::max(drag_.moved, std::hypot(x - drag_.x, y - drag_.y));
  if (drag_.moved <= kClickReach * ui_->scale()) return;
  const double turn = kTurnPerPixel / ui_->scale();
  if (drag_.button != GLFW_MOUSE_BUTTON_LEFT) client_.has_moved_view();
  if (drag_.button == GLFW_MOUSE_BUTTON_MIDDLE)
    client_.camera.pan(dx, -dy);
  else if (drag_.button == GLFW_MOUSE_BUTTON_RIGHT)
    client_.camera.orbit(dx * turn, dy * turn);
  else
    client_.launcher.turn(dx * turn / 4, -dy * turn / 4);
}

}  // namespace physim::client
