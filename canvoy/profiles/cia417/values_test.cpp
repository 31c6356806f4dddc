// What the values of CiA 417-4 mean, and what they measure, typed from the text.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/testing/words.hpp"

namespace canvoy::cia417_values_test {
namespace {

/// The named values of a field, each boundary of them.
struct ExpectedName {
  const char* clause;
  unsigned index;
  unsigned sub;
  const char* field;  ///< empty: the entry itself
  std::int64_t first;
  std::int64_t last;
  const char* name;
  Meaning meaning = Meaning::state;
};
constexpr ExpectedName names[] = {
    {"4.3.1", 0x6100, 1, "Basic function", 0x00, 0x00, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Basic function", 0x01, 0x01, "Generic input"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x02, 0x02, "Standard hall call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x03, 0x03, "Low priority hall call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x04, 0x04, "High priority hall call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x05, 0x05, "Standard car call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x06, 0x06, "Low priority car call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x07, 0x07, "High priority car call request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x08, 0x08, "Standard destination call"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x09, 0x09, "Low priority destination call"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0A, 0x0A, "High priority destination call"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0B, 0x0B, "Standard call to destination floor"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0C, 0x0C, "Low priority call to destination floor"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0D, 0x0D, "High priority call to destination floor"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0E, 0x0E, "Special function"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x0F, 0x0F, "Access code upload request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x10, 0x10, "Speech connection request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x11, 0x11, "Area monitoring connection request"},
    {"4.3.1", 0x6100, 1, "Basic function", 0x12, 0x7F, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Basic function", 0x80, 0xFF, "manufacturer-specific",
     Meaning::manufacturer},
    {"4.3.1", 0x6100, 1, "Special function", 0x00, 0x00, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Special function", 0x01, 0x01, "Request fan 1"},
    {"4.3.1", 0x6100, 1, "Special function", 0x02, 0x02, "Request fan 2"},
    {"4.3.1", 0x6100, 1, "Special function", 0x03, 0x03, "Request load time 1"},
    {"4.3.1", 0x6100, 1, "Special function", 0x04, 0x04, "Request load time 2"},
    {"4.3.1", 0x6100, 1, "Special function", 0x05, 0x05, "Key lock 1"},
    {"4.3.1", 0x6100, 1, "Special function", 0x06, 0x06, "Key lock 2"},
    {"4.3.1", 0x6100, 1, "Special function", 0x07, 0x07, "Key lock 3"},
    {"4.3.1", 0x6100, 1, "Special function", 0x08, 0x08, "Key lock 4"},
    {"4.3.1", 0x6100, 1, "Special function", 0x09, 0x09, "Request door open"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0A, 0x0A, "Request door close"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0B, 0x0B, "Fire service enable"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0C, 0x0C, "Fire service"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0D, 0x0D, "Hall call disable"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0E, 0x0E, "Attendant service"},
    {"4.3.1", 0x6100, 1, "Special function", 0x0F, 0x0F, "VIP service"},
    {"4.3.1", 0x6100, 1, "Special function", 0x10, 0x10, "Out of order"},
    {"4.3.1", 0x6100, 1, "Special function", 0x11, 0x11, "Bed passenger service"},
    {"4.3.1", 0x6100, 1, "Special function", 0x12, 0x12, "Special service"},
    {"4.3.1", 0x6100, 1, "Special function", 0x13, 0x13, "Service run"},
    {"4.3.1", 0x6100, 1, "Special function", 0x14, 0x14, "Dogging service enable"},
    {"4.3.1", 0x6100, 1, "Special function", 0x15, 0x15, "Dogging service up"},
    {"4.3.1", 0x6100, 1, "Special function", 0x16, 0x16, "Dogging service down"},
    {"4.3.1", 0x6100, 1, "Special function", 0x17, 0xFF, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Basic function", 0x00, 0x00, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Basic function", 0x01, 0x01, "Generic output"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x02, 0x02, "Standard hall call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x03, 0x03, "Low priority hall call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x04, 0x04, "High priority hall call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x05, 0x05, "Standard car call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x06, 0x06, "Low priority car call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x07, 0x07, "High priority car call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x08, 0x08, "Standard destination call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x09, 0x09,
     "Low priority destination call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0A, 0x0A,
     "High priority destination call acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0B, 0x0B,
     "Standard call to destination floor acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0C, 0x0C,
     "Low priority call to destination floor acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0D, 0x0D,
     "High priority call to destination floor acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0E, 0x0E, "Special function acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x0F, 0x0F, "Access code upload acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x10, 0x10, "Speech connection acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x11, 0x11,
     "Area monitoring connection acknowledgement"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x12, 0x3F, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Basic function", 0x40, 0x40, "Position indicator"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x41, 0x41, "Hall lantern"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x42, 0x42, "Direction indication"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x43, 0x43, "Special indication"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x44, 0x44, "Arrival indication"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x45, 0x45, "Operation data"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x46, 0x46, "Publicity indication"},
    {"4.4.1", 0x6200, 1, "Basic function", 0x47, 0x7F, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Basic function", 0x80, 0xFF, "manufacturer-specific",
     Meaning::manufacturer},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x00, 0x00, "reserved",
     Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x01, 0x01,
     "Request fan 1 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x02, 0x02,
     "Request fan 2 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x03, 0x03,
     "Request load time 1 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x04, 0x04,
     "Request load time 2 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x05, 0x05,
     "Request key lock 1 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x06, 0x06,
     "Request key lock 2 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x07, 0x07,
     "Request key lock 3 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x08, 0x08,
     "Request key lock 4 acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x09, 0x09,
     "Request door open acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0A, 0x0A,
     "Request door close acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0B, 0x0B,
     "Fire service enable acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0C, 0x0C,
     "Fire service acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0D, 0x0D,
     "Hall call disable acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0E, 0x0E,
     "Attendant service acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x0F, 0x0F,
     "VIP service acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x10, 0x10,
     "Out of order acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x11, 0x11,
     "Bed passenger service acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x12, 0x12,
     "Special service acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x13, 0x13,
     "Service run acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x14, 0x14,
     "Dogging service enable acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x15, 0x15,
     "Dogging service up acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x16, 0x16,
     "Dogging service down acknowledgement"},
    {"4.4.1", 0x6200, 1, "Special function acknowledgement", 0x17, 0xFF, "reserved",
     Meaning::reserved},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x00, 0x00, "all displays off"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x01, 0x01, "No load"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x02, 0x02, "Full load"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x03, 0x03, "Over load"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x04, 0x04, "Fire"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x05, 0x05, "Fire brigade service"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x06, 0x06, "Help is coming"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x07, 0x07, "Special service"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x08, 0x08, "Load time"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x09, 0x09, "Occupied"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x0A, 0x0A, "Out of order"},
    {"4.4.1, A4", 0x6200, 1, "Special indication", 0x0B, 0xFF, "reserved", Meaning::reserved},
    {"4.13.1", 0x6500, 1, "Basic function", 0x00, 0x00, "reserved", Meaning::reserved},
    {"4.13.1", 0x6500, 1, "Basic function", 0x01, 0x01, "Generic sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x02, 0x02, "Glass sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x03, 0x03, "Smoke sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x04, 0x04, "Damage sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x05, 0x05, "Pressure sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x06, 0x06, "Temperature sensor"},
    {"4.13.1", 0x6500, 1, "Basic function", 0x07, 0x7F, "reserved", Meaning::reserved},
    {"4.13.1", 0x6500, 1, "Basic function", 0x80, 0xFF, "manufacturer-specific",
     Meaning::manufacturer},
    {"4.6.1", 0x6300, 1, "Command", 0, 0, "Close door without limit force"},
    {"4.6.1", 0x6300, 1, "Command", 1, 1, "Close door with limit force"},
    {"4.6.1", 0x6300, 1, "Command", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Command", 3, 3, "Open door without limit force"},
    {"4.6.1", 0x6300, 1, "Command", 4, 4, "Open door with limit force"},
    {"4.6.1", 0x6300, 1, "Command", 5, 6, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Command", 7, 7, "Stop door without limit force"},
    {"4.6.1", 0x6300, 1, "Command", 8, 8, "Stop door with limit force"},
    {"4.6.1", 0x6300, 1, "Command", 9, 13, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Command", 14, 14, "Reset door"},
    {"4.6.1", 0x6300, 1, "Command", 15, 15, "do not care / take no action", Meaning::do_not_care},
    {"4.6.1", 0x6300, 1, "Door velocity", 0, 0, "Move door with standard speed"},
    {"4.6.1", 0x6300, 1, "Door velocity", 1, 1, "Move door with reduced speed"},
    {"4.6.1", 0x6300, 1, "Door velocity", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Door velocity", 3, 3, "do not care / take no action",
     Meaning::do_not_care},
    {"4.6.1", 0x6300, 1, "Motion detector", 0, 0, "Enable motion detector"},
    {"4.6.1", 0x6300, 1, "Motion detector", 1, 1, "Disable motion detector"},
    {"4.6.1", 0x6300, 1, "Motion detector", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Motion detector", 3, 3, "do not care / take no action",
     Meaning::do_not_care},
    {"4.6.1", 0x6300, 1, "Finger protector", 0, 0, "Enable finger protector"},
    {"4.6.1", 0x6300, 1, "Finger protector", 1, 1, "Disable finger protector"},
    {"4.6.1", 0x6300, 1, "Finger protector", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Finger protector", 3, 3, "do not care / take no action",
     Meaning::do_not_care},
    {"4.6.1", 0x6300, 1, "Door lock", 0, 0, "Enable door lock"},
    {"4.6.1", 0x6300, 1, "Door lock", 1, 1, "Disable door lock"},
    {"4.6.1", 0x6300, 1, "Door lock", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Door lock", 3, 3, "do not care / take no action", Meaning::do_not_care},
    {"4.6.1", 0x6300, 1, "Battery power", 0, 0, "Battery power supply disabled"},
    {"4.6.1", 0x6300, 1, "Battery power", 1, 1, "Battery power supply enabled"},
    {"4.6.1", 0x6300, 1, "Battery power", 2, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "Battery power", 3, 3, "do not care / take no action",
     Meaning::do_not_care},
    {"4.7.1", 0x6301, 1, "Status", 0, 0, "Door closed with torque"},
    {"4.7.1", 0x6301, 1, "Status", 1, 1, "Door closed without torque"},
    {"4.7.1", 0x6301, 1, "Status", 2, 2, "Closing"},
    {"4.7.1", 0x6301, 1, "Status", 3, 3, "Door opened with torque"},
    {"4.7.1", 0x6301, 1, "Status", 4, 4, "Door opened without torque"},
    {"4.7.1", 0x6301, 1, "Status", 5, 5, "Opening"},
    {"4.7.1", 0x6301, 1, "Status", 6, 6, "Re-opening"},
    {"4.7.1", 0x6301, 1, "Status", 7, 7, "Stopped"},
    {"4.7.1", 0x6301, 1, "Status", 8, 13, "reserved", Meaning::reserved},
    {"4.7.1", 0x6301, 1, "Status", 14, 14, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Status", 15, 15, "not available / not installed", Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Force limit", 0, 0, "Force limit not reached"},
    {"4.7.1", 0x6301, 1, "Force limit", 1, 1, "Force limit reached"},
    {"4.7.1", 0x6301, 1, "Force limit", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Force limit", 3, 3, "not available or not installed", Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Motion detector", 0, 0, "Motion not detected"},
    {"4.7.1", 0x6301, 1, "Motion detector", 1, 1, "Motion detected"},
    {"4.7.1", 0x6301, 1, "Motion detector", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Motion detector", 3, 3, "not available or not installed",
     Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Finger protector", 0, 0, "No finger detected"},
    {"4.7.1", 0x6301, 1, "Finger protector", 1, 1, "Finger detected"},
    {"4.7.1", 0x6301, 1, "Finger protector", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Finger protector", 3, 3, "not available or not installed",
     Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Door lock", 0, 0, "Door not locked"},
    {"4.7.1", 0x6301, 1, "Door lock", 1, 1, "Door locked"},
    {"4.7.1", 0x6301, 1, "Door lock", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Door lock", 3, 3, "not available or not installed", Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Safety contact", 0, 0, "Contact not closed"},
    {"4.7.1", 0x6301, 1, "Safety contact", 1, 1, "Contact closed"},
    {"4.7.1", 0x6301, 1, "Safety contact", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Safety contact", 3, 3, "not available or not installed",
     Meaning::invalid},
    {"4.7.1", 0x6301, 1, "Battery power", 0, 0, "No battery power used"},
    {"4.7.1", 0x6301, 1, "Battery power", 1, 1, "Battery power used"},
    {"4.7.1", 0x6301, 1, "Battery power", 2, 2, "Error indicator", Meaning::failure},
    {"4.7.1", 0x6301, 1, "Battery power", 3, 3, "not available or not installed", Meaning::invalid},
    {"4.8.1", 0x6310, 1, "Status", 0, 0, "No subject detected"},
    {"4.8.1", 0x6310, 1, "Status", 1, 1, "Subject detected"},
    {"4.8.1", 0x6310, 1, "Status", 2, 2, "Error indicator", Meaning::failure},
    {"4.8.1", 0x6310, 1, "Status", 3, 3, "not available / not installed", Meaning::invalid},
    // Beside the long lists.
    {"4.2.2, A23", 0x6001, 0, "", 0x00, 0x00, "reserved", Meaning::reserved},
    {"4.2.6", 0x6020, 0, "Access", 0, 0, "as specified"},
    {"4.2.6", 0x6020, 0, "Access", 1, 1, "ro"},
    {"4.2.6", 0x6020, 0, "Access", 2, 2, "wo"},
    {"4.2.6", 0x6020, 0, "Access", 3, 3, "rw"},
    {"4.2.6", 0x6020, 0, "Action", 0, 0, "reserved", Meaning::reserved},
    {"4.2.6", 0x6020, 0, "Action", 1, 1, "create"},
    {"4.2.6", 0x6020, 0, "Action", 2, 2, "destroy"},
    {"4.2.6", 0x6020, 0, "Action", 3, 3, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Target stop", 0, 0, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Target stop", 255, 255, "reserved", Meaning::reserved},
    {"4.3.1", 0x6100, 1, "Call request", 0, 0, "no call request"},
    {"4.3.1", 0x6100, 1, "Call request", 1, 1, "call request"},
    {"4.3.1", 0x6100, 1, "Call request", 2, 2, "function is defective", Meaning::failure},
    {"4.3.1", 0x6100, 1, "Call request", 3, 3, "function is not installed",
     Meaning::not_implemented},
    {"4.3.1", 0x6100, 1, "Source panel", 0, 0, "car"},
    {"4.3.1", 0x6100, 1, "Source panel", 255, 255, "reserved", Meaning::reserved},
    {"4.3.2", 0x6120, 1, "", 0xFFFFFFFF, 0xFFFFFFFF, "nothing used", Meaning::invalid},
    {"4.3.3", 0x6140, 1, "Limitation", 0, 0, "reserved", Meaning::reserved},
    {"4.3.3", 0x6140, 1, "Sending event", 0, 0, "reserved", Meaning::reserved},
    {"4.3.3", 0x6140, 1, "Sending event", 255, 255, "not used", Meaning::invalid},
    {"4.4.1", 0x6200, 1, "Target stop acknowledgement", 0, 0, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Target stop acknowledgement", 255, 255, "all target stop buttons"},
    {"4.4.1", 0x6200, 1, "Floor data", 0, 0, "clear the display"},
    {"4.4.1", 0x6200, 1, "Floor data", 255, 255, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Property", 0, 0, "Default"},
    {"4.4.1", 0x6200, 1, "Property", 1, 1, "continuous"},
    {"4.4.1", 0x6200, 1, "Property", 2, 2, "impulse"},
    {"4.4.1", 0x6200, 1, "Property", 3, 3, "flashing"},
    {"4.4.1", 0x6200, 1, "Property", 4, 4, "color"},
    {"4.4.1", 0x6200, 1, "Property", 5, 5, "volume"},
    {"4.4.1", 0x6200, 1, "Property", 6, 6, "scroll rate"},
    {"4.4.1", 0x6200, 1, "Property", 7, 7, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Impulse", 0, 0, "0.5 s"},
    {"4.4.1", 0x6200, 1, "Impulse", 2, 2, "1.5 s"},
    {"4.4.1", 0x6200, 1, "Impulse", 4, 4, "3 s"},
    {"4.4.1", 0x6200, 1, "Impulse", 7, 7, "15 s"},
    {"4.4.1", 0x6200, 1, "Flashing", 0, 0, "10 Hz"},
    {"4.4.1", 0x6200, 1, "Flashing", 1, 1, "7.5 Hz"},
    {"4.4.1", 0x6200, 1, "Flashing", 3, 3, "2 Hz"},
    {"4.4.1", 0x6200, 1, "Flashing", 7, 7, "0.25 Hz"},
    {"4.4.1", 0x6200, 1, "Color", 0, 0, "white"},
    {"4.4.1", 0x6200, 1, "Color", 1, 1, "yellow"},
    {"4.4.1", 0x6200, 1, "Color", 2, 2, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Color", 3, 3, "green"},
    {"4.4.1", 0x6200, 1, "Color", 4, 4, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Color", 5, 5, "red"},
    {"4.4.1", 0x6200, 1, "Color", 6, 6, "reserved", Meaning::reserved},
    {"4.4.1", 0x6200, 1, "Color", 7, 7, "blue"},
    {"4.4.1", 0x6200, 1, "Volume", 0, 0, "min."},
    {"4.4.1", 0x6200, 1, "Volume", 1, 6, "vary"},
    {"4.4.1", 0x6200, 1, "Volume", 7, 7, "max."},
    {"4.4.1", 0x6200, 1, "Scroll rate", 0, 0, "automatic"},
    {"4.4.1, A22", 0x6200, 1, "Destination panel", 255, 255, "all floors"},
    {"4.5.1, B11", 0x6220, 1, "Error code", 0, 0xFE, "reserved", Meaning::reserved},
    {"4.5.4", 0x6280, 1, "Flash rate", 0, 0, "always set"},
    {"4.5.4", 0x6280, 1, "Intensity/Volume", 0, 0, "reserved", Meaning::reserved},
    {"4.5.4", 0x6280, 1, "Intensity/Volume", 1, 1, "minimal"},
    {"4.5.4", 0x6280, 1, "Intensity/Volume", 0xFE, 0xFE, "maximum"},
    {"4.6.1", 0x6300, 1, "reserved", 0, 2, "reserved", Meaning::reserved},
    {"4.6.1", 0x6300, 1, "reserved", 3, 3, "all bits 1", Meaning::padding},
    {"4.7.2", 0x6302, 1, "", 0, 0, "door is closed"},
    {"4.7.2", 0x6302, 1, "", 0xFFFF, 0xFFFF, "not available or not requested", Meaning::invalid},
    {"4.7.3", 0x6304, 1, "", 0, 0, "default velocity profile"},
    {"4.7.3", 0x6304, 1, "", 1, 0xFF, "manufacturer-specific velocity profile",
     Meaning::manufacturer},
    {"4.7.3", 0x6304, 2, "", 0, 0, "default width profile"},
    {"4.7.3, B3", 0x6304, 2, "", 1, 0xFF, "manufacturer-specific width profile",
     Meaning::manufacturer},
    {"4.7.3", 0x6307, 3, "", 0, 0, "undefined"},
    {"4.7.3", 0x6307, 3, "", 1, 1, "center opening"},
    {"4.7.3", 0x6307, 3, "", 2, 2, "left side opening"},
    {"4.7.3", 0x6307, 3, "", 3, 3, "right side opening"},
    {"4.7.3", 0x6307, 3, "", 4, 0xFF, "reserved", Meaning::reserved},
    {"4.7.3", 0x6304, 4, "", 0, 0, "sends only its status by PDO"},
    {"4.7.3", 0x6304, 4, "", 1, 1, "re-opens"},
    {"4.7.3", 0x6304, 5, "", 2, 2, "stops"},
    {"4.7.3", 0x6304, 5, "", 3, 0xFF, "reserved", Meaning::reserved},
    {"4.7.3, B14", 0x6304, 6, "", 1, 1, "re-closes while the finger protector is active"},
    {"4.7.3", 0x6304, 7, "", 1, 1, "re-opens until no motion is detected"},
    {"4.7.3", 0x6304, 8, "", 0, 0, "timer disabled"},
    {"4.7.3", 0x6304, 0x0B, "", 0, 0, "door stops without torque"},
    {"4.7.3", 0x6304, 0x0B, "", 1, 1, "door stops with torque"},
    {"4.7.3", 0x6304, 0x0B, "", 2, 2, "door closes with reduced speed"},
    {"4.7.3", 0x6304, 0x0B, "", 3, 0xFF, "reserved", Meaning::reserved},
    {"4.11.1.4", 0x6403, 0, "", 1, 1, "profile position mode"},
    {"4.11.1.4", 0x6404, 0, "", 3, 3, "profile velocity mode"},
    {"4.11.1.4", 0x6404, 0, "", -128, -1, "manufacturer-specific mode", Meaning::manufacturer},
    {"4.11.1.12, A16", 0x640C, 0, "", 0, 0, "no jerk"},
    {"4.11.1.12, A16", 0x640C, 0, "", 3, 3, "reserved", Meaning::reserved},
    {"4.11.1.12, A16", 0x640C, 0, "", 5, 5, "reserved", Meaning::reserved},
    {"4.12.1", 0x6480, 1, "", 0xFFFF, 0xFFFF, "sensor error, or no actual value", Meaning::invalid},
    {"4.12.4", 0x6483, 4, "", 0xFFFF, 0xFFFF, "unused limit", Meaning::invalid},
    {"4.13.1", 0x6500, 1, "Sensor signal", 1, 1, "signal set"},
    {"4.13.1", 0x6500, 1, "Sensor signal", 2, 2, "sensor is defective", Meaning::failure},
    {"4.13.1", 0x6500, 1, "Sensor signal", 3, 3, "sensor is not installed",
     Meaning::not_implemented},
    {"4.13.1", 0x6500, 1, "Source position", 0, 0x7F, "reserved", Meaning::reserved},
    {"4.13.1", 0x6500, 1, "Source position", 0x80, 0xFF, "manufacturer-specific",
     Meaning::manufacturer},
};

TEST(Cia417, ValuesHaveTheNamesOfTheirClause) {
  for (const ExpectedName& expected : names) {
    const EntryInfo& entry = entry_at(cia417::profile, expected.index, expected.sub);
    const std::string_view field_name = expected.field;
    SCOPED_TRACE(testing::Message()
                 << expected.clause << " " << field_name << " " << expected.first);
    const FieldInfo* field = field_name.empty() ? nullptr : field_at(entry, field_name);
    ASSERT_EQ(field == nullptr, field_name.empty());
    const ValueInfo& value = field != nullptr ? field->value : entry.value;
    const BitRange bits = field != nullptr ? bits_of(*field) : bits_of(entry);
    for (std::int64_t number = expected.first; number <= expected.last; ++number) {
      const NamedValue* named = find_name(value, number, bits.bits, bits.is_signed);
      ASSERT_NE(named, nullptr) << number;
      EXPECT_EQ(named->name, expected.name) << number;
      EXPECT_EQ(named->meaning, expected.meaning) << number;
    }
  }
}

struct ExpectedQuantity {
  const char* clause;
  unsigned index;
  unsigned sub;
  const char* field;  ///< empty: the entry itself
  Unit unit;
  std::int64_t raw;
  double physical;
};
constexpr ExpectedQuantity quantities[] = {
    {"4.3.3", 0x6140, 1, "Limitation", Unit::per_second, 4, 4},
    {"4.3.4", 0x6160, 1, "Debounce time", Unit::millisecond, 254, 254},
    {"4.5.2", 0x6240, 1, "Impulse time", Unit::second, 15, 1.5},
    {"4.5.4", 0x6280, 1, "Flash rate", Unit::hertz, 75, 7.5},
    {"4.5.4", 0x6280, 1, "Scroll rate", Unit::line_per_second, 7, 7},
    {"4.4.1", 0x6200, 1, "Scroll rate", Unit::line_per_second, 7, 7},
    {"4.7.2", 0x6302, 4, "", Unit::millimetre, 900, 900},
    {"4.7.3", 0x6304, 8, "", Unit::second, 10, 10},
    {"4.7.3", 0x6304, 9, "", Unit::second, 10, 10},
    {"4.7.3, B12", 0x6304, 0x0A, "", Unit::second, 10, 20},
    // 10 counts of 10 micrometres, of 0.1 mm/s and 1 count of 1 mm/s2.
    {"4.9.5", 0x6384, 1, "", Unit::micrometre, 10, 100},
    {"4.9.5", 0x6387, 2, "", Unit::millimetre_per_second, 10, 1},
    {"4.9.5", 0x6386, 3, "", Unit::millimetre_per_second_squared, 1, 1},
    {"4.9.4", 0x6383, 1, "", Unit::millimetre, 123456, 12345.6},
    {"4.9.9", 0x6390, 4, "", Unit::millimetre_per_second, -1600, -1600},
    {"4.9.10", 0x6391, 2, "", Unit::millimetre_per_second_squared, -900, -900},
    {"4.9.30", 0x63C8, 1, "", Unit::hour, 25, 2.5},
    {"4.11.6.6", 0x6435, 2, "", Unit::millisecond, 250, 250},
    {"4.12.1", 0x6480, 1, "", Unit::kilogram, 630, 630},
    {"4.12.4", 0x6483, 4, "", Unit::kilogram, 693, 693},
};

TEST(Cia417, ValuesHaveTheUnitsAndResolutionsOfTheirClause) {
  for (const ExpectedQuantity& expected : quantities) {
    const EntryInfo& entry = entry_at(cia417::profile, expected.index, expected.sub);
    const std::string_view field_name = expected.field;
    SCOPED_TRACE(testing::Message() << expected.clause << " " << entry.name << " " << field_name);
    const FieldInfo* field = field_name.empty() ? nullptr : field_at(entry, field_name);
    const ValueInfo& value = field != nullptr ? field->value : entry.value;
    EXPECT_EQ(value.unit, expected.unit);
    EXPECT_DOUBLE_EQ(to_physical(static_cast<double>(expected.raw), value.scale),
                     expected.physical);
  }
}

/// Position, speed and acceleration of each unit are counted in the steps of its own object
/// (errata A19).
TEST(Cia417, MeasuringStepsAreThoseOfTheSamePositionUnit) {
  constexpr unsigned measured[][2] = {{0x6383, 1}, {0x6390, 2}, {0x6391, 3}};
  for (const auto& [index, step_sub] : measured) {
    for (unsigned unit = 1; unit <= 4; ++unit) {
      const StepEntry step = entry_at(cia417::profile, index, unit).value.step;
      EXPECT_EQ(step.index, 0x6383 + unit);
      EXPECT_EQ(step.sub, step_sub);
    }
  }
}

TEST(Cia417, TheStateOfTheDriveIsInBits0To3And5And6) {
  using cia417::DriveState;
  EXPECT_EQ(cia417::drive_state(0x0000), DriveState::not_ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0020), DriveState::not_ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0240), DriveState::switch_on_disabled);
  EXPECT_EQ(cia417::drive_state(0x0260), DriveState::switch_on_disabled);
  EXPECT_EQ(cia417::drive_state(0x0231), DriveState::ready_to_switch_on);
  EXPECT_EQ(cia417::drive_state(0x0233), DriveState::switched_on);
  EXPECT_EQ(cia417::drive_state(0x0637), DriveState::operation_enabled);
  EXPECT_EQ(cia417::drive_state(0x0217), DriveState::quick_stop_active);
  EXPECT_EQ(cia417::drive_state(0x021F), DriveState::fault_reaction_active);
  EXPECT_EQ(cia417::drive_state(0x0218), DriveState::fault);
}

}  // namespace
}  // namespace canvoy::cia417_values_test
