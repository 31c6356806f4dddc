// CiA 447-3: the two states of each field of two bits, as the value tables print them: one field
// for each wording in an object.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/numbered_name.hpp"

namespace canvoy::two_states_test {
namespace {

struct TwoStates {
  unsigned index;
  unsigned sub;
  const char* field;
  const char* first;
  const char* second;
};
constexpr TwoStates fields[] = {
    {0x6007, 0, "ignition lock", "Ignition not locked", "Ignition locked (Key in)"},
    {0x6007, 0, "accessory", "No ignition accessory", "Ignition accessory"},
    {0x6007, 0, "ignition on", "Ignition off", "Ignition on"},
    {0x6007, 0, "ignition start", "No ignition start", "Ignition start"},
    {0x600C, 0, "wd", "Open the window", "Close the window"},
    {0x600E, 0, "dd", "Open the door", "Close the door"},
    {0x6011, 0, "eh", "Close", "Open"},
    {0x6018, 1, "sfb", "Seat forward", "Seat backward"},
    {0x6018, 1, "sud", "Seat up", "Seat down"},
    {0x6018, 1, "sals", "Seat angle lift", "Seat angle sink"},
    {0x6018, 1, "stsfb", "Seat tight support forward", "Seat tight support backward"},
    {0x6018, 1, "sbfb", "Seat back forward", "Seat back backward"},
    {0x6018, 1, "hud", "Headrest up", "Headrest down"},
    {0x6019, 1, "sfb", "Seat is moving forward", "Seat is moving backward"},
    {0x6019, 1, "sud", "Seat is moving up", "Seat is moving down"},
    {0x6019, 1, "sals", "Seat angle lift", "Seat angle sink"},
    {0x6019, 1, "stsfb", "Seat tight support forward", "Seat tight support backward"},
    {0x6019, 1, "sbfb", "Seat back is moving forward", "Seat back is moving backward"},
    {0x6019, 1, "hud", "Headrest is moving up", "Headrest is moving down"},
    {0x601B, 0, "wsf", "Switch the front wiper system off", "Switch tip wiping on"},
    {0x601B, 0, "wwf", "Switch the front washing off", "Switch the front washing on"},
    {0x601B, 0, "wsr", "Switch the rear wiper system off", "Switch the rear wiper system on"},
    {0x601B, 0, "wwr", "Switch the rear washer system off", "Switch the rear washer system on"},
    {0x601C, 0, "swas", "Steering wheel angle positive/left",
     "Steering wheel angle negative/right"},
    {0x601D, 0, "right turn indicator reset", "No turn indicator reset detected",
     "Turn indicator reset detected"},
    {0x6025, 0, "hfw", "Deactivate the function", "Activate the function"},
    {0x6025, 0, "dfw", "Deactivate the function", "Defrost front window (fans on with full power)"},
    {0x6025, 0, "recair", "Recirculation air off", "Recirculation air on"},
    {0x6026, 0, "hfw", "Function is not active", "Function is active"},
    {0x6027, 0, "docs", "Free", "Occupied"},
    {0x6028, 0, "bsd", "Seatbelt not fastened", "Seatbelt fastened"},
    {0x6030, 0, "day/night detection", "Day", "Night"},
    {0x6032, 0, "airrel", "Airbag not released", "Airbag released"},
    {0x6032, 0, "pate", "Presafe acceleration threshold not exceeded",
     "Presafe acceleration threshold exceeded"},
    {0x6032, 0, "ams", "No accident motor stop", "Accident motor stop"},
    {0x6032, 0, "accident", "No accident", "Accident"},
    {0x6033, 0, "UDS diagnose session", "The UDS diagnose session is not active",
     "The UDS diagnose session is active"},
    {0x6040, 0, "dtrl", "Off", "On"},
    {0x6044, 0, "dtrl", "Switch the light off", "Switch the light on"},
    {0x6045, 0, "lrid", "Off", "On"},
    {0x6046, 0, "lrid", "Off", "On"},
    {0x604A, 0, "horn status", "Not active", "Active"},
    {0x604B, 0, "horn command", "Horn off command", "Horn on command"},
    {0x604C, 0, "gclf", "Disable function", "Enable function"},
    {0x604D, 0, "gclf", "Function is turned off", "Function is turned on"},
    {0x6050, 0, "t61", "Terminal 61 not active", "Terminal 61 active"},
    {0x6052, 0, "pb", "Disengaged", "Engaged"},
    {0x6055, 0, "pcvalid", "No", "Yes"},
    {0x6056, 0, "valid", "No", "Yes"},
    {0x605C, 0, "tlm", "Tank level minimum not reached", "Tank level minimum reached"},
    {0x605D, 0, "fco", "No fuel consumption overflow", "Fuel consumption overflow"},
    {0x605D, 0, "fsu", "Liter", "Kilogram"},
    {0x6060, 0, "acc", "Cruise control off", "Cruise control on"},
    {0x6060, 0, "ad", "+ accelerate", "- decelerate"},
    {0x6060, 0, "dcs", "Deactivate the function (turn-off)", "Activate the function (turn-on)"},
    {0x6061, 0, "acc", "Cruise control off", "Cruise control on"},
    {0x6061, 0, "ad", "+ accelerating", "- decelerating"},
    {0x6061, 0, "dcs", "The function is turned-off", "The function is turned-on"},
    {0x6062, 0, "four-wheel drive", "Switch four-wheel drive off", "Switch four-wheel drive on"},
    {0x6063, 0, "four-wheel drive", "Four-wheel drive function is switched off",
     "Four-wheel drive function is switched on"},
    {0x6070, 0, "radio power on", "No", "Yes"},
    {0x6071, 0, "radio power off", "No radio power off request", "Radio power off request"},
    {0x6073, 0, "periphery power on", "No", "Yes"},
    {0x6074, 0, "periphery power off", "No periphery power off request",
     "Periphery power off request"},
    {0x6078, 0, "taximeter di", "Input not active", "Input active"},
    {0x6081, 0, "number pad command", "Release (control device by vehicle standard application)",
     "Lock (control device by car add-on device application)"},
    {0x6086, 0, "function key command", "Release (control device by vehicle standard application)",
     "Lock (control device by car add-on device application)"},
    {0x608B, 0, "control keys command", "Release (control device by vehicle standard application)",
     "Lock (control device by car add-on device application)"},
    {0x6091, 0, "steering wheel switch pad access command",
     "Release (control device by vehicle standard application)",
     "Lock (control device by car add-on device application)"},
    {0x6094, 0, "emergency key access command",
     "Release (control device by vehicle standard application)",
     "Lock (control device by car add-on device application)"},
    {0x6095, 0, "emergency key interaction", "No emergency key pressed", "Emergency key pressed"},
    {0x609D, 0, "display 2 command", "Release (control device by vehicle standard application)",
     "Lock (lock device for car add-on device application)"},
    {0x60A0, 0, "buzzer command", "Buzzer off", "Buzzer on"},
    {0x60A1, 0, "fesce", "Warning not active", "Warning is active"},
    {0x60A6, 1, "command", "Release (control device by vehicle standard application)",
     "Lock (lock device for car add-on device application)"},
    {0x60A7, 1, "status", "Released (device controlled by vehicle standard application)",
     "Locked (device locked for car add-on device application)"},
    {0x60AA, 1, "command", "Release (control device by vehicle standard application)",
     "Lock (lock device for car add-on device application)"},
    {0x60AB, 1, "status", "Released (device controlled by vehicle standard application)",
     "Locked (device locked for car add-on device application)"},
    {0x60D8, 0, "ticof", "No", "Yes"},
    {0x60E0, 0, "buffer empty", "Buffer is not empty", "Buffer is empty"},
    {0x60E1, 0, "np", "No error", "Error (printer has no paper)"},
    {0x60E2, 0, "apt", "No", "Yes"},
    {0x60E5, 0, "pb", "No command", "Execute the command"},
    {0x60E6, 0, "text bold", "Text bold is not set", "Text bold is set"},
    {0x60E6, 0, "text cursive", "Text cursive is not set", "Text cursive is set"},
    {0x60E6, 0, "variable width font", "Variable width font is not set",
     "Variable width font is set"},
    {0x60E6, 0, "color space", "RGB color space is set", "CMYK color space is set"},
    {0x60F4, 0, "RTC status", "RTC not valid", "RTC valid"},
    {0x60F4, 0, "DST support", "DST not supported", "DST supported"},
    {0x60F4, 0, "DST status", "DST not active", "DST active"},
    {0x60FA, 0, "logged in", "Driver is logged out", "Driver is logged in"},
    {0x60FA, 0, "data state", "Invalid", "Valid"},
    {0x60FA, 0, "ID system failure", "No identification failure", "Identification failure"},
    {0x6100, 0, "power down", "No power down", "Power down"},
    {0x6100, 0, "input", "CAN used", "Discrete inputs used (lamp driver input)"},
    {0x6100, 0, "dldi", "Discrete lamp driver input is not available",
     "Discrete lamp driver input available"},
    {0x6103, 0, "i1", "Input not active", "Input active"},
    {0x6109, 0, "epdm", "Do not enter the power down mode", "Enter the power down mode"},
    {0x6110, 0, "saa", "No", "Yes"},
    {0x6115, 0, "rerr1", "No", "Yes"},
    {0x6116, 0, "rp", "Turn off the radio power", "Turn on the radio power"},
    {0x6116, 0, "ptt", "Release push-to-talk", "Set push-to-talk"},
    {0x6117, 0, "rp", "Radio power is off", "Radio power is on"},
    {0x6117, 0, "tx-ptt", "Ready to transmit, push-to-talk released",
     "Transmit in the moment, push-to-talk is set"},
    {0x6130, 1, "mlb1", "Disable function (turn-off)", "Enable function (turn-on)"},
    {0x6131, 1, "mlb1", "The function is disabled (off)", "The function is enabled (on)"},
    {0x613A, 1, "swds", "Play the sound with normal speed", "Play the sound with double speed"},
    {0x613A, 1, "scl", "Switch to land sound signal", "Switch to city sound signal"},
    {0x613A, 1, "sor", "Disable function (turn-off)", "Enable function (turn-on)"},
    {0x613A, 1, "svdn", "Switch to day sound signal", "Switch to night sound signal"},
    {0x613B, 1, "swds", "The sound is playing with normal speed",
     "The sound is playing with double speed"},
    {0x613B, 1, "scl", "Land sound signal is on", "City sound signal is on"},
    {0x613B, 1, "sor", "Function is turned off", "Function is turned on"},
    {0x613B, 1, "svdn", "Day sound signal is on", "Night sound signal is on"},
    {0x613B, 2, "speak", "Not defined", "Speaker is OK"},
    {0x6140, 0, "ffr", "Disable function (turn-off)", "Enable function (turn-on)"},
    {0x6141, 0, "ffr", "Function is turned off", "Function is turned on"},
    {0x6150, 0, "radio hand-free key", "Radio hand-free key is not pressed",
     "Radio hand-free key is pressed"},
    {0x6151, 0, "indication LED", "Request to switch radio active indication LED off",
     "Request to switch radio active indication LED on"},
    {0x6151, 0, "audio mute", "Request to switch audio mute off",
     "Request to switch audio mute on"},
};

const FieldInfo* find_field(const TwoStates& wanted) {
  const ObjectInfo* object = find_object(cia447::profile, wanted.index);
  const EntryInfo* entry = object == nullptr ? nullptr : find_entry(*object, wanted.sub);
  if (entry == nullptr) return nullptr;
  const auto* found = std::ranges::find_if(entry->fields, [&](const FieldInfo& field) {
    return is_named(field.name, field.number, wanted.field);
  });
  return found == entry->fields.end() ? nullptr : found;
}

TEST(Cia447TwoStates, HaveTheNamesOfTheTables) {
  for (const TwoStates& expected : fields) {
    SCOPED_TRACE(testing::Message()
                 << std::hex << expected.index << "h:" << expected.sub << " " << expected.field);
    const FieldInfo* field = find_field(expected);
    ASSERT_NE(field, nullptr);
    ASSERT_EQ(field->bits, 2);
    EXPECT_EQ(find_name(field->value, 0, 2, false)->name, expected.first);
    EXPECT_EQ(find_name(field->value, 1, 2, false)->name, expected.second);
  }
}

}  // namespace
}  // namespace canvoy::two_states_test
