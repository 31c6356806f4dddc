// What the messages of SDO say, in words (CiA 301, 7.2.4).
//
//     SdoDecoder decoder(network);
//     decoder.request(frame, 10);   // "read 6010h:00h"
//     decoder.response(frame, 10);  // "6010h:00h battery_temperature = 21.5 °C"
//
// It follows the channels of each node, since the segments of a block transfer look like
// other messages.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/sdo.hpp"
#include "canvoy/decoder/network.hpp"

namespace canvoy::tools {

class SdoDecoder {
 public:
  /// `network` tells the profiles of the nodes, and must outlive this.
  explicit SdoDecoder(const decoder::Network& network) : network_(&network) {}

  /// Of a data frame from the client, and of one from the server; `node` is 1 to 127,
  /// the server; `channel` the CAN-ID of the requests, 0 that of the default channel.
  std::string request(const Frame& frame, NodeId node, std::uint16_t channel = 0);
  std::string response(const Frame& frame, NodeId node, std::uint16_t channel = 0);

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

  const decoder::Network* network_;
  Channel& channel_of(NodeId node, std::uint16_t channel) {
    return channels_.at(channel == 0 ? can_id::sdo_request + node : channel);
  }

  std::array<Channel, 0x800> channels_{};  ///< by the CAN-ID of their requests
};

}  // namespace canvoy::tools
