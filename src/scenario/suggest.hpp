// Suggestions for misspelt words in error messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace physim {

/// Edits that turn one word into another: insert, delete, replace, swap neighbours (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a word, case ignored: within a few edits, or one that the word begins or abbreviates; empty
/// where none is near.
[[nodiscard]] std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// `did you mean "mass"?`, or else the candidates themselves: `known keys: mass, length`.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string_view> candidates,
                                     std::string_view what_they_are);

/// A text in quotes as messages show it; long texts are shortened, control characters hidden.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace physim
