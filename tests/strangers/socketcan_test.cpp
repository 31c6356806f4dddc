// Real CAN sockets, with can-utils as peers. It needs AF_CAN, iproute2 and root: the test runs it
// in an emulated machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::host {
namespace {

// Emulated code is slow.
constexpr Duration patience = 120s;

void shell(const std::string& command) {
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

// A program that runs beside the test, until it ends or the test does.
class Beside {
 public:
  explicit Beside(const std::string& command) : child_(fork()) {
    if (child_ != 0) return;
    execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
    _exit(127);
  }
  ~Beside() {
    if (child_ > 0) interrupt();
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void wait() {
    waitpid(child_, nullptr, 0);
    child_ = 0;
  }
  bool has_ended() {
    if (child_ > 0 && waitpid(child_, nullptr, WNOHANG) == child_) child_ = 0;
    return child_ == 0;
  }
  void interrupt() {
    kill(child_, SIGINT);
    wait();
  }

 private:
  pid_t child_;
};

struct Node {
  Node(EventLoop& loop, HostBus& bus) : attachment(loop, bus), port(attachment.port()) {
    attachment.attach(*this);
  }

  void receive(const Frame& frame, Time) { heard.emplace_back(FrameText(frame).view()); }
  void bus_state(BusState state, Time) { states.push_back(state); }
  bool send(const char* frame) const { return port.send(port.context, parse_frame(frame).frame); }

  Attachment attachment;
  Port port;
  std::vector<std::string> heard;
  std::vector<BusState> states;
};

using Heard = std::vector<std::string>;
using States = std::vector<BusState>;

// Each test has an interface vtest of its own.
class SocketCanTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!Descriptor{::socket(AF_CAN, SOCK_RAW | SOCK_CLOEXEC, 1)})
      GTEST_SKIP() << "this kernel has no CAN sockets";
    shell("ip link add vtest type vcan && ip link set vtest up");
  }
  void TearDown() override { std::system("ip link del vtest 2>/dev/null"); }

  std::unique_ptr<HostBus> open() {
    Result<std::unique_ptr<HostBus>> bus = open_bus(*loop_, "vtest");
    EXPECT_TRUE(bus) << bus.error().line();
    return bus ? std::move(*bus) : nullptr;
  }
  std::string refusal(std::string_view address) {
    const Result<std::unique_ptr<HostBus>> bus = open_bus(*loop_, address);
    return bus ? "opened" : bus.error().line();
  }
  template <class Condition>
  bool run_until(Condition condition) {
    const Time give_up = loop_->now() + patience;
    while (!condition() && loop_->now() < give_up) loop_->run_until(loop_->now() + 5ms);
    return condition();
  }

  std::unique_ptr<EventLoop> loop_ = *EventLoop::create();
};

TEST_F(SocketCanTest, ANodeHearsWhatCansendSends) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node node(*loop_, *bus);
  shell("cansend vtest 185#1E2F && cansend vtest 12345678#R2 && cansend vtest 00000001#");
  EXPECT_TRUE(run_until([&] { return node.heard.size() == 3; }));
  EXPECT_EQ(node.heard, (Heard{"185#1E2F", "12345678#R2", "00000001#"}));
  EXPECT_EQ(bus->counters().received, 3U);
}

TEST_F(SocketCanTest, ANodesFrameReachesSiblingsAndOtherSocketsButNotItself) {
  const auto bus = open();
  const auto other_bus = open();
  ASSERT_TRUE(bus && other_bus);
  Node charger(*loop_, *bus);
  Node battery(*loop_, *bus);
  Node stranger(*loop_, *other_bus);
  EXPECT_TRUE(charger.send("185#1E2F"));
  EXPECT_TRUE(run_until([&] {
    return !battery.heard.empty() && !stranger.heard.empty() && bus->counters().sent == 1;
  }));
  EXPECT_EQ(battery.heard, Heard{"185#1E2F"});
  EXPECT_EQ(stranger.heard, Heard{"185#1E2F"});
  EXPECT_EQ(charger.heard, Heard{});
  EXPECT_EQ(other_bus->counters().received, 1U);
}

constexpr auto guarded_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

TEST_F(SocketCanTest, NodeGuardingIsAnsweredToRemoteFramesOfCansendAndOfOurMaster) {
  const auto bus = open();
  const auto other_bus = open();
  ASSERT_TRUE(bus && other_bus);
  Node witness(*loop_, *other_bus);
  Attachment slave_attachment(*loop_, *bus);
  Attachment master_attachment(*loop_, *other_bus);
  constexpr DictionaryTables tables = guarded_layout.tables();
  WireMemory memories[2] = {WireMemory(tables), WireMemory(tables)};
  canvoy::Node slave_node(tables, memories[0].spans(), slave_attachment.port(), 5);
  canvoy::Node master_node(tables, memories[1].spans(), master_attachment.port(), 1);
  NodeGuardingSlave slave(slave_node);
  NodeGuardingMaster::Slot slots[1];
  NodeGuardingMaster master(master_node, slots);
  slave_attachment.attach(slave_node);
  master_attachment.attach(master_node);
  slave_node.start(loop_->now());
  master_node.start(loop_->now());
  shell("cansend vtest '705#R' && cansend vtest '705#R1' && cansend vtest '705#R8'");
  const auto heard = [&](const char* frame) {
    return std::find(witness.heard.begin(), witness.heard.end(), frame) != witness.heard.end();
  };
  EXPECT_TRUE(run_until([&] {
    return heard("705#00") && std::count(witness.heard.begin(), witness.heard.end(), "705#7F") == 2;
  }));
  EXPECT_TRUE(heard("705#FF")) << "toggle bit of the second answer";
  // The next answer has toggle bit 1: the master takes the one behind it.
  ASSERT_TRUE(master.guard(5, 50ms, 200));
  EXPECT_TRUE(run_until([&] { return master.state(5) == RemoteState::pre_operational; }));
  shell("cansend vtest 000#0105");
  EXPECT_TRUE(run_until([&] { return master.state(5) == RemoteState::operational; }));
}

// Sorted: where two processors send at once, the kernel delivers in another order to each socket.
Heard lines_of(const std::string& text) {
  Heard lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST_F(SocketCanTest, OurLogHasTheLinesOfCandumpByteForByte) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  const TemporaryFile ours;
  const TemporaryFile theirs;
  Result<CandumpWriter> log = CandumpWriter::create(ours.path(), loop_->epoch());
  ASSERT_TRUE(log);
  bus->on_frame([&](const BusFrame& heard) {
    EXPECT_TRUE(log->write(heard.time, bus->name(), heard.frame));
  });
  Beside candump("candump -L vtest,0:0,#FFFFFFFF >" + theirs.path());
  // Candump listens when it has printed its first frame.
  EXPECT_TRUE(run_until([&] {
    std::system("cansend vtest 7FF#");
    return !theirs.content().empty();
  }));
  Node node(*loop_, *bus);
  node.heard.clear();
  Beside narrow("cangen vtest -g 2 -n 60");
  Beside wide("cangen vtest -g 3 -n 40 -e");
  Beside remote("cangen vtest -g 5 -n 20 -R");
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(node.send("185#1E2F"));
    loop_->run_until(loop_->now() + 1ms);
  }
  shell("cansend vtest 20000004#0010000000000000");
  EXPECT_TRUE(
      run_until([&] { return narrow.has_ended() && wide.has_ended() && remote.has_ended(); }));
  EXPECT_TRUE(run_until([&] { return lines_of(theirs.content()).size() >= 1 + 120 + 50 + 1; }));
  // What candump has was queued for us before this last one.
  shell("cansend vtest 7FE#");
  EXPECT_TRUE(run_until([&] {
    return !node.heard.empty() && node.heard.back() == "7FE#" &&
           theirs.content().find(" 7FE#") != std::string::npos;
  }));
  EXPECT_EQ(node.states.size(), 1U);
  candump.interrupt();
  EXPECT_TRUE(log->flush());
  // Before candump listened, we may have heard more than it; and the kernel stamps frames for all
  // sockets alike only a while after the first socket asked for it.
  Heard heard = lines_of(theirs.content());
  std::erase_if(heard, [](const std::string& line) { return line.ends_with(" 7FF#"); });
  EXPECT_GE(heard.size(), 170U);
  EXPECT_THAT(heard, testing::IsSubsetOf(lines_of(ours.content())));
}

TEST_F(SocketCanTest, ErrorFramesBecomeBusStates) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node node(*loop_, *bus);
  shell(
      "cansend vtest 20000004#0008000000000000 && "
      "cansend vtest 20000004#0020000000000000 && cansend vtest 20000004#0001000000000000 &&"
      "cansend vtest 20000040#0000000000000000");
  EXPECT_TRUE(run_until([&] { return node.states.size() == 3; }));
  EXPECT_FALSE(node.send("185#1E2F"));
  shell("cansend vtest 20000100#0000000000000000");
  EXPECT_TRUE(run_until([&] { return node.states.size() == 4; }));
  EXPECT_EQ(node.states, (States{BusState::error_warning, BusState::error_passive,
                                 BusState::bus_off, BusState::error_active}));
  EXPECT_EQ(node.heard, Heard{});
  EXPECT_EQ(bus->counters().carrier.error_frames, 5U);
  EXPECT_EQ(bus->counters().carrier.overrun, 1U);
  EXPECT_TRUE(node.send("185#1E2F"));
}

TEST_F(SocketCanTest, AnInterfaceThatGoesDownIsReportedOnceAndServedWhenItIsUpAgain) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node node(*loop_, *bus);
  std::vector<std::string> troubles;
  bus->on_trouble([&](const Error& error) { troubles.push_back(error.line()); });
  shell("ip link set vtest down");
  EXPECT_TRUE(run_until([&] { return node.states == States{BusState::bus_off}; }));
  EXPECT_FALSE(node.send("185#1E2F"));
  loop_->run_until(loop_->now() + 300ms);
  EXPECT_EQ(
      troubles,
      Heard{"vtest: the interface is down; bring it up: `ip link set vtest up`, a real one with "
            "`type can bitrate 125000`"});
  shell("ip link set vtest up");
  EXPECT_TRUE(run_until([&] { return node.states.size() == 2; }));
  EXPECT_EQ(node.states.back(), BusState::error_active);
  shell("cansend vtest 185#1E2F");
  EXPECT_TRUE(run_until([&] { return node.heard == Heard{"185#1E2F"}; }));
  EXPECT_TRUE(node.send("186#"));
  EXPECT_TRUE(run_until([&] { return bus->counters().sent == 1; }));
}

TEST_F(SocketCanTest, AnInterfaceThatIsUnpluggedIsReportedAndServedWhenItIsBack) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node node(*loop_, *bus);
  std::vector<std::string> troubles;
  bus->on_trouble([&](const Error& error) { troubles.push_back(error.what); });
  shell("ip link del vtest");
  EXPECT_TRUE(run_until([&] { return node.states == States{BusState::bus_off}; }));
  loop_->run_until(loop_->now() + 300ms);
  EXPECT_EQ(troubles, Heard{"there is no such interface"});
  shell("ip link add vtest type vcan && ip link set vtest up");
  EXPECT_TRUE(run_until([&] { return node.states.size() == 2; }));
  shell("cansend vtest 185#1E2F");
  EXPECT_TRUE(run_until([&] { return node.heard == Heard{"185#1E2F"}; }));
}

TEST_F(SocketCanTest, ASendThatFindsTheInterfaceDownIsRefusedAndReported) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  Node node(*loop_, *bus);
  int troubles = 0;
  bus->on_trouble([&](const Error&) { ++troubles; });
  shell("ip link set vtest down");
  EXPECT_FALSE(node.send("185#1E2F"));
  EXPECT_EQ(bus->counters().refused, 1U);
  EXPECT_TRUE(run_until([&] { return node.states == States{BusState::bus_off}; }));
  EXPECT_EQ(troubles, 1);
}

TEST_F(SocketCanTest, WhatTheSocketCannotHoldIsCountedAsOverrun) {
  const auto bus = open();
  ASSERT_TRUE(bus);
  shell("cangen vtest -g 0 -i -n 20000 -I 123 -L 8");
  EXPECT_TRUE(run_until([&] {
    std::system("cansend vtest 7FF#");
    return bus->counters().carrier.overrun > 0;
  }));
  EXPECT_GT(bus->counters().received, 100U);
  EXPECT_EQ(bus->counters().carrier.fd, 0U);
}

TEST_F(SocketCanTest, ABusThatCannotBeOpenedIsRefusedInOneLineThatSaysWhatToDo) {
  EXPECT_EQ(refusal("nocan7"),
            "nocan7: there is no such interface; `ip -br link` lists what there is; `ip link add "
            "vcan0 type vcan` "
            "makes a virtual one");
  EXPECT_EQ(refusal("lo"), "lo: this is no CAN interface; `ip -br link show type can` lists those");
  shell("ip link set vtest down");
  EXPECT_EQ(refusal("vtest"),
            "vtest: the interface is down; bring it up: `ip link set vtest up`, a real one with "
            "`type can bitrate "
            "125000`");
}

TEST(SocketCan, LeavesFramesThatNobodyWantsInTheKernel) {
  const auto loop = *EventLoop::create();
  const auto bus = *open_bus(*loop, "vcan0");
  Node node(*loop, *bus);
  node.port.accept(node.port.context, 0x605, true);
  loop->run_until(loop->now() + Duration(10ms));
  shell("cansend vcan0 185#01; cansend vcan0 605#02; cansend vcan0 605#R; cansend vcan0 185#03");
  const Time end = loop->now() + patience;
  while (node.heard.size() < 2 && loop->now() < end) loop->run_until(loop->now() + Duration(10ms));
  loop->run_until(loop->now() + Duration(100ms));
  EXPECT_EQ(node.heard, (std::vector<std::string>{"605#02", "605#R"}));
  EXPECT_EQ(bus->counters().received, 2U);
  EXPECT_TRUE(node.send("585#04"));
  while (bus->counters().sent == 0 && loop->now() < end) {
    loop->run_until(loop->now() + Duration(10ms));
  }
  EXPECT_EQ(bus->counters().sent, 1U) << "own frames come back";
}

}  // namespace
}  // namespace canvoy::host
