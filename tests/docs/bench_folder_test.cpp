// ./dev bench --cyclone: a folder that holds no Cyclone is told before anything is built.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace physim::docs_bench_folder_test {

namespace fs = std::filesystem;

struct Answer {
  int code = 0;
  std::string text;
};

Answer bench(const std::string& arguments) {
  const std::string command = "'" PHYSIM_SOURCE_DIR "/dev' bench " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return {-1, "no pipe"};
  Answer answer;
  char part[4096];
  while (std::fgets(part, sizeof part, pipe)) answer.text += part;
  answer.code = WEXITSTATUS(pclose(pipe));
  return answer;
}

TEST(BenchFolder, one_without_cyclone_is_refused) {
  const fs::path folder = fs::path(testing::TempDir()) / "physim no cyclone";
  fs::remove_all(folder);
  fs::create_directories(folder / "include" / "cyclone");
  std::ofstream(folder / "include" / "cyclone" / "cyclone.h") << "\n";  // half of one
  for (const auto& [arguments, part] :
       {std::pair<std::string, std::string>{"--cyclone", "--cyclone wants a folder"},
        {"--cyclone '" + (folder / "absent").string() + "'", "include/cyclone/cyclone.h is missing"},
        {"--quick --cyclone '" + folder.string() + "'", "src/core.cpp is missing"}}) {
    const Answer answer = bench(arguments);
    EXPECT_EQ(answer.code, 2) << answer.text;
    EXPECT_NE(answer.text.find(part), std::string::npos) << answer.text;
    EXPECT_NE(answer.text.find("idmillington/cyclone-physics"), std::string::npos) << answer.text;
  }
  fs::remove_all(folder);
}

}  // namespace physim::docs_bench_folder_test
