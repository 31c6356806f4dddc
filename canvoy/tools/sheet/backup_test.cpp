// Backups of devices are restored: `canvoy eds read` reads each device that the project builds,
// `canvoy configure` writes the result into it, and nothing is refused or changed.
#include <gtest/gtest.h>

#include "canvoy/devices/testing/foreign_client.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_configuration.hpp"
#include "canvoy/formats/sheet/sheet_scan.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools::backup_test {
namespace {

using Bytes = ForeignClient::Bytes;
using formats::Configuration;
using formats::ConfigurationEntry;

formats::DataSheet read_of(ForeignClient& desk) {
  formats::SheetScan scan(
      [&](std::uint16_t index, std::uint8_t sub) { return desk.read(index, sub); });
  const Result<Bytes> type = desk.read(0x1000, 0);
  EXPECT_TRUE(type);
  const Profile* profile =
      find_profile(type ? static_cast<std::uint32_t>(load_unsigned(*type)) : 0);
  EXPECT_NE(profile, nullptr);
  formats::DataSheet sheet = scan.read_profile(profile == nullptr ? base_profile() : *profile,
                                               {.node_id = desk.id(), .node_name = "any"});
  EXPECT_GT(scan.count(), 20U);
  return sheet;
}

Configuration configuration_of(ForeignClient& desk) {
  return formats::configuration_of(read_of(desk), desk.id());
}

/// Reads a backup like the two commands, with the file between them.
Configuration backup_of(ForeignClient& desk) {
  formats::Findings findings;
  const formats::DataSheet stored = formats::read_eds(formats::write_eds(read_of(desk)), findings);
  return formats::configuration_of(stored, desk.id());
}

std::string place_of(const ConfigurationEntry& entry) {
  char text[32];
  std::snprintf(text, sizeof text, "%04Xh:%02Xh", static_cast<unsigned>(entry.index),
                static_cast<unsigned>(entry.sub));
  return text;
}

/// Dependencies within PDOs are covered by tests of PDOs.
bool is_pdo(std::uint16_t index) {
  return index >= 0x1400 && index <= 0x1BFF;
}

class Backup : public testing::TestWithParam<const DeviceKind*> {};

/// A sealed taximeter keeps its channels except for service (MID, annex IX).
AbortCode wanted(std::uint16_t index) {
  const bool is_sealed =
      test_name(*Backup::GetParam()) == "taximeter" && index >= 0x1200 && index < 0x1800;
  return is_sealed ? AbortCode::device_state : AbortCode::none;
}

void write_all(ForeignClient& desk, const Configuration& backup, const char* state) {
  for (const ConfigurationEntry& entry : backup.entries) {
    const AbortCode answer = desk.write(entry.index, entry.sub, entry.value);
    EXPECT_EQ(answer, wanted(entry.index)) << place_of(entry) << " " << std::hex
                                           << static_cast<std::uint32_t>(answer) << ", " << state;
  }
}

TEST_P(Backup, GoesBackIntoTheDeviceThatItIsOf) {
  ForeignClient desk(*GetParam());
  const Configuration backup = backup_of(desk);
  EXPECT_TRUE(backup.bad.empty());
  EXPECT_GT(backup.entries.size(), 5U);
  for (const char* const state : {"pre-operational", "operational"}) {
    write_all(desk, backup, state);
    EXPECT_EQ(configuration_of(desk).entries, backup.entries) << "nothing has changed, " << state;
    desk.start();
  }
}

/// Changes all values that can be changed, each by one or to its half.
TEST_P(Backup, OfAChangedDeviceGoesIntoANewOne) {
  ForeignClient changed(*GetParam());
  std::size_t changes = 0;
  for (const ConfigurationEntry& entry : configuration_of(changed).entries) {
    if (entry.value.empty() || is_pdo(entry.index)) continue;
    Bytes more = entry.value;
    ++more[0];
    Bytes half = entry.value;
    half[0] /= 2;
    const bool is_done = changed.write(entry.index, entry.sub, more) == AbortCode::none ||
                         changed.write(entry.index, entry.sub, half) == AbortCode::none;
    changes += is_done ? 1U : 0U;
  }
  EXPECT_GT(changes, 3U);
  const Configuration backup = backup_of(changed);
  ForeignClient other(*GetParam());
  write_all(other, backup, "pre-operational");
  EXPECT_EQ(configuration_of(other).entries, backup.entries);
}

INSTANTIATE_TEST_SUITE_P(OfEvery, Backup, testing::ValuesIn(every_device_kind()),
                         [](const auto& each) { return test_name(*each.param); });

}  // namespace
}  // namespace canvoy::tools::backup_test
