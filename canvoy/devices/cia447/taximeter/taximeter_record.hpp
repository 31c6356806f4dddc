// Data that a taximeter keeps without power: state, totals, the trip, and the sealed settings. It
// is one record, so that a total and the trip that was added to it always belong together.
//
//     const TaximeterRecordBytes bytes = bytes_of(record);
//     const std::optional<TaximeterRecord> back = taximeter_record(bytes);
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// Half of 60D9h: overall, or of the shift.
struct TaxiTotals {
  std::uint32_t distance = 0;        ///< in 0,001 of the local distance unit
  std::uint32_t distance_hired = 0;  ///< in 0,001 of the local distance unit
  std::uint32_t income = 0;          ///< charged amount, in 0,001 of the currency unit
  std::uint32_t hirings = 0;         ///< trips
  std::uint32_t supplements = 0;     ///< included in income
  std::uint32_t fare = 0;            ///< included in income

  /// The two highest codes have a special meaning: like a counter with a limited number of digits,
  /// a total restarts below them.
  static constexpr void add(std::uint32_t& total, std::uint64_t more) {
    constexpr std::uint64_t modulus = 0xFFFF'FFFE;
    total = static_cast<std::uint32_t>((total + more % modulus) % modulus);
  }
  /// Visits all members in their order.
  template <class Archive>
  constexpr void visit(Archive& archive) {
    archive(distance, distance_hired, income, hirings, supplements, fare);
  }
};

/// An unknown point in time.
inline constexpr std::int64_t no_time = INT64_MIN;

/// The present trip, or the last one.
struct TaxiTrip {
  bool is_there = false;          ///< false: there was none
  bool has_fare = true;           ///< false in odometer operation, unless a price was agreed
  FareCalculation::State fare;    ///< of the trip
  std::uint64_t pulses = 0;       ///< of the wheels
  std::uint32_t supplements = 0;  ///< in 0,001 of the currency unit
  std::int64_t duration = 0;      ///< microseconds
  std::int64_t start = no_time;   ///< seconds since 1970-01-01, UTC
  std::int64_t finish = no_time;  ///< seconds since 1970-01-01, UTC
  /// Part of the supplements for each kind of the tariff. Kept behind the rest of the record.
  std::array<std::uint32_t, supplement_kinds_max> supplements_of_kind = {};

  /// Visits all members in their order.
  template <class Archive>
  constexpr void visit(Archive& archive) {
    archive(is_there, has_fare);
    fare.visit(archive);
    archive(pulses, supplements, duration, start, finish);
  }
};

/// Actions outside of service mode: until the meter is sealed again, no trip starts.
namespace tampering {
inline constexpr std::uint8_t source = 0x01;  ///< another source or sender of the wheel pulses
inline constexpr std::uint8_t seal = 0x02;    ///< the seal was opened
}  // namespace tampering

struct TaximeterRecord {
  static constexpr std::uint8_t present_version = 2;  ///< of the record
  /// Version without the kinds of supplements, the beginning of the shift and the mode.
  static constexpr std::uint8_t version_1 = 1;
  static constexpr std::uint8_t no_level = 0xFF;  ///< the clock selects it

  std::uint8_t version = present_version;            ///< other versions are converted, or refused
  Taximeter state = Taximeter::signed_off;           ///< of the taximeter
  Taximeter before_standby = Taximeter::signed_off;  ///< state to return to
  bool totals_are_known = true;                      ///< false after damage of the former record
  TaxiTotals total;                                  ///< never reset
  TaxiTotals shift;                                  ///< since the driver has signed on
  std::uint32_t distance_rest = 0;  ///< pulses by 1000, below k: not yet included in the totals
  TaxiTrip trip;                    ///< present or last
  std::uint8_t chosen_level = no_level;  ///< by the driver
  std::int64_t saved_at = no_time;       ///< seconds since 1970-01-01, UTC
  std::int64_t shift_begin = no_time;    ///< as saved_at; kept behind the rest of the record
  /// Seconds by which the meter's own clock was ahead of the one on the bus when that was last
  /// received.
  std::int64_t own_clock_ahead = 0;
  std::int32_t own_offset_ahead = 0;  ///< difference of their offsets from UTC

  // Sealed settings.
  std::uint32_t k = 1;                                    ///< pulses for a local distance unit
  std::uint16_t tariff = 0;                               ///< identification of the tariff
  std::int64_t date_of_securing = no_time;                ///< in local seconds since 1970-01-01
  WheelSource wheel_source = WheelSource::not_available;  ///< that was sealed
  std::uint8_t wheel_node = 0;                        ///< sender of the wheel pulses; 0: not known
  std::uint8_t tampering = 0;                         ///< bits of namespace tampering
  TaximeterMode mode = TaximeterMode::not_available;  ///< 60DAh:02h; kept behind the rest

  /// Visits all members in their order.
  template <class Archive>
  constexpr void visit(Archive& archive) {
    archive(version, state, before_standby, totals_are_known);
    total.visit(archive);
    shift.visit(archive);
    archive(distance_rest);
    trip.visit(archive);
    archive(chosen_level, saved_at, own_clock_ahead, own_offset_ahead, k, tariff, date_of_securing,
            wheel_source, wheel_node, tampering);
    for (auto& of_kind : trip.supplements_of_kind) archive(of_kind);
    archive(shift_begin, mode);
  }

  static const std::size_t size;               ///< in bytes
  static const std::size_t size_of_version_1;  ///< in bytes, of the former version
};

namespace record_archive {

/// Counts the bytes of a record.
struct CountingArchive {
  std::size_t size = 0;  ///< in bytes
  template <class... Number>
  constexpr void operator()(const Number&... numbers) {
    ((size += sizeof numbers), ...);
  }
};
/// Writes numbers as in memory, one behind the other.
struct WritingArchive {
  std::uint8_t* place;  ///< next byte
  template <class... Number>
  void operator()(const Number&... numbers) {
    (put(&numbers, sizeof numbers), ...);
  }
  /// Writes a number.
  void put(const void* number, std::size_t length) {
    std::memcpy(place, number, length);
    place += length;
  }
};
/// Reads numbers in the order in which they were written.
struct ReadingArchive {
  const std::uint8_t* place;  ///< next byte
  template <class... Number>
  void operator()(Number&... numbers) {
    (get(numbers), ...);
  }
  /// Reads a number.
  template <class Number>
  void get(Number& number) {
    if constexpr (std::is_same_v<Number, bool>) {
      number = *place != 0;
    } else {
      std::memcpy(&number, place, sizeof number);
    }
    place += sizeof number;
  }
};

/// Size in bytes of a record that passes all of it to an archive by visit().
template <class Record>
consteval std::size_t size_of() {
  CountingArchive archive;
  Record{}.visit(archive);
  return archive.size;
}
/// A record in the form in which it is kept.
template <std::size_t size, class Record>
std::array<std::uint8_t, size> bytes_of(Record record) {
  std::array<std::uint8_t, size> bytes;
  WritingArchive archive{bytes.data()};
  record.visit(archive);
  return bytes;
}

}  // namespace record_archive

inline constexpr std::size_t TaximeterRecord::size = record_archive::size_of<TaximeterRecord>();
inline constexpr std::size_t TaximeterRecord::size_of_version_1 =
    size - sizeof TaxiTrip{}.supplements_of_kind - sizeof TaximeterRecord{}.shift_begin -
    sizeof TaximeterRecord{}.mode;

/// A record as bytes.
using TaximeterRecordBytes = std::array<std::uint8_t, TaximeterRecord::size>;

/// The record as bytes, to be kept.
inline TaximeterRecordBytes bytes_of(const TaximeterRecord& record) {
  return record_archive::bytes_of<TaximeterRecord::size>(record);
}
/// Nothing if the bytes are of another version. Values that version 1 does not have are unknown.
inline std::optional<TaximeterRecord> taximeter_record(const TaximeterRecordBytes& bytes) {
  TaximeterRecord record;
  record_archive::ReadingArchive archive{bytes.data()};
  record.visit(archive);
  const bool is_known = record.version == TaximeterRecord::present_version ||
                        record.version == TaximeterRecord::version_1;
  if (!is_known || record.k == 0) return std::nullopt;
  if (record.version == TaximeterRecord::version_1) {
    record.shift_begin = no_time;
    record.mode = TaximeterMode::not_available;
  }
  record.version = TaximeterRecord::present_version;
  return record;
}

}  // namespace canvoy::cia447
