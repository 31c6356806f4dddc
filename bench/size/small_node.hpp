// A small complete node, to measure what the application layer costs: SDO server, four RPDOs and
// four TPDOs, SYNC, heartbeat, emergency with history, LSS slave.
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy {

extern "C" {
bool board_send(void*, const Frame&);
bool board_receive(Frame*);
std::int64_t board_time();
}

/// Starts a node and serves it forever.
[[noreturn]] inline void run_on_board(Node& node) {
  node.start(Time(Duration(board_time())));
  Frame frame;
  for (;;) {
    const Time now(Duration{board_time()});
    if (board_receive(&frame)) node.receive(frame, now);
    node.advance(now);
  }
}

/// The node with all its services; with block transfers if `sdo_blocks`. Constant-initialised, in
/// zeroed memory.
template <const auto& tables, bool sdo_blocks = false>
struct SmallNode {
  using Device = DeviceServices<tables, LssSlave::routes, sdo_blocks, 4, 4>;

  constexpr explicit SmallNode(typename Device::Memory& memory)
      : device(memory, {nullptr, board_send, nullptr}, 5), lss(device.node()) {}

  Device device;
  LssSlave lss;

  void run() { run_on_board(device.node()); }
};

}  // namespace canvoy
