// Colours, fonts and boxes of the user interface.
#include <algorithm>
#include <filesystem>

#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"};

void load_font(float size) {
  static constexpr ImWchar kRanges[] = {0x20, 0xFF, 0x370, 0x3FF, 0x2010, 0x2027, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};
  ImGuiIO& io = ImGui::GetIO();
  for (const char* path : kFonts)
    if (std::filesystem::exists(path) && io.Fonts->AddFontFromFileTTF(path, size, nullptr, kRanges) != nullptr) return;
  ImFontConfig config;
  config.SizePixels = size;
  io.Fonts->AddFontDefault(&config);
}

}  // namespace

ImVec4 tint(Colour colour) { return ImGui::ColorConvertU32ToFloat4(shade(colour)); }

ImU32 shade(Colour colour) { return IM_COL32(colour >> 24, (colour >> 16) & 255, (colour >> 8) & 255, colour & 255); }

void set_theme(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowBorderSize = 0;
  style.WindowPadding = {8, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {6, 4};
  style.CellPadding = {4, 2};
  const std::pair<int, Colour> colours[] = {
      {ImGuiCol_WindowBg, 0x1A1E24FF},        {ImGuiCol_PopupBg, 0x20252DFF},
      {ImGuiCol_MenuBarBg, 0x14171CFF},       {ImGuiCol_Text, colours::kText},
      {ImGuiCol_TextDisabled, colours::kDim}, {ImGuiCol_FrameBg, 0x2A313AFF},
      {ImGuiCol_FrameBgHovered, 0x36404CFF},  {ImGuiCol_FrameBgActive, 0x41505FFF},
      {ImGuiCol_Button, 0x2F3945FF},          {ImGuiCol_ButtonHovered, 0x3D4C5DFF},
      {ImGuiCol_ButtonActive, 0x4B6078FF},    {ImGuiCol_Header, 0x2C3743FF},
      {ImGuiCol_HeaderHovered, 0x3A4A5BFF},   {ImGuiCol_HeaderActive, 0x46596EFF},
      {ImGuiCol_TitleBg, 0x14171CFF},         {ImGuiCol_TitleBgActive, 0x14171CFF},
      {ImGuiCol_CheckMark, 0x56B4E9FF},       {ImGuiCol_SliderGrab, 0x56B4E9FF},
      {ImGuiCol_NavHighlight, 0xE69F00FF},    {ImGuiCol_Separator, 0x38414CFF},
      {ImGuiCol_TableRowBgAlt, 0xFFFFFF08},   {ImGuiCol_Tab, 0x242B33FF},
      {ImGuiCol_TabHovered, 0x3D4C5DFF},      {ImGuiCol_TabActive, 0x35506BFF}};
  for (const auto& [slot, colour] : colours) style.Colors[slot] = tint(colour);
  style.ScaleAllSizes(scale);
  load_font(15 * scale);
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
