#include "canvoy/sim/taxi/trip_book.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/sim/taxi/read_receipts.hpp"

namespace canvoy::taxi {

const Trip& TripBook::pay(Time now, const cia447::TripData& shown, const Payment& payment) {
  Trip trip = fares_.paid(now, shown);
  if (!payment.is_read) trip.paid = 0;
  trip.paid += payment.pocketed;
  paid_ += trip.paid;
  return trips_.emplace_back(trip);
}

void TripBook::judge_totals(double income) {
  totals_error_ = std::abs(income - paid_);
}

void TripBook::judge_receipts(std::span<const std::string> paper, bool some_may_lack) {
  receipts_error_ = difference_of_receipts(paper, trips_, some_may_lack);
}

bool TripBook::any_was_disturbed() const {
  return std::ranges::any_of(trips_, &Trip::is_disturbed);
}

template <class Excess>
double TripBook::worst(const Excess& excess) const {
  double most = 0;
  for (const Trip& trip : trips_) {
    if (!trip.is_disturbed) most = std::max(most, (trip.*excess)());
  }
  return most;
}

double TripBook::fare_excess() const {
  return worst(&Trip::fare_excess);
}
double TripBook::distance_excess() const {
  return worst(&Trip::distance_excess);
}
double TripBook::time_excess() const {
  return worst(&Trip::time_excess);
}

}  // namespace canvoy::taxi
