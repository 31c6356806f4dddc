#include "canvoy/text/lss_text.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::text::lss_text_test {
namespace {

struct Example {
  std::string_view frame;
  std::string_view text;
};

TEST(LssText, NamesEachServiceOfTheMaster) {
  constexpr Example examples[] = {
      {"7E5#0400000000000000", "switch all to waiting"},
      {"7E5#0401000000000000", "switch all to configuration"},
      {"7E5#4078563412000000", "select vendor-ID 12345678h"},
      {"7E5#4178563412000000", "select product code 12345678h"},
      {"7E5#4278563412000000", "select revision number 12345678h"},
      {"7E5#4378563412000000", "select serial number 12345678h"},
      {"7E5#1105000000000000", "set node-ID 5"},
      {"7E5#11FF000000000000", "set node-ID none"},
      {"7E5#1300000000000000", "set bit rate 1000 kbit/s"},
      {"7E5#1300040000000000", "set bit rate 125 kbit/s"},
      {"7E5#1300050000000000", "set bit rate of index 5 in table 0"},
      {"7E5#1300080000000000", "set bit rate 10 kbit/s"},
      {"7E5#1300090000000000", "set bit rate by detection"},
      {"7E5#1380020000000000", "set bit rate of index 2 in table 128"},
      {"7E5#15E8030000000000", "activate the bit rate after 1000 ms"},
      {"7E5#1700000000000000", "store"},
      {"7E5#5A00000000000000", "inquire vendor-ID"},
      {"7E5#5D00000000000000", "inquire serial number"},
      {"7E5#5E00000000000000", "inquire node-ID"},
      {"7E5#4678563412000000", "identify vendor-ID 12345678h"},
      {"7E5#4878563412000000", "identify revision number from 12345678h"},
      {"7E5#4B78563412000000", "identify serial number to 12345678h"},
      {"7E5#4C00000000000000", "identify who has no node-ID"},
      {"7E5#5100000000800000", "Fastscan, who has no node-ID?"},
      {"7E5#51785634121F0000", "Fastscan, vendor-ID 12345678h down to bit 31"},
      {"7E5#5178563412000203",
       "Fastscan, revision number 12345678h down to bit 0, then serial number"},
      {"7E5#5178563412000409",
       "Fastscan, unknown number 12345678h down to bit 0, then unknown number"},
      {"7E5#5178563412000300", "Fastscan, serial number 12345678h: be selected"},
      {"7E5#0402000000000000", "switch all to unknown state 02h"},
      {"7E5#7700000000000000", "unknown command 77h"},
  };
  for (const Example& example : examples) {
    EXPECT_EQ(lss_master_text(parse_frame(example.frame).frame), example.text) << example.frame;
  }
}

TEST(LssText, NamesEachAnswerOfASlave) {
  constexpr Example examples[] = {
      {"7E4#4400000000000000", "selected"},
      {"7E4#1100000000000000", "node-ID done"},
      {"7E4#1101000000000000", "node-ID refused, error 01h: out of range"},
      {"7E4#1102000000000000", "node-ID refused, error 02h"},
      {"7E4#1300000000000000", "bit rate done"},
      {"7E4#13FF050000000000", "bit rate refused, error FFh: the manufacturer's 05h"},
      {"7E4#1301000000000000", "bit rate refused, error 01h: not supported"},
      {"7E4#1700000000000000", "storing done"},
      {"7E4#1701000000000000", "storing refused, error 01h: not supported"},
      {"7E4#1702000000000000", "storing refused, error 02h: the storage medium does not work"},
      {"7E4#5A78563412000000", "vendor-ID 12345678h"},
      {"7E4#5C78563412000000", "revision number 12345678h"},
      {"7E4#5E05000000000000", "node-ID 5"},
      {"7E4#5EFF000000000000", "node-ID none"},
      {"7E4#4F00000000000000", "identified"},
      {"7E4#5000000000000000", "has no node-ID"},
      {"7E4#0400000000000000", "unknown command 04h"},
  };
  for (const Example& example : examples) {
    EXPECT_EQ(lss_slave_text(parse_frame(example.frame).frame), example.text) << example.frame;
  }
}

}  // namespace
}  // namespace canvoy::text::lss_text_test
