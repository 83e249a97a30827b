// Texts as a terminal shows them: how wide they are, on one line, and cut where they are too long.
#include "report/table.hpp"

#include <gtest/gtest.h>

namespace physim::report::report_table_test {

TEST(Table, shortens_texts_between_characters) {
  EXPECT_EQ(shortened("as long as it may be", 20), "as long as it may be");
  EXPECT_EQ(shortened("longer than it may be", 20), "longer than it may …");
  EXPECT_EQ(shortened("Geschoß über Zürich", 19), "Geschoß über Zürich") << "characters, not bytes";
  EXPECT_EQ(shortened("Geschoß über Zürich", 18), "Geschoß über Züri…");
  EXPECT_EQ(shortened("Geschoß über Zürich", 8), "Geschoß…") << "a character is cut whole";
  EXPECT_EQ(shortened("Geschoß über Zürich", 7), "Gescho…");
  EXPECT_EQ(shortened("砲弾の軌道", 3), "砲弾…");
}

}  // namespace physim::report::report_table_test
