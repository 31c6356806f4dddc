// Values of CiA 417-4 that depend on others. canvoy/profiles/clauses/417-4.txt has the meaning of
// each.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/testing/words.hpp"

namespace canvoy::cia417_values_test {
namespace {

/// Position, speed and acceleration of each unit are counted in the steps of its own object
/// (errata A19).
TEST(Cia417, MeasuringStepsAreThoseOfTheSamePositionUnit) {
  constexpr unsigned measured[][2] = {{0x6383, 1}, {0x6390, 2}, {0x6391, 3}};
  for (const auto& [index, step_sub] : measured) {
    for (unsigned unit = 1; unit <= 4; ++unit) {
      const StepEntry step = entry_at(cia417::profile, index, unit).value.step;
      EXPECT_EQ(step.index, 0x6383 + unit);
      EXPECT_EQ(step.sub, step_sub);
    }
  }
}

TEST(Cia417, TheStateOfTheDriveIsInBits0To3And5And6) {
  using cia417::DriveState;
  EXPECT_EQ(cia417::drive_state(0x0000), DriveState::not_ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0020), DriveState::not_ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0240), DriveState::switch_on_disabled);
  EXPECT_EQ(cia417::drive_state(0x0260), DriveState::switch_on_disabled);
  EXPECT_EQ(cia417::drive_state(0x0231), DriveState::ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0233), DriveState::switched_on);
  EXPECT_EQ(cia417::drive_state(0x0637), DriveState::operation_enabled);
  EXPECT_EQ(cia417::drive_state(0x0217), DriveState::quick_stop_active);
  EXPECT_EQ(cia417::drive_state(0x021F), DriveState::fault_reaction_active);
  EXPECT_EQ(cia417::drive_state(0x0218), DriveState::fault);
}

}  // namespace
}  // namespace canvoy::cia417_values_test
