// Counts heap allocations: none after the construction of a bus.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "canvoy/can/simulated/simulated_bus.hpp"

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) std::abort();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace canvoy::allocation_test {
namespace {

TEST(Allocation, IsNotDoneByASimulatedBusOnceItIsConstructed) {
  const std::size_t before_construction = allocations;
  SimulatedBus bus({.faults = {.bit_error_rate = 1e-3}});
  ASSERT_GT(allocations, before_construction);
  const std::size_t before = allocations;
  ControllerId last = no_controller;
  for (int i = 0; i < 127; ++i) last = bus.attach({});
  for (std::uint8_t i = 0; i < 127; ++i) {
    for (int count = 0; count < 40; ++count) bus.send(i, Frame::data_frame(0x180U + i, {i}));
  }
  bus.advance(Time(1s));
  bus.cut_cable(60);
  bus.unplug(last);
  bus.babble(3, Frame::data_frame(0x100, {}));
  bus.disturb(50, 20);
  bus.set_bit_rate(70, 250'000);
  bus.advance(Time(5s));
  bus.mend_cable();
  bus.advance(Time(10s));
  EXPECT_EQ(allocations, before);
  EXPECT_GT(bus.statistics().frames, 1000U);
  EXPECT_GT(bus.statistics().error_frames, 50U);
}

}  // namespace
}  // namespace canvoy::allocation_test
