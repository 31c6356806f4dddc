// A node with an LSS slave, an identity, and a heartbeat producer, for tests.
//
//     LssNode node(node_id_unconfigured);
//     node.start();
//     node.receive("7E5#04 01");  // padded to eight bytes
//     node.answers({"7E4#5A 04 03 02 01"});
#pragma once

#include <utility>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/nmt/heartbeat_producer.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

inline constexpr auto lss_layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1014, .entry_count = 1},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x1018, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned32},
         {.type = DataType::unsigned32, .traits = EntryTraits::plus_node_id, .initial = 0x80},
         {.type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 4},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32}}));

/// Vendor-ID 01020304h, product code 11121314h, revision 21222324h, serial number 31323334h.
inline constexpr LssAddress lss_address{{0x0102'0304, 0x1112'1314, 0x2122'2324, 0x3132'3334}};

/// A frame of LSS in the wire language, optionally with a time, padded to eight bytes with zeros.
inline std::string lss_frame(std::string_view text) {
  if (text.starts_with('@')) {
    const auto blank = text.find(' ') + 1;
    return std::string(text.substr(0, blank)) + lss_frame(text.substr(blank));
  }
  Frame frame = wire_frame(text);
  if (frame.id == can_id::lss_request || frame.id == can_id::lss_response) frame.length = 8;
  return wire_text(frame);
}

/// Records the calls of the slave to the application.
struct LssApplication {
  LssSlaveHooks hooks() {
    return {.configure_bit_timing = callback<&LssApplication::check>(*this),
            .activate_bit_timing = callback<&LssApplication::activate>(*this),
            .store = callback<&LssApplication::store>(*this),
            .state_entered = callback<&LssApplication::entered>(*this)};
  }
  std::vector<std::string> take() { return std::exchange(log, {}); }

  LssError answer_to_bit_timing;
  BitTimingSwitch* bit_timing = nullptr;
  std::vector<std::string> log;

 private:
  LssError check(std::uint8_t index) {
    log.push_back("check " + std::to_string(index));
    return answer_to_bit_timing;
  }
  void activate(std::uint8_t index, Duration delay) {
    log.push_back("activate " + std::to_string(index) + " in " + std::to_string(delay.count()) +
                  " us");
    if (bit_timing != nullptr) bit_timing->activate(index, delay);
  }
  void store(NodeId id, std::uint8_t index) {
    log.push_back("store " + std::to_string(id) + ", " + std::to_string(index));
  }
  void entered(LssState state) {
    log.push_back(state == LssState::waiting ? "waiting" : "configuration");
  }
};

class LssNode : public WireNode {
 public:
  explicit LssNode(NodeId id, const LssAddress& address = lss_address, bool with_hooks = true,
                   std::uint8_t present = bit_timing)
      : WireNode(lss_layout.tables(), id),
        lss(node, with_hooks ? application.hooks() : LssSlaveHooks{}, present),
        heartbeat_(node),
        address_(address) {
    identity_.reset = callback<&LssNode::set_identity>(*this);
    node.attach(identity_);
  }

  void receive(std::string_view frame) { WireNode::receive(lss_frame(frame)); }
  void receive_all(const std::vector<std::string>& frames) {
    for (const std::string& frame : frames) receive(frame);
  }
  /// Like expect(), but with frames of LSS padded.
  void answers(const std::vector<std::string>& frames) {
    std::vector<std::string> filled;
    for (const std::string& frame : frames) filled.push_back(lss_frame(frame));
    expect(filled);
  }
  /// Starts the node and discards its boot-up message.
  LssNode& up() {
    boot();
    return *this;
  }
  /// Puts the node into state configuration, with all frames discarded.
  LssNode& in_configuration() {
    boot();
    receive("7E5#04 01");
    sent.clear();
    application.log.clear();
    return *this;
  }

  static constexpr std::uint8_t bit_timing = 4;  ///< 125 kbit/s
  LssApplication application;
  LssSlave lss;

 private:
  void set_identity(ResetScope) {
    for (std::size_t part = 0; part < 4; ++part) {
      node.dictionary().set_number(0x1018, static_cast<std::uint8_t>(part + 1),
                                   address_.parts[part]);
    }
  }

  HeartbeatProducer heartbeat_;
  LssAddress address_;
  Service identity_;
};

}  // namespace canvoy
