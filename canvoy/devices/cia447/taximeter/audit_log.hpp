// What a taximeter records of what is done to it: what, when, by whom. Directive 2014/32/EU, annex
// IX, and OIML R 21 want what changes the fare to be protected; here what is refused, and what is
// done behind the seal, leaves a trace that nobody can delete.
//
//     AuditLog log;
//     log.note({.at = now, .what = AuditEvent::write_refused, .who = 7, .detail = 0x605500});
//     log.newest(0)->times    // how often
//
// It has room for few entries of each class, so that a stranger who writes all day does not push
// out who has opened the seal. What had to go is counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canvoy::cia447 {

/// What happened; flash and 5F21h have the numbers and words of these.
enum class AuditEvent : std::uint8_t {
  none,
  write_refused,     ///< by a client that is not the provider; detail: index and sub-index; value
  settings_refused,  ///< the same of PDO and SDO parameters, which are behind the seal
  error,             ///< detail: TaximeterError; value: sealed and found
  engine_stands,     ///< the wheels give pulses, and the engine stands
  clock_step,        ///< between two trips; value: seconds, with a sign
  clock_refused,     ///< in a trip: the meter does not go by it; value: seconds, with a sign
  seal_opened,
  seal_closed,
  service_entered,
  sealed,          ///< service mode was left; value: k
  k_set,           ///< detail: k before; value: k
  calibrated,      ///< detail: pulses; value: k
  tariff_changed,  ///< detail: the tariff before; value: the tariff
  trip_cut,        ///< a loss of power has ended a trip; value: what it came to
};

/// By whom, where it is no node-ID.
inline constexpr std::uint8_t by_meter = 0;               ///< by itself, or by hands at it
inline constexpr std::uint8_t by_default_channel = 0xFF;  ///< by whoever is plugged in

/// What, when, by whom.
struct AuditEntry {
  /// No clock was known.
  static constexpr std::uint32_t no_time = 0xFFFF'FFFF;

  std::uint32_t at = no_time;          ///< seconds since 1970-01-01, UTC
  std::uint32_t until = no_time;       ///< the last time of several
  AuditEvent what = AuditEvent::none;  ///< that was done
  std::uint8_t who = by_meter;         ///< a node-ID, or one of the two above
  std::uint16_t times = 1;             ///< no more than FFFFh
  std::uint32_t detail = 0;            ///< as AuditEvent says
  std::uint32_t value = 0;             ///< of several the first one's

  friend constexpr bool operator==(const AuditEntry&, const AuditEntry&) = default;
};

class AuditLog {
 public:
  /// Entries, of all classes together.
  static constexpr std::size_t capacity = 32;

  /// Answers the entry where it stands: writes that are refused and errors that have one of the
  /// same kind, by the same, are counted there. Linear in the number of entries.
  const AuditEntry& note(const AuditEntry& entry);
  std::size_t size() const { return size_; }
  /// 0 is the newest; null: there are not as many. It holds until the next note().
  const AuditEntry* newest(std::size_t number) const {
    return number < size_ ? &entries_[size_ - 1 - number] : nullptr;
  }
  std::uint32_t events() const { return events_; }  ///< noted in all; no more than FFFF FFFFh
  std::uint32_t lost() const { return lost_; }      ///< entries that had to go

  /// Tells an archive all of it, as TaximeterRecord does.
  template <class Archive>
  constexpr void visit(Archive& archive) {
    archive(version_, events_, lost_, size_);
    for (AuditEntry& entry : entries_) {
      archive(entry.at, entry.until, entry.what, entry.who, entry.times, entry.detail, entry.value);
    }
  }
  /// What was read back fits together.
  bool is_sound() const { return version_ == present_version && size_ <= capacity; }

 private:
  static constexpr std::uint8_t present_version = 1;

  void make_room(AuditEvent what);

  std::uint8_t version_ = present_version;
  std::uint8_t size_ = 0;
  std::uint32_t events_ = 0;
  std::uint32_t lost_ = 0;
  std::array<AuditEntry, capacity> entries_{};  ///< the oldest first
};

}  // namespace canvoy::cia447
