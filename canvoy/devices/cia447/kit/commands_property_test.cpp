// Every field of every command object (CiA 447-3, 4.2): reserved codes are refused (0609 0030h) and
// change nothing, at once or later; all others are accepted; "don't care" changes nothing. The test
// derives the reserved codes from the description independently; a sample was read from the tables
// by hand.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/devices/cia447/radio/radio_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"

namespace canvoy::cia447::commands_property_test {
namespace {

constexpr const CarUnit* commanded_units[] = {
    &car_unit<IvnGatewayKind>,  &car_unit<PowerSupplyKind>,  &car_unit<RadioKind>,
    &car_unit<AudioSwitchKind>, &car_unit<RoofBarLightKind>, &car_unit<RoofBarSoundKind>,
    &car_unit<BlueLightKind>,   &car_unit<HandsFreeKind>};

/// An entry that takes commands, on a bench of its own.
struct CommandCase {
  const CarUnit* unit;
  const ObjectInfo* object;
  const EntryInfo* entry;
};

std::vector<CommandCase> all_commands() {
  std::vector<CommandCase> cases;
  for (const CarUnit* unit : commanded_units) {
    for (const DeviceObject& provided : unit->provides->objects) {
      const ObjectInfo* object = find_object(profile, provided.index);
      for (const EntryInfo& entry : object->entries()) {
        if (entry.access == Access::rw) cases.push_back({unit, object, &entry});
      }
    }
  }
  return cases;
}

struct FieldOfCase {
  unsigned first_bit;
  unsigned bits;
  const ValueInfo* value;
};
std::vector<FieldOfCase> fields_of(const EntryInfo& entry) {
  std::vector<FieldOfCase> fields;
  if (entry.fields.empty()) fields.push_back({0, bit_length(entry.type), &entry.value});
  for (const FieldInfo& field : entry.fields) {
    fields.push_back({field.first_bit, field.bits, &field.value});
  }
  return fields;
}

enum class Kind { allowed, reserved, left_alone };
Kind kind_of(const ValueInfo& value, std::int64_t code) {
  for (const NamedValue& named : value.names) {
    if (named.meaning == Meaning::padding) return Kind::left_alone;
  }
  for (const NamedValue& named : value.names) {
    if (code < named.first || code > named.last) continue;
    if (named.meaning == Meaning::do_not_care) return Kind::left_alone;
    const bool is_free = named.meaning == Meaning::state || named.meaning == Meaning::manufacturer;
    return is_free ? Kind::allowed : Kind::reserved;
  }
  const Limits& limits = value.limits;
  return code >= limits.low && code <= limits.high ? Kind::allowed : Kind::reserved;
}

class EveryCommand : public testing::TestWithParam<CommandCase> {
 protected:
  EveryCommand() { bench.cable.run_for(10s); }  // whatever begins by itself is over

  std::string write(std::uint64_t value) {
    const unsigned bytes = bit_length(GetParam().entry->type) / 8;
    static constexpr unsigned specifiers[] = {0, 0x2F, 0x2B, 0x27, 0x23};
    return bench.ask(text(specifiers[bytes]) + place() + text(value & 0xFF) +
                     text(value >> 8 & 0xFF) + text(value >> 16 & 0xFF) + text(value >> 24 & 0xFF));
  }
  std::string answer(unsigned specifier, const std::string& data) {
    const std::string whole = text(specifier) + place() + data;
    return whole.substr(0, whole.size() - 1);
  }
  /// One field has this code, all other bits are 1.
  std::uint64_t value_with(const FieldOfCase& field, std::uint64_t code) {
    const std::uint64_t mask = ((1ULL << field.bits) - 1) << field.first_bit;
    return (all_ones_of_entry() & ~mask) | code << field.first_bit;
  }
  std::uint64_t all_ones_of_entry() { return (1ULL << bit_length(GetParam().entry->type)) - 1; }
  std::uint64_t command_value() {
    return bench.node().dictionary().number(GetParam().object->index, GetParam().entry->sub_first);
  }
  /// All statuses of the device, without the commands.
  std::string statuses() {
    std::string all;
    for (const DeviceObject& provided : GetParam().unit->provides->objects) {
      const ObjectInfo* object = find_object(profile, provided.index);
      for (const EntryInfo& entry : object->entries()) {
        if (entry.access == Access::rw || is_string(entry.type)) continue;
        all += text(bench.node().dictionary().number(object->index, entry.sub_first));
      }
    }
    return all;
  }

  CarBench bench{std::span(&GetParam().unit, 1)};

 private:
  static std::string text(std::uint64_t number) {
    char buffer[24];
    std::snprintf(buffer, sizeof buffer, "%02X ", static_cast<unsigned>(number));
    return buffer;
  }
  std::string place() {
    const std::uint16_t index = GetParam().object->index;
    return text(index & 0xFF) + text(index >> 8) + text(GetParam().entry->sub_first);
  }
};

TEST_P(EveryCommand, ReservedCodesAreRefusedAndChangeNothing) {
  const std::string before = statuses();
  for (const FieldOfCase& field : fields_of(*GetParam().entry)) {
    for (std::uint64_t code = 0; code < 1ULL << field.bits; ++code) {
      if (kind_of(*field.value, static_cast<std::int64_t>(code)) != Kind::reserved) continue;
      ASSERT_EQ(write(value_with(field, code)), answer(0x80, "30 00 09 06 "))
          << field.first_bit << ": " << code;
      ASSERT_EQ(command_value(), all_ones_of_entry());
    }
  }
  bench.cable.run_for(20s);
  EXPECT_EQ(statuses(), before);
}

TEST_P(EveryCommand, DoNotCareChangesNothing) {
  const std::string before = statuses();
  EXPECT_EQ(write(all_ones_of_entry()), answer(0x60, "00 00 00 00 "));
  EXPECT_EQ(statuses(), before);
  bench.cable.run_for(20s);
  EXPECT_EQ(statuses(), before);
}

TEST_P(EveryCommand, AllOtherCodesAreTakenAndReadBack) {
  for (const FieldOfCase& field : fields_of(*GetParam().entry)) {
    for (std::uint64_t code = 0; code < 1ULL << field.bits; ++code) {
      if (kind_of(*field.value, static_cast<std::int64_t>(code)) == Kind::reserved) continue;
      const std::uint64_t value = value_with(field, code);
      ASSERT_EQ(write(value), answer(0x60, "00 00 00 00 ")) << field.first_bit << ": " << code;
      ASSERT_EQ(command_value(), value);
    }
  }
}

std::string case_name(const testing::TestParamInfo<CommandCase>& tested) {
  char name[16];
  std::snprintf(name, sizeof name, "%04X_%02X", tested.param.object->index,
                tested.param.entry->sub_first);
  return name;
}
INSTANTIATE_TEST_SUITE_P(Of, EveryCommand, testing::ValuesIn(all_commands()), case_name);

TEST(EveryCommandThereIs, IsTried) {
  // 16 of the gateway (one of them with two seats), 2, 1, 2, 5 sub-indices, 3 entries, 1, 1.
  EXPECT_EQ(all_commands().size(), 32u);
}

/// Read from the tables of the specification, by hand.
TEST(ReservedCodes, OfASampleAreRefused) {
  struct Sample {
    const CarUnit* unit;
    const char* request;
    const char* why;
  };
  const Sample samples[] = {
      {&car_unit<IvnGatewayKind>, "2F 06 60 00 65 00 00 00", "Table 4: above 64h"},
      {&car_unit<IvnGatewayKind>, "2F 06 60 00 FD 00 00 00", "Table 4"},
      {&car_unit<IvnGatewayKind>, "2F 0A 60 00 FD 00 00 00", "Table 13: 04h to 0Dh"},
      {&car_unit<IvnGatewayKind>, "2F 0A 60 00 FE 00 00 00", "Table 13: 0Eh"},
      {&car_unit<IvnGatewayKind>, "2B 0C 60 00 FE FF 00 00", "Table 19: wd 02h"},
      {&car_unit<IvnGatewayKind>, "2B 11 60 00 EF FF 00 00", "Table 31: bl 02h"},
      {&car_unit<IvnGatewayKind>, "2B 11 60 00 FF FB 00 00", "Table 31: blw 02h (errata C8)"},
      {&car_unit<IvnGatewayKind>, "27 18 60 02 FF EF FF 00", "Table 34: rm 06h"},
      {&car_unit<IvnGatewayKind>, "2B 1B 60 00 FF FD 00 00", "Table 43: wwr 02h (errata A11)"},
      {&car_unit<IvnGatewayKind>, "2B 25 60 00 BF FF 00 00", "Table 58: dfw 02h"},
      {&car_unit<IvnGatewayKind>, "2F 2C 60 00 FE 00 00 00", "Table 72: 1Eh"},
      {&car_unit<IvnGatewayKind>, "23 44 60 00 FF FF FF BF", "Table 93: pll 02h (errata B1)"},
      {&car_unit<IvnGatewayKind>, "2B 46 60 00 FB FF 00 00", "Table 99: ii 03h"},
      {&car_unit<IvnGatewayKind>, "2F 48 60 00 FC 00 00 00", "Table 105: 04h"},
      {&car_unit<IvnGatewayKind>, "2F 4B 60 00 FE 00 00 00", "Table 114"},
      {&car_unit<IvnGatewayKind>, "23 4C 60 00 FF FF FE FF", "Table 117: dtrln 02h"},
      {&car_unit<IvnGatewayKind>, "2B 60 60 00 CF FF 00 00", "store 04h"},
      {&car_unit<IvnGatewayKind>, "2F 62 60 00 FE 00 00 00", "four-wheel drive 02h"},
      {&car_unit<PowerSupplyKind>, "2F 71 60 00 FE 00 00 00", "Table 180"},
      {&car_unit<AudioSwitchKind>, "27 20 61 00 01 01 FE 00", "Table 453: gain FEh"},
      {&car_unit<AudioSwitchKind>, "2B 21 61 00 FE 01 00 00", "Table 456"},
      {&car_unit<RoofBarSoundKind>, "2F 38 61 00 17 00 00 00", "Table 476: after USA"},
      {&car_unit<RoofBarSoundKind>, "23 3A 61 01 FF FE FF FF", "Table 482: swds 02h"},
  };
  for (const Sample& sample : samples) {
    CarBench bench(std::span(&sample.unit, 1));
    const std::string request = sample.request;
    EXPECT_EQ(bench.ask(request), "80" + request.substr(2, 9) + " 30 00 09 06") << sample.why;
  }
}

/// Codes that look as if they were reserved.
TEST(ReservedCodes, AreNotThese) {
  struct Sample {
    const CarUnit* unit;
    const char* request;
    const char* why;
  };
  const Sample samples[] = {
      {&car_unit<IvnGatewayKind>, "2B 11 60 00 BF FF 00 00", "stop of the top (errata A8)"},
      {&car_unit<IvnGatewayKind>, "2B 11 60 00 FF FE 00 00", "stop of the back door (errata A8)"},
      {&car_unit<IvnGatewayKind>, "2B 25 60 00 FF FE 00 00", "-0,5 degrees (errata A8)"},
      {&car_unit<IvnGatewayKind>, "2F 0A 60 00 03 00 00 00", "r is not all ones"},
      {&car_unit<RoofBarLightKind>, "23 30 61 03 FF FF FF BF", "position 3 (errata Z35)"},
      {&car_unit<RoofBarLightKind>, "23 30 61 03 FF FF FF FB", "swing left (errata Z35)"},
  };
  for (const Sample& sample : samples) {
    CarBench bench(std::span(&sample.unit, 1));
    const std::string request = sample.request;
    EXPECT_EQ(bench.ask(request), "60" + request.substr(2, 9) + " 00 00 00 00") << sample.why;
  }
}

}  // namespace
}  // namespace canvoy::cia447::commands_property_test
