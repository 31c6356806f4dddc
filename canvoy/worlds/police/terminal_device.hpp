// The terminal that radio, signals and navigation of a police car share: its keys, and the texts on
// its displays.
//
//     TerminalDevice terminal(bus, sabotage);
//     terminal.press(cia447::NumberPadKey::key_3);
//     if (terminal.client() == Client::radio) ...
#pragma once

#include <optional>
#include <string>

#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/police_options.hpp"

namespace canvoy::police {

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
  void is_unit(cia447::TerminalUnit& unit, Node& /*node*/) { unit_ = &unit; }

  car::CarBus& bus_;
  const Sabotage& sabotage_;
  cia447::TerminalUnit* unit_ = nullptr;
  std::string title_;
  std::string text_1_;
  std::string text_2_;
  unsigned keys_ = 0;
};

}  // namespace canvoy::police
