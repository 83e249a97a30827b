#include "outputs.hpp"

#include <algorithm>
#include <filesystem>

#include "base/assert.hpp"
#include "command.hpp"
#include "report/file.hpp"
#include "report/gnuplot.hpp"
#include "scenario/files_in_use.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {
namespace fs = std::filesystem;

std::string type_name_of(const Format& format) {
  if (!format.is_picture) return "FILE";
  const std::string other(format.other_ending);
  return "FILE" + std::string(format.ending) + (other.empty() ? "" : "|" + other.substr(1));
}

std::string help_of(const Format& format, const std::string& what, std::span<const Subject> subjects) {
  std::string text = "Write " + (format.what.empty() ? what : std::string(format.what)) + " " + std::string(format.doc);
  const auto is_unable = [&](Subject subject) { return !can_write(format, subject); };
  if (std::ranges::any_of(subjects, is_unable)) text += is_unable(Subject::world) ? "; not of worlds" : "; of worlds";
  return format.is_picture ? text : text + "; - is the standard output";
}

}  // namespace

bool Outputs::use_stdout() const { return std::ranges::count(paths, "-") > 0; }

std::vector<const Format*> Outputs::asked() const {
  std::vector<const Format*> out;
  for (const Format& format : formats())
    if (!path_of(format).empty()) out.push_back(&format);
  return out;
}

const std::string& Outputs::path_of(const Format& format) const {
  return paths[static_cast<std::size_t>(&format - formats().data())];
}

void Outputs::forget(const Format& format) { paths[static_cast<std::size_t>(&format - formats().data())].clear(); }

std::string option_of(const Format& format) { return "--" + std::string(format.name); }

void add_output_options(Command& command, Outputs& outputs, const std::string& what,
                        std::span<const Subject> subjects) {
  for (std::size_t i = 0; i < formats().size(); ++i) {
    const Format& format = formats()[i];
    if (std::ranges::none_of(subjects, [&](Subject subject) { return can_write(format, subject); })) continue;
    command.add_output(option_of(format).c_str(), outputs.paths[i], type_name_of(format).c_str(),
                       help_of(format, what, subjects).c_str());
  }
}

Status check(const Outputs& outputs) {
  for (const bool are_pictures : {false, true})  // which need gnuplot, too
    for (const Format* each : outputs.asked())
      if (const std::string& path = outputs.path_of(*each); each->is_picture == are_pictures)
        if (Status status = are_pictures ? check_plot(path) : check_output(path); !status) return status;
  return outputs.record.empty() ? Status() : check_writable(outputs.record);
}

Status announce(const Outputs& outputs, const std::string& option) {
  for (const Format* each : outputs.asked())
    if (Status status = announce(outputs.path_of(*each), option); !status) return status;
  return {};
}

Status announce(const std::string& file, const std::string& option) {
  FilesInUse* const files = FilesInUse::current();
  PHYSIM_ASSERT(files != nullptr);  // of the command's action
  return files->add_output(file, option);
}

Status check_subject(const Outputs& outputs, Subject subject, const std::string& why, const std::string& hint) {
  for (const Format* format : outputs.asked())
    if (!can_write(*format, subject)) return Error{.message = why, .place = option_of(*format), .hint = hint};
  return {};
}

Status write(const Outputs& outputs, const std::function<Content(const Format&)>& make) {
  std::vector<const Format*> asked = outputs.asked();
  std::stable_partition(asked.begin(), asked.end(), [](const Format* format) { return format->is_picture; });
  for (const Format* format : asked) {
    const std::string& path = outputs.path_of(*format);
    const Content content = make(*format);
    const auto* text = std::get_if<Text>(&content);
    if (Status status = text != nullptr && path == "-" ? print(*text) : write_content(path, content); !status)
      return status;
  }
  return {};
}

Status write_output(const std::string& path, const Text& text) {
  return path == "-" ? print(text) : write_file(path, text);
}

Status check_output(const std::string& path) { return path == "-" ? Status() : check_writable(path); }

Outputs outputs_in(const std::string& folder, const std::string& stem, Subject subject) {
  Outputs outputs;
  for (std::size_t i = 0; i < formats().size(); ++i)
    if (const Format& format = formats()[i]; can_write(format, subject))
      outputs.paths[i] = (fs::path(folder) / (stem + std::string(format.ending))).string();
  return outputs;
}

}  // namespace physim::cli
