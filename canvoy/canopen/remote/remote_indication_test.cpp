// The message of a client before a transfer with a device behind a node, byte for byte
// (remote_access.hpp).
#include "canvoy/canopen/remote/remote_indication.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::remote_indication_test {
namespace {

/// Node 5 selects node 7 of network 2 at node 10.
struct RemoteIndications : testing::Test {
  RemoteIndications() { client.boot(); }

  AbortCode begin(NodeId module = 10, NodeId device = 7) {
    return indication.begin(module, device,
                            RemoteIndication::Done::to<&RemoteIndications::done>(*this), 100ms);
  }
  void done(SdoEnd outcome) { outcomes.push_back(outcome); }
  void expect_outcomes(const std::vector<SdoEnd>& expected) {
    EXPECT_EQ(outcomes, expected);
    outcomes.clear();
  }

  WireNode client{sdo_objects(), 5};
  RemoteIndication indication{client.node, {.network = 2}};
  std::vector<SdoEnd> outcomes;
};

TEST_F(RemoteIndications, AreConfirmedByTheSameBytes) {
  EXPECT_EQ(begin(), AbortCode::none);
  client.expect({"60A#E0 02 00 07 00 00 00 00"});
  EXPECT_TRUE(indication.busy());
  client.receive("58A#E0 02 00 08 00 00 00 00");  // of another device
  client.receive("58A#E0 02 00 07");
  client.receive("58B#E0 02 00 07 00 00 00 00");
  expect_outcomes({});
  client.receive("58A#E0 02 00 07 00 00 00 00");
  expect_outcomes({SdoEnd()});
  EXPECT_FALSE(indication.busy());
  client.receive("58A#E0 02 00 07 00 00 00 00");
  client.run_for(1s);
  expect_outcomes({});
}

TEST_F(RemoteIndications, SayWhyTheyAreRefused) {
  begin();
  client.receive("58A#80 02 00 07 01 00 04 05");
  expect_outcomes({SdoEnd::by_server(AbortCode::command_specifier)});
  EXPECT_FALSE(indication.busy());
}

TEST_F(RemoteIndications, GiveUpWhereNobodyAnswers) {
  begin();
  client.run_for(99ms);
  expect_outcomes({});
  client.run_for(1ms);
  expect_outcomes({SdoEnd::no_answer()});
  client.receive("58A#E0 02 00 07 00 00 00 00");
  expect_outcomes({});
  EXPECT_EQ(begin(), AbortCode::none);
}

TEST_F(RemoteIndications, AreNotBegunWhereTheyCannotBe) {
  EXPECT_EQ(begin(0), AbortCode::no_sdo_connection);
  EXPECT_EQ(begin(10, 128), AbortCode::no_sdo_connection);
  client.expect({});
  EXPECT_EQ(begin(), AbortCode::none);
  EXPECT_EQ(begin(), AbortCode::device_state) << "one is under way";
  client.expect({"60A#E0 02 00 07 00 00 00 00"});
}

TEST_F(RemoteIndications, AreNotBegunWhereTheirMessageWouldBeLost) {
  client.fill();
  EXPECT_EQ(begin(), AbortCode::device_state);
  EXPECT_FALSE(indication.busy());
  client.run_for(1s);
  expect_outcomes({});
}

TEST_F(RemoteIndications, MayBeCancelledWhereNoneIsUnderWay) {
  indication.cancel();
  EXPECT_FALSE(indication.busy());
  EXPECT_EQ(begin(), AbortCode::none);
}

TEST_F(RemoteIndications, TellNobodyWhenTheyAreCancelled) {
  begin();
  indication.cancel();
  EXPECT_FALSE(indication.busy());
  client.receive("58A#E0 02 00 07 00 00 00 00");
  client.run_for(1s);
  expect_outcomes({});
}

}  // namespace
}  // namespace canvoy::remote_indication_test
