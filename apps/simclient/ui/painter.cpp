#include "simclient/ui/painter.hpp"

#include <backends/imgui_impl_opengl3.h>

#include "base/assert.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

ImTextureID texture_id(GLuint texture) { return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)); }

Painter::~Painter() { forget_fonts(); }

void Painter::forget_fonts() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
  texture_ = 0;
  atlas_.Clear();
}

void Painter::make_fonts(float scale) {
  if (scale_ == scale) return;
  forget_fonts();
  scale_ = scale;
  fonts_[0] = load_font(atlas_, 15 * scale);
  fonts_[1] = load_font(atlas_, 22 * scale);
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas_.GetTexDataAsRGBA32(&pixels, &width, &height);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  atlas_.SetTexID(texture_id(texture_));
}

ImDrawList& Painter::begin(int width, int height, float scale) {
  make_fonts(scale);
  width_ = static_cast<float>(width), height_ = static_cast<float>(height);
  shared_.TexUvWhitePixel = atlas_.TexUvWhitePixel;
  shared_.TexUvLines = atlas_.TexUvLines;
  shared_.Font = fonts_[0];
  shared_.FontSize = fonts_[0]->FontSize;
  shared_.ClipRectFullscreen = {0, 0, width_, height_};
  shared_.InitialFlags = ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedFill;
  shared_.SetCircleTessellationMaxError(0.3F);
  list_._ResetForNewFrame();
  list_.PushTextureID(atlas_.TexID);
  list_.PushClipRectFullScreen();
  return list_;
}

void Painter::end() {
  list_._PopUnusedDrawCmd();
  ImDrawList* lists[] = {&list_};
  ImDrawData data;
  data.Valid = true;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.TotalIdxCount = list_.IdxBuffer.Size;
  data.TotalVtxCount = list_.VtxBuffer.Size;
  data.DisplaySize = {width_, height_};
  data.FramebufferScale = {1, 1};
  ImGui_ImplOpenGL3_RenderDrawData(&data);
}

float Painter::width_of(const std::string& text, Face face) const {
  return font(face).CalcTextSizeA(font(face).FontSize, FLT_MAX, 0, text.c_str()).x;
}

std::string Painter::fitting(const std::string& text, float room, Face face) const {
  std::string part = text;
  for (std::size_t end = text.size(); width_of(part, face) > room && end > 0;) {
    end = text.rfind(' ', end - 1);
    if (end == text.npos) break;
    part = text.substr(0, end) + " ...";
  }
  return part;
}

void Painter::write(float x, float y, const std::string& text, ImU32 colour, Face face) {
  PHYSIM_ASSERT(texture_ != 0);
  const float pad = 2 * scale_;
  list_.AddRectFilled({x - pad, y}, {x + width_of(text, face) + pad, y + line(face)}, exact(theme_in_use().label));
  list_.AddText(&font(face), font(face).FontSize, {x, y}, colour, text.c_str());
}

}  // namespace physim::client
