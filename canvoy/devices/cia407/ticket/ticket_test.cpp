// Ticket canceller and printer at their wire: the messages of the main on-board computer in,
// tickets out. The bytes are those of 8.1.4.3.
#include <gtest/gtest.h>

#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"

namespace canvoy::cia407::ticket_test {
namespace {

struct Machine {
  std::vector<TicketData> tickets;
  bool is_ready = false;
  bool has_paper = true;

  void stamp(const TicketData& data) { tickets.push_back(data); }
  void show(bool ready) { is_ready = ready; }
  bool print(const TicketData& data) {
    if (has_paper) tickets.push_back(data);
    return has_paper;
  }
  bool paper() { return has_paper; }
  TicketCancellerHardware canceller() {
    return {.stamp = callback<&Machine::stamp>(*this),
            .show_ready = callback<&Machine::show>(*this)};
  }
  TicketPrinterHardware printer() {
    return {.print = callback<&Machine::print>(*this),
            .has_paper = callback<&Machine::paper>(*this)};
  }
};

// 2026-11-23 08:05:30: 2026 - 1985 = 41 = 29h, 23 days = 92 quarters = 5Ch, 11, 8, 5, 120 quarters.
constexpr const char* time = "181#29 5C 0B 08 05 78";
// Segment 0 of zone 0, not blocked, forward, the first stop.
constexpr const char* place = "381#00 00 00 00 01 01";

class Canceller : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<TicketCancellerKind>};
  Machine machine;
  TicketCancellerUnit* unit = nullptr;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(callback<&Machine::canceller>(machine));
                   environment.watch(unit);
                 }};
};

TEST_F(Canceller, StampsWhereAndWhen) {
  bench.cable.send(time);
  // Segment 0102h, zone 7, not blocked, backward, the 9th stop.
  bench.cable.send("381#02 01 07 00 02 09");
  bench.cable.send("281#44 33 22 11 17 00 05 00");
  bench.ask("23 09 61 00 4D 01 00 00");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done);
  ASSERT_EQ(machine.tickets.size(), 1u);
  const TicketData& ticket = machine.tickets[0];
  EXPECT_EQ(
      ticket.time,
      (CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 30}));
  EXPECT_EQ(ticket.route_segment_number, 0x102);
  EXPECT_EQ(ticket.fare_zone, 7);
  EXPECT_EQ(ticket.direction, JourneyDirection::backward);
  EXPECT_EQ(ticket.number_of_running, 9);
  EXPECT_EQ(ticket.block_id, 0x11223344u);
  EXPECT_EQ(ticket.line_id, 23);
  EXPECT_EQ(ticket.stop_point_id, 333u);
}

TEST_F(Canceller, StampsWhoseVehicleAndRoute) {
  bench.cable.send(time);
  bench.cable.send(place);
  bench.ask("23 00 61 00 67 12 00 00");
  bench.ask("23 91 61 00 09 00 00 00");
  bench.ask("2B 93 61 00 03 00 00 00");
  EXPECT_TRUE(bench.download(0x6120, 0, "Zoo"));
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done);
  ASSERT_EQ(machine.tickets.size(), 1u);
  const TicketData& ticket = machine.tickets[0];
  EXPECT_EQ(ticket.vehicle_id, 4711u);
  EXPECT_EQ(ticket.destination_number, 9u);
  EXPECT_EQ(ticket.route_number, 3);
  EXPECT_EQ(ticket.stop_point_text, "Zoo");
}

TEST_F(Canceller, IsBlockedAndSaysSo) {
  bench.cable.send(time);
  bench.cable.send(place);
  EXPECT_TRUE(machine.is_ready);
  bench.cable.send("381#00 00 00 80 01 01");
  EXPECT_FALSE(machine.is_ready);
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::blocked);
  bench.cable.send("381#00 00 00 7F 01 01");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done) << "bit 7 alone says it";
  EXPECT_EQ(machine.tickets.size(), 1u);
}

TEST_F(Canceller, TakesNoTicketsWithoutATimeOrOutOfOperational) {
  bench.cable.send(place);
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service);
  bench.cable.send(time);
  bench.cable.send("000#80 05");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service);
  EXPECT_FALSE(machine.is_ready);
  bench.cable.send("000#01 05");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done);
  bench.cable.send("181#FF FF FF FF FF FF");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service);
  EXPECT_TRUE(machine.tickets.size() == 1);
}

/// Of the messages in 8.1.4.3, a canceller has that of zone and segment, but not that of the stop
/// point (errata 99). Either is a location, and 0 is a valid number in it.
TEST_F(Canceller, TakesNoTicketsWhereItWasNotToldWhereItIs) {
  bench.cable.send(time);
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service);
  EXPECT_FALSE(machine.is_ready);
  bench.ask("23 09 61 00 00 00 00 00");
  bench.ask("2F 11 61 00 02 00 00 00");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service) << "stop 0, a zone alone";
  bench.cable.send("000#81 05");
  bench.cable.send("000#01 05");
  bench.cable.send(time);
  bench.cable.send(place);
  EXPECT_TRUE(machine.is_ready);
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done) << "segment 0 of zone 0";
  EXPECT_TRUE(machine.tickets.back().has_fare_place);
  bench.cable.send("000#81 05");
  bench.cable.send("000#01 05");
  bench.cable.send(time);
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::not_in_service) << "forgotten with a reset";
  bench.ask("23 09 61 00 4D 01 00 00");
  EXPECT_EQ(unit->insert_ticket(), TicketAnswer::done) << "stop 333";
  EXPECT_EQ(machine.tickets.back().stop_point_id, 333u);
  EXPECT_FALSE(machine.tickets.back().has_fare_place);
}

TEST_F(Canceller, ItsStateIsHowManyItHasCancelled) {
  bench.cable.send(time);
  bench.cable.send(place);
  unit->insert_ticket();
  unit->insert_ticket();
  bench.ask("23 02 60 01 01 00 00 04");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 02 00 04");
  bench.ask("23 02 60 01 00 00 00 04");
  EXPECT_EQ(bench.cable.last(0x185), "185#00 00 00 00 00 00 00 00");
}

class TicketPrinter : public testing::Test {
 protected:
  static constexpr const BusUnit* units[] = {&bus_unit<TicketPrinterKind>};
  Machine machine;
  TicketPrinterUnit* unit = nullptr;
  BusBench bench{units, [this](Environment& environment) {
                   environment.provide(callback<&Machine::printer>(machine));
                   environment.watch(unit);
                 }};
};

TEST_F(TicketPrinter, PrintsWhereAndWhen) {
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::not_in_service) << "without a time";
  bench.cable.send(time);
  bench.cable.send("281#44 33 22 11 17 00 05 00");
  // Segment 0102h, zone 7, backward, the 9th stop: not all of it comes by a PDO.
  for (const char* each :
       {"2B 10 61 00 02 01 00 00", "2F 11 61 00 07 00 00 00", "2F 08 61 00 02 00 00 00",
        "2F 0A 61 00 09 00 00 00", "23 00 61 00 67 12 00 00", "23 91 61 00 09 00 00 00",
        "2B 93 61 00 03 00 00 00"}) {
    bench.ask(each);
  }
  EXPECT_TRUE(bench.download(0x6120, 0, "Zoo"));
  EXPECT_TRUE(bench.download(0x6196, 0, "23a"));
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::done);
  ASSERT_EQ(machine.tickets.size(), 1u);
  const TicketData& ticket = machine.tickets[0];
  EXPECT_EQ(
      ticket.time,
      (CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 30}));
  EXPECT_EQ(ticket.block_id, 0x11223344u);
  EXPECT_EQ(ticket.line_id, 23);
  EXPECT_EQ(ticket.destination_number, 9u);
  EXPECT_EQ(ticket.route_number, 3);
  EXPECT_EQ(ticket.route_segment_number, 0x102);
  EXPECT_EQ(ticket.fare_zone, 7);
  EXPECT_EQ(ticket.direction, JourneyDirection::backward);
  EXPECT_EQ(ticket.number_of_running, 9);
  EXPECT_EQ(ticket.vehicle_id, 4711u);
  EXPECT_EQ(ticket.stop_point_text, "Zoo");
  EXPECT_EQ(ticket.line_text, "23a");
  bench.ask("2F 16 61 00 80 00 00 00");
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::blocked);
}

TEST_F(TicketPrinter, WithoutPaperItSaysSo) {
  bench.cable.send(time);
  bench.cable.send("401#4D 01 00 00 00 00 00 00");
  bench.cable.send("301#09 00 00 00 03 00");
  bench.ask("23 96 61 00 32 33 61 00");
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::done);
  ASSERT_EQ(machine.tickets.size(), 1u);
  EXPECT_EQ(machine.tickets[0].stop_point_id, 333u);
  machine.has_paper = false;
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.last(0x085), "085#01 FF 01 01 00 00 00 00");
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::out_of_paper);
  EXPECT_EQ(bench.cable.count(0x085), 1u) << "told once";
  machine.has_paper = true;
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(unit->sell_ticket(), TicketAnswer::done);
}

}  // namespace
}  // namespace canvoy::cia407::ticket_test
