// The trips of a shift: as they were, as they were metered and as they were paid; and whether the
// meter's income, and the receipts, agree with them.
//
//     TripBook trips(tariff, clock);
//     trips.begin(now, drive.metres(), 1s);
//     trips.step(now, drive.metres(), excuse);      // while driven
//     const Trip& trip = trips.pay(now, shown, {.is_by_card = true});
//     trips.meter_ended(shown.total);               // it is for hire again
//     trips.judge_income(income);                   // in the end
#pragma once

#include <span>
#include <vector>

#include "canvoy/worlds/taxi/invariant.hpp"
#include "canvoy/worlds/taxi/read_receipts.hpp"
#include "canvoy/worlds/taxi/read_slip.hpp"

namespace canvoy::taxi {

/// Payment of a trip.
struct Payment {
  double pocketed = 0;      ///< amount beyond the meter's, in 0.001 of the currency unit
  bool is_by_card = false;  ///< false: in cash
};

class TripBook {
 public:
  /// Takes the parameters of FareReferee.
  TripBook(const cia447::Tariff& tariff, const TownClock& clock) : fares_(tariff, clock) {}
  TripBook(const TripBook&) = delete;
  TripBook& operator=(const TripBook&) = delete;

  /// Begins a trip. The meter processes its keys within `key_time`.
  void begin(Time now, double metres, Duration key_time);
  /// Call it in each step while passengers are driven.
  void step(Time now, double metres, const TripExcuse& excuse) { fares_.step(now, metres, excuse); }
  /// Takes the fare on the display while driven. That of a trip that the meter has lost is another
  /// one.
  void look(Time now, double fare) {
    if (!has_lost_trip_) fares_.look(now, fare);
  }
  /// Names of the tariff's levels that may apply in the present trip; empty: they are unknown.
  std::optional<std::array<std::array<char, 2>, 2>> levels_about(Time now) const {
    if (!fares_.has_trip() || !fares_.trip().has_clock) return std::nullopt;
    return fares_.levels_about(now);
  }
  /// Ends the drive: the driver has pressed the key, and the meter has obeyed or never will.
  void stop(Time now, double metres) { fares_.step(now, metres, last_excuse_); }
  /// Marks the time of the meter's clock as unknown here.
  void lack_clock() { fares_.trip().has_clock = false; }
  /// Adds a service: the driver has pressed the key for it, and the meter has obeyed.
  void press_extra(unsigned kind) { fares_.press_extra(kind); }
  /// Withdraws services that were pressed by mistake.
  void clear_extras() { fares_.clear_extras(); }
  /// Sets the agreed price, which the meter has accepted, in 0.001 of the currency unit.
  void agree(double price) { fares_.agree(price); }
  /// Marks the services as unknown: they are pressed outside of the world.
  void knows_no_extras() { fares_.trip().knows_extras = false; }
  /// The meter has lost its power, which may end its trip.
  void lose_power();
  /// The loss of power has ended its trip, or may have.
  void lose_trip() { has_lost_trip_ = true; }
  /// What a fault may affect from this time on; everything, for a trip that the meter has lost.
  TripExcuse excuse(TripExcuse by_faults);
  /// Ends the trip with a payment: the amount of the meter, and the one beyond it in `payment`.
  /// Where the meter cannot be read, the amount is unknown: the driver lets the passengers go.
  const Trip& pay(Time now, const std::optional<cia447::TripData>& shown, const Payment& payment);
  /// The trip of the meter has ended with this total.
  void meter_ended(double total);
  /// Excuses a missing receipt of the last trip.
  void excuse_receipt();

  /// Compares the income of the shift that the meter reports, in 0.001 of the currency unit, with
  /// the totals of the trips that it has shown.
  void judge_income(double income) { compare_income(income, shown_income_); }
  /// Like judge_income(), but compares with what was paid: for a meter with an unknown display.
  void judge_income_by_payment(double income) { compare_income(income, paid_); }
  /// Judges the text on the paper of the whole shift.
  void judge_receipts(std::span<const std::string> paper, const PaperTruth& truth);
  /// Judges the text on the slip that the driver gets at signing off.
  void judge_slip(std::span<const std::string> paper, const PaperTruth& truth,
                  const DrivenShift& shift);
  /// Judges whether there is a receipt for this trip, with a text of any form.
  void judge_receipt(std::size_t trip, bool is_there);

  /// Trips that were paid.
  const std::vector<Trip>& trips() const { return trips_; }
  double paid() const { return paid_; }  ///< sum in 0.001 of the currency unit
  /// True if the meter has lost its power in the present trip, or before the last one was over.
  bool has_lost_power() const;
  /// True if the amount of each trip is known.
  bool all_were_read() const;

  /// Greatest excess of any trip beyond its limits; 0: all are within them. For an invariant of
  /// trips: in m, s, or 0.001 of the currency unit.
  double worst(InvariantKind kind) const;
  /// Number of trips, receipts, lines or totals that could have broken it.
  std::uint64_t judged(InvariantKind kind) const;

 private:
  /// Parts of the last trip that are still to be compared.
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
  std::vector<Trip> trips_;
  Open open_;
  TripExcuse last_excuse_;
  bool has_lost_trip_ = false;
  double paid_ = 0;
  double shown_income_ = 0;
  double totals_error_ = 0;
  std::uint64_t totals_judged_ = 0;
  ReceiptVerdict receipts_;
  SlipVerdict slip_;
};

}  // namespace canvoy::taxi
