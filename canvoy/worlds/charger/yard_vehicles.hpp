// The vehicles of a charging yard: they come, wait for their bay, are plugged in one after the
// other, leave and are driven. A vehicle that has reached the goal, or is full, makes room for the
// next one.
//
//     YardVehicles vehicles(yard, bays, [&](Time now, const VehicleMoved& moved) { ... });
//     vehicles.step(now);                    // after each step of the plants of the bays
//     vehicles.cells(2).state_of_charge();   // of the third one, wherever it is
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/worlds/charger/charging_bay.hpp"
#include "canvoy/worlds/charger/yard_event.hpp"
#include "canvoy/worlds/charger/yard_options.hpp"

namespace canvoy::charger {

class YardVehicles {
 public:
  using Bays = std::vector<std::unique_ptr<ChargingBay>>;  ///< bay 1 first
  /// Receives each move of a vehicle, when it has taken place.
  using Note = std::function<void(Time, const VehicleMoved&)>;

  /// All must outlive this object. Takes the batteries away that the bays are made with.
  YardVehicles(const YardOptions& yard, Bays& bays, Note note);

  /// Has vehicles come, leave and return by their plan, and exchanges them at the cables.
  void step(Time now);

  std::size_t size() const { return vehicles_.size(); }
  /// Of a vehicle, from 0 on.
  VehiclePlace place(std::size_t vehicle) const { return vehicles_[vehicle].place; }
  /// The one that the vehicle is charged in, from 1 on, also while it is away.
  unsigned bay(std::size_t vehicle) const { return options_[vehicle].bay; }
  /// The true state of its battery.
  const BatteryPlant& cells(std::size_t vehicle) const;

 private:
  static constexpr std::size_t nobody = ~std::size_t{0};
  static constexpr Duration rest_step = 1min;

  struct Vehicle {
    BatteryPlant battery;  ///< while it is not at the cable
    VehiclePlace place = VehiclePlace::away;
    bool has_come = false;
    bool has_left = false;
    bool has_returned = false;
  };
  struct Cable {
    std::size_t vehicle = nobody;
    std::vector<std::size_t> waiting;  ///< in the order in which they came
    Time free_at{};
  };

  void come_and_go(Time now, std::size_t vehicle);
  void serve(Time now, std::size_t bay);
  bool is_served(std::size_t vehicle) const;
  void arrive(Time now, std::size_t vehicle);
  void leave(Time now, std::size_t vehicle);
  void drive(std::size_t vehicle);
  void plug(Time now, std::size_t vehicle);
  void unplug(Time now, std::size_t bay, VehiclePlace to);
  void move(Time now, std::size_t vehicle, VehiclePlace to);
  ChargerDevices& devices(std::size_t bay) { return (*bays_)[bay]->devices(); }

  const YardOptions* yard_;
  std::span<const YardVehicle> options_;
  Bays* bays_;
  Note note_;
  std::vector<Vehicle> vehicles_;
  std::vector<Cable> cables_;
  Time rested_at_{};
};

}  // namespace canvoy::charger
