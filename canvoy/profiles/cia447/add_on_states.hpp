// States of CiA 447-3 for application code (states.hpp), of add-on devices: terminal, GPS,
// taximeter, printer, clock, tariff display, roof bar.
#pragma once

#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

// Each enumeration is a row, with its sentinels behind its states.
// clang-format off

// Terminal (4.2.9).

/// Holder of a part of the terminal.
enum class TerminalAccess : std::uint8_t {
  none, off = none, vehicle, device_1, device_2, device_3, device_4, device_5, device_6, device_7,
  device_8, device_9, device_10, device_11, device_12, device_13, device_14, device_15, device_16,
  failure = 0x1E, not_available = 0x1F
};
/// Code 2 locks display 1 for ISO-TP. In the other commands it is `not_implemented`.
enum class AccessCommand : std::uint8_t {
  release, lock, lock_for_iso_tp, not_implemented = lock_for_iso_tp, do_not_care
};
/// Pressed key of the number pad (6082h).
enum class NumberPadKey : std::uint8_t {
  none, key_1, key_2, key_3, key_4, key_5, key_6, key_7, key_8, key_9, hash, key_0, star, several,
  failure = 0x1E, not_available = 0x1F
};
/// Pressed function key (6087h).
enum class FunctionKey : std::uint8_t {
  none, key_1, key_2, key_3, key_4, key_5, key_6, key_7, several,
  failure = 0xE, not_available = 0xF
};
/// Pressed control key (608Ch).
enum class ControlKey : std::uint8_t {
  none,
  up,
  down,
  right,
  left,
  turn_right,
  turn_left,
  ok,
  clear,
  back,  ///< "return"
  send,
  end,
  f1,
  f2,
  f3,
  f4,
  several,
  failure = 0x1E,
  not_available = 0x1F
};
/// Pressed tip switch (6092h).
enum class TipSwitch : std::uint8_t {
  none, switch_1, switch_2, switch_3, switch_4, switch_5, switch_6, switch_7, switch_8, switch_9,
  switch_10, switch_11, switch_12, several,
  failure, not_available
};
/// Command for the functional warnings (60A2h).
enum class WarningCommand : std::uint16_t {
  reset_all,
  reset_fire_cartridge_empty,
  reset_fire_active,
  reset_fire_on,
  reset_fire_fault,
  reset_air_cylinder_empty,
  reset_air_active,
  reset_air_inactive,
  set_fire_cartridge_empty = 0x8001,
  set_fire_active,
  set_fire_on,
  set_fire_fault,
  set_air_cylinder_empty,
  set_air_active,
  set_air_inactive,
  not_implemented = 0xFFFE,
  do_not_care = 0xFFFF
};
/// Whether an icon is locked (60A7h, 60ABh).
enum class IconAccess : std::uint8_t { released, locked, failure, not_available };
/// Picture of an icon (60A6h, 60A7h, 60AAh, 60ABh).
enum class Icon : std::uint8_t {
  none, antenna, micro, empty_circle, filled_circle, speaker_on, speaker_off, signal_out, signal_in,
  gps_active, crossed_circle, bell, clock, skip_to_end, taximeter,
  failure = 0xFE, not_implemented = failure, not_available = 0xFF, do_not_care = not_available
};
/// Form of an icon (60A6h, 60A7h, 60AAh, 60ABh).
enum class IconFormat : std::uint8_t {
  standard, highlighted,
  failure = 6, not_implemented = failure, not_available = 7, do_not_care = not_available
};

// GPS and navigation system (4.2.10, 4.2.11).

/// Kind of a position (60B2h).
enum class GpsFix : std::uint8_t { none, fix_2d, fix_3d, failure = 0xE, not_available = 0xF };
/// Command to begin a guidance (60C3h).
enum class StartGuidance : std::uint8_t {
  without_interrupting, with_interrupting, do_not_care = 0xFF
};
/// Command to read the position (60C4h).
enum class PositionRequest : std::uint8_t { read, do_not_care };

// Taximeter, printer, clock (4.2.12 to 4.2.14).

/// How distance and time are charged (60D0h).
enum class FareMode : std::uint32_t {
  single_calculation,
  double_calculation,
  fixed_price,
  failure = 0xFFFF'FFFE,
  not_available = 0xFFFF'FFFF
};
/// State of a taximeter (60D8h).
enum class Taximeter : std::uint8_t {
  for_hire, hired, stopped, signed_off, service_mode, standby_mode,
  failure = 0xE, not_available = 0xF
};
/// Mode of a taximeter (60DAh).
enum class TaximeterMode : std::uint8_t {
  taximeter_operation, odometer_operation, failure = 0xFE, not_available = 0xFF
};
/// State of a printer (60E0h).
enum class PrinterState : std::uint8_t { ready, busy, standby, failure = 0xE, not_available = 0xF };
/// Command for a property of the font (60E5h).
enum class FontCommand : std::uint8_t { no_command, execute, not_implemented, do_not_care };
/// Command and status have different codes (errata Z16).
enum class ColorSpaceCommand : std::uint8_t { no_command, rgb, cmyk, do_not_care };
/// Color space of the font (60E6h).
enum class ColorSpace : std::uint8_t { rgb, cmyk, failure, not_available };
/// Kind of data to print (60E9h, 60EAh).
enum class PrinterMode : std::uint8_t {
  text, graphics_black, graphics_gray, graphics_rgb, graphics_cmyk, logo,
  failure = 0xFE, not_implemented = failure, not_available = 0xFF, do_not_care = not_available
};
/// Source of the time of a clock (60F4h).
enum class RtcSource : std::uint8_t {
  unknown, gps, time_normal, battery_buffered, failure = 0xE, not_available = 0xF
};
/// Trustability of a clock (60F4h).
enum class RtcTrustability : std::uint8_t {
  user_adjustable, accepted_by_authority, failure = 0xE, not_available = 0xF
};

// Tariff display (4.2.16).

/// Source of the state of the lamps (6100h).
enum class LampInput : std::uint8_t { can, discrete_inputs, failure, not_available };
/// Failure of a lamp (6101h).
enum class LampFailure : std::uint8_t {
  none, open_load, over_load, failure = 0xE, not_available = 0xF
};
/// Lamp, its command and its state (6104h, 6106h).
enum class Lamp : std::uint8_t {
  off, on, dimmed, blinking,
  failure = 0xE, not_implemented = failure, not_available = 0xF, do_not_care = not_available
};
/// Command for the source of the lamps (6109h).
enum class DisplayConfiguration : std::uint8_t { no_command, can, discrete_inputs, do_not_care };

// Roof bar (4.2.20, 4.2.21).

/// Swing of the search lamp (6130h, 6131h).
enum class SearchLampTurn : std::uint8_t {
  stop, right, left, not_available, do_not_care = not_available
};
/// Tilt of the search lamp (6130h, 6131h).
enum class SearchLampTilt : std::uint8_t {
  stop, up, down, not_available, do_not_care = not_available
};
/// Stored position of the search lamp (6130h, 6131h).
enum class SearchLampPosition : std::uint8_t {
  position_1, position_2, position_3, not_available, do_not_care = not_available
};
/// Voltage of the roof bar (6131h, 613Bh).
enum class LocalVoltage : std::uint8_t { ok, under_voltage, over_voltage, not_available };
/// Sound by its country (6138h, 6139h).
enum class CountrySound : std::uint8_t {
  none, din, italian_police, italian_ambulance, italian_fire_fight, netherlands_2_sound,
  netherlands_3_sound, austria_vienna_rescue, austria_rescue, austria_police, austria_fire_fight,
  austria_ambulance, norway, sweden, denmark, france_police, france_fire_fight, france_gendarmerie,
  france_umh, france_ambulance, piste, great_britain_fire_fight, usa,
  failure = 0xFE, not_implemented = failure, not_available = 0xFF, do_not_care = not_available
};
/// Sound beside those of countries (613Ah, 613Bh).
enum class AdditionalSound : std::uint8_t {
  none, country_specific, peak, us_hi_lo, us_yelp, sweden_yelp, wail, air_horn, cricket,
  failure = 0xFE, not_implemented = failure, not_available = 0xFF, do_not_care = not_available
};
/// Speed of a sound (613Ah, 613Bh).
enum class SoundSpeed : std::uint8_t {
  normal, double_speed,
  failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// Variant of a sound (613Ah, 613Bh).
enum class SoundPlace : std::uint8_t {
  land, city, failure, not_implemented = failure, not_available, do_not_care = not_available
};
/// State of a loudspeaker (613Bh).
enum class Speaker : std::uint8_t { not_defined, ok, failure, not_available };

// clang-format on

}  // namespace canvoy::cia447
