// Files: read whole within a limit, with an error for every way in which that can fail; their lines and words. Where
// the files that are written lead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// The text of a file of at most `most_bytes`, without a byte order mark and an end mark of DOS; UTF-16 is refused.
/// `kind` names in errors what it should be: "scenario file". A pipe is read to its end within the same limit; it is
/// refused if it has no writer, or if nothing comes for a minute. Folders, devices and sockets are refused.
[[nodiscard]] Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes,
                                                 const std::string& kind);
/// The bytes of a file, read as read_text_file() reads.
[[nodiscard]] Result<std::vector<std::byte>> read_byte_file(const std::string& file, std::uintmax_t most_bytes,
                                                            const std::string& kind);

/// An error unless the path leads to a regular file of at most `most_bytes`. For what is read more than once, and for
/// libraries that open files themselves.
[[nodiscard]] Status check_file(const std::string& file, std::uintmax_t most_bytes, const std::string& kind);

/// Takes the next line off the front of a text, without its end: LF, CR LF or CR.
[[nodiscard]] std::string_view take_line(std::string_view& text);
/// The words of a line: views into it, parted by blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);
/// A field of a line of CSV (RFC 4180), without blanks and quotes about it, and the column where it starts, from 1.
struct CsvField {
  std::string_view text;
  std::size_t column;
};
/// The fields of a line: views into it. Commas within quotes part nothing.
[[nodiscard]] std::vector<CsvField> csv_fields(std::string_view line);
/// The finite number that a word is, with a sign or without; nothing if it is another word.
[[nodiscard]] std::optional<double> finite_number(std::string_view word);

/// Where a path leads: the file itself behind symbolic links, so that a link is kept and its target replaced.
[[nodiscard]] std::string target_of(const std::string& path);
/// A device or a pipe is written to; it must never be replaced by a file.
[[nodiscard]] bool is_special(const std::string& path);

}  // namespace physim
