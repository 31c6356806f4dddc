#include "canvoy/worlds/taxi/trip_book.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::taxi {

namespace {

bool can_be_read(const Trip& trip) {
  return trip.is_read;
}
bool has_tariff(const Trip& trip) {
  return trip.is_read && trip.has_clock;
}

}  // namespace

void TripBook::begin(Time now, double metres, Duration key_time) {
  fares_.hired(now, metres, key_time);
  open_ = {};
  last_excuse_ = {};
  has_lost_trip_ = false;
}

void TripBook::lose_power() {
  if (fares_.has_trip()) {
    fares_.trip().has_lost_power = true;
  } else if (!trips_.empty() && !open_.ended) {
    trips_.back().has_lost_power = true;
  }
}

TripExcuse TripBook::excuse(TripExcuse by_faults) {
  if (has_lost_trip_) by_faults = {.fare = true, .distance = true, .duration = true};
  last_excuse_ = by_faults;
  return by_faults;
}

const Trip& TripBook::pay(Time now, const std::optional<cia447::TripData>& shown,
                          const Payment& payment) {
  Trip trip = fares_.paid(now, shown);
  trip.pocketed = payment.pocketed;
  trip.is_by_card = payment.is_by_card;
  trip.paid += payment.pocketed;
  paid_ += trip.paid;
  open_.paid = trip.paid;
  open_.is_known = trip.is_read && !trip.has_lost_power;
  settle();
  return trips_.emplace_back(trip);
}

void TripBook::meter_ended(double total) {
  shown_income_ += total;
  open_.ended = total;
  settle();
}

/// In each trip, the payment is the amount of the meter.
void TripBook::settle() {
  if (!open_.paid || !open_.ended) return;
  if (open_.is_known) {
    totals_error_ += std::abs(*open_.paid - *open_.ended);
    ++totals_judged_;
  }
  open_.paid.reset();
}

void TripBook::excuse_receipt() {
  if (!trips_.empty()) trips_.back().may_lack_receipt = true;
}

void TripBook::compare_income(double income, double with) {
  totals_error_ += std::abs(income - with);
  ++totals_judged_;
}

void TripBook::judge_receipts(std::span<const std::string> paper, const PaperTruth& truth) {
  receipts_ = taxi::judge_receipts(paper, trips_, truth);
}

void TripBook::judge_slip(std::span<const std::string> paper, const PaperTruth& truth,
                          const DrivenShift& shift) {
  slip_ = taxi::judge_slip(paper, trips_, truth, shift);
}

void TripBook::judge_receipt(std::size_t trip, bool is_there) {
  if (trips_.at(trip).may_lack_receipt) return;
  ++receipts_.receipts;
  if (!is_there) receipts_.difference += trips_.at(trip).paid;
}

bool TripBook::has_lost_power() const {
  if (fares_.has_trip()) return fares_.trip().has_lost_power;
  return !trips_.empty() && trips_.back().has_lost_power;
}

bool TripBook::all_were_read() const {
  return std::ranges::all_of(trips_, can_be_read);
}

template <class Excess, class IsJudged>
double TripBook::worst_of(const Excess& excess, const IsJudged& is_judged) const {
  double most = 0;
  for (const Trip& trip : trips_) {
    if (is_judged(trip)) most = std::max(most, (trip.*excess)());
  }
  return most;
}

double TripBook::worst(InvariantKind kind) const {
  switch (kind) {
    case InvariantKind::fare:
      return worst_of(&Trip::fare_excess, has_tariff);
    case InvariantKind::distance:
      return worst_of(&Trip::distance_excess, can_be_read);
    case InvariantKind::duration:
      return worst_of(&Trip::time_excess, can_be_read);
    case InvariantKind::waiting:
      return worst_of(&Trip::waiting_excess, has_tariff);
    case InvariantKind::total:
      return worst_of(&Trip::total_error, can_be_read);
    case InvariantKind::totals:
      return totals_error_;
    case InvariantKind::receipts:
      return receipts_.difference;
    case InvariantKind::receipt_lines:
      return static_cast<double>(receipts_.wrong_lines);
    case InvariantKind::shift_slip:
      return static_cast<double>(slip_.wrong_lines);
    default:
      return 0;
  }
}

std::uint64_t TripBook::judged(InvariantKind kind) const {
  switch (kind) {
    case InvariantKind::fare:
    case InvariantKind::waiting:
      return static_cast<std::uint64_t>(std::ranges::count_if(trips_, has_tariff));
    case InvariantKind::distance:
    case InvariantKind::duration:
    case InvariantKind::total:
      return static_cast<std::uint64_t>(std::ranges::count_if(trips_, can_be_read));
    case InvariantKind::totals:
      return totals_judged_;
    case InvariantKind::receipts:
      return receipts_.receipts;
    case InvariantKind::receipt_lines:
      return receipts_.lines;
    case InvariantKind::shift_slip:
      return slip_.lines;
    default:
      return 0;
  }
}

}  // namespace canvoy::taxi
