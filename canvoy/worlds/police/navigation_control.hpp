// Application of the navigation of a police car, beside its virtual device: it takes the number of
// a destination from the terminal's number pad, and shows the distance to it.
#pragma once

#include <string>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/terminal_menu.hpp"

namespace canvoy::police {

struct NavigationControlHardware {
  Acted acted = {};
  /// Begins guidance, and returns the distance in m.
  Callback<double(unsigned destination)> guide = {};
};
struct NavigationControlSettings {
  NodeId terminal = 0;
  /// Takes keys of another client: for tests that this is detected.
  bool is_greedy = false;
};

class NavigationControl {
 public:
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

struct NavigationControlKind
    : cia447::CarKind<NavigationControl, NavigationControlHardware, NavigationControlSettings> {
  static constexpr DeviceInfo info = {.name = "navigation-control",
                                      .title = "control of a navigation system"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::police
