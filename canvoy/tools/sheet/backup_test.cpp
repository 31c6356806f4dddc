// A device's backup goes back into it: what `canvoy eds read` reads of each device that the project
// builds, `canvoy configure` writes into it, and nothing is refused or changed by that.
#include <gtest/gtest.h>

#include <cstdio>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/testing/every_device.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_configuration.hpp"
#include "canvoy/formats/sheet/sheet_scan.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools::backup_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using formats::Configuration;
using formats::ConfigurationEntry;

/// An SDO client with a device at the other end of the cable.
class Desk {
 public:
  explicit Desk(const DeviceKind& kind) : device_(cable_.port(0), kind) {
    cable_.connect(0, device_.node());
    cable_.start_all();
    cable_.run_for(1s);
  }
  void start() {
    cable_.send("000#01 00");
    cable_.run_for(1s);
  }
  NodeId id() { return device_.node().id(); }

  Result<Bytes> read(std::uint16_t index, std::uint8_t sub) {
    Frame answer = ask({0x40, low(index), high(index), sub});
    if (answer.data[0] == aborted) return abort_of(answer);
    const unsigned command = answer.data[0];
    if ((command & 2) != 0) {
      const unsigned unused = (command & 1) != 0 ? command >> 2 & 3 : 0;
      return Bytes(answer.data.begin() + 4, answer.data.begin() + 8 - unused);
    }
    Bytes value;
    for (std::uint8_t toggle = 0;; toggle ^= 0x10) {
      answer = ask({static_cast<std::uint8_t>(0x60 | toggle)});
      if (answer.data[0] == aborted) return abort_of(answer);
      const unsigned unused = answer.data[0] >> 1 & 7U;
      value.insert(value.end(), answer.data.begin() + 1, answer.data.begin() + 8 - unused);
      if ((answer.data[0] & 1) != 0) return value;
    }
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, const Bytes& value) {
    const bool is_short = value.size() >= 1 && value.size() <= 4;
    std::array<std::uint8_t, 8> request{0x21, low(index), high(index), sub};
    request[4] = static_cast<std::uint8_t>(value.size());
    if (is_short) {
      request[0] = static_cast<std::uint8_t>(0x23 | (4 - value.size()) << 2);
      std::ranges::copy(value, request.begin() + 4);
    }
    Frame answer = ask(request);
    if (answer.data[0] == aborted) return abort_of(answer);
    if (is_short) return AbortCode::none;
    std::uint8_t toggle = 0;
    std::size_t sent = 0;
    do {
      const std::size_t now = std::min<std::size_t>(value.size() - sent, 7);
      const bool is_last = sent + now == value.size();
      std::array<std::uint8_t, 8> segment{
          static_cast<std::uint8_t>(toggle | (7 - now) << 1 | (is_last ? 1U : 0U))};
      std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(sent), now, segment.begin() + 1);
      answer = ask(segment);
      if (answer.data[0] == aborted) return abort_of(answer);
      sent += now;
      toggle ^= 0x10;
    } while (sent < value.size());
    return AbortCode::none;
  }

 private:
  static constexpr std::uint8_t aborted = 0x80;
  static std::uint8_t low(std::uint16_t index) { return static_cast<std::uint8_t>(index); }
  static std::uint8_t high(std::uint16_t index) { return static_cast<std::uint8_t>(index >> 8); }
  static AbortCode abort_of(const Frame& answer) {
    return AbortCode{load<std::uint32_t>(answer.data.data() + 4)};
  }

  Frame ask(std::array<std::uint8_t, 8> request) {
    char text[48];
    int length = std::snprintf(text, sizeof text, "%03X#", 0x600U + id());
    for (const std::uint8_t byte : request) {
      length += std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length),
                              "%02X ", byte);
    }
    text[length - 1] = '\0';
    cable_.clear();
    cable_.send(text);
    for (int i = 0; i < 100 && cable_.count(0x580U + id()) == 0; ++i) cable_.run_for(1ms);
    const std::string answer = cable_.last(0x580U + id());
    EXPECT_NE(answer, "") << text;
    return answer.empty() ? wire_frame("580#80 00 00 00 00 00 00 00") : wire_frame(answer);
  }

  Cable cable_;
  DeviceOfKind device_;
};

/// As the two commands have it, with the file between them.
Configuration backup_of(Desk& desk) {
  formats::SheetScan scan(
      [&](std::uint16_t index, std::uint8_t sub) { return desk.read(index, sub); });
  const Result<Bytes> type = desk.read(0x1000, 0);
  EXPECT_TRUE(type);
  const Profile* profile =
      find_profile(type ? static_cast<std::uint32_t>(load_unsigned(*type)) : 0);
  EXPECT_NE(profile, nullptr);
  const formats::DataSheet sheet = scan.read_profile(profile == nullptr ? base_profile() : *profile,
                                                     {.node_id = desk.id(), .node_name = "any"});
  EXPECT_GT(scan.count(), 20U);
  formats::Findings findings;
  const formats::DataSheet stored = formats::read_eds(formats::write_eds(sheet), findings);
  return formats::configuration_of(stored, desk.id());
}

std::string place_of(const ConfigurationEntry& entry) {
  char text[32];
  std::snprintf(text, sizeof text, "%04Xh:%02Xh", static_cast<unsigned>(entry.index),
                static_cast<unsigned>(entry.sub));
  return text;
}

/// What of PDOs depends on each other, tests of PDOs try.
bool is_pdo(std::uint16_t index) {
  return index >= 0x1400 && index <= 0x1BFF;
}

void write_all(Desk& desk, const Configuration& backup, const char* state) {
  for (const ConfigurationEntry& entry : backup.entries) {
    const AbortCode answer = desk.write(entry.index, entry.sub, entry.value);
    EXPECT_EQ(answer, AbortCode::none) << place_of(entry) << " " << std::hex
                                       << static_cast<std::uint32_t>(answer) << ", " << state;
  }
}

class Backup : public testing::TestWithParam<const DeviceKind*> {};

TEST_P(Backup, GoesBackIntoTheDeviceThatItIsOf) {
  for (const bool is_operational : {false, true}) {
    Desk desk(*GetParam());
    if (is_operational) desk.start();
    const Configuration backup = backup_of(desk);
    EXPECT_TRUE(backup.bad.empty());
    EXPECT_GT(backup.entries.size(), 5U);
    write_all(desk, backup, is_operational ? "operational" : "pre-operational");
    EXPECT_EQ(backup_of(desk).entries, backup.entries) << "nothing has changed";
  }
}

/// As much of it as it lets be changed, each value by one or to its half.
TEST_P(Backup, OfAChangedDeviceGoesIntoANewOne) {
  Desk changed(*GetParam());
  std::size_t changes = 0;
  for (const ConfigurationEntry& entry : backup_of(changed).entries) {
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
  Desk other(*GetParam());
  write_all(other, backup, "pre-operational");
  EXPECT_EQ(backup_of(other).entries, backup.entries);
}

INSTANTIATE_TEST_SUITE_P(OfEvery, Backup, testing::ValuesIn(every_device_kind()),
                         [](const auto& each) { return test_name(*each.param); });

}  // namespace
}  // namespace canvoy::tools::backup_test
