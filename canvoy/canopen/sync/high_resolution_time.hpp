// The high-resolution time stamp: a clock of microseconds that the nodes of a network share by
// mapping it into PDOs (CiA 301, 7.5.2.16, object 1013h).
//
//     HighResolutionTime high_resolution_time(node, &sync);
#pragma once

#include <cstdint>

#include "canvoy/canopen/sync/sync.hpp"

namespace canvoy {

/// A clock. 1013h has its 32 bits of microseconds: in an SDO upload those of the moment, in a PDO
/// those of the last SYNC. The producer of the time maps it into a TPDO; the others map it into an
/// event-driven RPDO, which sets their clocks: the value is the time at the last SYNC (without
/// SYNC: of reception).
///
/// CiA 301 does not define the moment of the stamp; the SYNC is the moment that all nodes share.
class HighResolutionTime {
 public:
  /// Makes the clock; `sync` may be null.
  HighResolutionTime(Node& node, Sync* sync);
  HighResolutionTime(const HighResolutionTime&) = delete;
  HighResolutionTime& operator=(const HighResolutionTime&) = delete;

  /// Value of the clock at `at`; it overflows after 71 minutes.
  std::uint32_t clock(Time at) const {
    return static_cast<std::uint32_t>(at.time_since_epoch().count()) + ahead_;
  }

 private:
  void received(std::uint8_t counter);
  AbortCode before_read(const Entry& entry);
  void after_write(const Entry& entry, Source source);

  Node& node_;
  SyncListener listener_;
  static const AccessHandlers hook_calls;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Time stamped_at_{};
  std::uint32_t ahead_ = 0;  ///< lead over the time of the node
  bool stamped_ = false;
};

}  // namespace canvoy
