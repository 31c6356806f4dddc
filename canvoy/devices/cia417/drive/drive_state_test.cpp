// Every controlword in every state of CiA 402: the expectation is typed from the table of commands
// (which bits each has) and the list of transitions 2 to 16.
#include "canvoy/devices/cia417/drive/drive_state.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::drive_state_test {
namespace {

using enum DriveState;

struct Row {
  DriveState from;
  std::uint16_t mask;  ///< bits that the command looks at
  std::uint16_t bits;
  DriveState to;
};
/// Bits 0 to 3 and 7 of each command: `mask` has those that are not "don't care".
constexpr Row transitions[] = {
    {switch_on_disabled, 0x87, 0x06, ready_to_switch_on},  // 2
    {ready_to_switch_on, 0x8F, 0x07, switched_on},         // 3
    {ready_to_switch_on, 0x8F, 0x0F, operation_enabled},   // 3 and 4
    {switched_on, 0x8F, 0x0F, operation_enabled},          // 4
    {operation_enabled, 0x8F, 0x07, switched_on},          // 5
    {switched_on, 0x87, 0x06, ready_to_switch_on},         // 6
    {ready_to_switch_on, 0x02, 0x00, switch_on_disabled},  // 7
    {ready_to_switch_on, 0x06, 0x02, switch_on_disabled},  // 7
    {operation_enabled, 0x87, 0x06, ready_to_switch_on},   // 8
    {operation_enabled, 0x02, 0x00, switch_on_disabled},   // 9
    {switched_on, 0x02, 0x00, switch_on_disabled},         // 10
    {switched_on, 0x06, 0x02, switch_on_disabled},         // 10
    {operation_enabled, 0x06, 0x02, quick_stop_active},    // 11
    {quick_stop_active, 0x02, 0x00, switch_on_disabled},   // 12
};
constexpr Row resuming = {quick_stop_active, 0x8F, 0x0F, operation_enabled};  // 16

constexpr DriveState all_states[] = {
    not_ready_to_switch_on, switch_on_disabled, ready_to_switch_on,    switched_on,
    operation_enabled,      quick_stop_active,  fault_reaction_active, fault};

std::optional<DriveState> expected(DriveState state, unsigned controlword, bool stays) {
  for (const Row& row : transitions) {
    if (row.from == state && (controlword & row.mask) == row.bits) return row.to;
  }
  const bool resumes = state == resuming.from && (controlword & resuming.mask) == resuming.bits;
  return resumes && stays ? std::optional(resuming.to) : std::nullopt;
}

TEST(DriveState, EveryControlwordInEveryStateDoesWhatTheTableSaysOrNothing) {
  for (const DriveState state : all_states) {
    for (const bool stays : {false, true}) {
      for (unsigned word = 0; word <= 0xFFFF; ++word) {
        const auto command = drive_command(static_cast<std::uint16_t>(word));
        const auto next = command ? next_state(state, *command, stays) : std::nullopt;
        ASSERT_EQ(next, expected(state, word, stays))
            << "state " << static_cast<int>(state) << ", controlword " << word;
      }
    }
  }
}

TEST(DriveState, TheStatuswordTellsEachState) {
  for (const DriveState state : all_states) {
    for (const unsigned others : {0x0000U, 0xFF90U}) {
      EXPECT_EQ(cia402::drive_state(static_cast<std::uint16_t>(state_bits(state) | others)), state);
    }
  }
}

TEST(DriveState, ThePowerStageIsOnWhileTheDriveMovesOrStops) {
  for (const DriveState state : all_states) {
    EXPECT_EQ(is_powered(state), state == operation_enabled || state == quick_stop_active ||
                                     state == fault_reaction_active);
  }
}

}  // namespace
}  // namespace canvoy::cia417::drive_state_test
