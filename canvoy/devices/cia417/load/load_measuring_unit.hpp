// A load measuring unit: weighs the car by its ropes, and reports which limits the load has reached
// (6480h to 6485h; CiA 417-4, 4.12).
//
//     LoadMeasuringUnit load(node, {.rope_load = Callback<std::optional<double>(unsigned)>::to<
//                                       &LoadCell::rope_load>(cell)}, {.ropes = 6});
//
// Zero load is reached at and below its limit, the others at and above (errata B25). A signal with
// a bit of 0 in 6482h:02h changes without a message; the next message contains it.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia417/handles.hpp"
#include "canvoy/profiles/model/written_value.hpp"

namespace canvoy::cia417 {

/// The load cell.
struct LoadHardware {
  /// Load of a rope, from 1 on, in kg, including the empty car; nothing: its sensor has failed.
  Callback<std::optional<double>(unsigned rope)> rope_load;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(LoadHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::rope_load; }, "LoadHardware needs a member function rope_load");
  hardware.rope_load = callback<&Plain::rope_load>(plain);
}

/// Settings of a load measuring unit.
struct LoadSettings {
  unsigned lift = 1;   ///< 1 to 8
  unsigned ropes = 1;  ///< 1 to 254
  double tare_kg = 0;  ///< of the empty car
  // Values of 6483h and 6485h after a reset if their defaults are "unused" and nothing: for a car
  // of 630 kg, in kg. A maker that stores parameters describes other defaults.
  std::uint16_t zero_load = 20;       ///< below: the car is empty
  std::uint16_t norm_load = 315;      ///< half of the greatest load
  std::uint16_t full_load = 504;      ///< from here on no further passengers
  std::uint16_t overload = 693;       ///< from here on the car must not start
  std::uint16_t rope_ratio = 0x0101;  ///< nominator above denominator: 0201h for 2:1
  /// Period of readings of the hardware; zero: read when the hardware reports a change.
  Duration sensing_period = 100ms;
};

class LoadMeasuringUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  LoadMeasuringUnit(Node& node, const LoadHardware& hardware, const LoadSettings& settings);

  /// Reads the hardware at the next call of the node.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }

 private:
  void reset(ResetScope scope);
  AbortCode check_unit(Raw<std::uint16_t> unit);
  AbortCode check_ratio(Raw<std::uint16_t> ratio);
  void look_again();
  void look(Time now);
  std::optional<double> weigh();
  std::uint16_t in_unit(double kilograms) const;
  void report_load(std::optional<std::uint16_t> load);
  void signal(std::optional<std::uint16_t> load);
  void report_signals(std::uint8_t signals);

  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(node_.dictionary())[in_lift(settings_.lift, handle)];
  }

  Node& node_;
  LoadHardware hardware_;
  LoadSettings settings_;
  bool is_defect_ = false;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
