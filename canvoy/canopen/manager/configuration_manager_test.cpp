// The configuration manager in node 1, frame by frame (CiA 302-3: 1F22h, 1F25h, 1F26h, 1F27h).
#include "canvoy/canopen/manager/configuration_manager.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/concise_dcf_bytes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::configuration_manager_test {
namespace {

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1F22, .entry_count = 2},
                              {.index = 0x1F25, .entry_count = 2},
                              {.index = 0x1F26, .count = 2, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 127},
         {.sub_first = 1, .sub_last = 127, .type = DataType::domain, .access = Access::rw},
         {.access = Access::const_, .initial = 128},
         {.sub_first = 1, .sub_last = 128, .type = DataType::unsigned32, .access = Access::wo},
         {.access = Access::const_, .initial = 127},
         {.sub_first = 1, .sub_last = 127, .type = DataType::unsigned32, .access = Access::rw}}));

const std::vector<std::uint8_t> for_5 =
    concise_dcf({{0x1017, 0, {0xF4, 0x01}}, {0x2000, 3, {0x07}}});
const std::vector<std::uint8_t> for_6 = concise_dcf({{0x2000, 3, {0x08}}});
const std::vector<std::uint8_t> for_7 = {0x01, 0x00, 0x00, 0x00, 0x17};  // cut
const std::vector<std::uint8_t> for_8 = {0x00, 0x00, 0x00, 0x00};        // empty
const FixedConfigurations::Item items[] = {{.slave = 5, .concise_dcf = for_5},
                                           {.slave = 6, .concise_dcf = for_6},
                                           {.slave = 7, .concise_dcf = for_7},
                                           {.slave = 8, .concise_dcf = for_8}};

using Kind = ConfigurationOutcome::Kind;

struct Manager : WireNode {
  explicit Manager() : WireNode(layout.tables(), 1) {
    sut.on_done(ConfigurationManager::Done::to<&Manager::done>(*this));
    boot();
  }
  void done(NodeId slave, const ConfigurationOutcome& result) {
    slaves.push_back(slave);
    outcome = result;
    if (again) {
      again = false;
      EXPECT_EQ(sut.update(slave), AbortCode::none);
    }
  }
  void update(NodeId slave) {
    EXPECT_EQ(sut.update(slave), AbortCode::none);
    settle();
  }
  void expect_date(NodeId slave, std::uint32_t days, std::uint32_t milliseconds) {
    node.dictionary().set_number(0x1F26, slave, days);
    node.dictionary().set_number(0x1F27, slave, milliseconds);
  }

  SdoServer server{node, 0, {}};
  FixedConfigurations configurations{node, items};
  ConfigurationManager::Worker workers[2] = {ConfigurationManager::Worker(node),
                                             ConfigurationManager::Worker(node)};
  ConfigurationManager sut{node, workers, 500ms};
  std::vector<NodeId> slaves;
  ConfigurationOutcome outcome;
  bool again = false;
};

// Expected date and time: 3E8h days, 1770h ms.

TEST(ConfigurationManager, ASlaveWithTheExpectedDateAndTimeIsLeftAlone) {
  Manager manager;
  manager.expect_date(5, 0x3E8, 0x1770);
  manager.update(5);
  manager.expect({"605#40 20 10 01 00 00 00 00"});
  manager.receive("585#43 20 10 01 E8 03 00 00");
  manager.expect({"605#40 20 10 02 00 00 00 00"});
  manager.receive("585#43 20 10 02 70 17 00 00");
  manager.expect({});
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{5});
  EXPECT_EQ(manager.outcome.kind, Kind::up_to_date);
  EXPECT_EQ(manager.outcome.written, 0u);
  EXPECT_FALSE(manager.sut.busy(5));
}

TEST(ConfigurationManager, AnotherDateHasItConfiguredAndDated) {
  Manager manager;
  manager.expect_date(5, 0x3E8, 0x1770);
  manager.update(5);
  manager.sent.clear();
  manager.receive("585#43 20 10 01 E7 03 00 00");
  manager.expect({"605#2B 17 10 00 F4 01 00 00"});
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.expect({"605#2F 00 20 03 07 00 00 00"});
  manager.receive("585#60 00 20 03 00 00 00 00");
  manager.expect({"605#23 20 10 01 E8 03 00 00"});
  manager.receive("585#60 20 10 01 00 00 00 00");
  manager.expect({"605#23 20 10 02 70 17 00 00"});
  manager.receive("585#60 20 10 02 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
  EXPECT_EQ(manager.outcome.written, 2u);
}

TEST(ConfigurationManager, WhatWasWrittenCountsAnewWithEachConfiguration) {
  Manager manager;
  for (int i = 0; i < 2; ++i) {
    manager.update(5);
    manager.receive("585#60 17 10 00 00 00 00 00");
    manager.receive("585#60 00 20 03 00 00 00 00");
    EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
    EXPECT_EQ(manager.outcome.written, 2u);
  }
}

TEST(ConfigurationManager, AnotherTimeHasItConfiguredToo) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.update(6);
  manager.receive("586#43 20 10 01 E8 03 00 00");
  manager.sent.clear();
  manager.receive("586#43 20 10 02 71 17 00 00");
  manager.expect({"606#2F 00 20 03 08 00 00 00"});
}

TEST(ConfigurationManager, WithoutAnExpectedDateItIsConfiguredEachTime) {
  Manager manager;
  for (int i = 0; i < 2; ++i) {
    manager.update(6);
    manager.expect({"606#2F 00 20 03 08 00 00 00"});
    manager.receive("586#60 00 20 03 00 00 00 00");
    manager.expect({});
    EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
  }
  EXPECT_EQ(manager.slaves.size(), 2u);
}

TEST(ConfigurationManager, ASlaveWithout1020hIsConfiguredAndNotDated) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0);
  manager.update(6);
  manager.sent.clear();
  manager.receive("586#80 20 10 01 00 00 02 06");
  manager.expect({"606#2F 00 20 03 08 00 00 00"});
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
}

TEST(ConfigurationManager, ASlaveThatIsSilentHasFailedAt1020h) {
  Manager manager;
  manager.expect_date(5, 0x3E8, 0x1770);
  manager.update(5);
  manager.run_for(500ms);
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{5});
  EXPECT_EQ(manager.outcome.kind, Kind::failed);
  EXPECT_EQ(manager.outcome.end, SdoEnd::no_answer());
  EXPECT_EQ(manager.outcome.index, 0x1020);
  EXPECT_EQ(manager.outcome.sub, 1);
  EXPECT_EQ(manager.outcome.written, 0u);
}

TEST(ConfigurationManager, AnEntryThatIsRefusedIsNamedAndTheDateNotWritten) {
  Manager manager;
  manager.expect_date(5, 0x3E8, 0x1770);
  manager.update(5);
  manager.receive("585#43 20 10 01 00 00 00 00");
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.sent.clear();
  manager.receive("585#80 00 20 03 30 00 09 06");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::failed);
  EXPECT_EQ(manager.outcome.end, SdoEnd::by_server(AbortCode::value_range));
  EXPECT_EQ(manager.outcome.index, 0x2000);
  EXPECT_EQ(manager.outcome.sub, 3);
  EXPECT_EQ(manager.outcome.written, 1u);
}

TEST(ConfigurationManager, ADateThatIsRefusedHasFailed) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.update(6);
  manager.receive("586#43 20 10 01 00 00 00 00");
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.sent.clear();
  manager.receive("586#80 20 10 01 02 00 01 06");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::failed);
  EXPECT_EQ(manager.outcome.end, SdoEnd::by_server(AbortCode::read_only));
  EXPECT_EQ(manager.outcome.index, 0x1020);
  EXPECT_EQ(manager.outcome.written, 1u);
}

TEST(ConfigurationManager, ATimeThatIsRefusedHasFailed) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.update(6);
  manager.receive("586#43 20 10 01 E8 03 00 00");
  manager.receive("586#80 20 10 02 11 00 09 06");
  EXPECT_EQ(manager.outcome.kind, Kind::failed) << "it cannot be read";
  EXPECT_EQ(manager.outcome.end, SdoEnd::by_server(AbortCode::no_sub_index));
  EXPECT_EQ(manager.outcome.sub, 2);
  manager.update(6);
  manager.receive("586#43 20 10 01 00 00 00 00");
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.receive("586#60 20 10 01 00 00 00 00");
  manager.receive("586#80 20 10 02 02 00 01 06");
  EXPECT_EQ(manager.outcome.kind, Kind::failed) << "it cannot be written";
  EXPECT_EQ(manager.outcome.end, SdoEnd::by_server(AbortCode::read_only));
  EXPECT_EQ(manager.outcome.sub, 2);
}

TEST(ConfigurationManager, ATimeOfDayAloneIsExpectedAsWell) {
  Manager manager;
  manager.expect_date(6, 0, 0x1770);
  manager.update(6);
  manager.expect({"606#40 20 10 01 00 00 00 00"});
  manager.receive("586#43 20 10 01 00 00 00 00");
  manager.expect({"606#40 20 10 02 00 00 00 00"});
  manager.receive("586#43 20 10 02 70 17 00 00");
  EXPECT_EQ(manager.outcome.kind, Kind::up_to_date);
}

TEST(ConfigurationManager, AMalformedConciseDcfIsToBlameItself) {
  Manager manager;
  manager.update(7);
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::failed);
  EXPECT_EQ(manager.outcome.end.abort(), AbortCode::length_too_low);
  EXPECT_EQ(manager.outcome.index, 0);
}

TEST(ConfigurationManager, WhereNothingIsKnownNothingIsDone) {
  Manager manager;
  manager.update(8);
  EXPECT_EQ(manager.outcome.kind, Kind::nothing_known) << "an empty concise DCF";
  manager.update(9);
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::nothing_known) << "no concise DCF";
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{8, 9}));
}

TEST(ConfigurationManager, AnExpectedDateWithoutAConciseDcfCannotBeReached) {
  Manager manager;
  manager.expect_date(9, 0x3E8, 0x1770);
  manager.update(9);
  manager.sent.clear();
  manager.receive("589#43 20 10 01 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::failed);
  EXPECT_EQ(manager.outcome.end.abort(), AbortCode::no_data);
}

TEST(ConfigurationManager, ConfiguresAsManyAtATimeAsItHasWorkers) {
  Manager manager;
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{20}}) {
    manager.expect_date(slave, 1, 1);
    EXPECT_EQ(manager.sut.update(slave), AbortCode::none);
  }
  manager.settle();
  manager.expect({"605#40 20 10 01 00 00 00 00", "606#40 20 10 01 00 00 00 00"});
  EXPECT_TRUE(manager.sut.busy(20));
  manager.run_for(500ms);
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{5, 6}));
  manager.expect({"605#80 20 10 01 00 00 04 05", "606#80 20 10 01 00 00 04 05",
                  "614#40 20 10 01 00 00 00 00"});
  manager.run_for(500ms);
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{5, 6, 20}));
}

TEST(ConfigurationManager, RefusesItselfWhatIsNoNodeAndWhatItIsAtAlready) {
  Manager manager;
  EXPECT_EQ(manager.sut.update(0), AbortCode::value_range);
  EXPECT_EQ(manager.sut.update(1), AbortCode::value_range);
  EXPECT_EQ(manager.sut.update(128), AbortCode::value_range);
  EXPECT_EQ(manager.sut.update(255), AbortCode::value_range);
  EXPECT_EQ(manager.sut.update(5), AbortCode::none);
  EXPECT_EQ(manager.sut.update(5), AbortCode::device_state);
}

TEST(ConfigurationManager, MayBeAskedAgainFromItsAnswer) {
  Manager manager;
  manager.again = true;
  manager.update(6);
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.expect({"606#2F 00 20 03 08 00 00 00", "606#2F 00 20 03 08 00 00 00"});
}

TEST(ConfigurationManager, AResetForgetsAllSlaves) {
  Manager manager;
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{20}}) {
    manager.expect_date(slave, 1, 1);
    EXPECT_EQ(manager.sut.update(slave), AbortCode::none);
  }
  manager.settle();
  manager.receive("000#82 01");
  manager.run_for(10s);
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{});
  EXPECT_FALSE(manager.sut.busy(5));
  EXPECT_FALSE(manager.sut.busy(20));
  manager.update(6);
  EXPECT_TRUE(manager.sut.busy(6));
}

TEST(ConfigurationManager, InNmtStateStoppedAllSlavesFail) {
  Manager manager;
  for (const NodeId slave : {NodeId{5}, NodeId{6}, NodeId{20}}) {
    manager.expect_date(slave, 1, 1);
    EXPECT_EQ(manager.sut.update(slave), AbortCode::none);
  }
  manager.settle();
  manager.receive("000#02 01");
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{5, 6, 20}));
  EXPECT_EQ(manager.outcome.end, SdoEnd(AbortCode::device_state)) << "20 could not begin";
}

// 1F25h: configure request

TEST(ConfigurationRequest, ConfConfiguresASlaveWhateverItsDate) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.receive("601#23 25 1F 06 63 6F 6E 66");
  manager.expect({"581#60 25 1F 06 00 00 00 00", "606#2F 00 20 03 08 00 00 00"});
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.receive("586#60 20 10 01 00 00 00 00");
  manager.receive("586#60 20 10 02 00 00 00 00");
  manager.expect({"606#23 20 10 01 E8 03 00 00", "606#23 20 10 02 70 17 00 00"});
  EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
}

TEST(ConfigurationRequest, ASlaveWithout1020hIsConfiguredAndNotDated) {
  Manager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.receive("601#23 25 1F 06 63 6F 6E 66");
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.sent.clear();
  manager.receive("586#80 20 10 01 00 00 02 06");
  manager.expect({});
  EXPECT_EQ(manager.outcome.kind, Kind::downloaded);
}

TEST(ConfigurationRequest, SubIndex128ConfiguresAllThatHaveAConfiguration) {
  Manager manager;
  manager.receive("601#23 25 1F 80 63 6F 6E 66");
  manager.expect({"581#60 25 1F 80 00 00 00 00", "605#2B 17 10 00 F4 01 00 00",
                  "606#2F 00 20 03 08 00 00 00"});
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.receive("585#60 00 20 03 00 00 00 00");
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{6, 7, 8, 5}));
}

TEST(ConfigurationRequest, AnotherSignatureIsRefused) {
  Manager manager;
  manager.receive("601#23 25 1F 06 73 61 76 65");
  manager.expect({"581#80 25 1F 06 20 00 00 08"});
  manager.receive("601#23 25 1F 80 00 00 00 00");
  manager.expect({"581#80 25 1F 80 20 00 00 08"});
}

TEST(ConfigurationRequest, ASlaveWithoutAConciseDcfIsRefused) {
  Manager manager;
  manager.receive("601#23 25 1F 09 63 6F 6E 66");
  manager.expect({"581#80 25 1F 09 24 00 00 08"});
  manager.receive("601#23 25 1F 01 63 6F 6E 66");
  manager.expect({"581#80 25 1F 01 30 00 09 06"});
}

TEST(ConfigurationRequest, ASlaveThatIsConfiguredJustNowIsRefused) {
  Manager manager;
  manager.update(5);
  manager.sent.clear();
  manager.receive("601#23 25 1F 05 63 6F 6E 66");
  manager.expect({"581#80 25 1F 05 22 00 00 08"});
}

TEST(ConfigurationRequest, CannotBeRead) {
  Manager manager;
  manager.receive("601#40 25 1F 05 00 00 00 00");
  manager.expect({"581#80 25 1F 05 01 00 01 06"});
}

// In the boot-up procedure of an NMT master (CiA 302-2)

struct BootingManager : Manager {
  BootingManager() { sut.serve(hooks); }
  void boot_slave(NodeId slave, SdoClient& slave_client) {
    hooks.update_configuration({slave, &slave_client, callback<&BootingManager::booted>(*this)});
    settle();
  }
  void booted(BootOutcome result) { outcomes.push_back(result); }

  BootHooks hooks;
  SdoClient clients[3] = {SdoClient(node), SdoClient(node), SdoClient(node)};
  std::vector<BootOutcome> outcomes;
};

TEST(ConfigurationAtBoot, ASlaveIsConfiguredOnTheClientOfItsTask) {
  BootingManager manager;
  manager.expect_date(6, 0x3E8, 0x1770);
  manager.boot_slave(6, manager.clients[0]);
  EXPECT_TRUE(manager.clients[0].busy());
  manager.receive("586#43 20 10 01 00 00 00 00");
  EXPECT_TRUE(manager.clients[0].busy());
  manager.receive("586#60 00 20 03 00 00 00 00");
  EXPECT_TRUE(manager.clients[0].busy());
  manager.receive("586#60 20 10 01 00 00 00 00");
  manager.receive("586#60 20 10 02 00 00 00 00");
  manager.expect({"606#40 20 10 01 00 00 00 00", "606#2F 00 20 03 08 00 00 00",
                  "606#23 20 10 01 E8 03 00 00", "606#23 20 10 02 70 17 00 00"});
  EXPECT_EQ(manager.outcomes, std::vector<BootOutcome>{BootOutcome{}});
  EXPECT_FALSE(manager.clients[0].busy());
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{6});
}

TEST(ConfigurationAtBoot, ASlaveThatRefusesHasErrorJAndTheAbortCode) {
  BootingManager manager;
  manager.boot_slave(6, manager.clients[0]);
  manager.receive("586#80 00 20 03 30 00 09 06");
  EXPECT_EQ(manager.outcomes,
            (std::vector<BootOutcome>{
                {BootError::configuration, SdoEnd::by_server(AbortCode::value_range)}}));
}

TEST(ConfigurationAtBoot, ASlaveOfWhichNothingIsKnownGoesOn) {
  BootingManager manager;
  manager.boot_slave(9, manager.clients[0]);
  manager.expect({});
  EXPECT_EQ(manager.outcomes, std::vector<BootOutcome>{BootOutcome{}});
}

TEST(ConfigurationAtBoot, SlavesThatBootWaitForAWorkerAndComeBeforeOthers) {
  BootingManager manager;
  manager.update(5);
  manager.expect_date(20, 1, 1);
  manager.expect_date(21, 1, 1);
  manager.expect_date(22, 1, 1);
  EXPECT_EQ(manager.sut.update(22), AbortCode::none);
  manager.boot_slave(20, manager.clients[0]);
  manager.boot_slave(21, manager.clients[1]);
  manager.expect({"605#2B 17 10 00 F4 01 00 00", "614#40 20 10 01 00 00 00 00"});
  manager.run_for(500ms);
  EXPECT_EQ(manager.slaves, (std::vector<NodeId>{5, 20}));
  manager.expect({"605#80 17 10 00 00 00 04 05", "614#80 20 10 01 00 00 04 05",
                  "615#40 20 10 01 00 00 00 00", "616#40 20 10 01 00 00 00 00"});
}

TEST(ConfigurationAtBoot, MoreSlavesThanWorkersMayWaitAndNoMoreThanAsManyAgain) {
  BootingManager manager;
  for (const NodeId slave : {NodeId{20}, NodeId{21}, NodeId{22}}) {
    manager.expect_date(slave, 1, 1);
    manager.hooks.update_configuration(
        {slave, &manager.clients[slave - 20], callback<&BootingManager::booted>(manager)});
  }
  EXPECT_EQ(manager.outcomes,
            (std::vector<BootOutcome>{{BootError::configuration, AbortCode::out_of_memory}}));
}

TEST(ConfigurationAtBoot, AnAbandonedSlaveNoLongerWaitsForAWorker) {
  BootingManager manager;
  manager.expect_date(9, 0x3E8, 0x1770);
  manager.boot_slave(5, manager.clients[0]);
  manager.boot_slave(6, manager.clients[1]);
  manager.boot_slave(9, manager.clients[2]);
  manager.sent.clear();
  manager.hooks.abandon(9);
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.expect({});
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{6});
  EXPECT_FALSE(manager.sut.busy(9));
}

TEST(ConfigurationAtBoot, TakesThePlaceOfWhatIsUnderWayForTheSlave) {
  BootingManager manager;
  manager.update(5);
  manager.expect({"605#2B 17 10 00 F4 01 00 00"});
  manager.boot_slave(5, manager.clients[0]);
  manager.expect({"605#80 17 10 00 00 00 00 08", "605#2B 17 10 00 F4 01 00 00"});
  manager.receive("585#60 17 10 00 00 00 00 00");
  manager.receive("585#60 00 20 03 00 00 00 00");
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{5}) << "it is told once";
  EXPECT_EQ(manager.outcomes, std::vector<BootOutcome>{BootOutcome{}});
}

TEST(ConfigurationAtBoot, AnAbandonedSlaveIsForgotten) {
  BootingManager manager;
  manager.boot_slave(6, manager.clients[0]);
  manager.boot_slave(5, manager.clients[1]);
  manager.sent.clear();
  manager.clients[0].cancel();
  manager.hooks.abandon(6);
  manager.expect({"606#80 00 20 03 00 00 00 08"});
  manager.receive("586#60 00 20 03 00 00 00 00");
  manager.run_for(10s);
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{5}) << "the other one went on";
  EXPECT_EQ(manager.outcomes.size(), 1u);
  EXPECT_FALSE(manager.sut.busy(6));
  manager.sent.clear();
  manager.boot_slave(6, manager.clients[0]);
  manager.expect({"606#2F 00 20 03 08 00 00 00"});
}

TEST(ConfigurationAtBoot, AnAbandonedTaskDoesNotHearOfTheNextConfiguration) {
  BootingManager manager;
  manager.boot_slave(6, manager.clients[0]);
  manager.clients[0].cancel();
  manager.hooks.abandon(6);
  manager.update(6);
  manager.receive("586#60 00 20 03 00 00 00 00");
  EXPECT_EQ(manager.slaves, std::vector<NodeId>{6});
  EXPECT_EQ(manager.outcomes, std::vector<BootOutcome>{});
}

struct AbandoningManager : BootingManager {
  AbandoningManager() {
    sut.on_done(ConfigurationManager::Done::to<&AbandoningManager::abandon>(*this));
  }
  void abandon(NodeId slave, const ConfigurationOutcome&) { hooks.abandon(slave); }
};

TEST(ConfigurationAtBoot, ASlaveThatIsAbandonedByWhoIsToldOfItsEndIsNotBootedOn) {
  AbandoningManager manager;
  manager.boot_slave(9, manager.clients[0]);
  manager.run_for(10s);
  EXPECT_EQ(manager.outcomes.size(), 0u);
  EXPECT_FALSE(manager.sut.busy(9));
  manager.boot_slave(6, manager.clients[1]);
  manager.expect({"606#2F 00 20 03 08 00 00 00"});
}

struct OrderedManager : BootingManager {
  OrderedManager() { sut.on_done(ConfigurationManager::Done::to<&OrderedManager::told>(*this)); }
  void told(NodeId slave, const ConfigurationOutcome&) {
    outcomes_before.push_back(outcomes.size());
    may_be_updated = sut.update(slave) == AbortCode::none;
  }
  std::vector<std::size_t> outcomes_before;
  bool may_be_updated = false;
};

TEST(ConfigurationAtBoot, WhatBecameOfAConfigurationIsToldBeforeTheBootUpGoesOn) {
  OrderedManager manager;
  manager.boot_slave(6, manager.clients[0]);
  manager.receive("586#60 00 20 03 00 00 00 00");
  EXPECT_EQ(manager.outcomes_before, std::vector<std::size_t>{0}) << "none was booted on before";
  EXPECT_EQ(manager.outcomes, std::vector<BootOutcome>{BootOutcome{}});
  EXPECT_TRUE(manager.may_be_updated) << "it is not busy any more";
}

TEST(FixedConfigurations, CanBeReadAndNotWritten) {
  Manager manager;
  manager.receive("601#40 22 1F 06 00 00 00 00");
  manager.expect({"581#41 22 1F 06 0C 00 00 00"});
  manager.receive("601#60 00 00 00 00 00 00 00");
  manager.expect({"581#00 01 00 00 00 00 20 03"});
  manager.receive("601#70 00 00 00 00 00 00 00");
  manager.expect({"581#15 01 00 00 00 08 00 00"});
  manager.receive("601#40 22 1F 09 00 00 00 00");
  manager.expect({"581#80 22 1F 09 24 00 00 08"});
  manager.receive("601#21 22 1F 06 0C 00 00 00");
  manager.expect({"581#80 22 1F 06 00 00 01 06"});
}

}  // namespace
}  // namespace canvoy::configuration_manager_test
