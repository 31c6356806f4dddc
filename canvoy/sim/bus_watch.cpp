#include "canvoy/sim/bus_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

BusTap BusWatch::tap() {
  return {.context = this,
          .on_frame = [](void* context, Time now, ControllerId,
                         const Frame& frame) { static_cast<BusWatch*>(context)->hear(now, frame); },
          .on_state =
              [](void* context, Time now, ControllerId controller, BusState state) {
                static_cast<BusWatch*>(context)->state_changed(now, controller, state);
              }};
}

void BusWatch::hear(Time now, const Frame& frame) {
  if (!frame.is_plain()) return;
  if (frame.id == can_id::nmt && frame.length == 2) {
    note_(now, NmtCommandSeen{bus_, frame.data[1], static_cast<NmtCommand>(frame.data[0])});
  }
  const auto node = static_cast<NodeId>(frame.id & 0x7FU);
  const std::uint32_t service = frame.id & ~std::uint32_t{0x7F};
  if (node == 0) return;
  if (service == can_id::error_control && frame.length == 1) {
    return hear_error_control(now, node, frame.data[0]);
  }
  if (service != can_id::emergency || frame.length != 8) return;
  EmergencySeen seen{.bus = bus_,
                     .node = node,
                     .code = load<std::uint16_t>(frame.data.data()),
                     .error_register = frame.data[2]};
  std::copy_n(frame.data.begin() + 3, seen.info.size(), seen.info.begin());
  note_(now, seen);
}

void BusWatch::hear_error_control(Time now, NodeId node, std::uint8_t byte) {
  const RemoteState state = remote_state(byte);
  const RemoteState last = std::exchange(heard_.at(node), Heard{state, now}).state;
  if (state == RemoteState::boot_up) {
    note_(now, BootedUp{bus_, node});
  } else if (state != last && state != RemoteState::unknown) {
    note_(now, NmtStateSeen{bus_, node, static_cast<NmtState>(state)});
  }
}

RemoteState BusWatch::heard_of(NodeId node, Time now, Duration time_out) const {
  const Heard& heard = heard_.at(node);
  const bool is_lost = heard.state != RemoteState::unknown && now - heard.at > time_out;
  return is_lost ? RemoteState::lost : heard.state;
}

void BusWatch::state_changed(Time now, ControllerId controller, BusState state) {
  const auto found = nodes_.find(controller);
  if (found != nodes_.end()) note_(now, BusStateChanged{bus_, found->second, state});
}

}  // namespace canvoy
