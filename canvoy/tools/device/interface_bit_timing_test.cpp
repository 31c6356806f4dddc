// Answers of LSS for an interface of this machine without a bit rate; one with a bit rate is tested
// in the emulated machine (tests/strangers).
#include "canvoy/tools/device/interface_bit_timing.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace canvoy::tools::interface_bit_timing_test {
namespace {

struct Spoken {
  InterfaceBitTiming of(const char* interface) {
    return {interface, [this](const std::string& line) { lines.push_back(line); }};
  }
  std::vector<std::string> lines;
};

TEST(InterfaceBitTiming, IsRefusedWithALineWhereThereIsNoBitRate) {
  Spoken spoken;
  const InterfaceBitTiming sut = spoken.of("lo");
  EXPECT_EQ(sut.present(), lss_bit_timing::unknown);
  EXPECT_EQ(sut.configure(3).code, LssError::out_of_range);
  EXPECT_EQ(spoken.lines, std::vector<std::string>{"lo has no bit rate that LSS could set"});
}

TEST(InterfaceBitTiming, OfAnInterfaceThatIsNotThereIsRefusedWithALine) {
  Spoken spoken;
  const InterfaceBitTiming sut = spoken.of("no-such-can0");
  EXPECT_EQ(sut.present(), lss_bit_timing::unknown);
  EXPECT_EQ(sut.configure(3).code, LssError::out_of_range);
  sut.switch_to(3);
  ASSERT_EQ(spoken.lines.size(), 2U);
  for (const std::string& line : spoken.lines)
    EXPECT_TRUE(line.starts_with("no-such-can0")) << line;
}

}  // namespace
}  // namespace canvoy::tools::interface_bit_timing_test
