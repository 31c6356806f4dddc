// What a frame on a CANopen bus is, in words: its service, the node, and what it says.
//
//     FrameDecoder decoder;
//     FrameWords words = decoder.decode(frame);  // {"SDO response", 10, "6010h:00h
//     battery_temperature = 21.5 °C"}
//
// It knows the pre-defined connection set (CiA 301, 7.3.3), and learns the profile of a node when
// somebody reads the node's device type (1000h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/sdo.hpp"
#include "canvoy/profiles/registry.hpp"

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
  std::string content(const Frame& frame, const FrameWords& words);
  std::string sdo_request(const Frame& frame, NodeId node);
  std::string sdo_response(const Frame& frame, NodeId node);
  std::string object(NodeId node, sdo::Multiplexer multiplexer) const;
  std::string object_with_value(NodeId node, sdo::Message message);
  void learn_profile(NodeId node, sdo::Multiplexer multiplexer, std::uint32_t value);
  const Profile& profile_of(NodeId node) const;

  std::array<const Profile*, node_id_max + 1> profiles_{};
};

}  // namespace canvoy::tools
