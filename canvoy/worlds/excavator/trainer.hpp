// A trainer on a second seat of an excavator, who takes the command over and gives it back, while
// the operator lets go: both watch the lamps that show which seat has the command.
//
//     Trainer trainer(own_panel, panel_of_the_operator, driver, moved);
//     trainer.step(now);            // each step
//     trainer.lessons();            // lessons in which both had what they asked for
//
// In a lesson the trainer slews to one side; then the operator pulls a stick without the command,
// which moves nothing; then the trainer slews back.
#pragma once

#include <functional>

#include "canvoy/worlds/excavator/excavator_operator.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class Trainer {
 public:
  /// All must outlive this object. `moved` is called when sticks or buttons of a seat have moved.
  Trainer(SeatPanel& own, SeatPanel& panel, ExcavatorOperator& driver, std::function<void()> moved)
      : own_(own), panel_(panel), driver_(driver), moved_(std::move(moved)) {}
  Trainer(const Trainer&) = delete;
  Trainer& operator=(const Trainer&) = delete;

  /// Call it each ExcavatorOperator::step_time.
  void step(Time now);
  /// Number of lessons that went as both wanted.
  unsigned lessons() const { return lessons_; }

 private:
  enum class Step : std::uint8_t {
    waits,
    comes_to_rest,  ///< the operator lets go
    takes,          ///< with a finger on the button
    slews,
    looks_on,  ///< while the operator pulls a stick
    slews_back,
    rests,
    gives,  ///< the operator's finger is on the button
  };

  void enter(Time now, Step step);
  void act(Time now, Duration passed);
  /// Holds the button for a moment, again and again, until the lamp of that seat is lit. True when
  /// it is; false for good if it never is.
  bool has_asked(SeatPanel& seat, std::size_t number, Duration passed);

  SeatPanel& own_;
  SeatPanel& panel_;
  ExcavatorOperator& driver_;
  std::function<void()> moved_;
  Step step_ = Step::waits;
  Time since_{};
  unsigned lessons_ = 0;
};

}  // namespace canvoy::excavator
