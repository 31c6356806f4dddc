// Listens to LSS (CiA 305): which device is selected, by its identity or by Fastscan, and which
// node-ID it is given.
//
//     LssFollower lss;
//     if (const LssFollower::Device* device = lss.take(frame)) show(device->node,
//     device->identity);
#pragma once

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"

namespace canvoy::decoder {

class LssFollower {
 public:
  struct Device {
    NodeId node = 0;    ///< 0: none, or not known
    Identity identity;  ///< empty: all devices were switched at once, or nobody said
  };

  /// Takes a message of eight bytes, from 7E5h or 7E4h. Returns the selected device where the
  /// message has told something of it; until the next message. Null: it has not.
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
  Identity found_;                ///< by Fastscan
  lss::FastscanRequest scan_;     ///< the latest
  lss::Command asked_{};          ///< what the master asked last
  std::uint8_t wanted_node_ = 0;  ///< as it is to be configured
  std::uint8_t answers_ = 0;      ///< to what the master asked last
};

}  // namespace canvoy::decoder
