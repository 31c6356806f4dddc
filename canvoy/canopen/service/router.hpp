// Maps CAN-IDs to services: a sorted table, searched for every frame that a node receives, and a
// few remembered positions in it, so that frequent CAN-IDs are found at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/machine.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Routes of one node. It keeps their memory sorted, and tells the port which CAN-IDs it must let
/// pass.
class Router {
 public:
  /// Takes a frame, and the time of its arrival.
  using Receiver = Callback<void(const Frame&, Time)>;

  /// Kind of frames: remote frames have separate routes.
  enum class Kind : std::uint16_t { data = 0, remote = 0x800 };

  /// One CAN-ID and its receiver.
  struct Route {
    std::uint16_t key;  ///< CAN-ID and Kind
    Receiver receiver;  ///< called for each frame with the key
  };

  /// Makes a router. The size of `table` limits the number of routes; it must outlive the router.
  /// Needed CAN-IDs are reported to `port`.
  constexpr Router(std::span<Route> table, const Port& port)
      : port_(port), table_(table.data()), capacity_(static_cast<std::uint16_t>(table.size())) {
    forget();
  }

  /// Adds a route. Several receivers may take one CAN-ID; all are called, in the order in which
  /// they were added. False if the table is full, or the CAN-ID is above 7FFh. Linear in the number
  /// of routes.
  bool add(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);
  /// Removes a route; no effect if there is none.
  void remove(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);

  /// For services that take frames without a route: sets the filter of the port, unless a route
  /// needs the opposite.
  void filter(std::uint16_t can_id, bool is_wanted);

  /// For a service that listens to one CAN-ID at a time: replaces `present` by `wanted`, 0 for
  /// none. False if there is no free route. On a small machine it needs none: see
  /// ServiceEvent::frame_came.
  template <auto receive, class Object>
  bool listen(Object& object, std::uint16_t present, std::uint16_t wanted) {
    if constexpr (is_small_machine) {
      refilter(present, wanted);
      return wanted != 0;
    }
    const auto receiver = Receiver::template to<receive>(object);
    if (present != 0) remove(present, receiver);
    return wanted != 0 && add(wanted, receiver);
  }
  /// True if listen() would succeed for a service that does not listen yet.
  bool has_room_to_listen() const { return is_small_machine || !full(); }

  /// True if add() would fail.
  bool full() const { return size_ == capacity_; }

  /// Hands a frame (11-bit, data or remote) to all its receivers; false if there is none. A
  /// receiver may add and remove routes: added ones are not called for this frame, nor are removed
  /// ones. Constant time if the CAN-ID came before and is still remembered, otherwise logarithmic.
  bool dispatch(const Frame& frame, Time now) {
    if constexpr (is_small_machine) return search_ != nullptr && search_(*this, frame, now);
    const std::uint16_t key = key_of(frame);
    // A CAN-ID that comes twice in a row needs no table: the processor predicts this branch.
    if (last_.value->key == key) {
      last_.value->receiver(frame, now);
      return true;
    }
    // Most other frames are for other nodes.
    if (!known_.value.has(key)) return false;
    const std::size_t position = remembered_.value[place_of(key)];
    const Route* route = table_ + position;
    if (position >= size_ || route->key != key) return search_and_dispatch(*this, frame, now);
    last_.value = route;
    route->receiver(frame, now);
    return true;
  }

 private:
  /// Remaining routes for the frame under way. Dispatches nest if a frame that a receiver sends is
  /// answered at once.
  struct Walk {
    Route* next;
    Route* end;
    Walk* outer;
  };

  /// Number of remembered positions. A 32-bit processor needs none: it searches its few routes
  /// quickly, and saves the memory.
  static constexpr std::size_t remembered_max = 32;
  static constexpr std::uint16_t nowhere = 0xFFFF;

  /// Keys that may have a route: one bit for each 512 neighbours, in one cache line.
  struct KnownKeys {
    bool has(std::uint16_t key) const { return (words[key / 64 % 8] >> key % 64 & 1) != 0; }
    void add(std::uint16_t key) { words[key / 64 % 8] |= bit(key); }
    void remove(std::uint16_t key) { words[key / 64 % 8] &= ~bit(key); }
    static bool share(unsigned one, unsigned other) { return (one ^ other) % 512 == 0; }
    static std::uint64_t bit(std::uint16_t key) { return std::uint64_t{1} << key % 64; }

    std::array<std::uint64_t, 8> words{};
  };

  /// Position of a key: differs for the function codes of one node, and for neighbouring nodes with
  /// one function code.
  static std::size_t place_of(std::uint16_t key) {
    return static_cast<std::size_t>(key ^ key >> 7) % 32;
  }
  static std::uint16_t key_of(const Frame& frame) {
    const Kind kind = frame.is_remote() ? Kind::remote : Kind::data;
    return static_cast<std::uint16_t>(frame.id | static_cast<unsigned>(kind));
  }
  using Search = bool(Router&, const Frame&, Time now);
  [[gnu::noinline]] static Search search_and_dispatch;
  constexpr void forget() {
    if constexpr (is_small_machine) return;
    remembered_.value.fill(nowhere);
    last_.value = &nobody;
  }
  Route* lower_bound(unsigned key) const;
  void follow(const Route* place, int step);
  void refilter(std::uint16_t present, std::uint16_t wanted);

  const Port& port_;
  Route* table_;
  Walk* walks_ = nullptr;
  /// For small machines: set with the first route, so that a program without routes links none of
  /// it.
  Search* search_ = nullptr;
  [[no_unique_address]] HostOnly<const Route*>
      /// Remembered key that was dispatched last.
      last_;
  static const Route nobody;
  std::uint16_t capacity_;
  std::uint16_t size_ = 0;
  [[no_unique_address]] HostOnly<KnownKeys> known_;
  /// Positions of routes with a unique key.
  [[no_unique_address]] HostOnly<std::array<std::uint16_t, remembered_max>> remembered_;
};

}  // namespace canvoy
