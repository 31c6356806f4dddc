// Position, occupancy and delay of a simulated bus as GTFS-Realtime, from the messages on its
// network: an old network feeds present passenger information, by a file or by HTTP.
//
//     const std::unique_ptr<RealtimeOutlet> outlet = open_realtime(":8080", network);
//     outlet->tell(network);
#pragma once

#include <memory>
#include <string>

#include "canvoy/formats/gtfs/realtime.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::tools {

/// The present state, as far as the frames of its first car give it (bus_line::HeardBus); fields
/// without a source are omitted. Without a known stop there is no trip; without a stop and a
/// position, no vehicle. Delays are those of the present or next stop, and of all later ones
/// (bus_line::forecast()).
gtfs::RealtimeFeed realtime_of(bus_line::BusNetwork& network);

/// An outlet of the feed.
class RealtimeOutlet {
 public:
  RealtimeOutlet() = default;
  virtual ~RealtimeOutlet() = default;
  RealtimeOutlet(const RealtimeOutlet&) = delete;
  RealtimeOutlet& operator=(const RealtimeOutlet&) = delete;

  /// Replaces the previous content at once. Throws Failure.
  virtual void tell(bus_line::BusNetwork& network) = 0;
};

/// Opens an outlet: `:8080` serves it by HTTP at all addresses of this machine, `127.0.0.1:8080` or
/// `[::1]:8080` at this address; port 0 is a free one, reported on stderr. Anything else is a file.
/// Writes the present state at once. Throws Failure, and UsageError for an invalid port.
std::unique_ptr<RealtimeOutlet> open_realtime(const std::string& where,
                                              bus_line::BusNetwork& network);

}  // namespace canvoy::tools
