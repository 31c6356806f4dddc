// A police car with its devices, and the inputs of the gateway from the car: ignition and locks.
//
//     PoliceCar car(bus, options, acted, events);
//     for (const auto& node : bus.nodes()) car.power(*node, true);
//     car.turn_ignition(true);
//     car.signals().siren_is_heard()
#pragma once

#include <optional>
#include <string>

#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/car/drive.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/police_event.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/radio_devices.hpp"
#include "canvoy/worlds/police/signal_devices.hpp"
#include "canvoy/worlds/police/supply_device.hpp"
#include "canvoy/worlds/police/surroundings.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

// The navigation of a police car with its satellite receiver: it finds the scene by the number of a
// call, and leads there along a road to the north.
//
//     NavigationDevice navigation(bus, drive, sabotage, acted);
//     navigation.know(call.destination);
//     navigation.scene_lies_ahead(call.metres);

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

/// The application of the navigation of a police car, beside its virtual device.
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

/// The navigation of a police car with its satellite receiver, as a device on the bus.
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

/// The terminal that radio, signals and navigation of a police car share: its keys, and the texts
/// on its displays.
///
///     TerminalDevice terminal(bus, sabotage);
///     terminal.press(cia447::NumberPadKey::key_3);
///     if (terminal.client() == Client::radio) ...
class TerminalDevice {
 public:
  /// Time for which a key is held.
  static constexpr Duration key_time = 200ms;

  /// All must outlive this object.
  TerminalDevice(car::CarBus& bus, const Sabotage& sabotage) : bus_(bus), sabotage_(sabotage) {}
  TerminalDevice(const TerminalDevice&) = delete;
  TerminalDevice& operator=(const TerminalDevice&) = delete;

  /// Puts the device on the bus.
  void add_node();
  /// Takes power from the device; does nothing to other nodes.
  void lose_power(NodeId id);
  /// Presses a NumberPadKey or FunctionKey. Only while it has power.
  template <class Key>
  void press(Key key) {
    ++keys_;
    unit_->press(key);
    bus_.touched(terminal_id);
    bus_.world().at(bus_.world().now() + key_time, [this, key](Time) {
      unit_->release(key);
      bus_.touched(terminal_id);
    });
  }

  /// Presses the emergency key. Only while it has power.
  void press_emergency_key();

  /// Title on display 1.
  const std::string& title() const { return title_; }
  /// First text of display 1.
  const std::string& text_1() const { return text_1_; }
  /// Text of display 2.
  const std::string& text_2() const { return text_2_; }
  /// Client with the title on display 1.
  std::optional<Client> client() const;
  unsigned keys() const { return keys_; }  ///< number of keys pressed
  /// The unit; made again when the terminal gets power, so keep no reference.
  cia447::TerminalUnit& unit() { return *unit_; }

 private:
  cia447::TerminalHardware hardware();
  void show(const cia447::DisplayContent& content);

  car::CarBus& bus_;
  const Sabotage& sabotage_;
  cia447::TerminalUnit* unit_ = nullptr;
  std::string title_;
  std::string text_1_;
  std::string text_2_;
  unsigned keys_ = 0;
};

class PoliceCar {
 public:
  /// All must outlive this object, which puts the devices on the bus. `acted` is called for each
  /// key of the terminal on which a client has acted.
  PoliceCar(car::CarBus& bus, const PoliceOptions& options, const Acted& acted,
            EventLog<PoliceEvent>& events);
  PoliceCar(const PoliceCar&) = delete;
  PoliceCar& operator=(const PoliceCar&) = delete;

  /// Switches power of a device; one that gets power starts from its initial state.
  void power(car::CarNode& node, bool is_on);
  /// Sets the function that receives the reports of the gateway on its network, from its next
  /// power-on.
  void on_event(const Callback<void(const cia447::CarEvent&)>& told) { told_ = told; }

  /// Turns the key of the car, which the gateway reports.
  void turn_ignition(bool is_on);
  /// Turns the key in the door.
  void turn_key(bool is_locked);
  /// True while the key of the car is turned.
  bool is_ignited() const { return is_ignited_; }
  /// Last time that the ignition was switched off; long ago where it was never on.
  Time ignition_off_at() const { return ignition_off_at_; }
  /// True if the doors are locked.
  bool is_locked() const { return is_locked_; }

  /// The bus with its nodes.
  car::CarBus& bus() { return bus_; }
  /// Motion of the car.
  car::Drive& drive() { return drive_; }
  /// Motion of the car.
  const car::Drive& drive() const { return drive_; }
  /// Blue light and siren.
  SignalDevices& signals() { return signals_; }
  /// Blue light and siren.
  const SignalDevices& signals() const { return signals_; }
  /// Power supply of radio and periphery.
  SupplyDevice& supply() { return supply_; }
  /// Power supply of radio and periphery.
  const SupplyDevice& supply() const { return supply_; }
  /// Handset, audio switch and radio.
  RadioDevices& radio() { return radio_; }
  /// Handset, audio switch and radio.
  const RadioDevices& radio() const { return radio_; }
  /// The terminal, with its keys and displays.
  TerminalDevice& terminal() { return terminal_; }
  /// The terminal, with its keys and displays.
  const TerminalDevice& terminal() const { return terminal_; }
  /// Satellites and navigation.
  NavigationDevice& navigation() { return navigation_; }
  /// What is heard and read at present.
  Surroundings around() const;

 private:
  void add_nodes();
  void report_car();
  cia447::CarHardware hardware();
  void car_became(const cia447::FieldPlace& status, std::uint32_t code);
  std::optional<double> speed() { return drive_.speed(); }
  std::optional<double> distance() { return drive_.metres(); }

  car::CarBus& bus_;
  const PoliceOptions& options_;
  car::Drive drive_;
  SupplyDevice supply_;
  TerminalDevice terminal_;
  SignalDevices signals_;
  RadioDevices radio_;
  NavigationDevice navigation_;
  cia447::IvnGatewayUnit* gateway_ = nullptr;
  Callback<void(const cia447::CarEvent&)> told_;
  bool is_making_gateway_ = false;
  bool is_ignited_ = false;
  bool is_locked_ = true;
  Time ignition_off_at_ = Time(-24h);
};

}  // namespace canvoy::police
