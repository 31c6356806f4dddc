// Nothing in `sim` allocates after construction: the test counts every allocation of this program
// while a charger and a battery run through a charge, errors on the bus, resets and garbage.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <new>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/world.hpp"

namespace {

bool counting = false;
std::size_t allocations = 0;

void* allocate(std::size_t size) {
  if (counting) ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
/// Used by callers that can go on without the memory, such as std::stable_sort.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  if (counting) ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace canvoy::allocation_test {
namespace {

/// A tester on the same bus: reads a string by SDO, and sends unexpected frames.
class Tester {
 public:
  explicit Tester(const Port& port)
      : port_(port),
        node_(no_dictionary, {.values = {}, .states = {}, .routes = routes_, .backlog = backlog_},
              port, node_id_unconfigured),
        client_(node_) {}

  Node& node() { return node_; }
  void read_device_name(Time now) {
    node_.advance(now);
    client_.upload(10, 0x1008, 0, std::span<std::uint8_t>(bytes_),
                   SdoClient::Done::to<&Tester::finished>(*this));
  }
  void finished(SdoClient::Outcome outcome) { length_ = outcome ? *outcome : 0; }
  void send(const Frame& frame) { port_.send(port_.context, frame); }
  std::size_t length() const { return length_; }

 private:
  static constexpr DictionaryTables no_dictionary{};

  Port port_;
  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 16> backlog_{};
  std::array<std::uint8_t, 64> bytes_{};
  std::size_t length_ = 0;
  Node node_;
  SdoClient client_;
};

class CountAllocations {
 public:
  CountAllocations() {
    allocations = 0;
    counting = true;
  }
  ~CountAllocations() { counting = false; }
};

TEST(Allocation, TheCounterCounts) {
  const CountAllocations count;
  // The compiler may omit an expression with new and delete, but not a call.
  ::operator delete(::operator new(1));
  EXPECT_EQ(allocations, 1u);
}

TEST(Allocation, NothingIsAllocatedAfterConstruction) {
  World world;
  const BusIndex bus = world.add_bus({.bit_rate = 125'000});
  const std::array<SlotIndex, 3> slots = {world.add_slot(bus), world.add_slot(bus),
                                          world.add_slot(bus)};
  ChargingPlant plant(BatteryPlant::lead_acid_48v(), 0.2);
  cia419::ChargerDevice<> charger(world.port(slots[0]), 5, plant.stage.hardware());
  cia418::BatteryDevice<> battery(world.port(slots[1]), 10, plant.battery.hardware());
  Tester tester(world.port(slots[2]));
  world.occupy(slots[0], charger.node());
  world.occupy(slots[1], battery.node());
  world.occupy(slots[2], tester.node());
  for (const SlotIndex slot : slots) world.start(slot);
  world.add_plant(plant.on_step(), ChargingPlant::step_time);
  const std::size_t name_length = std::string_view("Canvoy CiA 418 battery").size();

  const CountAllocations count;
  world.run_for(10s);
  const bool has_charged = plant.ampere() > 0;
  tester.read_device_name(world.now());
  world.touched(slots[2]);
  world.run_for(1s);
  const bool has_read = tester.length() == name_length;
  for (std::uint16_t id = 0; id < 0x800; ++id) {
    tester.send(Frame::data_frame(id, {0x2F, 0x17, 0x10, 0x00, 0xFF, 0xFF, 0xFF, 0xFF}));
    tester.send(Frame::remote_frame(id, 8));
    world.run_for(5ms);
  }
  world.bus(bus).disturb(300, 20);
  world.run_for(10s);
  world.bus(bus).unplug(world.controller(slots[1]));
  world.run_for(10s);
  world.bus(bus).plug(world.controller(slots[1]));
  tester.send(Frame::data_frame(0x000, {0x81, 0x00}));
  world.run_for(30s);
  counting = false;

  EXPECT_TRUE(has_charged);
  EXPECT_TRUE(has_read);
  EXPECT_GT(plant.ampere(), 0) << "the charge went on";
  EXPECT_EQ(allocations, 0u);
}

}  // namespace
}  // namespace canvoy::allocation_test
