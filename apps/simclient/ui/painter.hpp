// Painter: boxes and letters over a picture that is no window, as large as its pixels ask for.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <epoxy/gl.h>

#include <string>

namespace physim::client {

/// A texture as Dear ImGui names it.
[[nodiscard]] ImTextureID texture_id(GLuint texture);

class Painter {
 public:
  enum class Face { text, title };

  Painter() = default;
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  /// While the context of OpenGL is there.
  ~Painter();

  /// For a picture of this size, with letters of a scale: what is drawn into the list comes into the picture.
  ImDrawList& begin(int width, int height, float scale);
  /// Draws it into the framebuffer in use.
  void end();

  /// How wide a text is, and how high a line [pixels].
  [[nodiscard]] float width_of(const std::string& text, Face face = Face::text) const;
  /// As much of a text as has room, up to a word, with dots.
  [[nodiscard]] std::string fitting(const std::string& text, float room, Face face) const;
  [[nodiscard]] float line(Face face = Face::text) const { return font(face).FontSize; }
  /// Letters on a box of the theme, with their upper left corner there.
  void write(float x, float y, const std::string& text, ImU32 colour, Face face = Face::text);

 private:
  void make_fonts(float scale);
  void forget_fonts();
  [[nodiscard]] const ImFont& font(Face face) const { return *fonts_[static_cast<int>(face)]; }

  ImFontAtlas atlas_;
  ImFont* fonts_[2] = {};
  GLuint texture_ = 0;
  float scale_ = 0, width_ = 0, height_ = 0;
  ImDrawListSharedData shared_;
  ImDrawList list_{&shared_};
};

}  // namespace physim::client
