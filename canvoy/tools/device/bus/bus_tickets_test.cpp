// Output of ticket canceller and printer for passengers.
#include "canvoy/tools/device/bus/bus_tickets.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::bus_tickets_test {
namespace {

class BusTicketsTest : public testing::Test {
 public:
  BusTicketsTest() { tickets.join(environment); }

  template <class Act>
  static std::string said_of(Act act) {
    testing::internal::CaptureStdout();
    act();
    return testing::internal::GetCapturedStdout();
  }

  DeviceOutput output;
  BusTickets tickets{output};
  Environment environment;
};

constexpr cia407::TicketData ticket = {.time = cia407::CivilTime{.hour = 8, .minute = 5},
                                       .stop_point_id = 17,
                                       .block_id = 6,
                                       .line_id = 23,
                                       .route_number = 5,
                                       .has_fare_place = true,
                                       .route_segment_number = 4,
                                       .fare_zone = 2};

TEST_F(BusTicketsTest, AStampSaysWhereAndWhen) {
  const auto canceller = environment.get<cia407::TicketCancellerHardware>();
  EXPECT_EQ(said_of([&] { canceller.stamp(ticket); }),
            "ticket-canceller: stamps 08:05 stop 17 zone 2 segment 4 line 23 route 5 block 6\n");
  cia407::TicketData named = ticket;
  named.stop_point_text = "Town Hall";
  EXPECT_EQ(said_of([&] { canceller.stamp(named); }),
            "ticket-canceller: stamps 08:05 stop 17 zone 2 segment 4 line 23 route 5 block 6, Town "
            "Hall\n");
}

TEST_F(BusTicketsTest, AStampDoesNotSayWhatNobodyHasTold) {
  const auto canceller = environment.get<cia407::TicketCancellerHardware>();
  cia407::TicketData stop = {.time = ticket.time, .stop_point_id = 17};
  EXPECT_EQ(said_of([&] { canceller.stamp(stop); }), "ticket-canceller: stamps 08:05 stop 17\n");
  cia407::TicketData zone = {.time = ticket.time, .has_fare_place = true};
  EXPECT_EQ(said_of([&] { canceller.stamp(zone); }),
            "ticket-canceller: stamps 08:05 zone 0 segment 0\n");
}

TEST_F(BusTicketsTest, TheLampSaysWhetherTicketsAreTaken) {
  const auto canceller = environment.get<cia407::TicketCancellerHardware>();
  EXPECT_EQ(said_of([&] {
              canceller.show_ready(true);
              canceller.show_ready(false);
            }),
            "ticket-canceller: takes tickets\nticket-canceller: takes no tickets\n");
}

TEST_F(BusTicketsTest, WithoutPaperNothingIsPrinted) {
  const auto printer = environment.get<cia407::TicketPrinterHardware>();
  EXPECT_TRUE(printer.has_paper());
  tickets.act({.what = "no-paper"});
  EXPECT_FALSE(printer.has_paper());
  bool is_printed = true;
  EXPECT_EQ(said_of([&] { is_printed = printer.print(ticket); }), "");
  EXPECT_FALSE(is_printed);
  tickets.act({.what = "paper"});
  EXPECT_TRUE(printer.has_paper());
  EXPECT_EQ(said_of([&] { is_printed = printer.print(ticket); }),
            "ticket-printer: prints 08:05 stop 17 zone 2 segment 4 line 23 route 5 block 6\n");
  EXPECT_TRUE(is_printed);
}

}  // namespace
}  // namespace canvoy::tools::bus_tickets_test
