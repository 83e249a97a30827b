// One version everywhere: pages and files that name it agree with physim/result.hpp.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "physim/result.hpp"
#include "physim/world.hpp"

namespace physim::docs_release_test {

const std::string kOwn = kVersion;

std::string content_of(const std::string& page) {
  std::ifstream file(std::filesystem::path(PHYSIM_SOURCE_DIR) / page, std::ios::binary);
  EXPECT_TRUE(file) << page << " cannot be read";
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

/// What a pattern's group finds in a page, each time.
std::vector<std::string> found_in(const std::string& page, const std::string& pattern) {
  const std::string text = content_of(page);
  const std::regex wanted(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), wanted), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

std::string first_in(const std::string& page, const std::string& pattern) {
  const auto found = found_in(page, pattern);
  return found.empty() ? "none" : found[0];
}

TEST(Release, VersionsAreThreeNumbers) {
  EXPECT_TRUE(std::regex_match(kOwn, std::regex("[0-9]+\\.[0-9]+\\.[0-9]+"))) << kOwn;
}

TEST(Release, TheNewestSectionsAreOfThisVersion) {
  EXPECT_EQ(first_in("CHANGELOG.md", "\n## ([0-9.]+) \\([0-9]{4}-[0-9]{2}-[0-9]{2}\\)\n"), kOwn);
  EXPECT_EQ(first_in("docs/api_changes.md", "\n## ([0-9.]+)\n"), kOwn);
}

TEST(Release, TheCitationIsOfThisVersionAndDay) {
  EXPECT_EQ(first_in("CITATION.cff", "\nversion: (\\S+)\n"), kOwn);
  EXPECT_EQ(first_in("CITATION.cff", "\ndate-released: (\\S+)\n"),
            first_in("CHANGELOG.md", "\n## [0-9.]+ \\(([^)]*)\\)\n"));
}

TEST(Release, AProjectOutsideAsksForThisVersion) {
  const std::string minor = kOwn.substr(0, kOwn.rfind('.'));
  for (const char* page : {"README.md", "tests/install/CMakeLists.txt"})
    EXPECT_EQ(first_in(page, "find_package\\(physim ([0-9.]+) "), minor) << page;
}

TEST(Release, PagesThatQuoteTheVersionAreOfThisOne) {
  EXPECT_EQ(first_in("docs/validation.md", "PhySim ([0-9]+\\.[0-9]+\\.[0-9]+)\\."), kOwn);
  for (const char* page : {"docs/cli.md", "docs/world.md"})
    for (const std::string& version : found_in(page, "recorded by  physim ([0-9.]+)")) EXPECT_EQ(version, kOwn) << page;
}

TEST(Release, EveryVersionOfTheChangelogHasItsChangesOfTheInterface) {
  EXPECT_EQ(found_in("CHANGELOG.md", "\n## ([0-9.]+) "), found_in("docs/api_changes.md", "\n## ([0-9.]+)\n"));
}

/// The table of formats ends in the column of this version.
TEST(Release, TheTableOfFormatsIsOfThisVersion) {
  const std::string version = "\n\\| file \\|.* ([0-9.]+) \\|\n", last = ".*\\| ([0-9]+)[^|\n]*\\|\n";
  EXPECT_EQ(first_in("docs/api_changes.md", version), kOwn);
  EXPECT_EQ(first_in("docs/api_changes.md", "\n\\| save of a world" + last), std::to_string(kSaveFormat));
  EXPECT_EQ(first_in("docs/api_changes.md", "\n\\| recording" + last), std::to_string(kRecordingFormat));
}

}  // namespace physim::docs_release_test
