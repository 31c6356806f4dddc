// What the people of a building are going to do, and when; of one time, in the order in which it
// was planned.
//
//     CrowdAgenda agenda;
//     agenda.plan({.when = now + 500ms, .act = CrowdAct::look, .who = 3});
//     while (const std::optional<CrowdAgenda::Entry> due = agenda.take(now)) act(*due);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/call_buttons.hpp"

namespace canvoy::lift {

using PassengerId = std::size_t;

enum class CrowdAct : std::uint8_t {
  arrive,
  look,          // whether a button has to be pressed
  give_up,       // waiting
  release,       // a button
  release_door,  // the button for it
  out_of_way,    // the doorway is free
  through,       // a person is in, or out
  hand_away,     // that stopped a closing door
  try_again,     // to get through the door
  leave_stuck,   // a car that does not go on
};

class CrowdAgenda {
 public:
  static constexpr PassengerId nobody = ~std::size_t{0};

  struct Entry {
    Time when{};
    CrowdAct act = CrowdAct::arrive;
    PassengerId who = nobody;
    LiftNumber lift = 0;  ///< where it is done in a car, or at its door
    CallButton button{};  ///< of a release
  };

  void plan(const Entry& entry) { entries_.push({entry, order_++}); }
  Time deadline() const { return entries_.empty() ? never : entries_.top().entry.when; }
  /// The next that is due; nothing: none is.
  std::optional<Entry> take(Time now) {
    if (deadline() > now || entries_.empty()) return std::nullopt;
    const Entry entry = entries_.top().entry;
    entries_.pop();
    return entry;
  }

 private:
  struct Planned {
    Entry entry{};
    std::uint64_t order = 0;
    /// std::priority_queue puts the greatest on top.
    bool operator<(const Planned& other) const {
      return entry.when != other.entry.when ? entry.when > other.entry.when : order > other.order;
    }
  };

  std::priority_queue<Planned> entries_;
  std::uint64_t order_ = 0;
};

}  // namespace canvoy::lift
