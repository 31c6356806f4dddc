// CiA 447: virtual devices, pre-defined PDOs and CAN-IDs, typed from the clauses of part 3 and from
// facts upon which public implementations agree.
#include "canvoy/profiles/cia447/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "canvoy/profiles/cia447.hpp"

namespace canvoy::network_test {
namespace {

TEST(Cia447Network, EachNodeHasItsRangeOfPdos) {
  constexpr std::uint32_t bases[] = {0x180, 0x200, 0x280, 0x300, 0x380, 0x400, 0x480, 0x500,
                                     0x1A0, 0x220, 0x2A0, 0x320, 0x3A0, 0x420, 0x4A0, 0x520};
  for (unsigned node_id = 1; node_id <= 16; ++node_id) {
    EXPECT_EQ(cia447::pdo_base(node_id), bases[node_id - 1]) << node_id;
  }
}

TEST(Cia447Network, EachClientHasARowOfSdoRequests) {
  constexpr std::uint32_t rows[] = {0x240, 0x250, 0x260, 0x270, 0x340, 0x350, 0x360, 0x370,
                                    0x440, 0x450, 0x460, 0x470, 0x540, 0x550, 0x560, 0x570};
  for (unsigned client = 1; client <= 16; ++client) {
    for (unsigned server = 1; server <= 16; ++server) {
      EXPECT_EQ(cia447::sdo_request(client, server), rows[client - 1] + server - 1);
      EXPECT_EQ(cia447::sdo_response(client, server), rows[client - 1] + server - 1 - 0x80);
    }
  }
  EXPECT_EQ(cia447::sdo_response(16, 1), 0x4F0U);
  EXPECT_EQ(cia447::sdo_request(13, 13), 0x54CU) << "the ISO-TP request of node 13";
}

TEST(Cia447Network, NoCanIdHasTwoMeanings) {
  std::set<std::uint32_t> used;
  const auto take = [&](std::uint32_t can_id) {
    EXPECT_TRUE(used.insert(can_id).second) << std::hex << can_id;
  };
  for (unsigned node_id = 1; node_id <= 16; ++node_id) {
    for (unsigned n = 0; n < cia447::pdos_per_node; ++n) take(cia447::pdo_base(node_id) + n);
    for (unsigned server = 1; server <= 16; ++server) {
      take(cia447::sdo_request(node_id, server));
      take(cia447::sdo_response(node_id, server));
    }
    take(cia447::sleep_can_id(node_id));
    take(0x700 + node_id);
    take(0x80 + node_id);
  }
  EXPECT_EQ(cia447::sleep_can_id(1), 0x691U);
}

struct Device {
  const char* clause;
  const char* name;
  unsigned first;
  unsigned last;
  std::size_t count;
};
constexpr Device devices[] = {
    {"4.2.2 to 4.2.4", "IVN gateway", 0x6005, 0x6063, 57},
    {"4.2.5", "Fire extinguishing system", 0x6069, 0x6069, 1},
    {"4.2.6", "Emergency fresh-air system", 0x606C, 0x606C, 1},
    {"4.2.7", "Power supply", 0x6070, 0x6074, 4},
    {"4.2.8", "Discrete inputs", 0x6078, 0x6078, 1},
    {"4.2.9", "Terminal", 0x6080, 0x60AB, 31},
    {"4.2.10", "GPS", 0x60B0, 0x60B6, 7},
    {"4.2.11", "Navigation system", 0x60C0, 0x60C5, 6},
    {"4.2.12", "Taximeter", 0x60D0, 0x60DB, 9},
    {"4.2.13", "Printer", 0x60E0, 0x60EB, 10},
    {"4.2.14", "Real time clock (RTC)", 0x60F0, 0x60F5, 6},
    {"4.2.15", "Driver identification", 0x60F9, 0x60FC, 4},
    {"4.2.16", "Tariff display", 0x6100, 0x610A, 10},
    {"4.2.17", "Taxi alarm system", 0x6110, 0x6110, 1},
    {"4.2.18", "Radio", 0x6115, 0x6117, 3},
    {"4.2.19", "Audio switch", 0x6120, 0x6122, 3},
    {"4.2.20", "Roof bar light", 0x6130, 0x6131, 2},
    {"4.2.21", "Roof bar sound", 0x6138, 0x613B, 4},
    {"4.2.22", "Vehicle \"blue\" light flasher module", 0x6140, 0x6141, 2},
    {"4.2.23", "Radio hand-free conversation", 0x6150, 0x6151, 2},
};

TEST(Cia447Devices, HaveTheObjectsOfTheirClauses) {
  ASSERT_EQ(cia447::profile.virtual_devices.size(), std::size(devices));
  for (std::size_t i = 0; i < std::size(devices); ++i) {
    const VirtualDeviceInfo& device = cia447::profile.virtual_devices[i];
    SCOPED_TRACE(devices[i].name);
    EXPECT_EQ(device.name, devices[i].name);
    EXPECT_EQ(device.clause, devices[i].clause);
    EXPECT_EQ(device.code, 0) << "not known";
    ASSERT_EQ(device.objects.size(), devices[i].count);
    EXPECT_EQ(device.objects[0].index, devices[i].first);
    EXPECT_EQ(device.objects[device.objects.size() - 1].index, devices[i].last);
  }
}

TEST(Cia447Devices, TogetherProvideEachObjectOnce) {
  std::set<unsigned> provided;
  for (const VirtualDeviceInfo& device : cia447::profile.virtual_devices) {
    for (const DeviceObject& object : device.objects) {
      EXPECT_TRUE(provided.insert(object.index).second) << std::hex << object.index;
    }
  }
  EXPECT_EQ(provided.size(), cia447::profile.objects.size());
}

struct Pdo {
  unsigned number;
  std::vector<std::uint32_t> mapping;
};
const std::vector<Pdo> pdos = {
    {1, {0x60070008}},
    {2, {0x60100018, 0x60050008, 0x601A0010}},
    {3, {0x60330008}},
    {4, {0x60270010, 0x60280010, 0x60090008}},
    {5, {0x600B0018, 0x600D0010, 0x601D0008, 0x60300008}},
    {6, {0x60190118, 0x60190218}},
    {7, {0x60320010}},
    {17, {0x60500010, 0x60530010, 0x60550018}},
    {18, {0x60510008}},
    {19, {0x60400020, 0x60470008, 0x604A0008}},
    {65, {0x61500008}},
    {66, {0x61410020}},
    {67, {0x60FA0008}},
    {68, {0x606C0008}},
    {69, {0x60690008}},
    {70, {0x60B00120, 0x60B00220}},
    {71, {0x61100010}},
    {72, {0x60E00008, 0x60E10010}},
    {73, {0x61310120, 0x61310220}},
    {74, {0x61310320, 0x61310420}},
    {75, {0x61310520}},
    {76, {0x613B0120, 0x613B0220}},
    {77, {0x61010020, 0x61020020}},
    {78, {0x61030020}},
    {79, {0x60780010}},
    {80, {0x60D80008}},
    {81,
     {0x60800008, 0x60820008, 0x60850008, 0x60870008, 0x608A0008, 0x608C0008, 0x60970008,
      0x609C0008}},
    {82, {0x60900008, 0x60920008, 0x60930008, 0x60950008}},
    {83, {0x61150008, 0x61170008}},
    {84, {0x60700008, 0x60730008}},
};

TEST(Cia447Pdos, AreTheSameInBothDirections) {
  ASSERT_EQ(cia447::profile.pdos.size(), 2 * pdos.size());
  for (std::size_t i = 0; i < cia447::profile.pdos.size(); ++i) {
    const PdoInfo& pdo = cia447::profile.pdos[i];
    const Pdo& expected = pdos[i % pdos.size()];
    SCOPED_TRACE(expected.number);
    EXPECT_EQ(pdo.direction == PdoInfo::Direction::transmit, i < pdos.size());
    EXPECT_EQ(pdo.number, expected.number);
    EXPECT_EQ(std::vector(pdo.mapping.begin(), pdo.mapping.end()), expected.mapping);
    EXPECT_EQ(pdo.cob_id & 0x8000'0000, 0x8000'0000) << "its CAN-ID is not known";
  }
}

/// Entries that part 3 maps by default and no pre-defined PDO has, and vice versa.
TEST(Cia447Pdos, CarryWhatPart3MapsByDefault) {
  std::set<std::uint32_t> mapped;
  for (const Pdo& pdo : pdos) {
    for (const std::uint32_t entry : pdo.mapping) mapped.insert(entry >> 8);
  }
  std::set<std::uint32_t> by_default;
  for (const ObjectInfo* object : cia447::profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      if (entry.mapping != Mapping::by_default) continue;
      by_default.insert(std::uint32_t{object->index} << 8 | entry.sub_first);
    }
  }
  std::set<std::uint32_t> only_by_default;
  std::set<std::uint32_t> only_mapped;
  std::ranges::set_difference(by_default, mapped,
                              std::inserter(only_by_default, only_by_default.end()));
  std::ranges::set_difference(mapped, by_default, std::inserter(only_mapped, only_mapped.end()));
  EXPECT_EQ(only_by_default, (std::set<std::uint32_t>{0x603100, 0x604900, 0x610400}));
  EXPECT_EQ(only_mapped, (std::set<std::uint32_t>{0x610200}));  // Z40
}

}  // namespace
}  // namespace canvoy::network_test
