// The largest CANopen network on one bus: a master boots, configures and starts 126 slaves, and no
// service is lost or repeated.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/configuration.hpp"
#include "canvoy/profiles/cia302/master.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::large_network_test {
namespace {

constexpr NodeId master_id = 127;
constexpr NodeId slave_count = 126;
constexpr std::uint32_t heartbeat_ms = 1000;

constexpr auto master_device =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::heartbeat_consumers(127),
             cia301::heartbeat_producer(0), cia302::nmt_master(), cia302::configuration());
constexpr auto master_layout = lay_out_device<master_device>();

constexpr auto slave_device = describe(
    cia301::device_type(0x000F'0191), cia301::error_register_object,
    cia301::identity({.vendor_id = 0x123, .product_code = 7, .revision = 0x0001'0002}),
    cia301::heartbeat_producer(0), cia301::emergency(), cia301::verify_configuration_object);
constexpr auto slave_layout = lay_out_device<slave_device>();

// Two entries: 1017h = 1000 ms, 1015h = 10 ms.
constexpr std::uint8_t concise_dcf[] = {0x02, 0x00, 0x00, 0x00,                    // count
                                        0x17, 0x10, 0x00, 0x02, 0x00, 0x00, 0x00,  //
                                        0xE8, 0x03,                                //
                                        0x15, 0x10, 0x00, 0x02, 0x00, 0x00, 0x00,  //
                                        0x64, 0x00};

/// A slave; a part of its frames may be lost.
struct Slave {
  Slave(const Port& port, NodeId id, unsigned lost_of_hundred)
      : bus(port),
        every(lost_of_hundred),
        device({this, &Slave::take, &Slave::accept}, id),
        stored(device.node()) {
    count = id;
  }
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<Slave*>(context);
    const bool is_sdo = (frame.id & 0x780U) == 0x580U;
    if (is_sdo && self.every != 0 && ++self.count % (100 / self.every) == 0) return true;
    return self.bus.send(self.bus.context, frame);
  }
  static void accept(void* context, std::uint16_t id, bool wanted) {
    const Port& port = static_cast<Slave*>(context)->bus;
    port.accept(port.context, id, wanted);
  }
  Port bus;
  unsigned every;
  unsigned count = 0;
  DeviceNode<slave_layout> device;
  StoredValues stored;
};

template <std::size_t slots>
struct LargeNetwork {
  using Workers = std::array<ConfigurationManager::Worker, slots>;

  LargeNetwork(const SimulatedBusOptions& options, std::uint32_t startup,
               unsigned lost_of_hundred = 0)
      : bus(world.add_bus(options)),
        master_slot(world.add_slot(bus)),
        hooks(std::make_unique<Hooks>()),
        master(world.port(master_slot), master_id, {.hooks = hooks->forward()}),
        stored(master.node()),
        workers(make_workers(std::make_index_sequence<slots>{})),
        configuration(master.node(), workers) {
    configuration.serve(hooks->real);
    world.occupy(master_slot, master.node());
    stored.store(0x1F80, 0, startup);
    for (NodeId id = 1; id <= slave_count; ++id) add_slave(id, lost_of_hundred);
    fixed = std::make_unique<FixedConfigurations>(master.node(), items);
    world.bus().observe({this, &LargeNetwork::heard, nullptr, nullptr, nullptr});
    world.run_until(Time(100ms));
    counted = true;
    world.start(master_slot);
  }

  /// The configuration manager needs the node of the master, which receives its hooks earlier.
  struct Hooks {
    BootHooks real;
    BootHooks forward() {
      return {.update_configuration = callback<&Hooks::update>(*this),
              .abandon = callback<&Hooks::abandon>(*this)};
    }
    void update(const BootTask& task) { real.update_configuration(task); }
    void abandon(NodeId slave) { real.abandon(slave); }
  };

  template <std::size_t... numbers>
  Workers make_workers(std::index_sequence<numbers...>) {
    return {((void)numbers, ConfigurationManager::Worker(master.node()))...};
  }

  void add_slave(NodeId id, unsigned lost_of_hundred) {
    const SlotIndex slot = world.add_slot(bus);
    Slave& slave = slaves.emplace_back(world.port(slot), id, lost_of_hundred);
    world.occupy(slot, slave.device.node());
    world.start(slot);
    const std::uint32_t expected[] = {0x000F'0191, 0x123, 7, 0x0001'0002, 0};
    for (unsigned i = 0; i < 5; ++i) {
      stored.store(static_cast<std::uint16_t>(0x1F84 + i), id, expected[i]);
    }
    stored.store(0x1F81, id, 0x0D);
    stored.store(0x1F26, id, 0x2000);
    stored.store(0x1F27, id, 0x3000 + id);
    stored.store(0x1016, id, static_cast<std::uint32_t>(id) << 16 | 3 * heartbeat_ms);
    items.push_back({.slave = id, .concise_dcf = concise_dcf});
  }

  static void heard(void* context, Time now, ControllerId, const Frame& frame) {
    auto& self = *static_cast<LargeNetwork*>(context);
    if (!self.counted) return;
    if (frame.id == 0 && frame.data[0] == 0x01) self.started = now;
    if (frame.id > 0x700) return;  // heartbeats are not counted
    Frame counted_frame = frame;
    // What a server answers depends on its values.
    if ((frame.id & 0x780U) == 0x580U)
      counted_frame.data = {frame.data[0], frame.data[1], frame.data[2], frame.data[3]};
    ++self.frames[wire_text(counted_frame)];
  }

  /// Runs until all are operational, at most until `limit`.
  bool run_until_operational(Time limit) {
    while (world.now() < limit && !all_operational()) world.run_for(1ms);
    return all_operational();
  }
  bool all_operational() {
    for (Slave& slave : slaves) {
      if (slave.device.node().state() != NmtState::operational) return false;
    }
    return master.node().state() == NmtState::operational;
  }

  World world;
  BusIndex bus;
  SlotIndex master_slot;
  std::unique_ptr<Hooks> hooks;
  MasterNode<master_layout, MasterSize{.slots = slots, .own_routes = slots}> master;
  StoredValues stored;
  Workers workers;
  ConfigurationManager configuration;
  std::deque<Slave> slaves;
  std::vector<FixedConfigurations::Item> items;
  std::unique_ptr<FixedConfigurations> fixed;
  std::map<std::string, unsigned> frames;
  Time started{};
  bool counted = false;
};

/// Counts each frame that the boot-up of 126 slaves needs.
std::map<std::string, unsigned> frames_of_boot_up(bool all_at_once) {
  std::map<std::string, unsigned> expected{{"000#82 00", 1}};
  if (all_at_once) expected["000#01 00"] = 1;
  for (unsigned id = 1; id <= slave_count; ++id) {
    char text[64];
    const auto expect = [&](unsigned can_id, const char* bytes) {
      std::snprintf(text, sizeof text, "%03X#%s", can_id + id, bytes);
      expected[text] = 1;
    };
    const auto both = [&](const char* request, const char* answer) {
      expect(0x600, request);
      expect(0x580, answer);
    };
    both("40 00 10 00 00 00 00 00", "43 00 10 00 00 00 00 00");
    both("40 18 10 01 00 00 00 00", "43 18 10 01 00 00 00 00");
    both("40 18 10 02 00 00 00 00", "43 18 10 02 00 00 00 00");
    both("40 18 10 03 00 00 00 00", "43 18 10 03 00 00 00 00");
    both("40 20 10 01 00 00 00 00", "43 20 10 01 00 00 00 00");
    both("2B 17 10 00 E8 03 00 00", "60 17 10 00 00 00 00 00");
    both("2B 15 10 00 64 00 00 00", "60 15 10 00 00 00 00 00");
    both("23 20 10 01 00 20 00 00", "60 20 10 01 00 00 00 00");
    std::snprintf(text, sizeof text, "%03X#23 20 10 02 %02X 30 00 00", 0x600 + id, id);
    expected[text] = 1;
    expect(0x580, "60 20 10 02 00 00 00 00");
    if (!all_at_once) {
      std::snprintf(text, sizeof text, "000#01 %02X", id);
      expected[text] = 1;
    }
  }
  return expected;
}

template <std::size_t slots>
void expect_each_service_once(LargeNetwork<slots>& network, bool all_at_once) {
  const auto expected = frames_of_boot_up(all_at_once);
  EXPECT_EQ(network.frames.size(), expected.size());
  for (const auto& [frame, count] : expected) EXPECT_EQ(network.frames[frame], count) << frame;
  for (const auto& [frame, count] : network.frames) EXPECT_EQ(expected.count(frame), 1U) << frame;
  EXPECT_EQ(network.master.node().transmitter().lost(), 0U);
  EXPECT_EQ(network.master.node().counters().malformed, 0U);
}

void expect_parameters(std::deque<Slave>& slaves) {
  for (Slave& slave : slaves) {
    const Dictionary& dictionary = slave.device.dictionary();
    EXPECT_EQ(dictionary.number(0x1017, 0), heartbeat_ms);
    EXPECT_EQ(dictionary.number(0x1015, 0), 100U);
    EXPECT_EQ(dictionary.number(0x1020, 1), 0x2000U);
    EXPECT_EQ(dictionary.number(0x1020, 2), 0x3000U + slave.device.node().id());
  }
}

constexpr SimulatedBusOptions fast_bus{.bit_rate = 1'000'000};
constexpr std::uint32_t one_by_one = 0x01;
constexpr std::uint32_t all_at_once = 0x03;

TEST(LargeNetwork, Of127NodesBootsWithEachServiceDoneOnce) {
  auto network = std::make_unique<LargeNetwork<126>>(fast_bus, all_at_once);
  ASSERT_TRUE(network->run_until_operational(Time(10s)));
  expect_each_service_once(*network, true);
  expect_parameters(network->slaves);
  RecordProperty("operational_ms", static_cast<int>(network->started.time_since_epoch() / 1ms));
  // The network stays up: each slave sends its heartbeat, and nothing else happens.
  const auto frames = network->frames;
  network->world.run_for(10s);
  EXPECT_EQ(network->frames, frames);
  EXPECT_TRUE(network->all_operational());
}

TEST(LargeNetwork, Of127NodesBootsSlaveBySlaveWithEachServiceDoneOnce) {
  auto network = std::make_unique<LargeNetwork<126>>(fast_bus, one_by_one);
  ASSERT_TRUE(network->run_until_operational(Time(10s)));
  expect_each_service_once(*network, false);
}

TEST(LargeNetwork, NeedsNoMoreThanAFewSlots) {
  auto network = std::make_unique<LargeNetwork<4>>(fast_bus, one_by_one);
  // A slave keeps its slot until its first heartbeat.
  ASSERT_TRUE(network->run_until_operational(Time(60s)));
  expect_each_service_once(*network, false);
  expect_parameters(network->slaves);
}

TEST(LargeNetwork, BootsOnABusThatDestroysOneFrameInFifty) {
  SimulatedBusOptions options = fast_bus;
  options.faults.frame_error_probability = 0.02;
  auto network = std::make_unique<LargeNetwork<126>>(options, all_at_once);
  ASSERT_TRUE(network->run_until_operational(Time(10s)));
  expect_parameters(network->slaves);
  // The controllers repeat destroyed frames. A frame that is disturbed in its very last bit comes
  // twice, as on every CAN bus, without effect.
  const auto expected = frames_of_boot_up(true);
  EXPECT_EQ(network->frames.size(), expected.size());
  for (const auto& [frame, count] : expected) EXPECT_GE(network->frames[frame], count) << frame;
}

TEST(LargeNetwork, BootsAlthoughEachSlaveLosesOneAnswerInFifty) {
  auto network = std::make_unique<LargeNetwork<126>>(fast_bus, all_at_once, 2);
  ASSERT_TRUE(network->run_until_operational(Time(60s)));
  expect_parameters(network->slaves);
  EXPECT_EQ(network->frames["000#01 00"], 1U);
}

}  // namespace
}  // namespace canvoy::large_network_test
