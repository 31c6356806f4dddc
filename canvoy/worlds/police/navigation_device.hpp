// The navigation of a police car with its satellite receiver: it finds the scene by the number of a
// call, and leads there along a road to the north.
//
//     NavigationDevice navigation(bus, drive, sabotage, acted);
//     navigation.know(call.destination);
//     navigation.scene_lies_ahead(call.metres);
#pragma once

#include <optional>
#include <string>

#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/car/drive.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

// Application of the navigation of a police car, beside its virtual device: it takes the number of
// a destination from the terminal's number pad, and shows the distance to it.

/// What the control reports, and what guides.
struct NavigationControlHardware {
  Acted acted = {};  ///< called at each key that it acts on
  /// Begins guidance, and returns the distance in m.
  Callback<double(unsigned destination)> guide = {};
};
/// The terminal that it uses.
struct NavigationControlSettings {
  NodeId terminal = 0;  ///< node-ID of the terminal
  /// Takes keys of another client: for tests that this is detected.
  bool is_greedy = false;
};

class NavigationControl {
 public:
  /// `network` must outlive this object; it acts once the node runs.
  NavigationControl(cia447::CarNetwork& network, const NavigationControlHardware& hardware,
                    const NavigationControlSettings& settings);
  NavigationControl(const NavigationControl&) = delete;
  NavigationControl& operator=(const NavigationControl&) = delete;

  /// Presses the button at the navigation system.
  void press_button();

 private:
  void reset(ResetScope scope);
  void number_pressed(cia447::NumberPadKey key);
  void key_written(const Entry& entry, Source source);

  cia447::CarNetwork& network_;
  NavigationControlHardware hardware_;
  cia447::TerminalClient terminal_;
  TerminalMenu menu_;
  std::string typed_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers greedy_hooks[];
  static const ServiceHandlers greedy_calls;
  HandlerBinding service_{&service_calls, this};
  HandlerBinding greed_{&greedy_calls, this};
};

/// A CarUnit beside the virtual devices of the navigation; it is not in the catalogue.
struct NavigationControlKind
    : cia447::CarKind<NavigationControl, NavigationControlHardware, NavigationControlSettings> {
  static constexpr DeviceInfo info = {.name = "navigation-control",
                                      .title = "control of a navigation system"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// The keys of the terminal.
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

class NavigationDevice {
 public:
  /// All must outlive this object. `acted` is called for each key on which it has acted.
  NavigationDevice(car::CarBus& bus, const car::Drive& drive, const Sabotage& sabotage,
                   const Acted& acted)
      : bus_(bus), drive_(drive), sabotage_(sabotage), acted_(acted) {}
  NavigationDevice(const NavigationDevice&) = delete;
  NavigationDevice& operator=(const NavigationDevice&) = delete;

  /// Puts the device on the bus.
  void add_node();
  /// Presses the button at the navigation system.
  void press_button();
  /// Sets the number of the call with a known scene; the scenes of other numbers are unknown.
  void know(unsigned destination) { destination_ = destination; }
  /// Sets the distance of the scene from the present position of the car.
  void scene_lies_ahead(double metres) { scene_at_ = drive_.metres() + metres; }

 private:
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  cia447::NavigationHardware hardware();
  cia447::GeoPosition here() const;
  std::optional<cia447::GeoPosition> position() { return here(); }
  double road(const cia447::GeoPosition& from, const cia447::GeoPosition& to);
  NavigationControlHardware control_hardware();
  NavigationControlSettings control_settings();
  double guide(unsigned destination);

  car::CarBus& bus_;
  const car::Drive& drive_;
  const Sabotage& sabotage_;
  Acted acted_;
  cia447::NavigationUnit* unit_ = nullptr;
  NavigationControl* control_ = nullptr;
  std::optional<unsigned> destination_;
  double scene_at_ = 0;  ///< position in m of the drive
};

}  // namespace canvoy::police
