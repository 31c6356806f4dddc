// Driver identification: the present driver and the login time (60F9h to 60FCh; CiA 447-3, 4.2.15).
//
//     DriverIdentificationUnit drivers(network, {.clock = ..., .knows = ...}, {});
//     drivers.log_in({.id = 4711, .name = "A. Driver"});   // a card was put in
//     drivers.log_out();
//
// Login and logout time are those of the last driver until the next one logs in; ID and name are
// cleared at logout. Times are seconds since 1970-01-01 UTC, from the real time clock on the bus
// that the settings name, otherwise from the hardware's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/object_reader.hpp"
#include "canvoy/devices/cia447/kit/provided_objects.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"

namespace canvoy::cia447 {

/// What a card says of its driver.
struct DriverCard {
  std::uint64_t id = 0;        ///< 60F9h
  std::string_view name = "";  ///< UTF-8; cut after 64 bytes
};

/// The card reader.
struct DriverIdentificationHardware {
  /// Nothing if it is not set.
  Callback<std::optional<LocalTime>()> clock = {};
  /// True if a card may log in; without a callback all may.
  Callback<bool(std::uint64_t id)> knows = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(DriverIdentificationHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::clock; } || requires { &Plain::knows; },
      "the class has no member function of DriverIdentificationHardware: clock or knows");
  if constexpr (requires { &Plain::clock; }) hardware.clock = callback<&Plain::clock>(plain);
  if constexpr (requires { &Plain::knows; }) hardware.knows = callback<&Plain::knows>(plain);
}

/// Period and clock.
struct DriverIdentificationSettings {
  /// Provider of date and time (60F0h, 60F2h, 60F4h): they are read from it by SDO, and only it may
  /// write them. 0: none.
  NodeId clock_node = 0;
  Duration asking_period = 10s;  ///< of the date and the time, if no PDO carries them
};

/// State of the card reader.
enum class CardReader : std::uint8_t { working, failed, not_available };

class DriverIdentificationUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  DriverIdentificationUnit(CarNetwork& network, const DriverIdentificationHardware& hardware,
                           const DriverIdentificationSettings& settings);

  /// False if a driver is logged in, the reader does not work, or the card is not known. An unknown
  /// card is an identification failure until the next card, or forget_failure().
  bool log_in(const DriverCard& card);
  /// False if no driver is logged in.
  bool log_out();
  /// Reports a card that cannot be read.
  void card_is_unreadable();
  /// Ends the report of a failed login.
  void forget_failure();
  /// Reports whether the reader works.
  void reader_is(CardReader reader);

 private:
  void reset(ResetScope scope);
  void clock_was_read(std::uint16_t index) { bus_clock_.told(index); }
  void tell();
  std::uint32_t now();

  static constexpr std::uint32_t no_time_told = 0xFFFF'FFFF;

  CarNetwork& network_;
  DriverIdentificationHardware hardware_;
  BusClock bus_clock_;
  ProvidedObjects clock_objects_;
  ObjectReader clock_reader_;
  bool is_logged_in_ = false;
  bool has_failed_ = false;
  CardReader reader_ = CardReader::working;
  std::uint64_t id_ = 0;
  std::array<char, driver_name_capacity> name_{};
  std::size_t name_length_ = 0;
  std::uint32_t login_ = no_time_told;
  std::uint32_t logout_ = no_time_told;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the driver identification (4.2.15); car_unit makes it a part of a device.
struct DriverIdentificationKind : CarKind<DriverIdentificationUnit, DriverIdentificationHardware,
                                          DriverIdentificationSettings> {
  static constexpr DeviceInfo info = {.name = "driver-identification",
                                      .title = "driver identification",
                                      .product = "Canvoy CiA 447 identification",
                                      .product_code = 44712,
                                      .node_id = 8,
                                      .hardware = "reader of drivers' cards, clock"};
  static constexpr const VirtualDeviceInfo& provides = driver_identification_device;
  static constexpr const ObjectInfo* consumes[] = {&rtc_date_object, &rtc_time_object,
                                                   &rtc_type_and_status_object};
};

}  // namespace canvoy::cia447
