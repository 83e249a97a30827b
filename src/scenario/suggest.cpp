#include "scenario/suggest.hpp"

#include <algorithm>
#include <vector>

#include "base/assert.hpp"

namespace physim {
namespace {

constexpr std::size_t kLongestWord = 200;    // a longer one is no misspelling; keeps the quadratic cost small
constexpr std::size_t kLongestQuote = 60;    // [characters]
constexpr std::size_t kMostCandidates = 30;  // a longer list does not help

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// Short words have many neighbours, so they must be nearer.
std::size_t allowed_edits(std::size_t length) { return length < 3 ? 0 : std::min<std::size_t>(length / 3, 4); }

/// The first letters of the words of a key: "bc" of "ballistic_coefficient".
std::string initials(std::string_view key) {
  std::string out;
  for (std::size_t i = 0; i < key.size(); ++i)
    if (i == 0 || key[i - 1] == '_') out += key[i];
  return out;
}

/// Whether a word is the beginning or the abbreviation of a candidate; of paths the last keys count, in one table.
bool is_short_for(std::string_view word, std::string_view candidate) {
  constexpr std::size_t kShortest = 2;
  const std::size_t dot = word.rfind('.'), head = dot == word.npos ? 0 : dot + 1;
  if (candidate.substr(0, head) != word.substr(0, head)) return false;
  PHYSIM_ASSERT(head <= candidate.size());
  const std::string_view key = word.substr(head), whole = candidate.substr(head);
  return key.size() >= kShortest && whole.find('.') == whole.npos && (whole.starts_with(key) || initials(whole) == key);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  PHYSIM_ASSERT(above[b.size()] <= std::max(a.size(), b.size()));
  return above[b.size()];
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.size() > kLongestWord) return {};
  const std::string wanted = lower_case(word);
  std::string_view best, whole;  // whole: the shortest that the word is short for
  std::size_t best_distance = allowed_edits(word.size()) + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > kLongestWord) continue;
    const std::string lower = lower_case(candidate);
    const std::size_t distance = edit_distance(wanted, lower);
    if (distance < best_distance) best = candidate, best_distance = distance;
    if (is_short_for(wanted, lower) && (whole.empty() || candidate.size() < whole.size())) whole = candidate;
  }
  const bool is_slip = !best.empty() && best_distance <= 1;
  return whole.empty() || is_slip ? best : whole;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates,
                       std::string_view what_they_are) {
  if (const std::string_view near = nearest(word, candidates); !near.empty())
    return "did you mean " + in_quotes(near) + "?";
  std::string out(what_they_are);
  for (std::size_t i = 0; i < std::min(candidates.size(), kMostCandidates); ++i)
    out += (i == 0 ? ": " : ", ") + std::string(candidates[i]);
  return candidates.size() > kMostCandidates ? out + ", ..." : out;
}

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text.substr(0, kLongestQuote)) out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  if (text.size() > kLongestQuote) {
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0) == 0x80) out.pop_back();  // half a character
    PHYSIM_ASSERT(!out.empty());  // the quote at the front is no half of anything
    if (static_cast<unsigned char>(out.back()) >= 0xC0) out.pop_back();
    out += "...";
  }
  return out + "\"";
}

}  // namespace physim
