// An NMT slave that the test plays for a master: it boots, answers SDO requests about itself,
// accepts writes, and records NMT commands.
//
//     SlavePartner slave(bench);
//     slave.boot_up();
//     if (!slave.wait_for(NmtCommand::start, 5s)) return failed("it is not started");
#pragma once

#include <map>
#include <vector>

#include "canvoy/text/check/bench/bench.hpp"

namespace canvoy::conformance {

class SlavePartner {
 public:
  /// A write by a client.
  struct Written {
    /// Index of the entry.
    std::uint16_t index = 0;
    /// Sub-index of the entry.
    std::uint8_t sub = 0;
    Bytes value = {};  ///< 1 to 4 bytes
    /// True for equal entries and values.
    friend bool operator==(const Written&, const Written&) = default;
  };

  /// Starts the played node. It has 1000h and 1018h.
  explicit SlavePartner(Bench& bench);
  ~SlavePartner();
  SlavePartner(const SlavePartner&) = delete;
  SlavePartner& operator=(const SlavePartner&) = delete;

  static constexpr std::uint32_t device_type = 0x0001'0191;  ///< value of 1000h
  static constexpr std::uint32_t vendor = 0x0000'02F0;       ///< value of 1018h:01h

  /// Node-ID of the slave.
  NodeId node() const { return node_; }
  /// Sends a boot-up message.
  void boot_up();
  /// True if 1000h was read.
  bool was_identified() const { return was_identified_; }
  /// Writes in their order; all are accepted.
  const std::vector<Written>& written() const { return written_; }
  /// NMT commands to the slave, or to all nodes, since its start.
  const std::vector<NmtCommand>& commands() const { return commands_; }
  /// True if this command has come, or comes in time.
  bool wait_for(NmtCommand command, Duration time);

 private:
  void hear(const Frame& frame);
  void answer(const Frame& request);
  void reply(std::uint8_t command, const Frame& request, std::uint32_t value);

  Bench& bench_;
  NodeId node_;
  Player player_;
  std::map<std::uint32_t, std::uint32_t> values_;  ///< by index and sub-index
  std::vector<Written> written_;
  std::vector<NmtCommand> commands_;
  bool was_identified_ = false;
};

}  // namespace canvoy::conformance
