// A device whose program is downloaded passes the cases about it, and one with a defect is found
// (CiA 302-3, 1F50h and 1F51h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"

namespace canvoy::conformance::program_test {
namespace {

constexpr std::uint16_t program_data = 0x1F50;
constexpr std::uint16_t program_control = 0x1F51;

constexpr auto programmed_device =
    describe(cia301::device_type(0), cia301::error_register_object, cia301::identity({}),
             cia301::heartbeat_producer(0), cia302::programs(1));
constexpr auto programmed_layout = lay_out_device<programmed_device>();

/// A device with one program, which was downloaded and runs.
struct ProgrammedDevice {
  ProgrammedDevice() {
    on_line.start(device.node());
    Bench bench(on_line.line(), device.node().id(), {});
    constexpr std::uint8_t program[] = {8, 7, 6, 5, 4, 3, 2, 1, 0};
    EXPECT_TRUE(bench.write(program_control, 1, 3, 1)) << "clear";
    bench.listen(1s);
    EXPECT_TRUE(bench.write(program_data, 1, program));
    EXPECT_TRUE(bench.write(program_control, 1, 1, 1)) << "start";
  }
  Report check() {
    Check check(on_line.line(), device.node().id(), {});
    return check.run({}, "302-");
  }

  NodeOnLine on_line;
  DeviceNode<programmed_layout> device{on_line.port(), 5};
  SimulatedFlash memory{{.sector_size = 128, .sectors = 2, .unit = 8}};
  std::array<ProgramSlot, 1> slots{{{.address = 0, .size = 256}}};
  ProgramServer programs{device.node(), memory.flash, slots};
};

TEST(ProgramDownload, OfADeviceOfOursPasses) {
  ProgrammedDevice sut;
  const Report report = sut.check();
  ASSERT_TRUE(report.is_whole);
  EXPECT_THAT(failures(report), ::testing::IsEmpty());
  for (const TestResult& each : report.results) {
    if (!each.test->id.starts_with("302-program")) continue;
    EXPECT_EQ(each.verdict.outcome, Outcome::passed) << each.test->id << ": " << each.verdict.why;
  }
  EXPECT_TRUE(sut.programs.is_valid(1));
  EXPECT_EQ(sut.device.dictionary().number(program_control, 1), 1U) << "the program runs";
}

/// A segmented download of a program that the device takes, whatever it does with the bytes.
/// `count` is 1 from its first frame to its last.
bool swallow_program(Middle& middle, Frame& frame) {
  constexpr std::uint8_t with_size = 0x21;
  if (is_download(middle, frame, program_data) && frame.data[0] == with_size) {
    middle.count = 1;
    middle.add(middle.answers(), {0x60, 0x50, 0x1F, frame.data[3], 0, 0, 0, 0});
    return false;
  }
  const bool is_segment = frame.id == middle.requests() && (frame.data[0] & 0xE0) == 0;
  if (middle.count == 0 || !is_segment) return true;
  const auto toggle = static_cast<std::uint8_t>(frame.data[0] & 0x10U);
  middle.add(middle.answers(), {static_cast<std::uint8_t>(0x20U | toggle), 0, 0, 0, 0, 0, 0, 0});
  if ((frame.data[0] & 1U) != 0) middle.count = 0;
  return false;
}

std::vector<Way> program_ways() {
  return {
      {"it overwrites a program that runs", {"302-program-01"}, {}, swallow_program},
      {"it takes commands that are reserved",
       {"302-program-02"},
       [](Middle& middle, Frame& frame) {
         const bool is_refused = frame.id == middle.answers() && frame.data[0] == 0x80 &&
                                 index_of(frame) == program_control &&
                                 middle.last_request.data[4] > 3;
         if (is_refused) say_written(frame);
         return true;
       }},
      {"it refuses a command that is reserved, and stops its program",
       {"302-program-02"},
       [](Middle& middle, Frame& frame) {
         const bool is_stopped =
             is_upload(middle, frame, program_control) && frame.data[3] == 1 && middle.count != 0;
         if (is_stopped) frame.data[4] = 0;
         return true;
       },
       [](Middle& middle, Frame& frame) {
         if (is_download(middle, frame, program_control) && frame.data[4] > 3) middle.count = 1;
         return true;
       }},
  };
}

TEST(ProgramDownload, ThatIsBrokenIsFound) {
  for (const Way& way : program_ways()) {
    ProgrammedDevice sut;
    Middle middle(sut.on_line);
    apply(sut.on_line, middle, way);
    EXPECT_THAT(failures(sut.check()), ::testing::UnorderedElementsAreArray(way.found_by))
        << way.name;
  }
}

}  // namespace
}  // namespace canvoy::conformance::program_test

namespace canvoy::conformance {

std::vector<Way> program_ways() {
  return program_test::program_ways();
}

}  // namespace canvoy::conformance
