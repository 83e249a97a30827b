#include "simclient/gl/window.hpp"

#include <cctype>

namespace physim::client {
namespace {

std::string last_problem;  // that GLFW told

void remember_problem(int, const char* text) { last_problem = text; }

}  // namespace

void CloseWindow::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
  glfwTerminate();
}

Result<Window> open_window(int width, int height, bool hidden) {
  glfwSetErrorCallback(remember_problem);
  if (glfwInit() != GLFW_TRUE)
    return Error{"there is no display: " + last_problem, "simclient",
                 "set DISPLAY, or run it under xvfb-run -a where there is no screen"};
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_VISIBLE, hidden ? GLFW_FALSE : GLFW_TRUE);
  Window window(glfwCreateWindow(width, height, "PhySim SimClient", nullptr, nullptr));
  if (!window) {
    glfwTerminate();
    return Error{"no window with OpenGL 3.3: " + last_problem, "simclient",
                 "software OpenGL comes with the package libgl1-mesa-dri"};
  }
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(hidden ? 0 : 1);
  return window;
}

std::optional<std::string> key_name(int key, int scancode) {
  // Letters and signs are those of the keyboard's layout.
  if (const char* name = glfwGetKeyName(key, scancode); name != nullptr && name[0] != '\0' && name[1] == '\0')
    return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  switch (key) {
    case GLFW_KEY_SPACE: return "Space";
    case GLFW_KEY_ESCAPE: return "Esc";
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return "Enter";
    case GLFW_KEY_TAB: return "Tab";
    case GLFW_KEY_LEFT: return "Left";
    case GLFW_KEY_RIGHT: return "Right";
    case GLFW_KEY_UP: return "Up";
    case GLFW_KEY_DOWN: return "Down";
    case GLFW_KEY_HOME: return "Home";
    case GLFW_KEY_PAGE_UP: return "PageUp";
    case GLFW_KEY_PAGE_DOWN: return "PageDown";
    default: return std::nullopt;
  }
}

}  // namespace physim::client
