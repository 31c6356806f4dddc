// A device with one defect and a person at hand, and the expected result of its behaviour test.
//
//     expect_found({"lift-door", {"it does not stop", {"417-4-door-05"}, {}, lose_stop}});
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/text/check/testing/middle.hpp"
#include "canvoy/text/check/testing/workshop.hpp"

namespace canvoy::conformance {

/// The device with one defect.
struct BrokenDevice {
  std::string_view device;
  Way way;
};

/// Expects that the cases of a group that concern the defect fail, and no others.
inline void expect_found(const BrokenDevice& broken, std::string_view group = "behaviour") {
  Workshop workshop;
  const DeviceKind& kind = *find_device_kind(broken.device);
  CheckedDevice device(kind, workshop.environment);
  workshop.drive.connect(device.device());
  Middle middle(device);
  apply(device, middle, broken.way);
  Check check(device.line(), device.node(),
              {.moves = true, .profile = kind.profile, .hand = workshop.hands.answer()});
  const Report report = check.run({}, group);
  EXPECT_TRUE(report.is_whole) << broken.way.name;
  EXPECT_THAT(failures(report), ::testing::UnorderedElementsAreArray(broken.way.found_by))
      << broken.device << ": " << broken.way.name;
}

}  // namespace canvoy::conformance
