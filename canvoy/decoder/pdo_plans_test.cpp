#include "canvoy/decoder/pdo_plans.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::pdo_plans_test {
namespace {

const Profile& base = base_profile();
const Profile& charger = *find_profile("419");
constexpr std::uint32_t entry = 0x6000'0008;
constexpr std::uint32_t invalid = 0x8000'0000;

/// Makes the PDO with this mapping parameter carry one entry.
void map_entry(PdoPlans& sut, NodeId node, int mapping_index) {
  const auto index = static_cast<std::uint16_t>(mapping_index);
  sut.learn(node, index, 1, entry, base);
  sut.learn(node, index, 0, 1, base);
}
/// If there is none, an empty plan of node 0.
const PdoPlan& plan(const PdoPlans& sut, std::uint32_t can_id) {
  static const PdoPlan none;
  return sut.find(can_id) == nullptr ? none : *sut.find(can_id);
}

// 1400h and 1600h, 1800h and 1A00h, 512 of each (CiA 301, 7.5.2.33 to 7.5.2.38).
TEST(PdoPlans, HaveTheNumbersOfTheirIndices) {
  using enum PdoInfo::Direction;
  for (const auto& [parameter, direction, number] :
       {std::tuple(0x1400, receive, 1), std::tuple(0x15FF, receive, 512),
        std::tuple(0x1800, transmit, 1), std::tuple(0x19FF, transmit, 512)}) {
    PdoPlans sut;
    map_entry(sut, 10, parameter + 0x200);
    sut.learn(10, static_cast<std::uint16_t>(parameter), 1, 0x333, base);
    EXPECT_EQ(plan(sut, 0x333).direction, direction);
    EXPECT_EQ(plan(sut, 0x333).number, number);
  }
}

// Up to 64 entries; FEh and FFh are the two kinds of MPDO (CiA 301, 7.5.2.36).
TEST(PdoPlans, OfAnImpossibleMappingAreNone) {
  PdoPlans sut;
  for (unsigned sub = 1; sub <= 255; ++sub) {
    sut.learn(10, 0x1A00, static_cast<std::uint8_t>(sub), entry, base);
  }
  for (const std::uint32_t count : {0U, 65U, 253U}) {
    sut.learn(10, 0x1A00, 0, count, base);
    EXPECT_EQ(sut.find(0x18A), nullptr) << count;
  }
  sut.learn(10, 0x1A00, 0, 64, base);
  EXPECT_EQ(plan(sut, 0x18A).mapping.size(), 64U);
  for (const auto& [count, kind] :
       {std::pair(0xFEU, MpdoKind::source), std::pair(0xFFU, MpdoKind::destination)}) {
    sut.learn(10, 0x1A00, 0, count, base);
    EXPECT_EQ(plan(sut, 0x18A).multiplexed, kind);
    EXPECT_TRUE(plan(sut, 0x18A).mapping.empty()) << "the frame says what it carries";
  }
}

// Bit 31 is "not valid", bit 29 a frame of 29 bits, which is not followed here (CiA 301, 7.5.2.35).
TEST(PdoPlans, AreOfValidCobIdsOf11BitsAndComeBackWithThem) {
  PdoPlans sut;
  map_entry(sut, 10, 0x1A00);
  for (const std::uint32_t cob_id : {invalid | 0x18A, 0x2000'018AU, 0x0001'018AU}) {
    sut.learn(10, 0x1800, 1, cob_id, base);
    EXPECT_EQ(sut.find(0x18A), nullptr) << cob_id;
    sut.learn(10, 0x1800, 1, 0x4000'018A, base);
    EXPECT_NE(sut.find(0x18A), nullptr) << "bit 30 is of remote frames";
  }
  sut.learn(10, 0x1800, 2, 0x333, base);
  EXPECT_EQ(sut.find(0x333), nullptr) << "the transmission type";
}

TEST(PdoPlans, OfTwoThatChangePlacesAreEachWhereItIsNow) {
  PdoPlans sut;
  map_entry(sut, 10, 0x1A00);
  map_entry(sut, 10, 0x1A01);
  sut.learn(10, 0x1800, 1, 0x28A, base);
  sut.learn(10, 0x1801, 1, 0x18A, base);
  EXPECT_EQ(plan(sut, 0x28A).number, 1);
  EXPECT_EQ(plan(sut, 0x18A).number, 2);
}

TEST(PdoPlans, OfWhoSendsGoBeforeThoseOfWhoReceives) {
  PdoPlans sut;
  map_entry(sut, 10, 0x1A00);
  map_entry(sut, 11, 0x1600);
  sut.learn(11, 0x1400, 1, 0x18A, base);
  EXPECT_EQ(plan(sut, 0x18A).node, 10);
  sut.learn(10, 0x1800, 1, invalid, base);
  EXPECT_EQ(plan(sut, 0x18A).node, 11) << "nobody sends it";
  sut.learn(10, 0x1800, 1, 0x18A, base);
  EXPECT_EQ(plan(sut, 0x18A).node, 10);
}

// TPDO2 carries 6001h and 6052h (CiA 419, 6.2.6.3). TPDO1 is valid from the start (CiA 418).
TEST(PdoPlans, StandWhereTheyWereHeardWhicheverProfileBecomesKnown) {
  PdoPlans sut;
  sut.learn(10, 0x1801, 1, 0x333, base);
  EXPECT_EQ(sut.find(0x333), nullptr) << "what it carries is not known";
  sut.use_profile(10, charger);
  EXPECT_EQ(plan(sut, 0x333).mapping, (std::vector<std::uint32_t>{0x6001'0008, 0x6052'0010}));
  EXPECT_EQ(sut.find(0x28A), nullptr);
  sut.learn(11, 0x1800, 1, 0x334, base);
  sut.use_profile(11, *find_profile("418"));
  EXPECT_EQ(plan(sut, 0x334).node, 11);
  EXPECT_EQ(plan(sut, 0x18B).node, 0);
}

TEST(PdoPlans, OfADeviceThatIsReplacedAreForgottenAndThoseOfItsNeighboursStay) {
  PdoPlans sut;
  for (const NodeId node : {NodeId{9}, NodeId{10}, NodeId{11}}) {
    map_entry(sut, node, 0x1A00);
    sut.learn(node, 0x1800, 1, 0x330U + node, base);
  }
  sut.use_profile(11, charger);
  sut.forget(10, base);
  EXPECT_EQ(plan(sut, 0x18A).node, 0) << "what it carries is forgotten too";
  EXPECT_EQ(plan(sut, 0x28B).node, 11);
  sut.use_profile(11, charger);
  EXPECT_EQ(plan(sut, 0x33B).node, 11) << "what was heard of it is not forgotten";
  map_entry(sut, 10, 0x1A00);
  EXPECT_EQ(plan(sut, 0x18A).node, 10) << "where it is after power-on (CiA 301, 7.3.3)";
}

/// 16 nodes write all PDO parameters: no others are followed from then on.
TEST(PdoPlans, AreLearnedOf16384PdosAndNoMore) {
  PdoPlans sut;
  for (int again = 0; again < 9; ++again) map_entry(sut, 1, 0x1A00);
  for (NodeId node = 1; node <= 16; ++node) {
    for (unsigned i = 0; i < 512; ++i) {
      sut.learn(node, static_cast<std::uint16_t>(0x1400 + i), 1, invalid, base);
      sut.learn(node, static_cast<std::uint16_t>(0x1800 + i), 1, invalid, base);
    }
  }
  map_entry(sut, 17, 0x1A00);
  EXPECT_EQ(sut.find(0x191), nullptr);
  map_entry(sut, 16, 0x1BFF);
  sut.learn(16, 0x19FF, 1, 0x333, base);
  EXPECT_EQ(plan(sut, 0x333).node, 16);
}

/// Two nodes receive one PDO of an unknown sender; then one receives another.
TEST(PdoPlans, OfTwoReceiversIsLeftTheOneThatStays) {
  PdoPlans sut;
  for (const NodeId node : {NodeId{11}, NodeId{12}}) {
    map_entry(sut, node, 0x1600);
    sut.learn(node, 0x1400, 1, 0x18A, base);
  }
  sut.learn(12, 0x1400, 1, 0x20C, base);
  EXPECT_EQ(plan(sut, 0x18A).node, 11);
  EXPECT_EQ(plan(sut, 0x20C).node, 12);
  sut.learn(11, 0x1400, 1, invalid, base);
  EXPECT_EQ(sut.find(0x18A), nullptr);
}

}  // namespace
}  // namespace canvoy::decoder::pdo_plans_test
