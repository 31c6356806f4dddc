// Slaves that disturb their own boot-up: a restart in each step, answers that are late, doubled,
// short or of another kind, two nodes with one node-ID (CiA 302-2).
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/testing/bit_flips.hpp"
#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_restart_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;

/// Slave 5 with all expectations, each 77h, and a heartbeat within 300 ms.
struct DisturbedMaster : BootNetwork {
  explicit DisturbedMaster(std::uint32_t assignment = optional_slave) {
    assign(5, assignment);
    watch(5, 300);
    for (unsigned index = 0x1F84; index <= 0x1F88; ++index) {
      stored.store(static_cast<std::uint16_t>(index), 5, 0x77);
    }
    start();
    forget();
  }
  void answer_next(unsigned question) {
    answer(5, question == 0 ? 0x1000 : 0x1018, static_cast<std::uint8_t>(question), 0x77);
  }
};

TEST(BootSlaveRestart, InTheMiddleOfAnyQuestionBeginsTheBootUpAnew) {
  for (unsigned answered = 0; answered < 5; ++answered) {
    DisturbedMaster sut;
    sut.boot_up(5);
    for (unsigned question = 0; question < answered; ++question) sut.answer_next(question);
    sut.forget();
    sut.run_until(Time(100ms));
    sut.boot_up(5);
    ASSERT_GE(sut.log.size(), 2U);
    EXPECT_EQ(sut.log[0].text.substr(0, 15), "5 restarted in ");
    EXPECT_EQ(sut.log[1].text, "5 device_type");
    EXPECT_EQ(wire_text(sut.sent.back().frame), "605#40 00 10 00 00 00 00 00");
    for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
    sut.forget();
    sut.heartbeat(5, 0x7F);
    sut.expect({"000#01 05"});
  }
}

/// 1F82h, or a node that has its master reset it: no fault of the slave, however often.
TEST(BootSlaveRestart, ThatItIsToldOfIsNone) {
  DisturbedMaster sut;
  sut.boot_up(5);
  for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
  sut.heartbeat(5, 0x7F);
  for (int times = 0; times < 10; ++times) {
    sut.forget();
    EXPECT_TRUE(sut.commands.add({5, NmtCommand::reset_communication}));
    sut.run_for(100ms);
    sut.boot_up(5);
    for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
    sut.heartbeat(5, 0x7F);
    for (const auto& note : sut.log) {
      EXPECT_EQ(note.text.find("restarted"), std::string::npos) << times;
    }
    EXPECT_EQ(wire_text(sut.sent.back().frame), "000#01 05") << times;
  }
  sut.boot_up(5);
  EXPECT_EQ(sut.log.back().text, "5 device_type");
  EXPECT_EQ(sut.log.rbegin()[1].text, "5 restarted in done") << "by itself";
}

/// Slave 5 boots in place of each answer, 3 ms later; records the requests of its boot-up, with
/// times.
struct RestartingSlave : DisturbedMaster {
  void answer_by_boot_ups(Duration time) {
    const Time end = now + time;
    boot_up(5);
    for (std::size_t seen = 0; now < end; run_for(3ms)) {
      bool is_asked = false;
      for (; seen < sent.size(); ++seen) {
        if (wire_text(sent[seen].frame) != "605#40 00 10 00 00 00 00 00") continue;
        asked.push_back(sent[seen].at.time_since_epoch() / 1ms);
        is_asked = true;
      }
      if (!is_asked) continue;
      run_for(3ms);
      boot_up(5);
    }
  }
  std::size_t count(std::string_view text) const {
    return static_cast<std::size_t>(std::ranges::count(log, text, &Note::text));
  }
  std::vector<long> asked;
};

TEST(BootSlaveRestart, AgainAndAgainIsSlowedDownAndGivenUp) {
  RestartingSlave sut;
  sut.answer_by_boot_ups(1h);
  ASSERT_EQ(sut.asked.size(), 8U) << "at once, three times again, and then four times more";
  EXPECT_LE(sut.asked[3], 30);
  const long pauses[] = {1000, 2000, 4000, 8000};
  for (std::size_t i = 0; i < 4; ++i) {
    const long pause = sut.asked[4 + i] - sut.asked[3 + i];
    EXPECT_GE(pause, pauses[i]);
    EXPECT_LE(pause, pauses[i] + 10);
  }
  EXPECT_EQ(sut.count("5 restarted in device_type"), 8U);
  EXPECT_EQ(sut.count("5 slowed"), 4U);
  EXPECT_EQ(sut.count("5 given_up B"), 1U);
  EXPECT_EQ(sut.log.back().text, "5 given_up B");
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::failed);
  for (const auto& sent : sut.sent) EXPECT_NE(sent.frame.id, 0U);
}

TEST(BootSlaveRestart, ThatWasGivenUpIsWorthOneSlowAttemptAndAfterAWhileAPromptOne) {
  RestartingSlave sut;
  sut.answer_by_boot_ups(20s);
  sut.asked.clear();
  sut.sent.clear();
  for (int i = 0; i < 100; ++i) sut.heartbeat(5, 0x7F);
  sut.expect({});
  const long now = sut.now.time_since_epoch() / 1ms;
  sut.answer_by_boot_ups(20s);
  ASSERT_EQ(sut.asked.size(), 1U);
  EXPECT_GE(sut.asked[0] - now, 8000);
  EXPECT_LE(sut.asked[0] - now, 8010);
  EXPECT_EQ(sut.count("5 given_up B"), 2U);
  sut.run_for(1min);
  sut.sent.clear();
  sut.boot_up(5);
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
  sut.sent.clear();
  sut.heartbeat(5, 0x7F);
  sut.expect({"000#01 05"});
}

TEST(BootSlaveRestart, NowAndThenIsNeverSlowedDown) {
  RestartingSlave sut;
  for (int i = 0; i < 100; ++i) {
    sut.boot_up(5);
    EXPECT_EQ(wire_text(sut.sent.back().frame), "605#40 00 10 00 00 00 00 00");
    for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
    for (int beat = 0; beat < 160; ++beat) {
      sut.heartbeat(5, 0x7F);
      sut.run_for(200ms);
    }
  }
  EXPECT_EQ(sut.count("5 slowed"), 0U);
  EXPECT_EQ(sut.count("5 restarted in done"), 99U);
}

/// The slot of a slave that was given up is free for others.
TEST(BootSlaveRestart, WithoutEndKeepsNoOtherSlaveWaiting) {
  BootNetwork sut(1);
  sut.assign(4, optional_slave);
  sut.assign(5, optional_slave);
  sut.start();
  for (int i = 0; i < 30; ++i) {
    sut.boot_up(4);
    sut.run_for(1s);
  }
  sut.forget();
  sut.boot_up(5);
  sut.answer(5, 0x1000, 0, 0);
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
}

TEST(BootSlaveRestart, WhileItWaitsForItsTurnCountsOnce) {
  BootNetwork sut(1);
  sut.assign(4, optional_slave);
  sut.assign(5, optional_slave);
  sut.start();
  sut.boot_up(4);
  sut.forget();
  for (int i = 0; i < 3; ++i) sut.boot_up(5);
  sut.expect({});
  sut.answer(4, 0x1000, 0, 0);
  sut.expect({"000#01 04", "605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0);
  sut.expect({"000#01 05"});
}

TEST(BootSlaveRestart, IsNoneAfterAResetThatComesLateByTheInhibitTime) {
  BootNetwork sut;
  sut.stored.store(0x102A, 0, 10000);  // NMT commands each second
  sut.assign(5, 0x05);
  sut.start();
  sut.run_until(Time(1s - 1us));
  sut.forget();
  sut.run_until(Time(1s));
  sut.answer(5, 0x1000, 0, 0);
  sut.run_until(Time(1500ms));
  sut.expect({"@1000000 605#40 00 10 00 00 00 00 00", "@1000000 000#82 05"});
  sut.boot_up(5);
  sut.expect_log({"@1000 5 device_type", "@1000 5 reset", "@1500 5 error_control", "@1500 5 booted",
                  "@1500 5 started"});
  sut.run_until(Time(2s));
  sut.expect({"@2000000 000#01 05"});
}

TEST(BootSlaveRestart, OfTwoNodesWithOneNodeIdIsTold) {
  DisturbedMaster sut;
  sut.boot_up(5);
  sut.boot_up(5);
  sut.expect_log({"5 device_type", "5 restarted in device_type", "5 device_type"});
  // Both answer each request: the second answer belongs to no request.
  sut.forget();
  for (unsigned question = 0; question < 5; ++question) {
    sut.answer_next(question);
    sut.answer_next(question);
  }
  sut.heartbeat(5, 0x7F);
  sut.heartbeat(5, 0x7F);
  std::size_t starts = 0;
  for (const auto& sent : sut.sent) starts += sent.frame.id == 0 ? 1U : 0U;
  EXPECT_EQ(starts, 1U);
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
}

TEST(BootSlaveRestart, IsNoAnswerOfAnotherKind) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    DisturbedMaster sut;
    sut.boot_up(5);
    sut.forget();
    Frame frame = wire_frame("585#00 00 10 00 99 00 00 00");
    frame.data[0] = static_cast<std::uint8_t>(byte);
    sut.node.receive(frame, sut.now);
    sut.settle();
    for (const auto& sent : sut.sent) EXPECT_NE(sent.frame.id, 0U) << byte;
    EXPECT_NE(sut.manager.slave_state(5), BootManager::SlaveState::booted) << byte;
    sut.run_for(10s);
    for (const auto& sent : sut.sent) EXPECT_NE(sent.frame.id, 0U) << byte;
  }
}

TEST(BootSlaveRestart, IsNothingThatAShortFrameCouldMean) {
  for (std::uint8_t length = 0; length < 8; ++length) {
    DisturbedMaster sut;
    sut.boot_up(5);
    sut.forget();
    Frame frame = wire_frame("585#43 00 10 00 77 00 00 00");
    frame.length = length;
    sut.node.receive(frame, sut.now);
    sut.settle();
    sut.expect({});
    sut.answer_next(0);
    sut.expect({"605#40 18 10 01 00 00 00 00"});
  }
  DisturbedMaster sut;
  sut.receive("705#");
  sut.receive("705#00 00");
  sut.receive("705#R1");
  sut.expect({});
}

TEST(BootSlaveRestart, InAnyNmtStateOfTheMasterHarmsNobody) {
  for (const char* command : {"000#01 7F", "000#02 7F", "000#80 7F", "000#81 7F", "000#82 7F"}) {
    for (unsigned answered = 0; answered <= 5; ++answered) {
      DisturbedMaster sut;
      sut.boot_up(5);
      for (unsigned question = 0; question < answered; ++question) sut.answer_next(question);
      sut.receive(command);
      sut.receive("000#01 7F");
      sut.boot_up(5);
      for (unsigned question = 0; question < 5; ++question) sut.answer_next(question);
      sut.forget();
      sut.heartbeat(5, 0x7F);
      sut.expect({"000#01 05"});
      EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted) << command;
    }
  }
}

/// Each bit of 1F81h in each combination: a slave that obeys boots, or is left.
TEST(BootSlaveRestart, DoesNotHappenToASlaveThatDoesAsItIsTold) {
  for (std::uint32_t assignment = 0; assignment < 0x100; ++assignment) {
    BootNetwork sut;
    sut.assign(5, assignment);
    sut.watch(5, 300);
    sut.start();
    sut.boot_up(5);
    sut.answer(5, 0x1000, 0, 0);
    sut.heartbeat(5, 0x7F);
    sut.heartbeat(5, 0x7F);
    const bool is_slave = (assignment & 1) != 0;
    const bool is_booted = (assignment & 4) != 0;
    std::size_t starts = 0;
    std::size_t questions = 0;
    for (const auto& sent : sut.sent) {
      starts += wire_text(sent.frame) == "000#01 05" ? 1U : 0U;
      questions += sent.frame.id == 0x605 && sent.frame.data[0] == 0x40 ? 1U : 0U;
    }
    EXPECT_EQ(starts, is_slave && is_booted ? 1U : 0U) << assignment;
    EXPECT_EQ(questions != 0, is_slave && is_booted) << assignment;
    EXPECT_EQ(sut.manager.slave_state(5),
              is_slave ? BootManager::SlaveState::booted : BootManager::SlaveState::none)
        << assignment;
  }
}

/// Messages of slave 5 in a boot-up.
constexpr const char* dialogue[] = {"705#00",
                                    "585#43 00 10 00 77 00 00 00",
                                    "585#43 18 10 01 77 00 00 00",
                                    "585#43 18 10 02 77 00 00 00",
                                    "585#43 18 10 03 77 00 00 00",
                                    "585#43 18 10 04 77 00 00 00",
                                    "705#7F"};

bool starts_a_slave(const DisturbedMaster& master) {
  return std::ranges::any_of(master.sent, [](const WireNode::Sent& sent) {
    return wire_text(sent.frame).starts_with("000#01");
  });
}

TEST(BootSlaveBitFlip, InAnyFrameOfTheSlaveStartsNobodyAndHarmsNoLaterBootUp) {
  for (std::size_t place = 0; place < std::size(dialogue); ++place) {
    for (const Frame& flip : bit_flips(wire_frame(dialogue[place]))) {
      SCOPED_TRACE(wire_text(flip) + " in place of " + dialogue[place]);
      DisturbedMaster sut;
      for (std::size_t before = 0; before < place; ++before) sut.receive(dialogue[before]);
      sut.node.receive(flip, sut.now);
      sut.settle();
      // Some bits of the heartbeat have no effect.
      const bool is_heartbeat = flip.id == 0x705 && flip.length == 1 && !flip.is_remote();
      EXPECT_FALSE(starts_a_slave(sut) && !(place == 6 && is_heartbeat));
      sut.run_for(10s);
      sut.forget();
      for (const char* said : dialogue) sut.receive(said);
      EXPECT_TRUE(starts_a_slave(sut));
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace canvoy::boot_slave_restart_test
