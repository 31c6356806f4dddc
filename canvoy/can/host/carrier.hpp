// What carries frames between a HostBus and the world: SocketCAN, UDP multicast, or something in a
// test.
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

/// What became of a frame that was given to a carrier.
enum class SendResult : std::uint8_t {
  sent,     ///< taken; it comes back as an own frame once it has been on the bus
  busy,     ///< not taken; give it again after `writable`
  refused,  ///< not taken: the interface is down, or there is no route; `state` or `writable` comes
            ///< when it is back
};

/// Where a frame that came from the bus was sent.
enum class Origin : std::uint8_t { elsewhere, own };

/// 11-bit identifiers.
using AcceptedIds = std::bitset<Frame::id_max + 1>;

/// What a carrier alone can count.
struct CarrierCounters {
  std::uint64_t overrun = 0;       ///< frames that the kernel dropped because we read too slowly
  std::uint64_t malformed = 0;     ///< datagrams that are no frame
  std::uint64_t fd = 0;            ///< CAN FD frames, ignored
  std::uint64_t error_frames = 0;  ///< of the CAN controller
  std::uint64_t foreign = 0;       ///< datagrams of other machines, ignored
};

/// What a carrier tells its owner. Times are those of the kernel, as loop time.
struct CarrierEvents {
  Callback<void(const Frame&, Time, Origin)> frame;
  Callback<void(BusState, Time)> state;
  Callback<void()> writable;
  Callback<void(const Error&)> trouble;  ///< once when it begins, not for each frame
};

/// The base of all carriers: which one it is, the user decides at run time.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  /// The bus as the user writes it and as logs show it: can0, udp:239.74.163.2:43113.
  virtual std::string_view name() const = 0;
  /// Calls no event itself: what it learns, it tells from the loop.
  virtual SendResult send(const Frame& frame) = 0;
  /// From here on only frames with these identifiers need be handed on, own ones among them, and
  /// those with 29 bits; null: all. A carrier that has no filter hands on all.
  virtual void accept(const AcceptedIds* ids) { static_cast<void>(ids); }

  void connect(const CarrierEvents& events) { events_ = events; }
  const CarrierCounters& counters() const { return counters_; }

 protected:
  CarrierEvents events_;
  CarrierCounters counters_;
};

}  // namespace canvoy::host
