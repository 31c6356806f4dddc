// Keeps what has happened in a world, oldest first: its own events, and those heard on its buses.
// Each object that notes events holds a reference to the log.
//
//     EventLog<TaxiEvent> events;
//     events.note(now, AlarmPressed{});
//     BusWatch watch(bus, [&](Time now, const BusEvent& heard) { events.hear(now, heard); });
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "canvoy/sim/event.hpp"

namespace canvoy {

/// `Event` has a time, and a variant of all that can happen.
template <class Event>
class EventLog {
 public:
  EventLog() = default;
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  /// Notes an event of the world. Times are expected in order.
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }
  /// Notes an event that was heard on a bus.
  void hear(Time now, const BusEvent& heard) {
    std::visit([&](const auto& seen) { note(now, seen); }, heard);
  }
  /// All events so far, oldest first; valid until the next note.
  std::span<const Event> all() const { return events_; }

 private:
  std::vector<Event> events_;
};

}  // namespace canvoy
