// The bits of the objects of CiA 417-4, typed from the text.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/testing/words.hpp"

namespace canvoy::fields_test {
namespace {

struct ExpectedField {
  const char* clause;
  unsigned index;
  unsigned sub;
  const char* name;
  unsigned number;  ///< 0: it has none
  unsigned last_bit;
  unsigned first_bit;
};
constexpr ExpectedField fields[] = {
    {"4.2.1", 0x6000, 1, "Virtual device", 0, 15, 8},
    {"4.2.2", 0x6001, 0, "Lift #", 1, 0, 0},
    {"4.2.2", 0x6001, 0, "Lift #", 8, 7, 7},
    {"4.2.6", 0x6020, 0, "Index", 0, 31, 16},
    {"4.2.6", 0x6020, 0, "Sub-index", 0, 15, 8},
    {"4.2.6, A20", 0x6020, 0, "Access", 0, 7, 6},
    {"4.2.6", 0x6020, 0, "reserved", 0, 5, 2},
    {"4.2.6, A20", 0x6020, 0, "Action", 0, 1, 0},
    // Bytes 0 to 5 of a virtual input; 6010h has the same.
    {"4.3.1", 0x6100, 1, "Basic function", 0, 7, 0},
    {"4.3.1", 0x6100, 1, "Hall call up", 0, 8, 8},
    {"4.3.1", 0x6100, 1, "Hall call down", 0, 9, 9},
    {"4.3.1", 0x6100, 1, "Target stop", 0, 15, 8},
    {"4.3.1", 0x6100, 1, "Special function", 0, 15, 8},
    {"4.3.1", 0x6100, 1, "Source lift #", 1, 16, 16},
    {"4.3.1", 0x6100, 1, "Source lift #", 8, 23, 23},
    {"4.3.1", 0x6100, 1, "Source panel", 0, 31, 24},
    {"4.3.1", 0x6100, 1, "Dest. door #", 1, 32, 32},
    {"4.3.1", 0x6100, 1, "Dest. door #", 4, 35, 35},
    {"4.3.1", 0x6100, 1, "Source door #", 1, 36, 36},
    {"4.3.1", 0x6100, 1, "Source door #", 4, 39, 39},
    {"4.3.1", 0x6100, 1, "Call request", 0, 41, 40},
    {"4.3.1", 0x6100, 1, "Lock", 0, 47, 47},
    {"4.2.3", 0x6010, 0, "Source panel", 0, 31, 24},
    {"4.3.2", 0x6120, 1, "Enable", 0, 0, 0},
    {"4.3.2", 0x6120, 1, "Error code", 0, 15, 8},
    {"4.3.2", 0x6120, 1, "reserved", 2, 31, 16},
    {"4.3.3", 0x6140, 1, "reserved", 1, 7, 0},
    {"4.3.3", 0x6140, 1, "Limitation", 0, 15, 8},
    {"4.3.3", 0x6140, 1, "Sending event", 0, 23, 16},
    {"4.3.3", 0x6140, 1, "reserved", 2, 31, 24},
    {"4.3.4", 0x6160, 1, "Debounce time", 0, 7, 0},
    {"4.3.4", 0x6160, 1, "LH edge", 0, 8, 8},
    {"4.3.4", 0x6160, 1, "HL edge", 0, 9, 9},
    {"4.3.4", 0x6160, 1, "reserved", 1, 14, 10},
    {"4.3.4", 0x6160, 1, "Polarity", 0, 15, 15},
    {"4.3.4", 0x6160, 1, "reserved", 2, 31, 16},
    {"4.3.5", 0x6180, 1, "reserved", 0, 31, 0},
    // Bytes 0 to 5 of a virtual output; 6011h has the same.
    {"4.4.1", 0x6200, 1, "Basic function", 0, 7, 0},
    {"4.4.1", 0x6200, 1, "Hall call up", 0, 8, 8},
    {"4.4.1", 0x6200, 1, "Hall call down", 0, 9, 9},
    {"4.4.1", 0x6200, 1, "Target stop acknowledgement", 0, 15, 8},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0, 15, 8},
    {"4.4.1", 0x6200, 1, "Floor data", 0, 15, 8},
    {"4.4.1", 0x6200, 1, "Up", 0, 8, 8},
    {"4.4.1", 0x6200, 1, "Down", 0, 9, 9},
    {"4.4.1", 0x6200, 1, "Right", 0, 10, 10},
    {"4.4.1", 0x6200, 1, "Left", 0, 11, 11},
    {"4.4.1", 0x6200, 1, "Moving", 0, 12, 12},
    {"4.4.1", 0x6200, 1, "Special indication", 0, 15, 8},
    {"4.4.1", 0x6200, 1, "Destination lift #", 1, 16, 16},
    {"4.4.1", 0x6200, 1, "Destination lift #", 8, 23, 23},
    {"4.4.1", 0x6200, 1, "Destination panel", 0, 31, 24},
    {"4.4.1", 0x6200, 1, "Dest. button #", 1, 32, 32},
    {"4.4.1", 0x6200, 1, "Dest. button #", 4, 35, 35},
    {"4.4.1", 0x6200, 1, "Dest. door #", 1, 36, 36},
    {"4.4.1", 0x6200, 1, "Dest. door #", 4, 39, 39},
    {"4.4.1", 0x6200, 1, "Status", 0, 40, 40},
    {"4.4.1", 0x6200, 1, "Property parameter", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Impulse", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Flashing", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Color", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Volume", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Scroll rate", 0, 46, 44},
    {"4.4.1", 0x6200, 1, "Property", 0, 43, 41},
    {"4.4.1", 0x6200, 1, "Predicate", 0, 47, 47},
    {"4.2.4", 0x6011, 0, "Property", 0, 43, 41},
    {"4.5.1", 0x6220, 1, "Enable", 0, 0, 0},
    {"4.5.1", 0x6220, 1, "Error code", 0, 15, 8},
    {"4.5.1, A7", 0x6220, 1, "reserved", 2, 23, 16},
    {"4.5.1", 0x6220, 1, "Default value", 0, 31, 24},
    {"4.5.2", 0x6240, 1, "Limitation", 0, 15, 8},
    {"4.5.2", 0x6240, 1, "Reception event", 0, 23, 16},
    {"4.5.2", 0x6240, 1, "Impulse time", 0, 31, 24},
    {"4.5.3", 0x6260, 1, "reserved", 1, 7, 0},
    {"4.5.3", 0x6260, 1, "reserved", 2, 14, 8},
    {"4.5.3", 0x6260, 1, "Polarity", 0, 15, 15},
    {"4.5.3", 0x6260, 1, "reserved", 3, 31, 16},
    {"4.5.4", 0x6280, 1, "Flash rate", 0, 7, 0},
    {"4.5.4", 0x6280, 1, "Scroll rate", 0, 15, 8},
    {"4.5.4", 0x6280, 1, "Color", 0, 23, 16},
    {"4.5.4", 0x6280, 1, "Intensity/Volume", 0, 31, 24},
    // Doors.
    {"4.6.1", 0x6300, 1, "Command", 0, 15, 12},
    {"4.6.1", 0x6300, 1, "Door velocity", 0, 11, 10},
    {"4.6.1", 0x6300, 1, "Motion detector", 0, 9, 8},
    {"4.6.1", 0x6300, 1, "Finger protector", 0, 7, 6},
    {"4.6.1", 0x6300, 1, "Door lock", 0, 5, 4},
    {"4.6.1", 0x6300, 1, "Battery power", 0, 3, 2},
    {"4.6.1", 0x6300, 1, "reserved", 0, 1, 0},
    {"4.7.1", 0x6301, 1, "Status", 0, 15, 12},
    {"4.7.1", 0x6301, 1, "Force limit", 0, 11, 10},
    {"4.7.1", 0x6301, 1, "Motion detector", 0, 9, 8},
    {"4.7.1", 0x6301, 1, "Finger protector", 0, 7, 6},
    {"4.7.1", 0x6301, 1, "Door lock", 0, 5, 4},
    {"4.7.1", 0x6301, 1, "Battery power", 0, 3, 2},
    {"4.7.1, A1", 0x6301, 1, "Safety contact", 0, 1, 0},
    {"4.8.1", 0x6310, 1, "Status", 0, 7, 6},
    {"4.8.1", 0x6310, 1, "reserved", 0, 5, 0},
    // Drive and position, by CiA 402 and CiA 406.
    {"4.11.1.1", 0x6400, 0, "Switch on", 0, 0, 0},
    {"4.11.1.1", 0x6400, 0, "Quick stop", 0, 2, 2},
    {"4.11.1.1", 0x6400, 0, "New set-point", 0, 4, 4},
    {"4.11.1.1", 0x6400, 0, "Fault reset", 0, 7, 7},
    {"4.11.1.1", 0x6400, 0, "Halt", 0, 8, 8},
    {"4.11.1.2", 0x6401, 0, "Operation enabled", 0, 2, 2},
    {"4.11.1.2", 0x6401, 0, "Switch on disabled", 0, 6, 6},
    {"4.11.1.2, B20", 0x6401, 0, "Target reached", 0, 10, 10},
    {"4.11.1.2, B20", 0x6401, 0, "Set-point acknowledge or speed 0", 0, 12, 12},
    {"4.11.3.15", 0x641E, 0, "Position polarity", 0, 7, 7},
    {"4.11.3.15", 0x641E, 0, "Velocity polarity", 0, 6, 6},
    {"4.9.1", 0x6380, 4, "Code sequence", 0, 0, 0},
    {"4.9.1", 0x6380, 4, "Measuring direction", 0, 3, 3},
    {"4.9.11", 0x63B0, 1, "Range underflow", 0, 2, 2},
    {"4.10.1", 0x63A0, 1, "Cam #", 8, 7, 7},
    // Load and sensors.
    {"4.12.1", 0x6480, 2, "Prefix", 0, 15, 8},
    {"4.12.1", 0x6480, 2, "SI unit", 0, 7, 0},
    {"4.12.3", 0x6482, 1, "Zero load", 0, 0, 0},
    {"4.12.3", 0x6482, 1, "Norm load", 0, 1, 1},
    {"4.12.3", 0x6482, 1, "Full load", 0, 2, 2},
    {"4.12.3", 0x6482, 1, "Overload", 0, 3, 3},
    {"4.12.3", 0x6482, 2, "Overload", 0, 3, 3},
    {"4.12.6", 0x6485, 1, "Ratio nominator", 0, 15, 8},
    {"4.12.6", 0x6485, 1, "Ratio denominator", 0, 7, 0},
    {"4.13.1", 0x6500, 1, "Basic function", 0, 7, 0},
    {"4.13.1", 0x6500, 1, "Source lift #", 1, 8, 8},
    {"4.13.1", 0x6500, 1, "Source floor", 0, 23, 16},
    {"4.13.1", 0x6500, 1, "Source position", 0, 31, 24},
    {"4.13.1", 0x6500, 1, "Sensor signal", 0, 33, 32},
    {"4.13.1, A21", 0x6500, 1, "Sensor value", 0, 47, 34},
    {"4.2.5, A8", 0x6012, 0, "Source floor", 0, 23, 16},
    {"4.13.4", 0x6560, 1, "Debounce time", 0, 7, 0},
    {"4.13.4", 0x6560, 1, "Polarity", 0, 15, 15},
    {"4.13.4", 0x6560, 1, "SI unit", 0, 23, 16},
    {"4.13.4", 0x6560, 1, "Prefix", 0, 31, 24},
};

TEST(Cia417, FieldsStandInTheBitsOfTheirClause) {
  for (const ExpectedField& expected : fields) {
    SCOPED_TRACE(testing::Message() << expected.clause << " " << expected.name);
    const FieldInfo* field = field_at(entry_at(cia417::profile, expected.index, expected.sub),
                                      expected.name, expected.number);
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->first_bit, expected.first_bit);
    EXPECT_EQ(field->first_bit + unsigned{field->bits} - 1, expected.last_bit);
  }
}

TEST(Cia417, ACallFromTheLandingSaysDirectionLiftFloorAndDoor) {
  // Bytes on the wire: 02 01 01 05 10 01.
  EXPECT_EQ(words(cia417::profile, 0x6010, 0, 0x01'10'05'01'01'02),
            "Basic function: Standard hall call request; Hall call up: 1; Source lift 1: request; "
            "Source panel: 5; Source door 1: request; Call request: call request");
}

TEST(Cia417, ACallFromTheCarSaysTheTargetStop) {
  EXPECT_EQ(words(cia417::profile, 0x6100, 254, 0x81'00'00'02'FE'07),
            "Basic function: High priority car call request; Target stop: 254; "
            "Source lift 2: request; Source panel: car; Call request: call request; "
            "Lock: with locking function");
  EXPECT_EQ(words(cia417::profile, 0x6100, 1, 0x00'00'00'00'FF'05),
            "Basic function: Standard car call request; Target stop: reserved; Source panel: car; "
            "Call request: no call request");
}

TEST(Cia417, ASpecialFunctionHasAListOfItsOwn) {
  EXPECT_EQ(words(cia417::profile, 0x6100, 1, 0x02'00'FF'00'16'0E),
            "Basic function: Special function; Special function: Dogging service down; "
            "Source panel: reserved; Call request: function is defective");
  EXPECT_EQ(words(cia417::profile, 0x6200, 1, 0x00'00'FF'00'05'0E),
            "Basic function: Special function acknowledgement; "
            "Special function acknowledgement: Request key lock 1 acknowledgement; "
            "Destination panel: all floors; Property: Default; Property parameter: reserved");
}

TEST(Cia417, AnArrowFlashesAtARate) {
  // Down and moving; data indicated, flashing (011b) at 0.25 Hz (111b), affirmed.
  EXPECT_EQ(words(cia417::profile, 0x6011, 0, 0xF7'00'03'80'12'41),
            "Basic function: Hall lantern; Down: 1; Moving: the car moves; Destination lift 8: 1; "
            "Destination panel: 3; Status: data indicated; Property: flashing; Flashing: 0.25 Hz; "
            "Predicate: acknowledgement is affirmed");
}

TEST(Cia417, AnIndicationIsWhatTheBasicFunctionSays) {
  EXPECT_EQ(words(cia417::profile, 0x6011, 0, 0x09'00'00'00'0A'43),
            "Basic function: Special indication; Special indication: Out of order; "
            "Destination panel: car; Status: data indicated; Property: color; Color: white");
  EXPECT_EQ(words(cia417::profile, 0x6011, 0, 0x00'00'00'00'01'44),
            "Basic function: Arrival indication; Up: 1; Destination panel: car; "
            "Property: Default; Property parameter: reserved");
  EXPECT_EQ(words(cia417::profile, 0x6011, 0, 0x7C'00'00'00'00'40),
            "Basic function: Position indicator; Floor data: clear the display; "
            "Destination panel: car; Property: scroll rate; Scroll rate: 7");
}

TEST(Cia417, ASensorMeasuresOnlyIfItsKindDoes) {
  // 4 x -100 + 1: minus 100 units, signal set.
  EXPECT_EQ(words(cia417::profile, 0x6012, 0, 0xFE71'80'02'01'06),
            "Basic function: Temperature sensor; Source lift 1: request; Source floor: 2; "
            "Source position: manufacturer-specific; Sensor signal: signal set; "
            "Sensor value: -100");
  EXPECT_EQ(words(cia417::profile, 0x6500, 1, 0xFFFE'00'00'01'03),
            "Basic function: Smoke sensor; Source lift 1: request; Source floor: car; "
            "Source position: reserved; Sensor signal: sensor is defective");
}

TEST(Cia417, ADoorHasACommandAndAState) {
  EXPECT_EQ(words(cia417::profile, 0x6300, 1, 0x4007),
            "Battery power: Battery power supply enabled; Door lock: Enable door lock; "
            "Finger protector: Enable finger protector; Motion detector: Enable motion detector; "
            "Door velocity: Move door with standard speed; Command: Open door with limit force");
  EXPECT_EQ(words(cia417::profile, 0x6301, 4, 0x5D21),
            "Safety contact: Contact closed; Battery power: No battery power used; "
            "Door lock: Error indicator; Finger protector: No finger detected; "
            "Motion detector: Motion detected; Force limit: not available or not installed; "
            "Status: Opening");
}

}  // namespace
}  // namespace canvoy::fields_test
