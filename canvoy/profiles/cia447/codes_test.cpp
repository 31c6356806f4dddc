// CiA 447-3: codes and their meanings, typed from the value tables: the ends of each kind of table,
// and all that an erratum decided.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/consistency.hpp"
#include "canvoy/profiles/number_rules.hpp"

namespace canvoy::codes_test {
namespace {

constexpr auto state = Meaning::state, invalid = Meaning::invalid, failure = Meaning::failure;
constexpr auto reserved = Meaning::reserved, manufacturer = Meaning::manufacturer;
constexpr auto not_implemented = Meaning::not_implemented, do_not_care = Meaning::do_not_care;
constexpr const char* not_available = "Signal not available";
constexpr const char* no_function = "Function not implemented";
constexpr const char* take_no_action = "Don't care, take no action";

struct Coded {
  unsigned index;
  unsigned sub;
  const char* field;  ///< empty: the whole entry
  std::int64_t code;
  Meaning meaning;
  const char* name;
};
constexpr Coded codes[] = {
    {0x6005, 0, "", 0x65, reserved, "Reserved"},
    {0x6005, 0, "", 0xFD, reserved, "Reserved"},
    {0x6005, 0, "", 0xFE, failure, "Failure"},
    {0x6005, 0, "", 0xFF, invalid, not_available},
    {0x6006, 0, "", 0xFE, not_implemented, no_function},
    {0x6006, 0, "", 0xFF, do_not_care, take_no_action},
    {0x6007, 0, "ignition lock", 1, state, "Ignition locked (Key in)"},
    {0x6007, 0, "accessory", 1, state, "Ignition accessory"},
    {0x6007, 0, "ignition on", 1, state, "Ignition on"},
    {0x6007, 0, "ignition start", 2, failure, "Failure"},
    {0x6009, 0, "central locking system status", 3, state, "Vehicle selective unlocked"},
    {0x6009, 0, "central locking system status", 0xD, reserved, "Reserved"},
    {0x600A, 0, "central locking system command", 2, state, "Lock vehicle external"},
    {0x600B, 0, "w3rl", 0, state, "Open"},
    {0x600B, 0, "wd", 3, state, "Is getting closed"},
    {0x600C, 0, "wd", 0, state, "Open the window"},
    {0x600D, 0, "dfp", 1, state, "Closed"},
    {0x600E, 0, "drl", 1, state, "Close the door"},
    {0x6010, 0, "eh", 0, state, "Closed"},
    {0x6010, 0, "blw", 4, reserved, "Reserved"},
    {0x6010, 0, "ct", 4, state, "Stopped"},
    {0x6010, 0, "bd", 5, reserved, "Reserved"},
    {0x6010, 0, "sr", 8, state, "Stopped (slide)"},
    {0x6010, 0, "sr", 9, reserved, "Reserved"},
    {0x6011, 0, "fd", 2, not_implemented, no_function},
    {0x6011, 0, "bd", 2, state, "Stop"},  // A8
    {0x6011, 0, "sr", 4, state, "Stop"},
    {0x6011, 0, "sr", 5, reserved, "Reserved"},
    {0x6018, 2, "rm", 4, state, "Recall Memory 4"},
    {0x6018, 1, "sm", 0, state, "Store no memory"},
    {0x6019, 1, "rm", 5, failure, "Failure"},  // A9
    {0x6019, 2, "sm", 6, failure, "Failure"},
    {0x601A, 0, "wspf", 4, state, "Wiper switch automatic"},
    {0x601A, 0, "wsr", 5, reserved, "Reserved"},
    {0x601B, 0, "wspf", 3, state, "Stage III (stage 2)"},  // D6
    {0x601B, 0, "wwr", 2, not_implemented, no_function},   // A11
    {0x601C, 0, "swas", 1, state, "Steering wheel angle negative/right"},
    {0x601C, 0, "swas", 2, failure, "Failure"},  // A1
    {0x601C, 0, "swas", 3, invalid, not_available},
    {0x6025, 0, "dfw", 1, state, "Defrost front window (fans on with full power)"},  // D5
    {0x6025, 0, "temp", 2, state, "- (0,5 °C)"},                                     // A8
    {0x6027, 0, "3rmocs", 1, state, "Occupied"},
    {0x6028, 0, "bsd", 0, state, "Seatbelt not fastened"},
    {0x602C, 0, "language", 6, reserved, "Reserved"},  // C13
    {0x602C, 0, "language", 7, state, "Dutch"},
    {0x602D, 0, "language", 0x0C, state, "Russian"},
    {0x602D, 0, "language", 0x1E, failure, "Failure"},
    {0x6030, 0, "day/night detection", 1, state, "Night"},
    {0x6032, 0, "accident", 1, state, "Accident"},
    {0x6040, 0, "dtrl", 1, state, "On"},
    {0x6044, 0, "pll", 0, state, "Switch the light off"},
    {0x6045, 0, "ii", 2, state, "On undimmed"},
    {0x6047, 0, "anti theft warning system", 1, state, "Pre-active"},
    {0x6048, 0, "anti theft warning system", 1, state, "Do not trigger"},  // C4
    {0x604C, 0, "gclf", 1, state, "Enable function"},
    {0x6051, 0, "", 6, state, "Shutdown"},
    {0x6051, 0, "", 7, reserved, "Reserved"},
    {0x6052, 0, "selector lever position", 9, state, "Position L (low)"},
    {0x6052, 0, "agm", 3, state, "Winter"},
    {0x6052, 0, "engaged gear", 9, state, "Reverse gear"},
    {0x6054, 0, "", 6, state, "Average all wheels"},
    {0x6057, 0, "", 0, reserved, "Reserved"},
    {0x605B, 0, "", 0xFF'FFFE, failure, "Signal is not valid"},  // A13
    {0x605B, 0, "", 0x98'9680, reserved, "Reserved"},
    {0x605C, 0, "tank level", 0xC9, reserved, "Reserved"},  // A2
    {0x605C, 0, "tank level", 0xFE, failure, "Failure"},
    {0x605D, 0, "current average fuel consumption", 0x7F01, reserved, "Reserved"},  // A3
    {0x605D, 0, "fsu", 1, state, "Kilogram"},
    {0x6060, 0, "store", 3, state, "Recall last stored speed"},
    {0x6061, 0, "ad", 1, state, "- decelerating"},
    {0x6063, 0, "four-wheel drive", 1, state, "Four-wheel drive function is switched on"},
    {0x6069, 0, "fire extinguishing system status", 5, state, "Manual started"},       // D4
    {0x606C, 0, "emergency fresh-air system status", 6, state, "Manually activated"},  // D4
    {0x606C, 0, "emergency fresh-air system status", 7, state, "Automatic activated"},
    {0x6080, 0, "number pad access", 0x11, state, "Number pad access by car add-on device 16"},
    {0x6080, 0, "number pad access", 0x12, reserved, "Reserved"},
    {0x6082, 0, "number pad", 0x0A, state, "Key # pressed"},  // C6
    {0x6082, 0, "number pad", 0x0B, state, "Key 0 pressed"},
    {0x6082, 0, "number pad", 0x0D, state, "More than one key pressed"},
    {0x6085, 0, "function key access", 0, state, "Function key access is not active"},
    {0x6087, 0, "function key", 8, state, "More than one key pressed"},
    {0x608A, 0, "control key access", 2, state, "Control key access by car add-on device 1"},
    {0x608C, 0, "control key", 5, state, "Key \"turn right\" pressed"},
    {0x608C, 0, "control key", 0x10, state, "More than one key pressed"},
    {0x6090, 0, "steering wheel switch pad access", 1, state,
     "Steering wheel access by standard vehicle application"},
    {0x6092, 0, "steering wheel switch pad interaction", 0xD, state,
     "More than one steering wheel tip switch pressed"},
    {0x6093, 0, "emergency key access", 0x0B, state,
     "Emergency key access by car add-on device 10"},
    {0x6097, 0, "display 1 status", 1, state, "On and access by standard vehicle application"},
    {0x6098, 0, "display 1 command", 2, state, "Lock device for ISO-TP transmitted content"},  // A7
    {0x609D, 0, "display 2 command", 2, not_implemented, no_function},
    {0x60A1, 0, "fasi", 1, state, "Warning is active"},
    {0x60A2, 0, "", 0x8000, reserved, "Reserved"},
    {0x60A2, 0, "", 0x8007, state, "Set fresh air system inactive"},
    {0x60A6, 1, "icon content", 0x0E, state, "Display icon number 14: DIN_PicTaxameter"},
    {0x60A6, 4, "icon content", 0x0F, reserved, "Reserved"},
    {0x60A7, 1, "icon content", 0x0F, failure, "Failure"},  // Z11
    {0x60AB, 4, "format", 2, failure, "Failure"},
    {0x60AB, 4, "status", 1, state, "Locked (device locked for car add-on device application)"},
    {0x60B0, 1, "", 0x6B49'D201, reserved, "Reserved"},
    {0x60B0, 2, "", 0xD693'A401, reserved, "Reserved"},
    {0x60B2, 0, "GPS fix", 2, state, "3D fix"},
    {0x60B3, 0, "GPS date month", 0, reserved, "Reserved"},
    {0x60B3, 0, "GPS date month", 0xD, reserved, "Reserved"},
    {0x60B3, 0, "GPS date day", 0x20, reserved, "Reserved"},
    {0x60B4, 0, "GPS UTC hour", 0x18, reserved, "Reserved"},
    {0x60B4, 0, "GPS UTC second", 0x1770, reserved, "Reserved"},
    {0x60C0, 0, "", 0xFFFD, invalid, "No destination selected"},
    {0x60C1, 1, "", 0xFFFF'FFFE, reserved, "Reserved"},  // Z35
    {0x60C3, 3, "", 1, state, "Start route guidance with interrupting currently active guidance"},
    {0x60C3, 3, "", 0xFE, reserved, "Reserved"},
    {0x60C4, 0, "rcp", 1, do_not_care, take_no_action},  // Z38
    {0x60D0, 4, "", 2, state, "Fixed price"},
    {0x60D0, 4, "", 3, reserved, "Reserved"},
    {0x60D3, 0, "tariff level character 1", 0x1F, reserved, "Reserved"},  // Z12
    {0x60D3, 0, "tariff level character 2", 0x7F, reserved, "Reserved"},
    {0x60D8, 0, "taximeter status", 5, state, "Standby mode"},
    {0x60DA, 2, "", 1, state, "Odometer operation"},
    {0x60DA, 3, "", 0x1'0000, reserved, "Reserved"},
    {0x60E0, 0, "printer status", 2, state, "Standby mode"},
    {0x60E2, 0, "logo number", 0, state, "The printer is not able to store logos"},
    {0x60E2, 0, "logo number", 0x15, reserved, "Reserved"},
    {0x60E5, 0, "uccs", 2, state, "Use CMYK color space"},  // Z16
    {0x60E5, 0, "height of used font", 0, do_not_care, "No command"},
    {0x60E5, 0, "height of used font", 0xFD, reserved, "Reserved"},
    {0x60E6, 0, "color space", 1, state, "CMYK color space is set"},
    {0x60E6, 0, "width of used font", 0, invalid, "No value is set"},
    {0x60E9, 0, "", 5, state, "Print logo"},
    {0x60EA, 0, "", 4, state, "Graphics CMYK with ESC"},
    {0x60F0, 0, "RTC date day", 0x20, reserved, "Reserved"},
    {0x60F0, 0, "RTC date year", 0, invalid, "No date is set"},
    {0x60F1, 0, "RTC date month", 0, state, "Reset the date"},
    {0x60F1, 0, "RTC date day", 0xFE, reserved, "Reserved"},
    {0x60F3, 0, "RTC hour", 0xFE, reserved, "Reserved"},
    {0x60F4, 0, "RTC source", 3, state, "Battery buffered RTC (taximeter intern)"},
    {0x60F4, 0, "offset from UTC", 0x69, reserved, "Reserved"},  // Z14
    {0x60FA, 0, "data state", 0, state, "Invalid"},
    {0x6100, 0, "number of lamps/lights", 0x11, reserved, "Reserved"},  // Z13
    {0x6100, 0, "number of lamps/lights", 0, invalid, "Not defined"},
    {0x6100, 0, "tlc", 3, reserved, "Reserved"},
    {0x6101, 0, "emcy light", 2, state, "Over load"},
    {0x6104, 0, "taxi light", 3, state, "Lamp blinking"},
    {0x6106, 0, "vacant light", 0xE, not_implemented, no_function},
    {0x6110, 0, "recr", 1, state, "Yes"},
    {0x6117, 0, "tx-ptt", 1, state, "Transmit in the moment, push-to-talk is set"},
    {0x6120, 0, "audio input channel", 0, state, "All input channels"},
    {0x6120, 0, "audio output channel", 0x11, reserved, "Reserved"},
    {0x6120, 0, "gain", 0, state, "Channel disconnected"},
    {0x6121, 0, "audio input channel", 0xFE, reserved, "Reserved"},  // Z35
    {0x6122, 0, "", 0xFE, failure, "Failure"},
    {0x6130, 3, "slp", 2, state, "Bring search lamp in position 3"},  // Z35
    {0x6131, 3, "sslrl", 2, state, "The search lamp is moving left"},
    {0x6131, 4, "rbllv", 2, state, "Over voltage"},
    {0x6138, 0, "", 0x16, state, "USA"},
    {0x6138, 0, "", 0x3F, reserved, "Reserved"},
    {0x6138, 0, "", 0x40, manufacturer, "Manufacturer-specific sounds"},  // Z08
    {0x6139, 0, "", 0xFD, manufacturer, "Manufacturer-specific sounds"},
    {0x613A, 1, "additional sound", 8, state, "Cricket (Grille: Austria-specific sound)"},
    {0x613A, 1, "additional sound", 0xFD, reserved, "Reserved"},
    {0x613A, 1, "sound volume", 0x3D, reserved, "Reserved"},  // Z09
    {0x613B, 1, "additional sound", 0xFD, manufacturer, "Manufacturer-specific additional sounds"},
    {0x613B, 1, "swds", 2, failure, "Failure"},  // Z10
    {0x613B, 2, "speak", 0, state, "Not defined"},
    {0x613B, 2, "rbslv", 2, state, "Over voltage"},
    {0x6140, 0, "mfl", 2, not_implemented, no_function},  // Z25
    {0x6141, 0, "ffr", 1, state, "Function is turned on"},
    {0x6151, 0, "audio mute", 1, state, "Request to switch audio mute on"},
};

struct Bits {
  const ValueInfo* value = nullptr;
  BitRange range;
};
Bits find_bits(const EntryInfo& entry, std::string_view name) {
  if (name.empty()) return {&entry.value, bits_of(entry)};
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return {&field.value, bits_of(field)};
  }
  return {};
}

TEST(Cia447Codes, MeanWhatTheTablesSay) {
  for (const Coded& coded : codes) {
    SCOPED_TRACE(testing::Message() << std::hex << coded.index << "h:" << coded.sub << " "
                                    << coded.field << " " << coded.code);
    const ObjectInfo* object = find_object(cia447::profile, coded.index);
    ASSERT_NE(object, nullptr);
    const EntryInfo* entry = find_entry(*object, coded.sub);
    ASSERT_NE(entry, nullptr);
    const Bits bits = find_bits(*entry, coded.field);
    ASSERT_NE(bits.value, nullptr);
    const NamedValue* named = find_name(*bits.value, coded.code, bits.range.bits, false);
    ASSERT_NE(named, nullptr);
    EXPECT_EQ(named->name, coded.name);
    EXPECT_EQ(named->meaning, coded.meaning);
  }
}

/// Each value of the profile that is coded in bits: a whole entry, or a field but reserved bits.
template <class Visit>
void for_each_value(Visit visit) {
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      if (entry.sub_first == 0 && !object->subs.empty()) continue;
      if (bit_length(entry.type) == 0 || object->index == 0x60F9) continue;
      SCOPED_TRACE(testing::Message() << std::hex << object->index << "h:" << +entry.sub_first);
      if (entry.fields.empty()) visit(*object, entry, "", entry.value, bits_of(entry));
      for (const FieldInfo& field : entry.fields) {
        if (field.name != "r") visit(*object, entry, field.name, field.value, bits_of(field));
      }
    }
  }
}

bool is_command(const EntryInfo& entry) {
  return entry.access == Access::rw;
}

TEST(Cia447Codes, EveryCodeIsANumberOrHasAName) {
  for_each_value([](const ObjectInfo&, const EntryInfo&, std::string_view field,
                    const ValueInfo& value, const BitRange& bits) {
    const std::int64_t last = (std::int64_t{1} << bits.bits) - 1;
    for (std::int64_t code = 0; code <= last;) {
      const NamedValue* named = find_name(value, code, bits.bits, false);
      const bool is_number = value.limits.kind != Limits::Kind::none && code >= value.limits.low;
      if (named != nullptr) {
        code = named->last + 1;
      } else if (is_number && code <= value.limits.high) {
        // Names may stand within a range, but at its beginning only.
        code = value.limits.high + 1;
      } else if (value.limits.kind == Limits::Kind::minimum && code < last - 1) {
        code = last - 1;
      } else {
        ADD_FAILURE() << field << ": code " << code << " means nothing";
        return;
      }
    }
  });
}

TEST(Cia447Codes, TheHighestCodeSaysThatThereIsNoValue) {
  for_each_value([](const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                    const ValueInfo& value, const BitRange& bits) {
    if (object.index == 0x6055 && field == "wheel pulse counter") return;  // C5
    if (object.index == 0x6056 && field == "wheel pulse counter overrun value") return;
    const std::int64_t highest = (std::int64_t{1} << bits.bits) - 1;
    const NamedValue* named = find_name(value, highest, bits.bits, false);
    ASSERT_NE(named, nullptr) << field;
    EXPECT_EQ(named->meaning, is_command(entry) ? do_not_care : invalid) << field;
    EXPECT_EQ(named->name, is_command(entry) ? take_no_action : not_available) << field;
    if (!is_command(entry)) {
      EXPECT_EQ(find_invalid(value), named) << "the first one is what a handle writes";
    }
  });
}

TEST(Cia447Codes, TheSecondHighestCodeSaysWhyButWhereNoneIsLeft) {
  using Exception = std::pair<unsigned, std::string_view>;
  const std::set<Exception> exceptions = {{0x6055, "wheel pulse counter"},
                                          {0x6056, "wheel pulse counter overrun value"},  // C5
                                          {0x6011, "ct"},
                                          {0x6011, "bd"},
                                          {0x6025, "temp"},
                                          {0x6098, "display 1 command"},  // A7, A8
                                          {0x60C1, ""},
                                          {0x60C3, ""},
                                          {0x60C4, "rcp"},
                                          {0x60E5, "uccs"},  // Z35
                                          {0x60F1, "RTC date year"},
                                          {0x60F1, "RTC date month"},
                                          {0x60F1, "RTC date day"},
                                          {0x60F3, "RTC hour"},
                                          {0x60F3, "RTC minute"},
                                          {0x60F3, "RTC second"},
                                          {0x6109, "configure"},
                                          {0x6121, "audio input channel"},
                                          {0x6121, "audio output channel"},
                                          {0x6130, "sslrl"},
                                          {0x6130, "sslud"},
                                          {0x6130, "slp"},
                                          {0x6131, "sslrl"},
                                          {0x6131, "sslud"},
                                          {0x6131, "slp"},
                                          {0x6131, "rbllv"},
                                          {0x613B, "rbslv"}};
  std::set<Exception> met;
  for_each_value([&](const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                     const ValueInfo& value, const BitRange& bits) {
    const std::int64_t code = (std::int64_t{1} << bits.bits) - 2;
    const NamedValue* named = find_name(value, code, bits.bits, false);
    const Meaning expected = is_command(entry) ? not_implemented : failure;
    if (named != nullptr && named->meaning == expected) return;
    met.insert({object.index, field});
  });
  EXPECT_EQ(met, exceptions);
}

TEST(Cia447Codes, AStatusSendsTheSecondHighestCodeWhereSeveralSayFailure) {  // A9, Z11
  for (const unsigned index : {0x6019U, 0x60A7U, 0x60ABU}) {
    for (const FieldInfo& field : find_object(cia447::profile, index)->subs[1].fields) {
      for (const NamedValue& named : field.value.names) {
        if (named.meaning != failure) continue;
        EXPECT_EQ(named.first, (1 << field.bits) - 2) << index << " " << field.name;
        EXPECT_EQ(named.last, named.first);
        break;
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::codes_test
