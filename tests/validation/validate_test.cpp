// Suites of figures as a library.
#include "validation/validate.hpp"
#include "must.hpp"

#include <algorithm>
#include <map>

namespace physim::validation::validation_validate_test {

const std::filesystem::path kData = PHYSIM_DATA_DIR "/validation";

TEST(Validate, RunsTheSuitesThatAreNamed) {
  std::size_t done = 0, total = 0;
  const auto results =
      must(validate({{"us76", "gravity"}, kData, true}, [&](std::size_t d, std::size_t t) { done = d, total = t; }));
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(done, 2U);
  EXPECT_EQ(total, 2U);
  for (const SuiteResult& result : results) {
    EXPECT_GT(result.figures.size(), 50U) << result.name;
    EXPECT_EQ(result.missed(), 0U) << result.name;
    const std::string text = table_text(result, false, report::Style());
    EXPECT_NE(text.find("pass"), std::string::npos);
    EXPECT_EQ(text.find('\033'), std::string::npos) << "no colours were asked for";
    EXPECT_NE(summary_text(result, report::Style(true)).find('\033'), std::string::npos);
  }
}

/// Figures whose name begins so, of the cases that tables 5-2 to 5-7 were printed of.
std::size_t count_of(const SuiteResult& result, const std::string& figure) {
  return static_cast<std::size_t>(std::ranges::count_if(result.figures, [&](const Figure& each) {
    const std::string& name = each.case_name;
    const bool is_row = name.size() == 6 || name.ends_with(" as published");
    return is_row && each.figure.starts_with(figure + " frame ");
  }));
}

TEST(Validate, TheOriginalIsComparedWithEveryPrintedFigure) {
  // The true frames of all printed rows, table by table, as their positions tell them.
  const std::map<std::string, std::vector<int>> printed = {{"test 1", {0, 27, 42, 77, 124, 161}},
                                                           {"test 2", {0, 7, 79, 120, 125, 147}},
                                                           {"test 3 as published", {0, 19, 44, 71, 93, 106}},
                                                           {"test 4", {0, 13, 35, 109, 123, 141}},
                                                           {"test 5", {0, 4, 10, 18, 28, 35, 49}},
                                                           {"test 6 as published", {0, 37, 106, 127, 162, 203}}};
  const auto results = must(validate({{"classic"}, kData, true}));
  const SuiteResult& classic = results.front();
  EXPECT_EQ(classic.missed(), 0U);
  EXPECT_TRUE(classic.skipped.empty());
  const char* const columns[] = {"x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "speed", "mass"};
  for (const char* column : columns) EXPECT_EQ(count_of(classic, column), 37U) << column;
  for (const auto& [test, frames] : printed)
    for (const int frame : frames)
      for (const char* column : columns) {
        const std::string name = column + std::string(" frame ") + std::to_string(frame);
        const auto of_it = [&](const Figure& f) { return f.case_name == test && f.figure == name; };
        const auto figure = std::ranges::find_if(classic.figures, of_it);
        ASSERT_NE(figure, classic.figures.end()) << test << ", " << name;
        EXPECT_LE(figure->gate, 0.5e-6) << "six decimals";
      }
}

TEST(Validate, MisprintsOfTheOriginalAreNamedOneByOne) {
  const auto results = must(validate({{"classic"}, kData, true}));
  const std::vector<Misprint>& misprints = results.front().misprints;
  EXPECT_EQ(misprints.size(), 39U);
  for (const Misprint& each : misprints) {
    EXPECT_FALSE(each.reason.empty()) << each.figure;
    EXPECT_NE(std::stod(each.printed), std::stod(each.instead)) << each.figure;
  }
  // What a misprinted v_z is follows from the row's speed, also where it was rounded to a whole number.
  const std::vector<Figure>& figures = results.front().figures;
  for (const int frame : {10, 28, 35, 49}) {
    const auto by_speed = std::ranges::find_if(figures, [&](const Figure& f) {
      return f.case_name == "test 5" && f.figure == "vz by speed frame " + std::to_string(frame);
    });
    ASSERT_NE(by_speed, figures.end()) << frame;
    EXPECT_LT(by_speed->gate, 1e-5) << "six digits";
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

}  // namespace physim::validation::validation_validate_test
