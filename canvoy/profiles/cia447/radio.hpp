// CiA 447-3, clauses 4.2.17 to 4.2.19 and 4.2.23: taxi alarm, radio, audio switch, hand-free
// conversation.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

inline constexpr auto taxi_alarm_system_status_fields = side_by_side(
    field(2, "saa", "silent alarm activated", no_yes),
    field(2, "faa", "full alarm activated", no_yes), field(2, "akp", "alarm key pressed", no_yes),
    field(2, "rakp", "remote alarm key pressed", no_yes),
    field(2, "recr", "radio emergency call requested", no_yes), reserved<1, 6>());
inline constexpr auto taxi_alarm_system_status_object = variable_object(
    0x6110, "Taxi alarm system status", "4.2.17.1", "Which alarm there is.",
    status(DataType::unsigned16, Mapping::by_default, taxi_alarm_system_status_fields));

// 4.2.18: radio.

inline constexpr auto radio_status_fields =
    side_by_side(field(2, "rerr1", "radio error 1", no_yes),
                 field(2, "rpod", "radio power off detected", no_yes), reserved<4>());
inline constexpr auto radio_status_object =
    variable_object(0x6115, "Radio status", "4.2.18.1", "Whether the radio works.",
                    status(DataType::unsigned8, Mapping::by_default, radio_status_fields));
inline constexpr auto radio_power_commands =
    command_values<2>("Turn off the radio power", "Turn on the radio power");
inline constexpr auto push_to_talk_commands =
    command_values<2>("Release push-to-talk", "Set push-to-talk");
inline constexpr auto radio_device_command_fields =
    side_by_side(field(2, "rp", "radio power", radio_power_commands),
                 field(2, "ptt", "push-to-talk", push_to_talk_commands), reserved<4>());
inline constexpr auto radio_device_command_object = variable_object(
    0x6116, "Radio device command", "4.2.18.2", "Switches the radio, lets it transmit.",
    command(DataType::unsigned8, radio_device_command_fields));
inline constexpr auto radio_power_states =
    status_values<2>("Radio power is off", "Radio power is on");
inline constexpr auto push_to_talk_states = status_values<2>(
    "Ready to transmit, push-to-talk released", "Transmit in the moment, push-to-talk is set");
inline constexpr auto radio_device_status_fields =
    side_by_side(field(2, "rp", "radio power", radio_power_states),
                 field(2, "tx-ptt", "transmit push-to-talk", push_to_talk_states), reserved<4>());
inline constexpr auto radio_device_status_object = variable_object(
    0x6117, "Radio device status", "4.2.18.3", "Whether the radio is on and transmits.",
    status(DataType::unsigned8, Mapping::by_default, radio_device_status_fields));

// 4.2.19: audio switch. A channel is the physical device that has the channel's number as its
// node-ID.

inline constexpr NamedValue input_channel_names[] = {command_sentinels<8>.second_highest,
                                                     command_sentinels<8>.highest,
                                                     {0x00, "All input channels"},
                                                     reserved_codes(0x11, 0xFD)};
inline constexpr NamedValue output_channel_names[] = {command_sentinels<8>.second_highest,
                                                      command_sentinels<8>.highest,
                                                      {0x00, "All output channels"},
                                                      reserved_codes(0x11, 0xFD)};
inline constexpr NamedValue gain_command_names[] = {command_sentinels<8>.second_highest,
                                                    command_sentinels<8>.highest,
                                                    {0x00, "Channel disconnected"}};
/// An audio channel, 1 to 16, or one of the named codes.
constexpr ValueInfo channel(Items<NamedValue> names) {
  return {.limits = within(0x00, 0x10), .names = names};
}
inline constexpr ValueInfo gain_command = {.limits = within(0x00, 0xFD),
                                           .names = gain_command_names};
inline constexpr auto audio_switch_command_fields =
    side_by_side(field(8, "audio input channel", "from where", channel(input_channel_names)),
                 field(8, "audio output channel", "to where", channel(output_channel_names)),
                 field(8, "gain", "how loud", gain_command));
inline constexpr auto audio_switch_command_object = variable_object(
    0x6120, "Audio switch command", "4.2.19.1", "Connects an audio input with an audio output.",
    command(DataType::unsigned24, audio_switch_command_fields), {.errata = "Z04"});

// The second highest code of a request is reserved, like those below it (errata Z35).
inline constexpr NamedValue requested_input_names[] = {
    command_sentinels<8>.highest, {0x00, "All input channels"}, reserved_codes(0x11, 0xFE)};
inline constexpr NamedValue requested_output_names[] = {
    command_sentinels<8>.highest, {0x00, "All output channels"}, reserved_codes(0x11, 0xFE)};
inline constexpr auto audio_switch_status_request_fields =
    side_by_side(field(8, "audio input channel", "from where", channel(requested_input_names)),
                 field(8, "audio output channel", "to where", channel(requested_output_names)));
inline constexpr auto audio_switch_status_request_object = variable_object(
    0x6121, "Audio switch status request", "4.2.19.2",
    "Asks for the gain between an input and an output: 6122h tells it.",
    command(DataType::unsigned16, audio_switch_status_request_fields), {.errata = "Z32, Z35"});
inline constexpr NamedValue gain_names[] = {status_sentinels<8>.second_highest,
                                            status_sentinels<8>.highest,
                                            {0x00, "Channel disconnected"}};
inline constexpr auto audio_switch_status_response_object = variable_object(
    0x6122, "Audio switch status response", "4.2.19.3", "The gain that 6121h asked for.",
    status(DataType::unsigned8, Mapping::no,
           ValueInfo{.limits = within(0x00, 0xFD), .names = gain_names}),
    {.errata = "Z32"});

// 4.2.23: hand-free conversation by radio.

inline constexpr auto hand_free_key_states =
    status_values<2>("Radio hand-free key is not pressed", "Radio hand-free key is pressed");
inline constexpr auto radio_hand_free_status_fields = side_by_side(
    field(2, "radio hand-free key", "whether it is pressed", hand_free_key_states), reserved<6>());
inline constexpr auto radio_hand_free_status_object =
    variable_object(0x6150, "Radio hand-free status", "4.2.23.1", "Whether the key is pressed.",
                    status(DataType::unsigned8, Mapping::by_default, radio_hand_free_status_fields),
                    {.errata = "Z47"});
inline constexpr auto indication_led_commands =
    command_values<2>("Request to switch radio active indication LED off",
                      "Request to switch radio active indication LED on");
inline constexpr auto audio_mute_commands =
    command_values<2>("Request to switch audio mute off", "Request to switch audio mute on");
inline constexpr auto radio_hand_free_command_fields = side_by_side(
    field(2, "indication LED", "shows that the radio is active", indication_led_commands),
    field(2, "audio mute", "silences what else is heard", audio_mute_commands), reserved<4>());
inline constexpr auto radio_hand_free_command_object = variable_object(
    0x6151, "Radio hand-free command", "4.2.23.2", "Shows and hears a call.",
    command(DataType::unsigned8, radio_hand_free_command_fields), {.errata = "Z47"});

}  // namespace canvoy::cia447
