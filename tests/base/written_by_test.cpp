#include "base/written_by.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace physim::base_written_by_test {

std::vector<std::byte> bytes_of(std::size_t length, const std::string& text) {
  std::vector<std::byte> bytes;
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(length >> (8 * i)));
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  return bytes;
}
std::string version_in(const std::string& text) { return version_at(bytes_of(text.size(), text)); }

TEST(WrittenBy, AVersionIsReadWhereOneStands) {
  EXPECT_EQ(version_in("0.1.0"), "0.1.0");
  EXPECT_EQ(version_in("12.0.3-rc1+4"), "12.0.3-rc1+4");
  EXPECT_EQ(version_at(bytes_of(5, "0.1.0 and what follows")), "0.1.0");
}

TEST(WrittenBy, AnythingElseIsNoVersion) {
  for (const char* text : {"", "1", "v1.0", ".1", "0.1\n", "0.1 beta", "0.1\x1b[31m", "copper"})
    EXPECT_EQ(version_in(text), "") << text;
  EXPECT_EQ(version_in(std::string(33, '1') + ".0"), "") << "too long";
  for (const std::size_t length : {6u, 0xffffffffu}) EXPECT_EQ(version_at(bytes_of(length, "0.1.0")), "") << length;
  const std::vector<std::byte> whole = bytes_of(5, "0.1.0");
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_EQ(version_at(std::span(whole).first(size)), "");
}

}  // namespace physim::base_written_by_test
