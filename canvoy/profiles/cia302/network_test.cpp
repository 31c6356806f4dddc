// A whole network in its boot-up procedure (CiA 302-2) with the additions of part 3: of three equal
// devices, one needs a configuration, one a program, and one both.
#include <gtest/gtest.h>

#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/manager/program_manager.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/canopen/testing/concise_dcf_bytes.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia302_network_test {
namespace {

constexpr auto master_device =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(0),
             cia302::nmt_master(), cia302::configuration(), cia302::expected_programs());
constexpr auto master_layout = lay_out_device<master_device>();

constexpr auto slave_device = describe(
    cia301::device_type(0x191), cia301::error_register_object, cia301::identity({.vendor_id = 7}),
    cia301::heartbeat_producer(0), cia301::verify_configuration_object, cia302::programs(1));
constexpr auto slave_layout = lay_out_device<slave_device>();

const std::vector<std::uint8_t> configuration = concise_dcf({{0x1017, 0, {0xF4, 0x01}}});
const FixedConfigurations::Item configurations[] = {{.slave = 5, .concise_dcf = configuration},
                                                    {.slave = 7, .concise_dcf = configuration}};
constexpr std::uint32_t crc_of_1_to_9 = 0xCBF4'3926;  // the check value of CRC-32
constexpr std::uint32_t date = 0x3D31, time = 0x0293'2E00;

/// A device with a place for one program.
struct Slave {
  Slave(const Port& port, NodeId id) : device(port, id) {}
  SimulatedFlash memory{{.sector_size = 128, .sectors = 2, .unit = 8}};
  std::array<ProgramSlot, 1> slots{{{.address = 0, .size = 256}}};
  DeviceNode<slave_layout> device;
  ProgramServer programs{device.node(), memory.flash, slots};

  std::uint64_t get(std::uint16_t index, std::uint8_t sub) {
    return device.node().dictionary().number(index, sub);
  }
};

/// Boots three slaves at once. 5 needs a configuration, 6 a program, 7 both, 8 nothing.
class NetworkOfPart3 : public testing::Test {
 protected:
  NetworkOfPart3() {
    configuration_manager.serve(hooks);
    program_manager.serve(hooks);
    sut.boot_manager().use(hooks);
    sut.boot_manager().on_report(callback<&NetworkOfPart3::told>(*this));
    std::size_t place = 0;
    cable.connect(place, sut.node());
    for (Slave* slave : all) cable.connect(++place, slave->device.node());
  }
  /// The master is configured, and boots.
  void boot() {
    for (const std::uint8_t id : std::to_array<std::uint8_t>({5, 7})) {
      set(0x1F26, id, date);
      set(0x1F27, id, time);
    }
    for (const std::uint8_t id : std::to_array<std::uint8_t>({6, 7}))
      set(0x1F55, id, crc_of_1_to_9);
    set(0x1F81, 5, 0x05);
    set(0x1F81, 6, 0x65);
    set(0x1F81, 7, 0x6D);
    set(0x1F81, 8, 0x05);
    cable.run_for(20s);
  }
  void expect_all_up() {
    std::ranges::sort(ends);
    EXPECT_EQ(ends, (std::vector<std::string>{"5-", "6-", "7-", "8-"}));
    for (Slave* slave : all) EXPECT_EQ(slave->device.node().state(), NmtState::operational);
    expect_configured(five, true);
    expect_configured(six, false);
    expect_configured(seven, true);
    expect_configured(eight, false);
  }
  /// Downloads of programs that start.
  auto downloads() {
    return std::ranges::count_if(cable.heard, [](const Cable::Heard& heard) {
      return wire_text(heard.frame).find("#21 50 1F 01") != std::string::npos;
    });
  }
  void set(std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    std::array<std::uint8_t, 4> bytes{};
    store(bytes.data(), value);
    const Result<Entry> entry = sut.dictionary().find(index, sub);
    ASSERT_TRUE(entry);
    ASSERT_EQ(sut.dictionary().write(*entry, bytes, Source::application), AbortCode::none);
  }
  void told(const BootReport& report) {
    const bool is_end = report.event == BootEvent::failed || report.event == BootEvent::retried ||
                        report.event == BootEvent::booted;
    if (is_end) ends.push_back(std::to_string(report.slave) + letter(report.outcome.error));
  }
  Result<std::uint32_t> open(NodeId) { return std::uint32_t{9}; }
  AbortCode read(NodeId, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>('1' + offset++);
    return AbortCode::none;
  }
  void expect_configured(Slave& slave, bool is_configured) {
    EXPECT_EQ(slave.get(0x1017, 0), is_configured ? 500U : 0U);
    EXPECT_EQ(slave.get(0x1020, 1), is_configured ? date : 0U);
    EXPECT_EQ(slave.get(0x1020, 2), is_configured ? time : 0U);
  }

  Cable cable;
  MasterNode<master_layout, MasterSize{.slots = 3, .own_routes = 3}> sut{cable.port(0), 127};
  FixedConfigurations stored{sut.node(), configurations};
  ConfigurationManager::Worker configuration_workers[3] = {
      ConfigurationManager::Worker(sut.node()), ConfigurationManager::Worker(sut.node()),
      ConfigurationManager::Worker(sut.node())};
  ConfigurationManager configuration_manager{sut.node(), configuration_workers};
  ProgramManager::Worker program_workers[3] = {ProgramManager::Worker(sut.node()),
                                               ProgramManager::Worker(sut.node()),
                                               ProgramManager::Worker(sut.node())};
  ProgramManager program_manager{program_workers,
                                 {.open = callback<&NetworkOfPart3::open>(*this),
                                  .read = callback<&NetworkOfPart3::read>(*this)}};
  BootHooks hooks;
  Slave five{cable.port(1), 5}, six{cable.port(2), 6}, seven{cable.port(3), 7},
      eight{cable.port(4), 8};
  Slave* all[4] = {&five, &six, &seven, &eight};
  std::vector<std::string> ends;
};

TEST_F(NetworkOfPart3, IsUpWhenEachSlaveHasWhatItNeeds) {
  cable.start_all();
  boot();
  expect_all_up();
  EXPECT_EQ(downloads(), 2);
  EXPECT_EQ(five.get(0x1F56, 1), 0U);
  for (Slave* updated : {&six, &seven}) {
    EXPECT_EQ(updated->get(0x1F56, 1), crc_of_1_to_9);
    EXPECT_EQ(updated->get(0x1F51, 1), 1U) << "the program runs";
  }
}

/// These devices do not store the configuration; they store a program.
TEST_F(NetworkOfPart3, ThatBootsAgainIsConfiguredAgainAndHasItsProgramsAlready) {
  cable.start_all();
  boot();
  sut.node().command(NmtCommand::reset_communication);
  cable.run_for(1s);
  ends.clear();
  cable.clear();
  boot();
  expect_all_up();
  EXPECT_EQ(downloads(), 0);
}

TEST_F(NetworkOfPart3, GivesASlaveThatComesLateWhatItNeeds) {
  cable.cut(3);
  cable.start_all();
  boot();
  EXPECT_EQ(std::ranges::count(ends, "7-"), 0);
  EXPECT_GE(std::ranges::count(ends, "7B"), 10) << "each second, and a second is waited for";
  ends.clear();
  cable.cut(3, false);
  cable.run_for(20s);
  EXPECT_EQ(ends.back(), "7-");
  expect_configured(seven, true);
  EXPECT_EQ(seven.get(0x1F56, 1), crc_of_1_to_9);
}

}  // namespace
}  // namespace canvoy::cia302_network_test
