// Numbers as people read them.
#include "base/text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace physim::base_text_test {

TEST(Text, ShortTextReadsBack) {
  EXPECT_EQ(short_text(1000), "1000");
  EXPECT_EQ(short_text(0.1), "0.1");
  EXPECT_EQ(short_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Text, RoundedTextHasTwoDigits) {
  EXPECT_EQ(rounded_text(1.0 / 60), "0.017");
  EXPECT_EQ(rounded_text(4.24), "4.2");
  EXPECT_EQ(rounded_text(99.6), "100");
  EXPECT_EQ(rounded_text(203.4), "203");
  EXPECT_EQ(rounded_text(1.23e7), "1.2e+07");
  EXPECT_EQ(rounded_text(0), "0");
}

TEST(Text, LengthsHaveTheUnitThatSuitsThem) {
  EXPECT_EQ(length_text(1500), "1.5 km");
  EXPECT_EQ(length_text(120), "120 m");
  EXPECT_EQ(length_text(0.42), "42 cm");
  EXPECT_EQ(length_text(0.01), "1 cm");
  EXPECT_EQ(length_text(4.2e-3), "4.2 mm");
  EXPECT_EQ(length_text(1.2e-4), "120 um");
  EXPECT_EQ(length_text(5e-8), "50 nm");
  EXPECT_EQ(length_text(2.3e-12), "2.3e-12 m");
  EXPECT_EQ(length_text(std::numeric_limits<double>::infinity()), "inf m");
}

TEST(Text, has_errors_within_a_sentence_and_replaced_parts) {
  EXPECT_EQ(within_sentence({"is heavy", "projectile.mass", "in kg"}), "projectile.mass: is heavy; in kg");
  EXPECT_EQ(within_sentence({"is heavy", "", ""}), "is heavy");
  std::string text = "a b a";
  replace_all(text, "a", "aa");
  EXPECT_EQ(text, "aa b aa");
}

}  // namespace physim::base_text_test
