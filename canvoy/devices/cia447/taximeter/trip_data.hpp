// Contents of 60D0h to 60D4h: the present trip, or the last one while the taxi is for hire (CiA
// 447-3, 4.2.12.1 to 4.2.12.5). All values are written at one moment, and the sequence counter
// (60DBh, 4.2.12.9) counts each change.
//
//     if (data != told) tell(dictionary, data), ++sequence;
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

struct TripData {
  static constexpr std::uint32_t unknown = 0xFFFF'FFFF;  ///< code of each number

  std::uint32_t fare = unknown;                      ///< amounts in 0,001 of the currency unit
  std::uint32_t supplements = unknown;               ///< in 0,001 of the currency unit
  std::uint32_t total = unknown;                     ///< in 0,001 of the currency unit
  FareMode mode = FareMode::not_available;           ///< of distance and time
  std::uint32_t minimum_fare = unknown;              ///< in 0,001 of the currency unit
  std::uint32_t initial_fare = unknown;              ///< in 0,001 of the currency unit
  std::uint32_t distance = unknown;                  ///< in 0,001 of the local distance unit
  std::uint32_t duration = unknown;                  ///< s
  std::uint32_t waiting = unknown;                   ///< s charged as time
  std::uint32_t start = unknown;                     ///< s since 1970-01-01
  std::uint32_t finish = unknown;                    ///< s since 1970-01-01
  std::array<std::uint8_t, 2> level = {0xFF, 0xFF};  ///< characters of 60D3h
  std::uint32_t time_rate = unknown;                 ///< price of an hour, in 0,001
  std::uint32_t distance_rate = unknown;             ///< price of a local distance unit, in 0,001

  bool operator==(const TripData&) const = default;
};

/// Data of a trip and its fare.
TripData trip_data(const TaxiTrip& trip, const FareCalculation& fare);

/// Seconds since 1970-01-01 in 32 bits; TripData::unknown if they do not fit.
std::uint32_t seconds_since_1970(std::int64_t time);

/// Writes all values at one moment, and counts the change in 60DBh.
void tell(Dictionary& dictionary, const TripData& data);

/// The sequence counter wraps from FDh to 0, as the two codes above have other meanings.
constexpr std::uint8_t next_sequence(std::uint8_t sequence) {
  constexpr std::uint8_t sequence_max = 0xFD;
  return sequence >= sequence_max ? std::uint8_t{0} : static_cast<std::uint8_t>(sequence + 1);
}

}  // namespace canvoy::cia447
