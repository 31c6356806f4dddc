// The virtual devices of clause 6, and their provisions in clauses 7 and 8.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::cia407_devices_test {
namespace {

struct ExpectedDevice {
  const char* clause;
  unsigned code;
  const char* name;
  const char* objects;  ///< index, M, O or C, and access; * where the device only consumes it
};
/// In the order of 8.1.1, without those that have classes.
constexpr ExpectedDevice expected_devices[] = {
    {"6.2", 0x01, "Main on-board computer",
     "6001Mwo 6002Mro 6100Oro 6101Oro 6102Oro 6103Oro 6104Oro 6105Oro 6106Oro 6107Oro 6108Mro "
     "6109Mro 610AOro 610BOro 610COro 610DOro 610EMro 610FOro 6110Mro 6111Mro 6112Oro 6113Oro "
     "6114Oro 6115Oro 6116Oro 6117Oro 6118Oro 6119Oro 611AOro 611BCro 611COro 611DOro 611EOro "
     "611FOro 6120Oro 6121Oro 6122Oro 6123Oro 6190Mwo 6191Mwo 6192Mwo 6193Mwo 6194Mwo 6195Mwo "
     "6196Oro 6197Oro 6198Oro 6204Mro 6481Owo 6482Owo 6483Cwo 6484Owo 6486Owo 6487Cwo 6488Owo "
     "6489Owo 6520Owo 6522Owo 6660Owo 6661Cwo 6662Owo 6663Owo 6664Owo 6665Cwo 6680Owo 6720Owo "
     "6721Owo 6722Owo 6723Owo 6740Mwo 6741Owo 6742Owo 6743Owo 6744Owo"},
    {"6.3", 0x02, "Identification",
     "6190Mro 6191Mro 6192Mro 6193Oro 6194Mro 6195Mro 6196Owo 6197Owo 6198Owo"},
    {"6.5", 0x04, "Ticket canceller",
     "6001Oro 6002Owo 6100Owo 6105Owo 6108Mwo 6109Mwo 610AOwo 610BOwo 610EMwo 6110Mwo 6111Mwo "
     "6112Owo 6116Owo 6118Owo 611COwo 6120Mwo 6191Mwo 6192Mwo 6193Owo 6194Mwo"},
    {"6.6", 0x05, "Ticket printer",
     "6100Owo 6108Mwo 6109Mwo 610AOwo 610BOwo 610COwo 610EMwo 6110Mwo 6111Mwo 6112Mwo 6116Owo "
     "6118Owo 611COwo 6120Mwo 6191Mwo 6192Mwo 6193Mwo 6194Mwo 6196Mwo 6197Owo 6740Mwo 6741Owo "
     "6742Owo 6743Owo 6744Owo"},
    {"6.7", 0x06, "Ticket/card reader/validator", ""},
    {"6.8", 0x07, "Acoustic announcer", "6001Oro 6002Owo 6109Mwo 6120Owo"},  // errata 22
    {"6.9", 0x08, "Acoustic control manager", "6001Oro 6002Owo"},
    {"6.10", 0x09, "Train bus gateway",
     "6100Owo 6101Owo 6102Owo 6103Owo 6104Owo 6105Owo 6106Owo 6107Owo 6108Mwo 6109Mwo 610AOwo "
     "610BOwo 610COwo 610DOwo 610EMwo 610FOwo 6110Mwo 6111Mwo 6112Owo 6113Owo 6114Owo 6115Owo "
     "6116Owo 6117Owo 6118Owo 611COwo 611DOwo 611EOwo 611FOwo 6120Owo 6121Owo 6123Owo 6190Mwo "
     "6191Mwo 6192Mwo 6193Mwo 6194Mwo 6195Mwo 6196Owo 6197Owo 6204Orw* 6481Owo 6484Owo 6488Owo "
     "6489Owo 6660Owo 6680Owo 6700Owo 6720Owo 6740Owo 6741Owo 6742Owo 6743Owo 6744Owo"},
    {"6.11", 0x0A, "Vehicle gateway",
     "610EOro 6481Oro 6482Oro 6483Cro 6484Oro 6486Oro 6487Cro 6488Oro 6489Oro 648AOro 648BOro "
     "648COro 648DOro"},
    {"6.13", 0x0C, "Tachograph",
     "6002Owo 6190Mwo 6520Mro 6521Mro 6522Mro 6523Oro 6524Mro 6525Mro"},  // errata 21
    {"6.14", 0x0D, "Data radio communication controller (DRCC)", ""},
    {"6.15", 0x0E, "Voice radio communication controller (VRCC)", ""},
    {"6.16", 0x0F, "Dedicated Short Range Communication (DSRC) device", ""},
    {"6.17", 0x10, "Geographical positioning device",
     "6660Mro 6661Mro 6662Oro 6663Oro 6664Mro 6665Mro"},  // errata 104
    {"6.18", 0x11, "Time fixing device", "6660Mwo 6680Mro"},
    {"6.19", 0x12, "Driver's console display", ""},
    {"6.20", 0x13, "Driver's console keyboard", "66C0Oro 6760Mro"},  // errata 7
    {"6.21", 0x14, "Passenger counter", "6001Oro 6002Owo 6488Owo 6700Mro"},
    {"6.22", 0x15, "Passenger counting manager",
     "6001Mro 6002Mwo 6100Owo 6108Mwo 6109Mwo 610EMwo 6191Mwo 6192Mwo 6193Mwo 6488Owo 6700Mwo "
     "6720Oro 6721Mro 6722Mro 6723Oro"},
    {"6.23", 0x16, "Diagnostics device",
     "6001Oro 610EMwo 6660Owo 6740Mro 6741Orw 6742Oro 6743Oro 6744Oro"},  // errata 23, 91
    {"6.24", 0x17, "Generic I/O device", "6760Oro 6761Orw 6762Oro 6763Orw"},
    {"6.25", 0x18, "Power supply", ""},
};

std::string text_of(const VirtualDeviceInfo& device) {
  std::ostringstream text;
  for (const DeviceObject& object : device.objects) {
    if (object.index != device.objects[0].index) text << ' ';
    text << std::hex << std::uppercase << object.index << "MOC"[static_cast<int>(object.category)]
         << (object.access == Access::none ? "--"
             : object.access == Access::rw ? "rw"
             : object.access == Access::ro ? "ro"
                                           : "wo");
    if (object.consumed != (object.access == Access::wo)) text << '*';
  }
  return text.str();
}
const VirtualDeviceInfo* find_device(unsigned code, unsigned device_class = 0,
                                     unsigned subclass = 0) {
  for (const VirtualDeviceInfo& device : cia407::profile.virtual_devices) {
    if (device.code == code && device.device_class == device_class && device.subclass == subclass) {
      return &device;
    }
  }
  return nullptr;
}

TEST(Cia407Devices, HaveTheObjectsOfClause6) {
  for (const ExpectedDevice& expected : expected_devices) {
    SCOPED_TRACE(expected.name);
    const VirtualDeviceInfo* device = find_device(expected.code);
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->clause, expected.clause);
    EXPECT_EQ(device->name, expected.name);
    EXPECT_EQ(text_of(*device), expected.objects);
  }
}

TEST(Cia407Devices, Are24InCombinationsOfClassAndSubclass) {
  EXPECT_EQ(cia407::profile.virtual_devices.size(), std::size(expected_devices) + 12 + 2);
}

/// 6.4: classes 1, 2, 3 and in each the subclasses 1, 2, 3, 4. In 6205h access is by sub-index
/// (errata 29); the second 6743h is 6744h (errata 5).
constexpr struct {
  unsigned index;
  const char* columns;
  const char* access;
} matrix[] = {
    {0x6001, "OOOOOOOOOOOO", "ro"}, {0x6002, "OOOOOOOOOOOO", "wo"}, {0x6101, "-OOO-OOO-OOO", "wo"},
    {0x6109, "---OMMMMMMMM", "wo"}, {0x610B, "-OMMMMMMMMMM", "wo"}, {0x610C, "OOOO----OMOO", "wo"},
    {0x610D, "-MOO-OOO-MOO", "wo"}, {0x610E, "---O---O---O", "wo"}, {0x6110, "MMMM----MMMM", "wo"},
    {0x6112, "-OOO-MOO-MOO", "wo"}, {0x6119, "---O---O-OOO", "wo"}, {0x611D, "-OOO-OOO-OOO", "wo"},
    {0x6120, "---OMMMMMMMM", "wo"}, {0x6121, "OOOOOOOOOOOO", "wo"}, {0x6123, "---O---O-OOO", "wo"},
    {0x6191, "MMMMMMMMMMMM", "wo"}, {0x6192, "OMMMOMMMMMMM", "wo"}, {0x6193, "MMMMMMMMMMMM", "wo"},
    {0x6196, "OMMMOMMMMMMM", "wo"}, {0x6200, "OOOOOOOOOOMO", "rw"}, {0x6201, "-OOOOOOOOOOO", "rw"},
    {0x6202, "OOOOOOOOOOMO", "rw"}, {0x6203, "MMMMMMMMMMMM", "rw"}, {0x6204, "-----OOOOOOO", "wo"},
    {0x6205, "-----OOOOOOO", "--"}, {0x6481, "---O---O-OOO", "wo"}, {0x6488, "---O---O-OOO", "wo"},
    {0x6489, "---O---O-OOO", "wo"}, {0x6520, "---O---O-OOO", "wo"}, {0x6662, "---O---O-OOO", "wo"},
    {0x6740, "--------OOOO", "wo"}, {0x6741, "--------OOOO", "wo"}, {0x6742, "--------OOOO", "wo"},
    {0x6743, "--------OOOO", "wo"}, {0x6744, "--------OOOO", "wo"},
};

TEST(Cia407Devices, PassengerInformationHasTheObjectsOfItsColumnInTheMatrix) {
  constexpr const char* classes[] = {"destination indicator", "next stop indicator",
                                     "information indicator"};
  constexpr const char* subclasses[] = {"simple", "text", "graphics", "extended"};
  for (unsigned column = 0; column < 12; ++column) {
    const VirtualDeviceInfo* device = find_device(3, column / 4 + 1, column % 4 + 1);
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->class_name, classes[column / 4]);
    EXPECT_EQ(device->subclass_name, subclasses[column % 4]);
    std::ostringstream expected;
    for (const auto& row : matrix) {
      if (row.columns[column] == '-') continue;
      if (expected.tellp() > 0) expected << ' ';
      expected << std::hex << std::uppercase << row.index << row.columns[column] << row.access;
    }
    EXPECT_EQ(text_of(*device), expected.str()) << column;
  }
}

TEST(Cia407Devices, TheDriverIndicatorWithAKeyboardKnowsTheTime) {  // 6.12; errata 6
  const char* others = " 6488Owo 6489Owo 648AOwo 648BOwo 648COwo 648DOwo 6740Owo";
  ASSERT_NE(find_device(0x0B, 1), nullptr);
  ASSERT_NE(find_device(0x0B, 2), nullptr);
  EXPECT_EQ(text_of(*find_device(0x0B, 1)), std::string("610EOwo") + others);
  EXPECT_EQ(text_of(*find_device(0x0B, 2)), std::string("610EMwo") + others);
  EXPECT_EQ(find_device(0x0B, 1)->class_name, "display only");
  EXPECT_EQ(find_device(0x0B, 2)->class_name, "display with keyboard");
}

TEST(Cia407Devices, FootnotesSayWhenTheTrainBusGatewayProvides) {  // 6.10; errata 32
  const VirtualDeviceInfo& gateway = *find_device(9);
  unsigned relays = 0;
  for (const DeviceObject& object : gateway.objects) {
    if (!object.condition.empty()) ++relays;
    if (object.index == 0x6700) {
      EXPECT_TRUE(object.condition.empty());
    }
  }
  EXPECT_EQ(relays, gateway.objects.size() - 1);
}

TEST(Cia407Devices, TheDeviceTypeHasCodeClassAndSubclassAboveTheProfilesNumber) {  // 8.1.1
  EXPECT_EQ(cia407::device_type(*find_device(3, 1, 2)), 0x0312'0197U);
  EXPECT_EQ(cia407::device_type(*find_device(0x0B, 2)), 0x0B20'0197U);
  EXPECT_EQ(cia407::device_type(*find_device(0x18)), 0x1800'0197U);
  EXPECT_EQ(cia407::multiple_device_type, 0x0000'0197U);
}

/// Name of the value of a field in 1000h that holds for the code.
std::string_view device_type_text(std::uint32_t device_type, std::string_view field_name) {
  for (const FieldInfo& field : cia407::profile.device_type) {
    if (field.name != field_name) continue;
    bool holds = field.when.empty();
    for (const FieldCondition& condition : field.when) {
      const std::int64_t code = device_type >> 24;
      holds = holds || (code >= condition.first && code <= condition.last);
    }
    if (!holds) continue;
    const NamedValue* named =
        find_name(field.value, extract(device_type, bits_of(field)), field.bits, false);
    return named == nullptr ? "?" : named->name;
  }
  return "no such field";
}
TEST(Cia407Devices, TheFieldsOfTheDeviceTypeAreNamed) {
  EXPECT_EQ(device_type_text(0x0312'0197, "device code"), "Passenger information");
  EXPECT_EQ(device_type_text(0x0312'0197, "class"), "destination indicator");
  EXPECT_EQ(device_type_text(0x0312'0197, "sub-class"), "text");
  EXPECT_EQ(device_type_text(0x0334'0197, "class"), "information indicator");
  EXPECT_EQ(device_type_text(0x0334'0197, "sub-class"), "extended");
  EXPECT_EQ(device_type_text(0x0B20'0197, "class"), "display with keyboard");
  EXPECT_EQ(device_type_text(0x0B20'0197, "sub-class"), "not used");
  EXPECT_EQ(device_type_text(0x0000'0197, "device code"), "Multiple virtual device");
  EXPECT_EQ(device_type_text(0x1200'0197, "class"), "not used");
  EXPECT_EQ(device_type_text(0x1210'0197, "class"), "reserved");
  EXPECT_EQ(device_type_text(0x1900'0197, "device code"), "reserved");
  EXPECT_EQ(device_type_text(0x0312'0197, "number of device profile"), "CiA 407");
}

TEST(Cia407Devices, EmergencyErrorCodesAreThoseOfClause7) {
  constexpr unsigned codes[] = {0x2110, 0x2310, 0x2320, 0x2330, 0x3110, 0x3120, 0x3210, 0x3220,
                                0x3310, 0x3320, 0x3330, 0xFF01, 0xFF02, 0xFF03, 0xFF04, 0xFF05};
  ASSERT_EQ(cia407::profile.error_codes.size(), std::size(codes));
  for (std::size_t i = 0; i < std::size(codes); ++i) {
    EXPECT_EQ(cia407::profile.error_codes[i].code, codes[i]);
    EXPECT_EQ(cia407::profile.error_codes[i].clause, "7.3");
  }
  EXPECT_EQ(cia407::profile.error_codes[3].text, "Load dump at outputs");
  EXPECT_EQ(cia407::profile.error_codes[11].text, "Out of paper");
}

// 8.1.4.3.

constexpr std::uint8_t computer = 1, identification = 2, display = 3, canceller = 4, printer = 5;

struct ExpectedPdo {
  std::uint8_t device;
  char direction;
  unsigned number;
  unsigned cob_id;
  std::vector<std::uint32_t> mapping;
};
const std::vector<std::uint32_t> time_of_day = {0x610E0108, 0x610E0208, 0x610E0308,
                                                0x610E0408, 0x610E0508, 0x610E0608};
const std::vector<std::uint32_t> route = {0x61100010, 0x61110008, 0x61160008, 0x61080008,
                                          0x610A0008};
const std::vector<std::uint32_t> line = {0x610B0108, 0x610B0208, 0x610B0308, 0x610B0408,
                                         0x610B0508, 0x610B0608, 0x610B0708, 0x610B0808};
const std::vector<std::uint32_t> stop_point = {0x61180108, 0x61180208, 0x61180308, 0x61180408,
                                               0x61180508, 0x61180608, 0x61180708, 0x61180808};
const std::vector<std::uint32_t> destination = {0x61910020, 0x61930010};
const std::vector<std::uint32_t> block = {0x61940020, 0x61920010, 0x61950010};
/// Where a receiver lacks an object, a dummy is mapped: 0005h, 0006h, 0007h (errata 97, 98).
const ExpectedPdo expected_pdos[] = {
    {computer, 'T', 1, 0x181, time_of_day},
    {computer, 'T', 2, 0x381, route},
    {computer, 'T', 3, 0x401, {0x61090020, 0x60010120}},
    {computer, 'T', 4, 0x481, line},
    {computer, 'T', 5, 0x501, stop_point},
    {computer, 'R', 2, 0x201, {0x61900020}},
    {computer, 'R', 3, 0x281, block},
    {computer, 'R', 1, 0x301, destination},
    {identification, 'T', 1, 0x201, {0x61900020}},
    {identification, 'T', 2, 0x281, block},
    {identification, 'T', 3, 0x301, destination},
    {display, 'R', 1, 0x301, destination},
    {display, 'R', 2, 0x381, {0x61100010, 0x00050008, 0x00050008, 0x00050008, 0x00050008}},
    {display, 'R', 3, 0x281, {0x00070020, 0x61920010, 0x00060010}},
    {display, 'R', 4, 0x401, {0x61090020, 0x00070020}},
    {canceller, 'R', 1, 0x181, time_of_day},
    {canceller, 'R', 2, 0x381, route},
    {canceller, 'R', 3, 0x281, {0x61940020, 0x61920010, 0x00060010}},
    {printer, 'R', 1, 0x181, time_of_day},
    {printer, 'R', 2, 0x381, route},
    {printer, 'R', 3, 0x281, {0x61940020, 0x61920010, 0x00060010}},
    {printer, 'R', 4, 0x401, {0x61090020, 0x00070020}},
    {printer, 'R', 5, 0x481, line},
    {printer, 'R', 6, 0x501, stop_point},
};

const PdoInfo* find_pdo(const ExpectedPdo& expected) {
  for (const PdoInfo& pdo : cia407::profile.pdos) {
    const bool is_tpdo = pdo.direction == PdoInfo::Direction::transmit;
    if (is_tpdo != (expected.direction == 'T') || pdo.number != expected.number) continue;
    for (const std::uint8_t device : pdo.devices) {
      if (device == expected.device) return &pdo;
    }
  }
  return nullptr;
}

TEST(Cia407Devices, PdosAreThoseOfTheTypicalConfiguration) {
  for (const ExpectedPdo& expected : expected_pdos) {
    SCOPED_TRACE(testing::Message() << "device " << unsigned{expected.device} << ' '
                                    << expected.direction << "PDO " << expected.number);
    const PdoInfo* pdo = find_pdo(expected);
    ASSERT_NE(pdo, nullptr);
    EXPECT_EQ(pdo->cob_id, expected.cob_id);
    EXPECT_FALSE(pdo->plus_node_id);
    EXPECT_EQ(pdo->transmission_type, 255);
    EXPECT_EQ(pdo->inhibit_time, 0);
    const bool is_time = expected.cob_id == 0x181 && expected.direction == 'T';
    EXPECT_EQ(pdo->event_timer, is_time ? 60'000 : 0) << "errata 101: once a minute";
    EXPECT_EQ(std::vector<std::uint32_t>(pdo->mapping.begin(), pdo->mapping.end()),
              expected.mapping);
  }
  std::size_t pdos = 0;
  for (const PdoInfo& pdo : cia407::profile.pdos) pdos += pdo.devices.size();
  EXPECT_EQ(pdos, std::size(expected_pdos));
}

TEST(Cia407Devices, TheMinimumConfigurationHasTheMessagesOfDefaultObjects) {  // errata 93
  for (const PdoInfo& pdo : cia407::profile.pdos) {
    const bool is_minimum = pdo.cob_id == 0x181 || pdo.cob_id == 0x201 || pdo.cob_id == 0x281;
    EXPECT_EQ(pdo.condition.starts_with("minimum"), is_minimum) << std::hex << pdo.cob_id;
  }
}

}  // namespace
}  // namespace canvoy::cia407_devices_test
