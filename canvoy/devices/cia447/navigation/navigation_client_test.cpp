// A client of the navigation system at the wire (CiA 447-3, 4.2.11): it is node 5, and the system
// is node 7, with requests on 346h and answers on 2C6h (facts 2.2).
#include "canvoy/devices/cia447/navigation/navigation_client.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"

namespace canvoy::cia447::navigation_client_test {
namespace {

constexpr VirtualDeviceInfo nothing_provided = {.name = "application"};

struct NoHardware {};
struct ChangedHardware {
  Callback<void()> changed = {};
};
struct ClientOfNavigation {
  ClientOfNavigation(CarNetwork& network, const ChangedHardware& hardware, const NoHardware&)
      : navigation(network, {.navigation = 7, .changed = hardware.changed}) {}
  NavigationClient navigation;
};
struct NavigationClientKind : CarKind<ClientOfNavigation, ChangedHardware, NoHardware> {
  static constexpr DeviceInfo info = {.name = "client", .title = "client"};
  static constexpr const VirtualDeviceInfo& provides = nothing_provided;
};

class ClientOfSystem : public testing::Test {
 protected:
  ClientOfSystem() {
    cable.run_for(0s);
    cable.clear();
  }
  NavigationClient& navigation() { return client_->navigation; }
  std::string asked() {
    cable.run_for(0s);
    return cable.last(0x346);
  }
  void answer(const std::string& answer) {
    cable.clear();
    cable.send("2C6#" + answer);
    cable.run_for(0s);
  }
  /// The system takes the request for a position, and answers Mun, A1, and the distance.
  void answer_rest(const std::string& distance) {
    EXPECT_EQ(asked(), "346#2F C4 60 00 FE 00 00 00");
    answer("60 C4 60 00 00 00 00 00");
    EXPECT_EQ(asked(), "346#40 C5 60 01 00 00 00 00");
    answer("47 C5 60 01 4D 75 6E 00");
    EXPECT_EQ(asked(), "346#40 C5 60 02 00 00 00 00");
    answer("4B C5 60 02 41 31 00 00");
    EXPECT_EQ(asked(), "346#40 C0 60 00 00 00 00 00");
    answer("4B C0 60 00 " + distance + " 00 00");
  }
  void begin_round() {
    cable.clear();
    cable.run_for(1s);
  }
  /// 48.1 degrees north, 11.0 east: 1CAB 7A40h and 068E 7780h; the place is B2.
  void answer_destination() {
    answer("60 C3 60 01 00 00 00 00");
    EXPECT_EQ(asked(), "346#23 C3 60 02 80 77 8E 06");
    answer("60 C3 60 02 00 00 00 00");
    EXPECT_EQ(asked(), "346#2F C3 60 03 01 00 00 00") << "at once";
    answer("60 C3 60 03 00 00 00 00");
    EXPECT_EQ(asked(), "346#23 C1 60 01 40 7A AB 1C");
    answer("60 C1 60 01 00 00 00 00");
    EXPECT_EQ(asked(), "346#23 C1 60 02 80 77 8E 06");
    answer("60 C1 60 02 00 00 00 00");
    EXPECT_EQ(asked(), "346#40 C2 60 02 00 00 00 00");
    answer("4B C2 60 02 42 32 00 00");
  }
  void changed() { ++changes; }
  ChangedHardware hardware() { return {.changed = callback<&ClientOfSystem::changed>(*this)}; }

  unsigned changes = 0;
  ClientOfNavigation* client_ = nullptr;
  CarBench bench{only_unit<NavigationClientKind>, [this](Environment& environment) {
                   environment.provide(callback<&ClientOfSystem::hardware>(*this));
                   environment.watch(client_);
                 }};
  Cable& cable = bench.cable;
};

TEST_F(ClientOfSystem, EachSecondItAsksWhereTheCarIs) {
  begin_round();
  answer_rest("FD FF");
  EXPECT_EQ(navigation().city(), "Mun");
  EXPECT_EQ(navigation().street(), "A1");
  EXPECT_EQ(navigation().metres(), std::nullopt) << "there is no destination";
  EXPECT_EQ(changes, 1u);
  cable.run_for(999ms);
  EXPECT_EQ(cable.last(0x346), "");
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x346), "346#2F C4 60 00 FE 00 00 00");
}

TEST_F(ClientOfSystem, ItHasTheCarLedToADestinationAndKnowsWhatIsThere) {
  navigation().guide({48.1, 11.0});
  begin_round();
  EXPECT_EQ(asked(), "346#23 C3 60 01 40 7A AB 1C");
  answer_destination();
  answer_rest("70 00");
  EXPECT_EQ(navigation().destination_street(), "B2");
  ASSERT_TRUE(navigation().metres());
  EXPECT_DOUBLE_EQ(*navigation().metres(), 11'200) << "0070h is 11.2 km";
  begin_round();
  answer_rest("FE FF");
  EXPECT_EQ(navigation().metres(), std::nullopt) << "a failure";
  EXPECT_EQ(navigation().destination_street(), "B2");
  navigation().forget_destination();
  EXPECT_EQ(navigation().destination_street(), "");
}

TEST_F(ClientOfSystem, ADestinationThatIsRefusedIsToldAgain) {
  navigation().guide({48.1, 11.0});
  begin_round();
  answer("80 C3 60 01 22 00 00 08");
  answer_rest("FD FF");
  EXPECT_EQ(navigation().street(), "A1");
  begin_round();
  EXPECT_EQ(asked(), "346#23 C3 60 01 40 7A AB 1C");
}

TEST_F(ClientOfSystem, OfOneThatDoesNotAnswerNothingIsKnown) {
  navigation().guide({48.1, 11.0});
  begin_round();
  answer_destination();
  answer_rest("70 00");
  begin_round();
  cable.run_for(499ms);
  EXPECT_EQ(navigation().street(), "A1");
  cable.run_for(1ms);
  EXPECT_EQ(navigation().street(), "");
  EXPECT_EQ(navigation().destination_street(), "");
  EXPECT_EQ(navigation().metres(), std::nullopt);
  EXPECT_EQ(changes, 2u);
  cable.run_for(500ms);
  EXPECT_EQ(cable.last(0x346), "346#23 C3 60 01 40 7A AB 1C") << "it may have lost its power";
}

TEST_F(ClientOfSystem, OneThatBootsIsToldTheDestinationAnew) {
  navigation().guide({48.1, 11.0});
  begin_round();
  answer_destination();
  answer_rest("70 00");
  cable.send("707#00");
  cable.run_for(0s);
  EXPECT_EQ(navigation().street(), "");
  EXPECT_EQ(navigation().metres(), std::nullopt);
  begin_round();
  EXPECT_EQ(asked(), "346#23 C3 60 01 40 7A AB 1C");
}

/// A destination that is set while another one is being sent is not mixed with it.
TEST_F(ClientOfSystem, ADestinationThatChangesOnTheWayIsToldAfterwards) {
  navigation().guide({48.1, 11.0});
  begin_round();
  navigation().guide({48.0, 12.0});
  answer_destination();
  answer_rest("70 00");
  EXPECT_EQ(navigation().destination_street(), "") << "B2 is not there";
  begin_round();
  EXPECT_EQ(asked(), "346#23 C3 60 01 00 38 9C 1C");
}

/// 33.5 south and 70.25 west: 499C 9AC0h and 9529 1EA0h (errata Z36).
TEST_F(ClientOfSystem, SouthAndWestHaveTheirCodes) {
  navigation().guide({-33.5, -70.25});
  begin_round();
  EXPECT_EQ(asked(), "346#23 C3 60 01 C0 9A 9C 49");
  answer("60 C3 60 01 00 00 00 00");
  EXPECT_EQ(asked(), "346#23 C3 60 02 A0 1E 29 95");
}

}  // namespace
}  // namespace canvoy::cia447::navigation_client_test
