// Program download, client (CiA 302-3, objects 1F50h to 1F57h).
#include "canvoy/canopen/manager/program_download.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/canopen/testing/program_objects.hpp"

namespace canvoy::program_download_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A program in memory.
struct Image {
  explicit Image(Bytes content) : bytes(std::move(content)) {}
  Result<std::size_t> next(std::span<std::uint8_t> place) {
    const std::size_t size = std::min(place.size(), bytes.size() - at);
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, place.begin());
    at += size;
    return size;
  }
  ProgramPlan plan(NodeId server) {
    return {.server = server,
            .supply = SdoClient::Supply::to<&Image::next>(*this),
            .size = static_cast<std::uint32_t>(bytes.size())};
  }
  Bytes bytes;
  std::size_t at = 0;
};

/// Records the outcome.
struct Outcome {
  ProgramDownload::Done done() { return ProgramDownload::Done::to<&Outcome::take>(*this); }
  void take(const ProgramOutcome& outcome) {
    ++calls;
    last = outcome;
  }
  int calls = 0;
  ProgramOutcome last{.step = ProgramStep::stop};
};

/// The client alone: the test is the node being programmed.
class ProgramDownloadTest : public testing::Test {
 protected:
  ProgramDownloadTest() { wire.boot(); }

  void begin(const ProgramPlan& plan) {
    wire.node.advance(wire.now);
    ASSERT_EQ(sut.begin(plan, outcome.done()), AbortCode::none);
  }
  /// Checks the next request, and sends the answer to it.
  void answer(const std::string& request, const std::string& response) {
    wire.expect({"605#" + request});
    wire.receive("585#" + response);
  }
  void up_to_download() {
    answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
    answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 00 00 00 00");
  }
  void send_nine_bytes() {
    answer("21 50 1F 01 09 00 00 00", "60 50 1F 01 00 00 00 00");
    answer("00 31 32 33 34 35 36 37", "20 00 00 00 00 00 00 00");
    answer("1B 38 39 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  }
  void up_to_programmed() {
    up_to_download();
    send_nine_bytes();
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 00 00 00 00");
  }
  void expect_end(ProgramStep step, SdoEnd end = {}, FlashError error = FlashError::none) {
    EXPECT_EQ(outcome.calls, 1);
    EXPECT_EQ(outcome.last.step, step);
    EXPECT_EQ(outcome.last.end, end);
    EXPECT_EQ(outcome.last.status.error(), error);
    EXPECT_FALSE(sut.busy());
    wire.expect({});
  }

  WireNode wire{DictionaryTables{}, 1};
  SdoClient client{wire.node};
  ProgramDownload sut{wire.node, client};
  Image image{Bytes{'1', '2', '3', '4', '5', '6', '7', '8', '9'}};
  Outcome outcome;
};

TEST_F(ProgramDownloadTest, CountsTheBytesThatItHasSent) {
  EXPECT_EQ(sut.transferred(), 0U);
  begin(image.plan(5));
  EXPECT_EQ(sut.transferred(), 0U) << "a stop is no program";
  up_to_download();
  send_nine_bytes();
  EXPECT_EQ(sut.step(), ProgramStep::wait_programmed);
  EXPECT_EQ(sut.transferred(), 9U);
}

TEST_F(ProgramDownloadTest, StopsClearsDownloadsLooksAndStarts) {
  begin(image.plan(5));
  up_to_programmed();
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end(ProgramStep::done);
  EXPECT_TRUE(outcome.last);
}

TEST_F(ProgramDownloadTest, TheNumberOfTheProgramIsTheSubIndex) {
  ProgramPlan plan = image.plan(5);
  plan.number = 3;
  plan.start = false;
  begin(plan);
  answer("2F 51 1F 03 00 00 00 00", "60 51 1F 03 00 00 00 00");
  answer("2F 51 1F 03 03 00 00 00", "60 51 1F 03 00 00 00 00");
  answer("40 57 1F 03 00 00 00 00", "43 57 1F 03 00 00 00 00");
  answer("21 50 1F 03 09 00 00 00", "60 50 1F 03 00 00 00 00");
}

TEST_F(ProgramDownloadTest, ABusyFlashIsAskedEachTenthOfASecond) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  for (int i = 0; i < 5; ++i) {
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 01 00 00 00");
    wire.run_for(100ms - 1us);
    wire.expect({});
    wire.run_for(1us);
  }
  answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 00 00 00 00");
  wire.expect({"605#21 50 1F 01 09 00 00 00"});
}

TEST_F(ProgramDownloadTest, AFlashThatStaysBusyForAMinuteIsGivenUp) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  const Time begun = wire.now;
  while (sut.busy()) {
    answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 01 00 00 00");
    if (sut.busy()) wire.run_for(100ms);
  }
  EXPECT_EQ(wire.now - begun, 60s);
  EXPECT_TRUE(outcome.last.end.is_silence());
  EXPECT_EQ(outcome.last.step, ProgramStep::wait_cleared);
}

TEST_F(ProgramDownloadTest, NoValidProgramIsNoErrorAfterClearing) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 02 00 00 00");
  wire.expect({"605#21 50 1F 01 09 00 00 00"});
}

TEST_F(ProgramDownloadTest, EachErrorOfTheFlashEndsItAndIsTold) {
  for (const FlashError error :
       {FlashError::no_valid_program, FlashError::unknown_format, FlashError::checksum,
        FlashError::not_cleared, FlashError::write_error, FlashError::address_error,
        FlashError::secured, FlashError::unspecified}) {
    outcome = {};
    image.at = 0;
    begin(image.plan(5));
    up_to_download();
    send_nine_bytes();
    wire.sent.clear();
    Frame status = wire_frame("585#43 57 1F 01 00 00 34 12");
    status.data[4] = static_cast<std::uint8_t>(static_cast<unsigned>(error) << 1);
    wire.receive(wire_text(status));
    expect_end(ProgramStep::wait_programmed, AbortCode::none, error);
    EXPECT_EQ(outcome.last.status.manufacturer(), 0x1234);
  }
}

TEST_F(ProgramDownloadTest, ANodeWithoutAFlashStatusIsNotAskedForIt) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("40 57 1F 01 00 00 00 00", "80 57 1F 01 00 00 02 06");
  send_nine_bytes();
  answer("40 57 1F 01 00 00 00 00", "80 57 1F 01 11 00 09 06");
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end(ProgramStep::done);
}

TEST_F(ProgramDownloadTest, AnAbortEndsItWhereItComes) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "80 51 1F 01 00 00 02 06");
  expect_end(ProgramStep::stop, SdoEnd::by_server(AbortCode::no_object));

  outcome = {};
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "80 51 1F 01 22 00 00 08");
  expect_end(ProgramStep::clear, SdoEnd::by_server(AbortCode::device_state));

  outcome = {};
  begin(image.plan(5));
  up_to_download();
  answer("21 50 1F 01 09 00 00 00", "80 50 1F 01 12 00 07 06");
  expect_end(ProgramStep::download, SdoEnd::by_server(AbortCode::length_too_high));
}

/// It is present, and does not restart with its bootloader.
TEST_F(ProgramDownloadTest, ATimeOutThatTheNodeTellsEndsItAsOtherAbortsDo) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "80 51 1F 01 00 00 04 05");
  expect_end(ProgramStep::stop, SdoEnd::by_server(AbortCode::time_out));
}

TEST_F(ProgramDownloadTest, AnAbortOfTheStartEndsIt) {
  begin(image.plan(5));
  up_to_programmed();
  answer("2F 51 1F 01 01 00 00 00", "80 51 1F 01 22 00 00 08");
  expect_end(ProgramStep::start, SdoEnd::by_server(AbortCode::device_state));
}

TEST_F(ProgramDownloadTest, ANodeThatIsGoneWithItsNewProgramWasStarted) {
  begin(image.plan(5));
  up_to_programmed();
  wire.run_for(1s);
  wire.expect({"605#2F 51 1F 01 01 00 00 00", "605#80 51 1F 01 00 00 04 05"});
  expect_end(ProgramStep::done);
}

TEST_F(ProgramDownloadTest, ANodeThatRestartsWithItsBootloaderIsWaitedFor) {
  begin(image.plan(5));
  wire.run_for(4500ms);
  EXPECT_EQ(wire.sent.size(), 9U) << "stop, and clear each second; four were given up";
  wire.sent.clear();
  wire.receive("585#60 51 1F 01 00 00 00 00");
  wire.expect({"605#40 57 1F 01 00 00 00 00"});
}

TEST_F(ProgramDownloadTest, ANodeThatIsNotThereIsGivenUpAfterElevenSeconds) {
  begin(image.plan(5));
  wire.run_for(11s - 1us);
  EXPECT_TRUE(sut.busy());
  wire.run_for(1us);
  wire.sent.clear();
  expect_end(ProgramStep::clear, SdoEnd::no_answer());
}

TEST_F(ProgramDownloadTest, ANodeMayClearBeforeItAnswers) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  wire.run_for(29s);
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  EXPECT_EQ(sut.step(), ProgramStep::wait_cleared);
}

TEST_F(ProgramDownloadTest, DateAndTimeAreWrittenBeforeTheProgram) {
  ProgramPlan plan = image.plan(5);
  plan.date = {{0x3C98, 0x0012'D687}};
  begin(plan);
  up_to_download();
  answer("23 52 1F 01 98 3C 00 00", "60 52 1F 01 00 00 00 00");
  answer("23 52 1F 02 87 D6 12 00", "60 52 1F 02 00 00 00 00");
  wire.expect({"605#21 50 1F 01 09 00 00 00"});
}

TEST_F(ProgramDownloadTest, ANodeThatTakesNoDateIsFine) {
  ProgramPlan plan = image.plan(5);
  plan.date = {{1, 2}};
  begin(plan);
  up_to_download();
  answer("23 52 1F 01 01 00 00 00", "80 52 1F 01 02 00 01 06");
  wire.expect({"605#21 50 1F 01 09 00 00 00"});
}

TEST_F(ProgramDownloadTest, TheIdentificationIsCompared) {
  ProgramPlan plan = image.plan(5);
  plan.identification = 0xCBF4'3926;
  begin(plan);
  up_to_programmed();
  answer("40 56 1F 01 00 00 00 00", "43 56 1F 01 26 39 F4 CC");
  expect_end(ProgramStep::identify, AbortCode::none, FlashError::checksum);
}

TEST_F(ProgramDownloadTest, ANodeWithoutAnIdentificationIsNotCompared) {
  ProgramPlan plan = image.plan(5);
  plan.identification = 0xCBF4'3926;
  begin(plan);
  up_to_programmed();
  answer("40 56 1F 01 00 00 00 00", "80 56 1F 01 00 00 02 06");
  answer("2F 51 1F 01 01 00 00 00", "60 51 1F 01 00 00 00 00");
  expect_end(ProgramStep::done);
}

TEST_F(ProgramDownloadTest, WhatCannotBeReadOfTheResultEndsIt) {
  ProgramPlan plan = image.plan(5);
  plan.identification = 0xCBF4'3926;
  begin(plan);
  up_to_programmed();
  answer("40 56 1F 01 00 00 00 00", "80 56 1F 01 00 00 06 06");
  expect_end(ProgramStep::identify, SdoEnd::by_server(AbortCode::hardware));

  outcome = {};
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("40 57 1F 01 00 00 00 00", "80 57 1F 01 00 00 06 06");
  expect_end(ProgramStep::wait_cleared, SdoEnd::by_server(AbortCode::hardware));
}

TEST_F(ProgramDownloadTest, WithoutAStartItEndsBehindTheProgramming) {
  ProgramPlan plan = image.plan(5);
  plan.start = false;
  begin(plan);
  up_to_programmed();
  expect_end(ProgramStep::done);
}

TEST_F(ProgramDownloadTest, ANodeThatWasStoppedAndFallsSilentIsGivenUp) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  wire.run_for(1min);
  wire.expect({"605#2F 51 1F 01 03 00 00 00", "605#80 51 1F 01 00 00 04 05"});
  expect_end(ProgramStep::clear, SdoEnd::no_answer());

  outcome = {};
  ProgramPlan dated = image.plan(5);
  dated.date = {{0x3C98, 0x0012'D687}};
  begin(dated);
  up_to_download();
  wire.run_for(1min);
  wire.expect({"605#23 52 1F 01 98 3C 00 00", "605#80 52 1F 01 00 00 04 05"});
  expect_end(ProgramStep::date, SdoEnd::no_answer());
}

TEST_F(ProgramDownloadTest, CountsTheBytesWhileTheyAreSent) {
  begin(image.plan(5));
  up_to_download();
  answer("21 50 1F 01 09 00 00 00", "60 50 1F 01 00 00 00 00");
  answer("00 31 32 33 34 35 36 37", "20 00 00 00 00 00 00 00");
  EXPECT_GE(sut.transferred(), 7U);
  EXPECT_LE(sut.transferred(), 9U);
}

TEST_F(ProgramDownloadTest, OneThatIsCancelledBetweenTwoLooksSendsNothingMore) {
  begin(image.plan(5));
  answer("2F 51 1F 01 00 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
  answer("40 57 1F 01 00 00 00 00", "43 57 1F 01 01 00 00 00");  // busy
  sut.cancel();
  wire.run_for(10s);
  wire.expect({});
  EXPECT_EQ(outcome.calls, 0);
  EXPECT_FALSE(sut.busy());
}

TEST_F(ProgramDownloadTest, OneThatIsCancelledTellsNobody) {
  begin(image.plan(5));
  up_to_download();
  sut.cancel();
  wire.expect({"605#21 50 1F 01 09 00 00 00", "605#80 50 1F 01 00 00 00 08"});
  wire.run_for(10s);
  EXPECT_EQ(outcome.calls, 0);
  EXPECT_FALSE(sut.busy());
}

TEST_F(ProgramDownloadTest, OneAtATime) {
  begin(image.plan(5));
  EXPECT_EQ(sut.begin(image.plan(6), outcome.done()), AbortCode::device_state);
}

TEST_F(ProgramDownloadTest, ANodeIdThatThereIsNotIsRefusedAtOnce) {
  EXPECT_EQ(sut.begin(image.plan(0), outcome.done()), AbortCode::no_sdo_connection);
  EXPECT_FALSE(sut.busy());
}

/// Client and server on one cable.
class ProgramTransfer : public testing::Test {
 protected:
  static constexpr SimulatedFlash::Geometry geometry{
      .sector_size = 4096, .sectors = 26, .unit = 32};

  ProgramTransfer() {
    cable.connect(0, master);
    cable.connect(1, device);
    cable.start_all();
  }
  ProgramOutcome run(const ProgramPlan& plan) {
    master.advance(cable.now);
    EXPECT_EQ(download.begin(plan, outcome.done()), AbortCode::none);
    for (int i = 0; download.busy() && i < 20'000; ++i) cable.run_for(10ms);
    EXPECT_EQ(outcome.calls, 1);
    return outcome.last;
  }
  static Bytes program(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 251);
    return bytes;
  }

  Cable cable;
  WireMemory master_memory{DictionaryTables{}};
  DictionaryTables no_tables;
  Node master{no_tables, master_memory.spans(), cable.port(0), 1};
  SdoClient client{master};
  std::array<std::uint8_t, SdoBlockClient::buffer_size> block_buffer{};
  SdoBlockClient blocks{client, block_buffer};
  ProgramDownload download{master, client};

  SimulatedFlash memory{geometry};
  DictionaryTables device_tables = program_layout.tables();
  WireMemory device_memory{device_tables};
  Node device{device_tables, device_memory.spans(), cable.port(1), 5};
  std::array<std::uint8_t, 16> server_buffer{};
  SdoServer server{device, 0, server_buffer};
  SdoBlockServer block_server{server};
  std::array<ProgramSlot, 1> slots{{{.address = 0, .size = 26 * 4096}}};
  ProgramServer programs{device, memory.flash, slots};
  Outcome outcome;
};

TEST_F(ProgramTransfer, AHundredThousandBytesGoInBlocksAndAreWhole) {
  memory.busy_polls = 20;
  Image image(program(100'000));
  ProgramPlan plan = image.plan(5);
  plan.identification = crc32(image.bytes);
  EXPECT_TRUE(run(plan));
  EXPECT_TRUE(std::equal(image.bytes.begin(), image.bytes.end(), memory.bytes.begin() + 32));
  EXPECT_TRUE(programs.is_valid(1));
  EXPECT_TRUE(slots[0].running);
  EXPECT_LT(cable.count(0x585), 500U) << "blocks, not segments";
}

TEST_F(ProgramTransfer, FramesThatAreLostDoNotHarm) {
  Image image(program(5'000));
  int number = 0;
  cable.filter = [&](const Frame& frame) { return frame.id != 0x605 || ++number % 97 != 50; };
  ProgramPlan plan = image.plan(5);
  plan.identification = crc32(image.bytes);
  const ProgramOutcome ended = run(plan);
  if (ended) {
    EXPECT_TRUE(std::equal(image.bytes.begin(), image.bytes.end(), memory.bytes.begin() + 32));
  } else {
    EXPECT_EQ(ended.end.abort(), AbortCode::time_out) << "of one side or the other";
  }
  EXPECT_EQ(static_cast<bool>(ended), programs.is_valid(1) && slots[0].running);
}

TEST_F(ProgramTransfer, ANodeThatIsCutOffInTheMiddleHasNoProgram) {
  Image image(program(50'000));
  master.advance(cable.now);
  ASSERT_EQ(download.begin(image.plan(5), outcome.done()), AbortCode::none);
  int number = 0;
  cable.filter = [&](const Frame& frame) { return frame.id != 0x605 || ++number < 2'000; };
  for (int i = 0; download.busy() && i < 1'000; ++i) cable.run_for(100ms);
  EXPECT_EQ(outcome.last.step, ProgramStep::download);
  EXPECT_EQ(outcome.last.end, SdoEnd::by_server(AbortCode::time_out))
      << "it hears nothing any more, and says so";
  cable.run_for(10s);
  EXPECT_FALSE(programs.is_valid(1));
  EXPECT_EQ(device.dictionary().number(0x1F57, 1), 2U);
}

}  // namespace
}  // namespace canvoy::program_download_test
