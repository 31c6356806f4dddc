// The contents of a lift's panels: position and direction of the car, its lanterns, and special
// indications (CiA 417-4, 4.4.1). The display is a state. LiftIndications finds what the panels
// have not received yet, one record after the other, so that there is no queue and the last state
// always arrives.
//
//     LiftIndications indications(1);
//     indications.display.floor = 7;
//     while (indications.waits()) send(indications.next());
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/lift/collective_control.hpp"
#include "canvoy/devices/cia417/lift/floor_set.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// A bit for each SpecialIndication.
using SpecialIndications = std::uint16_t;
/// Bit of an indication in a set of them.
constexpr SpecialIndications indication_bit(SpecialIndication indication) {
  return static_cast<SpecialIndications>(1U << static_cast<unsigned>(indication));
}

struct LiftDisplay {
  std::uint8_t floor = 0;                 ///< of the position indicators; 0: cleared
  Direction direction = Direction::none;  ///< of the direction indicators
  bool moving = false;                    ///< the arrow moves
  std::uint8_t lantern_floor = 0;         ///< where hall lanterns are lit; 0: none
  DoorMask lantern_doors = 0;             ///< doors with a lit lantern
  Direction lantern = Direction::none;    ///< direction that lanterns show
  SpecialIndications specials = 0;        ///< bits of indication_bit()

  friend constexpr bool operator==(const LiftDisplay&, const LiftDisplay&) = default;
};

/// What the panels show, and what they have received of it.
class LiftIndications {
 public:
  /// `lift` is 1 to 8.
  explicit LiftIndications(unsigned lift) : lift_(lift_bit(lift)) {}

  /// The contents to show. They may change at any time.
  LiftDisplay display;
  /// Rings at a landing and in the car: an event, of which the last one counts. Without a known
  /// direction it rings for up.
  void ring(std::uint8_t floor, DoorMask doors, Direction direction);

  /// True if a record has to be sent.
  bool waits() const;
  /// Returns the next record, and marks it as sent. Call it only while one is waiting.
  VirtualOutput next();
  /// Sends all that is shown, and the end of all that has ended, since panels have come that may
  /// not have received it. Gongs do not ring again.
  void report_again();
  /// Changes to the panels of another lift, which have received nothing.
  void set_lift(unsigned lift) {
    lift_ = lift_bit(lift);
    forget();
  }
  /// Starts with panels that have received nothing.
  void forget();

 private:
  /// Contents that the panels of the car, and those of all landings, have received.
  struct Told {
    bool knows_floor = false;
    bool knows_direction = false;
    std::uint8_t floor = 0;
    Direction direction = Direction::none;
    bool moving = false;
    SpecialIndications specials = 0;
    SpecialIndications were_on = 0;  ///< at some time
    SpecialIndications again = 0;    ///< to send even if unchanged
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
  FloorSet were_lit_;   ///< floors with lanterns that were lit at some time
  FloorSet out_again_;  ///< floors where lanterns have to be switched off
  Lantern ring_;
  bool rings_in_car_ = false;
};

}  // namespace canvoy::cia417
