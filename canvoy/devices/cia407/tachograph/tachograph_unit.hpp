// The tachograph: speed, distance, time, drivers and their driving times (CiA 407, 6.13, 9.2.17).
// Events for it (6002h) restart a trip and adjust the local time.
//
//     TachographUnit tachograph(device, {.read = ...}, {});
//
// An event that adjusts an offset has it in the manufacturer-specific information, the only place
// for it: signed hours in the low byte, signed minutes in the high byte.
#pragma once

#include <array>
#include <string_view>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/devices/cia407/kit/motion_recognition.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The values of a tachograph.
struct TachographReading {
  std::optional<double> speed_kmh = {};            ///< forward or backward
  Direction direction = Direction::not_available;  ///< of travel
  double distance_metres = 0;                      ///< total
  std::optional<CivilTime> utc = {};               ///< nothing: not known
  /// Three characters of the member state and 16 of the card (9.2.17.5).
  using Card = std::array<char, 19>;
  /// Empty: no card.
  std::array<std::string_view, 2> cards = {};
};
/// The tachograph's sensors and cards.
struct TachographHardware {
  Callback<TachographReading()> read = {};  ///< once a period
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TachographHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::read; }, "the class has no member function of TachographHardware: read");
  if constexpr (requires { &Plain::read; }) hardware.read = callback<&Plain::read>(plain);
}
/// Motion sensor, and limits of driving times.
struct TachographSettings {
  double pulses_per_metre = 8;                     ///< of the motion sensor
  Duration break_time = std::chrono::minutes(45);  ///< a rest that ends a driving time
  double trip_begin_metres = 0;  ///< total distance at the start of the present trip
  Duration period = 100ms;       ///< of readings
};

class TachographUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TachographUnit(VirtualDevice& device, const TachographHardware& hardware,
                 const TachographSettings& settings);

  /// Total distance at the start of the present trip.
  double trip_begin_metres() const { return trip_begin_; }

 private:
  static const AccessHandlers hook_calls[];

  void reset(ResetScope scope);
  AbortCode check_event(const Entry& entry, std::span<const std::uint8_t> value);
  void take_event(std::uint8_t flags, std::uint16_t information);
  void look(Time now);
  void tell();
  void count_driving(const TachographReading& reading, Time now);

  VirtualDevice& device_;
  TachographHardware hardware_;
  TachographSettings settings_;
  TachographReading reading_;
  MotionRecognition recognition_;
  double trip_begin_ = 0;
  std::uint8_t flags_ = 0;  ///< pending events
  std::int8_t offset_hours_ = 0;
  std::int8_t offset_minutes_ = 0;
  Duration driven_{};
  Duration rested_{};
  TachographReading::Card driver_{};  ///< of the first slot; zeros: none
  Time looked_{};
  Timer timer_;
};

/// Catalogue row of the tachograph (6.13); bus_unit makes it a part of a device.
struct TachographKind : BusKind<TachographUnit, TachographHardware, TachographSettings> {
  static constexpr DeviceInfo info = {.name = "tachograph",
                                      .title = "tachograph of a bus",
                                      .product = "Canvoy CiA 407 tachograph",
                                      .product_code = 40712,
                                      .node_id = 12,
                                      .hardware = "a motion sensor, a clock, two driver cards"};
  static constexpr const VirtualDeviceInfo& provides = tachograph;
  static constexpr std::array pdos = {own_pdo<tachograph_tpdo>, own_pdo<tachograph_distance_tpdo>,
                                      own_pdo<command_rpdo>};
};

}  // namespace canvoy::cia407
