// Transports frames between a HostBus and the outside: SocketCAN, UDP multicast, or a test.
#pragma once

#include <bitset>
#include <cstdint>
#include <string_view>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::host {

/// Result of passing a frame to a carrier.
enum class SendResult : std::uint8_t {
  sent,  ///< accepted; it returns as an own frame once it has been on the bus
  busy,  ///< not accepted; try again after `writable`
  /// Not accepted: the interface is down, or there is no route; `state` or `writable` reports its
  /// return.
  refused,
};

/// Origin of a frame from the bus.
enum class Origin : std::uint8_t { elsewhere, own };

/// Set of 11-bit identifiers.
using AcceptedIds = std::bitset<Frame::id_max + 1>;

/// Counters of a carrier.
struct CarrierCounters {
  std::uint64_t overrun = 0;  ///< frames that the kernel dropped because they were read too slowly
  std::uint64_t malformed = 0;     ///< datagrams that are not a frame
  std::uint64_t fd = 0;            ///< CAN FD frames, ignored
  std::uint64_t error_frames = 0;  ///< of the CAN controller
  std::uint64_t foreign = 0;       ///< datagrams of other machines, ignored
};

/// Events that a carrier reports to its owner. Times are those of the kernel, as loop time.
struct CarrierEvents {
  /// A frame from the bus; own ones come back when they were sent.
  Callback<void(const Frame&, Time, Origin)> frame;
  /// State of the controller has changed.
  Callback<void(BusState, Time)> state;
  /// A send that was refused as busy may be tried again.
  Callback<void()> writable;
  Callback<void(const Error&)> trouble;  ///< once at its beginning, not for each frame
};

/// Base class of all carriers, since the user selects one at run time.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  /// Name of the bus in the notation of users and logs: can0, udp:239.74.163.2:43113.
  virtual std::string_view name() const = 0;
  /// Sends a frame. Never calls an event itself: events come from the loop.
  virtual SendResult send(const Frame& frame) = 0;
  /// Sets the filter: only frames with these identifiers, including own ones, and those with 29
  /// bits are needed; null: all. A carrier without a filter passes all.
  virtual void accept(const AcceptedIds* ids) { static_cast<void>(ids); }

  /// Sets the receiver of events, once.
  void connect(const CarrierEvents& events) { events_ = events; }
  /// Counters since the carrier was opened.
  const CarrierCounters& counters() const { return counters_; }

 protected:
  CarrierEvents events_;
  CarrierCounters counters_;
};

}  // namespace canvoy::host
