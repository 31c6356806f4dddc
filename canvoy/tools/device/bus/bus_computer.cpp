#include "canvoy/tools/device/bus/bus_computer.hpp"

namespace canvoy::tools {

namespace {

constexpr double cabin_celsius = 20;

}  // namespace

void BusComputer::join(Environment& environment) {
  using namespace cia407;
  environment.provide(Callback<MainOnBoardComputerHardware()>::to<&BusComputer::hardware>(*this));
  environment.watch(
      Callback<void(MainOnBoardComputerUnit&, Node&)>::to<&BusComputer::is_unit>(*this));
  environment.provide(
      Callback<IdentificationHardware()>::to<&BusComputer::identification_hardware>(*this));
  environment.watch(
      Callback<void(IdentificationUnit&, Node&)>::to<&BusComputer::is_identification>(*this));
}

void BusComputer::act(const BusPress& press) {
  if (press.what == "log-in" || press.what == "log-out") log_in(press);
  if (press.what == "stop") unit_->request_stop();
  if (press.what == "block" || press.what == "unblock") {
    unit_->block_tickets(press.what == "block");
  }
  if (press.what == "place") place(press);
}

/// After a log-out there is no assignment.
void BusComputer::log_in(const BusPress& press) {
  const auto given = [&](std::string_view name) { return press.number(name).value_or(0); };
  assignment_ = {.driver_id = given("driver"),
                 .destination_number = given("destination"),
                 .line_id = static_cast<std::uint16_t>(given("line")),
                 .route_number = static_cast<std::uint16_t>(given("route")),
                 .block_id = given("block"),
                 .journey_number = static_cast<std::uint16_t>(given("journey"))};
  identification_->log_in(assignment_);
}

void BusComputer::place(const BusPress& press) {
  unit_->set_position(
      {.stop_point_id = press.number("stop").value_or(0),
       .number_of_running = static_cast<std::uint8_t>(press.number("running").value_or(1)),
       .fare_zone = static_cast<std::uint8_t>(press.number("zone").value_or(0)),
       .route_segment = static_cast<std::uint16_t>(press.number("segment").value_or(0))});
}

cia407::MainOnBoardComputerHardware BusComputer::hardware() {
  return {.clock = Callback<std::optional<cia407::CivilTime>()>::to<&BusComputer::clock>(*this),
          .inside_temperature = {[](void*) -> std::optional<double> { return cabin_celsius; },
                                 nullptr}};
}

cia407::IdentificationHardware BusComputer::identification_hardware() {
  assignment_ = kept_;
  return {.remembered = Callback<cia407::Assignment()>::to<&BusComputer::remembered>(*this)};
}

}  // namespace canvoy::tools
