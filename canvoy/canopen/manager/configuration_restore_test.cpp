// Defaults that are restored before a slave is configured in the boot-up procedure (CiA 302-2: bit
// 7 of 1F81h, 1F8Ah; CiA 301: 1011h).
#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/testing/concise_dcf_bytes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::configuration_restore_test {
namespace {

constexpr EntryRow count_row{.access = Access::const_, .initial = 127};
constexpr EntryRow slave_row(DataType type) {
  return {.sub_first = 1, .sub_last = 127, .type = type, .access = Access::rw};
}
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1F22, .entry_count = 2},
                              {.index = 0x1F26, .count = 2, .entry_count = 2},
                              {.index = 0x1F81, .entry_count = 2},
                              {.index = 0x1F8A, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {count_row, slave_row(DataType::domain), count_row, slave_row(DataType::unsigned32),
         count_row, slave_row(DataType::unsigned32), count_row, slave_row(DataType::unsigned8)}));

constexpr std::uint32_t restored = 0x85;
constexpr std::uint32_t not_restored = 0x05;

const std::vector<std::uint8_t> for_5 = concise_dcf({{0x2000, 3, {0x07}}});
const FixedConfigurations::Item items[] = {{.slave = 5, .concise_dcf = for_5}};

constexpr const char* load_all = "605#23 11 10 01 6C 6F 61 64";
constexpr const char* configure = "605#2F 00 20 03 07 00 00 00";

/// Boots slave 5, and plays the NMT master to its manager.
struct RestoringManager : WireNode {
  RestoringManager(std::uint32_t assignment, std::uint8_t sub) : WireNode(layout.tables(), 1) {
    manager.serve(hooks);
    boot();
    node.dictionary().set_number(0x1F81, 5, assignment);
    node.dictionary().set_number(0x1F8A, 5, sub);
  }
  void begin() {
    hooks.update_configuration(
        {5, &client, callback<&RestoringManager::booted>(*this),
         decltype(BootTask::restart)::to<&RestoringManager::restart>(*this)});
    settle();
  }
  void booted(BootOutcome outcome) { outcomes.push_back(outcome); }
  void restart(NmtCommand command, Callback<void(AbortCode)> over) {
    commands.push_back(command);
    restarted = over;
  }
  void end_restart(AbortCode how) {
    restarted(how);
    settle();
  }
  void expect_success() {
    receive("585#60 00 20 03 00 00 00 00");
    EXPECT_EQ(outcomes, std::vector<BootOutcome>{{}});
  }
  void expect_failure(SdoEnd end) {
    expect({});
    EXPECT_EQ(outcomes, (std::vector<BootOutcome>{{BootError::configuration, end}}));
  }

  FixedConfigurations configurations{node, items};
  ConfigurationManager::Worker workers[1] = {ConfigurationManager::Worker(node)};
  ConfigurationManager manager{node, workers, 500ms};
  SdoClient client{node};
  BootHooks hooks;
  std::vector<BootOutcome> outcomes;
  std::vector<NmtCommand> commands;
  Callback<void(AbortCode)> restarted;
};

TEST(RestoreConfiguration, WritesLoadResetsTheSlaveAndConfiguresIt) {
  RestoringManager sut(restored, 1);
  sut.begin();
  sut.expect({load_all});
  EXPECT_TRUE(sut.commands.empty());
  sut.receive("585#60 11 10 01 00 00 00 00");
  sut.expect({});
  EXPECT_EQ(sut.commands, std::vector<NmtCommand>{NmtCommand::reset_node});
  sut.end_restart(AbortCode::none);
  sut.expect({configure});
  sut.expect_success();
}

TEST(RestoreConfiguration, OfCommunicationParametersResetsCommunicationAlone) {
  RestoringManager sut(restored, 2);
  sut.begin();
  sut.expect({"605#23 11 10 02 6C 6F 61 64"});
  sut.receive("585#60 11 10 02 00 00 00 00");
  EXPECT_EQ(sut.commands, std::vector<NmtCommand>{NmtCommand::reset_communication});
}

TEST(RestoreConfiguration, OfOtherGroupsResetsTheNode) {
  for (const std::uint8_t sub : std::to_array<std::uint8_t>({3, 4, 127, 254})) {
    RestoringManager sut(restored, sub);
    sut.begin();
    Frame answer = wire_frame("585#60 11 10 00 00 00 00 00");
    answer.data[3] = sub;
    sut.node.receive(answer, sut.now);
    EXPECT_EQ(sut.commands, std::vector<NmtCommand>{NmtCommand::reset_node}) << unsigned{sub};
  }
}

TEST(RestoreConfiguration, NeedsTheBitAndASubIndex) {
  const std::pair<std::uint32_t, std::uint8_t> without[] = {{not_restored, 1}, {restored, 0}};
  for (const auto& [assignment, sub] : without) {
    RestoringManager sut(assignment, sub);
    sut.begin();
    sut.expect({configure});
    sut.expect_success();
    EXPECT_TRUE(sut.commands.empty());
  }
}

TEST(RestoreConfiguration, LeavesASlaveAloneThatHasTheExpectedDateAndTime) {
  RestoringManager sut(restored, 1);
  sut.node.dictionary().set_number(0x1F26, 5, 0x3E8);
  sut.begin();
  sut.receive("585#43 20 10 01 E8 03 00 00");
  sut.receive("585#43 20 10 02 00 00 00 00");
  sut.expect({"605#40 20 10 01 00 00 00 00", "605#40 20 10 02 00 00 00 00"});
  EXPECT_EQ(sut.outcomes, std::vector<BootOutcome>{{}});
}

TEST(RestoreConfiguration, ComesBeforeTheDownloadToASlaveWithAnotherDate) {
  RestoringManager sut(restored, 1);
  sut.node.dictionary().set_number(0x1F26, 5, 0x3E8);
  sut.begin();
  sut.receive("585#43 20 10 01 E7 03 00 00");
  sut.expect({"605#40 20 10 01 00 00 00 00", load_all});
}

TEST(RestoreConfiguration, ThatIsRefusedIsErrorJAndNothingIsReset) {
  RestoringManager sut(restored, 1);
  sut.begin();
  sut.expect({load_all});
  sut.receive("585#80 11 10 01 00 00 02 06");
  sut.expect_failure(SdoEnd::by_server(AbortCode::no_object));
  EXPECT_TRUE(sut.commands.empty());
}

TEST(RestoreConfiguration, WithoutABootUpMessageIsASilentSlave) {
  RestoringManager sut(restored, 1);
  sut.begin();
  sut.expect({load_all});
  sut.receive("585#60 11 10 01 00 00 00 00");
  sut.end_restart(AbortCode::time_out);
  sut.expect_failure(SdoEnd::no_answer());
}

TEST(RestoreConfiguration, IsAPartOfTheBootUpAlone) {
  RestoringManager sut(restored, 1);
  EXPECT_EQ(sut.manager.update(5), AbortCode::none);
  sut.settle();
  sut.expect({configure});
}

}  // namespace
}  // namespace canvoy::configuration_restore_test
