// Devices of the taxi that are real: what they say is what the car and its driver do.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

bool TaxiNetwork::is_real(NodeId id) const {
  return std::ranges::find(options_.real, id) != options_.real.end();
}

/// What a real device does is not seen here, and its keys are out of the driver's reach.
bool TaxiNetwork::can_be_judged(InvariantKind kind) const {
  const auto are_played = [this](std::initializer_list<NodeId> nodes) {
    return std::ranges::none_of(nodes, [this](NodeId id) { return is_real(id); });
  };
  switch (kind) {
    case InvariantKind::fare:
    case InvariantKind::distance:
    case InvariantKind::duration:
      return are_played({driver_id});  // whose clock says which tariff it is
    case InvariantKind::receipts:
      return are_played({printer_id});
    case InvariantKind::roof_sign:
      return are_played({sign_id, taximeter_id});
    case InvariantKind::terminal_fare:
      return are_played({terminal_id, taximeter_id});
    case InvariantKind::terminal_place:
      return are_played({terminal_id, driver_id, navigation_id});
    case InvariantKind::silence:
      return are_played({cia447::gateway_node_id});  // who has all sleep
    case InvariantKind::no_service:
      return are_played({taximeter_id});
    default:
      return true;
  }
}

/// Somebody presses the keys of a real meter: the driver does what goes with them.
MeterKeys TaxiNetwork::real_keys() {
  const auto says = [this](cia447::Taximeter state) {
    return [this, state] { return display_.state == state; };
  };
  return {.sign_on = says(cia447::Taximeter::for_hire),
          .hire = says(cia447::Taximeter::hired),
          .stop = says(cia447::Taximeter::stopped),
          .add_supplement = [](std::uint32_t) { return false; },
          .for_hire = says(cia447::Taximeter::for_hire),
          .sign_off = says(cia447::Taximeter::signed_off)};
}

void TaxiNetwork::hear_real_devices() {
  const auto if_real = [this](NodeId id) { return is_real(id) ? id : NodeId{0}; };
  const RealDevices::Wanted wanted = {.gateway = if_real(cia447::gateway_node_id),
                                      .meter = if_real(taximeter_id),
                                      .alarm = if_real(alarm_id)};
  if (!wanted.any()) return;
  if (wanted.gateway != 0) drive_.be_led();
  real_.emplace(
      wanted, options_.car_network.nodes.pdo_offsets, options_.car.pulse_counter_max,
      RealDevices::Hands{.meter = [this](cia447::Taximeter state) { real_meter_says(state); },
                         .alarm = [this] { note(now(), AlarmPressed{}); },
                         .wheels = [this](std::uint32_t pulses) { real_wheels_turn(pulses); }});
  const SlotIndex slot = world_.add_slot(bus_, {.listen_only = true, .accept_all = true});
  world_.occupy(slot, *real_);
  world_.start(slot);
}

void TaxiNetwork::real_meter_says(cia447::Taximeter state) {
  if (state == display_.state) return;
  note(now(), MeterChanged{state});
  display_.state = state;
  is_trip_read_ = false;
}

/// Whom we have ask a real meter.
NodeId TaxiNetwork::trip_reader_id() const {
  return is_real(cia447::gateway_node_id) ? navigation_id : cia447::gateway_node_id;
}

void TaxiNetwork::is_network_of_reader(cia447::CarNetwork& network, Node& /*node*/) {
  if (!is_real(taximeter_id)) return;
  trip_reader_.emplace(network, taximeter_id,
                       cia447::TripReader::Done::to<&TaxiNetwork::trip_came>(*this));
}

/// Each second, while there are passengers: what they pay is what was read last.
void TaxiNetwork::read_trip(Time now) {
  const bool has_passengers =
      display_.state == cia447::Taximeter::hired || display_.state == cia447::Taximeter::stopped;
  const bool is_second = (now - Time{}) % 1s == Duration{};
  if (!trip_reader_ || !has_passengers || !is_second) return;
  if (!node(trip_reader_id()).is_operational()) return;
  trip_reader_->read();
  world_.touched(trip_reader_id() - SlotIndex{1});
}

void TaxiNetwork::trip_came(const cia447::TripData* trip) {
  constexpr std::uint32_t unknown = cia447::TripData::unknown;
  if (trip == nullptr || trip->fare == unknown || trip->total == unknown ||
      trip->distance == unknown || trip->duration == unknown) {
    return;
  }
  display_.trip = *trip;
  is_trip_read_ = true;
}

/// A passenger reads what is on the paper of our printer, whatever else a real meter writes there.
/// One that never prints has a printer of its own.
void TaxiNetwork::look_for_receipt(double paid, std::size_t first_line) {
  const std::vector<std::string>& lines = paper_.lines();
  const bool prints = !lines.empty() && !is_real(printer_id);
  if (!prints || !options_.faults.faults.empty()) return;
  std::array<char, 24> amount{};
  std::snprintf(amount.data(), amount.size(), "%.2f", paid / money_unit);
  const auto says = [&](const std::string& line, char point) {
    std::string text = amount.data();
    std::ranges::replace(text, '.', point);
    return line.find(text) != std::string::npos;
  };
  const auto is_it = [&](const std::string& line) { return says(line, '.') || says(line, ','); };
  const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first_line);
  if (std::none_of(begin, lines.end(), is_it)) receipts_error_ += paid;
}

/// When the shift is over, nobody reads trips any more.
void TaxiNetwork::ask_for_totals() {
  constexpr auto income = cia447::place_of(cia447::taximeter_totalizers_shift_income);
  const bool is_judged =
      trip_reader_ && options_.faults.faults.empty() &&
      std::ranges::none_of(trips_, [](const Trip& trip) { return trip.is_disturbed; });
  car::CarNode& reader = node(trip_reader_id());
  if (!is_judged || !reader.is_operational()) return;
  trip_reader_.reset();
  totals_reader_.emplace(reader.node(), cia447::mesh_channel_to(taximeter_id));
  totals_reader_->upload(taximeter_id, income.index, income.sub, shift_income_,
                         SdoClient::Done::to<&TaxiNetwork::totals_came>(*this));
  world_.touched(trip_reader_id() - SlotIndex{1});
}

/// A meter that does not tell it is not judged by it.
void TaxiNetwork::totals_came(SdoClient::Outcome outcome) {
  constexpr std::uint32_t failure = 0xFFFF'FFFE;
  const auto income = load<std::uint32_t>(shift_income_.data());
  if (!outcome || *outcome != shift_income_.size() || income >= failure) return;
  totals_error_ = std::abs(income - paid_);
}

void TaxiNetwork::real_wheels_turn(std::uint32_t pulses) {
  drive_.roll(pulses * options_.car.wheel_circumference_m / options_.car.pulses_per_rotation,
              now() - rolled_);
  rolled_ = now();
}

}  // namespace canvoy::taxi
