#include "canvoy/formats/gtfs/csv_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>

namespace canvoy::gtfs::csv_reader_test {
namespace {

struct Row {
  std::size_t line = 0;
  std::vector<std::string> fields;

  friend bool operator==(const Row&, const Row&) = default;
};

/// Rows, and the error at the end.
struct Outcome {
  std::vector<Row> rows;
  std::string problem;
  std::size_t line = 0;
};

Outcome read(std::string text) {
  const FeedArchive archive = FeedArchive::of_texts({{"a.txt", std::move(text)}});
  host::Result<FeedFile> file = archive.file("a.txt");
  CsvReader reader(*file);
  Outcome outcome;
  while (reader.next() == CsvRead::row) {
    outcome.rows.push_back({reader.line(), {reader.fields().begin(), reader.fields().end()}});
  }
  outcome.problem = reader.problem();
  outcome.line = reader.line();
  return outcome;
}

using Rows = std::vector<Row>;

TEST(CsvReader, RowsEndWithAnyLineEndOrWithTheFile) {
  const Rows expected = {{1, {"a", "b"}}, {2, {"1", "2"}}};
  EXPECT_EQ(read("a,b\n1,2\n").rows, expected);
  EXPECT_EQ(read("a,b\r\n1,2\r\n").rows, expected);
  EXPECT_EQ(read("a,b\n1,2").rows, expected);
}

TEST(CsvReader, AByteOrderMarkIsNoPartOfTheFirstColumn) {
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "a,b\n")
                .rows,
            (Rows{{1, {"a", "b"}}}));
  EXPECT_EQ(read("\xEF\xBB\xBF").rows, Rows{});
}

TEST(CsvReader, AnEmptyFileHasNoRows) {
  EXPECT_EQ(read("").rows, Rows{});
  EXPECT_EQ(read("").problem, "");
  EXPECT_EQ(read("\n \r\n\n").rows, Rows{});
}

TEST(CsvReader, BlanksAroundFieldsAndEmptyLinesDoNotMatter) {
  EXPECT_EQ(read("a , b\n\n  \n \"1\" ,\t2 \n").rows, (Rows{{1, {"a", "b"}}, {4, {"1", "2"}}}));
}

TEST(CsvReader, EmptyFieldsAreFields) {
  EXPECT_EQ(read(",a,,\n").rows, (Rows{{1, {"", "a", "", ""}}}));
  EXPECT_EQ(read("\"\",\"\"\n").rows, (Rows{{1, {"", ""}}}));
}

TEST(CsvReader, QuotationMarksHoldCommasLineEndsAndQuotationMarks) {
  EXPECT_EQ(read("\"Main, St\",\"the \"\"Pub\"\"\",\"two\nlines\"\nnext,1,2\n").rows,
            (Rows{{1, {"Main, St", "the \"Pub\"", "two\nlines"}}, {3, {"next", "1", "2"}}}));
}

TEST(CsvReader, AQuotationMarkWithinATextIsACharacter) {
  EXPECT_EQ(read("Platform \"A\",5\" pipe\n").rows, (Rows{{1, {"Platform \"A\"", "5\" pipe"}}}));
}

TEST(CsvReader, WhatIsWrongIsToldWithItsLine) {
  const Outcome behind = read("a,b\n1,\"x\"y\n");
  EXPECT_EQ(behind.problem, "text behind a closing quotation mark");
  EXPECT_EQ(behind.line, 2U);
  const Outcome open = read("a,b\n1,\"x\ny,z\n");
  EXPECT_EQ(open.problem, "the file ends within quotation marks");
  EXPECT_EQ(open.line, 2U);
  EXPECT_EQ(open.rows.size(), 1U);
  EXPECT_EQ(read("\xFF\xFE"
                 "a\0")
                .problem,
            "the text is UTF-16; save it as UTF-8");
}

TEST(CsvReader, AMissingQuotationMarkDoesNotTakeInTheFile) {
  std::string text = "a,b\n1,\"x\n";
  for (int i = 0; i < 100'000; ++i) text += "some,row\n";
  const Outcome outcome = read(text);
  EXPECT_EQ(outcome.problem, "more than 65536 bytes in one row; is a quotation mark missing?");
  EXPECT_EQ(outcome.line, 2U);
}

TEST(CsvReader, ARowMayHave65536BytesAndNoMore) {
  EXPECT_EQ(read(std::string(65'536, 'x') + "\n").rows.size(), 1U);
  EXPECT_EQ(read(std::string(65'537, 'x') + "\n").problem,
            "more than 65536 bytes in one row; is a quotation mark missing?");
}

/// A row across the border of two pieces of 256 KiB.
TEST(CsvReader, ARowMayLieAcrossTheBorderOfTwoPieces) {
  std::string text;
  while (text.size() < 262'100) text += "12345678,abcdefgh\n";
  const std::size_t before = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  text += std::string(60, 'a') + ",\"" + std::string(60, 'b') + "\n\"\"" + std::string(10, 'c') +
          "\"\nend,1\n";
  const Outcome outcome = read(text);
  ASSERT_EQ(outcome.rows.size(), before + 2);
  EXPECT_EQ(outcome.rows[before],
            (Row{before + 1,
                 {std::string(60, 'a'), std::string(60, 'b') + "\n\"" + std::string(10, 'c')}}));
  EXPECT_EQ(outcome.rows.back(), (Row{before + 3, {"end", "1"}}));
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

RC_GTEST_PROP(CsvReader, WhateverStandsBetweenQuotationMarksIsReadBack, ()) {
  const auto fields = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(
      rc::gen::container<std::string>(rc::gen::elementOf(std::string_view("ab\",\n.")))));
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + quoted(field);
  const Outcome outcome = read(line + "\n" + line + "\r\nx");
  RC_ASSERT(outcome.problem.empty());
  RC_ASSERT(outcome.rows.size() == 3U);
  RC_ASSERT(outcome.rows[0].fields == fields);
  RC_ASSERT(outcome.rows[1].fields == fields);
  const auto lines = static_cast<std::size_t>(std::count(line.begin(), line.end(), '\n')) + 1;
  RC_ASSERT(outcome.rows[1].line == 1 + lines);
  RC_ASSERT(outcome.rows[2].line == 1 + 2 * lines);
}

}  // namespace
}  // namespace canvoy::gtfs::csv_reader_test
