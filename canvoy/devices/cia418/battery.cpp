#include "canvoy/devices/cia418/battery.hpp"

#include <array>

#include "canvoy/canopen/pdo/pdo_parameter.hpp"

namespace canvoy::cia418 {

constexpr ServiceHandlers Battery::service_calls = {.reset = method<&Battery::reset>};

Battery::Battery(Node& node, const BatteryHardware& hardware, const BatterySettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      status_(node.dictionary()),
      charger_status_(node.dictionary()),
      temperature_(node.dictionary()),
      voltage_(node.dictionary()),
      requested_(node.dictionary()),
      state_of_charge_(node.dictionary()),
      expended_(node.dictionary()),
      total_(node.dictionary()),
      timer_(callback<&Battery::sense>(*this)) {
  node.attach(service_);
}

void Battery::reset(ResetScope) {
  const Values values(node_.dictionary());
  values[battery_type] = settings_.type;
  values[capacity] = settings_.capacity_ampere_hours;
  values[maximum_charge_current] = settings_.current_max_ampere;
  values[number_of_cells] = settings_.cells;
  if (!settings_.requests_current) withdraw_request();
  sense(node_.now());
}

void Battery::withdraw_request() {
  constexpr std::uint16_t parameters = tpdo3_parameter_object.index;
  const auto cob_id =
      static_cast<std::uint32_t>(node_.dictionary().number(parameters, pdo_sub::cob_id));
  std::array<std::uint8_t, 4> invalid{};
  store(invalid.data(), cob_id | CobId::bit31);
  node_.dictionary().write(parameters, pdo_sub::cob_id, invalid, Source::application);
}

void Battery::sense(Time now) {
  node_.timers().arm(timer_, now + settings_.sensing_period);
  readings_ = hardware_.sense();
  status_ = readings_.ready ? Readiness::ready : Readiness::not_ready;
  temperature_ = readings_.temperature_celsius;
  voltage_ = readings_.voltage_volt;
  requested_ = readings_.requested_current_ampere;
  state_of_charge_ = readings_.state_of_charge_percent;
  expended_ = readings_.ampere_hours_since_charge;
  total_ = readings_.ampere_hours_total;
}

}  // namespace canvoy::cia418
