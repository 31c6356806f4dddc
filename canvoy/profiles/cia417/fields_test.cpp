// Meaning of the bits of CiA 417-4 objects in combination, typed from the text.
// canvoy/profiles/clauses/417-4.txt has their positions.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/testing/words.hpp"

namespace canvoy::fields_test {
namespace {

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
