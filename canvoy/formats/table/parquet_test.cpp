// Parquet files, byte by byte after parquet.thrift and Thrift's compact protocol. What pyarrow
// reads of them is in tests/strangers/traces.
#include "canvoy/formats/table/parquet.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "canvoy/formats/table/thrift.hpp"
#include "canvoy/formats/trace/inflater.hpp"

namespace canvoy::formats::parquet_test {
namespace {

using namespace std::string_literals;

TEST(Thrift, WritesFieldsByTheirDistanceAndNumbersInZigzag) {
  std::string bytes;
  ThriftStruct sut(bytes);
  sut.number(1, 1);
  sut.number(3, -1);
  sut.long_number(4, 150);
  sut.flag(5, true);
  sut.text(6, "ab");
  sut.begin(7).end();
  sut.end();
  EXPECT_EQ(bytes,
            "\x15\x02\x25\x01\x16\xAC\x02\x11\x18\x02"
            "ab\x1C\0\0"s);
}

TEST(Thrift, WritesLongListsWithTheirCountApart) {
  std::string bytes;
  ThriftStruct sut(bytes);
  sut.list(1, ThriftStruct::Of::numbers, 2);
  sut.item(0);
  sut.item(3);
  sut.list(2, ThriftStruct::Of::structures, 15);
  EXPECT_EQ(bytes, "\x19\x25\x00\x06\x19\xFC\x0F"s);
}

TEST(Parquet, APageHasItsValuesAndWhichAreThere) {
  ParquetColumn text("text", ParquetType::text);
  text.add(std::string_view("ab"));
  text.add(std::string_view(""));
  EXPECT_EQ(text.take_page(), "\2\0\0\0ab\0\0\0\0"s);
  EXPECT_EQ(text.take_page(), "") << "nothing is kept";

  ParquetColumn real("real", ParquetType::real);
  real.add(std::optional<double>(1.0));
  real.add(std::optional<double>());
  real.add(std::optional<double>(-2.0));
  // Two bytes of levels: one group of bits, 101.
  EXPECT_EQ(real.take_page(),
            "\2\0\0\0\3\5"
            "\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\0\xC0"s);

  ParquetColumn time("time", ParquetType::time);
  time.add(Duration{0x0102});
  EXPECT_EQ(time.take_page(), "\2\1\0\0\0\0\0\0"s);
}

TEST(Parquet, BeginsAndEndsWithItsMark) {
  ParquetWriter sut({{"node", ParquetType::whole}});
  std::string file;
  sut.column(0).add(std::int32_t{5});
  sut.end_row(file);
  EXPECT_EQ(file, "") << "the group is not full";
  sut.finish(file);
  EXPECT_TRUE(file.starts_with("PAR1"));
  EXPECT_TRUE(file.ends_with("PAR1"));
  EXPECT_EQ(sut.rows(), 1U);
  // Of its end, the length stands before the mark.
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + file.size() - 8, sizeof(length));
  EXPECT_EQ(file.substr(file.size() - 8 - length, 2), "\x15\x02"s);
}

/// SchemaElement of a time: type INT64, required, name, ConvertedType TIMESTAMP_MICROS, and
/// LogicalType TIMESTAMP (8) with isAdjustedToUTC (1) and the unit MICROS (2).
TEST(Parquet, ATimeIsSaidToBeInMicrosecondsOfUtcInBothWays) {
  ParquetWriter sut({{"at", ParquetType::time}});
  std::string file;
  sut.column(0).add(Duration{1});
  sut.end_row(file);
  sut.finish(file);
  EXPECT_NE(file.find("\x15\x04\x25\x00\x18\x02"
                      "at\x25\x14\x4C\x8C\x11\x1C\x2C\0\0\0\0\0"s),
            std::string::npos);
}

TEST(Parquet, CompressesAPageByGzip) {
  ParquetWriter sut({{"node", ParquetType::whole}});
  std::string file;
  sut.column(0).add(std::int32_t{5});
  sut.end_row(file);
  sut.finish(file);
  const std::size_t at = file.find("\x1F\x8B\x08");
  ASSERT_NE(at, std::string::npos);
  Inflater inflater{Inflater::Of::gzip};
  std::string page(100, '\0');
  page.resize(inflater.run(std::string_view(file).substr(at), page).made);
  EXPECT_EQ(page, "\5\0\0\0"s);
}

TEST(Parquet, WritesAGroupWhenItIsFull) {
  ParquetWriter sut({{"node", ParquetType::whole}});
  std::string file;
  for (std::uint32_t row = 0; row + 1 < ParquetWriter::rows_max; ++row) {
    sut.column(0).add(std::int32_t{5});
    sut.end_row(file);
  }
  EXPECT_EQ(file, "");
  sut.column(0).add(std::int32_t{5});
  sut.end_row(file);
  EXPECT_GT(file.size(), 4U);
}

}  // namespace
}  // namespace canvoy::formats::parquet_test
