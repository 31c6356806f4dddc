// A load measuring unit: weighs the car by its ropes, and tells which limits the load has reached
// (6480h to 6485h; CiA 417-4, 4.12).
//
//     LoadMeasuringUnit load(node, {.rope_load = Callback<std::optional<double>(unsigned)>::to<
//                                       &LoadCell::rope_load>(cell)}, {.ropes = 6});
//
// Zero load is reached at and below its limit, the others at and above (errata B25). A signal of
// which the bit in 6482h:02h is 0 changes without a message; the next one takes it along.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia417/handles.hpp"
#include "canvoy/profiles/written_value.hpp"

namespace canvoy::cia417 {

struct LoadHardware {
  /// What pulls at a rope, from 1 on, in kg, the empty car included; nothing: its sensor fails.
  Callback<std::optional<double>(unsigned rope)> rope_load;
};

struct LoadSettings {
  unsigned lift = 1;   ///< 1 to 8
  unsigned ropes = 1;  ///< 1 to 254
  double tare_kg = 0;  ///< of the empty car
  // What 6483h and 6485h hold after a reset where their defaults are "unused" and nothing: for a
  // car of 630 kg, in kg. A maker who stores parameters describes defaults of his own.
  std::uint16_t zero_load = 20;
  std::uint16_t norm_load = 315;
  std::uint16_t full_load = 504;
  std::uint16_t overload = 693;
  std::uint16_t rope_ratio = 0x0101;  ///< nominator above denominator: 0201h for 2:1
  /// How often the hardware is looked at; zero: when it says that it has changed.
  Duration sensing_period = 100ms;
};

class LoadMeasuringUnit {
 public:
  /// What `hardware` refers to must outlive this.
  LoadMeasuringUnit(Node& node, const LoadHardware& hardware, const LoadSettings& settings);
  LoadMeasuringUnit(const LoadMeasuringUnit&) = delete;
  LoadMeasuringUnit& operator=(const LoadMeasuringUnit&) = delete;

  /// Has the hardware looked at when the node is called next.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }

 private:
  void reset(ResetScope scope);
  AbortCode check_unit(Raw<std::uint16_t> unit);
  AbortCode check_ratio(Raw<std::uint16_t> ratio);
  void look_again();
  void look(Time now);
  std::optional<double> weigh();
  std::uint16_t in_unit(double kilograms) const;
  void tell_load(std::optional<std::uint16_t> load);
  void signal(std::optional<std::uint16_t> load);
  void tell_signals(std::uint8_t signals);

  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(node_.dictionary())[in_lift(settings_.lift, handle)];
  }

  Node& node_;
  LoadHardware hardware_;
  LoadSettings settings_;
  bool is_defect_ = false;
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
