// Arbitrary frames and times to an NMT master that boots a network, may be a flying master, and
// takes requests by SDO. It comes to rest, commands only permitted nodes, and continues to boot.
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/flying_master.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/master.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {
namespace {

constexpr NodeId master_id = 127;

constexpr auto device =
    describe(cia301::device_type(0), cia301::error_register_object, cia301::identity({}),
             cia301::heartbeat_consumers(4), cia301::heartbeat_producer(0), cia302::nmt_master(),
             cia302::flying_master(1));
constexpr auto layout = lay_out_device<device>();

class World {
 public:
  explicit World(Input& input)
      : master_({this, &World::take, nullptr}, master_id, {.hooks = hooks()}),
        flying_(master_.node(), master_.commands(), master_.boot_manager()) {
    stored_.reset = Callback<void(ResetScope)>::to<&World::restore>(*this);
    master_.node().attach(stored_);
    startup_ = input.byte();
    for (std::uint32_t& assignment : assignments_) assignment = input.word() & 0x01FF'FFFFU;
    master_.node().start(now_);
    settle();
  }

  void step(Input& input) {
    const std::uint8_t what = input.byte();
    switch (what % 8) {
      case 0:
        receive(arbitrary_frame(input));
        break;
      case 1:
      case 2:
      case 3:
        receive(likely_frame(input));
        break;
      case 4:
      case 5:
        pass_time(std::chrono::milliseconds(input.byte() * (1 + what / 8)));
        break;
      case 6:
        end_task(what / 8, input.byte());
        break;
      default:
        disturb(what / 8, input);
        break;
    }
    settle();
  }

 private:
  BootHooks hooks() {
    return {.update_program = Callback<void(const BootTask&)>::to<&World::update>(*this),
            .update_configuration = Callback<void(const BootTask&)>::to<&World::update>(*this),
            .abandon = Callback<void(NodeId)>::to<&World::abandon>(*this)};
  }
  void update(const BootTask& task) {
    require(is_node_id(task.slave) && !task.client->busy());
    require(tasks_.at(task.slave).slave == 0);
    tasks_.at(task.slave) = task;
  }
  void abandon(NodeId slave) {
    require(tasks_.at(slave).slave == slave);
    tasks_.at(slave) = {};
    restarts_.at(slave).is_under_way = false;
  }
  void end_task(unsigned slave, std::uint8_t code) {
    BootTask& place = tasks_.at(1 + slave % slaves_max);
    if (place.slave == 0 || restarts_.at(place.slave).is_under_way) return;
    if (code % 16 == 1) return restart(place, code);
    const BootTask task = place;
    place = {};
    const auto error = static_cast<BootError>(code % 4 == 0 ? 'G' + code / 4 % 4 : 0);
    task.done({error, code % 8 == 0 ? SdoEnd::no_answer() : SdoEnd()});
  }

  /// Notified once of each restart, unless its task was abandoned.
  struct Restart {
    void ended(AbortCode answer) {
      require(is_under_way);
      require(answer == AbortCode::none || answer == AbortCode::time_out ||
              answer == AbortCode::out_of_memory);
      is_under_way = false;
    }
    bool is_under_way = false;
  };
  void restart(const BootTask& task, std::uint8_t code) {
    Restart& restart = restarts_.at(task.slave);
    restart.is_under_way = true;
    task.restart(code / 16 % 2 == 0 ? NmtCommand::reset_node : NmtCommand::reset_communication,
                 Callback<void(AbortCode)>::to<&Restart::ended>(restart));
  }

  void restore(ResetScope) {
    Dictionary& dictionary = master_.dictionary();
    dictionary.set_number(0x1F80, 0, startup_);
    dictionary.set_number(0x1F89, 0, 3000);
    for (std::uint8_t slave = 1; slave <= slaves_max; ++slave) {
      dictionary.set_number(0x1F81, slave, assignments_.at(slave - 1U));
      if (slave % 2 == 0) dictionary.set_number(0x1016, slave, std::uint32_t{slave} << 16 | 200U);
    }
  }

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    require(frame.id <= Frame::id_max && frame.length <= Frame::length_max);
    require(!frame.is_extended() && !frame.is_error());
    if (frame.id == can_id::nmt) require(frame.length == 2 && frame.data[1] <= node_id_max);
    return !self.full_;
  }

  static Frame arbitrary_frame(Input& input) {
    Frame frame;
    frame.id = input.word() & Frame::id_max;
    const std::uint8_t shape = input.byte();
    frame.length = shape % 16 <= 8 ? shape % 16 : 8;
    if ((shape & 0x70) == 0x10) frame.flags = FrameFlags::remote;
    if (!frame.is_remote()) input.fill(std::span(frame.data).first(frame.length));
    return frame;
  }

  /// A message of a slave, of another master, or of a client with a request.
  static Frame likely_frame(Input& input) {
    const std::uint8_t choice = input.byte();
    const std::uint32_t slave = 1 + choice / 8 % slaves_max;
    switch (choice % 8) {
      case 0:
        return Frame::data_frame(0x700 + slave, {0x00});
      case 1:
        return Frame::data_frame(0x700 + slave, {0x7F});
      case 2:
        return Frame::data_frame(0x700 + slave, {input.byte()});
      case 3:
        return Frame::data_frame(0x580 + slave, {0x43, 0x00, 0x10, 0x00, 0, 0, 0, 0});
      case 4:
        return Frame::data_frame(0x67F,
                                 {0x2F, input.byte(), 0x1F, input.byte(), input.byte(), 0, 0, 0});
      case 5: {
        const std::uint32_t id = 0x071 + input.byte() % 6U;
        return id == 0x071 ? Frame::data_frame(id, {input.byte(), input.byte()})
                           : Frame::data_frame(id, {});
      }
      case 6:
        return Frame::data_frame(0x000, {input.byte(), 0});
      default:
        return Frame::data_frame(0x580 + slave, {0x80, input.byte(), 0x10, 0, 0, 0, 2, 6});
    }
  }

  void receive(const Frame& frame) { master_.node().receive(frame, now_); }

  void disturb(unsigned what, Input& input) {
    switch (what % 4) {
      case 0:
        full_ = true;
        return;
      case 1:
        return master_.boot_manager().guarding_lost(
            static_cast<NodeId>(1 + input.byte() % slaves_max));
      case 2:
        return master_.node().raise({.code = 0x8130, .instance = input.byte()});
      default:
        full_ = false;
        return master_.node().tx_ready(now_);
    }
  }

  void pass_time(Duration duration) {
    const Time until = now_ + duration;
    for (int i = 0; i < 200 && master_.node().deadline() <= until; ++i) {
      now_ = std::max(now_, master_.node().deadline());
      master_.node().advance(now_);
    }
    now_ = until;
    master_.node().advance(now_);
  }
  void settle() {
    for (int i = 0; master_.node().deadline() <= now_; ++i) {
      require(i < 1000);
      master_.node().advance(now_);
    }
    // A node with a task is being booted.
    for (const BootTask& task : tasks_) {
      if (task.slave == 0) continue;
      require(master_.boot_manager().slave_state(task.slave) == BootManager::SlaveState::booting);
    }
  }

  static constexpr std::uint8_t slaves_max = 4;

  Time now_{};
  bool full_ = false;
  std::uint8_t startup_ = 0;
  std::array<std::uint32_t, slaves_max> assignments_{};
  std::array<BootTask, node_id_max + 1> tasks_{};
  std::array<Restart, node_id_max + 1> restarts_{};
  Service stored_;
  MasterNode<layout, MasterSize{.slots = 2, .guarded = 2, .own_routes = 6}> master_;
  FlyingMaster flying_;
};

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  canvoy::fuzz::World world(input);
  while (!input.empty()) world.step(input);
  return 0;
}
