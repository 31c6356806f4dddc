// A node with two program slots in a simulated flash, and requests of a client.
//
//     ProgramNode sut(memory);
//     sut.ask("2F 51 1F 01 03 00 00 00", "60 51 1F 01 00 00 00 00");
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

inline constexpr EntryRow programs_row{.access = Access::const_, .initial = 2};
inline constexpr EntryRow program_row(DataType type, Access access) {
  return {.sub_first = 1, .sub_last = 2, .type = type, .access = access};
}
inline constexpr auto program_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1F50, .entry_count = 2},
                                      {.index = 0x1F51, .entry_count = 2},
                                      {.index = 0x1F52, .entry_count = 2},
                                      {.index = 0x1F56, .entry_count = 2},
                                      {.index = 0x1F57, .entry_count = 2}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::const_, .initial = 0x0002'01A2},
                 programs_row,
                 program_row(DataType::domain, Access::wo),
                 programs_row,
                 program_row(DataType::unsigned8, Access::rw),
                 programs_row,
                 program_row(DataType::unsigned32, Access::rw),
                 programs_row,
                 program_row(DataType::unsigned32, Access::ro),
                 programs_row,
                 program_row(DataType::unsigned32, Access::ro)}));

/// Two slots of 256 bytes, of which 224 are for the program.
inline constexpr SimulatedFlash::Geometry program_geometry{
    .sector_size = 128, .sectors = 4, .unit = 8};

class ProgramNode : public WireNode {
 public:
  explicit ProgramNode(SimulatedFlash& memory, NodeId id = 5)
      : WireNode(program_layout.tables(), id),
        slots{{{.address = 0, .size = 256}, {.address = 256, .size = 256}}},
        programs(node, memory.flash, slots,
                 {.control = callback<&ProgramNode::control>(*this),
                  .check = callback<&ProgramNode::check>(*this),
                  .under_way = callback<&ProgramNode::under_way>(*this)}),
        server_(node, 0, buffer_),
        blocks_(server_) {
    boot();
  }

  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    receive("605#" + request);
    expect({"585#" + answer});
  }
  /// Writes to 1F51h.
  void command(unsigned number, unsigned command, bool expected = true) {
    const std::string object = "51 1F 0" + std::to_string(number);
    ask("2F " + object + " 0" + std::to_string(command) + " 00 00 00",
        expected ? "60 " + object + " 00 00 00 00" : "80 " + object + " 22 00 00 08");
  }
  /// Downloads a program in segments; returns the command byte of the last answer, or 80h.
  unsigned download(const std::vector<std::uint8_t>& program, unsigned number = 1) {
    Frame request = wire_frame("605#21 50 1F 00 00 00 00 00");
    request.data[3] = static_cast<std::uint8_t>(number);
    request.data[4] = static_cast<std::uint8_t>(program.size());
    request.data[5] = static_cast<std::uint8_t>(program.size() >> 8);
    unsigned answer = exchange(request);
    std::size_t at = 0;
    for (unsigned toggle = 0; answer != 0x80; toggle ^= 0x10) {
      const std::size_t size = std::min<std::size_t>(7, program.size() - at);
      const bool last = at + size == program.size();
      Frame segment = wire_frame("605#00 00 00 00 00 00 00 00");
      segment.data[0] = static_cast<std::uint8_t>(toggle | (7 - size) << 1 | (last ? 1U : 0U));
      std::copy_n(program.begin() + static_cast<std::ptrdiff_t>(at), size,
                  segment.data.begin() + 1);
      at += size;
      answer = exchange(segment);
      if (last) break;
    }
    return answer;
  }
  std::uint64_t get(std::uint16_t index, std::uint8_t sub = 1) {
    return node.dictionary().number(index, sub);
  }

  std::array<ProgramSlot, 2> slots;
  ProgramServer programs;
  std::vector<std::string> log;  ///< commands to the device
  AbortCode control_answer = AbortCode::none;
  FlashError check_answer = FlashError::none;

 private:
  unsigned exchange(const Frame& request) {
    node.receive(request, now);
    settle();
    const unsigned answer = sent.empty() ? 0U : sent.back().frame.data[0];
    last_answer = sent.empty() ? "" : wire_text(sent.back().frame);
    sent.clear();
    return answer;
  }
  AbortCode control(std::uint8_t number, ProgramCommand command) {
    constexpr const char* names[] = {"stop", "start", "reset", "clear"};
    log.push_back(std::string(names[static_cast<unsigned>(command)]) + " " +
                  std::to_string(number));
    return control_answer;
  }
  FlashError check(std::uint8_t, const ProgramSlot&) { return check_answer; }
  void under_way(bool is) { log.emplace_back(is ? "begin" : "end"); }

  std::array<std::uint8_t, 16> buffer_{};
  SdoServer server_;
  SdoBlockServer blocks_;

 public:
  std::string last_answer;  ///< of download()
};

}  // namespace canvoy
