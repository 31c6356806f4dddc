// Discrete inputs: contacts of devices without CANopen that are wired to this one (6078h; CiA
// 447-3, 4.2.8).
//
//     DiscreteInputsUnit inputs(network, {}, {});
//     inputs.switching().report(discrete_inputs_status_ptt_di, Signal::on);
//     inputs.switching().sense(discrete_inputs_status_beacon_sdi, Sensing::not_available);
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

inline constexpr Rest discrete_inputs_rests[] = {
    rest(discrete_inputs_status_taximeter_di, Signal::no),
    rest(discrete_inputs_status_ptt_di, Signal::no),
    rest(discrete_inputs_status_occupdet_di, Signal::no),
    rest(discrete_inputs_status_roof_sign_di, Signal::no),
    rest(discrete_inputs_status_beacon_sdi, Signal::no)};
inline constexpr SwitchedTable discrete_inputs_table = {.rests = discrete_inputs_rests};

/// The unit is its table.
using DiscreteInputsUnit = SwitchedUnit<discrete_inputs_table>;

/// Catalogue row of the discrete inputs (4.2.8); car_unit makes it a part of a device.
struct DiscreteInputsKind : CarKind<DiscreteInputsUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "discrete-inputs",
                                      .title = "discrete inputs",
                                      .product = "Canvoy CiA 447 discrete inputs",
                                      .product_code = 44705,
                                      .node_id = 16,
                                      .hardware = "five contacts: active or not"};
  static constexpr const VirtualDeviceInfo& provides = discrete_inputs_device;
};

}  // namespace canvoy::cia447
