#include "canvoy/tools/device/bus/bus_tickets.hpp"

#include <fmt/format.h>

#include <string>

#include "canvoy/tools/device/bus/bus_words.hpp"

namespace canvoy::tools {

namespace {

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

/// Unknown values are omitted.
std::string ticket_words(const cia407::TicketData& ticket) {
  std::string text = clock_words(ticket.time);
  const auto add = [&text](std::string_view name, std::uint32_t number) {
    if (number != 0) text += fmt::format(" {} {}", name, number);
  };
  add("stop", ticket.stop_point_id);
  if (ticket.has_fare_place) {
    text += fmt::format(" zone {} segment {}", ticket.fare_zone, ticket.route_segment_number);
  }
  add("line", ticket.line_id);
  add("route", ticket.route_number);
  add("block", ticket.block_id);
  if (!ticket.stop_point_text.empty()) text += fmt::format(", {}", ticket.stop_point_text);
  return text;
}

}  // namespace

void BusTickets::join(Environment& environment) {
  using namespace cia407;
  environment.provide(callback<&BusTickets::canceller_hardware>(*this));
  environment.watch(canceller_);
  environment.provide(callback<&BusTickets::printer_hardware>(*this));
  environment.watch(printer_);
}

void BusTickets::act(const BusPress& press) {
  if (press.what == "ticket") {
    answer(canceller_->insert_ticket(), "ticket-canceller");
  } else if (press.what == "sell") {
    answer(printer_->sell_ticket(), "ticket-printer");
  } else if (press.what == "paper" || press.what == "no-paper") {
    has_paper_ = press.what == "paper";
  }
}

void BusTickets::answer(cia407::TicketAnswer answer, std::string_view who) {
  if (answer == cia407::TicketAnswer::done) return;
  output_.say(who, fmt::format("no ticket: {}", ticket_answer_text(answer)));
}

cia407::TicketCancellerHardware BusTickets::canceller_hardware() {
  return {.stamp = callback<&BusTickets::stamp>(*this),
          .show_ready = callback<&BusTickets::show_ready>(*this)};
}

void BusTickets::stamp(const cia407::TicketData& ticket) {
  output_.say("ticket-canceller", fmt::format("stamps {}", ticket_words(ticket)));
}

void BusTickets::show_ready(bool is_ready) {
  output_.say("ticket-canceller", is_ready ? "takes tickets" : "takes no tickets");
}

cia407::TicketPrinterHardware BusTickets::printer_hardware() {
  return {.print = callback<&BusTickets::print>(*this),
          .has_paper = callback<&BusTickets::has_paper>(*this)};
}

bool BusTickets::print(const cia407::TicketData& ticket) {
  if (has_paper_) output_.say("ticket-printer", fmt::format("prints {}", ticket_words(ticket)));
  return has_paper_;
}

}  // namespace canvoy::tools
