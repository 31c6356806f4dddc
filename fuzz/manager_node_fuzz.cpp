// Arbitrary frames, times and losses of nodes, for a node that is SDO manager, configuration
// manager and requests SDO connections itself. It comes to rest, its records stay consistent, and
// it continues to answer.
#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/device/verify_configuration.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/canopen/manager/sdo_requester.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"
#include "fuzz/require.hpp"

namespace canvoy {
namespace {

using fuzz::require;

constexpr EntryRow highest(std::int64_t sub) {
  return {.access = Access::const_, .initial = sub};
}
constexpr EntryRow u32(std::uint8_t first, std::uint8_t last, Access access,
                       std::int64_t initial = 0) {
  return {.sub_first = first,
          .sub_last = last,
          .type = DataType::unsigned32,
          .access = access,
          .initial = initial};
}
constexpr EntryRow peer = {.sub_first = 3, .sub_last = 3, .access = Access::rw};

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1020, .entry_count = 2},
                                      {.index = 0x1201, .count = 2, .entry_count = 3},
                                      {.index = 0x1280, .count = 2, .entry_count = 3},
                                      {.index = 0x1F00, .count = 2, .entry_count = 1},
                                      {.index = 0x1F02, .entry_count = 3},
                                      {.index = 0x1F03, .entry_count = 2},
                                      {.index = 0x1F10, .entry_count = 1},
                                      {.index = 0x1F22, .entry_count = 2},
                                      {.index = 0x1F25, .entry_count = 2},
                                      {.index = 0x1F26, .count = 2, .entry_count = 2}}),
            std::to_array<EntryRow>(
                {highest(2),
                 u32(1, 2, Access::rw),
                 highest(3),
                 u32(1, 2, Access::rw, 0x8000'0000),
                 peer,
                 highest(3),
                 u32(1, 2, Access::rw, 0x8000'0000),
                 peer,
                 u32(0, 0, Access::wo),
                 highest(6),
                 u32(1, 1, Access::rw, 0x680),
                 u32(2, 6, Access::rw, 0x8000'0000),
                 highest(4),
                 u32(1, 4, Access::ro),
                 u32(0, 0, Access::rw),
                 highest(127),
                 {.sub_first = 1, .sub_last = 127, .type = DataType::domain, .access = Access::rw},
                 highest(128),
                 u32(1, 128, Access::wo),
                 highest(127),
                 u32(1, 127, Access::rw)}));

constexpr std::uint8_t good_dcf[] = {2, 0, 0, 0, 0x17, 0x10, 0, 2, 0, 0, 0, 0xF4, 1, 1, 0x20,
                                     2, 9, 0, 0, 0,    1,    2, 3, 4, 5, 6, 7,    8, 9};
constexpr std::uint8_t cut_dcf[] = {2, 0, 0, 0, 0x17, 0x10, 0, 2, 0, 0};
constexpr FixedConfigurations::Item items[] = {{.slave = 5, .concise_dcf = good_dcf},
                                               {.slave = 6, .concise_dcf = cut_dcf}};

class Target {
 public:
  Target() {
    // Five COB-IDs: two connections and a spare one.
    for (std::uint8_t sub = 2; sub <= 5; ++sub) {
      node_.dictionary().set_number(0x1F02, sub, 0x67F + std::uint64_t{sub});
    }
    configurations_.on_done(ConfigurationManager::Done::to<&Target::configured>(*this));
    node_.start(now_);
  }

  void wait(Duration duration) { fuzz::pass(node_, now_, duration); }
  void receive(const Frame& frame) {
    node_.receive(frame, now_);
    wait(Duration::zero());
  }
  void remote(NodeId id, std::uint8_t state) {
    constexpr RemoteState states[] = {RemoteState::lost, RemoteState::boot_up,
                                      RemoteState::operational};
    node_.advance(now_);
    sdo_manager_.remote_changed(id, states[state % 3]);
    wait(Duration::zero());
  }
  void act(std::uint8_t what) {
    node_.advance(now_);
    const auto done = SdoRequester::Done::to<&Target::requested>(*this);
    switch (what % 5) {
      case 0:
        configurations_.update(what / 5);
        break;
      case 1:
        if (requester_.connect(10, 1, done) == AbortCode::none) ++requests_;
        break;
      case 2:
        if (requester_.connect_all(done) == AbortCode::none) ++requests_;
        break;
      case 3:
        requester_.release(1);
        break;
      default:
        requester_.leave();
        break;
    }
    wait(Duration::zero());
  }
  /// No COB-ID is assigned twice.
  void check() const {
    std::vector<unsigned> ids;
    for (const SdoConnection& connection : connections_) {
      for (const unsigned id : {connection.request, connection.response}) {
        if (id == 0) continue;
        for (const unsigned other : ids) require(other != id);
        ids.push_back(id);
      }
    }
  }
  void finish() {
    receive(Frame::data_frame(0x000, {0x01, 0x01}));
    node_.advance(now_);
    for (NodeId id = 1; id <= node_id_max; ++id) {
      sdo_manager_.remote_changed(id, RemoteState::lost);
    }
    wait(1h);
    require(!sdo_manager_.busy() && !requester_.busy());
    require(requests_ == 0);
    for (NodeId id = 1; id <= node_id_max; ++id) require(!configurations_.busy(id));
    for (const SdoConnection& connection : connections_) {
      require(connection.state == SdoConnection::State::unused);
    }
    last_ = {};
    receive(Frame::data_frame(0x601, {0x40, 0x20, 0x10, 0, 0, 0, 0, 0}));
    require(last_.id == 0x581 && last_.data[0] == 0x4F);
  }

 private:
  static bool take(void* context, const Frame& frame) {
    require(frame.is_plain() && frame.id <= Frame::id_max && frame.length <= 8);
    static_cast<Target*>(context)->last_ = frame;
    return true;
  }
  void configured(NodeId, const ConfigurationOutcome&) {}
  void requested(SdoEnd) { --requests_; }

  NodeMemory memory() { return {values_, states_, routes_, backlog_}; }
  static constexpr DictionaryTables tables_ = layout.tables();

  Time now_{};
  Frame last_;
  int requests_ = 0;
  std::array<std::uint8_t, tables_.value_bytes> values_{};
  std::array<ObjectState, tables_.objects.size()> states_{};
  std::array<Router::Route, 16> routes_{};
  std::array<Frame, 8> backlog_{};
  Node node_{tables_, memory(), {this, &Target::take, nullptr}, 1};
  std::array<std::array<std::uint8_t, 16>, 3> buffers_{};
  SdoServer servers_[3] = {SdoServer(node_, 0, buffers_[0]), SdoServer(node_, 1, buffers_[1]),
                           SdoServer(node_, 2, buffers_[2])};
  VerifyConfiguration verify_{node_};
  FixedConfigurations contents_{node_, items};
  ConfigurationManager::Worker workers_[2] = {ConfigurationManager::Worker(node_),
                                              ConfigurationManager::Worker(node_)};
  ConfigurationManager configurations_{node_, workers_};
  std::array<SdoConnection, 4> connections_{};
  SdoManager sdo_manager_{node_, connections_, {}};
  SdoRequester requester_{node_, {}};
};

Frame frame_from(fuzz::Input& input, std::uint32_t id, std::uint8_t length) {
  std::array<std::uint8_t, 8> data{};
  input.fill(std::span(data).first(length));
  return Frame::data_frame(id, std::span(data).first(length));
}

/// Possible answers of nodes 5, 6 and 10, and possible writes of devices.
Frame likely_frame(fuzz::Input& input) {
  constexpr std::array<std::uint16_t, 8> indices = {0x1F00, 0x1F01, 0x1F02, 0x1F10,
                                                    0x1F25, 0x1280, 0x1281, 0x1201};
  constexpr std::array<std::uint16_t, 6> ids = {0x601, 0x680, 0x585, 0x586, 0x58A, 0x681};
  const std::uint8_t choice = input.byte();
  Frame frame = frame_from(input, ids.at(choice % ids.size()), 8);
  if (choice >= 0x80) frame.data[0] = frame.id < 0x600 ? std::uint8_t{0x60} : std::uint8_t{0x23};
  store(&frame.data[1], indices.at(frame.data[1] % indices.size()));
  return frame;
}

void run(fuzz::Input input) {
  Target target;
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    switch (what % 8) {
      case 0:
        target.wait(Duration(std::int64_t{1} << (what >> 3)));
        break;
      case 1:
        target.act(input.byte());
        break;
      case 2:
        target.receive(frame_from(input, input.word(), what >> 3 & 7));
        break;
      case 3:
        target.receive(Frame::data_frame(0x000, {input.byte(), 0x01}));
        break;
      case 4:
        target.receive(Frame::data_frame(0x6E0, {}));
        break;
      case 5:
        target.remote(input.byte(), what >> 3);
        break;
      default:
        target.receive(likely_frame(input));
    }
    target.check();
  }
  target.finish();
}

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::run(canvoy::fuzz::Input(data, size));
  return 0;
}
