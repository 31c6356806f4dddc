// The expectations are those of the profile database of CiA's conformance test, but for the texts.
#include <gtest/gtest.h>

#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/master.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia302_master_test {
namespace {

using namespace entry_rows;

constexpr auto master = describe(cia301::device_type(0), cia301::error_register_object,
                                 cia301::identity({.vendor_id = 1}),
                                 cia301::heartbeat_consumers(127), cia301::heartbeat_producer(0),
                                 cia302::nmt_master({.startup = 0x01, .boot_time_ms = 5000}),
                                 cia302::flying_master(2), cia302::restore_configuration_object);
constexpr auto master_layout = lay_out_device<master>();

constexpr Expected entries[] = {
    {0x102A, 0, u16, "rw", 0},     {0x1F80, 0, u32, "rw", 1},     {0x1F81, 0, u8, "const", 127},
    {0x1F81, 1, u32, "rw", 0},     {0x1F81, 127, u32, "rw", 0},   {0x1F82, 0, u8, "const", 128},
    {0x1F82, 1, u8, "rw", 0},      {0x1F82, 127, u8, "rw", 0},    {0x1F82, 128, u8, "wo", 0},
    {0x1F83, 0, u8, "const", 128}, {0x1F83, 127, u8, "rw", 0},    {0x1F83, 128, u8, "wo", 0},
    {0x1F84, 0, u8, "const", 127}, {0x1F84, 127, u32, "rw", 0},   {0x1F85, 127, u32, "rw", 0},
    {0x1F86, 127, u32, "rw", 0},   {0x1F87, 127, u32, "rw", 0},   {0x1F88, 127, u32, "rw", 0},
    {0x1F89, 0, u32, "rw", 5000},  {0x1F8A, 0, u8, "const", 127}, {0x1F8A, 127, u8, "rw", 0},
    {0x1F90, 0, u8, "const", 6},   {0x1F90, 1, u16, "rw", 100},   {0x1F90, 2, u16, "rw", 500},
    {0x1F90, 3, u16, "rw", 2},     {0x1F90, 4, u16, "rw", 1500},  {0x1F90, 5, u16, "rw", 10},
    {0x1F90, 6, u16, "rw", 4000},  {0x1F91, 0, u8, "const", 3},   {0x1F91, 1, u16, "rw", 100},
    {0x1F91, 2, u16, "rw", 500},   {0x1F91, 3, u16, "rw", 15},
};

TEST(Cia302Master, HasItsObjectsWithTheirTypesAccessAndDefaults) {
  const DeviceMemory device(master_layout.tables(), 9);
  expect_entries(device.dictionary, entries);
}

constexpr auto slave = describe(cia301::device_type(0x191), cia301::error_register_object,
                                cia301::identity({.vendor_id = 7}), cia301::heartbeat_producer(100),
                                cia301::guard_time_object, cia301::life_time_factor_object);
constexpr auto slave_layout = lay_out_device<slave>();

/// Writes into the master like a configuration tool, and resets it.
void assign(Cable& cable, const char* request) {
  cable.send(request);
}

TEST(Cia302Master, BootsASlaveThatIsNamedOverTheBus) {
  Cable cable;
  MasterNode<master_layout> sut(cable.port(0), 127);
  DeviceNode<slave_layout> device(cable.port(1), 5);
  cable.connect(0, sut.node());
  cable.connect(1, device.node());
  cable.start_all();
  assign(cable, "67F#23 85 1F 05 07 00 00 00");  // vendor 7
  assign(cable, "67F#23 16 10 01 F4 01 05 00");  // heartbeat within 500 ms
  assign(cable, "67F#23 81 1F 05 0D 00 00 00");  // a mandatory slave
  cable.run_for(1s);
  EXPECT_EQ(device.node().state(), NmtState::operational);
  EXPECT_EQ(sut.boot_manager().slave_state(5), BootManager::SlaveState::booted);
  cable.send("67F#40 82 1F 05 00 00 00 00");
  EXPECT_EQ(cable.last(0x5FF), "5FF#4F 82 1F 05 05 00 00 00");
  cable.cut(1);
  cable.run_for(1s);
  EXPECT_EQ(sut.boot_manager().slave_state(5), BootManager::SlaveState::waiting);
  cable.send("67F#40 82 1F 05 00 00 00 00");
  EXPECT_EQ(cable.last(0x5FF), "5FF#4F 82 1F 05 01 00 00 00");
}

TEST(Cia302Master, GuardsASlaveWithoutHeartbeat) {
  Cable cable;
  MasterNode<master_layout, MasterSize{.guarded = 2}> sut(cable.port(0), 127);
  DeviceNode<slave_layout> device(cable.port(1), 5);
  cable.connect(0, sut.node());
  cable.connect(1, device.node());
  cable.start_all();
  cable.send("605#2B 17 10 00 00 00 00 00");     // no heartbeat
  assign(cable, "67F#23 81 1F 05 15 03 C8 00");  // 200 ms, factor 3, kept alive
  cable.send("000#01 05");
  cable.run_for(1s);
  EXPECT_EQ(sut.boot_manager().slave_error(5), BootError::already_operational);
  cable.send("67F#40 83 1F 05 00 00 00 00");
  EXPECT_EQ(cable.last(0x5FF), "5FF#4F 83 1F 05 01 00 00 00");
  cable.clear();
  cable.run_for(2s);
  EXPECT_GE(cable.count(0x705), 19U) << "remote frames and answers each 200 ms";
  cable.cut(1);
  cable.run_for(1s);
  EXPECT_EQ(sut.boot_manager().slave_state(5), BootManager::SlaveState::booting);
}

}  // namespace
}  // namespace canvoy::cia302_master_test
