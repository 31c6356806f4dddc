// The trips of a shift as they were, as they were metered and as they were paid; and whether the
// income that the meter tells, and the receipts, agree with them.
//
//     TripBook trips(tariff, local_begin);
//     trips.begin(now, drive.metres(), 1s);
//     trips.step(now, drive.metres(), excuse);      // while driven
//     const Trip& trip = trips.pay(now, shown, 0);
//     trips.meter_ended(shown.total);               // it is for hire again
//     trips.judge_income(income);                   // in the end
#pragma once

#include <span>
#include <vector>

#include "canvoy/sim/taxi/invariant.hpp"
#include "canvoy/sim/taxi/read_receipts.hpp"

namespace canvoy::taxi {

class TripBook {
 public:
  /// As FareReferee has it.
  TripBook(const cia447::Tariff& tariff, std::int64_t local_begin)
      : fares_(tariff, local_begin), local_begin_(local_begin) {}
  TripBook(const TripBook&) = delete;
  TripBook& operator=(const TripBook&) = delete;

  /// The meter works off its keys within `key_time`.
  void begin(Time now, double metres, Duration key_time);
  /// Each step while passengers are driven.
  void step(Time now, double metres, const TripExcuse& excuse) { fares_.step(now, metres, excuse); }
  /// The driver has pressed the key, and the meter has obeyed or never will.
  void stop(Time now, double metres) { fares_.step(now, metres, last_excuse_); }
  /// Nobody here knows what the clock shows that the meter asks.
  void lack_clock() { fares_.trip().has_clock = false; }
  /// The driver has pressed the key for it, and the meter has obeyed.
  void press_extra(double amount);
  /// Somebody else presses them.
  void knows_no_extras() { fares_.trip().knows_extras = false; }
  /// The meter has lost its power; its trip may end by that.
  void lose_power();
  /// By that it has lost its trip, or may have.
  void lose_trip() { has_lost_trip_ = true; }
  /// What a fault may cost from now on; and all that comes of a trip that the meter has lost.
  TripExcuse excuse(TripExcuse by_faults);
  /// What the meter shows is paid, and so much beside it, in 0,001 of the currency unit; the trip
  /// is over. Where nothing can be read nobody knows what to pay: the driver lets them go.
  const Trip& pay(Time now, const std::optional<cia447::TripData>& shown, double pocketed);
  /// The trip that the meter had has ended there with this total.
  void meter_ended(double total);
  /// The receipt of the last trip may lack.
  void excuse_receipt();

  /// What the meter says that it has got in the shift, in 0,001 of the currency unit, against the
  /// totals of the trips that it has shown.
  void judge_income(double income) { compare_income(income, shown_income_); }
  /// The same against what was paid: of a meter of which the display is not seen.
  void judge_income_by_payment(double income) { compare_income(income, paid_); }
  /// What is read on the paper of the whole shift.
  void judge_receipts(std::span<const std::string> paper);
  /// Whether there is a receipt for this trip, of somebody else's words.
  void judge_receipt(std::size_t trip, bool is_there);

  /// Those that were paid.
  const std::vector<Trip>& trips() const { return trips_; }
  double paid() const { return paid_; }  ///< in all, in 0,001 of the currency unit
  /// The meter has lost its power in the trip that is under way, or before the last one was over.
  bool has_lost_power() const;
  /// What each trip came to is known.
  bool all_were_read() const;

  /// The worst of all trips beyond their limits; 0: within them. Of the invariants that are about
  /// trips: in m, s, or 0,001 of the currency unit.
  double worst(InvariantKind kind) const;
  /// How many trips, receipts, lines or totals could have broken it.
  std::uint64_t judged(InvariantKind kind) const;

 private:
  /// What of the last trip is still to be compared.
  struct Open {
    std::optional<double> paid;
    std::optional<double> ended;
    bool is_known = true;
  };

  void compare_income(double income, double with);
  void settle();
  template <class Excess, class IsJudged>
  double worst_of(const Excess& excess, const IsJudged& is_judged) const;

  FareReferee fares_;
  std::int64_t local_begin_;
  std::vector<Trip> trips_;
  Open open_;
  TripExcuse last_excuse_;
  bool has_lost_trip_ = false;
  double paid_ = 0;
  double shown_income_ = 0;
  double totals_error_ = 0;
  std::uint64_t totals_judged_ = 0;
  ReceiptVerdict receipts_;
};

}  // namespace canvoy::taxi
