// A taximeter that is real: what it says of its state, what one of our devices asks it of trip and
// shift, and what it writes on our paper, is what the driver and his passengers know.
//
//     RealMeter real(car, trips);
//     real.says(cia447::Taximeter::hired);
//     real.read(now);                   // each step: what is shown is what was read last
//     real.ask_for_totals();            // when the shift is over
#pragma once

#include <array>
#include <optional>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/taximeter/trip_reader.hpp"
#include "canvoy/sim/taxi/taxi_car.hpp"
#include "canvoy/sim/taxi/trip_book.hpp"

namespace canvoy::taxi {

class RealMeter {
 public:
  /// All must outlive this. Where the meter is played, it does nothing.
  RealMeter(TaxiCar& car, TripBook& trips);
  RealMeter(const RealMeter&) = delete;
  RealMeter& operator=(const RealMeter&) = delete;

  /// Somebody has pressed a key of it.
  void says(cia447::Taximeter state);
  /// Each second, while there are passengers.
  void read(Time now);
  /// Since it is in its state it has told a trip.
  bool has_told_trip() const { return has_told_trip_; }
  void trip_begins() { lines_before_trip_ = car_.paper().lines().size(); }
  /// It prints by itself, in its own time: is there a receipt for what was paid last?
  void expect_receipt();
  /// What it has got in the shift. Nobody reads trips any more.
  void ask_for_totals();

 private:
  void device_is_made(cia447::CarNetwork& network, Node& node);
  void device_ends();
  void trip_came(const cia447::TripData* trip);
  void look_for_receipt(std::size_t trip, std::size_t first_line);
  void totals_came(SdoClient::Outcome outcome);

  TaxiCar& car_;
  TripBook& trips_;
  bool is_real_;
  std::optional<cia447::TripReader> trip_reader_;
  std::optional<SdoClient> totals_reader_;
  std::array<std::uint8_t, 4> shift_income_{};
  bool has_told_trip_ = false;
  std::size_t lines_before_trip_ = 0;  ///< on the paper
};

}  // namespace canvoy::taxi
