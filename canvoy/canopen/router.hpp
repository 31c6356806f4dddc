// Which service wants which CAN-ID: a sorted table, searched for every frame that a node is handed,
// and a few remembered places in it, so that what comes often is found at once.
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

class Router {
 public:
  using Receiver = Callback<void(const Frame&, Time)>;

  /// Remote frames are routed apart from data frames.
  enum class Kind : std::uint16_t { data = 0, remote = 0x800 };

  struct Route {
    std::uint16_t key;  ///< CAN-ID and Kind
    Receiver receiver;
  };

  /// `table` bounds the number of routes; it must outlive the router. Wanted CAN-IDs are told to
  /// `port`.
  constexpr Router(std::span<Route> table, const Port& port)
      : port_(port), table_(table.data()), capacity_(static_cast<std::uint16_t>(table.size())) {
    forget();
  }

  /// Several receivers may want one CAN-ID; all are called, in the order in which they were added.
  /// False where the table is full, or the CAN-ID is above 7FFh. Linear in the number of routes.
  bool add(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);
  /// Does nothing where there is no such route.
  void remove(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);

  /// For who wants frames without a route: tells the port, where no route wants the opposite.
  void filter(std::uint16_t can_id, bool is_wanted);

  /// For a service that listens to one CAN-ID at a time: `wanted` in place of `present`, 0 for
  /// none. False where there is no route left. On a small machine it needs none: see
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
  /// listen() would fail where it listens to nothing yet.
  bool has_room_to_listen() const { return is_small_machine || !full(); }

  bool full() const { return size_ == capacity_; }

  /// Hands the frame (11-bit, data or remote) to all who want it; false where nobody does. A
  /// receiver may add and remove routes: what it adds is not called for this frame any more, nor is
  /// what it removes. Constant time where the CAN-ID came before and no other took its place, else
  /// logarithmic.
  bool dispatch(const Frame& frame, Time now) {
    if constexpr (is_small_machine) return search_ != nullptr && search_(*this, frame, now);
    const std::uint16_t key = key_of(frame);
    // What comes twice in a row needs no table: the processor goes ahead on the guess that it does.
    if (last_.value->key == key) {
      last_.value->receiver(frame, now);
      return true;
    }
    // Most of what else comes is for others.
    if (!known_.value.has(key)) return false;
    const std::size_t position = remembered_.value[place_of(key)];
    const Route* route = table_ + position;
    if (position >= size_ || route->key != key) return search_and_dispatch(*this, frame, now);
    last_.value = route;
    route->receiver(frame, now);
    return true;
  }

 private:
  /// The routes that still want the frame under way. Dispatches nest, where a frame that a receiver
  /// sends is answered at once.
  struct Walk {
    Route* next;
    Route* end;
    Walk* outer;
  };

  /// Places that are remembered: a 32-bit processor searches its few routes faster than it saves
  /// memory for them.
  static constexpr std::size_t remembered_max = 32;
  static constexpr std::uint16_t nowhere = 0xFFFF;

  /// Keys that may have a route: a bit for 512 neighbours, in one line of the cache.
  struct KnownKeys {
    bool has(std::uint16_t key) const { return (words[key / 64 % 8] >> key % 64 & 1) != 0; }
    void add(std::uint16_t key) { words[key / 64 % 8] |= bit(key); }
    void remove(std::uint16_t key) { words[key / 64 % 8] &= ~bit(key); }
    static bool share(unsigned one, unsigned other) { return (one ^ other) % 512 == 0; }
    static std::uint64_t bit(std::uint16_t key) { return std::uint64_t{1} << key % 64; }

    std::array<std::uint64_t, 8> words{};
  };

  /// Different for the function codes of one node, and for neighbouring nodes of one function code.
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
  /// For small machines: set with the first route, so that nothing of it is linked where there is
  /// none.
  Search* search_ = nullptr;
  [[no_unique_address]] HostOnly<const Route*>
      last_;  ///< the remembered one that was dispatched last
  static const Route nobody;
  std::uint16_t capacity_;
  std::uint16_t size_ = 0;
  [[no_unique_address]] HostOnly<KnownKeys> known_;
  /// Positions of routes that are alone with their key.
  [[no_unique_address]] HostOnly<std::array<std::uint16_t, remembered_max>> remembered_;
};

}  // namespace canvoy
