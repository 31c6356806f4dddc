// A node of ours with heartbeat and emergencies, on a bus that is a pair of pipes (pipe_node.hpp).
// It watches node 1 for 2 s.
//
//     echo 000#8105 | canvoy_nmt_peer    # 705#00 twice
#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

constexpr EntryRow number(DataType type, std::int64_t initial) {
  return {.type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow watched_node = {.sub_first = 1,
                                   .sub_last = 1,
                                   .type = DataType::unsigned32,
                                   .access = Access::rw,
                                   .initial = 0x0001'07D0};

constexpr auto layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1001, .entry_count = 1},
                              {.index = 0x1014, .entry_count = 1},
                              {.index = 0x1016, .entry_count = 2},
                              {.index = 0x1017, .entry_count = 1}}),
    std::to_array<EntryRow>({number(DataType::unsigned32, 0), number(DataType::unsigned8, 0),
                             number(DataType::unsigned32, 0x85), number(DataType::unsigned8, 1),
                             watched_node, number(DataType::unsigned16, 0)})));

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::PipeNode<canvoy::DeviceNode<canvoy::layout>>(canvoy::pipe_port, canvoy::NodeId{5}).run();
}
