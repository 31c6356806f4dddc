// The three parties of a dynamic SDO connection, for tests: the dictionaries of an SDO manager, of
// a device that requests connections, and of a server.
//
//     WireNode manager(dynamic_sdo_manager(), 1);
//     RequestingNode device(cable.port(1), 5);
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/canopen/manager/sdo_requester.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

namespace detail {

constexpr EntryRow u32_row(std::uint8_t first, std::uint8_t last, Access access,
                           std::int64_t initial) {
  return {.sub_first = first,
          .sub_last = last,
          .type = DataType::unsigned32,
          .access = access,
          .initial = initial};
}
constexpr EntryRow channel_ids = u32_row(1, 2, Access::rw, 0x8000'0000);
constexpr EntryRow channel_peer = {.sub_first = 3, .sub_last = 3, .access = Access::rw};
constexpr EntryRow highest(std::int64_t sub) {
  return {.access = Access::const_, .initial = sub};
}

inline constexpr auto dynamic_sdo_manager_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1201, .count = 2, .entry_count = 3},
                                      {.index = 0x1F00, .count = 2, .entry_count = 1},
                                      {.index = 0x1F02, .entry_count = 7},
                                      {.index = 0x1F03, .entry_count = 2}}),
            std::to_array<EntryRow>(
                {highest(3), channel_ids, channel_peer, u32_row(0, 0, Access::wo, 0), highest(6),
                 u32_row(1, 1, Access::rw, 0x680), u32_row(2, 2, Access::rw, 0x681),
                 u32_row(3, 3, Access::rw, 0x682), u32_row(4, 4, Access::rw, 0x683),
                 u32_row(5, 5, Access::rw, 0x684), u32_row(6, 6, Access::rw, 0x8000'0000),
                 highest(8), u32_row(1, 8, Access::ro, 0)}));
inline constexpr auto requesting_layout = lay_out(
    std::to_array<ObjectRow>(
        {{.index = 0x1280, .count = 3, .entry_count = 3}, {.index = 0x1F10, .entry_count = 1}}),
    std::to_array<EntryRow>({highest(3), channel_ids, channel_peer, u32_row(0, 0, Access::rw, 0)}));
inline constexpr auto serving_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1201, .count = 2, .entry_count = 3},
                                      {.index = 0x2000, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {highest(3), channel_ids, channel_peer, u32_row(0, 0, Access::rw, 0x1234'5678)}));

}  // namespace detail

/// Has COB-IDs 680h to 684h: enough for two connections, and one left over; two servers for
/// devices.
inline DictionaryTables dynamic_sdo_manager() {
  return detail::dynamic_sdo_manager_layout.tables();
}

/// A node on a port, with memory from the heap.
class PortNode : private WireMemory {
 public:
  PortNode(const DictionaryTables& tables, const Port& port, NodeId id)
      : WireMemory(tables), tables_(tables), node(tables_, spans(), port, id) {}

 private:
  DictionaryTables tables_;

 public:
  Node node;
};

struct ManagingNode : PortNode {
  ManagingNode(const Port& port, NodeId id) : PortNode(dynamic_sdo_manager(), port, id) {}

  SdoServer servers[3] = {SdoServer(node, 0, {}), SdoServer(node, 1, {}), SdoServer(node, 2, {})};
  std::array<SdoConnection, 8> connections;
  SdoManager manager{node, connections, {}};
};

struct RequestingNode : PortNode {
  RequestingNode(const Port& port, NodeId id)
      : PortNode(detail::requesting_layout.tables(), port, id) {}
  AbortCode connect(NodeId partner, std::uint8_t number) {
    return requester.connect(partner, number, SdoRequester::Done::to<&RequestingNode::done>(*this));
  }
  void done(SdoEnd end) { answers.push_back(end); }

  SdoServer server{node, 0, {}};
  SdoClient clients[3] = {SdoClient(node, 0), SdoClient(node, 1), SdoClient(node, 2)};
  SdoRequester requester{node, {}};
  std::vector<SdoEnd> answers;
};

struct ServingNode : PortNode {
  ServingNode(const Port& port, NodeId id) : PortNode(detail::serving_layout.tables(), port, id) {}
  SdoServer servers[3] = {SdoServer(node, 0, {}), SdoServer(node, 1, {}), SdoServer(node, 2, {})};
};

}  // namespace canvoy
