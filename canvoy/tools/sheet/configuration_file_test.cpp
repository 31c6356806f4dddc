#include "canvoy/tools/sheet/configuration_file.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::configuration_file_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<ConfigurationEntry> parse(std::string_view text) {
  return parse_configuration("charger.txt",
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, 5)
      .entries;
}
std::string error_of(std::string_view text) {
  try {
    parse(text);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.status(), exit_failed);
    return failure.what();
  }
  return "none";
}

TEST(ConfigurationFile, TextHasAnEntryALine) {
  const auto entries = parse(
      "# index sub type value\n"
      "1017 0 u16 500\n"
      "\n"
      "  0x1800\t01h u32 0x80000185  \r\n"
      "2000 3 vs \"front left\"\n"
      "2000 4 vs \n"
      "2001 FF os hex:01 02\n"
      "6010 0 i16 -1\n"
      "6423:00h b 1");
  ASSERT_EQ(entries.size(), 7u);
  EXPECT_EQ(entries[0].index, 0x1017);
  EXPECT_EQ(entries[0].value, (Bytes{0xF4, 0x01}));
  EXPECT_EQ(entries[1].index, 0x1800);
  EXPECT_EQ(entries[1].sub, 1);
  EXPECT_EQ(entries[1].value, (Bytes{0x85, 0x01, 0x00, 0x80}));
  EXPECT_EQ(entries[2].value, (Bytes{'f', 'r', 'o', 'n', 't', ' ', 'l', 'e', 'f', 't'}));
  EXPECT_EQ(entries[3].value, Bytes{});
  EXPECT_EQ(entries[4].sub, 0xFF);
  EXPECT_EQ(entries[4].value, (Bytes{1, 2}));
  EXPECT_EQ(entries[5].value, (Bytes{0xFF, 0xFF}));
  EXPECT_EQ(entries[6].value, Bytes{1});
}

TEST(ConfigurationFile, AZeroByteMakesItAConciseDcf) {
  const Bytes bytes = {0x01, 0x00, 0x00, 0x00, 0x17, 0x10, 0x00,
                       0x02, 0x00, 0x00, 0x00, 0xF4, 0x01};
  const auto entries = parse_configuration("charger.cdcf", bytes, 5).entries;
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].index, 0x1017);
  EXPECT_EQ(entries[0].value, (Bytes{0xF4, 0x01}));
}

TEST(ConfigurationFile, ABadLineIsNamed) {
  EXPECT_EQ(error_of("1017 0 u16 500\n1017 0 u16 70000\n").substr(0, 19), "charger.txt line 2:");
  EXPECT_NE(error_of("1017 0 u99 5").find("'u99' is no data type"), std::string::npos);
  EXPECT_NE(error_of("1017 0 u16").find("the value is missing"), std::string::npos);
  for (const char* line : {"x", "1017", "1017 0", "10170 0 u8 1", "1017 100 u8 1", "-1 0 u8 1",
                           "1017 0x u8 1", "h 0 u8 1", ":0 u8 1", "1017:0:1 u8 1", "1017:"}) {
    EXPECT_NE(error_of(line).find("index sub type value"), std::string::npos) << line;
  }
}

TEST(ConfigurationFile, OneWithoutAnEntryIsRefused) {
  for (const std::string_view text :
       {std::string_view(""), std::string_view("# nothing\n\n"), std::string_view("\0\0\0\0", 4)}) {
    EXPECT_EQ(error_of(text), "charger.txt: there is no entry in it");
  }
}

TEST(ConfigurationFile, AConciseDcfIsRefusedWhereverItIsCut) {
  const Bytes whole = {0x02, 0x00, 0x00, 0x00, 0x17, 0x10, 0x00, 0x01, 0x00, 0x00, 0x00,
                       0xF4, 0x17, 0x10, 0x00, 0x02, 0x00, 0x00, 0x00, 0xF4, 0x01};
  for (std::size_t length = 2; length < whole.size(); ++length) {
    const auto cut = std::span(whole).first(length);
    EXPECT_THROW(parse_configuration("cut", cut, 5), Failure) << length;
  }
  Bytes longer = whole;
  longer.push_back(0);
  EXPECT_THROW(parse_configuration("long", longer, 5), Failure);
  EXPECT_EQ(parse_configuration("whole", whole, 5).entries.size(), 2u);
}

TEST(ConfigurationFile, WhatCannotBeReadIsTold) {
  for (const char* path : {"/no/such/file", "/"}) {
    try {
      read_configuration(path, 5);
      FAIL();
    } catch (const Failure& failure) {
      EXPECT_NE(std::string(failure.what()).find("check the path"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace canvoy::tools::configuration_file_test
