// Numbers as people read them in messages, and text with numbers in it.
#pragma once

#include <string>

#include "physim/result.hpp"

namespace physim {

/// At most six digits, for messages: "1000", "0.3", "1e+09", "nan".
[[nodiscard]] std::string short_text(double x);

/// Two digits, for figures that need no more: "0.0042", "38", "1.2e+04".
[[nodiscard]] std::string rounded_text(double x);
/// A length to two digits, in the unit that suits it: "4.2 mm", "1 cm", "120 um"; x in m.
[[nodiscard]] std::string length_text(double x);

/// An error within a sentence: "place: message; hint".
[[nodiscard]] std::string within_sentence(const Error& error);

/// Puts a text in the place of each that stands in another.
void replace_all(std::string& text, const std::string& from, const std::string& to);

/// As printf() would write it.
[[nodiscard]] [[gnu::format(printf, 1, 2)]] std::string formatted(const char* pattern, ...);

}  // namespace physim
