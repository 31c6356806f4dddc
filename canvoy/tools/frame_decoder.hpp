// What a frame on a CANopen bus is, in words: its service, the node, and what it says.
//
//     FrameDecoder decoder;
//     FrameWords words = decoder.decode(frame);  // {"SDO response", 10, "6010h:00h
//     battery_temperature = 21.5 °C"}
//
// It knows the pre-defined connection set (CiA 301, 7.3.3) and what CiA 302 and 305 add to it, and
// what the profiles say of objects. It remembers what the frames before have begun: transfers, and
// node guarding.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/tools/sdo_decoder.hpp"

namespace canvoy::tools {

struct FrameWords {
  std::string
      service;  ///< `NMT`, `SYNC`, `EMCY`, `TIME`, `TPDO1`, `SDO request`, `heartbeat`, `LSS` ...
  NodeId node = 0;            ///< 0: none, or all
  std::string text;           ///< what it says; empty where the service says it all
  NodeId client = 0;          ///< of SDO, where it is known who asks
  bool is_middle = false;     ///< of an SDO transfer that goes on
  std::string transfer = {};  ///< the whole SDO transfer, where this is its last message
  std::span<const decoder::DecodedValue> values = {};  ///< of objects; until the next frame
  decoder::Marks marks = {};
};

class FrameDecoder {
 public:
  FrameDecoder() = default;
  FrameDecoder(const FrameDecoder&) = delete;
  FrameDecoder& operator=(const FrameDecoder&) = delete;

  FrameWords decode(const Frame& frame);

  /// What is known of the nodes: given here, or learned.
  decoder::Network& network() { return objects_.network(); }

 private:
  FrameWords error_control(const Frame& frame, NodeId node);
  std::string content(const Frame& frame, const FrameWords& words);

  FrameWords sdo(const Frame& frame, const decoder::Decoded& decoded);
  static FrameWords pdo(const decoder::Decoded& decoded);
  static void add_transfer(const decoder::Decoded& decoded, FrameWords& words);

  decoder::Decoder objects_;
  SdoDecoder sdo_{objects_.network()};
  std::bitset<node_id_max + 1> asked_;  ///< nodes to which a guarding request went last
};

}  // namespace canvoy::tools
