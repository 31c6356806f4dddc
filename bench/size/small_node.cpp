// A small node, whole, to tell what the application layer costs: SDO server, four RPDOs and four
// TPDOs of eight mapped values each, SYNC, heartbeat, emergency with history.
#include "canvoy/canopen/device_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/layout.hpp"

using namespace canvoy;

namespace {

constexpr auto description =
    describe(cia301::device_type(0x0000'0191), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::sync(), cia301::error_history(8),
             cia301::emergency(), cia301::heartbeat_producer(1000),
             cia301::rpdo({.number = 1, .entries = 8}), cia301::rpdo({.number = 2}),
             cia301::rpdo({.number = 3}), cia301::rpdo({.number = 4}), cia301::tpdo({.number = 1}),
             cia301::tpdo({.number = 2}), cia301::tpdo({.number = 3}), cia301::tpdo({.number = 4}));
constexpr auto node_tables = lay_out_device<description>();

}  // namespace

/// Not linked: the report looks at its size.
extern const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes;
const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes{};

extern "C" {
bool board_send(void*, const Frame&);
bool board_receive(Frame*);
std::int64_t board_time();
}

alignas(8) std::uint8_t memory[sizeof(DeviceNode<node_tables>)];

int main() {
  auto* device = new (memory) DeviceNode<node_tables>({nullptr, board_send, nullptr}, 5);
  Node& node = device->node();
  node.start(Time(Duration(board_time())));
  for (;;) {
    Frame frame;
    const Time now(Duration{board_time()});
    if (board_receive(&frame)) node.receive(frame, now);
    if (node.deadline() <= now) node.advance(now);
  }
}
