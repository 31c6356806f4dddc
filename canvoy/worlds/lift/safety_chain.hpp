// The safety chain of a lift as a plant: contacts in series, without which motor and brake have no
// current, whatever drive and controller command (EN 81-20, 5.11.2).
//
//     SafetyChain chain({.rated_speed_m_s = 1.6});
//     chain.look({.from_floor_m = 1.2, .speed_m_s = 1.6, .doors_are_locked = false});
//     car.cut(!chain.is_closed());
//     if (chain.wants_gear()) car.arrest();
//     chain.reset_by_hand();
//
// Doors may be unlocked in the door zone at no more than the speed of levelling. What an overspeed
// governor or an unintended movement of the car has opened stays open until it is reset by hand;
// what the self-test of the brake has opened, until a technician resets it (5.6.7.3).
#pragma once

#include <cstdint>

namespace canvoy::lift {

/// Design of the chain and of its car.
struct SafetyChainDesign {
  double rated_speed_m_s = 1.6;  ///< the governor trips above it
  /// Share of the rated speed at which the governor trips, above the 1.15 at which units report
  /// overspeed.
  double governor_share = 1.2;
  double door_zone_m = 0.2;          ///< to both sides of a floor
  double levelling_speed_m_s = 0.3;  ///< EN 81-20, 5.12.1.4
  double final_limit_m = 0.1;        ///< beyond the last floors (5.12.2)
  bool is_bridged = false;           ///< always closed, which is forbidden
};

/// Inputs of its contacts and switches.
struct SafetySight {
  double from_floor_m = 0;       ///< to the nearest one
  double beyond_m = 0;           ///< the lowest or the highest one
  double speed_m_s = 0;          ///< up or down
  bool doors_are_locked = true;  ///< each lock, and each contact
  bool is_a_door_open = false;   ///< as its contact reports
  bool gear_is_caught = false;   ///< the car hangs in its safety gear
  bool brake_slips = false;      ///< at a self-test since the last reset
};

class SafetyChain {
 public:
  /// The part of the chain that has opened it.
  enum class Trip : std::uint8_t {
    none,
    overspeed,            ///< of the governor
    unintended_movement,  ///< out of the door zone with an open door
    final_limit,          ///< of the travel
    gear,                 ///< the safety gear was caught in another way
    brake,                ///< it slipped at its self-test
  };

  /// A closed chain.
  explicit SafetyChain(const SafetyChainDesign& design = {}) : design_(design) {}

  /// Call it at each change, and often while the car moves.
  void look(const SafetySight& sight);
  /// True if motor and brake can have current: no part has tripped, and no door is unlocked outside
  /// of the levelling in its zone; always true of a bridged chain.
  bool is_closed() const {
    return design_.is_bridged || (trip() == Trip::none && !doors_are_free_);
  }
  /// The part that must be reset by hand; none: only its doors open it.
  Trip trip() const { return trip_ == Trip::none && brake_slips_ ? Trip::brake : trip_; }
  /// True if the governor, or the detection of unintended movements, has the safety gear catch the
  /// car.
  bool wants_gear() const {
    return (trip_ == Trip::overspeed || trip_ == Trip::unintended_movement) && !design_.is_bridged;
  }
  /// Resets all but the brake, of which a technician must find the cause.
  void reset_by_hand() { trip_ = Trip::none; }
  /// Resets what the self-test of the brake has opened.
  void reset_brake() { brake_slips_ = false; }

 private:
  SafetyChainDesign design_;
  Trip trip_ = Trip::none;
  bool brake_slips_ = false;
  bool doors_are_free_ = false;
  bool was_in_zone_ = false;
  bool was_beyond_ = false;  ///< a final limit: after a reset by hand the car may come back
};

}  // namespace canvoy::lift
