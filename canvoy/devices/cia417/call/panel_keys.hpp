// Keys and buttons that were turned, held or let go while their call controller did not hear it: it
// reads what the inputs of its panels are (6100h to 611Fh, by SDO; CiA 417-4, 4.3.1), since a panel
// tells of changes alone (6010h).
//
//     PanelKeys keys(node, client, calls);
//     keys.read(22);     // node 22 is operational: it may have turned keys
//
// One panel after the other is read, input by input, with a pause behind each answer: heartbeats
// come behind SDO, and would wait until all was read. A special function whose input is on, or not
// any more, is taken as if its panel had told it now, but for those that presses switch (fans and
// load times without locking function): these, and calls, count only when they are told. Who has no
// inputs answers so with his first abort code, and whoever does not answer at all is left.
//
// Inputs of lift n stand at 6100h + (n - 1) * 0800h, or, in a panel for several lifts, at 6100h
// with the lifts in their records: both are read.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"

namespace canvoy::cia417 {

class PanelKeys {
 public:
  /// `client` is used by nobody else. All must outlive this.
  PanelKeys(Node& node, SdoClient& client, CallController& calls);
  PanelKeys(const PanelKeys&) = delete;
  PanelKeys& operator=(const PanelKeys&) = delete;

  /// Soon; a panel that is being read is read once more behind it.
  void read(NodeId panel);
  bool is_reading() const { return panel_ != 0; }

  /// Behind each answer. A record of an input takes four frames, 2 ms at 250 kbit/s.
  static constexpr Duration pause = 5ms;

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void go_on(Time now);
  bool find_next();
  void answered(SdoClient::Outcome outcome);
  void next_block();
  std::uint16_t index() const;

  static const ServiceCalls service_calls;

  Node& node_;
  SdoClient& client_;
  CallController& calls_;
  std::bitset<node_id_max + 1> waiting_;
  NodeId panel_ = 0;  ///< that is being read
  /// Where: the block of a lift (from 1), the group in it, the input, and how many the group has.
  std::uint8_t block_ = 0;
  std::uint8_t group_ = 0;
  std::uint8_t input_ = 0;  ///< 0: it is asked how many
  std::uint8_t inputs_ = 0;
  std::array<std::uint8_t, 8> value_{};
  Timer timer_;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy::cia417
