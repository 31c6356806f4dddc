#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_event_test {
namespace {

using enum AbortCode;

constexpr Tpdos::AtStart send_at_start = Tpdos::AtStart::send;

TEST(Tpdo, OfTypes254And255IsSentWhenAValueChanges) {
  for (const unsigned type : {254U, 255U}) {
    PdoNode node;
    node.map_tpdo(1, 0x185, type, {0x2010'01'10, 0x2000'03'08});
    node.operate();
    node.expect({});
    node.run_until(Time(5ms));
    node.set(0x2010, 1, 0x1234);
    node.expect({"@5000 185#34 12 00"});
    node.set(0x2010, 1, 0x1234);
    node.set(0x2010, 2, 0x9999);
    node.set(0x2000, 4, 1);
    node.expect({});
    ASSERT_EQ(node.write(0x2000, 3, 7), none);
    node.expect({"@5000 185#34 12 07"});
    node.receive("080#");
    node.expect({});
  }
}

TEST(Tpdo, IsSentWhenTheApplicationWritesAndTheNodeIsCalled) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.node.dictionary().set_number(0x2010, 1, 5);
  EXPECT_LE(node.node.deadline(), node.now) << "the node wants to be called";
  node.node.advance(node.now);
  node.expect({"185#05 00"});
}

TEST(Tpdo, ChangesOfSeveralValuesAreOneFrame) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10, 0x2010'02'10});
  node.operate();
  node.node.dictionary().set_number(0x2010, 1, 1);
  node.node.dictionary().set_number(0x2010, 2, 2);
  node.settle();
  node.expect({"185#01 00 02 00"});
}

TEST(Tpdo, OneValueInSeveralIsSentInAll) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.map_tpdo(4, 0x485, 254, {0x2000'02'08, 0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 1);
  node.expect({"185#01", "485#00 01"});
  node.set(0x2000, 2, 2);
  node.expect({"285#02", "485#02 01"});
}

TEST(Tpdo, IsSentInOperationalOnly) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.set(0x2010, 1, 1);
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
  node.operate();
  node.set(0x2010, 1, 2);
  node.expect({"185#02 00"});
  node.receive("000#02 00");
  node.set(0x2010, 1, 3);
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
}

TEST(Tpdo, EventDrivenIsSentOnceWhenTheNodeBecomesOperational) {
  PdoNode node(send_at_start);
  node.set(0x2000, 1, 0x11);
  node.map_tpdo(1, 0x185, 254, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 253, {0x2000'01'08});
  node.map_tpdo(4, 0x485, 0, {0x2000'01'08});
  node.expect({});
  node.operate();
  node.expect({"185#11", "285#11"});
  node.receive("080#");
  node.expect({"485#11"});
  node.operate();
  node.expect({});
  node.receive("000#80 00");
  node.operate();
  node.expect({"185#11", "285#11"});
}

TEST(Tpdo, EventDrivenIsSentOnceWhenItBecomesValidInOperational) {
  PdoNode node(send_at_start);
  node.operate();
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.expect({"185#00"});
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.expect({});
}

TEST(Tpdo, WaitsForAnEventAtStartWhereThatIsAskedFor) {
  PdoNode node;
  node.set(0x2000, 1, 0x11);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 0x11);
  node.set(0x2000, 2, 0x99);
  node.expect({});
  node.set(0x2000, 1, 0x12);
  node.expect({"185#12"});
}

TEST(Tpdo, IsTriggeredByTheApplicationWithoutAChange) {
  PdoNode node;
  node.map_tpdo(2, 0x285, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 253, {0x2000'01'08});
  node.operate();
  EXPECT_TRUE(node.tpdos.trigger(2));
  node.expect({"285#00"});
  EXPECT_FALSE(node.tpdos.trigger(3)) << "its type knows no events";
  EXPECT_FALSE(node.tpdos.trigger(1)) << "not mapped";
  EXPECT_FALSE(node.tpdos.trigger(0));
  EXPECT_FALSE(node.tpdos.trigger(5));
  node.expect({});
}

}  // namespace
}  // namespace canvoy::tpdo_event_test
