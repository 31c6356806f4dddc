// Driver identification: who drives, and since when (60F9h to 60FCh; CiA 447-3, 4.2.15).
//
//     DriverIdentificationUnit drivers(network, {.clock = ..., .knows = ...}, {});
//     drivers.log_in({.id = 4711, .name = "A. Driver"});   // a card was put in
//     drivers.log_out();
//
// Login and logout time are of the last driver until the next one logs in; ID and name go with him.
// Times are seconds since 1970-01-01 UTC, by the real time clock on the bus that the settings
// name, else by the hardware's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/car_kind.hpp"
#include "canvoy/devices/cia447/object_reader.hpp"
#include "canvoy/devices/cia447/provided_objects.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"

namespace canvoy::cia447 {

struct DriverCard {
  std::uint64_t id = 0;
  std::string_view name = "";  ///< UTF-8; of more than 64 bytes the rest is cut
};

struct DriverIdentificationHardware {
  /// Nothing: it is not set.
  Callback<std::optional<LocalTime>()> clock = {};
  /// Whether a card may log in; without it all may.
  Callback<bool(std::uint64_t id)> knows = {};
};

struct DriverIdentificationSettings {
  /// Who provides date and time (60F0h, 60F2h, 60F4h): it is asked for them, by SDO, and it alone
  /// may write them. 0: nobody.
  NodeId clock_node = 0;
  Duration asking_period = 10s;
};

/// What becomes of the reader of cards.
enum class CardReader : std::uint8_t { working, failed, not_available };

class DriverIdentificationUnit {
 public:
  /// What `hardware` refers to must outlive this.
  DriverIdentificationUnit(CarNetwork& network, const DriverIdentificationHardware& hardware,
                           const DriverIdentificationSettings& settings);
  DriverIdentificationUnit(const DriverIdentificationUnit&) = delete;
  DriverIdentificationUnit& operator=(const DriverIdentificationUnit&) = delete;

  /// False: somebody is logged in, the reader does not work, or the card is not known; that last is
  /// an identification failure until the next card, or forget_failure().
  bool log_in(const DriverCard& card);
  /// False: nobody is logged in.
  bool log_out();
  /// A card that cannot be read.
  void card_is_unreadable();
  void forget_failure();
  void reader_is(CardReader reader);

  bool is_logged_in() const { return is_logged_in_; }

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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

struct DriverIdentificationKind : CarKind<DriverIdentificationUnit, DriverIdentificationHardware,
                                          DriverIdentificationSettings> {
  static constexpr DeviceInfo info = {.name = "driver-identification",
                                      .title = "driver identification",
                                      .product = "Canvoy CiA 447 driver identification",
                                      .product_code = 44712,
                                      .node_id = 8,
                                      .hardware = "reader of drivers' cards, clock"};
  static constexpr const VirtualDeviceInfo& provides = driver_identification_device;
  static constexpr const ObjectInfo* consumes[] = {&rtc_date_object, &rtc_time_object,
                                                   &rtc_type_and_status_object};
};

}  // namespace canvoy::cia447
