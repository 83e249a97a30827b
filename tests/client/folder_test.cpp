// What the dialogue of files shows, and what is meant by what was typed there.
#include "simclient/core/folder.hpp"

#include "cli/program.hpp"

namespace physim::client::client_folder {
namespace {

TEST(Folder, FiltersByWordsInEitherCase) {
  EXPECT_TRUE(passes_filter("Golf_Drive.toml", "golf"));
  EXPECT_TRUE(passes_filter("golf_drive.toml", "DRIVE golf"));
  EXPECT_TRUE(passes_filter("golf_drive.toml", " "));
  EXPECT_FALSE(passes_filter("golf_drive.toml", "golf ball"));
}

TEST(Folder, ShowsFoldersThenFilesThatCanBeOpened) {
  const testing_cli::Folder folder;
  for (const char* name : {"b.toml", "A.rec", "notes.txt", ".hidden.toml"}) folder.write(name, "");
  std::filesystem::create_directory(folder / "deep");
  folder.write("deep/golf.toml", "");
  std::vector<std::string> names;
  for (const FolderEntry& entry : entries_of(folder / "", "")) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"..", "deep", "A.rec", "b.toml"}));
  const std::vector<FolderEntry> found = entries_of(folder / "", "B");
  EXPECT_EQ(found.back().path, folder / "b.toml");
  EXPECT_EQ(found.size(), 3U) << "folders stay";
  EXPECT_EQ(std::filesystem::path(entries_of(folder / "deep", "")[0].path),
            std::filesystem::path(folder / "").parent_path());
  EXPECT_TRUE(entries_of(folder / "nowhere", "").size() <= 1);
}

TEST(Folder, EnterMeansAPathOrTheFirstThatPasses) {
  const testing_cli::Folder folder;
  const std::string golf = folder.write("golf_drive.toml", ""), ball = folder.write("golf_ball.toml", "");
  EXPECT_EQ(meant_by(golf, "/"), golf);
  EXPECT_EQ(meant_by("golf_drive.toml", folder / ""), golf);
  EXPECT_EQ(meant_by("GOLF", folder / ""), ball);
  EXPECT_EQ(meant_by("drive", folder / ""), golf);
  EXPECT_EQ(meant_by("cannon", folder / ""), "");
  EXPECT_EQ(path_in("/a/b", "c.toml"), "/a/b/c.toml");
  EXPECT_EQ(path_in("/a/b", "/c.toml"), "/c.toml");
  EXPECT_EQ(path_in("/a/b", "../c.toml"), "/a/c.toml");
}

}  // namespace
}  // namespace physim::client::client_folder
