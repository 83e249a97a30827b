// Runs SimClient on a screen of its own (Xvfb), with real keyboard and mouse events (XTest).
#pragma once

#include <gtest/gtest.h>  // before X11, which has macros of the names in it

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "cli/program.hpp"

namespace physim::testing_window {

using Json = nlohmann::json;
using testing_cli::Folder;

inline void nap(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

/// Starts a program; its id.
inline pid_t start(const std::vector<std::string>& words, const std::vector<std::string>& more_environment,
                   int inherited = -1, const std::string& err = "/dev/null") {
  std::vector<std::string> variables;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string variable = *each;
    if (!variable.starts_with("DISPLAY=") && !variable.starts_with("XDG_STATE_HOME=")) variables.push_back(variable);
  }
  variables.insert(variables.end(), more_environment.begin(), more_environment.end());
  std::vector<char*> argv, envp;
  std::vector<std::string> copy = words;
  for (std::string& word : copy) argv.push_back(word.data());
  for (std::string& variable : variables) envp.push_back(variable.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  if (inherited >= 0) posix_spawn_file_actions_adddup2(&actions, inherited, 3);
  pid_t child = -1;
  if (posix_spawnp(&child, copy[0].c_str(), &actions, nullptr, argv.data(), envp.data()) != 0) child = -1;
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

/// A screen in memory, for as long as this lives.
class Screen {
 public:
  Screen() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    server_ = start({"Xvfb", "-displayfd", "3", "-screen", "0", "2600x1500x24", "-nolisten", "tcp"}, {}, ends[1]);
    close(ends[1]);
    char text[16] = "";
    std::size_t size = 0;
    while (server_ > 0 && size + 1 < sizeof text && read(ends[0], text + size, 1) == 1 && text[size] != '\n') ++size;
    close(ends[0]);
    name_ = size > 0 ? ":" + std::string(text, size) : "";
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });  // a window may close while it is asked for something
    if (!name_.empty()) display_ = XOpenDisplay(name_.c_str());
  }
  ~Screen() {
    if (display_ != nullptr) XCloseDisplay(display_);
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  [[nodiscard]] Display* display() const { return display_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  pid_t server_ = -1;
  std::string name_;
  Display* display_ = nullptr;
};

/// What a window shows, a pixel each: 0xRRGGBB.
struct Shot {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
  [[nodiscard]] std::uint32_t at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// The client in its window: on the open range where no scenario is named.
class RunningClient {
 public:
  static constexpr const char* kWithGallery = "with the gallery";  // among the arguments: as people start it

  RunningClient(const Screen& screen, std::vector<std::string> arguments) : screen_(screen.display()) {
    std::vector<std::string> words = {PHYSIM_SIMCLIENT, "--state", folder_ / "state"};
    if (std::erase(arguments, kWithGallery) == 0) words.emplace_back("--range");
    words.insert(words.end(), arguments.begin(), arguments.end());
    process_ = start(words,
                     {"DISPLAY=" + screen.name(), "XDG_STATE_HOME=" + (folder_ / "state_home"),
                      "LIBGL_ALWAYS_SOFTWARE=1", "LP_NUM_THREADS=2", "ASAN_OPTIONS=detect_leaks=0"},
                     -1, folder_ / "err");
    for (int i = 0; i < 600 && window_ == 0 && is_running(); ++i, nap(50)) window_ = find(DefaultRootWindow(screen_));
    wait_for([](const Json&) { return true; });
    focus();
  }
  ~RunningClient() {
    if (!exit_code_ && process_ > 0) kill(process_, SIGKILL), waitpid(process_, nullptr, 0);
  }
  RunningClient(const RunningClient&) = delete;
  RunningClient& operator=(const RunningClient&) = delete;

  [[nodiscard]] bool has_window() const { return window_ != 0; }

  /// Presses and releases a key: "e", "E" (with Shift), "space", "Escape".
  void key(const std::string& name) {
    const bool upper = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z';
    const KeySym symbol =
        XStringToKeysym(upper ? std::string(1, static_cast<char>(name[0] + 32)).c_str() : name.c_str());
    const KeyCode code = XKeysymToKeycode(screen_, symbol), shift = XKeysymToKeycode(screen_, XK_Shift_L);
    if (upper) XTestFakeKeyEvent(screen_, shift, True, 0);
    XTestFakeKeyEvent(screen_, code, True, 0);
    XTestFakeKeyEvent(screen_, code, False, 0);
    if (upper) XTestFakeKeyEvent(screen_, shift, False, 0);
    XSync(screen_, False);
    next_frames();
  }
  /// Presses keys much faster than the client looks; not two in a millisecond, which GLFW takes for one.
  void keys_at_once(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const auto [code, shifted] = key_of(name);
      const KeyCode shift = XKeysymToKeycode(screen_, XK_Shift_L);
      if (shifted) XTestFakeKeyEvent(screen_, shift, True, 0);
      XTestFakeKeyEvent(screen_, code, True, 0);
      XTestFakeKeyEvent(screen_, code, False, 0);
      if (shifted) XTestFakeKeyEvent(screen_, shift, False, 0);
      XSync(screen_, False);
      nap(2);
    }
    next_frames();
  }
  /// Holds some keys together: {"Control_L", "o"}.
  void chord(const std::vector<std::string>& names) {
    for (const std::string& name : names) XTestFakeKeyEvent(screen_, key_of(name).first, True, 0);
    for (auto name = names.rbegin(); name != names.rend(); ++name)
      XTestFakeKeyEvent(screen_, key_of(*name).first, False, 0);
    XSync(screen_, False);
    next_frames();
  }
  /// Holds a key for some frames, as hands do.
  void hold(const std::string& name) {
    const KeyCode code = XKeysymToKeycode(screen_, XStringToKeysym(name.c_str()));
    for (const Bool down : {True, False}) {
      XTestFakeKeyEvent(screen_, code, down, 0);
      XSync(screen_, False);
      next_frames();
    }
  }
  void move(int x, int y) {
    Window child = 0;
    int root_x = 0, root_y = 0;
    XTranslateCoordinates(screen_, window_, DefaultRootWindow(screen_), x, y, &root_x, &root_y, &child);
    XTestFakeMotionEvent(screen_, -1, root_x, root_y, 0);
    XSync(screen_, False);
    next_frames();
  }
  void click(int x, int y, unsigned button = 1) {
    move(x, y);
    XTestFakeButtonEvent(screen_, button, True, 0);
    XTestFakeButtonEvent(screen_, button, False, 0);
    XSync(screen_, False);
    next_frames();
  }
  void drag(int x, int y, int to_x, int to_y, unsigned button) {
    move(x, y);
    XTestFakeButtonEvent(screen_, button, True, 0);
    for (int i = 1; i <= 4; ++i) move(x + (to_x - x) * i / 4, y + (to_y - y) * i / 4);
    XTestFakeButtonEvent(screen_, button, False, 0);
    XSync(screen_, False);
    next_frames();
  }
  /// The button of the window's frame.
  void close_window() {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_;
    event.xclient.message_type = XInternAtom(screen_, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(screen_, "WM_DELETE_WINDOW", False));
    XSendEvent(screen_, window_, False, NoEventMask, &event);
    XSync(screen_, False);
  }

  /// The last whole line of the state.
  [[nodiscard]] Json state() const {
    std::ifstream file(folder_ / "state", std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(file.tellg());
    const std::streamoff part = std::min<std::streamoff>(size, 1 << 16);
    if (!file || part <= 0) return {};
    std::string text(static_cast<std::size_t>(part), '\0');
    file.seekg(size - part);
    file.read(text.data(), part);
    const std::size_t end = text.rfind('\n');
    if (end == std::string::npos) return {};
    const std::size_t begin = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    return Json::parse(text.substr(begin + 1, end - begin - 1), nullptr, false);
  }
  /// Waits until a state is as wanted, for at most 30 s; the state, or the last one.
  Json wait_for(const std::function<bool(const Json&)>& wanted) {
    Json now;
    for (int i = 0; i < 3000 && is_running(); ++i, nap(10)) {
      now = state();
      if (now.is_object() && wanted(now)) return now;
    }
    return now;
  }
  /// Two frames more: what was sent before has been seen, and shown. A client at rest draws none by itself: its window
  /// is uncovered, as when another one is taken away.
  Json next_frames() {
    const Json now = state();
    const std::uint64_t frame = now.is_object() ? now["frame"].get<std::uint64_t>() : 0;
    return wait_for([this, frame](const Json& s) {
      if (s["frame"].get<std::uint64_t>() > frame + 2) return true;
      uncover();
      return false;
    });
  }
  void uncover() {
    XClearArea(screen_, window_, 0, 0, 1, 1, True);
    XSync(screen_, False);
  }
  /// Says that the window is an icon, or is shown again, as window managers do.
  void iconify(bool is_icon) {
    const Atom atom = XInternAtom(screen_, "WM_STATE", False);
    const long state[2] = {is_icon ? IconicState : NormalState, None};
    XChangeProperty(screen_, window_, atom, atom, 32, PropModeReplace, reinterpret_cast<const unsigned char*>(state),
                    2);
    XSync(screen_, False);
  }
  /// The number of the last frame, once none has come for a while; nothing where they come and come.
  std::optional<std::uint64_t> frame_at_rest(int milliseconds) {
    for (int i = 0; i < 10 && is_running(); ++i) {
      const Json before = state();
      nap(milliseconds);
      if (state()["frame"] == before["frame"]) return before["frame"].get<std::uint64_t>();
    }
    return std::nullopt;
  }

  [[nodiscard]] Shot picture() const {
    XWindowAttributes a;
    XGetWindowAttributes(screen_, window_, &a);
    XImage* image = XGetImage(screen_, window_, 0, 0, static_cast<unsigned>(a.width), static_cast<unsigned>(a.height),
                              AllPlanes, ZPixmap);
    Shot shot{a.width, a.height, {}};
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x)
        shot.pixels.push_back(static_cast<std::uint32_t>(XGetPixel(image, x, y)) & 0xFFFFFF);
    XDestroyImage(image);
    return shot;
  }
  void resize(int width, int height) {
    XResizeWindow(screen_, window_, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XSync(screen_, False);
    next_frames();
  }

  bool is_running() {
    int status = 0;
    if (exit_code_ || process_ <= 0) return false;
    if (waitpid(process_, &status, WNOHANG) == process_) exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return !exit_code_;
  }
  /// Its exit code; nothing where it is still there after 20 s.
  std::optional<int> exit_code() {
    for (int i = 0; i < 400 && is_running(); ++i) nap(50);
    return exit_code_;
  }
  [[nodiscard]] std::string errors() const { return testing_cli::read(folder_ / "err"); }

 private:
  /// The key of a name, "a" or "BackSpace", or of a sign; and whether Shift goes with it.
  [[nodiscard]] std::pair<KeyCode, bool> key_of(const std::string& name) const {
    KeySym symbol = XStringToKeysym(name.c_str());
    if (symbol == NoSymbol && name.size() == 1) symbol = static_cast<KeySym>(static_cast<unsigned char>(name[0]));
    const KeyCode code = XKeysymToKeycode(screen_, symbol);
    return {code, XkbKeycodeToKeysym(screen_, code, 0, 0) != symbol};
  }
  Window find(Window parent) const {
    Window root = 0, up = 0, *children = nullptr;
    unsigned count = 0;
    Window found = 0;
    if (XQueryTree(screen_, parent, &root, &up, &children, &count) == 0) return 0;
    for (unsigned i = 0; i < count && found == 0; ++i) {
      char* name = nullptr;
      if (XFetchName(screen_, children[i], &name) != 0 && name != nullptr) {
        if (std::string(name) == "PhySim SimClient") found = children[i];
        XFree(name);
      }
    }
    if (children != nullptr) XFree(children);
    return found;
  }
  void focus() {
    if (window_ == 0) return;
    XSetInputFocus(screen_, window_, RevertToParent, CurrentTime);
    XSync(screen_, False);
    nap(50);
  }

  Folder folder_;
  Display* screen_;
  Window window_ = 0;
  pid_t process_ = -1;
  std::optional<int> exit_code_;
};

}  // namespace physim::testing_window
