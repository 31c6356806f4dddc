// The stored set survives a loss of power at any moment: it is the old or the new one.
//
// Exhaustively: power fails at each byte that is erased or programmed, and leaves the byte
// unchanged, half changed or changed; then the device starts again, and stores again.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_power_cut_test {
namespace {

// Small sectors, since each of their bytes is tested.
constexpr SimulatedFlash::Geometry geometry{.sector_size = 160, .sectors = 2, .unit = 8};
constexpr Storage::Settings settings{.slot_size = 160, .groups = stored_groups};
constexpr Tear tears[] = {Tear::nothing, Tear::some_bits};

using Parameters = StoringNode::Parameters;

/// Requests to a node before the power fails.
struct Step {
  const char* name;
  void (*prepare)(StoringNode&);  ///< with power
  void (*run)(StoringNode&);      ///< power fails during it
};

void write_signature(StoringNode& node, const std::string& object, const std::string& signature) {
  node.receive("605#23 " + object + " " + signature);
}
void save_all(StoringNode& node) {
  write_signature(node, "10 10 01", "73 61 76 65");
}
void save_application(StoringNode& node) {
  write_signature(node, "10 10 03", "73 61 76 65");
}
void load_all(StoringNode& node) {
  write_signature(node, "11 10 01", "6C 6F 61 64");
}

constexpr Step steps[] = {
    {"the first set", [](StoringNode& node) { node.set_all(1); }, save_all},
    {"the second set",
     [](StoringNode& node) {
       node.set_all(1);
       save_all(node);
       node.set_all(2);
     },
     save_all},
    {"the third set, in the place of the first",
     [](StoringNode& node) {
       for (const unsigned number : std::to_array<unsigned>({1, 2})) {
         node.set_all(number);
         save_all(node);
       }
       node.set_all(3);
     },
     save_all},
    {"one group of four",
     [](StoringNode& node) {
       for (const unsigned number : std::to_array<unsigned>({1, 2})) {
         node.set_all(number);
         save_all(node);
       }
       node.set_all(3);
     },
     save_application},
    {"the defaults",
     [](StoringNode& node) {
       for (const unsigned number : std::to_array<unsigned>({1, 2})) {
         node.set_all(number);
         save_all(node);
       }
     },
     load_all},
};

/// Contents of the flash, and the resulting state of a device.
struct Kept {
  SimulatedFlash::Bytes bytes;
  std::uint64_t steps = 0;
};

Kept run(const Step& step, std::uint64_t cut_after, Tear tear) {
  SimulatedFlash memory(geometry);
  StoringNode node(memory, settings);
  step.prepare(node);
  const std::uint64_t before = memory.steps();
  memory.cut_after(cut_after, tear);
  step.run(node);
  EXPECT_EQ(memory.violations, 0U);
  return {memory.bytes, memory.steps() - before};
}

Parameters after_power_on(const SimulatedFlash::Bytes& bytes) {
  SimulatedFlash memory(geometry, bytes);
  return StoringNode(memory, settings).parameters();
}

class StoragePowerCut : public testing::TestWithParam<Step> {};

TEST_P(StoragePowerCut, LeavesTheOldSetOrTheNewOneAndNoMixture) {
  const Parameters before = after_power_on(run(GetParam(), 0, Tear::nothing).bytes);
  const Kept whole = run(GetParam(), SimulatedFlash::no_limit / 2, Tear::nothing);
  const Parameters after = after_power_on(whole.bytes);
  ASSERT_NE(before, after);
  ASSERT_GT(whole.steps, 160U);
  bool is_new = false;
  for (std::uint64_t cut = 0; cut <= whole.steps + 1; ++cut) {
    for (const Tear tear : tears) {
      const Parameters found = after_power_on(run(GetParam(), cut, tear).bytes);
      ASSERT_TRUE(found == before || found == after) << "cut at byte " << cut;
      ASSERT_TRUE(found == after || !is_new) << "cut at byte " << cut << ": once new, always new";
      if (tear == Tear::nothing) is_new = found == after;
    }
  }
  EXPECT_TRUE(is_new);
}

TEST_P(StoragePowerCut, IsNoErrorWhereASetWasStoredBefore) {
  const bool had_one = std::string(GetParam().name) != "the first set";
  const Kept whole = run(GetParam(), SimulatedFlash::no_limit / 2, Tear::nothing);
  for (std::uint64_t cut = 0; cut <= whole.steps; ++cut) {
    for (const Tear tear : tears) {
      SimulatedFlash memory(geometry, run(GetParam(), cut, tear).bytes);
      StoringNode node(memory, settings);
      ASSERT_TRUE(node.storage.state() == RecordState::valid || !had_one) << "at byte " << cut;
    }
  }
}

TEST_P(StoragePowerCut, LeavesADeviceThatStoresAgain) {
  const Kept whole = run(GetParam(), SimulatedFlash::no_limit / 2, Tear::nothing);
  for (std::uint64_t cut = 0; cut <= whole.steps; ++cut) {
    for (const Tear tear : tears) {
      SimulatedFlash memory(geometry, run(GetParam(), cut, tear).bytes);
      StoringNode node(memory, settings);
      node.sent.clear();
      node.set_all(9);
      save_all(node);
      ASSERT_EQ(wire_text(node.sent.back().frame), "585#60 10 10 01 00 00 00 00");
      ASSERT_EQ(memory.violations, 0U);
      ASSERT_EQ(after_power_on(memory.bytes), node.parameters()) << "cut at byte " << cut;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, StoragePowerCut, testing::ValuesIn(steps), [](const auto& step) {
  std::string name = step.param.name;
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
});

TEST(StoragePowerCut, ASecondCutWhileTheDeviceStoresAgainIsSurvivedToo) {
  const Step& second = steps[1];
  const Parameters before = after_power_on(run(second, 0, Tear::nothing).bytes);
  const std::uint64_t whole = run(second, SimulatedFlash::no_limit / 2, Tear::nothing).steps;
  for (std::uint64_t first_cut = 0; first_cut < whole; first_cut += 11) {
    const SimulatedFlash::Bytes torn = run(second, first_cut, Tear::some_bits).bytes;
    for (std::uint64_t cut = 0; cut < whole; cut += 7) {
      SimulatedFlash memory(geometry, torn);
      StoringNode node(memory, settings);
      node.set_all(9);
      const Parameters after = node.parameters();
      memory.cut_after(cut, Tear::some_bits);
      save_all(node);
      const Parameters found = after_power_on(memory.bytes);
      ASSERT_TRUE(found == before || found == after) << first_cut << ", then " << cut;
    }
  }
}

// Any life of a device: sets, stores, restores, resets and cuts, and a model of what must be kept.
RC_GTEST_PROP(StoragePowerCut, AnyLifeOfADeviceKeepsWhatWasConfirmed, ()) {
  SimulatedFlash::Bytes bytes;
  Parameters kept = after_power_on(bytes);
  const auto lives = *rc::gen::inRange(1, 8);
  for (int life = 0; life < lives; ++life) {
    SimulatedFlash memory(geometry, bytes);
    StoringNode node(memory, settings);
    RC_ASSERT(node.parameters() == kept);
    const bool restores = *rc::gen::inRange(0, 4) == 0;
    if (!restores) node.set_all(*rc::gen::inRange(0U, 100U));
    const Parameters present = node.parameters();
    node.sent.clear();
    memory.cut_after(*rc::gen::inRange<std::uint64_t>(0, 500),
                     *rc::gen::element(Tear::nothing, Tear::some_bits));
    restores ? load_all(node) : save_all(node);
    bytes = memory.bytes;
    const Parameters found = after_power_on(bytes);
    const Parameters wanted = restores ? after_power_on({}) : present;
    RC_ASSERT(found == kept || found == wanted);
    if (!memory.is_dead()) RC_ASSERT(found == wanted);
    RC_ASSERT(memory.violations == 0U);
    kept = found;
  }
}

}  // namespace
}  // namespace canvoy::storage_power_cut_test
