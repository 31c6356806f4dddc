// The fire extinguishing system and the emergency fresh-air system test themselves, and then report
// their state (CiA 447-3, 4.2.5 and 4.2.6). PDO 68 is 38Dh of node 5, PDO 69 is 38Eh.
#include <gtest/gtest.h>

#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::self_test_test {
namespace {

/// A state, and its code in the PDO.
template <class State>
struct Told {
  State state;
  const char* code;
};

struct FreshAirSystem : EmergencyFreshAirKind {
  static constexpr auto status = emergency_fresh_air_system_status;
  static constexpr std::uint32_t pdo = 0x38D;
  static constexpr const char* initialization = "38D#F4";
  static constexpr Told<FreshAir> states[] = {{FreshAir::automatic_activated, "38D#F7"},
                                              {FreshAir::standby_limited, "38D#F2"},
                                              {FreshAir::deactivated, "38D#F0"}};
  static constexpr const char* standby = "38D#F1";
  static constexpr const char* failure = "38D#FE";
  static constexpr const char* not_available = "38D#FF";
  static constexpr const char* index = "6C 60 00";
};

struct FireSystem : FireExtinguishingKind {
  static constexpr auto status = fire_extinguishing_system_status;
  static constexpr std::uint32_t pdo = 0x38E;
  static constexpr const char* initialization = "38E#F3";
  static constexpr Told<FireExtinguishing> states[] = {
      {FireExtinguishing::automatic_started, "38E#F4"},
      {FireExtinguishing::standby_limited, "38E#F2"},
      {FireExtinguishing::deactivated, "38E#F0"}};
  static constexpr const char* standby = "38E#F1";
  static constexpr const char* failure = "38E#FE";
  static constexpr const char* not_available = "38E#FF";
  static constexpr const char* index = "69 60 00";
};

template <class System>
class SelfTest : public testing::Test {
 protected:
  std::string now() {
    bench.cable.run_for(0s);
    return bench.cable.last(System::pdo);
  }
  std::string after(auto state) {
    unit_->switching().report(System::status, state);
    return now();
  }

  typename System::Unit* unit_ = nullptr;
  CarBench bench{only_unit<System>, [this](Environment& environment) { environment.watch(unit_); }};
};
using Systems = testing::Types<FreshAirSystem, FireSystem>;
TYPED_TEST_SUITE(SelfTest, Systems);

TYPED_TEST(SelfTest, IsOverAfterThreeSeconds) {
  EXPECT_EQ(this->now(), TypeParam::initialization);
  this->bench.cable.run_for(2999ms);
  EXPECT_EQ(this->now(), TypeParam::initialization);
  this->bench.cable.run_for(1ms);
  EXPECT_EQ(this->now(), TypeParam::standby);
}

TYPED_TEST(SelfTest, IsFollowedByWhatTheSystemDoes) {
  this->bench.cable.run_for(3s);
  for (const auto& [state, code] : TypeParam::states) EXPECT_EQ(this->after(state), code);
}

TYPED_TEST(SelfTest, EndsWithAReport) {
  this->bench.cable.run_for(1s);
  EXPECT_EQ(this->after(TypeParam::states[0].state), TypeParam::states[0].code);
  this->bench.cable.run_for(10s);
  EXPECT_EQ(this->now(), TypeParam::states[0].code);
}

TYPED_TEST(SelfTest, IsFollowedByFailures) {
  this->bench.cable.run_for(3s);
  this->unit_->switching().sense(Sensing::failure);
  EXPECT_EQ(this->now(), TypeParam::failure);
  this->unit_->switching().sense(Sensing::not_available);
  EXPECT_EQ(this->now(), TypeParam::not_available);
}

TYPED_TEST(SelfTest, IsNotRepeatedAfterAnNmtReset) {
  this->bench.cable.run_for(3s);
  this->bench.cable.send("000#81 05");
  this->bench.cable.clear();
  this->bench.cable.send("000#01 05");
  EXPECT_EQ(this->bench.cable.last(TypeParam::pdo), TypeParam::standby);
}

TYPED_TEST(SelfTest, IsNotCommanded) {
  const std::string index = TypeParam::index;
  EXPECT_EQ(this->bench.ask("2F " + index + " 00 00 00 00"), "80 " + index + " 02 00 01 06");
}

}  // namespace
}  // namespace canvoy::cia447::self_test_test
