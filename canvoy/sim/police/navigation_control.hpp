// What the navigation of a police car does beside its virtual device: it takes the number of a
// destination from the terminal's number pad, and shows how far that is.
#pragma once

#include <string>

#include "canvoy/devices/cia447/car_kind.hpp"
#include "canvoy/sim/car/application.hpp"
#include "canvoy/sim/police/client.hpp"
#include "canvoy/sim/police/terminal_menu.hpp"

namespace canvoy::police {

struct NavigationControlHardware {
  Acted acted = {};
  /// Begins to guide there, and says how far it is, in m.
  Callback<double(unsigned destination)> guide = {};
};
struct NavigationControlSettings {
  NodeId terminal = 0;
  /// Takes keys that are another client's: for who looks whether that is seen.
  bool is_greedy = false;
};

class NavigationControl {
 public:
  NavigationControl(cia447::CarNetwork& network, const NavigationControlHardware& hardware,
                    const NavigationControlSettings& settings);
  NavigationControl(const NavigationControl&) = delete;
  NavigationControl& operator=(const NavigationControl&) = delete;

  /// The button at the navigation system.
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
  static const ServiceCalls service_calls;
  static const HookCalls greedy_hooks[];
  static const ServiceCalls greedy_calls;
  ServiceLink service_{&service_calls, this};
  ServiceLink greed_{&greedy_calls, this};
};

struct NavigationControlKind
    : cia447::CarKind<NavigationControl, NavigationControlHardware, NavigationControlSettings> {
  static constexpr DeviceInfo info = {.name = "navigation-control",
                                      .title = "control of a navigation system"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::police
