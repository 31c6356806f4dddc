// python-can as a peer on the UDP multicast bus, in a network that the test makes for itself.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/can/host/own_network_test.hpp"

namespace canvoy::host {
namespace {

class Program {
 public:
  Program(const char* interpreter, const char* script) : child_(fork()) {
    if (child_ != 0) return;
    execl(interpreter, interpreter, script, nullptr);
    _exit(127);
  }
  int wait() const {
    int status = 0;
    EXPECT_EQ(waitpid(child_, &status, 0), child_);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }

 private:
  pid_t child_;
};

struct Node {
  Node(EventLoop& loop, HostBus& bus) : attachment(loop, bus), port(attachment.port()) {
    attachment.attach(*this);
  }
  void receive(const Frame& frame, Time) { heard.emplace_back(FrameText(frame).view()); }

  Attachment attachment;
  Port port;
  std::vector<std::string> heard;
};

using Heard = std::vector<std::string>;

TEST(PythonCan, HearsAndAnswersEveryKindOfFrameByUdpMulticast) {
  if (std::system("/usr/bin/python3 -c 'import can, msgpack' 2>/dev/null") != 0) {
    GTEST_SKIP()
        << "python3-can or python3-msgpack is missing; scripts/install-packages installs them";
  }
  const OwnNetwork network;
  if (!network.entered()) GTEST_SKIP() << "a network of its own needs root";
  network.add_multicast_route();
  const std::unique_ptr<EventLoop> loop = *EventLoop::create();
  Result<std::unique_ptr<HostBus>> bus = open_bus(*loop, "udp:239.74.163.2:43113");
  ASSERT_TRUE(bus) << bus.error().line();
  Node node(*loop, **bus);
  const auto hear = [&](std::size_t count) {
    const Time give_up = loop->now() + 30s;
    while (node.heard.size() < count && loop->now() < give_up) loop->run_until(loop->now() + 1ms);
    return node.heard.size() == count;
  };

  const Program peer("/usr/bin/python3", CANVOY_PEER);
  ASSERT_TRUE(hear(1));
  EXPECT_EQ(node.heard, Heard{"7FE#"});

  const Heard sent{"185#1E2F", "000#",  "00000185#FF", "1FFFFFFE#0102030405060708",
                   "701#R8",   "701#R", "12345678#R3"};
  const Heard answers{"186#1E2F", "001#",  "00000186#FF", "1FFFFFFF#0102030405060708",
                      "702#R8",   "702#R", "12345679#R3"};
  for (std::size_t i = 0; i < sent.size(); ++i) {
    node.heard.clear();
    ASSERT_TRUE(node.port.send(node.port.context, parse_frame(sent[i]).frame));
    ASSERT_TRUE(hear(1)) << sent[i];
    EXPECT_EQ(node.heard[0], answers[i]);
  }

  ASSERT_TRUE(node.port.send(node.port.context, parse_frame("7FF#").frame));
  EXPECT_EQ(peer.wait(), 0);
  loop->run_until(loop->now() + 10ms);
  EXPECT_EQ((*bus)->counters().carrier.fd, 1U);
  EXPECT_EQ((*bus)->counters().carrier.malformed, 0U);
  EXPECT_EQ((*bus)->counters().sent, sent.size() + 1);
}

}  // namespace
}  // namespace canvoy::host
