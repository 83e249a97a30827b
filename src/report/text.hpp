// Texts that are handed over piece by piece, so that those of many shots are never whole in memory.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace physim::report {

/// Takes the next piece of a text.
using Sink = std::function<void(std::string_view piece)>;
/// Writes itself into a sink, the same each time. It may read what it was made from: that must still be there.
using Text = std::function<void(const Sink& sink)>;

/// All pieces of a text, of which it is known that there are few.
[[nodiscard]] inline std::string whole(const Text& text) {
  std::string out;
  text([&out](std::string_view piece) { out += piece; });
  return out;
}

/// A text that is whole already.
[[nodiscard]] inline Text as_text(std::string content) {
  return [content = std::move(content)](const Sink& sink) { sink(content); };
}

}  // namespace physim::report
