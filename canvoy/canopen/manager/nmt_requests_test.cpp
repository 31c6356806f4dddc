// Request NMT (1F82h) and request guarding (1F83h): every value, every sub-index, in every state of
// the master (CiA 302-2).
#include "canvoy/canopen/manager/nmt_requests.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::nmt_requests_test {
namespace {

/// Node 127 is a running NMT master without slaves, and answers SDO requests.
struct RequestedMaster : BootNetwork {
  explicit RequestedMaster(std::uint32_t startup_bits = 0x01)
      : requests(node, master, commands, manager,
                 {callback<&RequestedMaster::begin>(*this), callback<&RequestedMaster::end>(*this),
                  callback<&RequestedMaster::is_guarded>(*this)}),
        server(node, 0, buffer) {
    startup(startup_bits);
    start();
    forget();
    guard_log.clear();
  }
  bool begin(NodeId slave, Duration time, std::uint8_t factor) {
    if (time == Duration::zero()) return false;
    guard_log.push_back("guard " + std::to_string(slave) + " " + std::to_string(time / 1ms) + " " +
                        std::to_string(factor));
    guarded[slave] = true;
    return true;
  }
  void end(NodeId slave) {
    guard_log.push_back("stop " + std::to_string(slave));
    guarded[slave] = false;
  }
  bool is_guarded(NodeId slave) { return guarded[slave]; }
  std::uint64_t read(std::uint16_t index, std::uint8_t sub) {
    const auto bytes = node.dictionary().read(*node.dictionary().find(index, sub));
    return bytes ? load_unsigned(*bytes) : 0xFFFF;
  }

  std::vector<std::string> guard_log;
  std::array<bool, 128> guarded{};
  std::array<std::uint8_t, 256> buffer{};
  NmtRequests requests;
  SdoServer server;
};

TEST(NmtRequests, CommandANodeAfterTheAnswer) {
  RequestedMaster sut;
  sut.receive("67F#2F 82 1F 0A 05 00 00 00");
  sut.expect({"5FF#60 82 1F 0A 00 00 00 00", "000#01 0A"});
  sut.receive("67F#2F 82 1F 0A 04 00 00 00");
  sut.receive("67F#2F 82 1F 0A 06 00 00 00");
  sut.receive("67F#2F 82 1F 0A 07 00 00 00");
  sut.receive("67F#2F 82 1F 0A 7F 00 00 00");
  sut.expect({"5FF#60 82 1F 0A 00 00 00 00", "000#02 0A", "5FF#60 82 1F 0A 00 00 00 00",
              "000#81 0A", "5FF#60 82 1F 0A 00 00 00 00", "000#82 0A",
              "5FF#60 82 1F 0A 00 00 00 00", "000#80 0A"});
}

TEST(NmtRequests, CommandAllNodesWithTheMasterBySubIndex80h) {
  RequestedMaster sut;
  sut.receive("67F#2F 82 1F 80 7F 00 00 00");
  sut.expect({"5FF#60 82 1F 80 00 00 00 00", "000#80 00"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  sut.receive("67F#2F 82 1F 80 07 00 00 00");
  sut.expect({"5FF#60 82 1F 80 00 00 00 00", "000#82 00", "77F#00", "000#82 00"});
}

TEST(NmtRequests, CommandTheMasterItselfWithoutAFrame) {
  RequestedMaster sut;
  sut.receive("67F#2F 82 1F 7F 7F 00 00 00");
  sut.expect({"5FF#60 82 1F 7F 00 00 00 00"});
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
}

TEST(NmtRequests, KnowFiveValuesOf256ForEachOf128SubIndices) {
  for (unsigned value = 0; value < 256; ++value) {
    const bool known = (value >= 4 && value <= 7) || value == 0x7F;
    RequestedMaster sut;
    for (unsigned sub = 1; sub <= 126; ++sub) {
      const AbortCode answer = sut.write(0x1F82, static_cast<std::uint8_t>(sub), value);
      EXPECT_EQ(answer, known ? AbortCode::none : AbortCode::value_range);
    }
    EXPECT_EQ(sut.sent.size(), known ? 126U : 0U);
    EXPECT_EQ(sut.write(0x1F82, 128, value), known ? AbortCode::none : AbortCode::value_range);
  }
}

TEST(NmtRequests, AreRefusedWhereTheDeviceIsNotTheNmtMaster) {
  RequestedMaster sut(0x00);
  for (unsigned sub = 1; sub <= 128; ++sub) {
    EXPECT_EQ(sut.write(0x1F82, static_cast<std::uint8_t>(sub), 5), AbortCode::device_state);
    EXPECT_EQ(sut.write(0x1F83, static_cast<std::uint8_t>(sub), 1), AbortCode::device_state);
  }
  sut.expect({});
}

TEST(NmtRequests, AreRefusedWhileTooManyWait) {
  RequestedMaster sut;
  for (int i = 0; i < 128; ++i) EXPECT_TRUE(sut.commands.add({10, NmtCommand::start}));
  const std::uint8_t start = 5;
  EXPECT_EQ(sut.node.dictionary().write(0x1F82, 11, std::span(&start, 1), Source::sdo),
            AbortCode::out_of_memory);
}

TEST(NmtRequests, TellTheStateOfEachNode) {
  RequestedMaster sut;
  EXPECT_EQ(sut.read(0x1F82, 10), 0x00U);
  sut.receive("70A#00");
  EXPECT_EQ(sut.read(0x1F82, 10), 0x7FU);
  sut.receive("70A#05");
  EXPECT_EQ(sut.read(0x1F82, 10), 0x05U);
  sut.receive("70A#04");
  EXPECT_EQ(sut.read(0x1F82, 10), 0x04U);
  sut.master.set_time_out(10, 100ms);
  sut.receive("70A#7F");
  EXPECT_EQ(sut.read(0x1F82, 10), 0x7FU);
  sut.run_for(100ms);
  EXPECT_EQ(sut.read(0x1F82, 10), 0x01U);
  EXPECT_EQ(sut.read(0x1F82, 11), 0x00U);
  EXPECT_EQ(sut.read(0x1F82, 127), 0x05U) << "the master itself is operational";
  sut.receive("67F#40 82 1F 80 00 00 00 00");
  sut.expect({"5FF#80 82 1F 80 01 00 01 06"});
}

TEST(NmtRequests, BeginAndEndGuardingWithTheTimesOf1F81h) {
  RequestedMaster sut;
  sut.stored.store(0x1F81, 5, 0x0064'0201);
  sut.receive("000#82 7F");
  sut.guard_log.clear();
  EXPECT_EQ(sut.write(0x1F83, 5, 1), AbortCode::none);
  EXPECT_EQ(sut.read(0x1F83, 5), 1U);
  EXPECT_EQ(sut.write(0x1F83, 5, 0), AbortCode::none);
  EXPECT_EQ(sut.read(0x1F83, 5), 0U);
  EXPECT_EQ(sut.guard_log, (std::vector<std::string>{"guard 5 100 2", "stop 5"}));
  EXPECT_EQ(sut.write(0x1F83, 6, 1), AbortCode::device_state) << "without a guard time";
  for (unsigned value = 2; value < 256; ++value) {
    EXPECT_EQ(sut.write(0x1F83, 5, value), AbortCode::value_range);
  }
}

TEST(NmtRequests, BeginTheGuardingOfAllSlavesThatHaveAGuardTime) {
  RequestedMaster sut;
  sut.stored.store(0x1F81, 5, 0x0064'0201);
  sut.stored.store(0x1F81, 6, 0x0000'0001);
  sut.stored.store(0x1F81, 7, 0x0032'0301);
  sut.stored.store(0x1F81, 8, 0x0032'0300);
  sut.receive("000#82 7F");
  sut.guard_log.clear();
  EXPECT_EQ(sut.write(0x1F83, 128, 1), AbortCode::none);
  EXPECT_EQ(sut.guard_log, (std::vector<std::string>{"guard 5 100 2", "guard 7 50 3"}));
}

}  // namespace
}  // namespace canvoy::nmt_requests_test
