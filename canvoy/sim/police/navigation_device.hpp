// The navigation of a police car with its satellite receiver: it knows by the number of a call
// where the scene is, and leads there along a road to the north.
//
//     NavigationDevice navigation(bus, drive, sabotage, acted);
//     navigation.know(call.destination);
//     navigation.scene_lies_ahead(call.metres);
#pragma once

#include <optional>

#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/sim/car/car_bus.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/sim/police/navigation_control.hpp"
#include "canvoy/sim/police/police_options.hpp"

namespace canvoy::police {

class NavigationDevice {
 public:
  /// All must outlive this. `acted` is told of each key that it has acted on.
  NavigationDevice(car::CarBus& bus, const car::Drive& drive, const Sabotage& sabotage,
                   const Acted& acted)
      : bus_(bus), drive_(drive), sabotage_(sabotage), acted_(acted) {}
  NavigationDevice(const NavigationDevice&) = delete;
  NavigationDevice& operator=(const NavigationDevice&) = delete;

  /// Puts it on the bus.
  void add_node();
  /// The button at the navigation system.
  void press_button();
  /// The number of the call, by which its scene is known; of others it knows nothing.
  void know(unsigned destination) { destination_ = destination; }
  /// From where the car is now.
  void scene_lies_ahead(double metres) { scene_at_ = drive_.metres() + metres; }

 private:
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  cia447::NavigationHardware hardware();
  cia447::GeoPosition here() const;
  std::optional<cia447::GeoPosition> position() { return here(); }
  double road(const cia447::GeoPosition& from, const cia447::GeoPosition& to);
  void is_unit(cia447::NavigationUnit& unit, Node& /*node*/) { unit_ = &unit; }
  NavigationControlHardware control_hardware();
  NavigationControlSettings control_settings();
  void is_control(NavigationControl& control, Node& /*node*/) { control_ = &control; }
  double guide(unsigned destination);

  car::CarBus& bus_;
  const car::Drive& drive_;
  const Sabotage& sabotage_;
  Acted acted_;
  cia447::NavigationUnit* unit_ = nullptr;
  NavigationControl* control_ = nullptr;
  std::optional<unsigned> destination_;
  double scene_at_ = 0;  ///< m of the drive
};

}  // namespace canvoy::police
