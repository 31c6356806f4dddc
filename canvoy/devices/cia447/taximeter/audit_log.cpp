#include "canvoy/devices/cia447/taximeter/audit_log.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

/// Many events of one class displace only those of this class.
struct AuditClass {
  AuditEvent first;
  AuditEvent last;
  std::uint8_t room;
  bool is_counted;  ///< equal events have one entry

  constexpr bool has(AuditEvent what) const { return what >= first && what <= last; }
};
constexpr AuditClass classes[] = {
    {AuditEvent::write_refused, AuditEvent::settings_refused, 8, true},
    {AuditEvent::error, AuditEvent::engine_stands, 6, true},
    {AuditEvent::clock_step, AuditEvent::clock_refused, 6, false},
    {AuditEvent::seal_opened, AuditEvent::mode_set, 12, false}};

constexpr std::size_t room_of_all() {
  std::size_t room = 0;
  for (const AuditClass& each : classes) room += each.room;
  return room;
}
static_assert(room_of_all() == AuditLog::capacity);

constexpr const AuditClass& class_of(AuditEvent what) {
  for (const AuditClass& each : classes) {
    if (each.has(what)) return each;
  }
  return classes[std::size(classes) - 1];
}

template <class Number>
void count(Number& number) {
  if (number != static_cast<Number>(-1)) ++number;
}

}  // namespace

const AuditEntry& AuditLog::note(const AuditEntry& entry) {
  count(events_);
  const auto is_same = [&](const AuditEntry& other) {
    return other.what == entry.what && other.who == entry.who && other.detail == entry.detail;
  };
  auto* const end = entries_.begin() + size_;
  auto* const found =
      class_of(entry.what).is_counted ? std::find_if(entries_.begin(), end, is_same) : end;
  if (found != end) {
    count(found->times);
    found->until = entry.at;
    return *found;
  }
  make_room(entry.what);
  entries_[size_] = entry;
  entries_[size_].until = entry.at;
  return entries_[size_++];
}

void AuditLog::make_room(AuditEvent what) {
  const AuditClass& of = class_of(what);
  const auto is_of_class = [&](const AuditEntry& other) { return of.has(other.what); };
  auto* const end = entries_.begin() + size_;
  if (std::count_if(entries_.begin(), end, is_of_class) < of.room) return;
  std::rotate(std::find_if(entries_.begin(), end, is_of_class),
              std::find_if(entries_.begin(), end, is_of_class) + 1, end);
  --size_;
  count(lost_);
}

}  // namespace canvoy::cia447
