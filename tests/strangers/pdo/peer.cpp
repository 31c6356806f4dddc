// A node of ours with PDOs and SYNC, on a bus that is a pair of pipes (pipe_node.hpp).
//
//     echo 000#0105 | canvoy_pdo_peer    # 705#00
#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

constexpr Access process = Access::rw | Access::rpdo | Access::tpdo;

constexpr EntryRow parameter(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow mapped_objects = {
    .sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw};
constexpr EntryRow invalid = parameter(1, DataType::unsigned32, CobId::bit31);

/// Two PDOs in each direction that are to be configured, and process data of all sizes.
constexpr auto layout =
    partial(lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                              {.index = 0x1001, .entry_count = 1},
                                              {.index = 0x1005, .entry_count = 1},
                                              {.index = 0x1006, .entry_count = 1},
                                              {.index = 0x1007, .entry_count = 1},
                                              {.index = 0x1019, .entry_count = 1},
                                              {.index = 0x1400, .count = 2, .entry_count = 3},
                                              {.index = 0x1600, .count = 2, .entry_count = 2},
                                              {.index = 0x1800, .count = 2, .entry_count = 5},
                                              {.index = 0x1A00, .count = 2, .entry_count = 2},
                                              {.index = 0x2000, .entry_count = 1},
                                              {.index = 0x2001, .entry_count = 1},
                                              {.index = 0x2002, .entry_count = 1}}),
                    std::to_array<EntryRow>({
                        {.type = DataType::unsigned32},
                        {.type = DataType::unsigned8},
                        parameter(0, DataType::unsigned32, 0x80),
                        parameter(0, DataType::unsigned32),
                        parameter(0, DataType::unsigned32),
                        parameter(0, DataType::unsigned8),
                        invalid,
                        parameter(2, DataType::unsigned8, 254),
                        parameter(5, DataType::unsigned16),
                        parameter(0, DataType::unsigned8),
                        mapped_objects,
                        invalid,
                        parameter(2, DataType::unsigned8, 254),
                        parameter(3, DataType::unsigned16),
                        parameter(5, DataType::unsigned16),
                        parameter(6, DataType::unsigned8),
                        parameter(0, DataType::unsigned8),
                        mapped_objects,
                        {.type = DataType::unsigned16, .access = process},
                        {.type = DataType::integer8, .access = process},
                        {.type = DataType::unsigned32, .access = process},
                    })));

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::PipeNode<canvoy::DeviceNode<canvoy::layout>>(canvoy::pipe_port, canvoy::NodeId{5}).run();
}
