// What people do with a device of CiA 407.
#include <fmt/format.h>

#include <array>
#include <functional>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/tools/device/device_bus_panel.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration key_time = 300ms;
constexpr std::size_t relayed_value_max = 4;

std::string_view ticket_answer_text(cia407::TicketAnswer answer) {
  switch (answer) {
    case cia407::TicketAnswer::done:
      return "";
    case cia407::TicketAnswer::blocked:
      return "it is blocked";
    case cia407::TicketAnswer::not_in_service:
      return "it is not in service";
    case cia407::TicketAnswer::out_of_paper:
      return "there is no paper";
  }
  return "";
}

}  // namespace

void BusPanel::act(const BusPress& press, Node& node) {
  act_on_tickets(press);
  act_as_driver(press);
  act_on_counter(press);
  act_on_computer(press);
  if (press.what == "from-train") receive(press, node);
  if (press.what == "connect" || press.what == "disconnect") {
    is_disconnected_ = press.what == "disconnect";
  }
  if (press.what == "signal" || press.what == "no-signal") has_signal_ = press.what == "signal";
  const auto code = static_cast<std::uint16_t>(press.number().value_or(0));
  if (press.what == "fail") errors_.insert(code);
  if (press.what == "mend") errors_.erase(code);
}

void BusPanel::answer(cia407::TicketAnswer answer, std::string_view who) {
  if (answer == cia407::TicketAnswer::done) return;
  place_.output.say(who, fmt::format("no ticket: {}", ticket_answer_text(answer)));
}

void BusPanel::act_on_tickets(const BusPress& press) {
  if (press.what == "ticket") {
    answer(unit<cia407::TicketCancellerUnit>()->insert_ticket(), "ticket-canceller");
  } else if (press.what == "sell") {
    answer(unit<cia407::TicketPrinterUnit>()->sell_ticket(), "ticket-printer");
  } else if (press.what == "paper" || press.what == "no-paper") {
    has_paper_ = press.what == "paper";
  }
}

void BusPanel::act_as_driver(const BusPress& press) {
  const unsigned number = press.number().value_or(0);
  if (press.what == "log-in" || press.what == "log-out") {
    const auto given = [&](std::string_view name) { return press.number(name).value_or(0); };
    assignment_ = {.driver_id = given("driver"),
                   .destination_number = given("destination"),
                   .line_id = static_cast<std::uint16_t>(given("line")),
                   .route_number = static_cast<std::uint16_t>(given("route")),
                   .block_id = given("block"),
                   .journey_number = static_cast<std::uint16_t>(given("journey"))};
    unit<cia407::IdentificationUnit>()->log_in(assignment_);
  } else if (press.what == "key") {
    keys_ |= std::uint32_t{1} << (number - 1);
    release_at_[number] = place_.clock() + key_time;
  } else if (press.what == "reverse" || press.what == "forward") {
    is_reverse_ = press.what == "reverse";
  } else if (press.what == "card" || press.what == "no-card") {
    has_card_.at(number - 1) = press.what == "card";
  } else if (press.what == "open" || press.what == "close") {
    doors_.at(number - 1).is_open = press.what == "open";
    unit<cia407::VehicleGatewayUnit>()->hardware_changed();
  } else if (press.what == "brake" || press.what == "release") {
    is_braking_ = press.what == "brake";
    unit<cia407::VehicleGatewayUnit>()->hardware_changed();
  } else if (press.what == "input") {
    inputs_ ^= std::uint32_t{1} << (number - 1);
  }
}

void BusPanel::act_on_counter(const BusPress& press) {
  if (press.what == "clear") return unit<cia407::CountingManagerUnit>()->clear();
  cia407::PassengerCounterUnit* const counter = unit<cia407::PassengerCounterUnit>();
  const unsigned people = press.number().value_or(1);
  if (press.what == "in") counter->count_in(people);
  if (press.what == "out") counter->count_out(people);
  if (press.what == "open-door" || press.what == "close-door") {
    counter->set_door(press.what == "open-door");
  }
}

void BusPanel::act_on_computer(const BusPress& press) {
  cia407::MainOnBoardComputerUnit* const computer = unit<cia407::MainOnBoardComputerUnit>();
  if (press.what == "stop") computer->request_stop();
  if (press.what == "block" || press.what == "unblock") {
    computer->block_tickets(press.what == "block");
  }
  if (press.what != "place") return;
  computer->set_position(
      {.stop_point_id = press.number("stop").value_or(0),
       .number_of_running = static_cast<std::uint8_t>(press.number("running").value_or(1)),
       .fare_zone = static_cast<std::uint8_t>(press.number("zone").value_or(0)),
       .route_segment = static_cast<std::uint16_t>(press.number("segment").value_or(0))});
}

/// In as many bytes as the object has.
void BusPanel::receive(const BusPress& press, Node& node) {
  const auto index = static_cast<std::uint16_t>(press.number("index").value_or(0));
  const auto sub = static_cast<std::uint8_t>(press.number("sub").value_or(0));
  std::array<std::uint8_t, relayed_value_max> bytes{};
  store(bytes.data(), press.number("value").value_or(0));
  const Result<Entry> entry = node.dictionary().find(index, sub);
  const bool is_taken = entry && entry->bytes().size() <= bytes.size() &&
                        unit<cia407::TrainBusGatewayUnit>()->receive(
                            index, sub, std::span(bytes).first(entry->bytes().size()));
  if (!is_taken) {
    place_.output.say("train-bus-gateway",
                      fmt::format("{:04X}h:{:02X}h is none that it tells here", index, sub));
  }
}

}  // namespace canvoy::tools
