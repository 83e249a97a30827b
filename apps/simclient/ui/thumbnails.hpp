// Thumbnails: pictures of the gallery's scenarios, drawn by the client itself as they are looked at. Scenarios fly on a
// thread of their own; the window's thread draws one of them in a frame.
#pragma once

#include <epoxy/gl.h>

#include <future>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "simclient/core/gallery.hpp"
#include "simclient/gl/renderer.hpp"

namespace physim::client {

class Thumbnails {
 public:
  static constexpr int kWidth = 224, kHeight = 140;  // at scale 1 [pixels]

  Thumbnails() = default;
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;
  /// While the context of OpenGL is there.
  ~Thumbnails();

  /// The texture of a scenario's picture; 0 while there is none. Those that were asked for in a frame are drawn.
  [[nodiscard]] GLuint of(std::string_view scenario);
  /// Between two frames: draws what has flown, and lets the next one fly. `waits`: until all that were asked for are
  /// there. True if a picture has come. The framebuffer in use is another one then.
  bool advance(Renderer& renderer, const Theme& theme, float scale, bool waits);
  /// A picture is still to come.
  [[nodiscard]] bool is_busy() const { return flying_.valid() || !wanted_.empty(); }

 private:
  void begin_next(float scale);
  void take(Renderer& renderer, const Theme& theme, float scale);

  std::map<std::string, GLuint, std::less<>> textures_;
  std::vector<std::string> wanted_;  // in the order that they were asked for
  std::string name_;                 // of the one that flies
  std::future<Result<Pose>> flying_;
  const Theme* theme_ = nullptr;  // that they are drawn in
};

}  // namespace physim::client
