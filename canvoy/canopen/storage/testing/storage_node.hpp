// A node with storage on a simulated flash, and a dictionary with one object of each kind that
// storage treats differently.
//
//     StoringNode sut(memory);
//     sut.ask("23 10 10 01 73 61 76 65", "60 10 10 01 00 00 00 00");
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/storage/storage.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

inline constexpr std::uint32_t stored_device_type = 0x0002'01A2;

inline constexpr auto stored_objects = std::to_array<ObjectRow>({
    {.index = 0x1000, .entry_count = 1},
    {.index = 0x1010, .entry_count = 2},
    {.index = 0x1011, .entry_count = 2},
    {.index = 0x1014, .entry_count = 1},
    {.index = 0x1017, .entry_count = 1},
    {.index = 0x1018, .entry_count = 2},
    {.index = 0x2000, .entry_count = 1},
    {.index = 0x2010, .entry_count = 1},
    {.index = 0x2100, .entry_count = 1},
    {.index = 0x6000, .entry_count = 1},
    {.index = 0x6010, .entry_count = 1},
    {.index = 0x6020, .count = 2, .entry_count = 2},
    {.index = 0x6030, .entry_count = 1},
    {.index = 0x6040, .entry_count = 1},
    {.index = 0xA000, .entry_count = 1},
});
inline constexpr auto stored_entries = std::to_array<EntryRow>({
    {.type = DataType::unsigned32, .access = Access::const_, .initial = stored_device_type},
    // 1010h, 1011h
    {.access = Access::const_, .initial = 5},
    {.sub_first = 1,
     .sub_last = 5,
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 1},
    {.access = Access::const_, .initial = 5},
    {.sub_first = 1,
     .sub_last = 5,
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 1},
    // 1014h, 1017h, 1018h
    {.type = DataType::unsigned32,
     .access = Access::rw,
     .traits = EntryTraits::plus_node_id,
     .initial = 0x80},
    {.type = DataType::unsigned16, .access = Access::rw},
    {.access = Access::const_, .initial = 2},
    {.sub_first = 1,
     .sub_last = 2,
     .type = DataType::unsigned32,
     .access = Access::const_,
     .initial = 0x123},
    // 2000h, 2010h, 2100h
    {.access = Access::rw, .initial = 0x20},
    {.type = DataType::visible_string,
     .access = Access::rw,
     .capacity = 10,
     .initial_text = "charger"},
    {.type = DataType::unsigned16, .access = Access::rw, .initial = 0x2100},
    // 6000h: 0 to 1000; 6010h: a process value; 6020h and 6021h: arrays; 6030h: read only; 6040h: a
    // domain
    {.type = DataType::unsigned16,
     .access = Access::rw,
     .traits = EntryTraits::limited,
     .low = 0,
     .high = 1000,
     .initial = 100},
    {.type = DataType::integer16,
     .access = Access::rw | Access::rpdo,
     .traits = EntryTraits::not_stored,
     .initial = -1},
    {.access = Access::const_, .initial = 2},
    {.sub_first = 1, .sub_last = 2, .access = Access::rw, .initial = 0x60},
    {.type = DataType::unsigned16, .access = Access::ro, .initial = 0x6030},
    {.type = DataType::domain, .access = Access::rw},
    {.access = Access::rw, .initial = 0xA0},
});
inline constexpr auto stored_layout = lay_out(stored_objects, stored_entries);

/// Two groups of manufacturer-specific objects.
inline constexpr ParameterGroup stored_groups[] = {{4, 0x2000, 0x20FF}, {5, 0x2100, 0x21FF}};

inline constexpr SimulatedFlash::Geometry stored_geometry{
    .sector_size = 256, .sectors = 2, .unit = 8};
inline constexpr Storage::Settings stored_settings{.slot_size = 256, .groups = stored_groups};

/// A node after its power-on.
class StoringNode : public WireNode {
 public:
  explicit StoringNode(SimulatedFlash& memory, const Storage::Settings& settings = stored_settings,
                       const DictionaryTables& tables = stored_layout.tables(), NodeId id = 5)
      : WireNode(tables, id),
        emergency_producer(node, present_, waiting_),
        storage(node, memory.flash, settings),
        sdo_server(node, 0, buffer_) {
    start();
  }

  /// Boots the node; checks that there is no error.
  StoringNode& booted() {
    expect({"705#00"});
    return *this;
  }
  /// Sends a request and checks its answer: eight bytes each. An empty answer means none.
  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    receive("605#" + request);
    expect(answer.empty() ? std::vector<std::string>{} : std::vector<std::string>{"585#" + answer});
  }
  void save(unsigned group = 1) {
    const std::string sub = "0" + std::to_string(group);
    ask("23 10 10 " + sub + " 73 61 76 65", "60 10 10 " + sub + " 00 00 00 00");
  }
  void load(unsigned group = 1) {
    const std::string sub = "0" + std::to_string(group);
    ask("23 11 10 " + sub + " 6C 6F 61 64", "60 11 10 " + sub + " 00 00 00 00");
  }
  void set(std::uint16_t index, std::uint64_t number, std::uint8_t sub = 0) {
    ASSERT_TRUE(node.dictionary().set_number(index, sub, number));
  }
  std::uint64_t get(std::uint16_t index, std::uint8_t sub = 0) {
    return node.dictionary().number(index, sub);
  }
  void set_text(const std::string& text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    node.dictionary().set(*node.dictionary().find(0x2010, 0), bytes);
  }
  std::string text() {
    const auto bytes = node.dictionary().find(0x2010, 0)->bytes();
    return {bytes.begin(), bytes.end()};
  }

  /// Sets one of a family of sets that differ in every parameter.
  void set_all(unsigned number) {
    set(0x1014, 0x4000'0000U + number);
    set(0x1017, 1000 + number);
    set(0x2000, number);
    set_text("set " + std::to_string(number));
    set(0x2100, 2000 + number);
    set(0x6000, 600 + number);
    for (const std::uint16_t index : std::to_array<std::uint16_t>({0x6020, 0x6021})) {
      for (const std::uint8_t sub : std::to_array<std::uint8_t>({1, 2}))
        set(index, 10 * number + sub + index % 2 * 4U, sub);
    }
    set(0xA000, 100 + number);
  }
  using Parameters = std::vector<std::string>;
  Parameters parameters() {
    Parameters all{text()};
    for (const std::uint16_t index :
         std::to_array<std::uint16_t>({0x1014, 0x1017, 0x2000, 0x2100, 0x6000, 0xA000})) {
      all.push_back(std::to_string(get(index)));
    }
    for (const std::uint16_t index : std::to_array<std::uint16_t>({0x6020, 0x6021})) {
      for (const std::uint8_t sub : std::to_array<std::uint8_t>({1, 2}))
        all.push_back(std::to_string(get(index, sub)));
    }
    return all;
  }

 private:
  Error present_[4];
  Emergency waiting_[4];
  std::array<std::uint8_t, 16> buffer_{};

 public:
  EmergencyProducer emergency_producer;
  Storage storage;
  SdoServer sdo_server;
};

}  // namespace canvoy
