// Devices of lifts 2 to 8 (objects 800h apart, CiA 417-4, 4.1.1), and the predefined PDOs of a
// profile.
#include "canvoy/text/check/testing/broken_device.hpp"

namespace canvoy::conformance::lifts_test {
namespace {

/// The passed cases of a device of this lift (6001h).
std::vector<std::string> passed_in_lift(std::string_view name, unsigned lift,
                                        std::string_view group) {
  Workshop workshop;
  const DeviceKind& kind = *find_device_kind(name);
  CheckedDevice device(kind, workshop.environment);
  workshop.drive.connect(device.device());
  Bench bench(device.line(), device.node(), {});
  EXPECT_TRUE(bench.write(0x6001, 0, 1U << (lift - 1), 1));
  Check check(device.line(), device.node(),
              {.moves = true, .profile = kind.profile, .hand = workshop.hands.answer()});
  const Report report = check.run({}, group);
  EXPECT_THAT(failures(report), ::testing::IsEmpty()) << name << " of lift " << lift;
  std::vector<std::string> ids;
  for (const TestResult& each : report.results) {
    // A reset makes it a device of lift 1 again.
    if (each.test->id.ends_with("-default")) continue;
    if (each.verdict.outcome == Outcome::passed) ids.push_back(each.test->id);
  }
  return ids;
}

constexpr std::string_view units[] = {"lift-door", "lift-load", "lift-position", "lift-drive",
                                      "lift-light-barrier"};

/// Each lift passes the same cases.
TEST(CheckOfALift, TriesWhatADeviceDoesInItsLift) {
  for (const std::string_view unit : units) {
    const std::vector<std::string> in_lift_1 = passed_in_lift(unit, 1, "behaviour");
    EXPECT_GE(in_lift_1.size(), 3U) << unit;
    for (const unsigned lift : {2U, 5U, 8U}) {
      EXPECT_EQ(passed_in_lift(unit, lift, "behaviour"), in_lift_1) << unit << " of lift " << lift;
    }
  }
}
TEST(CheckOfALift, TriesTheObjectsAndPdosOfADeviceInItsLift) {
  for (const std::string_view unit : units) {
    const std::vector<std::string> in_lift_1 = passed_in_lift(unit, 1, "profile");
    EXPECT_GE(in_lift_1.size(), 5U) << unit;
    // Light barrier 4 of lift 8 has no PDO number.
    for (const unsigned lift : {2U, 7U}) {
      EXPECT_EQ(passed_in_lift(unit, lift, "profile"), in_lift_1) << unit << " of lift " << lift;
    }
  }
}

Way other_byte(std::string_view name, std::string_view found_by, std::uint16_t index,
               std::uint8_t sub, unsigned byte, std::uint8_t bits) {
  return {name, {found_by}, [index, sub, byte, bits](Middle& middle, Frame& frame) {
            if (is_upload(middle, frame, index) && frame.data[3] == sub) frame.data[byte] ^= bits;
            return true;
          }};
}

/// TPDO 259 of a load measuring unit: 188h, on events, with 6482h:01h (CiA 417-3, of public
/// sources).
TEST(CheckOfPdos, FindsWhatIsNotAsTheProfilePrintsIt) {
  expect_found({"lift-load", other_byte("its PDO has another CAN-ID", "417-4-tpdo-259-can-id",
                                        0x1902, 1, 4, 0x01)},
               "profile");
  expect_found({"lift-load", other_byte("its PDO has a synchronous type", "417-4-tpdo-259-type",
                                        0x1902, 2, 4, 0xF0)},
               "417-4-tpdo-259");
  expect_found({"lift-door", other_byte("it maps another object behind its state",
                                        "417-4-tpdo-267-mapping", 0x1B0A, 2, 6, 0x01)},
               "profile");
}

}  // namespace
}  // namespace canvoy::conformance::lifts_test
