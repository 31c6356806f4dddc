// Node guarding on a bus with arbitration and load: one master, 126 slaves, 125 kbit/s.
#include <gtest/gtest.h>

#include <deque>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::guarded_network_test {
namespace {

constexpr Duration guard_time = 200ms;
constexpr std::uint8_t life_time_factor = 3;

// Guard time and life time factor of each slave: the slave watches the master as well.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>(
        {{.index = 0x100C, .entry_count = 1}, {.index = 0x100D, .entry_count = 1}}),
    std::to_array<EntryRow>({{.type = DataType::unsigned16, .access = Access::rw, .initial = 200},
                             {.access = Access::rw, .initial = life_time_factor}}));
constexpr DictionaryTables tables = layout.tables();

struct Slave {
  Slave(const Port& port, NodeId id) : node(tables, memory.spans(), port, id), guarding(node) {}

  WireMemory memory{tables};
  Node node;
  NodeGuardingSlave guarding;
};

class GuardedNetwork : public testing::Test {
 protected:
  static constexpr NodeId master_id = 127;
  static constexpr unsigned slave_count = 126;

  void SetUp() override {
    for (unsigned id = 1; id <= slave_count; ++id) {
      const SlotIndex slot = world_.add_slot(bus_);
      slaves_.emplace_back(world_.port(slot), static_cast<NodeId>(id));
      world_.occupy(slot, slaves_.back().node);
      // Clocks that are up to 0.1 % too slow or too fast.
      world_.set_clock_drift(slot, static_cast<std::int32_t>(id * 16) - 1000);
      world_.start(slot);
    }
    guarding_.on_event(callback<&GuardedNetwork::event>(*this));
    world_.occupy(master_slot_, master_);
    world_.start(master_slot_);
    world_.at(Time(200ms), [this](Time now) { guard_all(now); });
  }

  void guard_all(Time now) {
    master_.advance(now);
    for (unsigned id = 1; id <= slave_count; ++id) {
      EXPECT_TRUE(guarding_.guard(static_cast<NodeId>(id), guard_time, life_time_factor));
    }
    world_.touched(master_slot_);
  }
  void event(NodeId node_id, NodeGuardingEvent, bool occurs) {
    events_.push_back((occurs ? "lost " : "back ") + std::to_string(node_id));
  }
  unsigned count_slaves(RemoteState state) const {
    unsigned count = 0;
    for (unsigned id = 1; id <= slave_count; ++id) {
      count += guarding_.state(static_cast<NodeId>(id)) == state ? 1U : 0U;
    }
    return count;
  }
  SlotIndex slot_of(unsigned id) const { return static_cast<SlotIndex>(id); }

  World world_;
  BusIndex bus_ = world_.add_bus({.bit_rate = 125'000});
  SlotIndex master_slot_ = world_.add_slot(bus_);
  WireMemory memory_{tables};
  Node master_{tables, memory_.spans(), world_.port(master_slot_), master_id};
  NodeGuardingMaster::Slot slots_[slave_count];
  NodeGuardingMaster guarding_{master_, slots_};
  std::deque<Slave> slaves_;
  std::vector<std::string> events_;
};

TEST_F(GuardedNetwork, HearsAllSlavesAndLosesNone) {
  world_.run_until(Time(10s));
  EXPECT_EQ(count_slaves(RemoteState::pre_operational), slave_count);
  EXPECT_EQ(events_, std::vector<std::string>());
  EXPECT_EQ(master_.transmitter().lost(), 0U);
  for (const Slave& slave : slaves_) EXPECT_FALSE(slave.guarding.is_master_lost());
}

TEST_F(GuardedNetwork, NoticesTheSlaveThatIsGoneAndItsReturn) {
  world_.run_until(Time(5s));
  world_.stop(slot_of(77));
  world_.run_until(Time(5s) + 3 * guard_time + guard_time);
  EXPECT_EQ(events_, std::vector<std::string>({"lost 77"}));
  world_.start(slot_of(77));
  world_.run_until(Time(10s));
  EXPECT_EQ(events_, std::vector<std::string>({"lost 77", "back 77"}));
  EXPECT_EQ(count_slaves(RemoteState::pre_operational), slave_count);
}

TEST_F(GuardedNetwork, IsWithoutAMasterForEverySlaveWhenThatIsGone) {
  world_.run_until(Time(5s));
  world_.stop(master_slot_);
  world_.run_until(Time(5s) + life_time_factor * guard_time + 50ms);
  for (const Slave& slave : slaves_) EXPECT_TRUE(slave.guarding.is_master_lost());
  world_.start(master_slot_);
  world_.at(world_.now() + 100ms, [this](Time now) { guard_all(now); });
  world_.run_for(1s);
  for (const Slave& slave : slaves_) EXPECT_FALSE(slave.guarding.is_master_lost());
}

}  // namespace
}  // namespace canvoy::guarded_network_test
