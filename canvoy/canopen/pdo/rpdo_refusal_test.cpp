#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::rpdo_refusal_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

/// A hook on 2062h that accepts even numbers only, and records its calls.
struct EvenOnly {
  explicit EvenOnly(PdoNode& node) : node_(node) {
    hook_.first = hook_.last = 0x2062;
    hook_.before_write =
        Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&EvenOnly::check>(
            *this);
    hook_.after_write = Callback<void(const Entry&, Source)>::to<&EvenOnly::written>(*this);
    node.node.dictionary().attach(hook_);
  }
  AbortCode check(const Entry&, std::span<const std::uint8_t> value) {
    return value[0] % 2 == 0 ? none : value_range;
  }
  void written(const Entry&, Source source) {
    EXPECT_EQ(source, Source::pdo);
    ++told;
    last_value_of_pdo = node_.number(0x2010, 1);
  }

  int told = 0;
  std::uint64_t last_value_of_pdo = 0;

 private:
  PdoNode& node_;
  Hook hook_;
};

TEST(Rpdo, WithOneValueOutOfRangeWritesNoneAndRaisesAnError) {
  PdoNode node;
  node.map_rpdo(4, 0x205, 255, {0x2010'01'10, 0x2000'01'08, 0x2060'00'08});
  node.operate();
  node.receive("205#01 02 03 0A");
  EXPECT_EQ(node.number(0x2060, 0), 10U);
  for (unsigned value = 0; value <= 255; ++value) {
    const bool fits = (value >= 10 && value <= 20) || value == 255;
    node.set(0x2010, 1, 0x7777);
    Frame frame = wire_frame("205#11 22 33 00");
    frame.data[3] = static_cast<std::uint8_t>(value);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.number(0x2010, 1), fits ? 0x2211U : 0x7777U) << value;
    EXPECT_EQ(node.number(0x2060, 0) == value, fits) << value;
  }
  EXPECT_EQ(node.errors(), Texts({"+8200/4", "-8200/4", "+8200/4", "-8200/4"}));
}

TEST(Rpdo, RefusedNamesThePdoAndTheObject) {
  PdoNode node;
  node.map_rpdo(4, 0x205, 255, {0x2010'01'10, 0x2061'00'10});
  node.operate();
  node.receive("205#00 00 9C FF");
  EXPECT_TRUE(node.errors().empty()) << "-100 fits";
  node.receive("205#00 00 9B FF");
  EXPECT_EQ(node.errors(), Texts({"+8200/4"})) << "-101 does not";
  EXPECT_EQ(node.last_error().info, (std::array<std::uint8_t, 5>{0x04, 0x00, 0x61, 0x20, 0x00}));
}

TEST(Rpdo, AsksTheHooksOfAllValuesBeforeItWritesOne) {
  PdoNode node;
  EvenOnly even(node);
  node.map_rpdo(1, 0x205, 255, {0x2062'00'10, 0x2010'01'10});
  node.operate();
  node.receive("205#02 00 11 11");
  EXPECT_EQ(even.told, 1);
  EXPECT_EQ(even.last_value_of_pdo, 0x1111U) << "all values are written before a hook is told";
  node.receive("205#03 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 2U);
  EXPECT_EQ(node.number(0x2010, 1), 0x1111U);
  EXPECT_EQ(even.told, 1);
  EXPECT_EQ(node.errors(), Texts({"+8200/1"}));
}

TEST(Rpdo, KnowsAHookThatWasAttachedAfterTheMapping) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2062'00'10, 0x2010'01'10});
  node.operate();
  node.receive("205#01 00 11 11");
  node.receive("205#03 00 11 11");
  EXPECT_EQ(node.number(0x2062, 0), 3U);
  EvenOnly even(node);
  node.receive("205#05 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 3U);
  node.receive("205#06 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 6U);
  EXPECT_EQ(even.told, 1);
}

}  // namespace
}  // namespace canvoy::rpdo_refusal_test
