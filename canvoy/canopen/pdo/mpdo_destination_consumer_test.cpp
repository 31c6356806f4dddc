// Consumer of multiplexed PDOs in destination address mode, frame by frame (CiA 301, 7.2.3).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::mpdo_destination_consumer_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;
constexpr unsigned destination = 0xFF;

TEST(DamConsumer, TakesWhatIsAddressedToItOrToAll) {
  for (unsigned node_id = 0; node_id <= 127; ++node_id) {
    MpdoNode node;
    node.use_rpdo(1, 0x205, destination);
    node.operate();
    Frame frame = wire_frame("205#80 10 20 03 34 12 00 00");
    frame.data[0] = static_cast<std::uint8_t>(0x80 + node_id);
    node.node.receive(frame, node.now);
    const bool is_taken = node_id == 0 || node_id == 5;
    EXPECT_EQ(node.number(0x2010, 3), is_taken ? 0x1234U : 0U) << node_id;
    EXPECT_EQ(node.errors(), Texts());
    EXPECT_EQ(node.node.counters().malformed, 0U);
  }
}

TEST(DamConsumer, WritesAsManyBytesAsTheObjectHas) {
  MpdoNode node;
  node.use_rpdo(2, 0x305, destination);
  node.operate();
  node.receive("305#85 00 20 10 11 22 33 44");
  EXPECT_EQ(node.number(0x2000, 16), 0x11U);
  EXPECT_EQ(node.number(0x2000, 15), 0U);
  node.receive("305#85 10 20 01 11 22 33 44");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U);
  EXPECT_EQ(node.number(0x2010, 2), 0U);
  node.receive("305#85 40 20 00 11 22 83 44");
  EXPECT_EQ(node.number(0x2040, 0), 0x832211U);
  node.receive("305#85 20 20 04 11 22 33 84");
  EXPECT_EQ(node.number(0x2020, 4), 0x84332211U);
  node.receive("305#85 50 20 00 01 00 00 00");
  EXPECT_EQ(node.number(0x2050, 0), 1U);
  EXPECT_EQ(node.errors(), Texts());
}

TEST(DamConsumer, RaisesAnErrorForADestinationThatIsNotThereUntilAGoodOneComes) {
  struct Case {
    const char* frame;
    const char* what;
  };
  const Case cases[] = {
      {"205#85 FF 2F 00 01 00 00 00", "no object"},
      {"205#85 00 20 11 01 00 00 00", "no sub-index"},
      {"205#80 FF 2F 00 01 00 00 00", "no object, though all nodes are meant"},
      {"205#85 30 20 00 01 00 00 00", "more than four bytes"},
      {"205#85 70 20 00 61 00 00 00", "a string"},
      {"205#85 80 20 00 01 00 00 00", "not mappable"},
      {"205#85 81 20 00 01 00 00 00", "mappable into TPDOs only"},
  };
  for (const Case& c : cases) {
    MpdoNode node;
    node.use_rpdo(1, 0x205, destination);
    node.operate();
    node.receive(c.frame);
    node.receive(c.frame);
    EXPECT_EQ(node.errors(), Texts({"+8230/1"})) << c.what;
    EXPECT_EQ(node.last_error().register_bits, error_register::communication);
    const Frame frame = wire_frame(c.frame);
    const std::array<std::uint8_t, 5> info = {1, 0, frame.data[1], frame.data[2], frame.data[3]};
    EXPECT_EQ(node.last_error().info, info) << "the PDO and the object";
    node.receive("205#85 82 20 00 34 12 00 00");
    EXPECT_EQ(node.errors(), Texts({"-8230/1"})) << c.what;
    EXPECT_EQ(node.number(0x2082, 0), 0x1234U);
  }
}

TEST(DamConsumer, RefusesAValueOutOfRange) {
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  node.operate();
  for (unsigned value = 0; value <= 255; ++value) {
    Frame frame = wire_frame("205#85 60 20 00 00 00 00 00");
    frame.data[4] = static_cast<std::uint8_t>(value);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.number(0x2060, 0) == value, value >= 10 && value <= 20) << value;
  }
  EXPECT_EQ(node.errors(), Texts({"+8200/1", "-8200/1", "+8200/1"}));
  EXPECT_EQ(node.last_error().info, (std::array<std::uint8_t, 5>{1, 0, 0x60, 0x20, 0}));
}

TEST(DamConsumer, AsksAndTellsTheHooksOfTheObject) {
  MpdoNode node;
  Texts told;
  auto check = [&](const Entry&, std::span<const std::uint8_t> value) {
    return value[0] == 0x66 ? value_range : none;
  };
  auto note = [&](const Entry& entry, Source source) {
    EXPECT_EQ(source, Source::pdo);
    told.push_back("written " + std::to_string(entry.sub));
  };
  auto received = [&](std::uint16_t number) { told.push_back("RPDO " + std::to_string(number)); };
  Hook hook{.first = 0x2000, .last = 0x2000};
  hook.before_write = Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::of(check);
  hook.after_write = Callback<void(const Entry&, Source)>::of(note);
  node.node.dictionary().attach(hook);
  node.rpdos.received = Callback<void(std::uint16_t)>::of(received);
  node.use_rpdo(1, 0x205, destination);
  node.operate();
  node.receive("205#85 00 20 02 65 00 00 00");
  EXPECT_EQ(told, Texts({"written 2", "RPDO 1"}));
  node.receive("205#85 00 20 02 66 00 00 00");
  node.receive("205#86 00 20 02 67 00 00 00");
  EXPECT_EQ(told.size(), 2U) << "refused, and for another node";
  EXPECT_EQ(node.number(0x2000, 2), 0x65U);
  EXPECT_EQ(node.errors(), Texts({"+8200/1"}));
}

TEST(DamConsumer, ForgetsWhatItsRecordMappedBefore) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1600, 1, 0x2000'01'08), none);
  ASSERT_EQ(node.write(0x1600, 0, 1), none);
  ASSERT_EQ(node.write(0x1600, 0, 0xFF), none);
  ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
  node.operate();
  for (const char* frame : {"205#85 00 20 02 65 00 00 00", "205#85 00 20 02 66 00 00 00"}) {
    node.receive(frame);
  }
  EXPECT_EQ(node.number(0x2000, 1), 0U);
  EXPECT_EQ(node.number(0x2000, 2), 0x66U);
}

TEST(DamConsumer, ChangesATpdoThatMapsTheObject) {
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  ASSERT_EQ(node.write(0x1A00, 1, 0x2000'01'08), none);
  ASSERT_EQ(node.write(0x1A00, 0, 1), none);
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.operate();
  node.receive("205#85 00 20 01 07 00 00 00");
  node.expect({"185#07"});
}

TEST(DamConsumer, IgnoresAndCountsFramesInSourceAddressMode) {
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  node.operate();
  for (unsigned first = 0; first < 0x80; ++first) {
    Frame frame = wire_frame("205#00 00 20 01 07 00 00 00");
    frame.data[0] = static_cast<std::uint8_t>(first);
    node.node.receive(frame, node.now);
  }
  EXPECT_EQ(node.number(0x2000, 1), 0U);
  EXPECT_EQ(node.errors(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 128U);
}

TEST(DamConsumer, HasAFrameOfEightBytes) {
  for (std::uint8_t length = 0; length < 8; ++length) {
    MpdoNode node;
    node.use_rpdo(1, 0x205, destination);
    node.operate();
    Frame frame = wire_frame("205#85 00 20 01 07 00 00 00");
    frame.length = length;
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.errors(), Texts({"+8210/1"})) << int{length};
    EXPECT_EQ(node.number(0x2000, 1), 0U);
    frame.length = 8;
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.errors(), Texts({"-8210/1"}));
    EXPECT_EQ(node.number(0x2000, 1), 7U);
  }
}

TEST(DamConsumer, IsReceivedInOperationalOnly) {
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  node.receive("205#85 00 20 01 07 00 00 00");
  EXPECT_EQ(node.number(0x2000, 1), 0U);
  node.operate();
  node.receive("000#02 00");
  node.receive("205#85 00 20 01 07 00 00 00");
  EXPECT_EQ(node.number(0x2000, 1), 0U);
}

TEST(DamConsumer, IsSupervisedByItsDeadline) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.use_rpdo(1, 0x205, destination);
  node.operate();
  node.receive("205#85 00 20 01 07 00 00 00");
  node.run_until(Time(100ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
  node.receive("205#85 00 20 01 07 00 00 00");
  EXPECT_EQ(node.errors(), Texts({"-8250/1"}));
}

TEST(DamConsumer, IsEventDriven) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 254) continue;
    MpdoNode node;
    ASSERT_EQ(node.write(0x1400, 2, type), none);
    ASSERT_EQ(node.write(0x1600, 0, destination), none);
    EXPECT_EQ(node.write(0x1400, 1, 0x205), type >= 254 ? none : parameter_incompatible) << type;
    EXPECT_EQ(node.rpdos[1].is_active(), type >= 254);
  }
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  EXPECT_EQ(node.write(0x1400, 2, 1), parameter_incompatible);
  EXPECT_EQ(node.write(0x1400, 2, 254), none);
}

TEST(DamConsumer, BecomesAPlainRpdoAgainByTheProcedure) {
  MpdoNode node;
  node.use_rpdo(1, 0x205, destination);
  EXPECT_EQ(node.write(0x1600, 0, 0), unsupported_access) << "while the PDO is valid";
  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  EXPECT_EQ(node.write(0x1600, 1, 0x2010'01'10), unsupported_access) << "while sub-index 0 is FFh";
  ASSERT_EQ(node.write(0x1600, 0, 0), none);
  ASSERT_EQ(node.write(0x1600, 1, 0x2010'01'10), none);
  ASSERT_EQ(node.write(0x1600, 0, 1), none);
  ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
  node.operate();
  node.receive("205#34 12");
  EXPECT_EQ(node.number(0x2010, 1), 0x1234U);
  EXPECT_EQ(node.errors(), Texts());
}

TEST(DamConsumer, IsUnknownToANodeWithoutTheService) {
  PdoNode node;
  for (const unsigned mode : {0xFEU, 0xFFU}) {
    EXPECT_EQ(node.write(0x1600, 0, mode), value_range);
    EXPECT_EQ(node.write(0x1A00, 0, mode), value_range);
  }
}

TEST(DamConsumer, LivesThroughEveryFirstByteAndLengthInBothModes) {
  for (const unsigned mode : {0xFEU, 0xFFU}) {
    MpdoNode node;
    node.use_rpdo(1, 0x205, mode);
    node.operate();
    for (unsigned first = 0; first <= 0xFF; ++first) {
      for (std::uint8_t length = 0; length <= 8; ++length) {
        Frame frame = wire_frame("205#00 FF FF FF FF FF FF FF");
        frame.data[0] = static_cast<std::uint8_t>(first);
        frame.length = length;
        node.node.receive(frame, node.now);
      }
    }
    node.settle();
    EXPECT_EQ(node.node.state(), NmtState::operational);
    node.expect({});
  }
}

}  // namespace
}  // namespace canvoy::mpdo_destination_consumer_test
