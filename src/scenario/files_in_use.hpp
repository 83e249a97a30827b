// Which files a piece of work reads and which it writes: no result may replace what it was computed from.
//
// Every function of the house that opens a file calls begin_reading() or begin_writing() first. They report to the
// records (FilesInUse) of their thread, and refuse a file that the work uses the other way. Without a record nothing
// is refused: a program may well load a save and write the next one over it.
#pragma once

#include <string>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// Whether two paths lead to one file: through links, "..", or as two names of it. The files need not exist. Never true
/// of an empty path, nor of character devices, which may have any number of writers.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// A record of the files that its thread opens while it lives. A file that is read cannot be written and the other way
/// round, whichever comes first.
class FilesInUse {
 public:
  FilesInUse();
  ~FilesInUse();
  FilesInUse(const FilesInUse&) = delete;
  FilesInUse& operator=(const FilesInUse&) = delete;

  /// Announces a file that an option will write; "-" is the standard output, an empty path none. An error if the path
  /// is a directory, or if the file is read or another option writes it. `replaces`: the kind of input that it may
  /// replace; empty: none.
  [[nodiscard]] Status add_output(const std::string& path, const std::string& option, const std::string& replaces = "");
  /// Announces a directory that an option will write files into. An error if it is a file.
  [[nodiscard]] Status add_folder(const std::string& path, const std::string& option);
  /// The paths of the files that were read, in order, each once.
  [[nodiscard]] std::vector<std::string> inputs() const;

  /// The record of this thread that was made last; null: none.
  [[nodiscard]] static FilesInUse* current();

 private:
  friend Status begin_reading(const std::string& path, const std::string& kind);
  friend Status begin_writing(const std::string& path);

  struct Input {
    std::string path, kind;
  };
  struct Output {
    std::string path, option, replaces;
  };
  [[nodiscard]] Status add(const Output& output);
  [[nodiscard]] Status check(const Input& input, const Output& output) const;
  [[nodiscard]] Status read(const Input& input);
  [[nodiscard]] Status write(const std::string& path) const;

  std::vector<Input> inputs_;
  std::vector<Output> outputs_;
  FilesInUse* outer_;
};

/// To be called before a file is opened to be read. `kind` names it in errors: "motor file".
[[nodiscard]] Status begin_reading(const std::string& path, const std::string& kind);
/// To be called before a file is opened to be written, or another is moved to its place.
[[nodiscard]] Status begin_writing(const std::string& path);

}  // namespace physim
