// One line of documentation for every rung of every effect, by the names that the library gives them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace physim::cli {

struct RungDoc {
  std::string_view effect;
  std::string_view rung;
  std::string_view doc;
};

/// Every rung of every effect, cheap to true; those that have no text here say so.
[[nodiscard]] std::span<const RungDoc> rung_docs();

}  // namespace physim::cli
