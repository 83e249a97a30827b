// Emphasis in texts for people: colours where they were asked for, plain text else.
#pragma once

#include <string>
#include <string_view>

namespace physim::report {

class Style {
 public:
  explicit Style(bool has_colours = false) : has_colours_(has_colours) {}

  [[nodiscard]] std::string bold(std::string_view text) const { return wrap("1", text); }
  [[nodiscard]] std::string dim(std::string_view text) const { return wrap("2", text); }
  [[nodiscard]] std::string good(std::string_view text) const { return wrap("32", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return wrap("1;31", text); }
  [[nodiscard]] std::string warn(std::string_view text) const { return wrap("33", text); }

 private:
  [[nodiscard]] std::string wrap(const char* code, std::string_view text) const {
    if (!has_colours_) return std::string(text);
    return std::string("\033[") + code + "m" + std::string(text) + "\033[0m";
  }
  bool has_colours_;
};

}  // namespace physim::report
