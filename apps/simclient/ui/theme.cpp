// Colours, fonts and boxes of the user interface.
#include <algorithm>
#include <filesystem>

#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"};

const Theme* in_use = &themes()[0];

}  // namespace

ImFont* load_font(ImFontAtlas& atlas, float size) {
  static constexpr ImWchar kRanges[] = {0x20, 0xFF, 0x370, 0x3FF, 0x2010, 0x2027, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};
  for (const char* path : kFonts)
    if (std::filesystem::exists(path))
      if (ImFont* font = atlas.AddFontFromFileTTF(path, size, nullptr, kRanges)) return font;
  ImFontConfig config;
  config.SizePixels = size;
  return atlas.AddFontDefault(&config);
}

void load_fonts(float scale) { load_font(*ImGui::GetIO().Fonts, 15 * scale); }

const Theme& theme_in_use() { return *in_use; }

ImU32 exact(Colour colour) { return IM_COL32(colour >> 24, (colour >> 16) & 255, (colour >> 8) & 255, colour & 255); }

ImVec4 exact_tint(Colour colour) { return ImGui::ColorConvertU32ToFloat4(exact(colour)); }

ImU32 shade(Colour colour) { return exact(letters(*in_use, colour)); }

ImVec4 tint(Colour colour) { return exact_tint(letters(*in_use, colour)); }

void use_theme(const Theme& theme, float scale) {
  in_use = &theme;
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  if (theme.is_light)
    ImGui::StyleColorsLight();
  else
    ImGui::StyleColorsDark();
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowBorderSize = 0;
  style.WindowPadding = {8, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {6, 4};
  style.CellPadding = {4, 2};
  const Colour faint = theme.is_light ? 0x00000008 : 0xFFFFFF08;
  const std::pair<int, Colour> colours[] = {{ImGuiCol_WindowBg, theme.panel},
                                            {ImGuiCol_PopupBg, theme.popup},
                                            {ImGuiCol_MenuBarBg, theme.bar},
                                            {ImGuiCol_Text, letters(theme, colours::kText)},
                                            {ImGuiCol_TextDisabled, letters(theme, colours::kDim)},
                                            {ImGuiCol_FrameBg, theme.field},
                                            {ImGuiCol_FrameBgHovered, theme.hovered},
                                            {ImGuiCol_FrameBgActive, theme.active},
                                            {ImGuiCol_Button, theme.button},
                                            {ImGuiCol_ButtonHovered, theme.hovered},
                                            {ImGuiCol_ButtonActive, theme.active},
                                            {ImGuiCol_Header, theme.field},
                                            {ImGuiCol_HeaderHovered, theme.hovered},
                                            {ImGuiCol_HeaderActive, theme.hovered},
                                            {ImGuiCol_TitleBg, theme.bar},
                                            {ImGuiCol_TitleBgActive, theme.bar},
                                            {ImGuiCol_CheckMark, theme.accent},
                                            {ImGuiCol_SliderGrab, grab(theme)},
                                            {ImGuiCol_SliderGrabActive, grab(theme)},
                                            {ImGuiCol_PlotHistogram, grab(theme)},
                                            {ImGuiCol_TextSelectedBg, selected_letters(theme)},
                                            {ImGuiCol_TableHeaderBg, theme.bar},
                                            {ImGuiCol_NavHighlight, letters(theme, colours::kWarning)},
                                            {ImGuiCol_Separator, theme.separator},
                                            {ImGuiCol_TableRowBgAlt, faint},
                                            {ImGuiCol_Tab, theme.field},
                                            {ImGuiCol_TabHovered, theme.hovered},
                                            {ImGuiCol_TabActive, theme.active}};
  for (const auto& [slot, colour] : colours) style.Colors[slot] = exact_tint(colour);
  style.ScaleAllSizes(scale);
}

bool begin_panel(const char* title, const Box& box, bool has_title) {
  ImGui::SetNextWindowPos({box.x, box.y});
  ImGui::SetNextWindowSize({box.width, box.height});
  return ImGui::Begin(title, nullptr,
                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                          (has_title ? 0 : ImGuiWindowFlags_NoTitleBar));
}

void centre_window(const Box& box, float width, float height) {
  ImGui::SetNextWindowPos({box.x + box.width / 2, box.y + box.height / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(width, box.width), std::min(height, box.height)});
}

void headings(std::initializer_list<const char*> titles) {
  for (const char* title : titles) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
}

void end_panel() { ImGui::End(); }

void go_beside(const char* label, float more) {
  ImGui::SameLine();
  const float wide = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x + more;
  if (ImGui::GetContentRegionAvail().x < wide) ImGui::NewLine();
}

void coloured_text(Colour colour, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, tint(colour));
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace physim::client
