// The IVN gateway: connects the car's own networks to CANopen (CiA 447-3, 4.2.2 to 4.2.4), in three
// function groups: car body electronics, light and signaling, power train.
//
//     IvnGatewayUnit gateway(network, hardware, {.pulses_per_rotation = 60});
//     gateway.report(door_status_driver, Opening::open);
//     gateway.sense(car_light_status_brake, Sensing::failure);
//
// Commands take effect according to the tables (car_body_table.hpp, light_table.hpp,
// power_train_table.hpp); car_seats.hpp has the seats. Measured values are sensed every 100 ms from
// the time when the node becomes operational, and are not available before (4.2.4.6).
#pragma once

#include "canvoy/devices/cia447/ivn_gateway/car_body_table.hpp"
#include "canvoy/devices/cia447/ivn_gateway/car_hardware.hpp"
#include "canvoy/devices/cia447/ivn_gateway/car_seats.hpp"
#include "canvoy/devices/cia447/ivn_gateway/light_table.hpp"
#include "canvoy/devices/cia447/ivn_gateway/power_train_table.hpp"
#include "canvoy/devices/cia447/ivn_gateway/wheel_pulse_counter.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/profiles/cia447/devices.hpp"

namespace canvoy::cia447 {

class IvnGatewayUnit {
 public:
  static constexpr Duration cycle = 100ms;  ///< 4.2.4.1, 4.2.4.4, 4.2.4.6

  /// Everything to which `hardware` and `settings` refer must outlive this.
  IvnGatewayUnit(CarNetwork& network, const CarHardware& hardware, const CarSettings& settings);
  IvnGatewayUnit(const IvnGatewayUnit&) = delete;
  IvnGatewayUnit& operator=(const IvnGatewayUnit&) = delete;

  /// Reports a state of the car: any status that has named states. For the front passenger's seat,
  /// by its place.
  template <class Handle, class State>
    requires requires { typename Handle::Place; }
  void report(const Handle& handle, State state) {
    report(place_of(handle), static_cast<std::uint32_t>(state));
  }
  /// Reports the state of a function, as its sensor has it.
  void report(const FieldPlace& status, std::uint32_t code);
  /// Reports the state of a function by its handle.
  template <class Handle>
    requires requires { typename Handle::Place; }
  void sense(const Handle& handle, Sensing sensing) {
    sense(place_of(handle), sensing);
  }
  /// Reports whether the sensor of a function works.
  void sense(const FieldPlace& status, Sensing sensing);

  /// Functions of the car body (4.2.2).
  Switching& body() { return body_.switching(); }
  /// Functions of light and signaling (4.2.3).
  Switching& light() { return light_.switching(); }
  /// Functions of the power train (4.2.4).
  Switching& power_train() { return power_train_.switching(); }
  /// The front seats.
  CarSeats& seats() { return seats_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void look(Time now);
  void look_at_wheels();
  void look_at_engine();
  void look_at_fuel();
  void look_at_surroundings();
  void tell_constants();
  void tell_pulses(Signal valid);
  template <class Handle>
  void tell(const Handle& handle, const Sensor& sensor, const std::optional<double>& sensed);
  template <class Handle>
  void tell_unknown(const Handle& handle, const Sensor& sensor);

  CarNetwork& network_;
  CarHardware hardware_;
  CarSettings settings_;
  SwitchedUnit<car_body_table> body_;
  SwitchedUnit<car_light_table> light_;
  SwitchedUnit<power_train_table> power_train_;
  CarSeats seats_;
  WheelPulseCounter pulses_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the IVN gateway (4.2.2 to 4.2.4); car_unit makes it a part of a device.
struct IvnGatewayKind : CarKind<IvnGatewayUnit, CarHardware, CarSettings> {
  static constexpr DeviceInfo info = {.name = "ivn-gateway",
                                      .title = "IVN gateway",
                                      .product = "Canvoy CiA 447 IVN gateway",
                                      .product_code = 44701,
                                      .node_id = 1,
                                      .hardware = "the car: speed, distance, engine, fuel, doors"};
  static constexpr const VirtualDeviceInfo& provides = ivn_gateway_device;
  static CarHardware simulated() { return parked_car(); }
};

}  // namespace canvoy::cia447
