// Units of a lift (CiA 417-4): door, drive, load, position, call controller and light barrier of
// lift 1, door 1.
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

namespace canvoy::conformance {

namespace of_417 {
namespace {

namespace lift = cia417;

// Door: the state is in bits 15 to 12 of the statusword, the command in the same bits of the
// controlword; all other fields are "do not care" here.

constexpr Place door_command{&lift::door_controlword_object, 1};
constexpr Place other_door_command{&lift::door_controlword_object, 2};
constexpr Place door_status{&lift::door_statusword_object, 1};
constexpr Place door_position{&lift::door_position_object, 1};
constexpr Place heartbeat_loss{&lift::door_configuration_object, 0x0B};

constexpr std::uint64_t door_state = 0xF000;
/// Closed with torque is 0, closed without torque is 1.
constexpr std::uint64_t closed_states = 0xE000;
constexpr std::int64_t is_opened = 0x3000;
constexpr std::int64_t is_closing = 0x2000;
constexpr std::int64_t is_opening = 0x5000;
constexpr std::int64_t is_stopped = 0x7000;
constexpr std::int64_t close_it = 0x1FFF;
constexpr std::int64_t close_with_force = 0x0FFF;
constexpr std::int64_t open_it = 0x4FFF;
constexpr std::int64_t open_with_force = 0x3FFF;
constexpr std::int64_t stop_it = 0x8FFF;
constexpr std::int64_t leave_it = 0xFFFF;
/// Time for a full door movement; no clause gives one, and the slowest doors need less.
constexpr Duration door_way = 30s;
constexpr Duration part_of_way = 500ms;

constexpr Step door_closes = feed(door_command, close_it);
constexpr Step door_opens = feed(door_command, open_it);
constexpr Step is_closed = is(door_status, 0, closed_states, door_way);
constexpr Step is_open = is(door_status, is_opened, door_state, door_way);

constexpr BehaviourRow door_rows[] = {
    row("417-4-door-01", "4.6.1 and 4.7.1", "a door that is told to open opens",
        {start, door_closes, is_closed, door_opens, is_open}),
    row("417-4-door-02", "4.6.1 and 4.7.1", "a door that is told to close closes",
        {start, door_opens, is_open, door_closes, is_closed}),
    row("417-4-door-03", "4.7.1", "a door tells that it opens, and that it is open",
        {start, door_closes, is_closed, door_opens, tells(door_status, is_opening, door_state),
         tells(door_status, is_opened, door_state, door_way)}),
    row("417-4-door-04", "4.7.1", "a door tells that it closes, and that it is closed",
        {start, door_opens, is_open, door_closes, tells(door_status, is_closing, door_state),
         tells(door_status, 0, closed_states, door_way)}),
    row("417-4-door-05", "4.6.1", "a door stops where it is told to",
        {start, door_closes, is_closed, door_opens, wait(part_of_way), feed(door_command, stop_it),
         is(door_status, is_stopped, door_state), wait(1s),
         stays(door_status, is_stopped, door_state)}),
    row("417-4-door-06", "4.6.1", "a door that closes opens where it is told to",
        {start, door_opens, is_open, door_closes, wait(part_of_way), door_opens,
         is(door_status, is_opening, door_state, 2s), is_open}),
    row("417-4-door-07", "4.6.1", "a door opens without a limit of its force",
        {start, door_closes, is_closed, feed(door_command, open_with_force), is_open}),
    row("417-4-door-08", "4.6.1", "a door closes without a limit of its force",
        {start, door_opens, is_open, feed(door_command, close_with_force), is_closed}),
    row("417-4-door-09", "4.6.1", "a door that is to take no action stays as it is",
        {start, door_closes, is_closed, feed(door_command, leave_it),
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-10", "4.6.1", "a reserved command moves no door: 2h",
        {start, door_closes, is_closed, feed(door_command, 0x2FFF),
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-11", "4.6.1", "a reserved command moves no door: 5h, 6h",
        {start, door_closes, is_closed, feed(door_command, 0x5FFF), feed(door_command, 0x6FFF),
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-12", "4.6.1", "a reserved command moves no door: 9h, Dh",
        {start, door_closes, is_closed, feed(door_command, 0x9FFF), feed(door_command, 0xDFFF),
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-13", "4.6.1", "the command of another door moves no door",
        {start, door_closes, is_closed, feed(other_door_command, open_it),
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-14", "CiA 301, 7.3.2.2.2", "a door follows no RPDO in pre-operational",
        {start, door_closes, is_closed, enter(NmtCommand::enter_pre_operational), door_opens,
         stays(door_status, 0, closed_states, 2s)}),
    row("417-4-door-15", "4.7.2", "a door tells its way",
        {start, door_closes, is_closed, door_opens, tells_any(door_position, 2s)}),
    row("417-4-door-16", "4.7.3", "a door whose heartbeat is lost stops",
        {start, door_closes, is_closed, put(heartbeat_loss, 0x00), door_opens, wait(part_of_way),
         lose, is(door_status, is_stopped, door_state)}),
    row("417-4-door-17", "4.7.3", "a door whose heartbeat is lost closes where it is so configured",
        {start, door_opens, is_open, put(heartbeat_loss, 0x02), lose, is_closed}),
    row("417-4-door-18", "4.7.3", "a reaction to a lost heartbeat that is reserved is refused",
        {refuse(heartbeat_loss, 0x03), refuse(heartbeat_loss, 0xFF)}),
};

// Drive: the state machine of CiA 402.

constexpr Place control{&lift::controlword_object, 0};
constexpr Place drive_status{&lift::statusword_object, 0};
constexpr std::uint64_t drive_states = 0x6F;
constexpr std::uint64_t disabled_states = 0x4F;
constexpr Step is_disabled = is(drive_status, 0x40, disabled_states, 2s);
constexpr Step is_ready = is(drive_status, 0x21, drive_states, 2s);
constexpr Step is_switched_on = is(drive_status, 0x23, drive_states, 2s);
constexpr Step is_enabled = is(drive_status, 0x27, drive_states, 2s);
constexpr Step stays_disabled = stays(drive_status, 0x40, disabled_states);
constexpr Step disable_voltage = feed(control, 0x0000);
constexpr Step shut_down = feed(control, 0x0006);
constexpr Step switch_on = feed(control, 0x0007);
constexpr Step enable_operation = feed(control, 0x000F);

constexpr BehaviourRow drive_rows[] = {
    row("417-4-drive-01", "4.11.1.1", "shutdown makes a drive ready to switch on",
        {start, disable_voltage, is_disabled, shut_down, is_ready, disable_voltage}),
    row("417-4-drive-02", "4.11.1.1", "switch on and enable operation follow",
        {start, disable_voltage, is_disabled, shut_down, is_ready, switch_on, is_switched_on,
         enable_operation, is_enabled, disable_voltage}),
    row("417-4-drive-03", "4.11.1.1", "disable voltage takes the power from any state",
        {start, disable_voltage, is_disabled, shut_down, is_ready, switch_on, is_switched_on,
         enable_operation, is_enabled, disable_voltage, is_disabled}),
    row("417-4-drive-04", "4.11.1.1", "disable operation leaves the drive switched on",
        {start, disable_voltage, is_disabled, shut_down, is_ready, switch_on, is_switched_on,
         enable_operation, is_enabled, switch_on, is_switched_on, disable_voltage}),
    row("417-4-drive-05", "4.11.1.1", "shutdown leaves operation enabled",
        {start, disable_voltage, is_disabled, shut_down, is_ready, switch_on, is_switched_on,
         enable_operation, is_enabled, shut_down, is_ready, disable_voltage}),
    row("417-4-drive-06", "4.11.1.1", "switch on does nothing where switching on is disabled",
        {start, disable_voltage, is_disabled, switch_on, stays_disabled}),
    row("417-4-drive-07", "4.11.1.1",
        "enable operation does nothing where switching on is disabled",
        {start, disable_voltage, is_disabled, enable_operation, stays_disabled}),
    row("417-4-drive-08", "4.11.1.2", "a drive tells its state",
        {start, disable_voltage, is_disabled, shut_down, tells(drive_status, 0x21, drive_states),
         disable_voltage}),
    row("417-4-drive-09", "CiA 301, 7.3.2.2.2", "a drive follows no RPDO in pre-operational",
        {start, disable_voltage, is_disabled, enter(NmtCommand::enter_pre_operational), shut_down,
         stays_disabled}),
};

// Load measuring unit. The load is unknown, so limits are moved instead.

constexpr Place load_signal{&lift::load_signaling_object, 1};
constexpr Place load_messages{&lift::load_signaling_object, 2};
constexpr Place load_unit{&lift::load_value_object, 2};
constexpr Place overload_limit{&lift::load_signaling_limits_object, 4};
constexpr Place full_limit{&lift::load_signaling_limits_object, 3};
constexpr Place norm_limit{&lift::load_signaling_limits_object, 2};
constexpr std::uint64_t norm_bit = 0x02;
constexpr std::uint64_t full_bit = 0x04;
constexpr std::uint64_t overload_bit = 0x08;
constexpr std::int64_t unused_limit = 0xFFFF;

constexpr BehaviourRow load_rows[] = {
    row("417-4-load-01", "4.12.3 and 4.12.4", "a load at its limit is signalled as an overload",
        {put(overload_limit, 0), is(load_signal, 0x08, overload_bit)}),
    row("417-4-load-02", "4.12.4", "a limit that is not used signals no overload",
        {put(overload_limit, 0), is(load_signal, 0x08, overload_bit),
         put(overload_limit, unused_limit), is(load_signal, 0, overload_bit)}),
    row("417-4-load-03", "4.12.4", "a load at its limit is signalled as a full load",
        {put(full_limit, 0), is(load_signal, 0x04, full_bit), put(full_limit, unused_limit),
         is(load_signal, 0, full_bit)}),
    row("417-4-load-04", "4.12.4", "a load at its limit is signalled as a norm load",
        {put(norm_limit, 0), is(load_signal, 0x02, norm_bit), put(norm_limit, unused_limit),
         is(load_signal, 0, norm_bit)}),
    row("417-4-load-05", "4.12.3", "an overload is told",
        {start, put(load_messages, 0x0F), put(overload_limit, unused_limit),
         is(load_signal, 0, overload_bit), put(overload_limit, 0),
         tells(load_signal, 0x08, overload_bit)}),
    row("417-4-load-06", "4.12.3", "an overload that is not to be told is not",
        {start, put(overload_limit, unused_limit), put(load_messages, 0x00),
         is(load_signal, 0, overload_bit), put(overload_limit, 0), is_silent(load_signal),
         is(load_signal, 0x08, overload_bit)}),
    row("417-4-load-07", "4.12.1", "a unit that is none of mass is refused",
        {refuse(load_unit, 0x0001), refuse(load_unit, 0x0003)}),
    row("417-4-load-08", "4.12.3", "reserved bits of the load signal are 0",
        {is(load_signal, 0, 0xF0)}),
};

// Car position unit and light barrier.

constexpr Place car_position{&lift::position_value_object, 1};
constexpr Place preset{&lift::preset_value_object, 1};
constexpr Place barrier{&lift::light_barrier_status_object, 1};
constexpr std::uint64_t barrier_bits = 0xC0;
constexpr std::string_view into_barrier = "put something into the light barrier of door 1";
constexpr std::string_view out_of_barrier = "take it out of the light barrier of door 1";

constexpr BehaviourRow position_rows[] = {
    row("417-4-position-01", "4.9.3 and 4.9.4", "a preset is the position from then on",
        {put(preset, 10000), is(car_position, 10000)}),
    row("417-4-position-02", "4.9.4", "a position that changes is told",
        {start, put(preset, 20000), tells(car_position, 20000)}),
    row("417-4-barrier-01", "4.8.1", "a light barrier tells what it sees",
        {hand(out_of_barrier), start, wait(100ms), hand(into_barrier),
         tells(barrier, 0x40, barrier_bits), hand(out_of_barrier),
         tells(barrier, 0, barrier_bits)}),
    row("417-4-barrier-02", "4.8.1", "reserved bits of the light barrier status are 1",
        {is(barrier, 0x3F, 0x3F)}),
};

// Call controller: records of basic function, sub-function, lift, floor, door and data, the first
// in the lowest byte.

constexpr Place call{&lift::virtual_input_mapping_object, 0};
constexpr Place answer{&lift::virtual_output_mapping_object, 0};
constexpr std::int64_t hall_up = 0x0110'0101'0102;
constexpr std::int64_t hall_up_affirmed = 0x8110'0101'0102;
constexpr std::int64_t hall_down = 0x0110'0201'0202;
constexpr std::int64_t hall_down_affirmed = 0x8110'0201'0202;
constexpr std::int64_t hall_low = 0x0110'0101'0103;
constexpr std::int64_t hall_high = 0x0110'0101'0104;
constexpr std::int64_t car_call = 0x0111'0001'0205;
constexpr std::int64_t car_call_affirmed = 0x8101'0001'0205;
/// Without the column of buttons.
constexpr std::uint64_t without_column = 0xFF0F'FFFF'FFFF;
constexpr std::uint64_t record = 0xFFFF'FFFF'FFFF;

constexpr BehaviourRow call_rows[] = {
    row("417-4-call-01", "4.3.1 and 4.4.1", "a hall call upward is affirmed",
        {start, feed(call, hall_up), tells(answer, hall_up_affirmed, record)}),
    row("417-4-call-02", "4.3.1 and 4.4.1", "a hall call downward is affirmed",
        {start, feed(call, hall_down), tells(answer, hall_down_affirmed, record)}),
    row("417-4-call-03", "4.3.1 and 4.4.1", "a hall call of low priority is affirmed as one",
        {start, feed(call, hall_low), tells(answer, 0x8110'0101'0103, record)}),
    row("417-4-call-04", "4.3.1 and 4.4.1", "a hall call of high priority is affirmed as one",
        {start, feed(call, hall_high), tells(answer, 0x8110'0101'0104, record)}),
    row("417-4-call-05", "4.3.1 and 4.4.1", "a car call is affirmed",
        {start, feed(call, car_call), tells(answer, car_call_affirmed, without_column)}),
    row("417-4-call-06", "4.3.1", "who presses again is answered again",
        {start, feed(call, hall_up), tells(answer, hall_up_affirmed, record), feed(call, hall_up),
         tells(answer, hall_up_affirmed, record)}),
    row("417-4-call-07", "4.3.1", "a call of another lift is not answered",
        {start, feed(call, 0x0110'0102'0102), is_silent(answer)}),
    row("417-4-call-08", "4.3.1", "a button that is let go is no call",
        {start, feed(call, 0x0010'0101'0102), is_silent(answer)}),
    row("417-4-call-09", "4.3.1", "a defective button is no call",
        {start, feed(call, 0x0210'0101'0102), is_silent(answer)}),
    row("417-4-call-10", "4.3.1", "a button that is not there is no call",
        {start, feed(call, 0x0310'0101'0102), is_silent(answer)}),
    row("417-4-call-11", "4.3.1", "a reserved floor is no call",
        {start, feed(call, 0x0110'0001'0102), is_silent(answer)}),
    row("417-4-call-12", "4.3.1", "basic function 0 is no call",
        {start, feed(call, 0x0110'0101'0100), is_silent(answer)}),
    row("417-4-call-13", "4.4.1", "a call to a floor that there is not is not affirmed",
        {start, feed(call, 0x0110'FE01'0102), tells(answer, 0x0010'FE01'0102, record)}),
    row("417-4-call-14", "CiA 301, 7.3.2.2.2", "a call is not answered in pre-operational",
        {enter(NmtCommand::enter_pre_operational), feed(call, hall_up), is_silent(answer)}),
};

constexpr Place lift_number{&lift::lift_number_object, 0};

constexpr BehaviourRow lift_rows[] = {
    row("417-4-lift-01", "4.2.2", "no lift at all is refused", {refuse(lift_number, 0x00)}),
};

}  // namespace
}  // namespace of_417

std::vector<std::span<const BehaviourRow>> rows_of_417() {
  using namespace of_417;  // NOLINT(google-build-using-namespace): its tables
  return {door_rows, drive_rows, load_rows, position_rows, call_rows, lift_rows};
}

}  // namespace canvoy::conformance
