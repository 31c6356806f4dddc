// CiA 447-3: enumerators beside what the tables print for their codes: add-on devices.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia447/equipment_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/cia447/testing/printed.hpp"

namespace canvoy::cia447::add_on_states_test {
namespace {

TEST(Cia447States, TerminalAccess) {
  using enum TerminalAccess;
  EXPECT_EQ(printed<TerminalAccess>(
                number_pad_status_access,
                {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
                 device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
                 device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
            "Number pad access is not active|Number pad access is not active|Number pad access by "
            "standard vehicle application|Number pad access by car add-on device 1|Number pad "
            "access by car add-on device 2|Number pad access by car add-on device 3|Number pad "
            "access by car add-on device 4|Number pad access by car add-on device 5|Number pad "
            "access by car add-on device 6|Number pad access by car add-on device 7|Number pad "
            "access by car add-on device 8|Number pad access by car add-on device 9|Number pad "
            "access by car add-on device 10|Number pad access by car add-on device 11|Number pad "
            "access by car add-on device 12|Number pad access by car add-on device 13|Number pad "
            "access by car add-on device 14|Number pad access by car add-on device 15|Number pad "
            "access by car add-on device 16|Failure|Signal not available");
  EXPECT_EQ(
      printed<TerminalAccess>(
          function_keys_status_key_access,
          {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
           device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
           device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
      "Function key access is not active|Function key access is not active|Function key access by "
      "standard vehicle application|Function key access by car add-on device 1|Function key access "
      "by car add-on device 2|Function key access by car add-on device 3|Function key access by "
      "car add-on device 4|Function key access by car add-on device 5|Function key access by car "
      "add-on device 6|Function key access by car add-on device 7|Function key access by car "
      "add-on device 8|Function key access by car add-on device 9|Function key access by car "
      "add-on device 10|Function key access by car add-on device 11|Function key access by car "
      "add-on device 12|Function key access by car add-on device 13|Function key access by car "
      "add-on device 14|Function key access by car add-on device 15|Function key access by car "
      "add-on device 16|Failure|Signal not available");
  EXPECT_EQ(printed<TerminalAccess>(
                control_keys_status_key_access,
                {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
                 device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
                 device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
            "Control key access is not active|Control key access is not active|Control key access "
            "by standard vehicle application|Control key access by car add-on device 1|Control key "
            "access by car add-on device 2|Control key access by car add-on device 3|Control key "
            "access by car add-on device 4|Control key access by car add-on device 5|Control key "
            "access by car add-on device 6|Control key access by car add-on device 7|Control key "
            "access by car add-on device 8|Control key access by car add-on device 9|Control key "
            "access by car add-on device 10|Control key access by car add-on device 11|Control key "
            "access by car add-on device 12|Control key access by car add-on device 13|Control key "
            "access by car add-on device 14|Control key access by car add-on device 15|Control key "
            "access by car add-on device 16|Failure|Signal not available");
  EXPECT_EQ(
      printed<TerminalAccess>(
          steering_wheel_switch_pad_status_access,
          {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
           device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
           device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
      "Steering wheel access is not active|Steering wheel access is not active|Steering wheel "
      "access by standard vehicle application|Steering wheel access by car add-on device "
      "1|Steering wheel access by car add-on device 2|Steering wheel access by car add-on device "
      "3|Steering wheel access by car add-on device 4|Steering wheel access by car add-on device "
      "5|Steering wheel access by car add-on device 6|Steering wheel access by car add-on device "
      "7|Steering wheel access by car add-on device 8|Steering wheel access by car add-on device "
      "9|Steering wheel access by car add-on device 10|Steering wheel access by car add-on device "
      "11|Steering wheel access by car add-on device 12|Steering wheel access by car add-on device "
      "13|Steering wheel access by car add-on device 14|Steering wheel access by car add-on device "
      "15|Steering wheel access by car add-on device 16|Failure|Signal not available");
  EXPECT_EQ(
      printed<TerminalAccess>(
          emergency_key_status_access,
          {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
           device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
           device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
      "Emergency key access is not active|Emergency key access is not active|Emergency key access "
      "by standard vehicle application|Emergency key access by car add-on device 1|Emergency key "
      "access by car add-on device 2|Emergency key access by car add-on device 3|Emergency key "
      "access by car add-on device 4|Emergency key access by car add-on device 5|Emergency key "
      "access by car add-on device 6|Emergency key access by car add-on device 7|Emergency key "
      "access by car add-on device 8|Emergency key access by car add-on device 9|Emergency key "
      "access by car add-on device 10|Emergency key access by car add-on device 11|Emergency key "
      "access by car add-on device 12|Emergency key access by car add-on device 13|Emergency key "
      "access by car add-on device 14|Emergency key access by car add-on device 15|Emergency key "
      "access by car add-on device 16|Failure|Signal not available");
  EXPECT_EQ(
      printed<TerminalAccess>(
          display_1_status,
          {none,      off,       vehicle,   device_1,  device_2,  device_3,  device_4,
           device_5,  device_6,  device_7,  device_8,  device_9,  device_10, device_11,
           device_12, device_13, device_14, device_15, device_16, failure,   not_available}),
      "Off|Off|On and access by standard vehicle application|On and access by car add-on device "
      "1|On and access by car add-on device 2|On and access by car add-on device 3|On and access "
      "by car add-on device 4|On and access by car add-on device 5|On and access by car add-on "
      "device 6|On and access by car add-on device 7|On and access by car add-on device 8|On and "
      "access by car add-on device 9|On and access by car add-on device 10|On and access by car "
      "add-on device 11|On and access by car add-on device 12|On and access by car add-on device "
      "13|On and access by car add-on device 14|On and access by car add-on device 15|On and "
      "access by car add-on device 16|Failure|Signal not available");
}

TEST(Cia447States, AccessCommand) {
  using enum AccessCommand;
  EXPECT_EQ(
      printed<AccessCommand>(number_pad_command, {release, lock, not_implemented, do_not_care}),
      "Release (control device by vehicle standard application)|Lock (control device by car add-on "
      "device application)|Function not implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<AccessCommand>(display_1_command, {release, lock, lock_for_iso_tp, do_not_care}),
      "Release (control device by vehicle standard application)|Lock device for car add-on device "
      "application (usage of CANopen objects)|Lock device for ISO-TP transmitted content|Don't "
      "care, take no action");
  EXPECT_EQ(
      printed<AccessCommand>(display_2_command, {release, lock, not_implemented, do_not_care}),
      "Release (control device by vehicle standard application)|Lock (lock device for car add-on "
      "device application)|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, NumberPadKey) {
  using enum NumberPadKey;
  EXPECT_EQ(printed<NumberPadKey>(number_pad_user_interaction,
                                  {none, key_1, key_2, key_3, key_4, key_5, key_6, key_7, key_8,
                                   key_9, hash, key_0, star, several, failure, not_available}),
            "No key pressed|Key 1 pressed|Key 2 pressed|Key 3 pressed|Key 4 pressed|Key 5 "
            "pressed|Key 6 pressed|Key 7 pressed|Key 8 pressed|Key 9 pressed|Key # pressed|Key 0 "
            "pressed|Key * pressed|More than one key pressed|Failure|Signal not available");
}

TEST(Cia447States, FunctionKey) {
  using enum FunctionKey;
  EXPECT_EQ(printed<FunctionKey>(function_keys_user_interaction_key,
                                 {none, key_1, key_2, key_3, key_4, key_5, key_6, key_7, several,
                                  failure, not_available}),
            "No key pressed|Function key 1 pressed|Function key 2 pressed|Function key 3 "
            "pressed|Function key 4 pressed|Function key 5 pressed|Function key 6 pressed|Function "
            "key 7 pressed|More than one key pressed|Failure|Signal not available");
}

TEST(Cia447States, ControlKey) {
  using enum ControlKey;
  EXPECT_EQ(printed<ControlKey>(control_keys_user_interaction_key,
                                {none, up, down, right, left, turn_right, turn_left, ok, clear,
                                 back, send, end, f1, f2, f3, f4, several, failure, not_available}),
            "No key pressed|Key \"up\" pressed|Key \"down\" pressed|Key \"right\" pressed|Key "
            "\"left\" pressed|Key \"turn right\" pressed|Key \"turn left\" pressed|Key \"OK\" "
            "pressed|Key \"clear\" pressed|Key \"return\" pressed|Key \"send\" pressed|Key \"end\" "
            "pressed|F1 pressed|F2 pressed|F3 pressed|F4 pressed|More than one key "
            "pressed|Failure|Signal not available");
}

TEST(Cia447States, TipSwitch) {
  using enum TipSwitch;
  EXPECT_EQ(printed<TipSwitch>(steering_wheel_switch_pad_user_interaction,
                               {none, switch_1, switch_2, switch_3, switch_4, switch_5, switch_6,
                                switch_7, switch_8, switch_9, switch_10, switch_11, switch_12,
                                several, failure, not_available}),
            "No steering wheel tip switch pressed|Steering wheel tip switch 1 pressed|Steering "
            "wheel tip switch 2 pressed|Steering wheel tip switch 3 pressed|Steering wheel tip "
            "switch 4 pressed|Steering wheel tip switch 5 pressed|Steering wheel tip switch 6 "
            "pressed|Steering wheel tip switch 7 pressed|Steering wheel tip switch 8 "
            "pressed|Steering wheel tip switch 9 pressed|Steering wheel tip switch 10 "
            "pressed|Steering wheel tip switch 11 pressed|Steering wheel tip switch 12 "
            "pressed|More than one steering wheel tip switch pressed|Failure|Signal not available");
}

TEST(Cia447States, WarningCommand) {
  using enum WarningCommand;
  EXPECT_EQ(
      printed<WarningCommand>(
          functional_warnings_command,
          {reset_all, reset_fire_cartridge_empty, reset_fire_active, reset_fire_on,
           reset_fire_fault, reset_air_cylinder_empty, reset_air_active, reset_air_inactive,
           set_fire_cartridge_empty, set_fire_active, set_fire_on, set_fire_fault,
           set_air_cylinder_empty, set_air_active, set_air_inactive, not_implemented, do_not_care}),
      "Reset all warnings|Reset fire extinguishing system cartridge empty|Reset fire extinguishing "
      "system active|Reset fire extinguishing system on|Reset fire extinguishing system "
      "fault|Reset fresh air system cylinder empty|Reset fresh air system active|Reset fresh air "
      "system inactive|Set fire extinguishing system cartridge empty|Set fire extinguishing system "
      "active|Set fire extinguishing system on|Set fire extinguishing system fault|Set fresh air "
      "system cylinder empty|Set fresh air system active|Set fresh air system inactive|Function "
      "not implemented|Don't care, take no action");
}

TEST(Cia447States, IconAccess) {
  using enum IconAccess;
  EXPECT_EQ(printed<IconAccess>(icon_display_1_status, {released, locked, failure, not_available}),
            "Released (device controlled by vehicle standard application)|Locked (device locked "
            "for car add-on device application)|Failure|Signal not available");
}

TEST(Cia447States, Icon) {
  using enum Icon;
  EXPECT_EQ(printed<Icon>(icon_display_1_command_content,
                          {none, antenna, micro, empty_circle, filled_circle, speaker_on,
                           speaker_off, signal_out, signal_in, gps_active, crossed_circle, bell,
                           clock, skip_to_end, taximeter, not_implemented, do_not_care}),
            "Display no icon|Display icon number 1: DIN_PicAntenna|Display icon number 2: "
            "DIN_PicMicro|Display icon number 3: DIN_PicEmptyCircle|Display icon number 4: "
            "DIN_PicFilledCircle|Display icon number 5: DIN_PicSpeakerOn|Display icon number 6: "
            "DIN_PicSpeakerOff|Display icon number 7: DIN_PicSignalOut|Display icon number 8: "
            "DIN_PicSignalIn|Display icon number 9: DIN_PicGPSActive|Display icon number 10: "
            "DIN_PicCrossedCircle|Display icon number 11: DIN_PicBell|Display icon number 12: "
            "DIN_PicClock|Display icon number 13: DIN_PicSkipToEnd (search run)|Display icon "
            "number 14: DIN_PicTaxameter|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<Icon>(icon_display_1_status_content,
                          {none, antenna, micro, empty_circle, filled_circle, speaker_on,
                           speaker_off, signal_out, signal_in, gps_active, crossed_circle, bell,
                           clock, skip_to_end, taximeter, failure, not_available}),
            "Display no icon|Display icon number 1: DIN_PicAntenna|Display icon number 2: "
            "DIN_PicMicro|Display icon number 3: DIN_PicEmptyCircle|Display icon number 4: "
            "DIN_PicFilledCircle|Display icon number 5: DIN_PicSpeakerOn|Display icon number 6: "
            "DIN_PicSpeakerOff|Display icon number 7: DIN_PicSignalOut|Display icon number 8: "
            "DIN_PicSignalIn|Display icon number 9: DIN_PicGPSActive|Display icon number 10: "
            "DIN_PicCrossedCircle|Display icon number 11: DIN_PicBell|Display icon number 12: "
            "DIN_PicClock|Display icon number 13: DIN_PicSkipToEnd (search run)|Display icon "
            "number 14: DIN_PicTaxameter|Failure|Signal not available");
}

TEST(Cia447States, IconFormat) {
  using enum IconFormat;
  EXPECT_EQ(printed<IconFormat>(icon_display_1_command_format,
                                {standard, highlighted, not_implemented, do_not_care}),
            "Standard|Highlighted|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<IconFormat>(icon_display_1_status_format,
                                {standard, highlighted, failure, not_available}),
            "Standard|Highlighted|Failure|Signal not available");
}

TEST(Cia447States, GpsFix) {
  using enum GpsFix;
  EXPECT_EQ(printed<GpsFix>(gps_status_fix, {none, fix_2d, fix_3d, failure, not_available}),
            "No fix|2D fix|3D fix|Failure|Signal not available");
}

TEST(Cia447States, StartGuidance) {
  using enum StartGuidance;
  EXPECT_EQ(printed<StartGuidance>(start_route_guidance_start,
                                   {without_interrupting, with_interrupting, do_not_care}),
            "Start route guidance without interrupting currently active guidance|Start route "
            "guidance with interrupting currently active guidance|Don't care, take no action");
}

TEST(Cia447States, PositionRequest) {
  using enum PositionRequest;
  EXPECT_EQ(printed<PositionRequest>(current_position_request, {read, do_not_care}),
            "Read current position country, city and street|Don't care, take no action");
}

TEST(Cia447States, FareMode) {
  using enum FareMode;
  EXPECT_EQ(printed<FareMode>(
                taxi_trip_payment_fare_calculation_mode,
                {single_calculation, double_calculation, fixed_price, failure, not_available}),
            "Single calculation mode S|Double calculation mode D|Fixed price|Failure|Signal not "
            "available");
}

TEST(Cia447States, Taximeter) {
  using enum Taximeter;
  EXPECT_EQ(
      printed<Taximeter>(taximeter_status, {for_hire, hired, stopped, signed_off, service_mode,
                                            standby_mode, failure, not_available}),
      "For hire|Hired|Stopped|Signed off|Service mode|Standby mode|Failure|Signal not available");
}

TEST(Cia447States, TaximeterMode) {
  using enum TaximeterMode;
  EXPECT_EQ(
      printed<TaximeterMode>(taximeter_configuration_mode,
                             {taximeter_operation, odometer_operation, failure, not_available}),
      "Taximeter operation|Odometer operation|Failure|Signal not available");
}

TEST(Cia447States, PrinterState) {
  using enum PrinterState;
  EXPECT_EQ(printed<PrinterState>(printer_status, {ready, busy, standby, failure, not_available}),
            "Ready|Busy|Standby mode|Failure|Signal not available");
}

TEST(Cia447States, FontCommand) {
  using enum FontCommand;
  EXPECT_EQ(printed<FontCommand>(printer_configuration_command_print_bold,
                                 {no_command, execute, not_implemented, do_not_care}),
            "No command|Execute the command|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, ColorSpaceCommand) {
  using enum ColorSpaceCommand;
  EXPECT_EQ(printed<ColorSpaceCommand>(printer_configuration_command_use_certain_color_space,
                                       {no_command, rgb, cmyk, do_not_care}),
            "No command|Use RGB color space|Use CMYK color space|Don't care, take no action");
}

TEST(Cia447States, ColorSpace) {
  using enum ColorSpace;
  EXPECT_EQ(printed<ColorSpace>(printer_configuration_status_color_space,
                                {rgb, cmyk, failure, not_available}),
            "RGB color space is set|CMYK color space is set|Failure|Signal not available");
}

TEST(Cia447States, PrinterMode) {
  using enum PrinterMode;
  EXPECT_EQ(printed<PrinterMode>(printer_mode_command,
                                 {text, graphics_black, graphics_gray, graphics_rgb, graphics_cmyk,
                                  logo, not_implemented, do_not_care}),
            "Print Text|Print graphics black with ESC|Print graphics gray with ESC|Print graphics "
            "RGB with ESC|Print graphics CMYK with ESC|Print logo|Function not implemented|Don't "
            "care, take no action");
  EXPECT_EQ(
      printed<PrinterMode>(printer_mode_status, {text, graphics_black, graphics_gray, graphics_rgb,
                                                 graphics_cmyk, logo, failure, not_available}),
      "Text|Graphics black with ESC|Graphics gray with ESC|Graphics RGB with ESC|Graphics CMYK "
      "with ESC|Logo mode|Failure|Signal not available");
}

TEST(Cia447States, RtcSource) {
  using enum RtcSource;
  EXPECT_EQ(
      printed<RtcSource>(rtc_type_and_status_source,
                         {unknown, gps, time_normal, battery_buffered, failure, not_available}),
      "Unknown|GPS|Time normal|Battery buffered RTC (taximeter intern)|Failure|Signal not "
      "available");
}

TEST(Cia447States, RtcTrustability) {
  using enum RtcTrustability;
  EXPECT_EQ(
      printed<RtcTrustability>(rtc_type_and_status_trustability,
                               {user_adjustable, accepted_by_authority, failure, not_available}),
      "User adjustable|Accepted by authority|Failure|Signal not available");
}

TEST(Cia447States, LampInput) {
  using enum LampInput;
  EXPECT_EQ(printed<LampInput>(tariff_display_information_and_status_input,
                               {can, discrete_inputs, failure, not_available}),
            "CAN used|Discrete inputs used (lamp driver input)|Failure|Signal not available");
}

TEST(Cia447States, LampFailure) {
  using enum LampFailure;
  EXPECT_EQ(printed<LampFailure>(tariff_display_lamp_failures_1_taxi_light,
                                 {none, open_load, over_load, failure, not_available}),
            "No lamp failure|Open load|Over load|Failure|Signal not available");
}

TEST(Cia447States, Lamp) {
  using enum Lamp;
  EXPECT_EQ(printed<Lamp>(tariff_display_lamps_status_1_taxi_light,
                          {off, on, dimmed, blinking, failure, not_available}),
            "Lamp off|Lamp on|Lamp dimmed|Lamp blinking|Failure|Signal not available");
  EXPECT_EQ(printed<Lamp>(tariff_display_lamps_command_1_taxi_light,
                          {off, on, dimmed, blinking, not_implemented, do_not_care}),
            "Lamp off|Lamp on|Lamp dimmed|Lamp blinking|Function not implemented|Don't care, take "
            "no action");
}

TEST(Cia447States, DisplayConfiguration) {
  using enum DisplayConfiguration;
  EXPECT_EQ(printed<DisplayConfiguration>(tariff_display_configuration_configure,
                                          {no_command, can, discrete_inputs, do_not_care}),
            "No configuration command|Configure via CAN: CAN operation|Configure by using discrete "
            "inputs: Discrete operation|Don't care, take no action");
}

TEST(Cia447States, SearchLampTurn) {
  using enum SearchLampTurn;
  EXPECT_EQ(printed<SearchLampTurn>(light_commands_roof_bar_swing_search_lamp_right_left,
                                    {stop, right, left, do_not_care}),
            "Stop swinging right/left|Swing the search lamp right|Swing the search lamp left|Don't "
            "care, take no action");
  EXPECT_EQ(printed<SearchLampTurn>(light_status_roof_bar_swing_search_lamp_right_left,
                                    {stop, right, left, not_available}),
            "The function is not active|The search lamp is moving right|The search lamp is moving "
            "left|Signal not available");
}

TEST(Cia447States, SearchLampTilt) {
  using enum SearchLampTilt;
  EXPECT_EQ(printed<SearchLampTilt>(light_commands_roof_bar_swing_search_lamp_up_down,
                                    {stop, up, down, do_not_care}),
            "Stop swinging up/down|Swing the search lamp up|Swing the search lamp down|Don't care, "
            "take no action");
  EXPECT_EQ(printed<SearchLampTilt>(light_status_roof_bar_swing_search_lamp_up_down,
                                    {stop, up, down, not_available}),
            "The function is not active|The search lamp is moving up|The search lamp is moving "
            "down|Signal not available");
}

TEST(Cia447States, SearchLampPosition) {
  using enum SearchLampPosition;
  EXPECT_EQ(printed<SearchLampPosition>(light_commands_roof_bar_search_lamp_position,
                                        {position_1, position_2, position_3, do_not_care}),
            "Bring search lamp in position 1|Bring search lamp in position 2|Bring search lamp in "
            "position 3|Don't care, take no action");
  EXPECT_EQ(printed<SearchLampPosition>(light_status_roof_bar_search_lamp_position,
                                        {position_1, position_2, position_3, not_available}),
            "The search lamp is in position 1|The search lamp is in position 2|The search lamp is "
            "in position 3|Signal not available");
}

TEST(Cia447States, LocalVoltage) {
  using enum LocalVoltage;
  EXPECT_EQ(printed<LocalVoltage>(light_status_roof_bar_local_voltage,
                                  {ok, under_voltage, over_voltage, not_available}),
            "Voltage is OK|Under voltage|Over voltage|Signal not available");
}

TEST(Cia447States, CountrySound) {
  using enum CountrySound;
  EXPECT_EQ(printed<CountrySound>(country_specific_sound_command, {none,
                                                                   din,
                                                                   italian_police,
                                                                   italian_ambulance,
                                                                   italian_fire_fight,
                                                                   netherlands_2_sound,
                                                                   netherlands_3_sound,
                                                                   austria_vienna_rescue,
                                                                   austria_rescue,
                                                                   austria_police,
                                                                   austria_fire_fight,
                                                                   austria_ambulance,
                                                                   norway,
                                                                   sweden,
                                                                   denmark,
                                                                   france_police,
                                                                   france_fire_fight,
                                                                   france_gendarmerie,
                                                                   france_umh,
                                                                   france_ambulance,
                                                                   piste,
                                                                   great_britain_fire_fight,
                                                                   usa,
                                                                   not_implemented,
                                                                   do_not_care}),
            "No sound|DIN|Italian police|Italian ambulance|Italian fire fight|Netherlands "
            "2-sound|Netherlands 3-sound|Austria (Vienna rescue)|Austria rescue|Austria "
            "police|Austria fire fight|Austria ambulance|Norway|Sweden|Denmark|France "
            "police|France fire fight|France gendarmerie|France UMH|France ambulance|Piste|Great "
            "Britain fire fight|USA|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<CountrySound>(country_specific_sound_status, {none,
                                                                  din,
                                                                  italian_police,
                                                                  italian_ambulance,
                                                                  italian_fire_fight,
                                                                  netherlands_2_sound,
                                                                  netherlands_3_sound,
                                                                  austria_vienna_rescue,
                                                                  austria_rescue,
                                                                  austria_police,
                                                                  austria_fire_fight,
                                                                  austria_ambulance,
                                                                  norway,
                                                                  sweden,
                                                                  denmark,
                                                                  france_police,
                                                                  france_fire_fight,
                                                                  france_gendarmerie,
                                                                  france_umh,
                                                                  france_ambulance,
                                                                  piste,
                                                                  great_britain_fire_fight,
                                                                  usa,
                                                                  failure,
                                                                  not_available}),
            "No sound selected|DIN|Italian police|Italian ambulance|Italian fire fight|Netherlands "
            "2-sound|Netherlands 3-sound|Austria (Vienna rescue)|Austria rescue|Austria "
            "police|Austria fire fight|Austria ambulance|Norway|Sweden|Denmark|France "
            "police|France fire fight|France gendarmerie|France UMH|France ambulance|Piste|Great "
            "Britain fire fight|USA|Failure|Signal not available");
}

TEST(Cia447States, AdditionalSound) {
  using enum AdditionalSound;
  EXPECT_EQ(printed<AdditionalSound>(sound_command_roof_bar_additional_sound,
                                     {none, country_specific, peak, us_hi_lo, us_yelp, sweden_yelp,
                                      wail, air_horn, cricket, not_implemented, do_not_care}),
            "No sound (turn-off)|Country-specific sound|Peak|US-HI-LO|US-YELP|Sweden-YELP|WAIL|Air "
            "horn|Cricket (Grille: Austria-specific sound)|Function not implemented|Don't care, "
            "take no action");
  EXPECT_EQ(printed<AdditionalSound>(sound_status_roof_bar_additional_sound,
                                     {none, country_specific, peak, us_hi_lo, us_yelp, sweden_yelp,
                                      wail, air_horn, cricket, failure, not_available}),
            "No sound|Country-specific sound|Peak|US-HI-LO|US-YELP|Sweden-YELP|WAIL|Air "
            "horn|Cricket (Grille: Austria-specific sound)|Failure|Signal not available");
}

TEST(Cia447States, SoundSpeed) {
  using enum SoundSpeed;
  EXPECT_EQ(printed<SoundSpeed>(sound_command_roof_bar_speed,
                                {normal, double_speed, not_implemented, do_not_care}),
            "Play the sound with normal speed|Play the sound with double speed|Function not "
            "implemented|Don't care, take no action");
  EXPECT_EQ(printed<SoundSpeed>(sound_status_roof_bar_speed,
                                {normal, double_speed, failure, not_available}),
            "The sound is playing with normal speed|The sound is playing with double "
            "speed|Failure|Signal not available");
}

TEST(Cia447States, SoundPlace) {
  using enum SoundPlace;
  EXPECT_EQ(printed<SoundPlace>(sound_command_roof_bar_city_land,
                                {land, city, not_implemented, do_not_care}),
            "Switch to land sound signal|Switch to city sound signal|Function not "
            "implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<SoundPlace>(sound_status_roof_bar_city_land, {land, city, failure, not_available}),
      "Land sound signal is on|City sound signal is on|Failure|Signal not available");
}

TEST(Cia447States, Speaker) {
  using enum Speaker;
  EXPECT_EQ(
      printed<Speaker>(sound_status_roof_bar_speaker, {not_defined, ok, failure, not_available}),
      "Not defined|Speaker is OK|Failure|Signal not available");
}

}  // namespace
}  // namespace canvoy::cia447::add_on_states_test
