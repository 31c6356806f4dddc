// A train of up to four cars: each car behind the first has a cable, a gateway, displays and an
// announcer of its own, shows what the first one shows, and is judged by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "canvoy/worlds/bus_line/bus_day_test.hpp"

namespace canvoy::bus_line::bus_train_test {
namespace {

BusNetworkOptions train(unsigned cars) {
  BusNetworkOptions options = with_seed(1);
  options.design.cars = cars;
  return options;
}

std::string played(const BusNetworkOptions& options, Duration time = 43min) {
  BusNetwork network(options);
  network.run_until(Time(time));
  return broken(network);
}

/// Texts of the next stop indicator of a car, one after the other, without the dark moments.
std::vector<std::string> stops_shown(const BusNetwork& network, unsigned car) {
  std::vector<std::string> texts;
  for (const NetworkEvent& event : network.events()) {
    const auto* shown = std::get_if<DisplayShows>(&event.what);
    if (shown == nullptr || shown->node != next_stop_of(car) || shown->text.empty()) continue;
    if (texts.empty() || texts.back() != shown->text) texts.push_back(shown->text);
  }
  return texts;
}
std::vector<std::uint32_t> stops_said(const BusNetwork& network, unsigned car) {
  std::vector<std::uint32_t> stops;
  for (const NetworkEvent& event : network.events()) {
    const auto* said = std::get_if<Announced>(&event.what);
    if (said != nullptr && said->car == car) stops.push_back(said->stop_point);
  }
  return stops;
}
std::size_t signs_lit(const BusNetwork& network, unsigned car) {
  return static_cast<std::size_t>(std::ranges::count_if(network.events(), [&](const auto& event) {
    const auto* sign = std::get_if<StopSignLit>(&event.what);
    return sign != nullptr && sign->is_lit && sign->car == car;
  }));
}

class BusTrain : public testing::TestWithParam<unsigned> {};

TEST_P(BusTrain, EachCarShowsAndSaysWhatTheFirstOneDoes) {
  const unsigned cars = GetParam();
  BusNetwork network(train(cars));
  network.run_until(Time(30min));
  ASSERT_GT(stops_shown(network, 1).size(), 8U);
  ASSERT_GT(signs_lit(network, 1), 2U);
  for (unsigned car = 2; car <= cars; ++car) {
    EXPECT_EQ(stops_shown(network, car), stops_shown(network, 1)) << "car " << car;
    EXPECT_EQ(stops_said(network, car), stops_said(network, 1)) << "car " << car;
    EXPECT_EQ(signs_lit(network, car), signs_lit(network, 1)) << "car " << car;
    EXPECT_EQ(network.display(destination_of(car)).text(), "407\nCentral Station");
  }
  EXPECT_EQ(broken(network), "");
  const BusNetworkSnapshot end = network.snapshot();
  EXPECT_EQ(end.buses.size(), cars);
  EXPECT_EQ(end.nodes.size(), 17U + 4 * (cars - 1)) << "four in each car behind the first";
  EXPECT_EQ(end.displays.size(), 4U + 2 * (cars - 1));
  EXPECT_EQ(network.invariants().size(), 17U + 3 * (cars - 1)) << "three of each of those cars";
}

/// The gateway sends the messages of 8.1.4.3 on its cable, and starts its devices there, which it
/// watches by their heartbeats, 700h + node-ID.
TEST_P(BusTrain, EachCableHasTheMessagesOfItsGateway) {
  BusNetwork network(train(GetParam()));
  std::vector<std::map<std::uint32_t, Frame>> last(GetParam());
  for (unsigned car = 2; car <= GetParam(); ++car) {
    network.world().bus(car - 1).observe(
        {.context = &last[car - 1],
         .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
           (*static_cast<std::map<std::uint32_t, Frame>*>(self))[frame.id] = frame;
         }});
  }
  network.run_until(Time(4min + 1s));
  const NodeId ids[][4] = {{31, 34, 35, 39}, {41, 44, 45, 49}, {51, 54, 55, 59}};
  for (unsigned car = 2; car <= GetParam(); ++car) {
    auto& frames = last[car - 1];
    // 4:59 on 2026-11-23, of SAE J1939: 41 years since 1985, quarters of days.
    EXPECT_EQ(frames[0x181], Frame::data_frame(0x181, {41, 92, 11, 4, 59, 0})) << "car " << car;
    EXPECT_EQ(frames[0x401].data[0], network.vehicle().truth().stop->number) << "car " << car;
    for (const NodeId id : ids[car - 2]) {
      EXPECT_EQ(frames[0x700U + id], Frame::data_frame(0x700U + id, {5})) << unsigned{id};
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cars, BusTrain, testing::Values(2U, 3U, 4U));

TEST(BusTrainFaults, NothingComesThroughATrainBusThatIsCut) {
  BusNetworkOptions options = train(4);
  options.faults.faults = {
      {.kind = FaultKind::train_bus_cut, .start = Time(10min), .duration = 5min}};
  BusNetwork network(options);
  network.run_until(Time(10min + 600ms));
  for (unsigned car = 2; car <= 4; ++car) {
    EXPECT_EQ(network.display(next_stop_of(car)).text(), "") << "car " << car;
  }
  network.run_until(Time(15min + 2s));
  for (unsigned car = 2; car <= 4; ++car) {
    EXPECT_EQ(network.display(next_stop_of(car)).text(), network.vehicle().truth().stop->name);
  }
  network.run_until(Time(25min));
  EXPECT_EQ(broken(network), "");
}

/// What is lost behind the first car is missed in its own car alone.
TEST(BusTrainFaults, ADeviceOfOneCarIsNotMissedInAnother) {
  for (const NodeId id : {gateway_of(3), destination_of(4), next_stop_of(3), announcer_of(4)}) {
    BusNetworkOptions options = train(4);
    options.faults.faults = {{.start = Time(9min), .duration = 6min, .node = id}};
    BusNetwork network(options);
    network.run_until(Time(12min));
    for (unsigned car = 2; car <= 4; ++car) {
      if (car == car_of(id)) continue;
      EXPECT_EQ(network.display(next_stop_of(car)).text(), network.vehicle().truth().stop->name)
          << "car " << car << " without node " << unsigned{id};
    }
    network.run_until(Time(25min));
    EXPECT_EQ(broken(network), "") << "node " << unsigned{id};
    EXPECT_TRUE(network.node(id).is_operational());
  }
}

/// A dead gateway excuses its own car, and no other one.
TEST(BusTrainFaults, AFaultInOneCarIsNoExcuseForAnother) {
  BusNetworkOptions options = train(4);
  options.faults.faults = {{.start = Time(1min), .duration = 2h, .node = gateway_of(3)}};
  EXPECT_EQ(played(options), "");
  options.sabotage.unlit_car = 4;
  EXPECT_EQ(played(options), "fourth_stop_sign ");
  options.sabotage.unlit_car = 3;
  EXPECT_EQ(played(options), "") << "it has no power of its gateway";
}

/// Each sabotage, in each of the cars, is detected as one of that car.
TEST(BusTrainFaults, EachCarIsJudgedByItself) {
  const auto with = [](unsigned Sabotage::*what, unsigned car) {
    BusNetworkOptions options = train(4);
    options.vehicle.riders.behind_every = 1;  // all riders, so that some press in each car
    options.sabotage.*what = car;
    return played(options);
  };
  EXPECT_EQ(with(&Sabotage::cut_car, 3), "third_car ");
  EXPECT_EQ(with(&Sabotage::cut_car, 4), "fourth_car ");
  EXPECT_EQ(with(&Sabotage::frozen_car, 3), "lie ");
  EXPECT_EQ(with(&Sabotage::mute_car, 3), "third_announcements ");
  EXPECT_EQ(with(&Sabotage::mute_car, 4), "fourth_announcements ");
  EXPECT_EQ(with(&Sabotage::unlit_car, 3), "third_stop_sign ");
  EXPECT_EQ(with(&Sabotage::dead_button_car, 3), "third_stop_sign ");
  EXPECT_EQ(with(&Sabotage::dead_button_car, 4), "fourth_stop_sign ");
}

}  // namespace
}  // namespace canvoy::bus_line::bus_train_test
