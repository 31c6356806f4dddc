// A boot-up that ends during a report: the callback has the manager retire, or the node reset (CiA
// 302-2).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_retire_test {
namespace {

/// A slave booted by the master, with an expected verified program (bit 5) and configuration.
constexpr std::uint32_t optional_slave = 0x25;
constexpr std::uint32_t kept_alive = 0x35;
constexpr unsigned nobody = 1000;

struct EndingMaster : BootNetwork {
  enum class By { retirement, reset };

  /// The work ends in the report with this number.
  EndingMaster(std::uint32_t assignment, By by, unsigned number)
      : BootNetwork(2, {.hooks = hooks()}), by_(by), number_(number) {
    manager.on_report(callback<&EndingMaster::told>(*this));
    startup(0x05);
    assign(5, assignment);
    watch(5, 300);
    for (unsigned index = 0x1F84; index <= 0x1F88; ++index) {
      stored.store(static_cast<std::uint16_t>(index), 5, 0x77);
    }
    start();
  }
  static BootHooks hooks() {
    constexpr auto done = [](void*, const BootTask& task) { task.done({}); };
    return {.update_program = {done, nullptr}, .update_configuration = {done, nullptr}};
  }
  void told(const BootReport& report) {
    EXPECT_EQ(report.slave, 5);
    if (ended_by_retirement()) ADD_FAILURE() << "told of " << boot_text(report);
    if (reports_++ != number_) return;
    if (by_ == By::retirement) manager.retire();
    if (by_ == By::reset) node.command(NmtCommand::reset_communication);
    sent.clear();
  }
  bool ended_by_retirement() const { return by_ == By::retirement && reports_ > number_; }
  /// All messages of a slave. `boots`: also a boot-up message after its reset.
  void play(bool boots) {
    answer_all();
    heartbeat(5, 0x7F);
    if (boots) boot_up(5);
    run_for(1s);
    answer_all();
    heartbeat(5, 0x7F);
  }
  void answer_all() {
    answer(5, 0x1000, 0, 0x77);
    for (std::uint8_t sub = 1; sub <= 4; ++sub) answer(5, 0x1018, sub, 0x77);
  }
  unsigned reports() const { return reports_; }

 private:
  By by_;
  unsigned number_;
  unsigned reports_ = 0;
};

/// Boots, is lost, and is booted again.
void play_all(EndingMaster& sut, bool boots) {
  sut.run_for(1s);
  sut.play(boots);
  sut.run_for(300ms);
  if (boots) sut.boot_up(5);
  sut.run_for(1s);
  sut.play(boots);
  sut.boot_up(5);
  sut.play(boots);
}

template <class Check>
void end_in_each_report(EndingMaster::By by, Check check) {
  for (const std::uint32_t assignment : {optional_slave, kept_alive}) {
    for (const bool boots : {false, true}) {
      EndingMaster undisturbed(assignment, by, nobody);
      play_all(undisturbed, boots);
      ASSERT_GT(undisturbed.reports(), 20U);
      for (unsigned number = 0; number < undisturbed.reports(); ++number) {
        SCOPED_TRACE(std::to_string(assignment) + " in report " + std::to_string(number));
        EndingMaster sut(assignment, by, number);
        play_all(sut, boots);
        check(sut);
      }
    }
  }
}

struct RetiringMaster : BootNetwork {
  /// Retires when the network enters this state.
  RetiringMaster(NetworkBoot when, std::uint32_t startup_value) : when_(when) {
    manager.on_network(callback<&RetiringMaster::network_is>(*this));
    startup(startup_value);
    assign(5, 0x05);
    start();
  }
  void network_is(NetworkBoot network) {
    if (network == when_) manager.retire();
  }

 private:
  NetworkBoot when_;
};

TEST(BootRetirement, AtTheBeginOfTheBootUpResetsNobody) {
  RetiringMaster sut(NetworkBoot::booting, 0x01);
  sut.expect({"77F#00"});
  EXPECT_FALSE(sut.manager.is_active());
  sut.boot_up(5);
  sut.run_for(10s);
  sut.expect({});
}

TEST(BootRetirement, WhenTheNetworkIsCompleteStartsNeitherSlavesNorTheMaster) {
  for (const std::uint32_t startup : {0x01U, 0x03U, 0x07U}) {
    RetiringMaster sut(NetworkBoot::complete, startup);
    sut.sent.clear();
    sut.forget();
    sut.boot_up(5);
    sut.answer(5, 0x1000, 0, 0);
    sut.run_for(10s);
    EXPECT_FALSE(sut.manager.is_active());
    EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
    for (const auto& sent : sut.sent) {
      EXPECT_NE(wire_text(sent.frame), "000#01 00") << "started at " << startup;
    }
    EXPECT_EQ(sut.node.deadline(), never) << "nothing is left to do";
  }
}

TEST(BootRetirement, InAnyReportLeavesAllSlavesAlone) {
  end_in_each_report(EndingMaster::By::retirement, [](EndingMaster& sut) {
    EXPECT_FALSE(sut.manager.is_active());
    for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
      EXPECT_EQ(sut.manager.slave_state(slave), BootManager::SlaveState::none);
    }
    for (const auto& sent : sut.sent) {
      EXPECT_NE(sent.frame.id, 0x605U) << wire_text(sent.frame);
      EXPECT_NE(wire_text(sent.frame), "000#82 00") << "a reset of all nodes";
    }
  });
}

TEST(BootRetirement, ByAResetOfTheMasterInAnyReportBeginsTheBootUpAnew) {
  end_in_each_report(EndingMaster::By::reset, [](EndingMaster& sut) {
    EXPECT_TRUE(sut.manager.is_active());
    sut.forget();
    sut.run_for(2s);
    sut.boot_up(5);
    sut.play(true);
    sut.boot_up(5);
    sut.answer_all();
    sut.heartbeat(5, 0x7F);
    EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
  });
}

}  // namespace
}  // namespace canvoy::boot_retire_test
