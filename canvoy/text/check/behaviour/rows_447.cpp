// Virtual devices of a car (CiA 447-3): the status follows the command. All commands and statuses
// have fields of two or four bits, where all ones are "do not care" and "not available".
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

namespace canvoy::conformance {

namespace of_447 {
namespace {

namespace car = cia447;

/// Time for a radio, a power stage, a lamp that warms up; no clause gives one.
constexpr Duration switched = 5s;
constexpr std::uint64_t two_bits = 0x03;
constexpr std::uint64_t next_two_bits = 0x0C;

// Radio (CiA 447-3, 4.2.18): bits 1 and 0 switch it on and off, 3 and 2 push to talk.

constexpr Place radio_command{&car::radio_device_command_object, 0};
constexpr Place radio_device{&car::radio_device_status_object, 0};
constexpr Place radio_status{&car::radio_status_object, 0};
constexpr Place radio_power{&car::radio_power_supply_status_object, 0};
constexpr Step radio_on = put(radio_command, 0xFD);
constexpr Step radio_off = put(radio_command, 0xFC);
constexpr Step talk = put(radio_command, 0xF7);
constexpr Step listen_only = put(radio_command, 0xF3);
constexpr Step radio_is_on = is(radio_device, 0x01, two_bits, switched);
constexpr Step radio_is_off = is(radio_device, 0x00, two_bits, switched);
constexpr Step talks = is(radio_device, 0x04, next_two_bits, switched);
constexpr Step is_quiet = is(radio_device, 0x00, next_two_bits, switched);

constexpr BehaviourRow radio_rows[] = {
    row("447-3-radio-01", "4.2.18", "a radio that is turned on is on",
        {radio_off, radio_is_off, radio_on, radio_is_on}),
    row("447-3-radio-02", "4.2.18", "a radio that is turned off is off",
        {radio_on, radio_is_on, radio_off, radio_is_off}),
    row("447-3-radio-03", "4.2.18", "push to talk transmits",
        {radio_on, radio_is_on, talk, talks, listen_only, is_quiet}),
    row("447-3-radio-04", "4.2.18", "a radio that is off does not transmit",
        {radio_off, radio_is_off, talk, stays(radio_device, 0, next_two_bits, 2s)}),
    row("447-3-radio-05", "4.2.18", "a radio that is turned off transmits no more",
        {radio_on, radio_is_on, talk, talks, radio_off, radio_is_off, is_quiet}),
    row("447-3-radio-06", "4.2.18", "a reserved command is refused",
        {refuse(radio_command, 0xFE), refuse(radio_command, 0xFB)}),
    row("447-3-radio-07", "4.2.18", "\"do not care\" leaves a radio as it is",
        {radio_on, radio_is_on, put(radio_command, 0xFF), stays(radio_device, 0x01, two_bits, 2s)}),
    row("447-3-radio-08", "4.2.18", "a radio tells that it is on",
        {start, radio_off, radio_is_off, radio_on, tells(radio_device, 0x01, two_bits, switched)}),
    row("447-3-radio-09", "4.2.18", "a radio without power is off, and says so",
        {radio_on, radio_is_on, put(radio_power, 0x00), radio_is_off,
         is(radio_status, 0x04, next_two_bits, switched)}),
};

// "Blue" light flashers (CiA 447-3, 4.2.22).

constexpr Place blue_command{&car::blue_light_flasher_command_object, 0};
constexpr Place blue_status{&car::blue_light_flasher_status_object, 0};
constexpr std::int64_t all_flashers_off = 0xFFF0'0000;
constexpr Step flashers_off = put(blue_command, all_flashers_off);
constexpr Step flashers_are_off = is(blue_status, 0, 0x000F'FFFF, switched);
constexpr Step first_flasher_on = put(blue_command, 0xFFFF'FFFD);
constexpr Step first_flasher_is_on = is(blue_status, 0x01, two_bits, switched);

constexpr BehaviourRow blue_rows[] = {
    row("447-3-blue-light-01", "4.2.22", "a flasher that is turned on is on",
        {flashers_off, flashers_are_off, first_flasher_on, first_flasher_is_on}),
    row("447-3-blue-light-02", "4.2.22", "a flasher that is turned off is off",
        {first_flasher_on, first_flasher_is_on, flashers_off, flashers_are_off}),
    row("447-3-blue-light-03", "4.2.22", "a command for one flasher leaves the others",
        {flashers_off, flashers_are_off, first_flasher_on, first_flasher_is_on,
         is(blue_status, 0, 0x000F'FFFC)}),
    row("447-3-blue-light-04", "4.2.22", "\"do not care\" leaves a flasher as it is",
        {first_flasher_on, first_flasher_is_on, put(blue_command, 0xFFFF'FFFF),
         stays(blue_status, 0x01, two_bits, 1s)}),
    row("447-3-blue-light-05", "4.2.22", "a reserved command is refused",
        {refuse(blue_command, 0xFFFF'FFFE)}),
    row("447-3-blue-light-06", "4.2.22", "reserved bits of a command say nothing",
        {flashers_off, flashers_are_off, put(blue_command, 0x000F'FFFD), first_flasher_is_on}),
    row("447-3-blue-light-07", "4.2.22", "reserved bits of the status are 1",
        {is(blue_status, 0xFFF0'0000, 0xFFF0'0000)}),
    row("447-3-blue-light-08", "4.2.22", "a flasher that is turned on is told",
        {start, flashers_off, flashers_are_off, first_flasher_on,
         tells(blue_status, 0x01, two_bits, switched)}),
};

// Roof bar (CiA 447-3, 4.2.20): five groups of lights.

constexpr Place roof_command(std::uint8_t sub) {
  return {&car::light_commands_roof_bar_object, sub};
}
constexpr Place roof_status(std::uint8_t sub) {
  return {&car::light_status_roof_bar_object, sub};
}
constexpr Step roof_on(std::uint8_t sub) {
  return put(roof_command(sub), 0xFFFF'FFFD);
}
constexpr Step roof_off(std::uint8_t sub) {
  return put(roof_command(sub), 0xFFFF'FFFC);
}
constexpr Step roof_is(std::uint8_t sub, std::int64_t lit) {
  return is(roof_status(sub), lit, two_bits, switched);
}

constexpr BehaviourRow roof_rows[] = {
    row("447-3-roof-bar-01", "4.2.20", "the first light of group 1 is turned on and off",
        {roof_off(1), roof_is(1, 0), roof_on(1), roof_is(1, 1), roof_off(1), roof_is(1, 0)}),
    row("447-3-roof-bar-02", "4.2.20", "the first light of group 2 is turned on and off",
        {roof_off(2), roof_is(2, 0), roof_on(2), roof_is(2, 1), roof_off(2), roof_is(2, 0)}),
    row("447-3-roof-bar-03", "4.2.20", "the first light of group 3 is turned on and off",
        {roof_off(3), roof_is(3, 0), roof_on(3), roof_is(3, 1), roof_off(3), roof_is(3, 0)}),
    row("447-3-roof-bar-04", "4.2.20", "a command for one group leaves the next",
        {roof_off(1), roof_off(2), roof_is(1, 0), roof_is(2, 0), roof_on(1), roof_is(1, 1),
         stays(roof_status(2), 0, two_bits)}),
    row("447-3-roof-bar-05", "4.2.20", "a light that is turned on is told",
        {start, roof_off(1), roof_is(1, 0), roof_on(1),
         tells(roof_status(1), 1, two_bits, switched)}),
};

// Tariff display (CiA 447-3, 4.2.16): lamps of four bits: off, on, dimmed, blinking.

constexpr Place lamps{&car::tariff_display_lamps_command_1_object, 0};
constexpr Place lamps_status{&car::tariff_display_lamps_status_1_object, 0};
constexpr Place display_power{&car::tariff_display_configuration_object, 0};
constexpr Place level_of_trip{&car::taxi_trip_tariff_level_object, 0};
constexpr Place level_shown{&car::tariff_display_tariff_level_object, 0};
constexpr std::uint64_t first_lamp = 0x0F;
constexpr Step lamp_off = put(lamps, 0xFFFF'FFF0);
constexpr Step lamp_on = put(lamps, 0xFFFF'FFF1);
constexpr Step lamp_is_off = is(lamps_status, 0, first_lamp, switched);
constexpr Step lamp_is_on = is(lamps_status, 1, first_lamp, switched);

constexpr BehaviourRow tariff_rows[] = {
    row("447-3-tariff-01", "4.2.16", "a lamp is turned on and off",
        {lamp_off, lamp_is_off, lamp_on, lamp_is_on, lamp_off, lamp_is_off}),
    row("447-3-tariff-02", "4.2.16", "a lamp is dimmed",
        {lamp_off, lamp_is_off, put(lamps, 0xFFFF'FFF2),
         is(lamps_status, 2, first_lamp, switched)}),
    row("447-3-tariff-03", "4.2.16", "a lamp blinks",
        {lamp_off, lamp_is_off, put(lamps, 0xFFFF'FFF3),
         is(lamps_status, 3, first_lamp, switched)}),
    row("447-3-tariff-04", "4.2.16",
        "a reserved command is refused, and none of its lamps is turned",
        {lamp_off, lamp_is_off, refuse(lamps, 0xFFFF'FF41), refuse(lamps, 0xFFFF'FFD1),
         lamp_is_off}),
    row("447-3-tariff-05", "4.2.16", "\"do not care\" leaves a lamp as it is",
        {lamp_on, lamp_is_on, put(lamps, 0xFFFF'FFFF), stays(lamps_status, 1, first_lamp, 1s)}),
    row("447-3-tariff-06", "4.2.16", "the tariff level of a taximeter is shown",
        {put(level_of_trip, 0x4132), is(level_shown, 0x32, 0xFF)}),
    row("447-3-tariff-07", "4.2.16", "a tariff level that is no text is not shown",
        {put(level_of_trip, 0x8007), is(level_shown, 0xFFFF)}),
    row("447-3-tariff-08", "4.2.16",
        "powered down, its lamps are off; powered up they are as before",
        {lamp_on, lamp_is_on, put(display_power, 0xFD), lamp_is_off, put(display_power, 0xFC),
         lamp_is_on}),
    row("447-3-tariff-09", "4.2.16", "a reserved configuration is refused",
        {refuse(display_power, 0xFE)}),
};

// Hand-free conversation and taxi alarm (CiA 447-3, 4.2.23 and 4.2.17).

constexpr Place hands_free_command{&car::radio_hand_free_command_object, 0};
constexpr Place hands_free_key{&car::radio_hand_free_status_object, 0};
constexpr Place taxi_alarm{&car::taxi_alarm_system_status_object, 0};
constexpr std::string_view press_key = "press the key of the hand-free equipment";
constexpr std::string_view let_key_go = "let the key of the hand-free equipment go";
constexpr std::string_view press_alarm = "press the alarm key";
constexpr std::string_view let_alarm_go = "let the alarm key go";

constexpr BehaviourRow key_rows[] = {
    row("447-3-hands-free-01", "4.2.23", "the LED is lit and put out",
        {put(hands_free_command, 0xFD), see("the LED of the hand-free equipment is lit"),
         put(hands_free_command, 0xFC), see("the LED of the hand-free equipment is dark")}),
    row("447-3-hands-free-02", "4.2.23", "a reserved command is refused",
        {refuse(hands_free_command, 0xFE), refuse(hands_free_command, 0xF9)}),
    row("447-3-hands-free-03", "4.2.23", "the key is told, pressed and let go",
        {hand(let_key_go), start, wait(100ms), hand(press_key), tells(hands_free_key, 1, two_bits),
         hand(let_key_go), tells(hands_free_key, 0, two_bits)}),
    row("447-3-taxi-alarm-01", "4.2.17", "the alarm key is told while it is pressed",
        {hand(let_alarm_go), start, wait(100ms), hand(press_alarm), tells(taxi_alarm, 0x10, 0x30),
         hand(let_alarm_go), tells(taxi_alarm, 0x00, 0x30)}),
    row("447-3-taxi-alarm-02", "4.2.17", "reserved bits of the status are 1",
        {is(taxi_alarm, 0xFC00, 0xFC00)}),
};

// Real time clock (CiA 447-3, 4.2.14): year in bits 15 to 0, month in 19 to 16, day in 27 to 20,
// the others 1.

constexpr Place date{&car::rtc_date_object, 0};
constexpr Place set_date{&car::set_rtc_date_object, 0};
constexpr Place clock_time{&car::rtc_time_object, 0};
constexpr Place set_time{&car::set_rtc_time_object, 0};
constexpr std::int64_t day_of_2026 = 0xF17B'07EA;  ///< 23rd November 2026
constexpr std::int64_t month_13 = 0xF17D'07EA;
constexpr std::int64_t february_30 = 0xF1E2'07EA;
constexpr std::int64_t half_past_twelve = 0x0000'1E0C;

constexpr BehaviourRow clock_rows[] = {
    row("447-3-clock-01", "4.2.14", "a date that is set is told",
        {put(set_date, day_of_2026), is(date, day_of_2026, 0x0FFF'FFFF)}),
    row("447-3-clock-02", "4.2.14", "a time that is set is told, and goes on",
        {put(set_time, half_past_twelve), is(clock_time, half_past_twelve, 0xFFFF)}),
    row("447-3-clock-03", "4.2.14", "a month that there is not is refused",
        {refuse(set_date, month_13)}),
    row("447-3-clock-04", "4.2.14", "a day that there is not is refused",
        {refuse(set_date, february_30)}),
    row("447-3-clock-05", "4.2.14", "an hour or a minute that there is not is refused",
        {refuse(set_time, 0x0000'0018), refuse(set_time, 0x0000'3C0C)}),
};

// Taximeter (CiA 447-3, 4.2.12): only the provider of an input writes it (CiA 447-3, 4.2.4).

constexpr Place meter_status{&car::taximeter_status_object, 0};
constexpr Place pulses{&car::wheel_pulse_counter_object, 0};
constexpr Place overrun{&car::wheel_pulse_counter_overrun_value_object, 0};
constexpr Place pulse_source{&car::wheel_signal_source_object, 0};
constexpr Place pulses_of_turn{&car::pulses_per_wheel_rotation_object, 0};

constexpr BehaviourRow meter_rows[] = {
    row("447-3-taximeter-01", "4.2.12", "a meter refuses the pulses of a stranger",
        {refuse(pulses, 0x00FD'01F4)}, {Place{&car::taximeter_status_object, 0}}),
    row("447-3-taximeter-02", "4.2.12", "a meter refuses the overrun value of a stranger",
        {refuse(overrun, 0x00FD'00C8)}, {Place{&car::taximeter_status_object, 0}}),
    row("447-3-taximeter-03", "4.2.12", "a meter refuses the signal source of a stranger",
        {refuse(pulse_source, 0x02)}, {Place{&car::taximeter_status_object, 0}}),
    row("447-3-taximeter-04", "4.2.12", "a meter refuses the pulses of a turn of a stranger",
        {refuse(pulses_of_turn, 0x30)}, {Place{&car::taximeter_status_object, 0}}),
    row("447-3-taximeter-05", "4.2.12", "nobody writes the state of a meter",
        {refuse(meter_status, 0xC1)}, {Place{&car::taxi_trip_payment_object, 1}}),
    row("447-3-taximeter-06", "4.2.12", "nobody writes what a trip costs",
        {refuse({&car::taxi_trip_payment_object, 1}, 0)},
        {Place{&car::taximeter_totalizers_object, 1}}),
    row("447-3-taximeter-07", "4.2.12", "nobody writes what a meter has added up",
        {refuse({&car::taximeter_totalizers_object, 1}, 0)},
        {Place{&car::taxi_trip_payment_object, 1}}),
};

// Texts of terminal and printer (CiA 447-3, 4.2.9 and 4.2.13).

constexpr Place display_command{&car::display_1_command_object, 0};
constexpr Place key_pad{&car::number_pad_command_object, 0};
constexpr Place display_text{&car::display_1_text_object, 0};
constexpr Step lock_display = put(display_command, 0xFD);
constexpr Step release_display = put(display_command, 0xFC);
constexpr Place print_mode_command{&car::printer_mode_command_object, 0};
constexpr Place print_mode{&car::printer_mode_status_object, 0};
constexpr Place transport{&car::printer_transport_object, 0};
constexpr Place printer_status{&car::printer_status_object, 0};
/// Longer than the largest display (CiA 447-3, 4.2.9.17).
constexpr std::string_view longer_than_any_display =
    "a text that no display of a car can show, since it is longer than the 254 characters that the "
    "parameters of one can say; it goes on, and on, without end, and says nothing but that it is "
    "long, so that it must be refused, whatever the display is: of one line, of two, or of many.";

constexpr BehaviourRow text_rows[] = {
    row("447-3-display-01", "4.2.9.20", "who has locked a display writes on it",
        {lock_display, put_text(display_text, "abc"), is_text(display_text, "abc"),
         release_display}),
    row("447-3-display-02", "4.2.9.20", "a text that the display has no room for is refused",
        {lock_display, put_text(display_text, "abc"),
         refuse_text(display_text, longer_than_any_display), is_text(display_text, "abc"),
         release_display}),
    row("447-3-keys-01", "4.2.9.2", "a reserved command is refused", {refuse(key_pad, 0xFE)}),
    row("447-3-printer-01", "4.2.13", "a text that is transported makes a printer busy",
        {start, wait(1s), put_text(transport, "Hello\n"), tells_any(printer_status, switched)}),
    row("447-3-printer-02", "4.2.13", "\"do not care\" leaves the mode as it is",
        {put(print_mode_command, 0xFF)}),
    row("447-3-printer-03", "4.2.13", "a reserved mode is refused",
        {refuse(print_mode_command, 0xFE)}, {print_mode}),
};

// Audio switch (CiA 447-3, 4.2.19): input, output and gain, a byte each.

constexpr Place connection{&car::audio_switch_command_object, 0};
constexpr Place question{&car::audio_switch_status_request_object, 0};
constexpr Place gain{&car::audio_switch_status_response_object, 0};

constexpr BehaviourRow audio_rows[] = {
    row("447-3-audio-01", "4.2.19", "an input is connected with an output",
        {put(connection, 0x50'0307), put(question, 0x0307), is(gain, 0x50)}),
    row("447-3-audio-02", "4.2.19", "a connection is one way",
        {put(connection, 0x00'0000), put(connection, 0x50'0307), put(question, 0x0703),
         is(gain, 0x00)}),
    row("447-3-audio-03", "4.2.19", "an input is disconnected",
        {put(connection, 0x50'0307), put(connection, 0x00'0307), put(question, 0x0307),
         is(gain, 0x00)}),
    row("447-3-audio-04", "4.2.19", "a reserved channel is refused",
        {refuse(connection, 0x50'0311)}),
};

// The gateway to the car (CiA 447-3, 4.2.2, 4.2.3).

constexpr Place horn_command{&car::horn_command_object, 0};
constexpr Place horn{&car::horn_status_object, 0};

constexpr BehaviourRow gateway_rows[] = {
    row("447-3-gateway-01", "4.2.3.9",
        "a horn that is turned on sounds, and one that is turned off not",
        {put(horn_command, 0xFD), is(horn, 1, two_bits, switched), put(horn_command, 0xFC),
         is(horn, 0, two_bits, switched)}),
    row("447-3-gateway-02", "4.2.3.9", "a reserved command of the horn is refused",
        {refuse(horn_command, 0xFE)}),
};

}  // namespace
}  // namespace of_447

std::vector<std::span<const BehaviourRow>> rows_of_447() {
  using namespace of_447;  // NOLINT(google-build-using-namespace): its tables
  return {radio_rows, blue_rows,  roof_rows, tariff_rows, key_rows,
          clock_rows, meter_rows, text_rows, audio_rows,  gateway_rows};
}

}  // namespace canvoy::conformance
