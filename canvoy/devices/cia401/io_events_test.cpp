// Changes of inputs of a module of CiA 401 that are events, each of which is sent (6006h to 6008h,
// 6421h to 6428h; facts 6.1).
#include "canvoy/devices/cia401/io_bench_test.hpp"

namespace canvoy::cia401::io_events_test {
namespace {

constexpr std::uint32_t digital_pdo = 0x1A1;
constexpr std::uint32_t analogue_pdo = 0x2A1;

struct ModuleEvents : IoBench<default_io> {};
struct BitEvents : IoBench<IoOptions{.digital_inputs = 16, .single_bits = true}> {};

TEST_F(ModuleEvents, MasksSayWhichChangesAreEvents) {
  write("2F 06 60 01 00 00 00 00");  // no change
  write("2F 07 60 01 01 00 00 00");  // but input 1 switched on
  write("2F 08 60 01 02 00 00 00");  // and input 2 switched off
  switch_contacts(0x02);
  EXPECT_EQ(cable.count(digital_pdo), 0u);
  EXPECT_EQ(ask("40 00 60 01 00 00 00 00"), "4F 00 60 01 02 00 00 00") << "it is read";
  switch_contacts(0x03);
  EXPECT_EQ(cable.last(digital_pdo), "1A1#03 00 00 00 00 00 00 00");
  switch_contacts(0x02);
  EXPECT_EQ(cable.count(digital_pdo), 1u);
  switch_contacts(0x00);
  EXPECT_EQ(cable.count(digital_pdo), 2u);
  switch_contacts(0x04);
  EXPECT_EQ(cable.count(digital_pdo), 2u);
}

/// Between two events it has changed without one: the TPDO carries again what it carried last.
TEST_F(ModuleEvents, EachEventOfAnInputIsToldWhateverTheTpdoCarriedLast) {
  struct Row {
    const char* masks[3];  ///< 6006h, 6007h and 6008h
    std::uint8_t event;
    std::uint8_t between;
    const char* told;
  };
  constexpr Row rows[] = {
      {{"2F 06 60 01 00 00 00 00", "2F 07 60 01 01 00 00 00", "2F 08 60 01 00 00 00 00"},
       0x01,
       0x00,
       "1A1#01 00 00 00 00 00 00 00"},
      {{"2F 06 60 01 00 00 00 00", "2F 07 60 01 00 00 00 00", "2F 08 60 01 01 00 00 00"},
       0x02,
       0x03,
       "1A1#02 00 00 00 00 00 00 00"},
  };
  for (const Row& row : rows) {
    for (const char* mask : row.masks) write(mask);
    for (int i = 0; i < 3; ++i) {
      switch_contacts(row.between);
      cable.clear();
      switch_contacts(row.event);
      EXPECT_EQ(cable.count(digital_pdo), 1u);
      EXPECT_EQ(cable.last(digital_pdo), row.told);
      switch_contacts(row.between);
      EXPECT_EQ(cable.count(digital_pdo), 1u) << "no mask asks for it";
    }
  }
}

/// Events of one bit, which has a separate TPDO.
TEST_F(BitEvents, EachEventOfAnInputOfOneBitIsTold) {
  write("23 00 18 01 A1 01 00 80");
  write("2F 00 1A 00 00 00 00 00");
  write("23 00 1A 01 01 01 20 60");  // 6020h:01h, one bit
  write("2F 00 1A 00 01 00 00 00");
  write("23 00 18 01 A1 01 00 00");
  write("2F 06 60 01 00 00 00 00");
  write("2F 07 60 01 01 00 00 00");
  cable.clear();
  for (unsigned i = 1; i <= 3; ++i) {
    switch_contacts(0x01);
    EXPECT_EQ(cable.count(digital_pdo), i);
    switch_contacts(0x00);
    EXPECT_EQ(cable.last(digital_pdo), "1A1#01");
  }
  EXPECT_EQ(cable.count(digital_pdo), 3u);
}

/// It was below the limit in between, which is no event.
TEST_F(ModuleEvents, EachValueBeyondALimitIsToldWhateverTheTpdoCarriedLast) {
  write("2F 23 64 00 01 00 00 00");
  write("2F 21 64 01 01 00 00 00");  // the upper limit
  write("23 24 64 01 64 00 00 00");  // 100
  for (unsigned i = 1; i <= 3; ++i) {
    turn(100);
    EXPECT_EQ(cable.count(analogue_pdo), i);
    turn(50);
    EXPECT_EQ(cable.last(analogue_pdo), "2A1#64 00 00 00 00 00 00 00");
  }
  EXPECT_EQ(cable.count(analogue_pdo), 3u);
}

}  // namespace
}  // namespace canvoy::cia401::io_events_test
