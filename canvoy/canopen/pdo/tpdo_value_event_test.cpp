// Values for which the application decides whether a change is an event (Dictionary::
// set_with_event() and set_without_event()), as for the interrupt masks of CiA 401: that decides,
// and not what the TPDO carried last (CiA 301, 7.5.2.37, transmission types).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_value_event_test {
namespace {

using enum AbortCode;

enum class IsEvent : std::uint8_t { yes, no };

void put(PdoNode& node, std::uint16_t index, std::uint8_t sub, std::uint64_t number, IsEvent is) {
  node.node.advance(node.now);
  Dictionary& dictionary = node.node.dictionary();
  const Result<Entry> entry = dictionary.find(index, sub);
  ASSERT_TRUE(entry);
  std::array<std::uint8_t, 8> bytes{};
  store(bytes.data(), number);
  if (is == IsEvent::yes) {
    dictionary.set_with_event(*entry, bytes);
  } else {
    dictionary.set_without_event(*entry, bytes);
  }
  node.settle();
}

struct Mapped {
  std::vector<std::uint32_t> entries;
  std::string one;   ///< with 2000h:01h = 1
  std::string none;  ///< with 0
};
/// One copy, several places, bits.
std::vector<Mapped> mappings() {
  return {{{0x2000'01'08}, "185#01", "185#00"},
          {{0x2010'01'10, 0x2000'01'08}, "185#00 00 01", "185#00 00 00"},
          {{0x2030'05'01, 0x2000'01'08, 0x2030'06'01}, "185#02 00", "185#00 00"}};
}

TEST(Tpdo, IsSentForAnEventOfAValueWhateverItCarriedLast) {
  for (const unsigned type : {254U, 255U}) {
    for (const Mapped& mapped : mappings()) {
      PdoNode node;
      node.map_tpdo(1, 0x185, type, mapped.entries);
      node.operate();
      for (int i = 0; i < 3; ++i) {
        put(node, 0x2000, 1, 1, IsEvent::yes);
        node.expect({mapped.one});
        put(node, 0x2000, 1, 0, IsEvent::no);
        node.expect({});
      }
      put(node, 0x2000, 1, 0, IsEvent::yes);
      node.expect({mapped.none});
    }
  }
}

/// Others in the same object, and in the same PDO, may be reported meanwhile.
TEST(Tpdo, IsNotSentForAChangeThatIsNoEvent) {
  for (const Mapped& mapped : mappings()) {
    PdoNode node;
    node.map_tpdo(1, 0x185, 255, mapped.entries);
    node.map_tpdo(2, 0x285, 255, {0x2000'09'08});
    node.operate();
    put(node, 0x2000, 1, 1, IsEvent::no);
    node.expect({});
    node.set(0x2000, 9, 7);
    node.expect({"285#07"});
    put(node, 0x2000, 9, 8, IsEvent::yes);
    node.expect({"285#08"});
    EXPECT_TRUE(node.tpdos.trigger(1));
    // The next one includes it.
    node.expect({mapped.one});
  }
}

/// Too many changes at once to record their places.
TEST(Tpdo, IsNotSentForAChangeThatIsNoEventBesideManyThatAre) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'09'08, 0x2000'0A'08});
  node.operate();
  put(node, 0x2000, 1, 1, IsEvent::no);
  Dictionary& dictionary = node.node.dictionary();
  for (std::uint8_t sub = 2; sub <= 16; ++sub) {
    ASSERT_TRUE(dictionary.set_number(0x2000, sub, 3));
  }
  node.settle();
  node.expect({"285#03 03"});
}

TEST(Tpdo, CarriesAnEventOfAValueWhenTheInhibitTimeIsOver) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.run_until(Time(50ms));
  put(node, 0x2000, 1, 1, IsEvent::yes);
  node.expect({"@50000 185#01"});
  node.run_until(Time(52ms));
  put(node, 0x2000, 1, 0, IsEvent::no);
  put(node, 0x2000, 1, 1, IsEvent::yes);
  node.run_until(Time(60ms - 1us));
  node.expect({});
  node.run_until(Time(1s));
  node.expect({"@60000 185#01"});
}

TEST(Tpdo, OfType0IsSentAtSyncForAnEventOfAValueOnly) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 0, {0x2000'01'08});
  node.operate();
  put(node, 0x2000, 1, 1, IsEvent::no);
  node.receive("080#");
  node.expect({});
  put(node, 0x2000, 1, 2, IsEvent::yes);
  put(node, 0x2000, 1, 1, IsEvent::no);
  node.expect({});
  node.receive("080#");
  node.expect({"185#01"});
  put(node, 0x2000, 1, 0, IsEvent::no);
  put(node, 0x2000, 1, 1, IsEvent::yes);
  node.receive("080#");
  node.expect({"185#01"});
  node.receive("080#");
  node.expect({});
}

/// A transmission meanwhile has sent the event.
TEST(Tpdo, TellsAnEventOfAValueOnce) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  const Result<Entry> entry = node.node.dictionary().find(0x2000, 1);
  ASSERT_TRUE(entry);
  const std::uint8_t one = 1;
  node.node.dictionary().set_with_event(*entry, {&one, 1});
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.settle();
  node.expect({"185#01"});
  node.set(0x2000, 2, 5);
  node.expect({});
}

/// An inactive PDO keeps nothing for later.
TEST(Tpdo, ForgetsEventsOfValuesThatCameBeforeItWasAtWork) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  put(node, 0x2000, 1, 1, IsEvent::yes);
  node.expect({});
  node.operate();
  node.set(0x2000, 2, 5);
  node.expect({});
}

}  // namespace
}  // namespace canvoy::tpdo_value_event_test
