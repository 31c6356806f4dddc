#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"

#include <algorithm>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr unsigned ignition_pdo = 1;
constexpr std::uint16_t asked_for[] = {ignition_switch_status_object.index};
constexpr Supply supplies[] = {Supply::radio, Supply::periphery};

struct Statuses {
  FieldPlace on;
  FieldPlace after_run;
  FieldPlace warning;
  FieldPlace overload;
};
constexpr Statuses statuses_of[] = {
    {.on = place_of(radio_power_supply_status_on),
     .after_run = place_of(radio_power_supply_status_after_run_active),
     .warning = place_of(radio_power_supply_status_cut_off_in_5_minutes),
     .overload = place_of(radio_power_supply_status_overload)},
    {.on = place_of(periphery_power_supply_status_on),
     .after_run = place_of(periphery_power_supply_status_after_run_active),
     .warning = place_of(periphery_power_supply_status_cut_off_in_5_minutes),
     .overload = place_of(periphery_power_supply_status_overload)}};

}  // namespace

constexpr AccessHandlers PowerSupplyUnit::hook_calls[] = {
    after_write<&PowerSupplyUnit::ignition_written, ignition_switch_status_object>};
constexpr ServiceHandlers PowerSupplyUnit::service_calls = {.hooks = hook_calls};

PowerSupplyUnit::PowerSupplyUnit(CarNetwork& network, const PowerSupplyHardware& hardware,
                                 const PowerSupplySettings& settings)
    : network_(network),
      hardware_(hardware),
      lines_{Line{.after_run = settings.radio_after_run},
             Line{.after_run = settings.periphery_after_run}},
      statuses_(network, {.drive = callback<&PowerSupplyUnit::commanded>(*this)},
                settings.switched),
      ignition_(network, {.pdo_number = ignition_pdo,
                          .lost = callback<&PowerSupplyUnit::ignition_lost>(*this)}),
      // Its PDO is sent when the key is turned, and this device may have missed it.
      reader_(network, {.server = gateway_node_id,
                        .indices = asked_for,
                        .period = 10s,
                        .came = callback<&PowerSupplyUnit::ignition_read>(*this)}),
      timer_(callback<&PowerSupplyUnit::look>(*this)) {
  network.node().attach(service_);
}

bool PowerSupplyUnit::commanded(const Commanded& wanted) {
  const bool is_radio = wanted.place.index == radio_power_supply_command_object.index;
  const Supply supply = is_radio ? Supply::radio : Supply::periphery;
  lines_[index_of(supply)].is_requested_off = wanted.as<Order>() == Order::on;
  settle(supply, network_.node().now());
  return true;
}

void PowerSupplyUnit::report_overload(Supply supply, bool is_overloaded) {
  lines_[index_of(supply)].is_overloaded = is_overloaded;
  settle(supply, network_.node().now());
}

void PowerSupplyUnit::ignition_written(Source source) {
  ignition_.came(source);
  look_at_ignition();
}

void PowerSupplyUnit::ignition_read(std::uint16_t /*index*/) {
  ignition_.came_from(gateway_node_id);
  look_at_ignition();
}

/// While the state of the ignition is not known, the battery is spared.
void PowerSupplyUnit::ignition_lost() {
  const Values car(network_.node().dictionary());
  car[ignition_switch_status_accessory] = Signal::not_available;
  car[ignition_switch_status_on] = Signal::not_available;
  look_at_ignition();
}

void PowerSupplyUnit::look_at_ignition() {
  const Values car(network_.node().dictionary());
  const bool was_ignited = is_ignited_;
  is_ignited_ = car[ignition_switch_status_accessory].is(Signal::yes) ||
                car[ignition_switch_status_on].is(Signal::yes);
  if (is_ignited_ == was_ignited) return;
  const Time now = network_.node().now();
  for (const Supply supply : supplies) {
    Line& line = lines_[index_of(supply)];
    if (is_ignited_) line.is_requested_off = false;
    line.cut_off = line.is_on && !is_ignited_ ? now + line.after_run : never;
    settle(supply, now);
  }
}

void PowerSupplyUnit::look(Time now) {
  for (const Supply supply : supplies) settle(supply, now);
}

void PowerSupplyUnit::settle(Supply supply, Time now) {
  Line& line = lines_[index_of(supply)];
  if (line.cut_off <= now) line.cut_off = never;
  const bool runs_after = !is_ignited_ && line.cut_off != never;
  const bool is_on = (is_ignited_ || runs_after) && !line.is_requested_off && !line.is_overloaded;
  if (runs_after && line.is_requested_off) line.cut_off = never;
  const bool is_warning = is_on && runs_after && line.cut_off - now <= warning;
  const Statuses& status = statuses_of[index_of(supply)];
  const auto tell = [this](const FieldPlace& place, bool is_so) {
    switching().report(place, static_cast<std::uint32_t>(is_so ? Signal::yes : Signal::no));
  };
  tell(status.on, is_on);
  tell(status.after_run, is_on && runs_after);
  tell(status.warning, is_warning);
  tell(status.overload, line.is_overloaded);
  if (line.is_on != is_on && hardware_.switch_power) hardware_.switch_power(supply, is_on);
  line.is_on = is_on;
  if (line.cut_off == never) return;
  const Time next = line.cut_off - now > warning ? line.cut_off - warning : line.cut_off;
  if (next < timer_.at()) network_.node().timers().arm(timer_, next);
}

}  // namespace canvoy::cia447
