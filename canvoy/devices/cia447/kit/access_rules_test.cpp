// Write access of clients to all 20 virtual devices at their wires (CiA 447-3, 4.2), by the printed
// function of an object. Commands, requests and similar objects are rw; a status is ro for the
// device that provides it (0601 0002h), and rw for one that consumes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447::access_rules_test {
namespace {

/// By the printed names; 6096h to 609Eh are texts, which other devices write.
bool is_asked_for(const ObjectInfo& object) {
  constexpr std::string_view words[] = {"command",
                                        "request",
                                        "Set RTC",
                                        "Start route guidance",
                                        "Printer transport",
                                        "Display 1 text",
                                        "Display 1 title",
                                        "Display 2 text",
                                        "Tariff display configuration"};
  return std::ranges::any_of(
      words, [&](std::string_view word) { return object.name.find(word) != object.name.npos; });
}

std::vector<const DeviceKind*> kinds_of_cars() {
  std::vector<const DeviceKind*> kinds;
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->car_unit != nullptr) kinds.push_back(kind);
  }
  return kinds;
}

class EveryVirtualDevice : public testing::TestWithParam<const DeviceKind*> {
 protected:
  /// The abort code of a write of all ones, of as many bytes as the entry has; 0: it was taken.
  std::uint32_t write(const ObjectInfo& object, const EntryInfo& entry) {
    const unsigned bytes = std::clamp(bit_length(entry.type) / 8, 1U, 4U);
    static constexpr unsigned specifiers[] = {0, 0x2F, 0x2B, 0x27, 0x23};
    const unsigned index = object.index;
    std::string request =
        text(specifiers[bytes]) + text(index) + text(index >> 8) + text(entry.sub_first);
    for (unsigned i = 0; i < 4; ++i) request += text(i < bytes ? 0xFF : 0);
    const std::string answer = bench.ask(request);
    std::uint32_t code = 0;
    for (unsigned i = 0; answer.starts_with("80") && i < 4; ++i) {
      code |= static_cast<std::uint32_t>(std::stoul(answer.substr(12 + 3 * i, 2), nullptr, 16))
              << 8 * i;
    }
    return code;
  }
  static std::string text(unsigned byte) {
    char buffer[4];
    std::snprintf(buffer, sizeof buffer, "%02X ", byte & 0xFFU);
    return buffer;
  }
  /// Entries with a type that has up to four bytes.
  static bool is_short(const EntryInfo& entry) {
    return !is_string(entry.type) && bit_length(entry.type) <= 32;
  }

  const CarUnit* unit = GetParam()->car_unit;
  CarBench bench{std::span(&unit, 1)};
};

TEST_P(EveryVirtualDevice, HasStatusesThatNobodyWrites) {
  constexpr std::uint32_t read_only = 0x0601'0002;
  for (const DeviceObject& provided : unit->provides->objects) {
    const ObjectInfo* object = find_object(profile, provided.index);
    ASSERT_NE(object, nullptr);
    if (is_asked_for(*object)) continue;
    for (const EntryInfo& entry : object->entries()) {
      EXPECT_EQ(write(*object, entry), read_only)
          << object->name << ", sub-index " << unsigned{entry.sub_first};
    }
  }
}

TEST_P(EveryVirtualDevice, HasCommandsThatMayBeWrittenAsDoNotCare) {
  for (const DeviceObject& provided : unit->provides->objects) {
    const ObjectInfo* object = find_object(profile, provided.index);
    if (!is_asked_for(*object)) continue;
    for (const EntryInfo& entry : object->entries()) {
      const bool is_count = entry.sub_first == 0 && object->entries().size() > 1;
      if (is_count || !is_short(entry)) continue;
      EXPECT_EQ(write(*object, entry), 0U)
          << object->name << ", sub-index " << unsigned{entry.sub_first};
    }
  }
}

/// Consumed objects of devices that count and record are written only by their provider; the client
/// on the default channel is not known (0800 0021h).
TEST_P(EveryVirtualDevice, TakesWhatItConsumesUnlessItCountsByIt) {
  const bool counts = unit == find_device_kind("taximeter")->car_unit ||
                      unit == find_device_kind("driver-identification")->car_unit;
  const std::uint32_t expected = counts ? 0x0800'0021 : 0;
  for (const ObjectInfo* object : unit->consumes) {
    for (const EntryInfo& entry : object->entries()) {
      const bool is_count = entry.sub_first == 0 && object->entries().size() > 1;
      if (is_count || !is_short(entry)) continue;
      EXPECT_EQ(write(*object, entry), expected)
          << object->name << ", sub-index " << unsigned{entry.sub_first};
    }
  }
}

std::string unit_name(const testing::TestParamInfo<const DeviceKind*>& tested) {
  std::string name(tested.param->info.name);
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Of, EveryVirtualDevice, testing::ValuesIn(kinds_of_cars()), unit_name);

TEST(EveryVirtualDeviceThereIs, IsTried) {
  EXPECT_EQ(kinds_of_cars().size(), 20u);
}

}  // namespace
}  // namespace canvoy::cia447::access_rules_test
