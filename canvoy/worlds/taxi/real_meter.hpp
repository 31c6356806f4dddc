// A real taximeter, as far as driver and passengers can see it: the state that it reports, its
// values of trip and shift, which a simulated device requests, and its output on the simulated
// paper.
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
#include "canvoy/worlds/taxi/taxi_car.hpp"
#include "canvoy/worlds/taxi/trip_book.hpp"

namespace canvoy::taxi {

class RealMeter {
 public:
  /// All must outlive this object. Where the meter is simulated here, it does nothing.
  RealMeter(TaxiCar& car, TripBook& trips);
  RealMeter(const RealMeter&) = delete;
  RealMeter& operator=(const RealMeter&) = delete;

  /// A key of the meter was pressed.
  void says(cia447::Taximeter state);
  /// Requests the values of the trip: each second, while there are passengers.
  void read(Time now);
  /// True if it has reported a trip since it is in its state.
  bool has_told_trip() const { return has_told_trip_; }
  /// A trip begins: lines from here on belong to its receipt.
  void trip_begins() { lines_before_trip_ = car_.paper().lines().size(); }
  /// Expects a receipt for the last payment: the meter prints by itself, at its own time.
  void expect_receipt();
  /// Requests its income of the shift. No trips are requested after it.
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
