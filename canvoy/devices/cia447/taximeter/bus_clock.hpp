// Date and time as a real time clock on the bus has told them (60F0h, 60F2h, 60F4h as a functional
// client has them; CiA 447-3, 4.2.14), going on by themselves until they are told again.
//
//     BusClock clock(node);
//     if (const std::optional<LocalTime> time = clock.read()) ...
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"

namespace canvoy::cia447 {

/// What people read on a clock, and where they are.
struct LocalTime {
  std::int64_t seconds = 0;     ///< since 1970-01-01, as the clock shows them
  std::int32_t utc_offset = 0;  ///< seconds that the clock is ahead of UTC

  constexpr std::int64_t utc() const { return seconds - utc_offset; }
};

/// What a client reads to know it. The date again after the time: midnight may have been between
/// the two.
inline constexpr std::uint16_t clock_objects[] = {rtc_type_and_status_object.index,
                                                  rtc_date_object.index, rtc_time_object.index,
                                                  rtc_date_object.index};

/// 0609 0030h where 60F0h is to be written with a day that there is not, as 31 February.
AbortCode check_date(const Entry& entry, std::span<const std::uint8_t> value);

/// For ProvidedObjects of those who go by a clock.
inline constexpr const ObjectInfo* bus_clock_objects[] = {&rtc_date_object, &rtc_time_object,
                                                          &rtc_type_and_status_object};
/// The same for check_date().
inline constexpr Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)> check_of_date(
    [](void*, const Entry& entry, std::span<const std::uint8_t> value) {
      return check_date(entry, value);
    },
    nullptr);

/// The time of 60F2h is that of the moment at which it is written over the bus; of a clock in the
/// same device, of the moment at which it is found changed. A clock that says of itself that it is
/// not valid, or fails, has no time; one that says nothing of itself has.
class BusClock {
 public:
  explicit BusClock(Node& node);
  BusClock(const BusClock&) = delete;
  BusClock& operator=(const BusClock&) = delete;

  /// Nothing where the node has no such objects, or nobody told it.
  std::optional<LocalTime> read();
  /// One of the objects was brought up to date, not over the bus but by this node.
  void told(std::uint16_t index);

 private:
  void date_came() { take(false); }
  void time_came() { take(true); }
  void take(bool has_new_time);
  std::optional<std::int64_t> told_days() const;
  std::optional<Duration> told_time() const;

  Node& node_;
  bool is_told_ = false;
  Duration time_of_day_{};  ///< at `told_at_`
  Time told_at_{};
  std::int64_t days_ = 0;
  std::optional<std::int64_t> days_before_ = {};  ///< as they were found last
  std::optional<Duration> time_before_ = {};
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy::cia447
