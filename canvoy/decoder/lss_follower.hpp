// Follows LSS: which device is selected, by its identity or by Fastscan, and which node-ID it
// receives (CiA 305).
//
//     LssFollower lss;
//     if (const LssFollower::Device* device = lss.take(frame)) show(device->node,
//     device->identity);
#pragma once

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"

namespace canvoy::decoder {

class LssFollower {
 public:
  /// The device that a message is about.
  struct Device {
    NodeId node = 0;    ///< 0: none, or unknown
    Identity identity;  ///< empty: all devices were switched at once, or none was identified
  };

  /// Takes a message of eight bytes from 7E5h or 7E4h. Returns the selected device if the message
  /// reveals something about it, valid until the next message; else null.
  const Device* take(const Frame& frame);

 private:
  const Device* request(const Frame& frame);
  const Device* response(const Frame& frame);
  const Device* scanned();
  const Device* configured(const Frame& frame);
  const Device* inquired(std::size_t part, std::uint32_t value);
  void scan(const Frame& frame);

  Device selected_;
  Identity asked_for_;            ///< by the four messages that select a device
  Identity found_;                ///< found by Fastscan
  lss::FastscanRequest scan_;     ///< the latest
  lss::Command asked_{};          ///< the last request of the master
  std::uint8_t wanted_node_ = 0;  ///< to be configured
  std::uint8_t answers_ = 0;      ///< number of answers to the last request of the master
};

}  // namespace canvoy::decoder
