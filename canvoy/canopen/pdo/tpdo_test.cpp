#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_test {
namespace {

using enum AbortCode;

constexpr Tpdos::AtStart send_at_start = Tpdos::AtStart::send;

TEST(Tpdo, IsSentOnEveryCanIdThatIsNotRestricted) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    ASSERT_EQ(node.write(0x1800, 1, CobId::bit31 | can_id), none) << can_id;
    ASSERT_EQ(node.write(0x1800, 1, can_id), is_free(can_id) ? none : value_range) << can_id;
    node.sent.clear();
    node.set(0x2010, 1, can_id + 1);
    ASSERT_EQ(node.sent.size(), is_free(can_id) ? 1U : 0U) << can_id;
    if (is_free(can_id)) {
      ASSERT_EQ(node.sent[0].frame.id, can_id);
    }
  }
}

TEST(Tpdo, ValidDoesNotChangeItsCanId) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    EXPECT_EQ(node.write(0x1800, 1, can_id), can_id == 0x185 ? none : value_range);
  }
  EXPECT_EQ(node.write(0x1800, 1, 0x4000'0186), value_range);
  EXPECT_EQ(node.write(0x1800, 1, 0x2000'0185), value_range);
  EXPECT_EQ(node.write(0x1800, 1, 0xC000'0186), none) << "but with bit 31 it may";
  EXPECT_EQ(node.write(0x1800, 1, 0x4000'0186), none);
}

TEST(Tpdo, With29BitsIsRefused) {
  PdoNode node;
  for (unsigned bit = 11; bit <= 29; ++bit) {
    EXPECT_EQ(node.write(0x1800, 1, 0x185U | 1U << bit), value_range) << bit;
    EXPECT_EQ(node.write(0x1800, 1, 0x8000'0185U | 1U << bit), value_range) << bit;
  }
}

TEST(Tpdo, HasTheTransmissionTypesThatAreNotReserved) {
  PdoNode node;
  for (unsigned type = 0; type <= 255; ++type) {
    const bool known = type <= 240 || type >= 252;
    EXPECT_EQ(node.write(0x1800, 2, type), known ? none : value_range) << type;
  }
}

TEST(Tpdo, AsksTheApplicationToRefreshBeforeItIsSampled) {
  PdoNode node;
  std::vector<std::uint16_t> asked;
  auto refresh = [&](std::uint16_t number) {
    asked.push_back(number);
    node.node.dictionary().set_number(0x2010, 1, 0x100U * asked.size());
  };
  node.tpdos.before_transmit = Callback<void(std::uint16_t)>::of(refresh);
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.map_tpdo(2, 0x285, 1, {0x2000'01'08});
  node.operate();
  node.run_until(Time(100ms));
  node.expect({"@100000 185#00 01"});
  node.receive("080#");
  node.expect({"@100000 285#00", "@100000 185#00 03"});
  EXPECT_EQ(asked, (std::vector<std::uint16_t>{1, 2, 1}));
}

TEST(Tpdo, IsNotSentWhereTheApplicationThatIsAskedToRefreshItHasMadeItInvalid) {
  for (const unsigned type : {1U, 255U}) {
    PdoNode node;
    auto refresh = [&](std::uint16_t) { ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none); };
    node.tpdos.before_transmit = Callback<void(std::uint16_t)>::of(refresh);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.receive("080#");
    node.receive("080#");
    node.expect({});
  }
}

TEST(Tpdo, IsNotSentWhereTheApplicationThatIsAskedToRefreshItHasStoppedTheNode) {
  PdoNode node;
  auto refresh = [&](std::uint16_t) { node.node.command(NmtCommand::stop); };
  node.tpdos.before_transmit = Callback<void(std::uint16_t)>::of(refresh);
  node.map_tpdo(1, 0x185, 1, {0x2010'01'10});
  node.operate();
  node.receive("080#");
  node.expect({});
  EXPECT_EQ(node.node.state(), NmtState::stopped);
}

TEST(Tpdo, LetsTheHooksOfItsValuesRefreshThem) {
  PdoNode node;
  unsigned count = 0;
  auto refresh = [&](const Entry& entry) {
    const std::array<std::uint8_t, 2> bytes = {static_cast<std::uint8_t>(++count), 0xAA};
    node.node.dictionary().set(entry, bytes);
    return none;
  };
  Hook hook{.first = 0x2062, .last = 0x2062};
  hook.before_read = Callback<AbortCode(const Entry&)>::of(refresh);
  node.map_tpdo(1, 0x185, 253, {0x2062'00'10});
  node.operate();
  node.node.dictionary().attach(hook);
  node.receive("185#R2");
  node.receive("185#R2");
  node.expect({"185#01 AA", "185#02 AA"});
}

TEST(Tpdo, AsksTheHooksOfItsValuesOnlyWhereItIsSent) {
  PdoNode node;
  unsigned count = 0;
  auto refresh = [&](const Entry& entry) {
    const std::array<std::uint8_t, 2> bytes = {static_cast<std::uint8_t>(++count), 0xAA};
    node.node.dictionary().set(entry, bytes);
    return none;
  };
  Hook hook{.first = 0x2062, .last = 0x2062};
  hook.before_read = Callback<AbortCode(const Entry&)>::of(refresh);
  node.map_tpdo(1, 0x185, 0, {0x2062'00'10});
  node.operate();
  node.node.dictionary().attach(hook);
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.receive("080#");
  node.expect({"185#01 AA"});
  node.receive("080#");
  node.expect({});
  EXPECT_EQ(count, 1U);
}

TEST(Tpdo, MadeInvalidIsSilent) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.set(0x2000, 1, 1);
  node.receive("185#R1");
  node.run_until(Time(1s));
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
}

TEST(Tpdo, WatchesItsValuesOnlyWhileItIsSentForEvents) {
  PdoNode node;
  const Result<Entry> entry = node.node.dictionary().find(0x2000, 1);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 0, {0x2000'02'08});
  EXPECT_EQ(entry->watchers(), 0b1010U);
  ASSERT_EQ(node.write(0x1802, 2, 1), none);
  EXPECT_EQ(entry->watchers(), 0b0010U);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(entry->watchers(), 0U);
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.receive("000#82 00");
  EXPECT_EQ(entry->watchers(), 0U);
}

TEST(Tpdo, ChangesItsTypeInOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 1);
  node.expect({});
  ASSERT_EQ(node.write(0x1800, 2, 255), none);
  node.set(0x2000, 1, 2);
  node.expect({"185#02"});
  ASSERT_EQ(node.write(0x1800, 2, 2), none);
  node.set(0x2000, 1, 3);
  node.receive("080#");
  node.expect({});
  node.receive("080#");
  node.expect({"185#03"});
}

TEST(Tpdo, HasItsDefaultsAgainAfterAReset) {
  for (const char* reset : {"000#81 00", "000#82 05"}) {
    PdoNode node(send_at_start);
    ASSERT_EQ(node.write(0x1800, 5, 100), none);
    node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
    node.operate();
    node.expect({"185#00"});
    node.receive(reset);
    node.expect({"705#00"});
    node.operate();
    node.set(0x2000, 1, 1);
    node.receive("185#R1");
    node.run_until(Time(1s));
    node.expect({});
  }
}

TEST(Tpdo, IsRefusedWhereNoRouteForItsRemoteFramesIsLeft) {
  std::vector<std::uint8_t> bytes(pdo_tables.value_bytes);
  std::vector<ObjectState> states(pdo_tables.objects.size());
  std::array<Router::Route, 1> routes;  // taken by NMT
  std::array<Frame, 4> backlog;
  const auto send = [](void*, const Frame&) { return true; };
  Node node(pdo_tables, {bytes, states, routes, backlog}, {nullptr, send, nullptr}, 5);
  std::array<Tpdo, 1> pdos;
  std::array<MappedValue, 8> values;
  Tpdos tpdos(node, pdos, values);
  node.start(Time{});
  std::array<std::uint8_t, 4> cob_id;
  store(cob_id.data(), std::uint32_t{0x185});
  EXPECT_EQ(node.dictionary().write(0x1800, 1, cob_id, Source::sdo), out_of_memory);
  store(cob_id.data(), std::uint32_t{0x4000'0185});
  EXPECT_EQ(node.dictionary().write(0x1800, 1, cob_id, Source::sdo), none);
}

TEST(Tpdo, OfEightBytesIsSentWhereAnyOfThemHasChanged) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2050'07'40});
  node.operate();
  node.set(0x2050, 7, 0x8877'6655'4433'2211);
  node.expect({"185#11 22 33 44 55 66 77 88"});
  node.set(0x2050, 7, 0x8877'6655'4433'2211);
  node.expect({});
  node.set(0x2050, 7, 0x8977'6655'4433'2211);
  node.expect({"185#11 22 33 44 55 66 77 89"});
}

}  // namespace
}  // namespace canvoy::tpdo_test
