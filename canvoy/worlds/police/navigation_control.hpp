// Application of the navigation of a police car, beside its virtual device: it takes the number of
// a destination from the terminal's number pad, and shows the distance to it.
#pragma once

#include <string>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

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

}  // namespace canvoy::police
