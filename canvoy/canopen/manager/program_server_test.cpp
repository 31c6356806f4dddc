// Program download, server (CiA 302-3, objects 1F50h to 1F57h).
#include "canvoy/canopen/manager/program_server.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/program_objects.hpp"

namespace canvoy::program_server_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Log = std::vector<std::string>;

Bytes a_program(std::size_t size, std::uint8_t seed = 1) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + seed);
  return bytes;
}

// 1F57h: the error in bits 1 to 7, busy in bit 0.
constexpr std::uint64_t ok = 0;
constexpr std::uint64_t busy = 1;
constexpr std::uint64_t no_valid_program = 2;
constexpr std::uint64_t unknown_format = 4;
constexpr std::uint64_t not_cleared = 8;
constexpr std::uint64_t write_error = 10;

class ProgramServerTest : public testing::Test {
 protected:
  ProgramServerTest() {
    for (std::uint8_t& byte : memory.bytes) byte = 0x5A;  // leftovers
  }
  /// Slot 1 after a power-on with the present contents of the flash.
  bool is_valid_after_power_on(std::uint8_t number = 1) {
    SimulatedFlash copy(program_geometry, memory.bytes);
    return ProgramNode(copy).programs.is_valid(number);
  }
  Bytes kept(std::size_t size) const {
    return {memory.bytes.begin() + 32,
            memory.bytes.begin() + 32 + static_cast<std::ptrdiff_t>(size)};
  }
  void TearDown() override { EXPECT_EQ(memory.violations, 0U); }

  SimulatedFlash memory{program_geometry};
};

TEST_F(ProgramServerTest, ADeviceWithoutAProgramSaysSo) {
  ProgramNode sut(memory);
  sut.ask("40 57 1F 01 00 00 00 00", "43 57 1F 01 02 00 00 00");
  sut.ask("40 56 1F 01 00 00 00 00", "43 56 1F 01 00 00 00 00");
  sut.ask("40 51 1F 01 00 00 00 00", "4F 51 1F 01 00 00 00 00");
  EXPECT_FALSE(sut.programs.is_valid(1));
}

TEST_F(ProgramServerTest, StopClearDownloadAndStart) {
  ProgramNode sut(memory);
  sut.command(1, 0);
  sut.command(1, 3);
  EXPECT_EQ(sut.get(0x1F57), ok);
  const Bytes program{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(sut.download(program), 0x30U);
  EXPECT_EQ(sut.get(0x1F57), ok);
  sut.ask("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CB");
  sut.command(1, 1);
  sut.ask("40 51 1F 01 00 00 00 00", "4F 51 1F 01 01 00 00 00");
  EXPECT_EQ(sut.log, (Log{"stop 1", "begin", "end", "begin", "end", "start 1"}));
  EXPECT_EQ(kept(9), program);
  EXPECT_TRUE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, ProgramsOfEachLengthThatFits) {
  for (std::size_t size = 1; size <= 224; size += size < 70 ? 1 : 11) {
    ProgramNode sut(memory);
    sut.command(1, 3);
    ASSERT_NE(sut.download(a_program(size)), 0x80U) << size;
    ASSERT_EQ(kept(size), a_program(size));
    ASSERT_TRUE(is_valid_after_power_on()) << size;
  }
}

TEST_F(ProgramServerTest, TheIdentificationSurvivesPowerAndReset) {
  {
    ProgramNode sut(memory);
    sut.command(1, 3);
    sut.download({'1', '2', '3', '4', '5', '6', '7', '8', '9'});
  }
  ProgramNode again(memory);
  EXPECT_EQ(again.get(0x1F56), 0xCBF4'3926U);
  EXPECT_EQ(again.get(0x1F57), ok);
  again.receive("000#81 05");
  EXPECT_EQ(again.get(0x1F56), 0xCBF4'3926U);
  again.receive("000#82 05");
  EXPECT_EQ(again.get(0x1F56), 0xCBF4'3926U);
}

TEST_F(ProgramServerTest, DateAndTimeOfTheProgramAreKeptWithIt) {
  {
    ProgramNode sut(memory);
    sut.command(1, 3);
    sut.ask("23 52 1F 01 11 22 00 00", "60 52 1F 01 00 00 00 00");
    sut.ask("23 52 1F 02 33 44 55 00", "60 52 1F 02 00 00 00 00");
    sut.download(a_program(50));
  }
  ProgramNode again(memory);
  EXPECT_EQ(again.get(0x1F52, 1), 0x2211U);
  EXPECT_EQ(again.get(0x1F52, 2), 0x55'4433U);
  again.command(1, 3);
  again.receive("000#81 05");
  EXPECT_EQ(again.get(0x1F52, 1), 0U);
}

TEST_F(ProgramServerTest, ADownloadWithoutAClearingIsRefused) {
  ProgramNode sut(memory);
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 22 00 00 08");
  EXPECT_EQ(sut.get(0x1F57), not_cleared);
  EXPECT_EQ(memory.programmings, 0U);
}

TEST_F(ProgramServerTest, ASecondDownloadWantsAnotherClearing) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  EXPECT_NE(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.download(a_program(60)), 0x80U);
  EXPECT_EQ(sut.get(0x1F57), not_cleared);
  EXPECT_TRUE(sut.programs.is_valid(1)) << "the first one is as it was";
  EXPECT_TRUE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, AFlashThatIsBlankNeedsNoClearing) {
  SimulatedFlash blank(program_geometry);
  ProgramNode sut(blank);
  EXPECT_NE(sut.download(a_program(50)), 0x80U);
}

TEST_F(ProgramServerTest, ClearingGoesOnWhileTheStatusIsBusy) {
  memory.busy_polls = 20;
  ProgramNode sut(memory);
  sut.command(1, 3);
  EXPECT_EQ(sut.get(0x1F57), busy);
  sut.command(1, 3, false);
  sut.command(1, 1, false);
  EXPECT_EQ(sut.download(a_program(9)), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 22 00 00 08");
  sut.run_for(40ms - 1us);
  EXPECT_EQ(sut.get(0x1F57), busy) << "two sectors of 20 ms";
  sut.run_for(2ms);
  EXPECT_EQ(sut.get(0x1F57), ok);
  EXPECT_EQ(sut.log, (Log{"begin", "end"}));
}

TEST_F(ProgramServerTest, ARunningProgramIsNeitherClearedNorReplaced) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.download(a_program(50));
  sut.command(1, 1);
  sut.command(1, 3, false);
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 22 00 00 08");
  sut.command(1, 0);
  sut.command(1, 3);
  EXPECT_FALSE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, WhatIsNotValidIsNotStarted) {
  ProgramNode sut(memory);
  sut.command(1, 1, false);
  sut.command(1, 3);
  sut.command(1, 1, false);
  EXPECT_EQ(sut.log, (Log{"begin", "end"}));
}

TEST_F(ProgramServerTest, ResetIsTheDevicesWork) {
  ProgramNode sut(memory);
  sut.command(2, 2);
  EXPECT_EQ(sut.log, Log{"reset 2"});
}

TEST_F(ProgramServerTest, WhatTheDeviceRefusesIsRefused) {
  ProgramNode sut(memory);
  sut.control_answer = AbortCode::local_control;
  sut.ask("2F 51 1F 01 00 00 00 00", "80 51 1F 01 21 00 00 08");
}

TEST_F(ProgramServerTest, AProgramThatTheDeviceDoesNotStartDoesNotRun) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  EXPECT_NE(sut.download(a_program(50)), 0x80U);
  sut.control_answer = AbortCode::local_control;
  sut.ask("2F 51 1F 01 01 00 00 00", "80 51 1F 01 21 00 00 08");
  sut.ask("40 51 1F 01 00 00 00 00", "4F 51 1F 01 00 00 00 00");
  sut.control_answer = AbortCode::none;
  sut.command(1, 1);
  sut.control_answer = AbortCode::local_control;
  sut.ask("2F 51 1F 01 00 00 00 00", "80 51 1F 01 21 00 00 08");
  sut.ask("40 51 1F 01 00 00 00 00", "4F 51 1F 01 01 00 00 00");
}

/// A node with the objects of two programs, and the memory of one.
class OneSlotNode : public WireNode {
 public:
  explicit OneSlotNode(SimulatedFlash& memory)
      : WireNode(program_layout.tables(), 5), programs_(node, memory.flash, slots_) {
    boot();
  }

 private:
  std::array<ProgramSlot, 1> slots_{{{.address = 0, .size = 256}}};
  ProgramServer programs_;
  std::array<std::uint8_t, 16> buffer_{};
  SdoServer server_{node, 0, buffer_};
};

TEST_F(ProgramServerTest, AnEntryWithoutMemoryOfAProgramIsRefused) {
  OneSlotNode sut(memory);
  sut.receive("605#2F 51 1F 02 03 00 00 00");
  sut.expect({"585#80 51 1F 02 00 00 01 06"});
  sut.receive("605#21 50 1F 02 09 00 00 00");
  sut.expect({"585#80 50 1F 02 00 00 01 06"});
  EXPECT_EQ(memory.erasures + memory.programmings, 0U);
}

TEST_F(ProgramServerTest, AFlashThatCannotBeReadIsNotTakenForABlankOne) {
  SimulatedFlash blank(program_geometry);
  blank.fail_read = true;
  ProgramNode sut(blank);
  blank.fail_read = false;
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.get(0x1F57), not_cleared);
}

TEST_F(ProgramServerTest, AFlashThatDoesNotKeepAProgramIsAHardwareError) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  memory.fail_sync = 1;
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 00 00 06 06");
  EXPECT_EQ(sut.get(0x1F57), write_error);
  EXPECT_FALSE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, EveryOtherCommandIsOutOfRange) {
  ProgramNode sut(memory);
  for (unsigned command = 4; command < 256; ++command) {
    Frame request = wire_frame("605#2F 51 1F 01 00 00 00 00");
    request.data[4] = static_cast<std::uint8_t>(command);
    sut.receive(wire_text(request));
    sut.expect({"585#80 51 1F 01 30 00 09 06"});
  }
  EXPECT_EQ(sut.log, Log{});
}

TEST_F(ProgramServerTest, AProgramThatIsTooLongIsRefusedBeforeItIsSent) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.ask("21 50 1F 01 E1 00 00 00", "80 50 1F 01 12 00 07 06");
  EXPECT_NE(sut.download(a_program(224)), 0x80U) << "it is cleared still";
}

TEST_F(ProgramServerTest, AProgramThatDoesNotEndIsRefusedWhereItsPlaceDoes) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.ask("20 50 1F 01 00 00 00 00", "60 50 1F 01 00 00 00 00");
  for (int i = 0; i < 32; ++i) {
    const bool toggle = i % 2 != 0;
    sut.ask(std::string(toggle ? "10" : "00") + " 01 02 03 04 05 06 07",
            std::string(toggle ? "30" : "20") + " 00 00 00 00 00 00 00");
  }
  sut.ask("00 01 02 03 04 05 06 07", "80 50 1F 01 12 00 07 06");
  EXPECT_EQ(sut.get(0x1F57), no_valid_program);
  EXPECT_FALSE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, AnEmptyProgramIsNone) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  EXPECT_EQ(sut.download({}), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 13 00 07 06");
  EXPECT_EQ(sut.get(0x1F57), no_valid_program);
}

TEST_F(ProgramServerTest, ADownloadThatIsAbandonedLeavesNoProgram) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.ask("21 50 1F 01 40 00 00 00", "60 50 1F 01 00 00 00 00");
  EXPECT_EQ(sut.get(0x1F57), busy);
  sut.ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  sut.run_for(1s);
  sut.expect({"585#80 50 1F 01 00 00 04 05"});
  EXPECT_EQ(sut.get(0x1F57), no_valid_program);
  EXPECT_FALSE(is_valid_after_power_on());
  EXPECT_EQ(sut.log, (Log{"begin", "end", "begin", "end"}));
  sut.command(1, 3);
  EXPECT_NE(sut.download(a_program(50)), 0x80U);
}

TEST_F(ProgramServerTest, AProgramOfAnotherDeviceIsRefusedByWhoKnows) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.check_answer = FlashError::unknown_format;
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 20 00 00 08");
  EXPECT_EQ(sut.get(0x1F57), unknown_format);
  EXPECT_EQ(sut.get(0x1F56), 0U);
  EXPECT_FALSE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, AFlashThatFailsIsAHardwareErrorAndTheStatusSaysSo) {
  for (const unsigned failing : std::to_array<unsigned>({1, 2, 3})) {
    ProgramNode sut(memory);
    sut.command(1, 3);
    memory.fail_program = failing;
    EXPECT_EQ(sut.download(a_program(50)), 0x80U) << failing;
    EXPECT_EQ(sut.last_answer, "585#80 50 1F 01 00 00 06 06");
    EXPECT_EQ(sut.get(0x1F57), write_error);
    EXPECT_FALSE(is_valid_after_power_on());
  }
}

TEST_F(ProgramServerTest, AFlashThatKeepsSomethingElseIsFoundOut) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  memory.stuck_bit = true;
  EXPECT_EQ(sut.download(a_program(50)), 0x80U);
  EXPECT_EQ(sut.get(0x1F57), write_error);
  EXPECT_FALSE(is_valid_after_power_on());
}

TEST_F(ProgramServerTest, AClearingThatFailsIsTold) {
  memory.fail_erase = true;
  ProgramNode sut(memory);
  sut.command(1, 3);
  EXPECT_EQ(sut.get(0x1F57), write_error);
  EXPECT_EQ(sut.download(a_program(9)), 0x80U);
}

TEST_F(ProgramServerTest, ProgramsDoNotTouchEachOther) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.download(a_program(224, 1), 1);
  sut.command(2, 3);
  sut.download(a_program(224, 2), 2);
  EXPECT_TRUE(is_valid_after_power_on(1));
  EXPECT_TRUE(is_valid_after_power_on(2));
  sut.command(1, 3);
  EXPECT_FALSE(is_valid_after_power_on(1));
  EXPECT_TRUE(is_valid_after_power_on(2));
}

TEST_F(ProgramServerTest, EachBitOfAProgramCounts) {
  ProgramNode sut(memory);
  sut.command(1, 3);
  sut.download(a_program(40));
  for (std::size_t bit = 0; bit < std::size_t{8} * (32 + 40); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
    memory.bytes[bit / 8] ^= mask;
    ASSERT_FALSE(is_valid_after_power_on()) << bit;
    memory.bytes[bit / 8] ^= mask;
  }
  EXPECT_TRUE(is_valid_after_power_on());
}

/// Parameters that were stored at the place of a program are none, intact as they are.
TEST_F(ProgramServerTest, ARecordOfAnotherKindIsNoProgram) {
  {
    ProgramNode sut(memory);
    sut.command(1, 3);
    sut.download(a_program(40));
  }
  RecordHead::Bytes bytes;
  std::copy_n(memory.bytes.begin(), bytes.size(), bytes.begin());
  RecordHead head = *RecordHead::from(bytes);
  ++head.kind;
  std::ranges::copy(head.bytes(), memory.bytes.begin());
  EXPECT_FALSE(is_valid_after_power_on());
  --head.kind;
  std::ranges::copy(head.bytes(), memory.bytes.begin());
  EXPECT_TRUE(is_valid_after_power_on());
}

// Power fails at each byte of clearing and downloading: the old program, the new one, or none is
// present; never a part of one.
TEST_F(ProgramServerTest, ALossOfPowerNeverLeavesHalfAProgram) {
  const Bytes old = a_program(100, 1);
  const Bytes wanted = a_program(120, 2);
  SimulatedFlash before(program_geometry);
  {
    ProgramNode node(before);
    ASSERT_NE(node.download(old), 0x80U);
  }
  bool was_new = false;
  for (std::uint64_t cut = 0; !was_new; ++cut) {
    ASSERT_LT(cut, 1000U);
    for (const Tear tear : {Tear::nothing, Tear::some_bits}) {
      SimulatedFlash flash(program_geometry, before.bytes);
      {
        ProgramNode node(flash);
        flash.cut_after(cut, tear);
        node.command(1, 3);
        node.download(wanted);
      }
      SimulatedFlash later(program_geometry, flash.bytes);
      ProgramNode node(later);
      if (!node.programs.is_valid(1)) continue;
      const Bytes found(
          later.bytes.begin() + 32,
          later.bytes.begin() + 32 + static_cast<std::ptrdiff_t>(node.slots[0].length));
      ASSERT_TRUE(found == old || found == wanted) << cut;
      was_new = was_new || (found == wanted && tear == Tear::nothing);
    }
  }
}

}  // namespace
}  // namespace canvoy::program_server_test
