#include "scenario/files_in_use.hpp"

#include <algorithm>
#include <filesystem>

#include "base/assert.hpp"

namespace physim {
namespace fs = std::filesystem;
namespace {

thread_local FilesInUse* innermost = nullptr;

constexpr const char* kStandardOutput = "-";

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code failure;
  const fs::path first = fs::weakly_canonical(fs::absolute(a, failure), failure);
  if (failure || fs::is_character_file(first, failure)) return false;
  const fs::path second = fs::weakly_canonical(fs::absolute(b, failure), failure);
  return !failure && (first == second || fs::equivalent(first, second, failure));
}

FilesInUse::FilesInUse() : outer_(innermost) { innermost = this; }

FilesInUse::~FilesInUse() {
  PHYSIM_ASSERT(innermost == this);
  innermost = outer_;
}

FilesInUse* FilesInUse::current() { return innermost; }

Status FilesInUse::add_output(const std::string& path, const std::string& option, const std::string& replaces) {
  std::error_code ignored;
  if (path.empty()) return {};
  if (path != kStandardOutput && fs::is_directory(path, ignored))
    return Error{"cannot write: it is a directory", path, "name a file with " + option};
  return add({path, option, replaces});
}

Status FilesInUse::add_folder(const std::string& path, const std::string& option) {
  std::error_code ignored;
  if (Status status = add({path, option, ""}); !status) return status;
  if (!fs::exists(path, ignored) || fs::is_directory(path, ignored)) return {};
  return Error{"it is a file, not a directory", path, "name a directory with " + option};
}

Status FilesInUse::add(const Output& output) {
  for (const Output& other : outputs_) {
    const bool is_stream = output.path == kStandardOutput || other.path == kStandardOutput;
    if (is_stream ? output.path == other.path : is_same_file(output.path, other.path))
      return Error{other.option + " and " + output.option + " cannot both go to " + output.path, "",
                   "name another file with one of them"};
  }
  for (const Input& input : inputs_)
    if (Status status = check(input, output); !status) return status;
  outputs_.push_back(output);
  return {};
}

std::vector<std::string> FilesInUse::inputs() const {
  std::vector<std::string> paths;
  for (const Input& input : inputs_)
    if (std::ranges::count(paths, input.path) == 0) paths.push_back(input.path);
  return paths;
}

/// The place of the error is the output.
Status FilesInUse::check(const Input& input, const Output& output) const {
  const bool is_free = output.path == kStandardOutput || (!output.replaces.empty() && output.replaces == input.kind);
  if (is_free || !is_same_file(input.path, output.path)) return {};
  return Error{output.option + " cannot write: it is the " + input.kind + " itself, " + input.path, output.path,
               "name another file with " + output.option};
}

Status FilesInUse::read(const Input& input) {
  for (const Output& output : outputs_)
    if (Status status = check(input, output); !status) return status;
  const auto is_known = [&](const Input& other) { return other.path == input.path && other.kind == input.kind; };
  if (std::ranges::none_of(inputs_, is_known)) inputs_.push_back(input);
  return {};
}

Status FilesInUse::write(const std::string& path) const {
  const auto announced = [&](const Output& output) { return is_same_file(output.path, path); };
  const auto output = std::ranges::find_if(outputs_, announced);
  const std::string replaces = output == outputs_.end() ? "" : output->replaces;
  for (const Input& input : inputs_)
    if ((replaces.empty() || replaces != input.kind) && is_same_file(input.path, path))
      return Error{"cannot write: it is the " + input.kind + " itself, " + input.path, path, "name another file"};
  return {};
}

Status begin_reading(const std::string& path, const std::string& kind) {
  PHYSIM_ASSERT(!kind.empty());
  for (FilesInUse* each = innermost; each != nullptr; each = each->outer_)
    if (Status status = each->read({path, kind}); !status) return status;
  return {};
}

Status begin_writing(const std::string& path) {
  for (const FilesInUse* each = innermost; each != nullptr; each = each->outer_)
    if (Status status = each->write(path); !status) return status;
  return {};
}

}  // namespace physim
