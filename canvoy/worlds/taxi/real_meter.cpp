#include "canvoy/worlds/taxi/real_meter.hpp"

#include <span>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/worlds/taxi/read_receipts.hpp"

namespace canvoy::taxi {

RealMeter::RealMeter(TaxiCar& car, TripBook& trips)
    : car_(car), trips_(trips), is_real_(!car.bus().is_played(taximeter_id)) {
  if (!is_real_) return;
  car.attach({.device_is_made = callback<&RealMeter::device_is_made>(*this),
              .device_ends = callback<&RealMeter::device_ends>(*this)});
}

void RealMeter::device_is_made(cia447::CarNetwork& network, Node& /*node*/) {
  trip_reader_.emplace(network, taximeter_id,
                       cia447::TripReader::Done::to<&RealMeter::trip_came>(*this));
}

void RealMeter::device_ends() {
  trip_reader_.reset();
  totals_reader_.reset();
}

void RealMeter::says(cia447::Taximeter state) {
  if (car_.meter().heard(state)) has_told_trip_ = false;
}

void RealMeter::read(Time now) {
  const bool is_second = (now - Time{}) % 1s == Duration{};
  if (!trip_reader_ || !car_.meter().has_passengers() || !is_second) return;
  const NodeId reader = car_.meter_reader_id();
  if (!car_.bus().node(reader).is_operational()) return;
  trip_reader_->read();
  car_.bus().touched(reader);
}

void RealMeter::trip_came(const cia447::TripData* trip) {
  constexpr std::uint32_t unknown = cia447::TripData::unknown;
  if (trip == nullptr || trip->fare == unknown || trip->total == unknown ||
      trip->distance == unknown || trip->duration == unknown) {
    return;
  }
  car_.meter().heard(*trip);
  has_told_trip_ = true;
}

void RealMeter::expect_receipt() {
  constexpr Duration in_time = 20s;
  if (!is_real_ || trips_.trips().empty() || !trips_.trips().back().is_read) return;
  World& world = car_.bus().world();
  world.at(world.now() + in_time,
           [this, trip = trips_.trips().size() - 1, first = lines_before_trip_](Time) {
             look_for_receipt(trip, first);
           });
}

/// A passenger reads the paper of the simulated printer, whatever else a real meter prints there. A
/// meter that never prints there has a printer of its own.
void RealMeter::look_for_receipt(std::size_t trip, std::size_t first_line) {
  const std::span<const std::string> lines = car_.paper().lines();
  const bool prints = !lines.empty() && car_.bus().is_played(printer_id);
  if (!prints) return;
  trips_.judge_receipt(trip, says_amount(lines.subspan(first_line), trips_.trips()[trip].paid));
}

void RealMeter::ask_for_totals() {
  constexpr auto income = cia447::place_of(cia447::taximeter_totalizers_shift_income);
  const bool is_judged = trip_reader_ && trips_.all_were_read();
  car::CarNode& reader = car_.bus().node(car_.meter_reader_id());
  if (!is_judged || !reader.is_operational()) return;
  trip_reader_.reset();
  totals_reader_.emplace(reader.node(), cia447::mesh_channel_to(taximeter_id));
  totals_reader_->upload(taximeter_id, income.index, income.sub, shift_income_,
                         SdoClient::Done::to<&RealMeter::totals_came>(*this));
  car_.bus().touched(car_.meter_reader_id());
}

/// A meter that does not report it is not judged by it.
void RealMeter::totals_came(SdoClient::Outcome outcome) {
  constexpr std::uint32_t failure = 0xFFFF'FFFE;
  const auto income = load<std::uint32_t>(shift_income_.data());
  if (!outcome || *outcome != shift_income_.size() || income >= failure) return;
  trips_.judge_income_by_payment(income);
}

}  // namespace canvoy::taxi
