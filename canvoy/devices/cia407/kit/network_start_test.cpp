// The device that starts a segment, at the wire: NMT commands of CiA 301, 7.2.8.3.1.
#include "canvoy/devices/cia407/kit/network_start.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"

namespace canvoy::cia407::network_start_test {
namespace {

constexpr const BusUnit* computer[] = {&bus_unit<MainOnBoardComputerKind>};
constexpr const BusUnit* gateway[] = {&bus_unit<TrainBusGatewayKind>};

/// A device alone on a cable, which no other device starts.
class Segment {
 public:
  Segment(std::span<const BusUnit* const> units, NodeId id, const BusSegment& segment)
      : segment_(segment) {
    environment_.provide(callback<&Segment::segment>(*this));
    device_.emplace(units, cable.port(0), id, environment_);
    cable.connect(0, device_->node());
    cable.start_all();
    cable.run_for(0s);
  }
  NmtState state() { return device_->node().state(); }
  /// NMT commands since the last call.
  std::vector<std::string> commands() {
    std::vector<std::string> texts;
    for (const Cable::Heard& each : cable.heard) {
      if (each.frame.id == 0) texts.push_back(wire_text(each.frame));
    }
    cable.clear();
    return texts;
  }

  Cable cable;

 private:
  BusSegment segment() const { return segment_; }

  BusSegment segment_;
  Environment environment_;
  std::optional<BusDevice> device_;
};

using Texts = std::vector<std::string>;

TEST(NetworkStart, StartsAllAndThenWhoeverIsNotOperational) {
  Segment bus(computer, 1, {.is_started_by_first = true});
  EXPECT_EQ(bus.commands(), (Texts{"000#80 00", "000#01 00"}));
  EXPECT_EQ(bus.state(), NmtState::operational);
  bus.cable.send("706#00");
  EXPECT_EQ(bus.commands(), Texts{"000#01 06"}) << "boot-up";
  bus.cable.send("706#05");
  bus.cable.run_for(3s);
  EXPECT_EQ(bus.commands(), Texts{}) << "who is operational is left alone";
  bus.cable.send("706#7F");
  EXPECT_EQ(bus.commands(), Texts{"000#01 06"});
  bus.cable.send("706#04");
  EXPECT_EQ(bus.commands(), Texts{"000#01 06"}) << "stopped";
  bus.cable.run_for(1s);
  EXPECT_EQ(bus.commands(), Texts{"000#01 06"}) << "again, as it has not said that it obeys";
}

TEST(NetworkStart, BeginsAnewWhereTheMasterWasSentBackButNotWhereItWasStopped) {
  Segment bus(computer, 1, {.is_started_by_first = true});
  bus.commands();
  bus.cable.send("000#80 01");
  EXPECT_EQ(bus.state(), NmtState::pre_operational);
  bus.commands();
  bus.cable.run_for(1s);
  EXPECT_EQ(bus.commands(), (Texts{"000#80 00", "000#01 00"}));
  bus.cable.send("000#02 01");
  bus.commands();
  bus.cable.send("706#00");
  bus.cable.run_for(3s);
  EXPECT_EQ(bus.commands(), Texts{});
  EXPECT_EQ(bus.state(), NmtState::stopped);
}

TEST(NetworkStart, IsAlsoTheGatewaysWhereThereIsNoMainComputer) {
  Segment second_car(gateway, 31, {.has_main_computer = false, .is_started_by_first = true});
  EXPECT_EQ(second_car.commands(), (Texts{"000#80 00", "000#01 00"}));
  Segment first_car(gateway, 30, {.is_started_by_first = true});
  first_car.cable.send("706#00");
  EXPECT_EQ(first_car.commands(), Texts{});
}

/// Like a device of the catalogue: 8.1.4.3 leaves open which node is the NMT master.
TEST(NetworkStart, IsNobodysWhereTheSegmentDoesNotSaySo) {
  Segment bus(computer, 1, {});
  bus.cable.send("706#00");
  bus.cable.run_for(3s);
  EXPECT_EQ(bus.commands(), Texts{});
  EXPECT_EQ(bus.state(), NmtState::pre_operational);
}

}  // namespace
}  // namespace canvoy::cia407::network_start_test
