// Inputs and outputs of CiA 401, which the elements of CiA 852 use as well. The text of CiA 401 is
// not available: expected values are those on which public sources agree.
#include "canvoy/profiles/cia401.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

namespace canvoy::conformance {

namespace of_401 {
namespace {

namespace io = cia401;

constexpr Place outputs{&io::write_output_8_bit_object, 1};
constexpr Place output_polarity{&io::change_polarity_output_8_bit_object, 1};
constexpr Place output_filter{&io::filter_mask_output_8_bit_object, 1};
constexpr Place output_error_mode{&io::error_mode_output_8_bit_object, 1};
constexpr Place output_error_value{&io::error_value_output_8_bit_object, 1};
constexpr Place level{&io::write_analogue_output_16_bit_object, 1};
constexpr Place level_error_mode{&io::analogue_output_error_mode_object, 1};
constexpr Place level_error_value{&io::analogue_output_error_value_integer_object, 1};
constexpr Place inputs{&io::read_input_8_bit_object, 1};
constexpr Place input_polarity{&io::polarity_input_8_bit_object, 1};
constexpr Place input_events{&io::global_interrupt_enable_digital_object, 0};
constexpr Place any_change{&io::interrupt_mask_any_change_8_bit_object, 1};
constexpr Place rising{&io::interrupt_mask_low_to_high_8_bit_object, 1};
constexpr Place falling{&io::interrupt_mask_high_to_low_8_bit_object, 1};
constexpr Place voltage{&io::read_analogue_input_16_bit_object, 1};
constexpr Place voltage_events{&io::analogue_input_global_interrupt_enable_object, 0};
constexpr Place trigger{&io::analogue_input_interrupt_trigger_selection_object, 1};
constexpr Place delta{&io::analogue_input_interrupt_delta_unsigned_object, 1};
constexpr Place upper_limit{&io::analogue_input_interrupt_upper_limit_integer_object, 1};
constexpr Place source{&io::analogue_input_interrupt_source_object, 1};

constexpr std::uint64_t input_1 = 0x01;
/// For a positive 16-bit number: true at half of the full scale or more.
constexpr std::uint64_t upper_half_mask = 0xC000;
constexpr std::int64_t upper_half = 0x4000;
constexpr std::int64_t by_limit = 0x01;
constexpr std::int64_t by_delta = 0x04;

constexpr std::string_view input_on = "switch input 1 of group 1 on";
constexpr std::string_view input_off = "switch input 1 of group 1 off";
constexpr std::string_view all_off = "switch inputs 1 to 8 off";
constexpr std::string_view volts_low = "set analogue input 1 to nothing";
constexpr std::string_view volts_high = "set analogue input 1 to its highest value";

/// Time in which a switched input is sampled.
constexpr Duration sensed = 100ms;

constexpr Step stop = enter(NmtCommand::stop);
constexpr Step pre_operational = enter(NmtCommand::enter_pre_operational);

constexpr BehaviourRow output_rows[] = {
    row("401-outputs-01", "CiA 401, 6200h", "outputs are what was written",
        {put(outputs, 0x05), is(outputs, 0x05), put(outputs, 0xA0), is(outputs, 0xA0)}),
    row("401-outputs-02", "CiA 401, 6200h", "outputs follow an RPDO",
        {start, put(outputs, 0), feed(outputs, 0x55), is(outputs, 0x55)}),
    row("401-outputs-03", "CiA 301, 7.3.2.2.2", "outputs follow no RPDO in pre-operational",
        {pre_operational, put(outputs, 0), feed(outputs, 0x55), stays(outputs, 0)}),
    row("401-outputs-04", "CiA 301, 7.3.2.2.4", "outputs follow no RPDO in stopped",
        {start, put(output_error_value, 0), put(outputs, 0), stop, feed(outputs, 0x55),
         pre_operational, is(outputs, 0)}),
    row("401-outputs-05", "CiA 401, 6208h", "outputs that 6208h filters keep what they were",
        {put(outputs, 0), put(output_filter, 0x0F), put(outputs, 0xFF), is(outputs, 0x0F)}),
    row("401-outputs-06", "CiA 401, 6202h", "polarity inverts what an output does",
        {put(outputs, 0x00), see("output 1 of group 1 is off"), put(output_polarity, 0x01),
         see("output 1 of group 1 is on")}),
    row("401-outputs-07", "CiA 401, 6206h and 6207h", "outputs take their error values in stopped",
        {start, put(output_error_mode, 0x03), put(output_error_value, 0x01), put(outputs, 0x02),
         stop, see("output 1 of group 1 is on"), see("output 2 of group 1 is off")}),
    row("401-outputs-08", "CiA 401, 6206h", "outputs without an error mode stay as they are",
        {start, put(output_error_mode, 0x00), put(outputs, 0x01), stop,
         see("output 1 of group 1 is on")}),
    row("401-outputs-09", "CiA 401, 6206h and 6207h",
        "outputs take their error values when a heartbeat is lost",
        {start, put(output_error_mode, 0x01), put(output_error_value, 0x00), put(outputs, 0x01),
         lose, see("output 1 of group 1 is off")}),
    row("401-level-01", "CiA 401, 6411h", "an analogue output is what was written",
        {put(level, 1000), is(level, 1000), put(level, -1000), is(level, -1000)}),
    row("401-level-02", "CiA 401, 6411h", "an analogue output follows an RPDO",
        {start, put(level, 0), feed(level, 1234), is(level, 1234)}),
    row("401-level-03", "CiA 301, 7.3.2.2.2",
        "an analogue output follows no RPDO in pre-operational",
        {pre_operational, put(level, 0), feed(level, 1234), stays(level, 0)}),
    row("401-level-04", "CiA 401, 6443h", "an error mode that there is not is refused",
        {refuse(level_error_mode, 2), refuse(level_error_mode, 255)}),
    row("401-level-05", "CiA 401, 6443h and 6444h", "an error value is kept as it was written",
        {put(level_error_value, -70000), is(level_error_value, -70000)}),
};

constexpr BehaviourRow input_rows[] = {
    row("401-inputs-01", "CiA 401, 6000h", "an input is read as it is",
        {hand(input_off), is(inputs, 0, input_1), hand(input_on), is(inputs, 1, input_1)}),
    row("401-inputs-02", "CiA 401, 6006h", "an input that changes is told",
        {hand(input_off), wait(sensed), start, put(any_change, 0xFF), hand(input_on),
         tells(inputs, 1, input_1), hand(input_off), tells(inputs, 0, input_1)}),
    row("401-inputs-03", "CiA 401, 6005h", "no input is told while 6005h says so",
        {hand(input_off), wait(sensed), start, put(input_events, 0), hand(input_on),
         is_silent(inputs), is(inputs, 1, input_1)}),
    row("401-inputs-04", "CiA 401, 6006h to 6008h", "an input without masks is not told",
        {hand(input_off), wait(sensed), start, put(any_change, 0), put(rising, 0), put(falling, 0),
         hand(input_on), is_silent(inputs), is(inputs, 1, input_1)}),
    row("401-inputs-05", "CiA 401, 6007h",
        "with 6007h an input is told when it is switched on alone",
        {hand(input_off), wait(sensed), start, put(any_change, 0), put(falling, 0), put(rising, 1),
         hand(input_on), tells(inputs, 1, input_1), hand(input_off), is_silent(inputs)}),
    row("401-inputs-06", "CiA 401, 6008h",
        "with 6008h an input is told when it is switched off alone",
        {hand(input_off), wait(sensed), start, put(any_change, 0), put(rising, 0), put(falling, 1),
         hand(input_on), is_silent(inputs), hand(input_off), tells(inputs, 0, input_1)}),
    row("401-inputs-07", "CiA 401, 6002h", "polarity inverts an input",
        {hand(all_off), put(input_polarity, 0x00), is(inputs, 0x00), put(input_polarity, 0x81),
         is(inputs, 0x81)}),
    row("401-inputs-08", "CiA 301, 7.3.2.2.2", "no input is told in pre-operational",
        {pre_operational, hand(input_off), wait(sensed), hand(input_on), is_silent(inputs),
         is(inputs, 1, input_1)}),
    row("401-inputs-09", "CiA 401, 6007h",
        "with 6007h an input is told each time it is switched on",
        {hand(input_off), wait(sensed), start, put(any_change, 0), put(falling, 0), put(rising, 1),
         hand(input_on), tells(inputs, 1, input_1), hand(input_off), wait(sensed), hand(input_on),
         tells(inputs, 1, input_1)}),
    row("401-voltage-01", "CiA 401, 6401h", "an analogue input is read as it is",
        {hand(volts_low), is(voltage, 0, upper_half_mask), hand(volts_high),
         is(voltage, upper_half, upper_half_mask)}),
    row("401-voltage-02", "CiA 401, 6423h", "no analogue input is told before 6423h allows it",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 0), hand(volts_high),
         is_silent(voltage), is(voltage, upper_half, upper_half_mask)}),
    row("401-voltage-03", "CiA 401, 6423h", "an analogue input that changes is told",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 1), hand(volts_high),
         tells(voltage, upper_half, upper_half_mask)}),
    row("401-voltage-04", "CiA 401, 6421h and 6426h",
        "an analogue input is not told before it has changed by its delta",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 1), put(trigger, by_delta),
         put(delta, 0x10000), hand(volts_high), is_silent(voltage)}),
    row("401-voltage-05", "CiA 401, 6421h and 6426h",
        "an analogue input is told when it has changed by its delta",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 1), put(trigger, by_delta),
         put(delta, 0x100), hand(volts_high), tells(voltage, upper_half, upper_half_mask)}),
    row("401-voltage-06", "CiA 401, 6421h and 6424h",
        "an analogue input is told at its upper limit and above",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 1), put(trigger, by_limit),
         put(upper_limit, upper_half), hand(volts_high),
         tells(voltage, upper_half, upper_half_mask)}),
    row("401-voltage-07", "CiA 401, 6422h", "reading the source of an event clears it",
        {hand(volts_low), wait(sensed), start, put(voltage_events, 1), hand(volts_high),
         is(source, 1, 1), is(source, 0, 1)}),
};

}  // namespace
}  // namespace of_401

std::span<const BehaviourRow> rows_of_401_outputs() {
  return of_401::output_rows;
}

std::span<const BehaviourRow> rows_of_401_inputs() {
  return of_401::input_rows;
}

}  // namespace canvoy::conformance
