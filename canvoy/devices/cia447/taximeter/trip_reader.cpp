#include "canvoy/devices/cia447/taximeter/trip_reader.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/taximeter/trip_parts.hpp"

namespace canvoy::cia447 {

namespace {

constexpr FieldPlace counter = place_of(taxi_trip_data_sequence_counter);
constexpr FieldPlace mode = place_of(taxi_trip_payment_fare_calculation_mode);
constexpr FieldPlace level = {.index = taxi_trip_tariff_level_object.index};

constexpr std::size_t numbers = std::size(trip_parts);

constexpr bool is_number(std::size_t position) {
  return position >= 1 && position <= numbers;
}

/// After the counter: the numbers, mode, level.
FieldPlace place_at(std::size_t position) {
  if (is_number(position)) return trip_parts[position - 1].place;
  if (position == numbers + 1) return mode;
  return position == numbers + 2 ? level : counter;
}

}  // namespace

TripReader::TripReader(CarNetwork& network, NodeId meter, Done done)
    : client_(network.node(), mesh_channel_to(meter)), meter_(meter), done_(done) {}

void TripReader::read() {
  if (client_.busy()) return;
  position_ = 0;
  attempts_ = 0;
  ask();
}

bool TripReader::is_last() const {
  return position_ == numbers + 3;
}

void TripReader::ask() {
  const FieldPlace place = place_at(position_);
  const AbortCode refused = client_.upload(meter_, place.index, place.sub, value_,
                                           SdoClient::Done::to<&TripReader::answered>(*this));
  if (refused != AbortCode::none) done_(nullptr);
}

/// A meter that does not answer is not read further; one that lacks an object may have others.
void TripReader::answered(SdoClient::Outcome outcome) {
  if (outcome.is_silence()) return done_(nullptr);
  if (position_ == 0) data_ = {};
  take(outcome ? *outcome : 0);
  const auto counted = outcome ? value_[0] : std::uint8_t{0xFF};
  if (position_ == 0) sequence_ = counted;
  if (!is_last()) {
    ++position_;
    return ask();
  }
  if (counted == sequence_) return done_(&data_);
  if (++attempts_ == attempts_max) return done_(nullptr);
  position_ = 0;
  ask();
}

/// Takes the received value of this number of bytes.
void TripReader::take(std::size_t length) {
  const bool is_long = length == sizeof(std::uint32_t);
  if (is_number(position_) && is_long) {
    data_.*trip_parts[position_ - 1].value = load<std::uint32_t>(value_.data());
  } else if (place_at(position_) == mode && is_long) {
    data_.mode = static_cast<FareMode>(load<std::uint32_t>(value_.data()));
  } else if (place_at(position_) == level && length == data_.level.size()) {
    data_.level = {value_[0], value_[1]};
  }
}

}  // namespace canvoy::cia447
