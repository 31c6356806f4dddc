// Non-volatile parameters: a device that stores and restores passes, and has its previous values
// stored afterwards; a device that does not is found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "canvoy/canopen/storage/storage.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"

namespace canvoy::conformance::kept_test {
namespace {

using ::testing::IsEmpty;

constexpr std::uint32_t slot = 16 * 1024;

/// A module of CiA 401 with a flash.
struct KeepingDevice {
  KeepingDevice() {
    environment.keeps_parameters = true;
    device.emplace(*find_device_kind("io-401"), environment, [this](Node& node) {
      storage.emplace(node, memory.flash, Storage::Settings{.slot_size = slot});
    });
  }
  Report check(const BenchOptions& options) {
    Check check(device->line(), device->node(), options);
    return check.run({}, "store-0");
  }
  /// 1017h after a simulated power cycle, by a reset of the node.
  std::uint32_t period_after_reset() {
    Bench bench(device->line(), device->node(), {});
    bench.command(NmtCommand::reset_node);
    bench.listen(1s);
    return bench.number(0x1017, 0).value_or(0);
  }

  Environment environment;
  SimulatedFlash memory{{.sector_size = 1024, .sectors = 2 * slot / 1024}};
  std::optional<Storage> storage;
  std::optional<CheckedDevice> device;
};

std::size_t passed(const Report& report) {
  return report.count(Outcome::passed);
}

TEST(KeptParameters, AreStoredAndRestoredByADeviceOfOurs) {
  KeepingDevice sut;
  const Report report = sut.check({.stores = true});
  EXPECT_THAT(failures(report), IsEmpty());
  EXPECT_EQ(passed(report), 7U) << "store-01 to store-07";
  EXPECT_THAT(report.notes, IsEmpty());
}

TEST(KeptParameters, AreStoredAfterwardsAsTheyWereBefore) {
  KeepingDevice sut;
  {
    Bench bench(sut.device->line(), sut.device->node(), {});
    ASSERT_TRUE(bench.write(0x1017, 0, 777, 2));
    ASSERT_TRUE(bench.write(0x1010, 1, save_signature, 4));
  }
  EXPECT_THAT(failures(sut.check({.stores = true})), IsEmpty());
  EXPECT_EQ(sut.period_after_reset(), 777U);
}

/// No byte of the flash changes.
TEST(KeptParameters, AreNotTouchedUnlessThatIsAllowed) {
  KeepingDevice sut;
  const SimulatedFlash::Bytes before = sut.memory.bytes;
  const Report report = sut.check({.moves = true});
  EXPECT_EQ(passed(report), 3U) << "store-01 to store-03";
  EXPECT_EQ(sut.memory.bytes, before);
}

bool is_signed_download(const Middle& middle, const Frame& frame, std::uint16_t index) {
  return frame.id == middle.requests() && frame.data[0] == 0x23 && index_of(frame) == index &&
         (frame.data[4] == 's' || frame.data[4] == 'l');
}
/// Confirms the write, without an effect.
bool pretends(Middle& middle, const Frame& frame, std::uint16_t index) {
  if (!is_signed_download(middle, frame, index)) return true;
  middle.add(middle.answers(), {0x60, frame.data[1], frame.data[2], frame.data[3], 0, 0, 0, 0});
  return false;
}

std::vector<Way> keeping_ways() {
  return {
      to_device("it says that it stores, and does not", {"store-04", "store-05"},
                [](Middle& middle, Frame& frame) { return pretends(middle, frame, 0x1010); }),
      to_device("it says that it restores, and does not", {"store-06"},
                [](Middle& middle, Frame& frame) { return pretends(middle, frame, 0x1011); }),
      {"it restores at once",
       {"store-07"},
       [](Middle& middle, Frame& frame) {
         // From a download of "load" to the reset, it reads the default.
         if (frame.id == middle.states() && frame.data[0] == 0) middle.count = 0;
         const bool is_period =
             frame.id == middle.answers() && frame.data[0] == 0x4B && index_of(frame) == 0x1017;
         if (is_period && middle.count != 0) frame.data[4] = frame.data[5] = 0;
         return true;
       },
       [](Middle& middle, Frame& frame) {
         if (is_signed_download(middle, frame, 0x1011)) middle.count = 1;
         return true;
       }},
      to_device("it aborts what has the right signature",
                {"store-04", "store-05", "store-06", "store-07"},
                [](Middle& middle, Frame& frame) {
                  if (!is_signed_download(middle, frame, 0x1010)) return true;
                  middle.add(middle.answers(), {0x80, 0x10, 0x10, frame.data[3], 0x20, 0, 0, 8});
                  return false;
                }),
  };
}

TEST(KeptParameters, OfBrokenDevicesAreFound) {
  for (const Way& way : keeping_ways()) {
    KeepingDevice sut;
    Middle middle(*sut.device);
    apply(*sut.device, middle, way);
    EXPECT_THAT(failures(sut.check({.stores = true})),
                ::testing::UnorderedElementsAreArray(way.found_by))
        << way.name;
  }
}

}  // namespace
}  // namespace canvoy::conformance::kept_test

namespace canvoy::conformance {

std::vector<Way> keeping_ways() {
  return kept_test::keeping_ways();
}

}  // namespace canvoy::conformance
