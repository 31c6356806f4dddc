// Cases in which a device answers a foreign client differently from its data sheet, and the
// reasons: each with the abort code that the clause, or our reading of it, requires.
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/canopen/protocol/abort_code.hpp"

namespace canvoy {

struct ObjectRuling {
  enum class Case : std::uint8_t {
    read,    ///< answer to reading a readable object
    within,  ///< answer to a value that the clause allows
    beyond,  ///< answer to a value beyond the range
  };
  unsigned profile = 0;  ///< of the device; 0: any
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  Case what = Case::within;
  AbortCode answer = AbortCode::none;
  std::string_view reason = {};

  constexpr bool is_for(unsigned number, std::uint16_t index, Case asked, AbortCode by) const {
    return (profile == 0 || profile == number) && index >= first && index <= last &&
           asked == what && by == answer;
  }
};

/// Objects of devices of a profile.
struct RuledObjects {
  unsigned profile = 0;
  std::uint16_t first = 0;
  std::uint16_t last = 0;
};
constexpr ObjectRuling refuses(const RuledObjects& objects, AbortCode answer,
                               std::string_view reason) {
  return {objects.profile, objects.first, objects.last, ObjectRuling::Case::within, answer, reason};
}
constexpr ObjectRuling takes(const RuledObjects& objects, std::string_view reason) {
  return {objects.profile, objects.first, objects.last, ObjectRuling::Case::beyond,
          AbortCode::none, reason};
}
/// With a code other than those for ranges.
constexpr ObjectRuling refuses_beyond(const RuledObjects& objects, AbortCode answer,
                                      std::string_view reason) {
  return {objects.profile, objects.first, objects.last, ObjectRuling::Case::beyond, answer, reason};
}
constexpr ObjectRuling does_not_read(const RuledObjects& objects, AbortCode answer,
                                     std::string_view reason) {
  return {objects.profile, objects.first, objects.last, ObjectRuling::Case::read, answer, reason};
}

inline constexpr ObjectRuling object_rulings[] = {
    does_not_read({0, 0x1003, 0x1003}, AbortCode::no_data,
                  "CiA 301, 7.5.2.4: there is no error at this place"),
    refuses({0, 0x1003, 0x1003}, AbortCode::value_range, "CiA 301, 7.5.2.4: only 0 may be written"),
    refuses({0, 0x1600, 0x17FF}, AbortCode::unsupported_access,
            "CiA 301, 7.5.2.36: its PDO is valid"),
    refuses({0, 0x1A00, 0x1BFF}, AbortCode::unsupported_access,
            "CiA 301, 7.5.2.38: its PDO is valid"),

    // CiA 407: passenger information.
    takes({407, 0x6001, 0x6001}, "9.2.4: an event of a device that is none is told to nobody"),
    refuses({407, 0x6002, 0x6002}, AbortCode::value_range,
            "9.2.5: an event for another virtual device than is at this place"),
    takes({407, 0x6108, 0x6108}, "9.2.6.9: a reserved direction says nothing"),
    takes({407, 0x6104, 0x6104}, "9.2.6.5: a reserved class says nothing (errata 70)"),
    refuses({407, 0x6201, 0x6201}, AbortCode::length_too_high,
            "9.2.8.2: a character has 256 bytes here"),
    refuses({407, 0x6205, 0x6205}, AbortCode::value_range,
            "9.2.8.6: a set that is not among its own"),
    takes({407, 0x6481, 0x648D}, "9.2.15: reserved codes of SAE J1939 say nothing"),
    takes({407, 0x6520, 0x6522}, "9.2.17: reserved codes of SAE J1939 say nothing"),
    takes({407, 0x6660, 0x6664}, "9.2.21: reserved codes of SAE J1939 say nothing"),
    refuses({407, 0x6740, 0x6740}, AbortCode::value_range,
            "9.2.27.1: only 0 may be written to sub-index 00h"),
    refuses({407, 0x6741, 0x6741}, AbortCode::value_range,
            "9.2.27.2: only 0 may be written (errata 91)"),
    refuses({407, 0x6742, 0x6744}, AbortCode::value_range,
            "9.2.27.3: only 0 and 1 may be written to sub-index 00h"),

    // CiA 417: lifts.
    refuses({417, 0x6001, 0x6001}, AbortCode::value_range,
            "4.2.2: several lifts, of which it has one"),
    refuses({417, 0x6001, 0x6001}, AbortCode::value_too_low, "4.2.2: no lift at all"),
    takes({417, 0x6010, 0x6011}, "4.2.3, 4.2.4: a function that is none is nobody's"),
    takes({417, 0x6200, 0x6280},
          "4.4.1, 4.5: a reserved code of one field leaves the others of its output what they are"),
    takes({417, 0x6300, 0x6301}, "4.6.1, 4.6.2: a reserved code of one door's does nothing"),
    refuses({417, 0x6304, 0x6304}, AbortCode::value_range,
            "4.7.3: a profile that the door does not have"),
    refuses({417, 0x6384, 0x6387}, AbortCode::value_too_low,
            "4.9.5: a step of nothing measures nothing"),
    refuses({417, 0x6402, 0x6402}, AbortCode::value_range,
            "4.11: an option code of another maker's"),
    refuses({417, 0x6403, 0x6403}, AbortCode::value_range,
            "4.11: a mode that the drive does not have"),
    takes({417, 0x6404, 0x6404}, "4.11: a reserved mode of a drive is none that is known"),
    refuses({417, 0x6405, 0x6405}, AbortCode::value_range,
            "4.11: a profile that the drive does not have"),
    refuses({417, 0x6408, 0x640B}, AbortCode::value_too_low,
            "CiA 402: with 0 it would never move, or stand"),
    refuses({417, 0x640A, 0x640B}, AbortCode::value_too_high, "CiA 402: beyond what 6409h allows"),
    refuses({417, 0x6410, 0x6413}, AbortCode::value_range,
            "4.11: a power of ten beyond what it counts in"),
    refuses({417, 0x6414, 0x641D}, AbortCode::value_too_low,
            "CiA 402: a factor of 0, or a divisor"),
    refuses({417, 0x6421, 0x6422}, AbortCode::maximum_below_minimum,
            "CiA 402: the range would be empty"),
    refuses({417, 0x6423, 0x6424}, AbortCode::value_too_high, "CiA 402: beyond what 6408h allows"),
    refuses({417, 0x6423, 0x6423}, AbortCode::value_too_low, "CiA 402: with 0 it would never move"),
    refuses({417, 0x6430, 0x6430}, AbortCode::value_too_high, "CiA 402: beyond what 6408h allows"),
    refuses({417, 0x6430, 0x6430}, AbortCode::value_too_low, "CiA 402: beyond what 6408h allows"),
    refuses({417, 0x6434, 0x6434}, AbortCode::value_range, "4.11.6.5: a sensor of another maker's"),
    refuses({417, 0x6435, 0x6437}, AbortCode::value_too_low,
            "4.11.6.6: a window of less than nothing"),
    refuses({417, 0x6480, 0x6480}, AbortCode::value_range, "4.12.1: a unit that is no weight"),
    refuses({417, 0x6485, 0x6485}, AbortCode::value_range, "4.12.6: a rope ratio with a 0 in it"),

    // CiA 447: cars.
    refuses({447, 0x1200, 0x17FF}, AbortCode::device_state,
            "MID, annex IX: a sealed taximeter has its channels changed in service mode"),
    refuses({447, 0x6050, 0x6057}, AbortCode::local_control,
            "MID, annex IX: a sealed taximeter counts by its provider alone"),
    refuses({447, 0x60F0, 0x60F4}, AbortCode::local_control,
            "MID, annex IX: a sealed clock is set by its provider alone"),
    refuses_beyond({447, 0x6050, 0x6057}, AbortCode::local_control,
                   "MID, annex IX: a sealed taximeter counts by its provider alone"),
    refuses_beyond({447, 0x60F0, 0x60F4}, AbortCode::local_control,
                   "MID, annex IX: a sealed clock is set by its provider alone"),
    takes({447, 0x6053, 0x6054}, "4.2.4: a reserved code of a status says nothing"),
    refuses({447, 0x6099, 0x609E}, AbortCode::device_state,
            "4.2.9: who writes has not reserved the display"),
    takes({447, 0x60B0, 0x60B0}, "4.2.10: a reserved code of a status says nothing"),
    takes({447, 0x60D3, 0x60D3}, "4.2.12: a reserved code of a status says nothing"),
    refuses({447, 0x60E5, 0x60E9}, AbortCode::value_range,
            "4.2.13: what the printer is not able to do"),
    does_not_read({447, 0x60EB, 0x60EB}, AbortCode::no_data, "4.2.13: it has nothing to say"),
    takes({447, 0x6106, 0x6107},
          "4.2: what was read of a lamp that is not there may be written back"),
    refuses({447, 0x60F1, 0x60F1}, AbortCode::device_state,
            "4.2.14: a date of which no other part is set"),
};

}  // namespace canvoy
