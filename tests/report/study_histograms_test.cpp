// Histograms of studies as they are drawn and printed.
#include "report/study_answer.hpp"

#include "report/study_pictures.hpp"
#include "study/study_support.hpp"

namespace physim::report_study_histograms_test {

using namespace test;
using report::FlownStudy;

/// A study of impacts whose `right` is drawn so.
FlownStudy drawn_right(const Distribution& right, std::size_t bars) {
  Study study = scatter();
  study.inputs[0].distribution = right;
  study.shots = 40'960;
  const auto plan = must(plan_study(study, scattered));
  return report::told_study(plan, run_study(plan).value(), bars);
}

/// Of the bars of `right` in a picture: the part of shots that they have, 1 for all.
double part_drawn(const FlownStudy& study) {
  const std::string script = report::histograms_picture("", study).script;
  std::size_t at = script.find('\n', script.find("$bars0")) + 1;
  double sum = 0, first = 0, last = 0;
  int rows = 0;
  for (double middle = 0, part = 0, low = 0, high = 0;
       std::sscanf(script.c_str() + at, "%lf %lf %lf %lf", &middle, &part, &low, &high) == 4; ++rows) {
    if (rows == 0) first = low;
    last = high;
    sum += part / 100 * (high - low);
    at = script.find('\n', at) + 1;
  }
  return rows == 0 ? 0 : sum / ((last - first) / rows);
}

TEST(HistogramsPicture, draws_all_of_few_values) {
  EXPECT_NEAR(part_drawn(drawn_right(DiscreteDistribution{{1, 2, 4}, {1, 2, 1}}, 30)), 1, 1e-6);
  EXPECT_NEAR(part_drawn(drawn_right(DiscreteDistribution{{1, 2}, {1, 1}}, 3)), 1, 1e-6);
  EXPECT_NEAR(part_drawn(drawn_right(DiscreteDistribution{{7}}, 30)), 1, 1e-6);
}

TEST(HistogramsPicture, leaves_out_what_lies_far_out) {
  const double part = part_drawn(drawn_right(NormalDistribution{0, 1}, 30));
  EXPECT_LT(part, 0.9995);
  EXPECT_GE(part, 0.996);
}

/// 26 km, known to 0.1 m: each bar begins where the one before ends, and not where it begins.
TEST(HistogramsText, has_digits_for_narrow_bars) {
  const std::string text = report::histograms_text(drawn_right(NormalDistribution{26'000, 0.1}, 12));
  std::size_t at = text.find('\n') + 1;
  double before = 0;
  for (int i = 0; i < 12; ++i) {
    double low = 0, high = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + at, "%lf %lf", &low, &high), 2) << text;
    EXPECT_LT(low, high);
    EXPECT_TRUE(i == 0 || low == before) << text;
    before = high;
    at = text.find('\n', at) + 1;
  }
}

}  // namespace physim::report_study_histograms_test
