// Writes a list of values into another node by SDO, one after the other: the setup of a device by a
// host after its boot-up, before its start.
//
//     NodeSetup setup(node, 10, {{0x1017, 0, 200, 2}, {0x6423, 0, 1, 1}});
//     setup.on_done(Callback<void(NodeId, bool)>::to<&Host::is_set_up>(host));
//     setup.begin();
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::excavator {

/// A value to write by SDO.
struct SetupWrite {
  std::uint16_t index = 0;      ///< of the object
  std::uint8_t sub = 0;         ///< of the entry
  std::uint32_t value = 0;      ///< little endian in as many bytes as stated
  std::uint8_t bytes = 4;       ///< 1 to 4
  bool may_be_missing = false;  ///< true: a device without this object is set up without it
};

class NodeSetup {
 public:
  /// `node` must outlive this object; `server` is the node-ID to write to, by its default SDO.
  NodeSetup(Node& node, NodeId server, std::vector<SetupWrite> writes)
      : client_(node), server_(server), writes_(std::move(writes)) {}
  NodeSetup(const NodeSetup&) = delete;
  NodeSetup& operator=(const NodeSetup&) = delete;

  /// Sets the function that is called when all is written, or when a write is refused or not
  /// answered.
  void on_done(Callback<void(NodeId, bool)> done) { done_ = done; }
  /// Starts from the first value, even while it is under way.
  void begin();
  /// Ends it without a report.
  void stop();
  /// True from begin() until its report.
  bool busy() const { return client_.busy(); }

 private:
  void write();
  void written(SdoClient::Outcome outcome);

  SdoClient client_;
  NodeId server_;
  std::vector<SetupWrite> writes_;
  std::size_t place_ = 0;
  unsigned tries_left_ = 0;
  std::array<std::uint8_t, 4> buffer_{};
  Callback<void(NodeId, bool)> done_;
};

}  // namespace canvoy::excavator
