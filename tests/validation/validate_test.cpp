// Suites of figures as a library.
#include "validation/validate.hpp"

#include <gtest/gtest.h>

namespace physim::validation {
namespace validation_validate_test {

const std::filesystem::path kData = PHYSIM_DATA_DIR "/validation";

TEST(Validate, RunsTheSuitesThatAreNamed) {
  std::size_t done = 0, total = 0;
  const auto results =
      validate({{"us76", "gravity"}, kData, true}, [&](std::size_t d, std::size_t t) { done = d, total = t; });
  ASSERT_TRUE(results);
  ASSERT_EQ(results->size(), 2U);
  EXPECT_EQ(done, 2U);
  EXPECT_EQ(total, 2U);
  for (const SuiteResult& result : *results) {
    EXPECT_GT(result.figures.size(), 50U) << result.name;
    EXPECT_EQ(result.missed(), 0U) << result.name;
    const std::string text = table_text(result, false, report::Style());
    EXPECT_NE(text.find("pass"), std::string::npos);
    EXPECT_EQ(text.find('\033'), std::string::npos) << "no colours were asked for";
    EXPECT_NE(summary_text(result, report::Style(true)).find('\033'), std::string::npos);
  }
}

TEST(Validate, SaysWhatIsMissing) {
  const auto no_suite = validate({{"stars"}, kData, true});
  ASSERT_FALSE(no_suite);
  EXPECT_EQ(no_suite.error().message, "no suite \"stars\"");
  EXPECT_EQ(no_suite.error().hint, "there are: " + names_of_suites());
  const auto no_folder = validate({{}, kData / "nowhere", true});
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.error().message, "no such folder");
}

TEST(Figure, PassesWithinItsGate) {
  Figure figure{.expected = 10, .actual = 10.5, .gate = 0.5};
  EXPECT_TRUE(figure.pass());
  EXPECT_EQ(figure.badness(), 1);
  figure.actual = 10.75;
  EXPECT_FALSE(figure.pass());
  figure.actual = kNaN;
  EXPECT_FALSE(figure.pass());
  EXPECT_TRUE(std::isinf(figure.badness()));
}

}  // namespace validation_validate_test
}  // namespace physim::validation
