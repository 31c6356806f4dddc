#include "canvoy/sim/police/terminal_device.hpp"

namespace canvoy::police {

void TerminalDevice::add_node() {
  using namespace cia447;
  Site& site = bus_.add_site();
  site.offer(Callback<TerminalHardware()>::to<&TerminalDevice::hardware>(*this));
  site.watch(Callback<void(TerminalUnit&, Node&)>::to<&TerminalDevice::is_unit>(*this));
  bus_.add(car::units_of<TerminalKind>, site);
}

void TerminalDevice::lose_power(NodeId id) {
  if (id != terminal_id) return;
  title_.clear();
  text_1_.clear();
  text_2_.clear();
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
