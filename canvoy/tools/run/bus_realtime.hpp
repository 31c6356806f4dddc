// Where a simulated bus is, how full and how late, as GTFS-Realtime: an old network feeds today's
// passenger information, by a file or by HTTP, with what is to be heard on it.
//
//     const std::unique_ptr<RealtimeOutlet> outlet = open_realtime(":8080", network);
//     outlet->tell(network);
#pragma once

#include <memory>
#include <string>

#include "canvoy/formats/gtfs/realtime.hpp"
#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::tools {

/// Of this moment, as far as the frames of its first car tell it (bus::HeardBus): without who knows
/// a thing it says nothing of that thing. Where no stop is known there is no trip, where neither
/// that nor a position is, no vehicle. Delays are those of the stop at which it stands, or the next
/// one, and of all behind it, as bus::forecast() has them.
gtfs::RealtimeFeed realtime_of(bus::BusNetwork& network);

/// Where whoever asks finds it.
class RealtimeOutlet {
 public:
  RealtimeOutlet() = default;
  virtual ~RealtimeOutlet() = default;
  RealtimeOutlet(const RealtimeOutlet&) = delete;
  RealtimeOutlet& operator=(const RealtimeOutlet&) = delete;

  /// In place of what was told before, at once and whole. Throws Failure.
  virtual void tell(bus::BusNetwork& network) = 0;
};

/// `:8080` serves it at all addresses of this machine, `127.0.0.1:8080` or `[::1]:8080` at this
/// one, by HTTP; port 0 is a free one, and a line on stderr tells where. All else is a file. It is
/// told at once. Throws Failure, and UsageError of what is no port.
std::unique_ptr<RealtimeOutlet> open_realtime(const std::string& where, bus::BusNetwork& network);

}  // namespace canvoy::tools
