#include "canvoy/worlds/police/terminal_device.hpp"

namespace canvoy::police {

void TerminalDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(Callback<TerminalHardware()>::to<&TerminalDevice::hardware>(*this));
  environment.watch(Callback<void(TerminalUnit&, Node&)>::to<&TerminalDevice::is_unit>(*this));
  bus_.add(car::units_of<TerminalKind>, environment);
}

void TerminalDevice::lose_power(NodeId id) {
  if (id != terminal_id) return;
  title_.clear();
  text_1_.clear();
  text_2_.clear();
}

void TerminalDevice::press_emergency_key() {
  if (sabotage_.cuts_emergency_key) return;
  const auto set = [this](bool is_pressed) {
    unit_->press_emergency_key(is_pressed);
    bus_.touched(terminal_id);
  };
  set(true);
  bus_.world().at(bus_.world().now() + key_time, [set](Time) { set(false); });
}

std::optional<Client> TerminalDevice::client() const {
  for (unsigned i = 0; i < client_count; ++i) {
    if (title_ == title_of(Client(i))) return Client(i);
  }
  return std::nullopt;
}

cia447::TerminalHardware TerminalDevice::hardware() {
  cia447::TerminalHardware hardware;
  hardware.show = Callback<void(const cia447::DisplayContent&)>::to<&TerminalDevice::show>(*this);
  return hardware;
}

void TerminalDevice::show(const cia447::DisplayContent& content) {
  if (content.display == cia447::TerminalDisplay::display_2) {
    if (!sabotage_.cuts_display) text_2_ = content.is_on ? content.text : "";
    return;
  }
  title_ = content.is_on ? content.title : "";
  text_1_ = content.is_on ? content.text : "";
}

}  // namespace canvoy::police
