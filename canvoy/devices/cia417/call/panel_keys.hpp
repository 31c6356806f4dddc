// Keys and buttons that were turned, held or released while the call controller did not receive it.
// This class reads the inputs of its panels (6100h to 611Fh, by SDO; CiA 417-4, 4.3.1), since a
// panel reports only changes (6010h).
//
//     PanelKeys keys(node, client, calls);
//     keys.read(22);     // node 22 is operational: it may have turned keys
//
// Panels are read one after the other, input by input, with a pause after each answer: heartbeats
// have lower priority than SDO, and would otherwise be delayed until all was read. A special
// function with an input that is on, or has gone off, is taken as if the panel had just sent it.
// Excepted are functions that each press switches (fans and load times without locking function):
// these, and calls, count only when they are sent. A panel without inputs answers with an abort
// code to the first request; a panel that does not answer is skipped.
//
// Inputs of lift n are at 6100h + (n - 1) * 0800h, or, in a panel for several lifts, at 6100h with
// the lifts in their records. Both are read.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"

namespace canvoy::cia417 {

class PanelKeys {
 public:
  /// `client` has no other user. All arguments must outlive this.
  PanelKeys(Node& node, SdoClient& client, CallController& calls);

  /// Reads a panel soon. A panel that is being read is read again afterwards.
  void read(NodeId panel);
  /// True while a panel is being read.
  bool is_reading() const { return panel_ != 0; }

  /// After each answer. A record of an input takes four frames, 2 ms at 250 kbit/s.
  static constexpr Duration pause = 5ms;

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void go_on(Time now);
  bool find_next();
  void answered(SdoClient::Outcome outcome);
  void next_block();
  std::uint16_t index() const;

  static const ServiceHandlers service_calls;

  Node& node_;
  SdoClient& client_;
  CallController& calls_;
  std::bitset<node_id_max + 1> waiting_;
  NodeId panel_ = 0;  ///< the panel that is being read
  /// Position: block of a lift (from 1), group in it, input, and number of inputs of the group.
  std::uint8_t block_ = 0;
  std::uint8_t group_ = 0;
  std::uint8_t input_ = 0;  ///< 0: the number is requested
  std::uint8_t inputs_ = 0;
  std::array<std::uint8_t, 8> value_{};
  Timer timer_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
