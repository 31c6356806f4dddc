// A car that the test controls, and its gateway on the bench (node-ID 5).
#pragma once

#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447 {

struct DrivenCar {
  std::optional<double> speed = 0;
  std::optional<double> distance = 0;
  std::optional<double> rpm = 0;
  std::optional<double> outside = 15;
  std::optional<double> steering = 0;
  std::optional<double> fuel = 40;
  Gear gear = Gear::none;
  std::string_view vin = "";

  CarHardware hardware() {
    CarHardware car;
    const auto sensor = [](std::optional<double>& value) {
      return Sensor([](void* sensed) { return *static_cast<std::optional<double>*>(sensed); },
                    &value);
    };
    car.speed = sensor(speed);
    car.distance = sensor(distance);
    car.engine_speed = sensor(rpm);
    car.outside_temperature = sensor(outside);
    car.steering_wheel_angle = sensor(steering);
    car.fuel = sensor(fuel);
    car.gear = callback<&DrivenCar::sensed_gear>(*this);
    car.vin = callback<&DrivenCar::sensed_vin>(*this);
    return car;
  }

 private:
  Gear sensed_gear() { return gear; }
  std::string_view sensed_vin() { return vin; }
};

class CarOnBench {
 public:
  explicit CarOnBench(const CarSettings& settings = {})
      : settings_(settings), bench(only_unit<IvnGatewayKind>, [this](Environment& environment) {
          environment.manages_network = false;  // the test is the master
          environment.provide(callback<&DrivenCar::hardware>(car));
          environment.provide(callback<&CarOnBench::settings>(*this));
          environment.watch(unit_);
        }) {}

  IvnGatewayUnit& gateway() { return *unit_; }
  std::string ask(const std::string& request) { return bench.ask(request); }

  DrivenCar car;

 private:
  CarSettings settings() { return settings_; }

  CarSettings settings_;
  IvnGatewayUnit* unit_ = nullptr;

 public:
  CarBench bench;
};

}  // namespace canvoy::cia447
