// Tampering with a taxi: what is done to meter, car, clock and bus, and whether it is found out, by
// the records of the meter or by what passengers pay.
//
//     Tampering tampering(car);
//     tampering.attach_stranger();                       // before the world runs
//     tampering.set(FaultKind::extra_pulses, true);
//     tampering.recorded(entry);                         // by the meter
//     tampering.look(now, passengers_are_cheated);       // each step
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/worlds/taxi/fault.hpp"
#include "canvoy/worlds/taxi/taxi_car.hpp"

namespace canvoy::taxi {

/// Judges whether acts of tampering are found.
class TamperWatch {
 public:
  /// Time after which an act counts as not found.
  static constexpr Duration found_within = 1h;

  /// An act begins.
  void begins(FaultKind kind, Time now) { acts_.push_back({.kind = kind, .begin = now}); }
  /// The meter records an entry: it finds the acts that the entry can be about.
  void recorded(const cia447::AuditEntry& entry);
  /// Passengers see that something is wrong with what they pay: this finds all present acts.
  void passengers_see();

  /// Number of acts that began.
  std::uint64_t acts() const { return acts_.size(); }
  /// Number of acts that were found, or should have been.
  std::uint64_t judged(Time now) const;
  /// Number of acts that should have been found, and were not.
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
  /// `car` must outlive this object, and this object the world's last run.
  explicit Tampering(TaxiCar& car) : car_(car) {}
  Tampering(const Tampering&) = delete;
  Tampering& operator=(const Tampering&) = delete;

  /// Adds a foreign device to the bus, which is silent at first.
  void attach_stranger();
  /// Begins or ends an act; ignores faults that are no tampering.
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
