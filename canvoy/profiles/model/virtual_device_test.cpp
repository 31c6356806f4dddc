#include "canvoy/profiles/model/virtual_device.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::virtual_device_test {
namespace {

constexpr auto smallest_canceller = virtual_device(cia407::profile, cia407::ticket_canceller);

TEST(VirtualDevice, HasItsMandatoryObjectsAndNoOthers) {
  constexpr std::uint16_t mandatory[] = {0x6108, 0x6109, 0x610E, 0x6110, 0x6111,
                                         0x6120, 0x6191, 0x6192, 0x6194};
  ASSERT_EQ(smallest_canceller.size(), std::size(mandatory));
  for (std::size_t i = 0; i < std::size(mandatory); ++i) {
    EXPECT_EQ(smallest_canceller.begin()[i].index(), mandatory[i]);
  }
}

constexpr auto canceller = describe(
    virtual_device(cia407::profile, cia407::ticket_canceller,
                   {{0x6001, 5}, {0x6002, 4}, {0x6112, 2, 40}, 0x6116, {0x611C, 0xFF, 12}}),
    cia301::device_type(cia407::device_type(cia407::ticket_canceller)),
    cia407::error_register_object, cia301::identity({.vendor_id = 1}));
constexpr auto canceller_layout = lay_out_device<canceller>();

std::string access_at(const DeviceMemory& device, unsigned index, unsigned sub) {
  const auto entry =
      device.dictionary.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
  return entry ? access_text(entry->row->access) : "nothing";
}

TEST(VirtualDevice, HasTheAccessThatClause6Gives) {
  const DeviceMemory device(canceller_layout.tables(), 9);
  EXPECT_EQ(access_at(device, 0x6001, 0), "ro");
  EXPECT_EQ(access_at(device, 0x6001, 1), "ro T") << "it provides events";
  EXPECT_EQ(access_at(device, 0x6001, 5), "ro T");
  EXPECT_EQ(access_at(device, 0x6002, 1), "wo R") << "it consumes commands";
  EXPECT_EQ(access_at(device, 0x6109, 0), "wo R");
  EXPECT_EQ(access_at(device, 0x610E, 0), "ro") << "sub-index 00h is no value";
  EXPECT_EQ(access_at(device, 0x610E, 6), "wo R");
  EXPECT_EQ(access_at(device, 0x6116, 0), "wo R");
  EXPECT_EQ(access_at(device, 0x6120, 0), "wo") << "not mappable";
  EXPECT_EQ(access_at(device, 0x6100, 0), "nothing") << "not wanted";
}

TEST(VirtualDevice, HasOnlyTheWantedEntriesAndTheWantedRoom) {
  const DeviceMemory device(canceller_layout.tables(), 9);
  EXPECT_EQ(access_at(device, 0x6001, 6), "nothing");
  EXPECT_EQ(device.dictionary.number(0x6112, 0), 2U);
  EXPECT_EQ(access_at(device, 0x6112, 3), "nothing");
  EXPECT_EQ(device.dictionary.find(0x6112, 2)->row->capacity, 40);
  EXPECT_EQ(device.dictionary.find(0x611C, 0)->row->capacity, 12);
  EXPECT_EQ(device.dictionary.find(0x6120, 0)->row->capacity, 64);
}

TEST(VirtualDevice, BeginsWithTheDefaultsOfTheProfile) {
  const DeviceMemory device(canceller_layout.tables(), 9);
  EXPECT_EQ(device.dictionary.number(0x1000, 0), 0x0400'0197U);
  EXPECT_EQ(device.dictionary.number(0x6108, 0), 1U);
  EXPECT_EQ(device.dictionary.number(0x610E, 1), 0xFFU);
}

constexpr DeviceDescription<96> make_multiple() {
  DeviceDescription<96> parts =
      virtual_device(cia407::profile, cia407::time_fixing);  // consumes 6660h
  add_virtual_device(parts, cia407::profile, cia407::geographical_positioning);
  return parts;
}
constexpr auto receiver =
    describe(make_multiple(), cia301::device_type(cia407::multiple_device_type),
             cia407::error_register_object, cia301::identity({.vendor_id = 1}),
             Part(cia407::supported_virtual_device_types_object).up_to(2));
constexpr auto receiver_layout = lay_out_device<receiver>();

TEST(VirtualDevice, OfSeveralTheOneThatProvidesAnObjectCounts) {
  const DeviceMemory device(receiver_layout.tables(), 9);
  EXPECT_EQ(access_at(device, 0x6660, 1), "ro T");
  EXPECT_EQ(access_at(device, 0x6664, 0), "ro T");
  EXPECT_EQ(access_at(device, 0x6680, 3), "ro T");
  EXPECT_EQ(device.dictionary.number(0x6680, 4), 1U) << "no default, and no day 0";
}

constexpr auto collector =
    describe(virtual_device(cia407::profile, cia407::diagnostics, {{0x6740, 10}, {0x6742, 3}}),
             cia301::device_type(cia407::device_type(cia407::diagnostics)),
             cia407::error_register_object, cia301::identity({.vendor_id = 1}));
constexpr auto collector_layout = lay_out_device<collector>();
constexpr auto reporter =
    describe(virtual_device(cia407::profile, cia407::ticket_printer,
                            {{0x6112, 1}, {0x6740, 10}, {0x6742, 3}}),
             cia301::device_type(cia407::device_type(cia407::ticket_printer)),
             cia407::error_register_object, cia301::identity({.vendor_id = 1}));
constexpr auto reporter_layout = lay_out_device<reporter>();

TEST(VirtualDevice, DiagnosticsTakesReportsAtSubIndex01) {  // CiA 407, errata 86, 87, 89, 90
  const DeviceMemory device(collector_layout.tables(), 9);
  EXPECT_EQ(access_at(device, 0x6740, 0), "rw TR");
  EXPECT_EQ(access_at(device, 0x6740, 1), "rw");
  EXPECT_EQ(access_at(device, 0x6740, 2), "ro");
  EXPECT_EQ(access_at(device, 0x6742, 0), "rw");
  EXPECT_EQ(access_at(device, 0x6742, 1), "rw");
  EXPECT_EQ(access_at(device, 0x6742, 3), "ro");
  const DeviceMemory printer(reporter_layout.tables(), 9);
  EXPECT_EQ(access_at(printer, 0x6740, 1), "wo");
  EXPECT_EQ(access_at(printer, 0x6742, 2), "wo");
}

/// All virtual devices can be laid out with their mandatory objects.
template <std::size_t... which>
consteval unsigned lay_out_all(std::index_sequence<which...>) {
  return (0 + ... +
          static_cast<unsigned>(
              virtual_device(cia407::profile, cia407::virtual_devices[which]).size()));
}
TEST(VirtualDevice, EachOfAProfileCanBeMade) {
  constexpr unsigned objects =
      lay_out_all(std::make_index_sequence<std::size(cia407::virtual_devices)>());
  unsigned mandatory = 0;
  for (const VirtualDeviceInfo& device : cia407::profile.virtual_devices) {
    for (const DeviceObject& object : device.objects) {
      if (object.category == Category::mandatory) ++mandatory;
    }
  }
  EXPECT_EQ(objects, mandatory);
}

}  // namespace
}  // namespace canvoy::virtual_device_test
