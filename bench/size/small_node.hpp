// A small node, whole, to tell what the application layer costs: SDO server, four RPDOs and four
// TPDOs of eight mapped values each, SYNC, heartbeat, emergency with history, LSS slave.
#pragma once

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy {

inline constexpr auto small_node =
    describe(cia301::device_type(0x0000'0191), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::sync(), cia301::error_history(8),
             cia301::emergency(), cia301::heartbeat_producer(1000),
             cia301::rpdo({.number = 1, .entries = 8}), cia301::rpdo({.number = 2}),
             cia301::rpdo({.number = 3}), cia301::rpdo({.number = 4}), cia301::tpdo({.number = 1}),
             cia301::tpdo({.number = 2}), cia301::tpdo({.number = 3}), cia301::tpdo({.number = 4}));
inline constexpr auto node_tables = lay_out_device<small_node>();
/// Not linked: the report looks at its size.
extern const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes;
const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes{};

extern "C" {
bool board_send(void*, const Frame&);
bool board_receive(Frame*);
std::int64_t board_time();
}

/// All that it does; `sdo_blocks` with block transfers. Constant-initialised, in zeroed memory.
template <bool sdo_blocks>
struct SmallNode {
  using Device = DeviceServices<node_tables, LssSlave::routes, sdo_blocks, 4, 4>;

  constexpr explicit SmallNode(typename Device::Memory& memory)
      : device(memory, {nullptr, board_send, nullptr}, 5), lss(device.node()) {}

  Device device;
  LssSlave lss;

  void run() {
    Node& node = device.node();
    node.start(Time(Duration(board_time())));
    Frame frame;
    for (;;) {
      const Time now(Duration{board_time()});
      if (board_receive(&frame)) node.receive(frame, now);
      node.advance(now);
    }
  }
};

}  // namespace canvoy
