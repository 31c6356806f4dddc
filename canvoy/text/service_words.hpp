// Services by CAN-ID: that of the pre-defined connection set (CiA 301, 7.3.3), and all that a
// decoder may find in frames with a CAN-ID, whatever they carry.
//
//     for (const PossibleWords& words : possible_words(network, 0x185)) show(words.service);
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/decoder/network.hpp"
#include "canvoy/text/frame_decoder.hpp"

namespace canvoy::text {

/// Service and node that the CAN-ID gives in the pre-defined connection set; "other" if none.
FrameWords service_of(std::uint32_t id);

/// Name of the service of a PDO: `TPDO1`, or `PDO` if the number is unknown.
std::string pdo_service(const decoder::PdoPlan& plan);

/// Service and nodes as FrameWords has them.
struct PossibleWords {
  std::string service;  ///< FrameWords::service
  NodeId node = 0;      ///< FrameWords::node
  NodeId client = 0;    ///< FrameWords::client
};

/// What FrameDecoder::decode() may make of frames, data or remote, with this CAN-ID of 11 bits, as
/// long as the network learns nothing.
std::vector<PossibleWords> possible_words(const decoder::Network& network, std::uint32_t id);

}  // namespace canvoy::text
