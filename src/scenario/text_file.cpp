#include "scenario/text_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/assert.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace fs = std::filesystem;
namespace {

constexpr int kWaitForWriter = 2'000, kWaitForMore = 60'000;  // on a pipe [ms]

Error unreadable(const std::string& file) { return {"the file cannot be read", file, std::strerror(errno)}; }

Error too_large(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  const bool is_small = most_bytes >> 20 == 0;
  const std::string limit =
      is_small ? std::to_string(most_bytes >> 10) + " KiB" : std::to_string(most_bytes >> 20) + " MiB";
  return {"larger than " + limit, file, "this cannot be a " + kind};
}

/// What stands at a path, if it is no file. Nothing is opened: to open a device may change it.
Status check_what_it_is(const std::string& file, const std::string& kind, bool allows_pipe, struct stat& at) {
  if (file.find('\0') != file.npos || ::stat(file.c_str(), &at) != 0) {
    const bool is_missing = errno == ENOENT || errno == ENOTDIR || file.find('\0') != file.npos;
    return is_missing ? Error{"there is no such file", file, ""} : unreadable(file);
  }
  if (S_ISDIR(at.st_mode)) return Error{"this is a folder", file, "name a " + kind + " in it"};
  if (S_ISREG(at.st_mode) || (allows_pipe && S_ISFIFO(at.st_mode))) return {};
  const char* what = S_ISFIFO(at.st_mode) ? "a pipe" : S_ISSOCK(at.st_mode) ? "a socket" : "a device";
  return Error{"this is " + std::string(what) + ", which has no end of its own", file, "name a " + kind};
}

/// A file that is open for reading.
class Open {
 public:
  explicit Open(const std::string& file)
      : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~Open() {
    if (number_ >= 0) ::close(number_);
  }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  [[nodiscard]] int number() const { return number_; }
  /// Waits until something comes; false if nothing does.
  [[nodiscard]] bool wait(int milliseconds) const {
    pollfd waiting{number_, POLLIN, 0};
    return ::poll(&waiting, 1, milliseconds) != 0;
  }

 private:
  int number_;
};

template <class Bytes>
Result<Bytes> read(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  PHYSIM_ASSERT(!kind.empty());
  struct stat at {};
  if (Status status = check_what_it_is(file, kind, true, at); !status) return status.error();
  if (Status begun = begin_reading(file, kind); !begun) return begun.error();
  const std::uintmax_t size = S_ISREG(at.st_mode) ? static_cast<std::uintmax_t>(at.st_size) : 0;
  if (size > most_bytes) return too_large(file, most_bytes, kind);
  const Open in(file);
  if (in.number() < 0) return unreadable(file);
  Bytes bytes;
  bool waited_for_writer = false;
  for (std::size_t filled = 0;;) {
    // One more than the file has: its end is found without another block.
    if (filled == bytes.size()) bytes.resize(std::max<std::size_t>(filled + (1 << 16), size + 1));
    const ssize_t count = ::read(in.number(), bytes.data() + filled, bytes.size() - filled);
    if (count > 0) filled += static_cast<std::size_t>(count);
    if (filled > most_bytes) return too_large(file, most_bytes, kind);
    if (count > 0 || (count < 0 && errno == EINTR)) continue;
    if (count < 0 && errno != EAGAIN) return unreadable(file);
    if (count < 0) {  // a pipe with a slow writer
      if (!in.wait(kWaitForMore))
        return Error{"nothing came through this pipe for a minute", file, "write a file first"};
    } else if (S_ISFIFO(at.st_mode) && filled == 0 && !waited_for_writer) {
      waited_for_writer = true;
      static_cast<void>(in.wait(kWaitForWriter));
    } else if (S_ISFIFO(at.st_mode) && filled == 0) {
      return Error{"nobody writes into this pipe", file, "name a " + kind};
    } else {
      bytes.resize(filled);
      return bytes;
    }
  }
}

}  // namespace

Result<std::string> read_text_file(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  auto text = read<std::string>(file, most_bytes, kind);
  if (!text) return text;
  if (text->starts_with("\xff\xfe") || text->starts_with("\xfe\xff"))
    return Error{"the text is in UTF-16", file + ":1:1", "save it as UTF-8"};
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // as spreadsheets and editors write it
  if (text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  constexpr char kEndMark = 0x1a;  // of texts from DOS; a file with zeros is no text
  if (text->ends_with(kEndMark) && text->find('\0') == text->npos) text->pop_back();
  return text;
}

Result<std::vector<std::byte>> read_byte_file(const std::string& file, std::uintmax_t most_bytes,
                                              const std::string& kind) {
  return read<std::vector<std::byte>>(file, most_bytes, kind);
}

Status check_file(const std::string& file, std::uintmax_t most_bytes, const std::string& kind) {
  struct stat at {};
  if (Status status = check_what_it_is(file, kind, false, at); !status) return status;
  if (Status begun = begin_reading(file, kind); !begun) return begun;
  if (static_cast<std::uintmax_t>(at.st_size) > most_bytes) return too_large(file, most_bytes, kind);
  return ::access(file.c_str(), R_OK) == 0 ? Status() : unreadable(file);
}

std::string target_of(const std::string& path) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : fs::path(path);
  return target.empty() ? path : target.string();
}

bool is_special(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlank); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::vector<CsvField> csv_fields(std::string_view line) {
  std::vector<CsvField> fields;
  for (std::size_t from = 0; from <= line.size();) {
    std::size_t end = from;
    for (bool quoted = false; end < line.size() && (quoted || line[end] != ','); ++end)
      quoted = quoted != (line[end] == '"');
    std::string_view text = trimmed(line.substr(from, end - from));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = trimmed(text.substr(1, text.size() - 2));
    const std::size_t start = text.empty() ? from : static_cast<std::size_t>(text.data() - line.data());
    fields.push_back({text, start + 1});
    from = end + 1;
  }
  return fields;
}

std::optional<double> finite_number(std::string_view word) {
  double value = 0;
  const auto [end, failure] = number_at_start(word, value);
  if (failure != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace physim
