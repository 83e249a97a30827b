// Window: GLFW's window with an OpenGL 3.3 context, and what its keys are called.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <epoxy/gl.h>
// GLFW must come after the OpenGL loader.
#include <GLFW/glfw3.h>

#include "physim/result.hpp"

namespace physim::client {

/// There is one window, and GLFW lives as long as it does.
struct CloseWindow {
  void operator()(GLFWwindow* window) const;
};
using Window = std::unique_ptr<GLFWwindow, CloseWindow>;

[[nodiscard]] Result<Window> open_window(int width, int height, bool hidden);

/// The name of a key as the table of actions writes it: "E", "Space", "F5"; nothing for others.
[[nodiscard]] std::optional<std::string> key_name(int key, int scancode);

}  // namespace physim::client
