// The radio: power, push-to-talk, and faults (6115h to 6117h; CiA 447-3, 4.2.18).
//
//     RadioUnit radio(network, {}, {});
//     radio.switching().report(radio_status_error_1, Signal::yes);
//
// It can talk only while it has power. When the power supply (6070h) reports that power is off,
// that is "radio power off detected", and the radio is off. When power returns, it returns to its
// former state.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/car_source.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* radio_commands[] = {&radio_device_command_object};
inline constexpr Effect radio_effects[] = {
    effect(radio_device_command_power, Order::on, radio_device_status_power, Signal::on, 1s),
    effect(radio_device_command_power, Order::off, radio_device_status_power, Signal::off, 100ms),
    effect(radio_device_command_push_to_talk, Order::on, radio_device_status_transmit_push_to_talk,
           Signal::on, 50ms),
    effect(radio_device_command_push_to_talk, Order::off, radio_device_status_transmit_push_to_talk,
           Signal::off, 50ms)};
inline constexpr Rest radio_rests[] = {rest(radio_status_error_1, Signal::no),
                                       rest(radio_status_power_off_detected, Signal::no)};
inline constexpr SwitchedTable radio_table = {
    .commands = radio_commands, .effects = radio_effects, .rests = radio_rests};

class RadioUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  RadioUnit(CarNetwork& network, const SwitchedHardware& hardware,
            const SwitchedSettings& settings);

  /// The machine of commands and states, for the reports of the radio.
  Switching& switching() { return unit_.switching(); }

 private:
  bool commanded(const Commanded& wanted);
  void became(const FieldPlace& status, std::uint32_t code);
  void supply_written(Source source);
  void supply_lost();
  void look_at_supply();

  CarNetwork& network_;
  SwitchedHardware hardware_;
  bool has_supply_ = true;
  bool is_wanted_on_ = false;
  SwitchedUnit<radio_table> unit_;
  CarSource supply_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the radio (4.2.18); car_unit makes it a part of a device.
struct RadioKind : CarKind<RadioUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "radio",
                                      .title = "radio",
                                      .product = "Canvoy CiA 447 radio",
                                      .product_code = 44715,
                                      .node_id = 11,
                                      .hardware = "transceiver: power, push-to-talk, errors"};
  static constexpr const VirtualDeviceInfo& provides = radio_device;
  /// The PDO that carries the first carries both.
  static constexpr std::array<const ObjectInfo*, 2> consumes = {
      &radio_power_supply_status_object, &periphery_power_supply_status_object};
};

}  // namespace canvoy::cia447
