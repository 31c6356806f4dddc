// CiA 447-3: the object descriptions, taken from the text.
#include <gtest/gtest.h>

#include <iterator>
#include <string>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::cia447_objects_test {
namespace {

struct Expected {
  unsigned index;
  const char* code;
  const char* category;  ///< part 2: "See CiA 447-2"
  const char* clause;
  const char* name;
};
constexpr Expected objects[] = {
    {0x6005, "VAR", "part 2", "4.2.2.1", "Switch illumination level status"},
    {0x6006, "VAR", "part 2", "4.2.2.2", "Switch illumination level command"},
    {0x6007, "VAR", "part 2", "4.2.2.3", "Ignition switch status"},
    {0x6009, "VAR", "part 2", "4.2.2.4", "Central locking system status"},
    {0x600A, "VAR", "part 2", "4.2.2.5", "Central locking system command"},
    {0x600B, "VAR", "part 2", "4.2.2.6", "Window status"},
    {0x600C, "VAR", "part 2", "4.2.2.7", "Window command"},
    {0x600D, "VAR", "part 2", "4.2.2.8", "Door status"},
    {0x600E, "VAR", "part 2", "4.2.2.9", "Door command"},
    {0x6010, "VAR", "part 2", "4.2.2.10", "Car flap status"},
    {0x6011, "VAR", "part 2", "4.2.2.11", "Car flap command"},
    {0x6018, "ARRAY", "optional", "4.2.2.12", "Seat adjustment command"},
    {0x6019, "ARRAY", "optional", "4.2.2.13", "Seat adjustment status"},
    {0x601A, "VAR", "part 2", "4.2.2.14", "Wiper system status"},
    {0x601B, "VAR", "part 2", "4.2.2.15", "Wiper system command"},
    {0x601C, "VAR", "part 2", "4.2.2.16", "Steering wheel angle"},
    {0x601D, "VAR", "part 2", "4.2.2.17", "Turn indicator reset status"},
    {0x6020, "VAR", "optional", "4.2.2.18", "Displayed outside air temperature"},
    {0x6021, "VAR", "optional", "4.2.2.19", "Displayed inside air temperature"},
    {0x6025, "VAR", "optional", "4.2.2.20", "Heating and air conditioner command"},
    {0x6026, "VAR", "optional", "4.2.2.21", "Heating and air conditioner status"},
    {0x6027, "VAR", "part 2", "4.2.2.22", "Occupant classification status"},
    {0x6028, "VAR", "part 2", "4.2.2.23", "Buckle switch status"},
    {0x602B, "VAR", "part 2", "4.2.2.24", "VIN data"},
    {0x602C, "VAR", "part 2", "4.2.2.25", "User-selected language command"},
    {0x602D, "VAR", "part 2", "4.2.2.26", "User-selected language status"},
    {0x6030, "VAR", "optional", "4.2.2.27", "Day/night detection"},
    {0x6031, "VAR", "optional", "4.2.2.28", "Environment light intensity"},
    {0x6032, "VAR", "part 2", "4.2.2.29", "Accident detection"},
    {0x6033, "VAR", "optional", "4.2.2.30", "Tester present"},
    {0x6040, "VAR", "part 2", "4.2.3.1", "Car light status"},
    {0x6044, "VAR", "part 2", "4.2.3.2", "Car light command"},
    {0x6045, "VAR", "part 2", "4.2.3.3", "Car interior light status"},
    {0x6046, "VAR", "part 2", "4.2.3.4", "Car interior light command"},
    {0x6047, "VAR", "optional", "4.2.3.5", "Anti theft warning system status"},
    {0x6048, "VAR", "optional", "4.2.3.6", "Anti theft warning system command"},
    {0x6049, "VAR", "optional", "4.2.3.7", "Mirror anti-dazzle position"},
    {0x604A, "VAR", "part 2", "4.2.3.8", "Horn status"},
    {0x604B, "VAR", "optional", "4.2.3.9", "Horn command"},
    {0x604C, "VAR", "optional", "4.2.3.10", "Flashing light command"},
    {0x604D, "VAR", "optional", "4.2.3.11", "Flashing light status"},
    {0x6050, "VAR", "part 2", "4.2.4.1", "Actual engine revolutions"},
    {0x6051, "VAR", "part 2", "4.2.4.2", "Engine status"},
    {0x6052, "VAR", "part 2", "4.2.4.3", "Transmission selector lever position"},
    {0x6053, "VAR", "part 2", "4.2.4.4", "Wheel rpm"},
    {0x6054, "VAR", "part 2", "4.2.4.5", "Wheel signal source"},
    {0x6055, "VAR", "part 2", "4.2.4.6", "Wheel pulse counter"},
    {0x6056, "VAR", "part 2", "4.2.4.7", "Wheel pulse counter overrun value"},
    {0x6057, "VAR", "part 2", "4.2.4.8", "Pulses per wheel rotation"},
    {0x605A, "VAR", "part 2", "4.2.4.9", "Displayed vehicle speed"},
    {0x605B, "VAR", "part 2", "4.2.4.10", "Odometer"},
    {0x605C, "VAR", "optional", "4.2.4.11", "Tank status"},
    {0x605D, "VAR", "part 2", "4.2.4.12", "Current average fuel consumption"},
    {0x6060, "VAR", "optional", "4.2.4.13",
     "Automatic cruise control and distance control command"},
    {0x6061, "VAR", "optional", "4.2.4.14", "Automatic cruise control and distance control status"},
    {0x6062, "VAR", "optional", "4.2.4.15", "Four-wheel drive command"},
    {0x6063, "VAR", "optional", "4.2.4.16", "Four-wheel drive status"},
    {0x6069, "VAR", "part 2", "4.2.5.1", "Fire extinguishing system status"},
    {0x606C, "VAR", "part 2", "4.2.6.1", "Emergency fresh-air system status"},
    {0x6070, "VAR", "part 2", "4.2.7.1", "Radio power supply status"},
    {0x6071, "VAR", "part 2", "4.2.7.2", "Radio power supply command"},
    {0x6073, "VAR", "part 2", "4.2.7.3", "Periphery power supply status"},
    {0x6074, "VAR", "part 2", "4.2.7.4", "Periphery power supply command"},
    {0x6078, "VAR", "part 2", "4.2.8.1", "Discrete inputs status"},
    {0x6080, "VAR", "part 2", "4.2.9.2", "Number pad status"},
    {0x6081, "VAR", "part 2", "4.2.9.3", "Number pad command"},
    {0x6082, "VAR", "part 2", "4.2.9.4", "Number pad user interaction"},
    {0x6085, "VAR", "part 2", "4.2.9.5", "Function keys status"},
    {0x6086, "VAR", "part 2", "4.2.9.6", "Function keys command"},
    {0x6087, "VAR", "part 2", "4.2.9.7", "Function keys user interaction"},
    {0x608A, "VAR", "part 2", "4.2.9.8", "Control keys status"},
    {0x608B, "VAR", "part 2", "4.2.9.9", "Control keys command"},
    {0x608C, "VAR", "part 2", "4.2.9.10", "Control keys user interaction"},
    {0x6090, "VAR", "part 2", "4.2.9.11", "Steering wheel switch pad status"},
    {0x6091, "VAR", "part 2", "4.2.9.12", "Steering wheel switch pad command"},
    {0x6092, "VAR", "part 2", "4.2.9.13", "Steering wheel switch pad user interaction"},
    {0x6093, "VAR", "part 2", "4.2.9.14", "Emergency key status"},
    {0x6094, "VAR", "part 2", "4.2.9.15", "Emergency key command"},
    {0x6095, "VAR", "part 2", "4.2.9.16", "Emergency key user interaction"},
    {0x6096, "ARRAY", "part 2", "4.2.9.17", "Display 1 parameters"},
    {0x6097, "VAR", "part 2", "4.2.9.18", "Display 1 status"},
    {0x6098, "VAR", "part 2", "4.2.9.19", "Display 1 command"},
    {0x6099, "VAR", "part 2", "4.2.9.20", "Display 1 text"},
    {0x609A, "VAR", "part 2", "4.2.9.21", "Display 1 title"},
    {0x609B, "ARRAY", "part 2", "4.2.9.22", "Display 2 parameters"},
    {0x609C, "VAR", "part 2", "4.2.9.23", "Display 2 status"},
    {0x609D, "VAR", "part 2", "4.2.9.24", "Display 2 command"},
    {0x609E, "VAR", "part 2", "4.2.9.25", "Display 2 text"},
    {0x60A0, "VAR", "part 2", "4.2.9.26", "Buzzer command"},
    {0x60A1, "VAR", "part 2", "4.2.9.27", "Functional warnings status"},
    {0x60A2, "VAR", "part 2", "4.2.9.28", "Functional warnings command"},
    {0x60A6, "ARRAY", "part 2", "4.2.9.29", "Icon display 1 command"},
    {0x60A7, "ARRAY", "part 2", "4.2.9.30", "Icon display 1 status"},
    {0x60AA, "ARRAY", "part 2", "4.2.9.31", "Icon display 2 command"},
    {0x60AB, "ARRAY", "part 2", "4.2.9.32", "Icon display 2 status"},
    {0x60B0, "ARRAY", "part 2", "4.2.10.1", "GPS current position"},
    {0x60B1, "VAR", "part 2", "4.2.10.2", "GPS satellites"},
    {0x60B2, "VAR", "part 2", "4.2.10.3", "GPS status"},
    {0x60B3, "VAR", "part 2", "4.2.10.4", "GPS date"},
    {0x60B4, "VAR", "part 2", "4.2.10.5", "GPS UTC time"},
    {0x60B5, "ARRAY", "part 2", "4.2.10.6", "GPS velocity and heading"},
    {0x60B6, "VAR", "part 2", "4.2.10.7", "GPS altitude"},
    {0x60C0, "VAR", "part 2", "4.2.11.1", "Distance to selected destination"},
    {0x60C1, "ARRAY", "part 2", "4.2.11.2", "Position description request"},
    {0x60C2, "ARRAY", "optional", "4.2.11.3", "Position description"},
    {0x60C3, "RECORD", "part 2", "4.2.11.4", "Start route guidance"},
    {0x60C4, "VAR", "part 2", "4.2.11.5", "Current position request"},
    {0x60C5, "ARRAY", "optional", "4.2.11.6", "Current position"},
    {0x60D0, "ARRAY", "part 2", "4.2.12.1", "Taxi trip payment"},
    {0x60D1, "VAR", "part 2", "4.2.12.2", "Taxi trip distance travelled"},
    {0x60D2, "ARRAY", "part 2", "4.2.12.3", "Taxi trip time information"},
    {0x60D3, "VAR", "part 2", "4.2.12.4", "Taxi trip tariff level"},
    {0x60D4, "ARRAY", "part 2", "4.2.12.5", "Taxi trip tariff value"},
    {0x60D8, "VAR", "part 2", "4.2.12.6", "Taximeter status"},
    {0x60D9, "ARRAY", "part 2", "4.2.12.7", "Taximeter totalizers"},
    {0x60DA, "RECORD", "part 2", "4.2.12.8", "Taximeter configuration"},
    {0x60DB, "VAR", "part 2", "4.2.12.9", "Taxi trip data sequence counter"},
    {0x60E0, "VAR", "part 2", "4.2.13.1", "Printer status"},
    {0x60E1, "VAR", "part 2", "4.2.13.2", "Printer errors"},
    {0x60E2, "VAR", "part 2", "4.2.13.3", "Printer features"},
    {0x60E3, "ARRAY", "part 2", "4.2.13.4", "Printer text status"},
    {0x60E4, "ARRAY", "part 2", "4.2.13.5", "Printer graphics status"},
    {0x60E5, "VAR", "part 2", "4.2.13.6", "Printer configuration command"},
    {0x60E6, "VAR", "part 2", "4.2.13.7", "Printer configuration status"},
    {0x60E9, "VAR", "part 2", "4.2.13.8", "Printer mode command"},
    {0x60EA, "VAR", "part 2", "4.2.13.9", "Printer mode status"},
    {0x60EB, "VAR", "part 2", "4.2.13.10", "Printer transport"},
    {0x60F0, "VAR", "part 2", "4.2.14.1", "RTC date"},
    {0x60F1, "VAR", "part 2", "4.2.14.2", "Set RTC date"},
    {0x60F2, "VAR", "part 2", "4.2.14.3", "RTC time"},
    {0x60F3, "VAR", "part 2", "4.2.14.4", "Set RTC time"},
    {0x60F4, "VAR", "part 2", "4.2.14.5", "RTC type and status"},
    {0x60F5, "VAR", "part 2", "4.2.14.6", "RTC time zone"},
    {0x60F9, "VAR", "part 2", "4.2.15.1", "Unique driver ID"},
    {0x60FA, "VAR", "part 2", "4.2.15.2", "Driver ID status"},
    {0x60FB, "VAR", "part 2", "4.2.15.3", "Drivers name"},
    {0x60FC, "ARRAY", "part 2", "4.2.15.4", "Driver login and logout time"},
    {0x6100, "VAR", "part 2", "4.2.16.1", "Tariff display information and status"},
    {0x6101, "VAR", "part 2", "4.2.16.2", "Tariff display lamp failures 1"},
    {0x6102, "VAR", "part 2", "4.2.16.3", "Tariff display lamp failures 2"},
    {0x6103, "VAR", "part 2", "4.2.16.4", "Tariff display inputs status"},
    {0x6104, "VAR", "part 2", "4.2.16.5", "Tariff display lamps status 1"},
    {0x6105, "VAR", "part 2", "4.2.16.6", "Tariff display lamps status 2"},
    {0x6106, "VAR", "part 2", "4.2.16.7", "Tariff display lamps command 1"},
    {0x6107, "VAR", "part 2", "4.2.16.8", "Tariff display lamps command 2"},
    {0x6109, "VAR", "part 2", "4.2.16.9", "Tariff display configuration"},
    {0x610A, "VAR", "part 2", "4.2.16.10", "Tariff display tariff level"},
    {0x6110, "VAR", "part 2", "4.2.17.1", "Taxi alarm system status"},
    {0x6115, "VAR", "part 2", "4.2.18.1", "Radio status"},
    {0x6116, "VAR", "part 2", "4.2.18.2", "Radio device command"},
    {0x6117, "VAR", "part 2", "4.2.18.3", "Radio device status"},
    {0x6120, "VAR", "part 2", "4.2.19.1", "Audio switch command"},
    {0x6121, "VAR", "part 2", "4.2.19.2", "Audio switch status request"},
    {0x6122, "VAR", "part 2", "4.2.19.3", "Audio switch status response"},
    {0x6130, "ARRAY", "part 2", "4.2.20.1", "Light commands roof bar"},
    {0x6131, "ARRAY", "part 2", "4.2.20.2", "Light status roof bar"},
    {0x6138, "VAR", "part 2", "4.2.21.1", "Country-specific sound command roof bar"},
    {0x6139, "VAR", "part 2", "4.2.21.2", "Country-specific sound status roof bar"},
    {0x613A, "ARRAY", "part 2", "4.2.21.3", "Sound command roof bar"},
    {0x613B, "ARRAY", "part 2", "4.2.21.4", "Sound status roof bar"},
    {0x6140, "VAR", "part 2", "4.2.22.1", "\"Blue\" light flasher command"},
    {0x6141, "VAR", "part 2", "4.2.22.2", "\"Blue\" light flasher status"},
    {0x6150, "VAR", "part 2", "4.2.23.1", "Radio hand-free status"},
    {0x6151, "VAR", "part 2", "4.2.23.2", "Radio hand-free command"},
};

std::string code_text(ObjectCode code) {
  if (code == ObjectCode::record) return "RECORD";
  return code == ObjectCode::array ? "ARRAY" : "VAR";
}

TEST(Cia447Objects, AreThoseOfTheSpecificationAndNoOthers) {
  ASSERT_EQ(cia447::profile.objects.size(), std::size(objects));
  for (std::size_t i = 0; i < std::size(objects); ++i) {
    const Expected& expected = objects[i];
    SCOPED_TRACE(testing::Message() << std::hex << expected.index << "h");
    const ObjectInfo& object = *cia447::profile.objects[i];
    EXPECT_EQ(object.index, expected.index);
    EXPECT_EQ(object.count, 1);
    EXPECT_EQ(code_text(object.code), expected.code);
    EXPECT_EQ(object.name, expected.name);
    EXPECT_EQ(object.clause, expected.clause);
    const bool is_optional = object.category == Category::optional;
    EXPECT_EQ(is_optional ? "optional" : "part 2", std::string(expected.category));
    EXPECT_EQ(is_optional, object.condition.empty());
    EXPECT_FALSE(object.description.empty());
  }
}

TEST(Cia447Objects, AreFoundByTheNumberOfTheProfile) {
  EXPECT_EQ(find_profile(0x0000'01BF), &cia447::profile);
  EXPECT_EQ(find_description(cia447::profile, 0x600D), &cia447::door_status_object);
  EXPECT_EQ(find_object(cia447::profile, 0x6008), nullptr)
      << "there is none between 6007h and 6009h";
  EXPECT_EQ(find_object(cia447::profile, 0x609F), nullptr) << "display 2 has no title (errata C11)";
}

}  // namespace
}  // namespace canvoy::cia447_objects_test
