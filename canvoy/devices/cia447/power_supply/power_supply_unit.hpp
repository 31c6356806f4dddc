// Power supply of radio and periphery: power is on while the ignition is on and for a time after
// that (6070h, 6071h, 6073h, 6074h; CiA 447-3, 4.2.7).
//
//     PowerSupplyUnit supply(network, {.switch_power = ...}, {.radio_after_run = 1h});
//     supply.report_overload(Supply::radio, true);
//
// Five minutes before the end of the after-run, the unit reports that power will be cut off. A
// request to cut it off is executed at once, and holds until it is cancelled or the ignition is
// switched on again. An overload switches the power off while it lasts.
#pragma once

#include <array>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/object_reader.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

/// A line with a switch of its own.
enum class Supply : std::uint8_t { radio, periphery };

/// The switches of the lines.
struct PowerSupplyHardware {
  /// Called when the power of a supply is switched on or off.
  Callback<void(Supply, bool is_on)> switch_power = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(PowerSupplyHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::switch_power; },
      "the class has no member function of PowerSupplyHardware: switch_power");
  if constexpr (requires { &Plain::switch_power; })
    hardware.switch_power = callback<&Plain::switch_power>(plain);
}

/// Times of after-run.
struct PowerSupplySettings {
  // Time with power after the ignition is switched off.
  Duration radio_after_run = 30min;      ///< of the radio
  Duration periphery_after_run = 15min;  ///< of the periphery
  SwitchedSettings switched = {};        ///< of the functions that are switched
};

inline constexpr const ObjectInfo* power_supply_commands[] = {
    &radio_power_supply_command_object, &periphery_power_supply_command_object};
inline constexpr Rest power_supply_rests[] = {
    rest(radio_power_supply_status_on, Signal::no),
    rest(radio_power_supply_status_after_run_active, Signal::no),
    rest(radio_power_supply_status_cut_off_in_5_minutes, Signal::no),
    rest(radio_power_supply_status_overload, Signal::no),
    rest(periphery_power_supply_status_on, Signal::no),
    rest(periphery_power_supply_status_after_run_active, Signal::no),
    rest(periphery_power_supply_status_cut_off_in_5_minutes, Signal::no),
    rest(periphery_power_supply_status_overload, Signal::no)};
inline constexpr SwitchedTable power_supply_table = {.commands = power_supply_commands,
                                                     .rests = power_supply_rests};

class PowerSupplyUnit {
 public:
  static constexpr Duration warning = 5min;  ///< before the power goes off

  /// Everything to which `hardware` and `settings` refer must outlive this.
  PowerSupplyUnit(CarNetwork& network, const PowerSupplyHardware& hardware,
                  const PowerSupplySettings& settings);

  /// Reports an overload of a line, which is then off.
  void report_overload(Supply supply, bool is_overloaded);
  /// True while a line has power.
  bool has_power(Supply supply) const { return lines_.at(index_of(supply)).is_on; }
  /// To report sensors that have failed.
  Switching& switching() { return statuses_.switching(); }

 private:
  struct Line {
    Duration after_run;
    Time cut_off = never;  ///< of the after-run
    bool is_on = false;
    bool is_requested_off = false;
    bool is_overloaded = false;
  };

  static std::size_t index_of(Supply supply) { return static_cast<std::size_t>(supply); }
  bool commanded(const Commanded& wanted);
  void ignition_written(Source source);
  void ignition_read(std::uint16_t index);
  void ignition_lost();
  void look_at_ignition();
  void look(Time now);
  void settle(Supply supply, Time now);

  CarNetwork& network_;
  PowerSupplyHardware hardware_;
  std::array<Line, 2> lines_;
  bool is_ignited_ = false;
  SwitchedUnit<power_supply_table> statuses_;
  CarSource ignition_;
  ObjectReader reader_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the power supply of radio and periphery (4.2.7);
/// car_unit makes it a part of a device.
struct PowerSupplyKind : CarKind<PowerSupplyUnit, PowerSupplyHardware, PowerSupplySettings> {
  static constexpr DeviceInfo info = {.name = "power-supply",
                                      .title = "power supply of radio and periphery",
                                      .product = "Canvoy CiA 447 power supply",
                                      .product_code = 44704,
                                      .node_id = 10,
                                      .hardware = "two supplies: on or off, overload"};
  static constexpr const VirtualDeviceInfo& provides = power_supply_device;
  static constexpr std::array<const ObjectInfo*, 1> consumes = {&ignition_switch_status_object};
};

}  // namespace canvoy::cia447
