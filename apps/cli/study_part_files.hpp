// Parts of studies as files: read, joined, and kept while a study is flown.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "physim/study.hpp"

namespace physim::cli {

/// The kind of a file that is gone on with, in errors.
inline constexpr const char* kResumedPart = "part of the study";

/// What was flown before: in the file that is gone on with, where there is one, and in those to be joined.
[[nodiscard]] Result<StudyPart> flown_before(const std::vector<std::string>& merge, const std::string& resume,
                                             const StudyPlan& plan);

/// Keeps what is flown in a file, once a second. What other programs have put into it meanwhile stays there.
class PartKeeper {
 public:
  explicit PartKeeper(std::string file) : file_(std::move(file)) {}

  /// False where it could not be written, now or before.
  bool take(const StudyPart& part) {
    using Clock = std::chrono::steady_clock;
    if (file_.empty() || Clock::now() - last_ < std::chrono::seconds(1)) return true;
    last_ = Clock::now();
    return write(part);
  }
  bool write(const StudyPart& part) {
    if (file_.empty()) return true;
    const Status written = write_together(part);
    if (status_.ok()) status_ = written;  // the first failure stopped the study
    return status_.ok();
  }
  [[nodiscard]] const Status& status() const { return status_; }
  /// Returns the part that the last write put into the file.
  [[nodiscard]] const StudyPart& kept() const { return kept_; }

 private:
  [[nodiscard]] Status write_together(const StudyPart& part);

  std::string file_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  Status status_;
  StudyPart kept_;
};

}  // namespace physim::cli
