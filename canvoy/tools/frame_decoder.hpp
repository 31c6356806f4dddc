// What a frame on a CANopen bus is, in words: its service, the node, and what it says.
//
//     FrameDecoder decoder;
//     FrameWords words = decoder.decode(frame);  // {"SDO response", 10, "6010h:00h
//     battery_temperature = 21.5 °C"}
//
// It knows the pre-defined connection set (CiA 301, 7.3.3) and what CiA 302 and 305 add to it. It
// remembers what the frames before have begun: block transfers, and node guarding.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/tools/sdo_decoder.hpp"

namespace canvoy::tools {

struct FrameWords {
  std::string_view
      service;  ///< `NMT`, `SYNC`, `EMCY`, `TIME`, `TPDO1`, `SDO request`, `heartbeat`, `LSS` ...
  NodeId node = 0;   ///< 0: none, or all
  std::string text;  ///< what it says; empty where the service says it all
};

class FrameDecoder {
 public:
  FrameWords decode(const Frame& frame);

 private:
  FrameWords error_control(const Frame& frame, NodeId node);
  std::string content(const Frame& frame, const FrameWords& words);

  SdoDecoder sdo_;
  std::bitset<node_id_max + 1> asked_;  ///< nodes to which a guarding request went last
};

}  // namespace canvoy::tools
