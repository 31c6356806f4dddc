#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_rtr_test {
namespace {

using enum AbortCode;

TEST(Tpdo, OfType252IsSampledAtSyncAndSentOnRequest) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 252, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.receive("080#");
  node.set(0x2010, 1, 2);
  node.expect({});
  node.receive("185#R2");
  node.expect({"185#01 00"});
  node.receive("080#");
  node.receive("185#R2");
  node.expect({"185#02 00"});
}

TEST(Tpdo, OfType252IsSampledOnRequestBeforeTheFirstSyncInOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 252, {0x2010'01'10});
  for (unsigned i = 1; i <= 2; ++i) {
    node.operate();
    node.set(0x2010, 1, i);
    node.receive("185#R2");
    node.expect({"185#0" + std::to_string(i) + " 00"});
    node.receive("000#80 00");
  }
}

TEST(Tpdo, OfType253IsSentOnRequestWithTheValuesOfNow) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 253, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.receive("080#");
  node.expect({});
  node.receive("185#R2");
  node.expect({"185#01 00"});
  node.receive("185#R0");
  node.expect({"185#01 00"});
}

TEST(Tpdo, OfTypes254And255IsSentOnRequestToo) {
  for (const unsigned type : {254U, 255U}) {
    PdoNode node;
    ASSERT_EQ(node.write(0x1800, 3, 100), none);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.receive("185#R2");
    node.expect({"@0 185#00 00"});
    node.receive("185#R2");
    node.run_until(Time(1s));
    node.expect({"@10000 185#00 00"});
  }
}

TEST(Tpdo, OfTypes0To240IsSentOnRequestWithTheValuesOfTheLastSync) {
  for (unsigned type = 0; type <= 240; ++type) {
    PdoNode node;
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.set(0x2010, 1, 1);
    for (unsigned sync = 0; sync < std::max(type, 1U); ++sync) node.receive("080#");
    node.set(0x2010, 1, 2);
    node.expect({"185#01 00"});
    node.receive("185#R2");
    node.expect({"185#01 00"});
  }
}

TEST(Tpdo, OfEveryTypeIsSilentOnRequestWhereBit30Forbids) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 252) continue;
    PdoNode node;
    node.map_tpdo(1, 0x4000'0185, type, {0x2010'01'10});
    node.operate();
    node.receive("185#R2");
    node.expect({});
  }
}

TEST(Tpdo, ValidLetsRequestsBeForbiddenAndAllowedByBit30) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.receive("185#R2");
  node.expect({"185#00 00"});
  ASSERT_EQ(node.write(0x1800, 1, 0x4000'0185), none);
  EXPECT_EQ(node.number(0x1800, 1), 0x4000'0185U);
  node.receive("185#R2");
  node.expect({});
  node.set(0x2010, 1, 1);
  node.expect({"185#01 00"});
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.expect({});
  node.receive("185#R2");
  node.expect({"185#01 00"});
}

TEST(Tpdo, IsSilentOnRequestOutsideOfOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 253, {0x2010'01'10});
  node.receive("185#R2");
  node.expect({});
  node.operate();
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.receive("185#R2");
  node.expect({});
}

}  // namespace
}  // namespace canvoy::tpdo_rtr_test
