// Target: a framebuffer of its own, for windows that are hidden and pictures of any size. Pictures: PNG files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "physim/result.hpp"

namespace physim::client {

class Target {
 public:
  Target(int width, int height);
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target();
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

 private:
  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

/// Red, green, blue; the top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The pixels of the framebuffer in use, from its lower left corner.
[[nodiscard]] Picture read_picture(int x, int y, int width, int height);
/// The content of a PNG file; empty if there is not enough memory.
[[nodiscard]] std::string png_of(const Picture& picture);

}  // namespace physim::client
