// Planned actions of the people of a building, by time; at one time, in the order in which they
// were planned.
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
#include "canvoy/worlds/lift/call_buttons.hpp"

namespace canvoy::lift {

/// Number of a person in the order of arrival, from 0.
using PassengerId = std::size_t;

/// What is to be done at a planned time.
enum class CrowdAct : std::uint8_t {
  arrive,
  look,          // at a button that may have to be pressed
  give_up,       // waiting
  release,       // a button
  release_door,  // the button for the door
  out_of_way,    // the doorway becomes free
  through,       // a person is in, or out
  hand_away,     // that stopped a closing door
  try_again,     // to get through the door
  leave_stuck,   // a car that does not go on
};

class CrowdAgenda {
 public:
  static constexpr PassengerId nobody = ~std::size_t{0};  ///< for actions of no person

  /// A planned action.
  struct Entry {
    Time when{};                      ///< when it is due
    CrowdAct act = CrowdAct::arrive;  ///< the action
    PassengerId who = nobody;         ///< the person who acts, if any
    LiftNumber lift = 0;              ///< for actions in a car, or at its door
    CallButton button{};              ///< button to release
  };

  /// Adds an action; it cannot be taken back. Logarithmic in the number of planned ones.
  void plan(const Entry& entry) { entries_.push({entry, order_++}); }
  /// Time of the earliest action; never: none is planned.
  Time deadline() const { return entries_.empty() ? never : entries_.top().entry.when; }
  /// The next entry that is due; empty: none is.
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
    /// std::priority_queue has the greatest on top.
    bool operator<(const Planned& other) const {
      return entry.when != other.entry.when ? entry.when > other.entry.when : order > other.order;
    }
  };

  std::priority_queue<Planned> entries_;
  std::uint64_t order_ = 0;
};

}  // namespace canvoy::lift
