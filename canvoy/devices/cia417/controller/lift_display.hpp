// What a lift shows on its panels: where the car is and goes, its lanterns, and what is special
// (CiA 417-4, 4.4.1). The display is a state; LiftIndications finds what the panels have not been
// told of it yet, one record after the other, so that nothing waits in a queue and the last state
// always comes through.
//
//     LiftIndications indications(1);
//     indications.display.floor = 7;
//     while (indications.waits()) send(indications.next());
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/controller/collective_control.hpp"
#include "canvoy/devices/cia417/controller/floor_set.hpp"
#include "canvoy/devices/cia417/panel/virtual_io.hpp"

namespace canvoy::cia417 {

/// A bit for each SpecialIndication.
using SpecialIndications = std::uint16_t;
constexpr SpecialIndications indication_bit(SpecialIndication indication) {
  return static_cast<SpecialIndications>(1U << static_cast<unsigned>(indication));
}

struct LiftDisplay {
  std::uint8_t floor = 0;  ///< of the position indicators; 0: they are cleared
  Direction direction = Direction::none;
  bool moving = false;
  std::uint8_t lantern_floor = 0;  ///< where hall lanterns are lit; 0: nowhere
  DoorMask lantern_doors = 0;
  Direction lantern = Direction::none;
  SpecialIndications specials = 0;

  friend constexpr bool operator==(const LiftDisplay&, const LiftDisplay&) = default;
};

class LiftIndications {
 public:
  /// `lift` is 1 to 8.
  explicit LiftIndications(unsigned lift) : lift_(lift_bit(lift)) {}

  /// What is to be shown. It may change at any time.
  LiftDisplay display;
  /// Rings at a landing and in the car: an event, of which the last one counts. Where no direction
  /// is known it rings for up.
  void ring(std::uint8_t floor, DoorMask doors, Direction direction);

  bool waits() const;
  /// What comes next, which is told with that; asked only while something waits.
  VirtualOutput next();
  /// Panels have come that may not have heard what is shown, and what is not any more. What rings
  /// does not ring again.
  void tell_again();
  /// It is shown on the panels of another lift, which know nothing of it.
  void set_lift(unsigned lift) {
    lift_ = lift_bit(lift);
    forget();
  }
  /// The panels know nothing any more.
  void forget();

 private:
  /// What the panels of the car, and those of all landings, were told.
  struct Told {
    bool knows_floor = false;
    bool knows_direction = false;
    std::uint8_t floor = 0;
    Direction direction = Direction::none;
    bool moving = false;
    SpecialIndications specials = 0;
    SpecialIndications were_on = 0;  ///< once
    SpecialIndications again = 0;    ///< to be told whether they have changed or not
  };
  struct Lantern {
    std::uint8_t floor = 0;
    DoorMask doors = 0;
    Direction direction = Direction::none;
    friend constexpr bool operator==(const Lantern&, const Lantern&) = default;
  };

  Lantern wanted_lantern() const;
  SpecialIndications untold_specials(unsigned place) const;
  VirtualOutput next_lantern();
  VirtualOutput next_lantern_out();
  VirtualOutput next_special(unsigned place);

  std::uint8_t lift_;
  Told told_[2];
  Lantern lantern_;
  FloorSet were_lit_;   ///< floors of which lanterns were lit once
  FloorSet out_again_;  ///< where they are told to be out
  Lantern ring_;
  bool rings_in_car_ = false;
};

}  // namespace canvoy::cia417
