// The displays of a bus, in all cars.
//
//     BusDisplays displays(nodes, options.sabotage, changed);
//     displays.at(next_stop_id).text()
#pragma once

#include <array>
#include <memory>

#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/shown_display.hpp"

namespace canvoy::bus_line {

/// The displays for passengers.
inline constexpr std::array<DeviceKey, 10> display_ids = {
    front_display_id, next_stop_id,      information_id,  side_display_id,   destination_of(2),
    next_stop_of(2),  destination_of(3), next_stop_of(3), destination_of(4), next_stop_of(4)};

/// Size of a display where the design states none.
BusDisplay::Size usual_size(DeviceKey key);

class BusDisplays {
 public:
  /// All must outlive this object. `changed` is called when the text on any display changes.
  BusDisplays(BusNodes& nodes, const Sabotage& sabotage, const Callback<void()>& changed)
      : nodes_(nodes), sabotage_(sabotage), changed_(changed) {}
  BusDisplays(const BusDisplays&) = delete;
  BusDisplays& operator=(const BusDisplays&) = delete;

  /// Puts the displays of the first car on the bus.
  void add_first_car();
  /// Puts the displays of car 2, 3 or 4 on the bus.
  void add_following_car(unsigned car);
  /// Takes power from a display; does nothing to other nodes.
  void lose_power(DeviceKey key);

  /// A display of this bus.
  const ShownDisplay& at(DeviceKey key) const { return *displays_.at(key); }
  /// Null where the device is no display, or does not exist yet.
  const ShownDisplay* find(DeviceKey key) const {
    return key > node_id_max ? nullptr : displays_.at(key).get();
  }
  /// True if a sign that the bus will stop is lit in this car.
  bool is_sign_lit(unsigned car) const;

 private:
  void add(DeviceKey key, const ShownDisplay::Sabotage& sabotage);
  BusDisplay::Size size_of(DeviceKey key) const;
  Time clock() { return nodes_.world().now(); }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  Callback<void()> changed_;
  std::array<std::unique_ptr<ShownDisplay>, node_id_max + 1> displays_;
};

}  // namespace canvoy::bus_line
