// Canvas: a framebuffer of several samples for a pixel, so that the edges of things are smooth.
#pragma once

#include <epoxy/gl.h>

namespace physim::client {

class Canvas {
 public:
  static constexpr int kSamples = 4;

  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas();
  /// To be drawn into from now on, of a size [pixels]; false if the machine has no such framebuffer.
  bool bind(int width, int height);
  /// Puts what was drawn into another framebuffer, at its place there, and leaves that one in use.
  void put_into(GLuint framebuffer, int x, int y) const;

 private:
  void clear();

  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace physim::client
