// The steps of the boot-up of a slave that hooks carry out: the check of its software (CiA 302-2;
// letters G, H and I) and of its configuration (letter J).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_hooks_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t verified = 0x25;

/// Keeps the tasks that it receives until the test ends them.
struct Worker {
  BootHooks hooks() {
    return {.update_program = callback<&Worker::program>(*this),
            .update_configuration = callback<&Worker::configuration>(*this),
            .abandon = callback<&Worker::abandon>(*this)};
  }
  void program(const BootTask& task) { begin("program", task); }
  void configuration(const BootTask& task) { begin("configuration", task); }
  void begin(const char* what, const BootTask& task) {
    log.push_back(std::string(what) + " " + std::to_string(task.slave));
    EXPECT_FALSE(task.client->busy());
    tasks.push_back(task);
  }
  void abandon(NodeId slave) {
    log.push_back("abandon " + std::to_string(slave));
    std::erase_if(tasks, [slave](const BootTask& task) { return task.slave == slave; });
  }
  void end(BootOutcome outcome) {
    const BootTask task = tasks.front();
    tasks.erase(tasks.begin());
    task.done(outcome);
  }
  std::vector<BootTask> tasks;
  std::vector<std::string> log;
};

struct WorkingMaster : Worker, BootNetwork {
  explicit WorkingMaster(std::uint32_t assignment = optional_slave)
      : BootNetwork(2, {.hooks = hooks()}) {
    assign(5, assignment);
    start();
    BootNetwork::forget();
    bring_up(5);
  }
  void work(BootOutcome outcome) {
    node.advance(now);
    end(outcome);
    settle();
  }
  void expect_work(const std::vector<std::string>& expected) { EXPECT_EQ(Worker::log, expected); }
};

TEST(BootSlaveHooks, ConfigureEachSlaveBeforeItIsStarted) {
  WorkingMaster sut;
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  sut.run_until(Time(1h));
  sut.expect({});
  sut.work({});
  sut.expect({"@3600000000 000#01 05"});
  sut.expect_work({"configuration 5"});
  sut.expect_log({"@0 5 device_type", "@0 5 configuration", "@3600000 5 error_control",
                  "@3600000 5 booted", "@3600000 5 started"});
}

TEST(BootSlaveHooks, CheckTheSoftwareFirstWhere1F81hBit5AsksForIt) {
  WorkingMaster sut(verified);
  sut.expect_work({"program 5"});
  sut.work({});
  sut.expect_work({"program 5", "configuration 5"});
  sut.work({});
  sut.expect_log({"5 device_type", "5 program", "5 configuration", "5 error_control", "5 booted",
                  "5 started"});
}

TEST(BootSlaveHooks, MayUseTheClientOfTheSlot) {
  WorkingMaster sut;
  sut.BootNetwork::forget();
  const std::uint8_t time[] = {0x11, 0x22, 0x33, 0x44};
  EXPECT_EQ(sut.tasks[0].client->download(5, 0x1020, 2, time, {}), AbortCode::none);
  sut.expect({"605#23 20 10 02 11 22 33 44"});
  sut.receive("585#60 20 10 02 00 00 00 00");
  sut.work({});
  sut.expect({"000#01 05"});
}

/// Result of the restart that a hook requested.
struct Restart {
  void ended(AbortCode how) { answers.push_back(how); }
  Callback<void(AbortCode)> callback() { return canvoy::callback<&Restart::ended>(*this); }
  std::vector<AbortCode> answers;
};

TEST(BootSlaveHooks, MayRestartTheSlaveAndHearOfItsBootUpMessage) {
  WorkingMaster sut;
  Restart restart;
  sut.BootNetwork::forget();
  sut.tasks[0].restart(NmtCommand::reset_node, restart.callback());
  sut.settle();
  sut.expect({"000#81 05"});
  EXPECT_TRUE(restart.answers.empty());
  sut.boot_up(5);
  EXPECT_EQ(restart.answers, std::vector<AbortCode>{AbortCode::none});
  sut.run_until(Time(1h));
  sut.expect_log({});
  sut.expect_work({"configuration 5"});
  sut.work({});
  sut.expect({"@3600000000 000#01 05"});
}

TEST(BootSlaveHooks, HearOfARestartWithoutABootUpMessage) {
  WorkingMaster sut;
  Restart restart;
  sut.BootNetwork::forget();
  sut.tasks[0].restart(NmtCommand::reset_communication, restart.callback());
  sut.run_until(Time(999'999us));
  sut.expect({"@0 000#82 05"});
  EXPECT_TRUE(restart.answers.empty());
  sut.run_until(Time(1s));
  EXPECT_EQ(restart.answers, std::vector<AbortCode>{AbortCode::time_out});
}

TEST(BootSlaveHooks, AreAbandonedWhenTheSlaveRestartsAgainAfterThat) {
  WorkingMaster sut;
  Restart restart;
  sut.tasks[0].restart(NmtCommand::reset_node, restart.callback());
  sut.settle();
  sut.boot_up(5);
  sut.boot_up(5);
  EXPECT_EQ(restart.answers.size(), 1U);
  sut.expect_work({"configuration 5", "abandon 5"});
}

TEST(BootSlaveHooks, HearNothingMoreOfARestartOnceTheyAreAbandoned) {
  WorkingMaster sut;
  Restart restart;
  sut.tasks[0].restart(NmtCommand::reset_node, restart.callback());
  sut.manager.retire();
  sut.boot_up(5);
  sut.run_for(10s);
  EXPECT_TRUE(restart.answers.empty());
  sut.expect_work({"configuration 5", "abandon 5"});
}

TEST(BootSlaveHooks, EndTheBootUpWithTheLetterThatTheyGive) {
  const BootOutcome outcomes[] = {{BootError::no_program_data, AbortCode::no_object},
                                  {BootError::program_not_allowed, AbortCode::none},
                                  {BootError::program_download, AbortCode::hardware}};
  const char* told[] = {"5 failed G 06020000", "5 failed H", "5 failed I 06060000"};
  for (int i = 0; i < 3; ++i) {
    WorkingMaster sut(verified);
    sut.BootNetwork::forget();
    sut.work(outcomes[i]);
    sut.expect_log({told[i]});
    sut.run_for(1h);
    sut.expect({});
    sut.expect_work({"program 5"});
  }
  WorkingMaster sut;
  sut.BootNetwork::forget();
  sut.work({BootError::configuration, AbortCode::value_range});
  sut.expect_log({"5 failed J 06090030"});
  sut.expect({});
  EXPECT_EQ(sut.manager.slave_error(5), BootError::configuration);
}

TEST(BootSlaveHooks, ThatMetASilentSlaveAreAskedAgain) {
  WorkingMaster sut;
  sut.BootNetwork::forget();
  sut.work({BootError::configuration, SdoEnd::no_answer()});
  sut.run_until(Time(1s));
  sut.expect({"@1000000 605#40 00 10 00 00 00 00 00"});
  sut.expect_log({"@0 5 retried J 05040000", "@1000 5 device_type"});
}

TEST(BootSlaveHooks, AreToldWhenTheSlaveRestartsInTheMiddleOfItsConfiguration) {
  WorkingMaster sut;
  sut.BootNetwork::forget();
  sut.run_until(Time(5ms));
  sut.receive("705#00");
  sut.expect_work({"configuration 5", "abandon 5"});
  sut.expect({"605#40 00 10 00 00 00 00 00"});
  sut.expect_log({"@5 5 restarted in configuration", "@5 5 device_type"});
  sut.answer(5, 0x1000, 0, 0);
  sut.expect_work({"configuration 5", "abandon 5", "configuration 5"});
  sut.work({});
  sut.expect({"000#01 05"});
}

TEST(BootSlaveHooks, RestartASlaveWithNewSoftwareWithoutHarm) {
  WorkingMaster sut(verified);
  sut.BootNetwork::forget();
  sut.receive("705#00");
  sut.expect_work({"program 5"});
  sut.work({});
  sut.expect_work({"program 5", "configuration 5"});
  sut.expect_log({"5 configuration"});
}

TEST(BootSlaveHooks, AreToldWhenTheMasterIsResetOrStopped) {
  for (const char* command : {"000#82 7F", "000#02 7F"}) {
    WorkingMaster sut;
    sut.receive(command);
    sut.expect_work({"configuration 5", "abandon 5"});
  }
}

TEST(BootSlaveHooks, ThatEndSinceTheMasterWasStoppedBlameNoSlave) {
  WorkingMaster sut;
  std::uint8_t bytes[4];
  struct Ending {
    WorkingMaster& sut;
    void ended(SdoClient::Outcome outcome) { sut.end({BootError::configuration, outcome}); }
  } ending{sut};
  EXPECT_EQ(
      sut.tasks[0].client->upload(5, 0x1020, 1, bytes, SdoClient::Done::to<&Ending::ended>(ending)),
      AbortCode::none);
  sut.BootNetwork::forget();
  sut.receive("000#02 7F");
  sut.expect_log({});
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::waiting);
  sut.receive("000#80 7F");
  sut.expect_log({"5 device_type"});
}

TEST(BootSlaveHooks, WorkOnAsManySlavesAsThereAreSlots) {
  Worker worker;
  BootNetwork sut(3, {.hooks = worker.hooks()});
  for (NodeId slave = 1; slave <= 5; ++slave) sut.assign(slave, optional_slave);
  sut.start();
  for (NodeId slave = 1; slave <= 5; ++slave) sut.boot_up(slave);
  for (NodeId slave = 1; slave <= 3; ++slave) sut.answer(slave, 0x1000, 0, 0);
  EXPECT_EQ(worker.log,
            (std::vector<std::string>{"configuration 1", "configuration 2", "configuration 3"}));
  sut.forget();
  worker.end({});
  sut.settle();
  sut.expect({"000#01 01", "604#40 00 10 00 00 00 00 00"});
}

}  // namespace
}  // namespace canvoy::boot_slave_hooks_test
