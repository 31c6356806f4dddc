// Which service wants which CAN-ID: a sorted table, searched for every frame that a node is handed.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

class Router {
 public:
  using Receiver = Callback<void(const Frame&, Time)>;

  /// Remote frames are routed apart from data frames.
  enum class Kind : std::uint16_t { data = 0, remote = 0x800 };

  struct Route {
    std::uint16_t key = 0;     ///< CAN-ID and Kind
    std::uint32_t serial = 0;  ///< routes of one key stand in the order of their serials
    Receiver receiver;
  };

  /// `table` bounds the number of routes; it must outlive the router. Wanted CAN-IDs are told to
  /// `port`.
  Router(std::span<Route> table, const Port& port) : table_(table), port_(port) {}

  /// Several receivers may want one CAN-ID; all are called, in the order in which they were added.
  /// False where the table is full, or the CAN-ID is above 7FFh. Linear in the number of routes.
  bool add(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);
  /// Does nothing where there is no such route.
  void remove(std::uint16_t can_id, Receiver receiver, Kind kind = Kind::data);

  bool full() const { return size_ == table_.size(); }

  /// Hands the frame (11-bit, data or remote) to all who want it; false where nobody does. A
  /// receiver may add and remove routes: what it adds is not called for this frame any more, nor is
  /// what it removes. Logarithmic.
  bool dispatch(const Frame& frame, Time now);

 private:
  Route* lower_bound(std::uint16_t key) const;
  const Route* after(std::uint16_t key, std::uint32_t serial) const;
  bool wanted(std::uint16_t can_id) const;

  std::span<Route> table_;
  const Port& port_;
  std::size_t size_ = 0;
  std::uint32_t generation_ = 0;  ///< counts changes, so that a dispatch notices one under its feet
};

}  // namespace canvoy
