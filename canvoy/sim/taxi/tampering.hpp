// Somebody who cheats with a taxi: what he does to meter, car, clock and bus, and whether he is
// found out, by what the meter records or by what passengers pay.
//
//     Tampering tampering(car);
//     tampering.attach_stranger();                       // before the world runs
//     tampering.set(FaultKind::extra_pulses, true);
//     tampering.recorded(entry);                         // by the meter
//     tampering.look(now, passengers_are_cheated);       // each step
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/sim/taxi/fault.hpp"
#include "canvoy/sim/taxi/taxi_car.hpp"

namespace canvoy::taxi {

/// Whether acts of tampering are found.
class TamperWatch {
 public:
  /// Whoever is not found in this time is not found.
  static constexpr Duration found_within = 1h;

  /// An act begins.
  void begins(FaultKind kind, Time now) { acts_.push_back({.kind = kind, .begin = now}); }
  /// The meter records it: that finds what it can be about.
  void recorded(const cia447::AuditEntry& entry);
  /// Passengers see that something is wrong with what they pay: that finds all that is there.
  void passengers_see();

  /// All that began.
  std::uint64_t acts() const { return acts_.size(); }
  /// That were found, or should have been.
  std::uint64_t judged(Time now) const;
  /// That should have been, and were not.
  std::uint64_t missed(Time now) const;

 private:
  struct Act {
    FaultKind kind{};  ///< what is done
    Time begin{};
    bool is_found = false;  ///< by the meter or by passengers
  };
  std::vector<Act> acts_;
};

class Tampering {
 public:
  /// `car` must outlive this, and this the world's last run.
  explicit Tampering(TaxiCar& car) : car_(car) {}
  Tampering(const Tampering&) = delete;
  Tampering& operator=(const Tampering&) = delete;

  /// Somebody who has a place on the bus, and says nothing yet.
  void attach_stranger();
  /// What is no tampering is left alone.
  void set(FaultKind kind, bool is_present);

 private:
  void write_on(Time now);
  void write(std::uint32_t can_id);

  TaxiCar& car_;
  ControllerId stranger_ = no_controller;
  bool writes_ = false;
  std::uint16_t count_ = 0;
};

}  // namespace canvoy::taxi
