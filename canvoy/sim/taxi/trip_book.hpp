// The trips of a shift as they were, as they were metered and as they were paid; and whether the
// income that the meter tells, and the receipts, agree with them.
//
//     TripBook trips(tariff, local_begin);
//     trips.begin(now, drive.metres(), 1s);
//     trips.step(now, drive.metres());              // while hired
//     const Trip& trip = trips.pay(now, shown, {});
//     trips.judge_totals(income);                   // in the end
#pragma once

#include <span>
#include <vector>

#include "canvoy/sim/taxi/fare_referee.hpp"

namespace canvoy::taxi {

class TripBook {
 public:
  /// How a passenger comes to know what to pay.
  struct Payment {
    bool is_read = true;  ///< without a display nobody knows: the driver lets them go
    double pocketed = 0;  ///< beside what the meter shows, in 0,001 of the currency unit
  };

  /// As FareReferee has it.
  TripBook(const cia447::Tariff& tariff, std::int64_t local_begin) : fares_(tariff, local_begin) {}
  TripBook(const TripBook&) = delete;
  TripBook& operator=(const TripBook&) = delete;

  void begin(Time now, double metres, Duration key_time) { fares_.hired(now, metres, key_time); }
  void step(Time now, double metres) { fares_.step(now, metres); }
  void stop(Time now, double metres) { fares_.stopped(now, metres); }
  /// A fault touches the trip that is under way: it is not judged.
  void disturb() { fares_.disturb(); }
  /// What the meter shows is paid; the trip is over.
  const Trip& pay(Time now, const cia447::TripData& shown, const Payment& payment);

  /// What the meter says that it has got in the shift, in 0,001 of the currency unit.
  void judge_totals(double income);
  /// What is read on the paper of the whole shift. `some_may_lack`: a fault may have cost receipts.
  void judge_receipts(std::span<const std::string> paper, bool some_may_lack);
  /// A receipt that should be there for so much is not.
  void miss_receipt(double paid) { receipts_error_ += paid; }

  const std::vector<Trip>& trips() const { return trips_; }
  double paid() const { return paid_; }  ///< in all, in 0,001 of the currency unit
  /// A fault has touched the trip that is under way.
  bool is_disturbed() const { return fares_.is_disturbed(); }
  /// The last one that was paid.
  bool last_was_disturbed() const { return !trips_.empty() && trips_.back().is_disturbed; }
  bool any_was_disturbed() const;

  // The worst of all trips that are judged, beyond their limits; 0: within them.
  double fare_excess() const;      ///< in 0,001 of the currency unit
  double distance_excess() const;  ///< in m
  double time_excess() const;      ///< in s
  double totals_error() const { return totals_error_; }
  double receipts_error() const { return receipts_error_; }

 private:
  template <class Excess>
  double worst(const Excess& excess) const;

  FareReferee fares_;
  std::vector<Trip> trips_;
  double paid_ = 0;
  double totals_error_ = 0;
  double receipts_error_ = 0;
};

}  // namespace canvoy::taxi
