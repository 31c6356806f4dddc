// Emergency 0010h of CiA 417-1, 8.4: an error counter of the CAN controller has reached its warning
// limit. CiA 301 has no code for that, and its emergency producer does not report it.
//
//     BusWarning bus_warning(device.node());   // "085#10 00 11 00 00 00 00 00"
//
// The error stays while the controller is error-passive, which 8120h reports in addition. It ends
// (0000h) when both counters are below the limit, or with the recovery from bus-off.
#pragma once

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia417 {

class BusWarning {
 public:
  /// `node` already has its emergency producer, and must outlive this.
  explicit BusWarning(Node& node) : node_(node) { node.attach(service_); }

 private:
  void reset(ResetScope scope);
  void bus_state_changed(BusState state);

  static const ServiceHandlers service_calls;
  Node& node_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
