// Several flying masters on one cable: one becomes the NMT master, and after its loss another one
// does (CiA 302-2).
#include <gtest/gtest.h>

#include "canvoy/canopen/manager/flying_master.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"
#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::flying_network_test {
namespace {

/// A device that may be NMT master; it monitors the node with the heartbeat given.
struct Candidate {
  Candidate(Cable& cable, std::size_t place, NodeId id, std::uint32_t priority, NodeId watched = 0)
      : master(cable.port(place), id),
        stored(master.node()),
        flying(master.node(), master.commands(), master.boot_manager()) {
    const std::uint32_t timing[] = {100, 500, priority, 1500, 10, 4000};
    for (std::uint8_t sub = 1; sub <= 6; ++sub) stored.store(0x1F90, sub, timing[sub - 1]);
    stored.store(0x1F80, 0, 0x21);
    if (watched != 0) stored.store(0x1016, 1, static_cast<std::uint32_t>(watched) << 16 | 300);
    cable.connect(place, master.node());
  }
  MasterNode<detail::boot_layout, MasterSize{.own_routes = 6}> master;
  StoredValues stored;
  FlyingMaster flying;
};

struct FlyingNetwork {
  Cable cable;
  Candidate low{cable, 0, 5, 2};
  Candidate high{cable, 1, 9, 0};
  Candidate middle{cable, 2, 7, 1, 9};

  std::vector<FlyingMaster::State> states() const {
    return {low.flying.state(), high.flying.state(), middle.flying.state()};
  }
  using State = FlyingMaster::State;
};

TEST(FlyingNetwork, IsLedByTheHighestPriorityWhoeverWasFirst) {
  FlyingNetwork sut;
  sut.cable.start_all();
  sut.cable.run_for(6s);
  using State = FlyingMaster::State;
  EXPECT_EQ(sut.states(), (std::vector{State::slave, State::master, State::slave}));
  EXPECT_EQ(sut.low.flying.active_master(), 9);
  EXPECT_EQ(sut.middle.flying.active_master(), 9);
  // Once after its victory, and to the first of the nodes that it reset then: the other one
  // receives it too.
  EXPECT_EQ(sut.cable.count(0x071), 2U);
  EXPECT_EQ(sut.cable.last(0x071), "071#00 09");
}

TEST(FlyingNetwork, KeepsItsMasterWhileItLives) {
  FlyingNetwork sut;
  sut.cable.start_all();
  sut.cable.run_for(5s);
  sut.cable.clear();
  for (int i = 0; i < 600; ++i) {
    sut.cable.run_for(100ms);
    sut.cable.send("709#05");
  }
  EXPECT_EQ(sut.cable.count(0x076), 15U) << "the call for other masters each four seconds";
  EXPECT_EQ(sut.cable.count(0x072), 0U) << "which nobody answers";
  EXPECT_EQ(sut.high.flying.state(), FlyingMaster::State::master);
}

TEST(FlyingNetwork, ChoosesAnotherMasterWhenTheFirstIsLost) {
  FlyingNetwork sut;
  sut.cable.start_all();
  sut.cable.run_for(3s);
  sut.cable.send("709#05");
  sut.cable.cut(1);
  sut.cable.clear();
  sut.cable.run_for(5s);
  using State = FlyingMaster::State;
  EXPECT_EQ(sut.low.flying.state(), State::slave);
  EXPECT_EQ(sut.middle.flying.state(), State::master);
  EXPECT_EQ(sut.cable.last(0x071), "071#01 07");
}

TEST(FlyingNetwork, ThatWasTwoBecomesOneAgain) {
  FlyingNetwork sut;
  sut.cable.start_all();
  sut.cable.run_for(3s);
  sut.cable.send("709#05");
  sut.cable.cut(1);
  sut.cable.run_for(10s);
  EXPECT_EQ(sut.high.flying.state(), FlyingMaster::State::master);
  EXPECT_EQ(sut.middle.flying.state(), FlyingMaster::State::master);
  sut.cable.cut(1, false);
  sut.cable.run_for(10s);
  EXPECT_EQ(sut.high.flying.state(), FlyingMaster::State::master);
  EXPECT_EQ(sut.middle.flying.state(), FlyingMaster::State::slave);
  EXPECT_EQ(sut.low.flying.state(), FlyingMaster::State::slave);
}

TEST(FlyingNetwork, TakesInAHigherPriorityThatComesLater) {
  Cable cable;
  Candidate low(cable, 0, 5, 2);
  cable.start_all();
  cable.run_for(10s);
  EXPECT_EQ(low.flying.state(), FlyingMaster::State::master);
  Candidate high(cable, 1, 9, 0);
  high.master.node().start(cable.now);
  cable.run_for(5s);
  EXPECT_EQ(high.flying.state(), FlyingMaster::State::master);
  EXPECT_EQ(low.flying.state(), FlyingMaster::State::slave);
}

}  // namespace
}  // namespace canvoy::flying_network_test
