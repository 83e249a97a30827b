// Tables of measurements: every field has a column, and what is none is refused with its place.
#include "scenario/measured_table.hpp"

#include "cli/program.hpp"
#include "scenario/measured_column.hpp"

namespace physim::scenario_measured_table_test {

using testing_cli::Folder;

using Numbers = std::vector<double>;

Result<Numbers> speeds_of(const Folder& folder, const std::string& text) {
  return read_measured_column(folder.write("d.csv", text), "v", Quantity::speed, Measured::values);
}

void expect_refusal(const std::string& text, const std::string& message) {
  const Folder folder;
  const auto read = speeds_of(folder, text);
  ASSERT_FALSE(read) << text;
  const std::string error = read.error().text();
  EXPECT_TRUE(error.starts_with((folder / "d.csv") + message)) << error << "\ninstead of\n" << message;
}

TEST(MeasuredTable, refuses_rows_of_another_count_of_fields) {
  constexpr const char* kDecimalCommas =
      ":2:1: error: 2 fields; the header has 1 column; commas part columns, and numbers have a decimal point";
  expect_refusal("v [m/s]\n100,5\n101,5\n", kDecimalCommas);
  expect_refusal("n,v [m/s]\n1,100\n2,101,5\n", ":3:1: error: 3 fields; the header has 2 columns; commas part columns");
  expect_refusal("# a chronograph\nn,v [m/s]\n1,100\n2\n", ":4:1: error: 1 field; the header has 2 columns");
  expect_refusal("v [m/s]\n\"100,5\"\n", ":2:2: error: \"100,5\" has a comma; write a decimal point");
}

TEST(MeasuredTable, refuses_heads_of_two_meanings_or_none) {
  expect_refusal("v [m/s],v [ft/s]\n100,1\n", ":1:9: error: two columns are named \"v\"");
  expect_refusal("n,v [s]\n1,100\n", ":1:3: error: \"1 s\" is a time; expected a speed");
  expect_refusal("V\n1\n", ":1:1: error: no column is called \"v\"; did you mean \"V\"?");
  expect_refusal("# nothing\n\n", ":1:1: error: there is no header line");
  expect_refusal("n,v\n1,\n", ":1:3: error: the column \"v\" has no numbers");
  const Folder folder;
  EXPECT_EQ(must(speeds_of(folder, "note,v [m/s],note,\na,100,b,\n")), Numbers({100})) << "of others it does not care";
}

TEST(MeasuredTable, says_that_commas_part_columns) {
  expect_refusal("v [m/s];w\n100,5;1\n", ":1:1: error: semicolons part the columns; save it as CSV where commas part");
  expect_refusal("\"v [m/s]\";\"w\"\n100;1\n", ":1:2: error: semicolons part the columns; ");
  expect_refusal("v [m/s]\tw\n100\t1\n", ":1:1: error: tabs part the columns; save it as CSV where commas part");
}

TEST(MeasuredTable, numbers_have_their_own_unit_or_that_of_the_head) {
  const Folder folder;
  EXPECT_EQ(must(speeds_of(folder, "v [ft/s]\n1000\n2000 ft/s\n100 m/s\n")), Numbers({304.8, 609.6, 100}));
  expect_refusal("v [m/s]\n100\n-\n", ":3:1: error: \"-\" is not a number");
  expect_refusal("v [m/s]\nnan\n", ":2:1: error: \"nan\" is not a number");
  expect_refusal("v [m/s]\ninf\n", ":2:1: error: \"inf\" is not a finite number");
  const std::string file = folder.write("days.csv", "dT\n9 degF\n3 degC\n-1\n");
  const auto changes = must(read_measured_column(file, "dT", Quantity::temperature, Measured::differences));
  ASSERT_EQ(changes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(changes[i], Numbers({5, 3, -1})[i], 1e-12);
}

TEST(MeasuredTable, lines_without_anything_in_their_fields_are_blank) {
  const Folder folder;
  EXPECT_EQ(must(speeds_of(folder, "\n,\nn,v [m/s]\n1,100\n,\n, ,\n\n2,\n3,101\n")), Numbers({100, 101}));
}

TEST(MeasuredTable, lines_end_as_any_program_ends_them) {
  const Folder folder;
  const std::string text = "n,v [m/s]\n1,100\n\n3,101\n";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string other = "\xef\xbb\xbf";
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(must(speeds_of(folder, other + "\x1a")), Numbers({100, 101}));
    const auto wrong = speeds_of(folder, other + "4,fast" + end);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().place, folder / "d.csv:5:3");
  }
}

}  // namespace physim::scenario_measured_table_test
