// Runs the built `physim` as a user would, without a shell in between.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "must.hpp"

namespace physim::testing_cli {

struct Ran {
  int code = -1;
  std::string out, err;
};

/// An empty folder of its own, removed at the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "physim-cli-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name) << content;
    return *this / name;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      all.push_back(entry.path().filename().string());
    return all;
  }

 private:
  std::filesystem::path path_;
};

/// A file of this content in a folder of its own, both removed at the end; wherever a path is wanted.
class File {
 public:
  File(const std::string& name, const std::string& content) : path_(folder_.write(name, content)) {}
  operator const std::string&() const { return path_; }  // NOLINT: a file is its path

 private:
  Folder folder_;
  std::string path_;
};

inline std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Runs a program with these arguments. Its output goes to `stdout_to` where one is given; `environment` replaces ours.
inline Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                       const std::string& stdout_to = "", const std::vector<std::string>& environment = {}) {
  const Folder folder;
  const std::string out = stdout_to.empty() ? folder / "out" : stdout_to, err = folder / "err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment;
  std::vector<char*> argv, envp;
  for (std::string& word : words) argv.push_back(word.data());
  for (std::string& variable : variables) envp.push_back(variable.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  pid_t child = 0;
  Ran ran;
  const int failed =
      posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environment.empty() ? environ : envp.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return ran;
  int status = 0;
  waitpid(child, &status, 0);
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (stdout_to.empty()) ran.out = read(out);
  ran.err = read(err);
  return ran;
}

/// A complaint: exit code 2, one line on stderr that says this, nothing on stdout.
inline void expect_complaint(const Ran& ran, const std::string& part) {
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(has(ran.err, "error: ")) << ran.err;
  EXPECT_TRUE(has(ran.err, part)) << ran.err;
  EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
}
inline nlohmann::json json_of(const Ran& ran) {
  EXPECT_EQ(ran.err, "");
  return nlohmann::json::parse(ran.out, nullptr, false);
}

#ifdef PHYSIM_CLI
/// Runs the built `physim`.
inline Ran physim(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) {
  return run_program(PHYSIM_CLI, arguments, "", environment);
}

/// The hash that `physim run` prints of a world; of no length where it prints none.
inline std::string hash_of(const Ran& ran) {
  const std::size_t at = ran.out.find("hash ");
  EXPECT_NE(at, std::string::npos) << ran.out << ran.err;
  return at == std::string::npos ? "" : ran.out.substr(at + 5, 16);
}
#endif

}  // namespace physim::testing_cli
