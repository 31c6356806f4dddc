// The events of 6001h and 6002h, by the tables of 9.2.4 and 9.2.5. The meaning of a flag depends on
// the virtual device.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::events_test {
namespace {

/// True if a field holds in an entry of this virtual device.
bool holds(const FieldInfo& field, unsigned code) {
  bool fits = field.when.empty();
  for (const FieldCondition& condition : field.when) {
    EXPECT_EQ(condition.field, "code of virtual device");
    fits = fits || (code >= condition.first && code <= condition.last);
  }
  return fits;
}
/// The name of the field that has the bit.
std::string_view name_of_bit(const EntryInfo& entry, unsigned bit, unsigned code) {
  std::string_view name = "none";
  unsigned fields = 0;
  for (const FieldInfo& field : entry.fields) {
    const bool covers = bit >= field.first_bit && bit < field.first_bit + unsigned{field.bits};
    if (!covers || !holds(field, code)) continue;
    name = field.name;
    ++fields;
  }
  EXPECT_EQ(fields, 1U) << "bit " << bit << " of code " << code;
  return name;
}

struct Table {
  unsigned index;
  unsigned code;
  const char* flags[8];
};
constexpr const char* r = "reserved";
constexpr const char* send_state = "send state information";
constexpr Table tables[] = {
    // Passenger information
    {0x6001,
     0x03,
     {"state information", "display in test mode", "mapped information cannot be displayed", r, r,
      r, r, r}},
    // Acoustic control manager
    {0x6001,
     0x08,
     {r, "driver microphone to indoor loudspeakers", "driver microphone to outdoor loudspeakers",
      "driver microphone to VRCC", "travel attendant microphone to indoor loudspeakers",
      "VRCC to indoor loudspeakers", "state information of the acoustic control manager", r}},
    // Ticket canceller
    {0x6001, 0x04, {"state information", r, r, r, r, r, r, r}},
    // Passenger counting
    {0x6001, 0x14, {"more than 200 incoming or outgoing passengers", r, r, r, r, r, r, r}},
    // Passenger counting manager
    {0x6001,
     0x15,
     {"close to passenger capacity limit", "passenger capacity warning limit", r, r, r, r, r, r}},
    // Diagnostic (errata 3)
    {0x6001,
     0x16,
     {"more than 200 entries in object 6740h", "object 6740h close to capacity limit",
      "more than 200 entries in object 6742h", "more than 200 entries in object 6743h",
      "more than 200 entries in object 6744h", r, r, r}},
    // Tachograph
    {0x6002,
     0x0C,
     {"reset tachograph trip distance", "adjust local hour offset", "adjust local minute offset", r,
      r, r, r, r}},
    // Passenger information
    {0x6002, 0x03, {send_state, "enter testmode", r, r, r, r, r, r}},
    // Acoustic announcement
    {0x6002, 0x07, {send_state, r, r, r, r, r, r, r}},
    // Ticket canceller
    {0x6002, 0x04, {send_state, r, r, r, r, r, r, r}},
    // Acoustic control manager: as in 6001h (errata 19, 20)
    {0x6002,
     0x08,
     {r, "driver microphone to indoor loudspeakers", "driver microphone to outdoor loudspeakers",
      "driver microphone to VRCC", "travel attendant microphone to indoor loudspeakers",
      "VRCC to indoor loudspeakers", "state information of the acoustic control manager", r}},
};

const EntryInfo& entry_of(unsigned index, unsigned device) {
  const unsigned sub = index == 0x6001 ? device + 1 : device;  // errata 83
  return *find_entry(*find_object(cia407::profile, index), sub);
}

TEST(Cia407Events, FlagsAreThoseOfTheVirtualDevicesTable) {
  for (const Table& table : tables) {
    for (const unsigned device : {1U, 17U, 32U}) {
      const EntryInfo& entry = entry_of(table.index, device);
      for (unsigned bit = 0; bit < 8; ++bit) {
        EXPECT_EQ(name_of_bit(entry, bit, table.code), table.flags[bit])
            << std::hex << table.index << ' ' << table.code << ' ' << bit;
      }
    }
  }
}

TEST(Cia407Events, FlagsOfOtherVirtualDevicesAreNotDefined) {
  for (const unsigned index : {0x6001U, 0x6002U}) {
    for (unsigned code = 0; code <= 0xFF; ++code) {
      bool has_table = false;
      for (const Table& table : tables) {
        has_table = has_table || (table.index == index && table.code == code);
      }
      for (unsigned bit = 0; bit < 32; ++bit) {
        const std::string_view name = name_of_bit(entry_of(index, 1), bit, code);
        if (bit < 8) {
          EXPECT_EQ(name == "event flags", !has_table) << code << ' ' << bit;
        } else {
          EXPECT_EQ(name,
                    bit < 24 ? "manufacturer-specific information" : "code of virtual device");
        }
      }
    }
  }
}

TEST(Cia407Events, ReservedFlagsMustNotBePending) {
  for (const FieldInfo& field : entry_of(0x6001, 1).fields) {
    const NamedValue* pending = find_name(field.value, 1, field.bits, false);
    if (field.name == "reserved") {
      EXPECT_EQ(pending->meaning, Meaning::reserved);
    } else if (field.bits == 1) {
      EXPECT_EQ(pending->name, "event pending");
      EXPECT_EQ(find_name(field.value, 0, 1, false)->name, "event not present");
    }
  }
}

TEST(Cia407Events, Code00IsNoVirtualDeviceInAnEvent) {
  const FieldInfo& code = entry_of(0x6002, 1).fields[entry_of(0x6002, 1).fields.size() - 1];
  EXPECT_EQ(find_name(code.value, 0x00, 8, false)->name, "none");
  EXPECT_EQ(find_name(code.value, 0x16, 8, false)->name, "Diagnostics device");
  EXPECT_EQ(find_name(code.value, 0x19, 8, false)->meaning, Meaning::reserved);
}

TEST(Cia407Events, BitBOfEventAtSubTellsOfSubIndexBPlus2) {  // errata 81
  const EntryInfo& entry = *find_entry(*find_object(cia407::profile, 0x6001), 1);
  ASSERT_EQ(entry.fields.size(), 32U);
  for (unsigned bit = 0; bit < 32; ++bit) {
    EXPECT_EQ(entry.fields[bit].first_bit, bit);
    EXPECT_EQ(entry.fields[bit].name, "sub #");
    EXPECT_EQ(entry.fields[bit].number, bit + 2);
    EXPECT_EQ(find_name(entry.fields[bit].value, 1, 1, false)->name, "at least one event");
  }
}

TEST(Cia407Events, EntriesAreNamedByTheirOrdinals) {
  constexpr struct {
    unsigned device;
    const char* name;
    unsigned number;
  } names[] = {
      {1, "events_from_1st_virtual_device", 1},    {2, "events_from_2nd_virtual_device", 2},
      {3, "events_from_3rd_virtual_device", 3},    {4, "events_from_#th_virtual_device", 4},
      {20, "events_from_#th_virtual_device", 20},  {21, "events_from_21st_virtual_device", 21},
      {22, "events_from_22nd_virtual_device", 22}, {23, "events_from_23rd_virtual_device", 23},
      {24, "events_from_#th_virtual_device", 24},  {30, "events_from_#th_virtual_device", 30},
      {31, "events_from_31st_virtual_device", 31}, {32, "events_from_32nd_virtual_device", 32}};
  for (const auto& [device, name, number] : names) {
    const EntryInfo& entry = entry_of(0x6001, device);
    EXPECT_EQ(entry.name, name);
    EXPECT_EQ(entry.first_number + (device + 1 - entry.sub_first), number);
  }
}

}  // namespace
}  // namespace canvoy::events_test
