// Events that a taximeter records: what, when, and by which node. Directive 2014/32/EU, annex IX,
// and OIML R 21 require the protection of everything that changes the fare. Refused accesses, and
// actions behind the seal, leave a trace here that cannot be deleted.
//
//     AuditLog log;
//     log.note({.at = now, .what = AuditEvent::write_refused, .who = 7, .detail = 0x605500});
//     log.newest(0)->times    // how often
//
// It has room for few entries of each class, so that a foreign node that writes continuously does
// not displace the entry of an opened seal. Discarded entries are counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canvoy::cia447 {

/// Kinds of events; flash and 5F21h use their numbers and words.
enum class AuditEvent : std::uint8_t {
  none,
  write_refused,     ///< by a client that is not the provider; detail: index and sub-index; value
  settings_refused,  ///< of PDO and SDO parameters, which are behind the seal; otherwise as above
  error,             ///< detail: TaximeterError; value: sealed and found
  engine_stands,     ///< the wheels give pulses while the engine stands
  clock_step,        ///< between two trips; value: signed seconds
  clock_refused,     ///< in a trip: the meter does not follow it; value: signed seconds
  seal_opened,
  seal_closed,
  service_entered,
  sealed,          ///< service mode was left; value: k
  k_set,           ///< detail: k before; value: k
  calibrated,      ///< detail: pulses; value: k
  tariff_changed,  ///< detail: the tariff before; value: the tariff
  trip_cut,        ///< a loss of power has ended a trip; value: its amount
  mode_set,        ///< detail: the mode before; value: the mode (60DAh:02h)
};

/// Origin of an event, if it is no node-ID.
inline constexpr std::uint8_t by_meter = 0;               ///< by itself, or by manual operation
inline constexpr std::uint8_t by_default_channel = 0xFF;  ///< by any device that is plugged in

/// Kind, time and origin of an event.
struct AuditEntry {
  /// No clock was known.
  static constexpr std::uint32_t no_time = 0xFFFF'FFFF;

  std::uint32_t at = no_time;          ///< seconds since 1970-01-01, UTC
  std::uint32_t until = no_time;       ///< time of the last of several
  AuditEvent what = AuditEvent::none;  ///< kind
  std::uint8_t who = by_meter;         ///< a node-ID, or one of the two above
  std::uint16_t times = 1;             ///< no more than FFFFh
  std::uint32_t detail = 0;            ///< as AuditEvent says
  std::uint32_t value = 0;             ///< for several, that of the first

  friend constexpr bool operator==(const AuditEntry&, const AuditEntry&) = default;
};

class AuditLog {
 public:
  /// Maximum number of entries, of all classes together.
  static constexpr std::size_t capacity = 32;

  /// Returns the entry in the log: refused writes and errors that have an entry of the same kind
  /// and origin are counted there. Linear in the number of entries.
  const AuditEntry& note(const AuditEntry& entry);
  std::size_t size() const { return size_; }
  /// 0 is the newest; null if there are fewer. Valid until the next note().
  const AuditEntry* newest(std::size_t number) const {
    return number < size_ ? &entries_[size_ - 1 - number] : nullptr;
  }
  std::uint32_t events() const { return events_; }  ///< noted in all, at most FFFF FFFFh
  std::uint32_t lost() const { return lost_; }      ///< number of discarded entries

  /// Passes all of it to an archive, like TaximeterRecord.
  template <class Archive>
  constexpr void visit(Archive& archive) {
    archive(version_, events_, lost_, size_);
    for (AuditEntry& entry : entries_) {
      archive(entry.at, entry.until, entry.what, entry.who, entry.times, entry.detail, entry.value);
    }
  }
  /// True if the contents that were read are consistent.
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
