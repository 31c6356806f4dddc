// Discrete inputs at the wire (CiA 447-3, 4.2.8). PDO 79 is 398h of node 5.
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::discrete_inputs_unit_test {
namespace {

class DiscreteInputs : public testing::Test {
 protected:
  template <class Handle>
  std::string after(const Handle& handle, Signal signal) {
    unit_->switching().report(handle, signal);
    bench.cable.run_for(0s);
    return bench.cable.last(0x398);
  }

  DiscreteInputsUnit* unit_ = nullptr;
  CarBench bench{only_unit<DiscreteInputsKind>,
                 [this](Environment& environment) { environment.watch(unit_); }};
};

TEST_F(DiscreteInputs, EachIsToldWhenItChanges) {
  EXPECT_EQ(bench.cable.last(0x398), "398#00 FC");
  EXPECT_EQ(after(discrete_inputs_status_taximeter_di, Signal::on), "398#01 FC");
  EXPECT_EQ(after(discrete_inputs_status_ptt_di, Signal::on), "398#05 FC");
  EXPECT_EQ(after(discrete_inputs_status_occupdet_di, Signal::on), "398#15 FC");
  EXPECT_EQ(after(discrete_inputs_status_roof_sign_di, Signal::on), "398#55 FC");
  EXPECT_EQ(after(discrete_inputs_status_beacon_sdi, Signal::on), "398#55 FD");
  EXPECT_EQ(after(discrete_inputs_status_ptt_di, Signal::off), "398#51 FD");
  bench.cable.clear();
  EXPECT_EQ(after(discrete_inputs_status_ptt_di, Signal::off), "") << "nothing new";
}

TEST_F(DiscreteInputs, AWireThatIsNotThereSaysSo) {
  unit_->switching().sense(discrete_inputs_status_beacon_sdi, Sensing::not_available);
  unit_->switching().sense(discrete_inputs_status_roof_sign_di, Sensing::failure);
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x398), "398#80 FF");
}

TEST_F(DiscreteInputs, NobodyWritesThem) {
  EXPECT_EQ(bench.ask("2B 78 60 00 00 00 00 00"), "80 78 60 00 02 00 01 06");
}

}  // namespace
}  // namespace canvoy::cia447::discrete_inputs_unit_test
