// The typical configuration of 8.1.4.2 at the wire: eight messages between six devices.
#include "canvoy/profiles/cia407/configuration.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/profiles/cia407/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::configuration_test {
namespace {

using namespace std::chrono_literals;
using cia407::Configuration;
using cia407::InformationClass;
using cia407::InformationSubclass;

constexpr auto computer =
    describe(cia407::device<cia407::main_on_board_computer, Configuration::typical>(
                 {{0x6001, 5}, {0x6002, 4}, {0x6740, 1}}),
             cia301::identity({.vendor_id = 1}));
constexpr auto identification =
    describe(cia407::device<cia407::identification, Configuration::typical>(),
             cia301::identity({.vendor_id = 1}));
constexpr auto destination_indicator = describe(
    cia407::device<
        cia407::passenger_information<InformationClass::destination, InformationSubclass::text>,
        Configuration::typical>({{0x6203, 3}, {0x610D, 1}}),
    cia301::identity({.vendor_id = 1}));
constexpr auto next_stop_indicator = describe(
    cia407::device<
        cia407::passenger_information<InformationClass::next_stop, InformationSubclass::text>,
        Configuration::typical>({{0x6203, 3}, {0x6112, 1}}),
    cia301::identity({.vendor_id = 1}));
constexpr auto canceller =
    describe(cia407::device<cia407::ticket_canceller, Configuration::typical>(),
             cia301::identity({.vendor_id = 1}));
constexpr auto printer = describe(
    cia407::device<cia407::ticket_printer, Configuration::typical>({{0x6112, 1}, {0x6740, 1}}),
    cia301::identity({.vendor_id = 1}));

constexpr auto computer_layout = partial(lay_out_device<computer>());
constexpr auto identification_layout = partial(lay_out_device<identification>());
constexpr auto destination_layout = partial(lay_out_device<destination_indicator>());
constexpr auto next_stop_layout = partial(lay_out_device<next_stop_indicator>());
constexpr auto canceller_layout = partial(lay_out_device<canceller>());
constexpr auto printer_layout = partial(lay_out_device<printer>());

class Cia407Configuration : public testing::Test {
 protected:
  Cia407Configuration() {
    cable_.connect(0, computer_.node());
    cable_.connect(1, identification_.node());
    cable_.connect(2, destination_.node());
    cable_.connect(3, next_stop_.node());
    cable_.connect(4, canceller_.node());
    cable_.connect(5, printer_.node());
    cable_.start_all();
    cable_.send("000#01 00");
  }

  Cable cable_;
  DeviceNode<computer_layout> computer_{cable_.port(0), 1};
  DeviceNode<identification_layout> identification_{cable_.port(1), 2};
  DeviceNode<destination_layout> destination_{cable_.port(2), 3};
  DeviceNode<next_stop_layout> next_stop_{cable_.port(3), 4};
  DeviceNode<canceller_layout> canceller_{cable_.port(4), 5};
  DeviceNode<printer_layout> printer_{cable_.port(5), 6};
};

TEST_F(Cia407Configuration, EachMessageIsSentOnceWhenNodesBecomeOperational) {
  EXPECT_EQ(cable_.last(0x181), "181#FF FF FF FF FF FF");
  EXPECT_EQ(cable_.last(0x381), "381#00 00 00 00 01 01");
  EXPECT_EQ(cable_.last(0x401), "401#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x481), "481#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x501), "501#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x201), "201#00 00 00 00");
  EXPECT_EQ(cable_.last(0x281), "281#00 00 00 00 00 00 00 00");
  EXPECT_EQ(cable_.last(0x301), "301#00 00 00 00 00 00");
}

TEST_F(Cia407Configuration, TheTimeIsSentEachMinute) {
  cable_.clear();
  cable_.run_for(59s);
  EXPECT_EQ(cable_.last(0x181), "");
  cable_.run_for(1s);
  EXPECT_EQ(cable_.last(0x181), "181#FF FF FF FF FF FF");
}

TEST_F(Cia407Configuration, BlockLineAndJourneyReachThoseWhoUseThem) {
  Values of_identification(identification_.dictionary());
  of_identification[cia407::block_id] = 0x01020304;
  of_identification[cia407::line_id] = 0x0506;
  of_identification[cia407::journey_number] = 0x0708;
  cable_.run_for(1ms);
  EXPECT_EQ(cable_.last(0x281), "281#04 03 02 01 06 05 08 07");
  EXPECT_EQ(computer_.dictionary().number(0x6195, 0), 0x0708U);
  EXPECT_EQ(canceller_.dictionary().number(0x6194, 0), 0x01020304U);
  EXPECT_EQ(printer_.dictionary().number(0x6192, 0), 0x0506U);
  EXPECT_EQ(destination_.dictionary().number(0x6192, 0), 0x0506U) << "the block is a dummy there";
  EXPECT_EQ(next_stop_.dictionary().number(0x6192, 0), 0U) << "errata 95: undecided";
}

TEST_F(Cia407Configuration, TheRouteReachesTicketsAndTheDestinationIndicator) {
  Values of_computer(computer_.dictionary());
  of_computer[cia407::route_segment_number] = 0x1234;
  of_computer[cia407::fare_zone] = 7;
  of_computer[cia407::blocking_of_ticket_canceller] = cia407::TicketValidator::blocked;
  of_computer[cia407::journey_direction] = cia407::JourneyDirection::backward;
  cable_.run_for(1ms);
  EXPECT_EQ(cable_.last(0x381), "381#34 12 07 80 02 01");
  EXPECT_EQ(canceller_.dictionary().number(0x6116, 0), 0x80U);
  EXPECT_EQ(printer_.dictionary().number(0x6108, 0), 2U);
  EXPECT_EQ(destination_.dictionary().number(0x6110, 0), 0x1234U);
}

TEST_F(Cia407Configuration, TheStopPointReachesTheNextStopIndicatorAndThePrinter) {
  Values of_computer(computer_.dictionary());
  of_computer[cia407::stop_point_id] = 42;
  cable_.run_for(1ms);
  EXPECT_EQ(cable_.last(0x401), "401#2A 00 00 00 00 00 00 00");
  EXPECT_EQ(next_stop_.dictionary().number(0x6109, 0), 42U);
  EXPECT_EQ(printer_.dictionary().number(0x6109, 0), 42U);
  EXPECT_EQ(canceller_.dictionary().number(0x6109, 0), 0U) << "errata 99: by SDO";
}

TEST_F(Cia407Configuration, TheLineReachesThePrinterAsText) {
  Values(computer_.dictionary())[cia407::line_short_representation] = "U8";
  cable_.run_for(1ms);
  EXPECT_EQ(cable_.last(0x481), "481#55 38 00 00 00 00 00 00");
  char buffer[8];
  EXPECT_EQ(Values(printer_.dictionary())[cia407::line_short_representation].value(buffer), "U8");
}

template <const VirtualDeviceInfo& device, Configuration configuration>
std::vector<unsigned> pdo_numbers() {
  std::vector<unsigned> numbers;
  for (const PdoInfo& pdo : cia407::profile.pdos) {
    if (cia407::has_pdo(device, configuration, pdo)) numbers.push_back(pdo.number);
  }
  return numbers;
}
TEST(Cia407MinimumConfiguration, HasTimeDriverAndBlockOnly) {  // errata 93
  using enum Configuration;
  using Numbers = std::vector<unsigned>;
  EXPECT_EQ((pdo_numbers<cia407::main_on_board_computer, minimum>()), (Numbers{2, 3, 1}));
  EXPECT_EQ((pdo_numbers<cia407::identification, minimum>()), (Numbers{1, 2}));
  EXPECT_EQ((pdo_numbers<cia407::ticket_canceller, minimum>()), (Numbers{1, 3}));
  EXPECT_EQ((pdo_numbers<cia407::ticket_canceller, none>()), Numbers{});
  EXPECT_EQ(
      (pdo_numbers<
          cia407::passenger_information<InformationClass::destination, InformationSubclass::text>,
          minimum>()),
      Numbers{3});
  EXPECT_EQ(
      (pdo_numbers<
          cia407::passenger_information<InformationClass::next_stop, InformationSubclass::text>,
          typical>()),
      Numbers{4});
}

constexpr auto mileage_alone = cia407::device<cia407::vehicle_gateway>({{0x6482}, {0x6488, 3}});
constexpr auto both_of_mileage = cia407::device<cia407::vehicle_gateway>({{0x6482}, {0x6483}});
constexpr auto no_mileage = cia407::device<cia407::vehicle_gateway>({{0x6481}});

TEST(Cia407MinimumConfiguration, HasThePrecisionOfWhatIsMeasured) {  // errata 104
  EXPECT_NE(mileage_alone.find(0x6483), nullptr);
  EXPECT_EQ(mileage_alone.find(0x6487), nullptr) << "no 6486h";
  EXPECT_EQ(mileage_alone.find(0x6488)->highest_sub(), 3);
  EXPECT_EQ(mileage_alone.size(), 2U + 3);
  EXPECT_EQ(both_of_mileage.size(), 2U + 2);
  EXPECT_EQ(no_mileage.size(), 2U + 1);
}

}  // namespace
}  // namespace canvoy::configuration_test
