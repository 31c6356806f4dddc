// Elements of an operator environment (CiA 852): the first of each kind in the device.
#include "canvoy/profiles/cia852.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

namespace canvoy::conformance {

namespace of_852 {
namespace {

namespace oe = cia852;

constexpr std::uint8_t sub(unsigned number) {
  return static_cast<std::uint8_t>(number);
}
constexpr Place switches(unsigned of) {
  return {&oe::read_input_8_bit_object, sub(of)};
}
constexpr Place position(unsigned of) {
  return {&oe::read_analogue_input_16_bit_object, sub(of)};
}

constexpr Place axis_x = position(oe::joystick_axis_sub(1, 1));
constexpr Place axis_y = position(oe::joystick_axis_sub(1, 2));
constexpr Place axis_z = position(oe::joystick_axis_sub(1, 3));
constexpr Place joystick_buttons = switches(oe::joystick_buttons_sub(1));
constexpr Place joystick_memory = switches(oe::joystick_memory_sub(1));
constexpr Place pedal = position(oe::foot_pedal_position_sub(1));
constexpr Place pedal_memory = switches(oe::foot_pedal_memory_sub(1));
constexpr Place wheel = position(oe::wheel_position_sub(1));
constexpr Place push_buttons = switches(oe::push_buttons_sub(1, 1));
constexpr Place last_push_buttons = switches(oe::push_buttons_sub(1, oe::groups_of_cluster));
constexpr Place encoder{&oe::read_input_32_bit_object, sub(oe::encoder_position_sub(1))};
constexpr Place indicators{&oe::write_output_8_bit_object, sub(oe::indicators_sub(1, 1))};
constexpr Place last_indicators{&oe::write_output_8_bit_object,
                                sub(oe::indicators_sub(1, oe::groups_of_cluster))};
constexpr Place indicators_error_mode{&oe::error_mode_output_8_bit_object,
                                      sub(oe::indicators_sub(1, 1))};
constexpr Place indicators_error_value{&oe::error_value_output_8_bit_object,
                                       sub(oe::indicators_sub(1, 1))};
constexpr Place display{&oe::write_analogue_output_16_bit_object, sub(oe::display_sub(1, 1))};
constexpr Place display_error_mode{&oe::analogue_output_error_mode_object,
                                   sub(oe::display_sub(1, 1))};
constexpr Place display_error_value{&oe::analogue_output_error_value_integer_object,
                                    sub(oe::display_sub(1, 1))};
constexpr Place analogue_events{&oe::analogue_input_global_interrupt_enable_object, 0};
constexpr Place axis_trigger{&cia401::analogue_input_interrupt_trigger_selection_object, 1};
constexpr Place axis_delta{&cia401::analogue_input_interrupt_delta_unsigned_object, 1};

constexpr std::uint16_t disabled_inputs = 0x0080;
/// For a positive 16-bit number: true at half of the full scale or more.
constexpr std::uint64_t far_mask = 0xC000;
constexpr std::int64_t far_out = 0x4000;
constexpr std::uint64_t first = 0x01;
constexpr std::uint64_t above_joystick_memory = 0xF8;
constexpr std::uint64_t above_pedal_memory = 0xFE;
constexpr std::int64_t by_axis_delta = 0x04;
constexpr Duration looked_at = 100ms;

constexpr Step oe_pre_operational = enter(NmtCommand::enter_pre_operational);
constexpr Step oe_stop = enter(NmtCommand::stop);

constexpr std::string_view push_x = "push joystick 1 along x to its positive end";
constexpr std::string_view push_y = "push joystick 1 along y to its positive end";
constexpr std::string_view turn_z = "turn joystick 1 about z to its positive end";
constexpr std::string_view let_go = "let joystick 1 go";
constexpr std::string_view press = "press button 1 of joystick 1";
constexpr std::string_view release = "let button 1 of joystick 1 go";
constexpr std::string_view press_pedal = "press foot pedal 1 to its end";
constexpr std::string_view lift_foot = "let foot pedal 1 go";
constexpr std::string_view turn_wheel = "turn wheel 1 to its positive end";
constexpr std::string_view turn_wheel_back = "turn wheel 1 to its middle";
constexpr std::string_view turn_encoder = "turn encoder 1";
constexpr std::string_view press_first = "press push-button 1 of cluster 1";
constexpr std::string_view let_first_go = "let push-button 1 of cluster 1 go";
constexpr std::string_view press_last = "press push-button 64 of cluster 1";
constexpr std::string_view let_last_go = "let push-button 64 of cluster 1 go";

constexpr BehaviourRow oe_rows[] = {
    row("852-joystick-01", "9.2", "the x-dimension is read where the joystick is",
        {hand(let_go), is(axis_x, 0, far_mask), hand(push_x), is(axis_x, far_out, far_mask)}),
    row("852-joystick-02", "9.2", "the y-dimension is read where the joystick is",
        {hand(let_go), is(axis_y, 0, far_mask), hand(push_y), is(axis_y, far_out, far_mask)}),
    row("852-joystick-03", "9.2", "the z-dimension is read where the joystick is",
        {hand(let_go), is(axis_z, 0, far_mask), hand(turn_z), is(axis_z, far_out, far_mask)}),
    row("852-joystick-04", "12.1", "a joystick that moves is told",
        {hand(let_go), wait(looked_at), start, put(analogue_events, 1), hand(push_x),
         tells(axis_x, far_out, far_mask)}),
    row("852-joystick-05", "9.2", "a joystick that moves is not told while 6423h is FALSE",
        {hand(let_go), wait(looked_at), start, put(analogue_events, 0), hand(push_x),
         is_silent(axis_x)}),
    row("852-joystick-06", "15", "a joystick that moves within its dead band is not told",
        {hand(let_go), wait(looked_at), start, put(analogue_events, 1),
         put(axis_trigger, by_axis_delta), put(axis_delta, 0x10000), hand(push_x),
         is_silent(axis_x), is(axis_x, far_out, far_mask)}),
    row("852-joystick-07", "9.2", "a button is 1 while it is pressed",
        {hand(release), is(joystick_buttons, 0, first), hand(press), is(joystick_buttons, 1, first),
         hand(release), is(joystick_buttons, 0, first)}),
    row("852-joystick-08", "12.1", "a button is told, pressed and let go",
        {hand(release), wait(looked_at), start, hand(press), tells(joystick_buttons, 1, first),
         hand(release), tells(joystick_buttons, 0, first)}),
    row("852-joystick-09", "9.2", "a button is told though 6423h is FALSE",
        {hand(release), wait(looked_at), start, put(analogue_events, 0), hand(press),
         tells(joystick_buttons, 1, first)}),
    row("852-joystick-10", "9.2", "reserved bits of the memory function are 0",
        {is(joystick_memory, 0, above_joystick_memory)}),
    row("852-joystick-11", "12.1", "a joystick is told once when its node becomes operational",
        {oe_pre_operational, wait(looked_at), start, tells_any(axis_x)}),
    row("852-joystick-12", "12.1", "a joystick that moves is not told in pre-operational",
        {hand(let_go), put(analogue_events, 1), oe_pre_operational, wait(looked_at), hand(push_x),
         is_silent(axis_x)}),
    row("852-pedal-01", "9.3", "the position of a foot pedal is read",
        {hand(lift_foot), is(pedal, 0, far_mask), hand(press_pedal), is(pedal, far_out, far_mask)}),
    row("852-pedal-02", "12.1", "a foot pedal that moves is told",
        {hand(lift_foot), wait(looked_at), start, put(analogue_events, 1), hand(press_pedal),
         tells(pedal, far_out, far_mask)}),
    row("852-pedal-03", "9.3", "reserved bits of the memory function are 0",
        {is(pedal_memory, 0, above_pedal_memory)}),
    row("852-wheel-01", "9.5", "the position of a wheel is read",
        {hand(turn_wheel_back), is(wheel, 0, far_mask), hand(turn_wheel),
         is(wheel, far_out, far_mask)}),
    row("852-wheel-02", "12.1", "a wheel that moves is told",
        {hand(turn_wheel_back), wait(looked_at), start, put(analogue_events, 1), hand(turn_wheel),
         tells(wheel, far_out, far_mask)}),
    row("852-encoder-01", "12.1", "an encoder that turns is told",
        {start, wait(looked_at), hand(turn_encoder), tells_any(encoder)}),
    row("852-push-button-01", "9.6", "a push-button is 1 while it is pressed",
        {hand(let_first_go), is(push_buttons, 0, first), hand(press_first),
         is(push_buttons, 1, first)}),
    row("852-push-button-02", "12.1", "a push-button is told, pressed and let go",
        {hand(let_first_go), wait(looked_at), start, hand(press_first),
         tells(push_buttons, 1, first), hand(let_first_go), tells(push_buttons, 0, first)}),
    row("852-push-button-03", "9.6", "the last push-button is the last bit",
        {hand(let_last_go), is(last_push_buttons, 0, 0x80), hand(press_last),
         is(last_push_buttons, 0x80, 0x80)}),
    row("852-indicator-01", "9.7", "an indicator is lit while its bit is 1",
        {put(indicators, 0x01), see("indicator 1 of cluster 1 is lit"), put(indicators, 0x00),
         see("indicator 1 of cluster 1 is dark")}),
    row("852-indicator-02", "12.1", "indicators follow their RPDO at once",
        {start, put(indicators, 0), feed(indicators, 0x81), is(indicators, 0x81)}),
    row("852-indicator-03", "9.7", "the last indicator is the last bit",
        {put(last_indicators, 0x80), see("indicator 64 of cluster 1 is lit"),
         put(last_indicators, 0x00), see("indicator 64 of cluster 1 is dark")}),
    row("852-indicator-04", "9.7", "an indicator takes its error value when the host is lost",
        {start, put(indicators_error_mode, 0x01), put(indicators_error_value, 0x00),
         put(indicators, 0x01), lose, see("indicator 1 of cluster 1 is dark")}),
    row("852-indicator-05", "9.7", "an indicator without an error mode stays as it is",
        {start, put(indicators_error_mode, 0x00), put(indicators, 0x01), lose,
         see("indicator 1 of cluster 1 is lit")}),
    row("852-display-01", "12.1", "a display follows its RPDO at once",
        {start, put(display, 0), feed(display, 321), is(display, 321),
         see("parameter 1 of display 1 is 321")}),
    row("852-display-02", "9.8", "a display shows values below zero",
        {put(display, -1), is(display, -1), see("parameter 1 of display 1 is -1")}),
    row("852-display-03", "9.8", "a display takes its error value when the host is lost",
        {start, put(display_error_mode, 1), put(display_error_value, 100), put(display, 5), lose,
         see("parameter 1 of display 1 is 100")}),
    row("852-alarm-01", "8.6", "becoming operational with 6423h FALSE is an emergency",
        {oe_pre_operational, put(analogue_events, 0), start, alarm(disabled_inputs)}),
    row("852-alarm-02", "8.6", "that emergency leaves the device operational",
        {hand(release), oe_pre_operational, put(analogue_events, 0), start, alarm(disabled_inputs),
         wait(1s), hand(press), tells(joystick_buttons, 1, first)}),
    row("852-alarm-03", "8.6", "becoming operational with 6423h TRUE is none",
        {oe_pre_operational, put(analogue_events, 1), start, no_alarm(disabled_inputs)}),
    row("852-nmt-01", "CiA 301, 7.3.2.2.4", "indicators follow no RPDO in stopped",
        {start, put(indicators_error_value, 0), put(indicators, 0), oe_stop, feed(indicators, 0x81),
         oe_pre_operational, is(indicators, 0)}),
};

}  // namespace
}  // namespace of_852

std::span<const BehaviourRow> rows_of_852() {
  return of_852::oe_rows;
}

}  // namespace canvoy::conformance
