// A taximeter: distance from the car's wheel pulses, time, fare, and totals that outlive a loss of
// power (60D0h to 60DBh; CiA 447-3, 4.2.12).
//
//     TaximeterUnit meter(network, {.clock = ..., .seal_is_open = ..., .show = ...},
//                         {.k = 8000, .tariff = my_tariff});
//     meter.sign_on();   // the driver's keys
//     meter.hire();
//     meter.stop();      // the fare stands; for_hire() ends the trip
//
// Distance is that of 6055h only, and excludes uncertain values (wheel_pulses.hpp). Each second is
// a slice of a trip (fare_calculation.hpp); a slice in which values of 6055h were lost is longer. A
// trip lasts from hire() to for_hire(); stopped is a pause of it. Its fare is added to the totals
// when it ends, distance and hirings at once.
//
// The meter is sealed: the objects that it consumes are accepted only from their providers
// (provided_objects.hpp), its PDO and SDO parameters are written only in service mode, clocks are
// limited (clock_bounds.hpp), and refused accesses and actions are recorded (audit_log.hpp; 5F20h
// and 5F21h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/object_reader.hpp"
#include "canvoy/devices/cia447/kit/provided_objects.hpp"
#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/devices/cia447/taximeter/audit_text.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"
#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_memory.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_objects.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_settings.hpp"
#include "canvoy/devices/cia447/taximeter/wheel_pulses.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

/// Limits the influence of a clock on a taximeter: in a trip, it may differ by at most two minutes
/// from the meter's own time. Between two trips it may be set, and the difference is recorded. So
/// neither a clock that jumps nor one that drifts changes a trip or its tariff.
///
///     ClockBounds bounds;
///     const LocalTime now = bounds.take(told, node.now(), has_trip);
///     if (bounds.is_beyond(told, node.now())) ...
class ClockBounds {
 public:
  static constexpr std::int64_t step_max = 120;          ///< s
  static constexpr std::int32_t offset_step_max = 3600;  ///< s: start or end of summer time

  /// The time to use. The first one is accepted.
  LocalTime take(const LocalTime& told, Time now, bool has_trip) {
    if (!known_) known_ = Known{told, now};
    return has_trip && is_beyond(told, now) ? expected(now) : told;
  }
  /// True if a clock is beyond its limit: take() does not use it in a trip.
  bool is_beyond(const LocalTime& told, Time now) const {
    if (!known_) return false;
    const std::int64_t step = told.utc() - expected(now).utc();
    const std::int32_t offset_step = told.utc_offset - known_->time.utc_offset;
    return step > step_max || step < -step_max || offset_step > offset_step_max ||
           offset_step < -offset_step_max;
  }
  /// Seconds by which it is beyond, in local time.
  std::int64_t step(const LocalTime& told, Time now) const {
    return known_ ? told.seconds - expected(now).seconds : 0;
  }
  /// Accepts this as the time.
  void settle(const LocalTime& told, Time now) { known_ = Known{told, now}; }

 private:
  struct Known {
    LocalTime time;
    Time at{};
  };
  LocalTime expected(Time now) const {
    LocalTime time = known_->time;
    time.seconds += std::chrono::floor<std::chrono::seconds>(now - known_->at).count();
    return time;
  }

  std::optional<Known> known_;
};

/// Emergencies: the codes of part 1 are not at hand; these are codes that CiA 301 leaves to the
/// device. The instance, and the first byte of the manufacturer-specific field, is a
/// TaximeterError.
namespace emergency_code {
inline constexpr std::uint16_t taximeter = 0xFF00;  ///< emergency error code: see TaximeterError
}  // namespace emergency_code

/// Error of a taximeter, in its emergency.
enum class TaximeterError : std::uint8_t {
  wheel_source = 1,  ///< 6054h changed outside of service mode; bytes 1, 2: sealed, found
  wheel_node,        ///< another node sends the wheel pulses; bytes 1, 2: sealed, found
  wheel_stands,      ///< the wheels turn according to 6053h, and 6055h stands still
  memory,            ///< totals were damaged, or cannot be written
  extra_pulses,      ///< 6055h counts more than the wheels turn according to 6053h
  seal               ///< the seal was opened outside of service mode
};

class TaximeterUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  TaximeterUnit(CarNetwork& network, const TaximeterHardware& hardware,
                const TaximeterSettings& settings);
  TaximeterUnit(const TaximeterUnit&) = delete;
  TaximeterUnit& operator=(const TaximeterUnit&) = delete;

  // The driver's keys. They return false if they are not allowed in this state; nothing has then
  // changed.

  bool sign_on();   ///< starts a shift: its totals are 0
  bool sign_off();  ///< from "for hire"
  bool hire();      ///< starts a trip, or continues a stopped one
  bool stop();      ///< ends the charging of time and distance
  bool for_hire();  ///< ends the trip and adds it to the totals
  bool standby();   ///< from "for hire" and "signed off"
  bool wake();      ///< leaves standby
  /// Changes to off mode; not with passengers. Any other key, and wake(), cancels it.
  bool turn_off();
  /// Selects a level of the tariff, instead of the clock, until the trip ends. The initial fare is
  /// that of the level at the start of the trip.
  bool choose_level(unsigned level);
  /// Returns to the level that the clock selects.
  void choose_level_by_clock() { record_.chosen_level = TaximeterRecord::no_level; }
  /// Charges a service of the tariff at its price, by its index in Tariff::supplements. While hired
  /// or stopped.
  bool charge(unsigned kind);
  /// Charges another supplement, in 0,001 of the currency unit. While hired or stopped.
  bool add_supplement(std::uint32_t amount);
  /// Clears all supplements.
  bool clear_supplements();
  /// Agrees a price for the present trip, or for the next one.
  bool agree_price(std::uint32_t price);

  // Behind the seal.

  bool enter_service();  ///< with the seal open, and no trip under way
  /// With the seal closed: the sealed settings take effect, with the date of securing; the meter is
  /// then signed off.
  bool leave_service();
  bool set_k(std::uint32_t k);  ///< in service mode; at least 1
  /// In service mode: sets the mode for later trips (60DAh:02h). It is kept like k; a trip that is
  /// under way keeps its own.
  bool set_mode(TaximeterMode mode);
  /// In service mode: starts to count the pulses of a drive over a known distance.
  bool begin_calibration();
  /// Ends the calibration: k is calculated from the pulses counted on `distance`, in 0,001 of the
  /// local distance unit. False, with k unchanged, if no calibration has started, or fewer than
  /// 1000 pulses have come, of which one is 0,1 %.
  bool end_calibration(std::uint32_t distance);

  /// Writes all data to keep before it returns.
  void power_fails();
  /// Sends the display's content again.
  void hardware_changed();

  /// State at present.
  Taximeter state() const { return record_.state; }
  /// The present tariff.
  const Tariff& tariff() const { return tariff_; }
  /// All that is kept.
  const TaximeterRecord& record() const { return record_; }
  /// Recorded events, with time and origin.
  const AuditLog& audit() const { return audit_; }

 private:
  void reset(ResetScope scope);
  void power_on();
  void resume();
  void count_came();
  void source_came();
  void adopt_source();
  void source_was_read(std::uint16_t index);
  void clock_was_read(std::uint16_t index) { bus_clock_.told(index); }
  void tick(Time now);
  void off(Time now);

  void advance(std::uint32_t turned, bool is_count);
  void add_distance(std::uint32_t turned);
  bool check_wheels(std::uint32_t turned, Duration since);
  void set_fastest();
  void watch_clock();
  void watch_clock_step();
  void watch_seal();
  void change_tariff();

  bool enter(Taximeter state);
  void object_to_sleep();
  void begin_trip();
  void end_trip();
  void set_error(TaximeterError error, bool is_present, std::uint8_t sealed = 0,
                 std::uint8_t found = 0);
  void report(TaximeterError error, bool is_present, std::uint8_t sealed = 0,
              std::uint8_t found = 0);
  static constexpr std::uint8_t bit_of(TaximeterError error) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(error));
  }
  void tamper(std::uint8_t how);
  bool is_tampered(std::uint8_t how) const { return (record_.tampering & how) != 0; }

  // The audit log.
  void note(AuditEvent what, std::uint32_t detail = 0, std::uint32_t value = 0,
            std::uint8_t who = by_meter);
  void write_refused(const RefusedWrite& refused);
  AbortCode check_settings(const Entry& entry, std::span<const std::uint8_t> value);
  void report_audit();
  void report_audit_line(const Entry& entry);
  void keep_audit(bool at_once);
  bool has_wheel_signal() const;
  bool is_signed_on() const;
  bool is_hired() const { return record_.state == Taximeter::hired; }
  bool has_trip_under_way() const { return is_hired() || record_.state == Taximeter::stopped; }

  std::optional<LocalTime> clock();
  std::optional<LocalTime> reported_time();
  std::int64_t utc_now();
  const TariffLevel& present_level();
  TaximeterRecord kept() const;
  void keep();
  void publish(bool is_all = false);
  void publish_configuration() { objects_.report_configuration(record_, settings_); }

  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(network_.node().dictionary())[handle];
  }

  CarNetwork& network_;
  TaximeterHardware hardware_;
  TaximeterSettings settings_;
  TaximeterRecord record_;
  FareCalculation fare_;
  WheelPulses wheel_;
  BusClock bus_clock_;
  ClockBounds clock_bounds_;
  WheelCheck wheel_check_;
  TaximeterMemory memory_;
  AuditLog audit_;
  AuditMemory audit_memory_;
  TaximeterObjects objects_;
  ProvidedObjects wheels_;
  ProvidedObjects clock_objects_;
  Hook sealed_parameters_;
  ObjectReader wheel_reader_;
  ObjectReader clock_reader_;
  Tariff tariff_;
  std::optional<std::uint32_t> agreed_price_ = {};  ///< for the next trip
  bool has_started_ = false;
  bool is_turning_off_ = false;
  Time advanced_to_{};
  Time counted_at_{};  ///< time of the last valid count
  Time kept_at_{};
  std::uint32_t kept_distance_ = 0;
  Duration slice_{};         ///< since the last slice was closed
  std::uint8_t errors_ = 0;  ///< a bit for each TaximeterError
  bool is_seal_open_ = false;
  bool stands_engine_ = false;                     ///< wheels give pulses, engine stands
  bool is_clock_refused_ = false;                  ///< in this trip
  std::optional<std::uint64_t> calibration_ = {};  ///< pulses of the drive
  bool has_new_audit_ = false;                     ///< entries that are not yet kept
  bool has_more_audit_ = false;                    ///< only their counts have changed
  Time audit_kept_at_{};
  TaximeterDisplay shown_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer tick_;
  Timer off_;
};

/// Catalogue row of the taximeter (4.2.12); car_unit makes it a part of a device.
struct TaximeterKind : CarKind<TaximeterUnit, TaximeterHardware, TaximeterSettings> {
  static constexpr DeviceInfo info = {.name = "taximeter",
                                      .title = "taximeter",
                                      .product = "Canvoy CiA 447 taximeter",
                                      .product_code = 44709,
                                      .node_id = 5,
                                      .hardware = "driver's keys, seal, clock, display"};
  static constexpr const VirtualDeviceInfo& provides = taximeter_device;
  static constexpr const ObjectInfo* consumes[] = {&actual_engine_revolutions_object,
                                                   &wheel_rpm_object,
                                                   &wheel_signal_source_object,
                                                   &wheel_pulse_counter_object,
                                                   &wheel_pulse_counter_overrun_value_object,
                                                   &pulses_per_wheel_rotation_object,
                                                   &rtc_date_object,
                                                   &rtc_time_object,
                                                   &rtc_type_and_status_object};
  /// 5F20h and 5F21h.
  static constexpr const ObjectInfo* own[] = {&audit_object, &audit_log_object};
};

}  // namespace canvoy::cia447
