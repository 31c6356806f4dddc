// The check of a slave's program in the boot-up procedure (CiA 302-2, letters G, H and I).
#include "canvoy/canopen/manager/program_manager.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::program_manager_test {
namespace {

constexpr EntryRow count_row{.access = Access::const_, .initial = 127};
constexpr EntryRow slave_row{
    .sub_first = 1, .sub_last = 127, .type = DataType::unsigned32, .access = Access::rw};
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1F53, .count = 3, .entry_count = 2},
                                      {.index = 0x1F81, .entry_count = 2}}),
            std::to_array<EntryRow>({count_row, slave_row, count_row, slave_row}));

constexpr std::uint32_t checked_only = 0x25;
constexpr std::uint32_t may_be_updated = 0x65;

/// A manager with a boot task for slave 5, and the program "123456789" for it.
class ProgramManagerTest : public testing::Test {
 protected:
  ProgramManagerTest() {
    wire.boot();
    set(0x1F81, may_be_updated);
    hooks.abandon = callback<&ProgramManagerTest::told>(*this);
    sut.serve(hooks);
    sut.on_update(callback<&ProgramManagerTest::updated>(*this));
  }
  void set(std::uint16_t index, std::uint32_t value) {
    wire.node.dictionary().set_number(index, 5, value);
  }
  BootTask task() { return {5, &client, callback<&ProgramManagerTest::done>(*this)}; }
  void boot() {
    wire.node.advance(wire.now);
    hooks.update_program(task());
  }
  void answer(const std::string& request, const std::string& response) {
    wire.expect({"605#" + request});
    wire.receive("585#" + response);
  }
  void download() {
    answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
    answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 00 00 00 00");
  }
  void send_nine_bytes() {
    answer("21 50 1F 01 09 00 00 00", "60 50 1F 01 00 00 00 00");
    answer("00 31 32 33 34 35 36 37", "20 00 00 00 00 00 00 00");
    answer("1B 38 39 00 00 00 00 00", "30 00 00 00 00 00 00 00");
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 00 00 00 00");
  }
  void expect_end(char expected, SdoEnd end = {}) {
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(letter(last.error), expected);
    EXPECT_EQ(last.end, end);
    wire.expect({});
  }
  void done(BootOutcome outcome) {
    ++ends;
    last = outcome;
  }
  void told(NodeId slave) { abandoned = slave; }
  void updated(NodeId slave, const ProgramOutcome& outcome) {
    EXPECT_EQ(slave, 5);
    EXPECT_EQ(ends, 0) << "the boot-up goes on when it is told";
    updates.push_back(outcome);
    if (abandons) hooks.abandon(slave);
  }
  Result<std::uint32_t> open(NodeId slave) {
    EXPECT_EQ(slave, 5);
    if (size == 0 && !is_empty) return AbortCode::no_data;
    return size;
  }
  AbortCode read(NodeId, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>('1' + offset++);
    return read_answer;
  }

  WireNode wire{layout.tables(), 127};
  SdoClient client{wire.node};
  ProgramManager::Worker workers[1]{ProgramManager::Worker(wire.node)};
  ProgramManager sut{workers,
                     {.open = callback<&ProgramManagerTest::open>(*this),
                      .read = callback<&ProgramManagerTest::read>(*this)}};
  BootHooks hooks;
  std::uint32_t size = 9;
  int ends = 0;
  std::vector<ProgramOutcome> updates;
  BootOutcome last{BootError::no_answer, AbortCode::general};
  NodeId abandoned = 0;
  bool is_empty = false;  ///< there is a program, of no bytes
  AbortCode read_answer = AbortCode::none;
  bool abandons = false;  ///< in the report of an update
};

TEST_F(ProgramManagerTest, ASlaveWithTheExpectedIdentificationIsFine) {
  set(0x1F55, 0xCBF4'3926);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CB");
  expect_end('-');
}

TEST_F(ProgramManagerTest, ASlaveWithTheExpectedDateAndTimeIsFine) {
  set(0x1F53, 0x3C98);
  set(0x1F54, 0x0012'D687);
  boot();
  answer("40 52 1F 01 00 00 00 00", "43 52 1F 01 98 3C 00 00");
  answer("40 52 1F 02 00 00 00 00", "43 52 1F 02 87 D6 12 00");
  expect_end('-');
}

TEST_F(ProgramManagerTest, WhereNothingIsExpectedItEndsWithG) {
  boot();
  expect_end('G');
}

TEST_F(ProgramManagerTest, ASlaveWithoutTheObjectEndsWithG) {
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "80 56 1F 01 00 00 02 06");
  expect_end('G', SdoEnd::by_server(AbortCode::no_object));
}

TEST_F(ProgramManagerTest, ASlaveThatDoesNotAnswerEndsWithG) {
  set(0x1F55, 1);
  boot();
  wire.run_for(1s);
  wire.expect({"605#40 56 1F 01 00 00 00 00", "605#80 56 1F 01 00 00 04 05"});
  expect_end('G', SdoEnd::no_answer());
}

TEST_F(ProgramManagerTest, AnUpdateThatIsNotAllowedEndsWithH) {
  set(0x1F81, checked_only);
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  expect_end('H');
}

TEST_F(ProgramManagerTest, AnUpdateForWhichThereIsNoProgramEndsWithG) {
  size = 0;
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  expect_end('G', AbortCode::no_data);
}

TEST_F(ProgramManagerTest, AnUpdateByAProgramOfNoBytesEndsWithG) {
  size = 0;
  is_empty = true;
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  expect_end('G', AbortCode::no_data);
}

TEST_F(ProgramManagerTest, AProgramThatCannotBeReadEndsWithI) {
  read_answer = AbortCode::hardware;
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  download();
  answer("21 50 1F 01 09 00 00 00", "60 50 1F 01 00 00 00 00");
  wire.expect({"605#80 50 1F 01 00 00 06 06"});
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(letter(last.error), 'I');
  EXPECT_EQ(last.end.abort(), AbortCode::hardware);
}

TEST_F(ProgramManagerTest, ASlaveWhoseClientIsBusyEndsWithG) {
  set(0x1F55, 1);
  std::array<std::uint8_t, 4> value{};
  ASSERT_EQ(client.upload(5, 0x1000, 0, std::span<std::uint8_t>(value), {}), AbortCode::none);
  wire.sent.clear();
  boot();
  expect_end('G', AbortCode::device_state);
}

TEST_F(ProgramManagerTest, ATimeOfDayAloneIsExpectedAsWell) {
  set(0x1F54, 0x0012'D687);
  boot();
  answer("40 52 1F 02 00 00 00 00", "43 52 1F 02 86 D6 12 00");
  download();
  answer("23 52 1F 01 00 00 00 00", "60 52 1F 01 00 00 00 00");
  answer("23 52 1F 02 87 D6 12 00", "60 52 1F 02 00 00 00 00");
  send_nine_bytes();
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end('-');
}

TEST_F(ProgramManagerTest, ASlaveWithAnotherProgramIsUpdatedAndVerified) {
  set(0x1F55, 0xCBF4'3926);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 00 00 00 00");
  download();
  send_nine_bytes();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CB");
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end('-');
}

TEST_F(ProgramManagerTest, ASlaveThatIsAbandonedByWhoIsToldOfItsUpdateIsNotBootedOn) {
  abandons = true;
  set(0x1F55, 0xCBF4'3926);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 00 00 00 00");
  download();
  answer("21 50 1F 01 09 00 00 00", "80 50 1F 01 21 00 00 08");
  EXPECT_EQ(updates.size(), 1U);
  EXPECT_EQ(ends, 0);
  abandons = false;
  set(0x1F55, 0);
  boot();
  expect_end('G');
}

TEST_F(ProgramManagerTest, TellsHowAnUpdateEnded) {
  set(0x1F55, 0xCBF4'3926);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CB");
  EXPECT_TRUE(updates.empty()) << "there was none";
  ends = 0;
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 00 00 00 00");
  download();
  answer("21 50 1F 01 09 00 00 00", "80 50 1F 01 21 00 00 08");
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates[0].step, ProgramStep::download);
  EXPECT_EQ(updates[0].end, SdoEnd::by_server(AbortCode{0x0800'0021}));
}

TEST_F(ProgramManagerTest, DateAndTimeOfAnUpdateAreThoseExpected) {
  set(0x1F53, 0x3C98);
  boot();
  answer("40 52 1F 01 00 00 00 00", "43 52 1F 01 97 3C 00 00");
  download();
  answer("23 52 1F 01 98 3C 00 00", "60 52 1F 01 00 00 00 00");
  answer("23 52 1F 02 00 00 00 00", "60 52 1F 02 00 00 00 00");
  send_nine_bytes();
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end('-');
}

TEST_F(ProgramManagerTest, AnUpdateThatFailsEndsWithI) {
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  answer("2F 51 1F 01 00 00 00 00", "80 51 1F 01 22 00 00 08");
  expect_end('I', SdoEnd::by_server(AbortCode::device_state));
}

TEST_F(ProgramManagerTest, AnUpdateThatTheSlaveDoesNotTakeEndsWithI) {
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  download();
  answer("21 50 1F 01 09 00 00 00", "60 50 1F 01 00 00 00 00");
  answer("00 31 32 33 34 35 36 37", "20 00 00 00 00 00 00 00");
  answer("1B 38 39 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 06 00 00 00");
  expect_end('I', AbortCode::cannot_store);
}

TEST_F(ProgramManagerTest, ASlaveThatIsAbandonedIsForgottenAndOthersAreTold) {
  set(0x1F55, 1);
  boot();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 02 00 00 00");
  wire.sent.clear();
  client.cancel();
  wire.sent.clear();
  hooks.abandon(5);
  EXPECT_EQ(abandoned, 5);
  wire.run_for(1min);
  EXPECT_EQ(ends, 0);
  wire.expect({});
  boot();
  wire.expect({"605#40 56 1F 01 00 00 00 00"});
}

TEST_F(ProgramManagerTest, OfASlaveThatIsAbandonedNoOtherOneIsForgotten) {
  set(0x1F55, 0xCBF4'3926);
  boot();
  hooks.abandon(6);
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CB");
  expect_end('-');
}

TEST_F(ProgramManagerTest, MoreSlavesThanWorkersEndWithI) {
  set(0x1F55, 1);
  boot();
  wire.sent.clear();
  boot();
  expect_end('I', AbortCode::out_of_memory);
}

}  // namespace
}  // namespace canvoy::program_manager_test
