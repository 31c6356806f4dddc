// Arbitrary frames at arbitrary times, a controller that is full, passive or bus-off, and an
// application with arbitrary permitted calls, for a node with all services.
//
// Beside what the sanitizers detect: each frame that the node sends is well-formed and allowed in
// its NMT state, the node comes to rest, and 1001h gives the present errors.
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/nmt/error_behaviour.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/nmt/heartbeat_producer.hpp"
#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/sync/high_resolution_time.hpp"
#include "canvoy/canopen/sync/sync.hpp"
#include "canvoy/canopen/sync/time_stamp.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_objects.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {
namespace {

constexpr NodeId own_id = 5;
constexpr NodeId other_id = 7;

/// A domain of 50 bytes that refuses to grow.
class ScratchDomain {
 public:
  explicit ScratchDomain(Dictionary& dictionary) {
    using Self = ScratchDomain;
    domain_.open_read = Callback<Result<std::uint32_t>(const Entry&)>::to<&Self::open_read>(*this);
    domain_.read = Callback<Result<std::size_t>(const Entry&, std::uint32_t,
                                                std::span<std::uint8_t>)>::to<&Self::read>(*this);
    domain_.open_write =
        Callback<AbortCode(const Entry&, std::uint32_t)>::to<&Self::open_write>(*this);
    domain_.write =
        Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&Self::write>(*this);
    hook_.first = hook_.last = 0x2007;
    hook_.domain = &domain_;
    dictionary.attach(hook_);
  }

 private:
  Result<std::uint32_t> open_read(const Entry&) { return size_; }
  Result<std::size_t> read(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    require(offset + bytes.size() <= size_);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = bytes_.at(offset + i);
    return bytes.size();
  }
  AbortCode open_write(const Entry&, std::uint32_t) {
    size_ = 0;
    return AbortCode::none;
  }
  AbortCode write(const Entry&, std::span<const std::uint8_t> bytes) {
    if (size_ + bytes.size() > bytes_.size()) return AbortCode::out_of_memory;
    for (const std::uint8_t byte : bytes) bytes_.at(size_++) = byte;
    return AbortCode::none;
  }

  std::array<std::uint8_t, 50> bytes_{};
  std::uint32_t size_ = 30;
  Domain domain_;
  Hook hook_;
};

/// The node, its bus and its application.
class World {
 public:
  World()
      : node_(tables_, {values_, states_, routes_, backlog_}, {this, &World::take, &World::accept},
              own_id),
        default_server_(node_, 0, default_buffer_),
        second_server_(node_, 1, second_buffer_),
        emergency_producer_(node_, present_, waiting_),
        error_behaviour_(node_),
        heartbeat_producer_(node_),
        heartbeat_consumer_(node_, heartbeat_slots_),
        guarding_slave_(node_),
        guarding_master_(node_, guarding_slots_),
        time_stamp_(node_),
        sync_(node_),
        high_resolution_time_(node_, &sync_),
        rpdos_(node_, rpdo_memory_, rpdo_values_, &sync_),
        tpdos_(node_, tpdo_memory_, tpdo_values_, &sync_),
        client_(node_),
        channel_client_(node_, std::uint8_t{0}),
        emergency_consumer_(node_, emergency_slots_),
        master_(node_, remote_nodes_),
        domain_(node_.dictionary()) {
    rpdos_.received = Callback<void(std::uint16_t)>::to<&World::rpdo_received>(*this);
    heartbeat_consumer_.on_change(
        Callback<void(NodeId, RemoteState)>::to<&World::remote_changed>(*this));
    guarding_master_.on_change(
        Callback<void(NodeId, RemoteState)>::to<&World::remote_changed>(*this));
    master_.on_change(Callback<void(NodeId, RemoteState)>::to<&World::remote_changed>(*this));
    node_.start(now_);
  }

  void step(Input& input) {
    const std::uint8_t what = input.byte();
    switch (what % 8) {
      case 0:
      case 1:
        receive(arbitrary_frame(input));
        break;
      case 2:
        receive(likely_frame(input));
        break;
      case 3:
        receive(sdo_write(input));
        break;
      case 4:
        pass_time(Duration(std::int64_t{input.word()} << what / 8 % 16));
        break;
      case 5:
        disturb(what / 8, input);
        break;
      case 6:
        act(what / 8, input);
        break;
      default:
        ask(what / 8, input);
        break;
    }
    settle();
  }

 private:
  // The bus

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    self.check(frame);
    return !self.full_;
  }

  static void accept(void* context, std::uint16_t id, bool wanted) {
    static_cast<World*>(context)->wanted_.at(id) = wanted;
  }

  void check(const Frame& frame) {
    require(frame.id <= Frame::id_max && frame.length <= Frame::length_max);
    require(!frame.is_extended() && !frame.is_error());
    const std::size_t used = frame.is_remote() ? 0 : frame.length;
    for (std::size_t i = used; i < Frame::length_max; ++i) require(frame.data.at(i) == 0);
    if (waited_) return;  // it may belong to an earlier state
    const bool error_control = frame.id == std::uint32_t{can_id::error_control} + own_id;
    // An answer to node guarding has a toggle bit.
    if (error_control) require(frame.length == 1 && (frame.data[0] & 0x7F) == state_byte());
    const bool guards = frame.is_remote() && frame.id > can_id::error_control;
    const bool command = frame.id == can_id::nmt;
    if (node_.state() == NmtState::initialisation) require(error_control);
    if (node_.state() == NmtState::stopped) require(error_control || command || guards);
  }
  std::uint8_t state_byte() const { return static_cast<std::uint8_t>(node_.state()); }

  void receive(const Frame& frame) {
    const bool filtered = frame.is_extended() || frame.is_error() || !wanted_.at(frame.id);
    const Node::Counters before = node_.counters();
    node_.receive(frame, now_);
    const Node::Counters& after = node_.counters();
    const bool refused = after.unwanted + after.extended != before.unwanted + before.extended;
    require(refused || !filtered);
  }

  static Frame arbitrary_frame(Input& input) {
    Frame frame;
    const std::uint16_t id = input.word();
    frame.id = id & Frame::id_max;
    const std::uint8_t shape = input.byte();
    frame.length = shape % 16 <= 8 ? shape % 16 : 8;
    if ((shape & 0x10) != 0) frame.flags = frame.flags | FrameFlags::remote;
    if ((shape & 0xE0) == 0x20) frame.flags = frame.flags | FrameFlags::extended;
    if ((shape & 0xE0) == 0x40) frame.flags = frame.flags | FrameFlags::error;
    if (!frame.is_remote()) input.fill(std::span(frame.data).first(frame.length));
    return frame;
  }

  /// A frame that some service waits for, of at most 8 bytes.
  static Frame likely_frame(Input& input) {
    constexpr std::array<std::uint16_t, 14> ids = {0x000, 0x080, 0x087, 0x185, 0x205, 0x587, 0x605,
                                                   0x607, 0x640, 0x707, 0x708, 0x77F, 0x100, 0x705};
    const std::uint8_t choice = input.byte();
    Frame frame = Frame::data_frame(ids.at(choice % ids.size()), {});
    const unsigned shorter = choice / ids.size();
    frame.length = static_cast<std::uint8_t>(shorter > 8 ? 8 : 8 - shorter % 9);
    if (frame.id == 0x705) {
      frame.flags = FrameFlags::remote;
    } else {
      input.fill(std::span(frame.data).first(frame.length));
    }
    return frame;
  }

  /// A mappable entry, including dummies, or nearly one.
  static std::uint32_t likely_mapping(std::uint8_t choice) {
    constexpr std::array<std::uint32_t, 14> values = {
        0x2000'0108, 0x2000'0808, 0x2001'0110, 0x2002'0010, 0x2003'0040, 0x2004'0018, 0x2005'0001,
        0x2006'0008, 0x2008'0020, 0x2009'0008, 0x1001'0008, 0x1000'0020, 0x0005'0008, 0x0001'0001};
    return values.at(choice % values.size());
  }

  /// An expedited download to an entry that exists.
  Frame sdo_write(Input& input) {
    const ObjectRow& object = tables_.objects[input.byte() % tables_.objects.size()];
    const EntryShape& entry =
        tables_.entries[object.entry_first + input.byte() % object.entry_count];
    const unsigned index = object.index + input.byte() % 2U * (object.count - 1U);
    const unsigned length = byte_length(entry.type) % 5 == 0 ? 4 : byte_length(entry.type) % 5;
    Frame frame = Frame::data_frame(can_id::sdo_request + std::uint32_t{own_id}, {});
    frame.length = 8;
    frame.data[0] = static_cast<std::uint8_t>(0x23 | (4 - length) << 2);
    store(&frame.data[1], static_cast<std::uint16_t>(index));
    const unsigned subs = entry.sub_last - entry.sub_first + 1U;
    frame.data[3] = static_cast<std::uint8_t>(entry.sub_first + input.byte() % subs);
    input.fill(std::span(frame.data).subspan(4, length));
    const bool maps = (index == 0x1600 || index == 0x1A00) && frame.data[3] != 0;
    if (maps && frame.data[7] == 0) store(&frame.data[4], likely_mapping(frame.data[4]));
    return frame;
  }

  void disturb(unsigned what, Input& input) {
    switch (what % 4) {
      case 0:
        return node_.bus_state(static_cast<BusState>(input.byte() % 4), now_);
      case 1:
        return node_.overrun(now_);
      case 2:
        full_ = waited_ = true;
        return;
      default:
        full_ = false;
        node_.tx_ready(now_);
        waited_ = !node_.transmitter().idle();
        return;
    }
  }

  // Time

  /// Some calls at their deadlines, then a late one.
  void pass_time(Duration duration) {
    const Time until = now_ + duration;
    for (int i = 0; i < 50 && node_.deadline() <= until; ++i) {
      now_ = std::max(now_, node_.deadline());
      node_.advance(now_);
    }
    now_ = until;
    node_.advance(now_);
  }

  void settle() {
    for (int i = 0; node_.deadline() <= now_; ++i) {
      require(i < 1000);
      node_.advance(now_);
    }
    std::uint8_t bits = 0;
    for (const Error& error : emergency_producer_.present()) {
      bits = static_cast<std::uint8_t>(bits | error.register_bits | error_register::generic);
    }
    require(node_.dictionary().number(0x1001, 0) == bits);
  }

  // The application

  void act(unsigned what, Input& input) {
    const std::uint8_t argument = input.byte();
    const auto number = static_cast<std::uint16_t>(1 + argument % 2);
    const Error error{.code = static_cast<std::uint16_t>(0x5000 + argument % 16),
                      .instance = static_cast<std::uint16_t>(argument / 128),
                      .register_bits = argument};
    const auto command = static_cast<NmtCommand>(input.byte());
    switch (what % 15) {
      case 0:
        return node_.raise(error);
      case 1:
        return node_.clear(error);
      case 2:
        return error_behaviour_.device_failure(argument);
      case 3:
        node_.dictionary().set_number(0x2001, 1 + argument % 4, input.word());
        return;
      case 4:
        tpdos_.trigger(number);
        return;
      case 5:
        rpdos_.request(number);
        return;
      case 6:
        master_.command(argument, command);
        return;
      case 7:
        return master_.set_time_out(argument, Duration(input.word()));
      case 8:
        emergency_consumer_.listen(argument, input.word());
        return;
      case 9:
        return emergency_consumer_.ignore(argument);
      case 10:
        guarding_master_.guard(argument, Duration(input.word()), input.byte());
        return;
      case 11:
        guarding_master_.release(argument);
        return guarding_master_.expect(static_cast<NodeId>(argument ^ 1), NmtState::operational);
      case 12:
        time_stamp_.set_clock({.milliseconds = input.word() * 1400U, .days = input.word()});
        return time_stamp_.produce_each(Duration(input.word() * 10LL));
      case 13:
        time_stamp_.send();
        return;
      default:
        return node_.command(command);
    }
  }

  void ask(unsigned what, Input& input) {
    SdoClient& client = what % 2 == 0 ? client_ : channel_client_;
    const auto done = SdoClient::Done::to<&World::answered>(*this);
    const std::uint16_t index = input.word();
    const std::size_t length = input.byte() % answer_.size();
    switch (what / 2 % 4) {
      case 0:
        client.upload(other_id, index, 0, std::span(answer_).first(length), done);
        return;
      case 1:
        client.download(other_id, index, 1, std::span(answer_).first(length), done);
        return;
      case 2:
        client.upload(input.byte(), index, 0, SdoClient::Sink{}, done, Duration(input.word()));
        return;
      default:
        return client.cancel();
    }
  }

  void answered(SdoClient::Outcome outcome) {
    if (!outcome || restarts_ == 0) return;
    --restarts_;
    client_.upload(other_id, 0x1000, 0, answer_, SdoClient::Done::to<&World::answered>(*this));
  }
  void rpdo_received(std::uint16_t number) {
    Dictionary& dictionary = node_.dictionary();
    dictionary.set_number(0x2001, 1, dictionary.number(0x2000, 1) + number);
  }
  /// Opens and closes routes during a dispatch.
  void remote_changed(NodeId node_id, RemoteState state) {
    if (state == RemoteState::lost) return emergency_consumer_.ignore(node_id);
    if (state == RemoteState::stopped) guarding_master_.release(node_id);
    emergency_consumer_.listen(node_id);
  }

  static constexpr DictionaryTables tables_ = objects.tables();
  static constexpr std::size_t routes_max = 180;

  Time now_{};
  bool full_ = false;
  bool waited_ = false;  ///< frames have waited in the node since the controller was full
  int restarts_ = 3;
  std::array<bool, Frame::id_max + 1> wanted_{};  ///< by the acceptance filter

  std::array<std::uint8_t, tables_.value_bytes> values_{};
  std::array<ObjectState, tables_.objects.size()> states_{};
  std::array<Router::Route, routes_max> routes_{};
  std::array<Frame, 6> backlog_{};
  std::array<std::uint8_t, 32> default_buffer_{};
  std::array<std::uint8_t, 16> second_buffer_{};
  std::array<std::uint8_t, 40> answer_{};
  std::array<Error, 3> present_{};
  std::array<Emergency, 3> waiting_{};
  std::array<HeartbeatConsumer::Slot, 2> heartbeat_slots_;
  std::array<Rpdo, 2> rpdo_memory_;
  std::array<Tpdo, 2> tpdo_memory_;
  std::array<MappedValue, 16> rpdo_values_{};
  std::array<MappedValue, 16> tpdo_values_{};
  std::array<EmergencyConsumer::Slot, 4> emergency_slots_;
  std::array<NodeGuardingMaster::Slot, 2> guarding_slots_;
  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;

  Node node_;
  SdoServer default_server_;
  SdoServer second_server_;
  EmergencyProducer emergency_producer_;
  ErrorBehaviour error_behaviour_;
  HeartbeatProducer heartbeat_producer_;
  HeartbeatConsumer heartbeat_consumer_;
  NodeGuardingSlave guarding_slave_;
  NodeGuardingMaster guarding_master_;
  TimeStamp time_stamp_;
  Sync sync_;
  HighResolutionTime high_resolution_time_;
  Rpdos rpdos_;
  Tpdos tpdos_;
  SdoClient client_;
  SdoClient channel_client_;
  EmergencyConsumer emergency_consumer_;
  NmtMaster master_;
  ScratchDomain domain_;
};

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::World world;
  canvoy::fuzz::Input input(data, size);
  while (!input.empty()) world.step(input);
  return 0;
}
