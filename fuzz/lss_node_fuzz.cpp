// A node with LSS slave and a node with LSS master, under random frames, answers, stores, resets
// and times: each continues to run, sends LSS on its own CAN-ID only, and comes to rest.
#include <array>
#include <span>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {
namespace {

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1018, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 4},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32, .initial = 0x1234}}));

/// A node that may send LSS in one direction only.
class Side {
 public:
  Side(std::uint16_t own_can_id, NodeId id)
      : node(layout.tables(), {values_, states_, routes_, backlog_}, {this, &Side::take, nullptr},
             id),
        own_can_id_(own_can_id) {}

  void settle(Time now) {
    for (int i = 0; node.deadline() <= now; ++i) {
      require(i < 1000);
      node.advance(now);
    }
  }

 private:
  static bool take(void* context, const Frame& frame) {
    const Side& self = *static_cast<Side*>(context);
    const bool is_boot_up = frame.id > can_id::error_control && frame.length == 1;
    require(is_boot_up || (frame.id == self.own_can_id_ && frame.length == 8));
    require(!is_boot_up || is_node_id(self.node.id()));
    return true;
  }

  std::array<std::uint8_t, layout.tables().value_bytes> values_{};
  std::array<ObjectState, layout.tables().objects.size()> states_{};
  std::array<Router::Route, 2> routes_{};
  std::array<Frame, 8> backlog_{};

 public:
  Node node;

 private:
  std::uint16_t own_can_id_;
};

class World {
 public:
  World()
      : slave_side_(can_id::lss_response, node_id_unconfigured),
        master_side_(can_id::lss_request, 1),
        bit_timing_(slave_side_.node, {}),
        slave_(slave_side_.node,
               {.configure_bit_timing =
                    Callback<LssError(std::uint8_t)>::to<&World::configure_bit_timing>(*this),
                .activate_bit_timing = bit_timing_.hook(),
                .store = Callback<void(NodeId, std::uint8_t)>::to<&World::store>(*this),
                .state_entered = {}}),
        master_(master_side_.node),
        scan_(master_side_.node, master_, addresses_) {
    scan_.on_choose(LssScan::Choose::to<&World::choose>(*this));
    slave_side_.node.start(now_);
    master_side_.node.start(now_);
  }

  void step(Input& input) {
    const std::uint8_t what = input.byte();
    Frame frame = Frame::data_frame(what % 2 == 0 ? can_id::lss_request : can_id::lss_response, {});
    switch (what % 16) {
      default:
        frame.length = what % 16 == 15 ? input.byte() % 9 : 8;
        input.fill(frame.data);
        slave_side_.node.receive(frame, now_);
        master_side_.node.receive(frame, now_);
        break;
      case 0:
        pass_time(Duration(input.word()));
        break;
      case 1:
        pass_time(std::chrono::milliseconds(input.word()));
        break;
      case 2:
        slave_.stored({.code = input.byte(), .specific = input.byte()});
        break;
      case 3:
        slave_side_.node.command(static_cast<NmtCommand>(0x81 + input.byte() % 2));
        break;
      case 4:
        scan_.start({.pattern = {}, .store = input.byte() % 2 == 0}, {});
        break;
      case 5:
        scan_.cancel();
        break;
      case 6:
        master_.inquire(input.byte() % 5U, {});
        break;
    }
    slave_side_.settle(now_);
    master_side_.settle(now_);
    require(scan_.found().size() <= addresses_.size());
  }

  /// All time-outs expire, and the slave can be configured.
  void end() {
    slave_.stored({});
    scan_.cancel();
    pass_time(3min);
    require(master_.idle() && !slave_side_.node.transmitter().muted());
    for (const auto& [command, value] : {std::pair{lss::Command::switch_global, 1U},
                                         {lss::Command::configure_node_id, 9U},
                                         {lss::Command::switch_global, 0U}}) {
      slave_side_.node.receive(lss::frame(can_id::lss_request, command, value), now_);
    }
    slave_side_.node.command(NmtCommand::reset_communication);
    require(slave_side_.node.id() == 9);
  }

 private:
  void pass_time(Duration duration) {
    const Time until = now_ + duration;
    for (Side* side : {&slave_side_, &master_side_}) {
      for (int i = 0; side->node.deadline() <= until && i < 500; ++i) {
        side->node.advance(std::max(now_, side->node.deadline()));
      }
    }
    now_ = until;
    slave_side_.settle(now_);
    master_side_.settle(now_);
  }
  LssError configure_bit_timing(std::uint8_t index) {
    return {.code = index == 2 ? std::uint8_t{1} : std::uint8_t{0}};
  }
  void store(NodeId, std::uint8_t) {}
  NodeId choose(const LssAddress& address) {
    return static_cast<NodeId>(address.parts[LssAddress::serial]);
  }

  Time now_{};
  Side slave_side_;
  Side master_side_;
  BitTimingSwitch bit_timing_;
  LssSlave slave_;
  LssMaster master_;
  std::array<LssAddress, 3> addresses_{};
  LssScan scan_;
};

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::World world;
  canvoy::fuzz::Input input(data, size);
  while (!input.empty()) world.step(input);
  world.end();
  return 0;
}
