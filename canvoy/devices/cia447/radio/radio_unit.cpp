#include "canvoy/devices/cia447/radio/radio_unit.hpp"

#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr unsigned power_supply_pdo = 84;

}  // namespace

constexpr AccessHandlers RadioUnit::hook_calls[] = {
    after_write<&RadioUnit::supply_written, radio_power_supply_status_object>};
constexpr ServiceHandlers RadioUnit::service_calls = {.hooks = hook_calls};

RadioUnit::RadioUnit(CarNetwork& network, const SwitchedHardware& hardware,
                     const SwitchedSettings& settings)
    : network_(network),
      hardware_(hardware),
      unit_(network,
            {.drive = callback<&RadioUnit::commanded>(*this),
             .became = callback<&RadioUnit::became>(*this)},
            settings),
      supply_(network, {.pdo_number = power_supply_pdo,
                        .lost = callback<&RadioUnit::supply_lost>(*this),
                        .read = callback<&RadioUnit::look_at_supply>(*this)}) {
  network.node().attach(service_);
}

/// Without power, no command is executed: only a command for the power is stored.
bool RadioUnit::commanded(const Commanded& wanted) {
  if (wanted.is_for(radio_device_command_power)) {
    is_wanted_on_ = wanted.as<Order>() == Order::on;
    if (!has_supply_) return true;
  }
  const bool talks =
      wanted.is_for(radio_device_command_push_to_talk) && wanted.as<Order>() == Order::on;
  if (talks && !switching().is(radio_device_status_power, Signal::on)) return true;
  return hardware_.drive && hardware_.drive(wanted);
}

void RadioUnit::became(const FieldPlace& status, std::uint32_t code) {
  const bool goes_off = status == place_of(radio_device_status_power) &&
                        code == static_cast<std::uint32_t>(Signal::off);
  if (goes_off) switching().report(radio_device_status_transmit_push_to_talk, Signal::off);
  if (hardware_.became) hardware_.became(status, code);
}

void RadioUnit::supply_written(Source source) {
  supply_.came(source);
  look_at_supply();
}

/// The radio itself detects whether there is power.
void RadioUnit::supply_lost() {
  Values(network_.node().dictionary())[radio_power_supply_status_on] = Signal::not_available;
  look_at_supply();
}

void RadioUnit::look_at_supply() {
  const Values car(network_.node().dictionary());
  const bool has_supply = !car[radio_power_supply_status_on].is(Signal::no);
  if (has_supply == has_supply_) return;
  has_supply_ = has_supply;
  switching().report(radio_status_power_off_detected, has_supply ? Signal::no : Signal::yes);
  if (!has_supply) {
    switching().report(radio_device_status_power, Signal::off);
    switching().report(radio_device_status_transmit_push_to_talk, Signal::off);
  } else if (is_wanted_on_) {
    switching().command(radio_device_command_power, Order::on);
  }
}

}  // namespace canvoy::cia447
