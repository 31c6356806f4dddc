// Date and time from a real time clock on the bus (60F0h, 60F2h, 60F4h of a functional client; CiA
// 447-3, 4.2.14), which continue by themselves until they are received again.
//
//     BusClock clock(node);
//     if (const std::optional<LocalTime> time = clock.read()) ...
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"

namespace canvoy::cia447 {

/// The time on a clock, and its offset from UTC.
struct LocalTime {
  std::int64_t seconds = 0;     ///< since 1970-01-01, as shown by the clock
  std::int32_t utc_offset = 0;  ///< seconds by which the clock is ahead of UTC

  /// Seconds since 1970-01-01, UTC.
  constexpr std::int64_t utc() const { return seconds - utc_offset; }
};

/// Objects that a client reads for it. The date follows the time once more: midnight may have been
/// between the two.
inline constexpr std::uint16_t clock_objects[] = {rtc_type_and_status_object.index,
                                                  rtc_date_object.index, rtc_time_object.index,
                                                  rtc_date_object.index};

/// 0609 0030h if 60F0h is to be written with a day that does not exist, such as 31 February.
AbortCode check_date(const Entry& entry, std::span<const std::uint8_t> value);

/// For ProvidedObjects of devices that use a clock.
inline constexpr const ObjectInfo* bus_clock_objects[] = {&rtc_date_object, &rtc_time_object,
                                                          &rtc_type_and_status_object};
/// check_date() as a callback.
inline constexpr Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)> check_of_date(
    [](void*, const Entry& entry, std::span<const std::uint8_t> value) {
      return check_date(entry, value);
    },
    nullptr);

/// The time of 60F2h is that of the moment at which it is written over the bus; for a clock in the
/// same device, of the moment at which a change is found. A clock that reports that it is not
/// valid, or that fails, has no time; a clock without such a report has.
class BusClock {
 public:
  /// Attaches to the node, which must outlive this.
  explicit BusClock(Node& node);

  /// Nothing if the node has no such objects, or has not received the time.
  std::optional<LocalTime> read();
  /// Takes an object that was updated by this node, not over the bus.
  void told(std::uint16_t index);

 private:
  void date_came() { take(false); }
  void time_came() { take(true); }
  void take(bool has_new_time);
  std::optional<std::int64_t> reported_days() const;
  std::optional<Duration> reported_time() const;

  Node& node_;
  bool is_told_ = false;
  Duration time_of_day_{};  ///< at `told_at_`
  Time told_at_{};
  std::int64_t days_ = 0;
  std::optional<std::int64_t> days_before_ = {};  ///< as last found
  std::optional<Duration> time_before_ = {};
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia447
