// A car position unit: up to four encoders that measure the position and the speed of the car, and
// whether it is within its work areas (CiA 417-4, 4.9; the values are those of CiA 406); with a
// position CAM unit (4.10).
//
//     CarPositionUnit position(node, {.tpdos = &tpdos}, hardware, {.lift = 1});
//     node.start(now);
//
// It samples often while the car moves, and rarely while it stands. A PDO that its event timer
// sends is sampled at that moment. An alarm of an encoder is an emergency with the position unit as
// instance. With overspeed_millimetre_per_second, it monitors the speed, and reports overspeed by
// emergency FF05h, on which the drive stops.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/lift/lift_bound.hpp"
#include "canvoy/devices/cia417/position/car_position_hardware.hpp"
#include "canvoy/devices/cia417/position/position_cam_unit.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/model/written_value.hpp"

namespace canvoy::cia417 {

/// Properties of an encoder, from its maker.
struct EncoderProperties {
  /// For a rotary encoder: travel of the car in one revolution, in micrometres; 0: it is linear.
  double revolution_micrometre = 0;
  std::uint32_t single_turn_resolution = 100'000;  ///< 63C1h; for a linear encoder its step in nm
  std::uint16_t revolutions = 1;                   ///< 63C2h
  std::int32_t manufacturer_offset = 0;            ///< 63D0h
  std::uint32_t position_min = 0;                  ///< smallest position, in its steps
  std::uint32_t position_max = 0x7FFF'FFFF;        ///< largest position, in its steps
  std::uint16_t supported_alarms = 0x0001;         ///< bits of the alarms, CiA 406
  std::uint16_t supported_warnings = 0x003F;       ///< bits of the warnings, CiA 406
  std::uint32_t operating_time = 0;                ///< tenths of an hour, before power-on
};

/// Settings of a position unit.
struct CarPositionSettings {
  unsigned lift = 1;                           ///< 1 to 8
  Duration moving_period = 20ms;               ///< of sampling
  Duration standing_period = 50ms;             ///< while the car stands
  double overspeed_millimetre_per_second = 0;  ///< 0: not monitored
  /// Error code of an alarm. The public sources of CiA 406 have no code for it: this is a fault of
  /// the hardware.
  std::uint16_t alarm_code = 0x5000;
  std::array<EncoderProperties, position_unit_count> encoders = {};  ///< of encoders 1 to 4
  std::span<const Cam> cams = {};                                    ///< none: no position CAM unit
};

/// Services of a node that it uses.
struct CarPositionServices {
  Tpdos* tpdos = nullptr;  ///< sampled before they are sent
};

class CarPositionUnit {
 public:
  /// Everything to which `hardware` and `services` refer must outlive this.
  CarPositionUnit(Node& node, const CarPositionServices& services,
                  const CarPositionHardware& hardware, const CarPositionSettings& settings);

  /// Position of unit 1 to 4, in counts, as in 6383h.
  std::int32_t position(unsigned unit) const;
  /// What an encoder, 1 to 4, has reported last.
  const PositionReadings& readings(unsigned unit) const { return units_[unit - 1].readings; }

 private:
  struct Unit {
    bool exists = false;
    bool has_alarm = false;
    double sign = 1;        ///< from the operating parameter
    double step = 0.1;      ///< millimetres per count
    double speed_step = 1;  ///< mm/s
    double acceleration_step = 1;
    std::int64_t offset = 0;  ///< counts; an encoder keeps the offset without power
    PositionReadings readings;
  };

  void reset(ResetScope scope);
  AbortCode check_parameter(Raw<std::uint16_t> wanted);
  AbortCode check_step(Raw<std::uint32_t> wanted);
  AbortCode check_preset(const Entry& entry, std::span<const std::uint8_t> value);
  void preset_written(const Entry& entry);
  void parameter_written();
  void cam_setting_written() { cams_.refresh(); }
  void before_transmit(std::uint16_t number);

  void configure(unsigned unit);
  void describe(unsigned unit);
  void preset(unsigned unit);
  std::int64_t measured(const Unit& unit) const;
  void tick(Time now);
  void sample();
  void sample(unsigned unit);
  void report_areas(unsigned unit, std::int32_t position);
  void report_errors(unsigned unit);
  void watch_speed(double speed);

  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(node_.dictionary())[in_lift(settings_.lift, handle)];
  }

  Node& node_;
  CarPositionHardware hardware_;
  CarPositionSettings settings_;
  PositionCamUnit cams_;
  std::array<Unit, position_unit_count> units_;
  bool is_too_fast_ = false;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
