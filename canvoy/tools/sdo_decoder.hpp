// What the messages of SDO say, in words (CiA 301, 7.2.4).
//
//     SdoDecoder decoder;
//     decoder.request(frame, 10);   // "read 6010h:00h"
//     decoder.response(frame, 10);  // "6010h:00h battery_temperature = 21.5 °C"
//
// It follows the default channel of each node, since the segments of a block transfer look like
// other messages; and it learns the profile of a node when somebody reads the node's device type
// (1000h).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/sdo.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

class SdoDecoder {
 public:
  /// Of a data frame from the client, and of one from the server; `node` is 1 to 127.
  std::string request(const Frame& frame, NodeId node);
  std::string response(const Frame& frame, NodeId node);

 private:
  /// Who sends the segments of a block now.
  enum class Sender : std::uint8_t { nobody, client, server };
  struct Channel {
    Sender sender = Sender::nobody;
    std::uint8_t last = 0;  ///< sequence number of the segment that said to be the last; 0: none
  };

  std::string block_segment(Channel& channel, const sdo::Message& message);
  std::string block_upload_request(Channel& channel, NodeId node, const sdo::Message& message);
  std::string block_download_request(NodeId node, const sdo::Message& message);
  std::string block_upload_response(NodeId node, const sdo::Message& message);
  std::string block_download_response(Channel& channel, NodeId node, const sdo::Message& message);
  std::string object(NodeId node, sdo::Multiplexer multiplexer) const;
  std::string object_with_value(NodeId node, sdo::Message message);
  std::string abort(Channel& channel, NodeId node, const sdo::Message& message) const;
  void learn_profile(NodeId node, sdo::Multiplexer multiplexer, std::uint32_t value);
  const Profile& profile_of(NodeId node) const;

  std::array<Channel, node_id_max + 1> channels_{};
  std::array<const Profile*, node_id_max + 1> profiles_{};
};

}  // namespace canvoy::tools
