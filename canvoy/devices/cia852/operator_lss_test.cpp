// Node-ID and bit rate of an operator environment, and of the module of CiA 401 that it is built
// on, by LSS (CiA 852, 6.2 and 8.2): each bit rate of 6.2 on a bus that has bit rates.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/lss/bit_rate_detection.hpp"
#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/devices/catalogue.hpp"

namespace canvoy::cia852::operator_lss_test {
namespace {

/// 6.2, by the index of CiA 305: 1000, 500, 250 and 125 kbit/s.
struct TableRate {
  const char* index;  ///< as it is written in a message of LSS
  std::uint32_t bit_rate;
};
constexpr TableRate shall_rates[] = {
    {"00", 1'000'000}, {"02", 500'000}, {"03", 250'000}, {"04", 125'000}};
constexpr std::uint8_t shall_indices[] = {0, 2, 3, 4};

/// A board with a CAN controller and a flash; its device lives from power-on to power-off.
class LssBoard {
 public:
  LssBoard(SimulatedBus& bus, const DeviceKind& kind, std::uint32_t delivered)
      : kind_(kind), delivered_(delivered), bus_(bus) {
    controller = bus.attach({.listener = {.context = this,
                                          .on_frame = &LssBoard::heard,
                                          .on_sent = &LssBoard::has_room},
                             .on_error = &LssBoard::is_no_frame});
    bus.power(controller, false);
  }

  void power_on() {
    bus_.power(controller, true);
    life_ = std::make_unique<Life>(*this);
    const std::uint8_t stored = life_->store.bit_timing();
    if (stored == lss_bit_timing::automatic) return detection.start(bus_.now());
    begin(stored == lss_bit_timing::unknown ? delivered_ : lss_bit_timing::bit_rate(stored));
  }
  void power_off() {
    life_.reset();
    bus_.power(controller, false);
  }
  Time deadline() const {
    return std::min(detection.deadline(), life_ ? life_->device.node().deadline() : never);
  }
  void advance(Time now) {
    detection.advance(now);
    if (life_ && life_->device.node().deadline() <= now) life_->device.node().advance(now);
  }
  Node& node() { return life_->device.node(); }

  ControllerId controller;
  std::uint32_t bit_rate = 0;  ///< of the controller
  bool listens_only = false;
  BitRateDetection detection{BitRateDetection::Restart::to<&LssBoard::restart>(*this)};

 private:
  struct Life {
    explicit Life(LssBoard& board)
        : device(board.kind_, board.bus_.port(board.controller), board.kind_.info.node_id,
                 board.environment_),
          store(device.node(), board.flash_.flash, {.address = 0, .slot_size = 128}),
          bit_timing(device.node(), callback<&LssBoard::switch_to>(board)),
          lss(device.node(),
              {.configure_bit_timing = callback<&LssBoard::is_known>(board),
               .activate_bit_timing = bit_timing.hook(),
               .store = store.hook(),
               .state_entered = {}},
              store.bit_timing()) {
      store.on_stored(LssStore::Stored::to<&LssSlave::stored>(lss));
    }

    mutable CatalogueDevice device;
    LssStore store;
    BitTimingSwitch bit_timing;
    LssSlave lss;
  };

  static void heard(void* self, Time now, const Frame& frame) {
    auto& board = *static_cast<LssBoard*>(self);
    if (board.listens_only) return board.detection.receive(frame, now);
    if (board.life_) board.node().receive(frame, now);
  }
  static void has_room(void* self, Time now, const Frame&) {
    auto& board = *static_cast<LssBoard*>(self);
    if (board.life_) board.node().tx_ready(now);
  }
  static void is_no_frame(void* self, Time now) {
    static_cast<LssBoard*>(self)->detection.bus_error(now);
  }

  /// The four bit rates that 6.2 requires, and detection: no other one.
  LssError is_known(std::uint8_t index) {
    const bool is_one =
        std::ranges::find(shall_indices, index) != std::end(shall_indices) || index == 9;
    return {.code = is_one ? LssError::none : LssError::out_of_range};
  }
  void switch_to(std::uint8_t index) { set(lss_bit_timing::bit_rate(index), false); }
  void begin(std::uint32_t rate) {
    set(rate, false);
    node().start(bus_.now());
  }
  /// Of the detection.
  bool restart(std::uint32_t rate, bool listen_only) {
    set(rate, listen_only);
    if (!listen_only) node().start(bus_.now());
    return true;
  }
  void set(std::uint32_t rate, bool listen_only) {
    bit_rate = rate;
    listens_only = listen_only;
    bus_.set_listen_only(controller, listen_only);
    bus_.set_bit_rate(controller, rate);
  }

  const DeviceKind& kind_;
  std::uint32_t delivered_;
  SimulatedBus& bus_;
  Environment environment_;
  SimulatedFlash flash_{{.sector_size = 128, .sectors = 2, .unit = 8}};
  std::unique_ptr<Life> life_;
};

/// A board, and two testers: one sends, both acknowledge. They change their bit rate on the test's
/// command.
class LssBitRate : public testing::TestWithParam<std::tuple<const char*, TableRate>> {
 protected:
  /// Not the requested one, so that there is a change to make.
  static constexpr std::uint32_t before() { return 125'000; }
  std::uint32_t wanted() const { return std::get<1>(GetParam()).bit_rate; }
  std::uint32_t delivered() const { return wanted() == before() ? 250'000 : before(); }
  const char* index() const { return std::get<1>(GetParam()).index; }
  const DeviceKind& kind() const { return *find_device_kind(std::get<0>(GetParam())); }
  NodeId id() const { return kind().info.node_id; }

  LssBitRate() {
    for (ControllerId* tester : {&speaker, &witness}) *tester = bus.attach({});
    bus.observe({.context = this,
                 .on_frame = [](void* self, Time at, ControllerId from, const Frame& frame) {
                   auto& test = *static_cast<LssBitRate*>(self);
                   if (from == test.speaker) test.asked_at = at;
                   if (from == test.board.controller) {
                     test.said.push_back({at, wire_text(frame)});
                   }
                 }});
    set_testers(delivered());
  }
  void set_testers(std::uint32_t rate) {
    for (const ControllerId tester : {speaker, witness}) bus.set_bit_rate(tester, rate);
  }
  void run_until(Time until) {
    for (Time next = due(); next <= until; next = due()) {
      bus.advance(next);
      board.advance(next);
    }
    bus.advance(until);
  }
  Time due() const { return std::min(bus.next_event(), board.deadline()); }
  void run_for(Duration duration) { run_until(bus.now() + duration); }
  /// Sends a frame, and allows a node and a store time to answer; frames of LSS have eight bytes.
  void send(std::string_view text) {
    Frame frame = wire_frame(text);
    if (frame.id == 0x7E5) frame.length = 8;
    said.clear();
    ASSERT_TRUE(bus.send(speaker, frame));
    run_for(20ms);
  }
  std::string answer() const { return said.empty() ? "" : said.back().text; }
  bool has_said(std::string_view begin) const {
    return std::ranges::any_of(said,
                               [&](const Said& each) { return each.text.starts_with(begin); });
  }
  /// The node answers, with nothing destroyed on the bus: both have one bit rate.
  void expect_talk(NodeId as) {
    char request[40], expected[8];
    std::snprintf(request, sizeof request, "%03X#40 00 10 00 00 00 00 00", 0x600U + as);
    std::snprintf(expected, sizeof expected, "%03X#43", 0x580U + as);
    const auto errors = bus.statistics().error_frames;
    send(request);
    EXPECT_TRUE(has_said(expected)) << expected;
    EXPECT_EQ(bus.statistics().error_frames, errors);
  }
  std::string heartbeat_id(NodeId of) const {
    char text[8];
    std::snprintf(text, sizeof text, "%03X#", 0x700U + of);
    return text;
  }

  struct Said {
    Time at;
    std::string text;
  };
  SimulatedBus bus{{.bit_rate = 125'000}};
  ControllerId speaker{};
  ControllerId witness{};
  std::vector<Said> said;  ///< by the board
  Time asked_at{};         ///< when receivers had the last frame of the speaker
  LssBoard board{bus, kind(), delivered()};
};

/// CiA 305: 13h configures, 15h activates after a delay of 100 ms (64h), 17h stores.
TEST_P(LssBitRate, IsConfiguredActivatedStoredAndUsedAfterARestart) {
  board.power_on();
  run_for(100ms);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].text, heartbeat_id(id()) + "00");
  send("7E5#04 01");
  send("7E5#11 20");
  EXPECT_EQ(answer(), "7E4#11 00 00 00 00 00 00 00");
  send(std::string("7E5#13 00 ") + index());
  EXPECT_EQ(answer(), "7E4#13 00 00 00 00 00 00 00");
  EXPECT_EQ(board.bit_rate, delivered()) << "nothing changes yet";
  send("7E5#17");
  EXPECT_EQ(answer(), "7E4#17 00 00 00 00 00 00 00");
  expect_talk(id());

  // A heartbeat every 10 ms shows when it is silent.
  board.node().dictionary().write(0x1017, 0, std::array<std::uint8_t, 2>{10, 0}, Source::sdo);
  run_for(30ms);
  EXPECT_EQ(answer(), heartbeat_id(id()) + "7F");
  ASSERT_TRUE(bus.send(speaker, wire_frame("7E5#15 64 00 00 00 00 00 00")));
  run_for(2ms);
  const Time told = asked_at;
  said.clear();
  run_until(told + 100ms - 1us);
  EXPECT_EQ(board.bit_rate, delivered()) << "the first delay";
  run_until(told + 100ms);
  EXPECT_EQ(board.bit_rate, wanted());
  set_testers(wanted());
  run_until(told + 200ms - 1us);
  EXPECT_TRUE(said.empty()) << "silence in both delays: " << said[0].text;
  run_for(20ms);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said[0].text, heartbeat_id(id()) + "7F");
  EXPECT_EQ(bus.statistics().error_frames, 0u);
  send("7E5#04 00");
  expect_talk(id());

  board.power_off();
  run_for(1s);
  said.clear();
  board.power_on();
  run_for(100ms);
  EXPECT_EQ(board.bit_rate, wanted());
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said[0].text, "720#00") << "the node-ID was stored as well";
  expect_talk(0x20);
  EXPECT_EQ(bus.statistics().error_frames, 0u);
}

/// A setting that is activated and not stored is lost with the power.
TEST_P(LssBitRate, IsGoneAfterARestartWhereItWasNotStored) {
  board.power_on();
  run_for(100ms);
  send("7E5#04 01");
  send(std::string("7E5#13 00 ") + index());
  send("7E5#15 0A 00");
  EXPECT_EQ(board.bit_rate, wanted());
  board.power_off();
  run_for(1s);
  board.power_on();
  EXPECT_EQ(board.bit_rate, delivered());
}

/// Error 1 is "out of range": 800 kbit/s, which this hardware does not have, the reserved index,
/// one behind the table, and a table of a manufacturer.
TEST_P(LssBitRate, ThatIsNotAllowedIsRefusedAndChangesNothing) {
  board.power_on();
  run_for(100ms);
  send("7E5#04 01");
  send(std::string("7E5#13 00 ") + index());
  EXPECT_EQ(answer(), "7E4#13 00 00 00 00 00 00 00");
  for (const char* const refused : {"7E5#13 00 01", "7E5#13 00 05", "7E5#13 00 06", "7E5#13 00 08",
                                    "7E5#13 00 0A", "7E5#13 00 FF", "7E5#13 80 02"}) {
    send(refused);
    EXPECT_EQ(answer(), "7E4#13 01 00 00 00 00 00 00") << refused;
  }
  send("7E5#15 0A 00");
  EXPECT_EQ(board.bit_rate, wanted()) << "the one that was allowed";
}

/// Index 9 of CiA 305: the device listens at each bit rate until it receives a frame (CiA 801), and
/// then boots. Before that, it never destroys a frame of other nodes.
TEST_P(LssBitRate, OfTheNetworkIsDetected) {
  board.power_on();
  run_for(100ms);
  send("7E5#04 01");
  send("7E5#13 00 09");
  EXPECT_EQ(answer(), "7E4#13 00 00 00 00 00 00 00");
  send("7E5#17");
  EXPECT_EQ(answer(), "7E4#17 00 00 00 00 00 00 00");
  board.power_off();
  run_for(1s);
  set_testers(wanted());
  said.clear();
  board.power_on();
  const Time begun = bus.now();
  // Another node sends every 100 ms.
  while (said.empty() && bus.now() < begun + 20s) {
    ASSERT_TRUE(bus.send(speaker, wire_frame("701#05")));
    run_for(100ms);
  }
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said[0].text, heartbeat_id(id()) + "00");
  EXPECT_EQ(board.bit_rate, wanted());
  EXPECT_EQ(board.detection.bit_rate(), wanted());
  EXPECT_FALSE(board.listens_only);
  EXPECT_EQ(bus.statistics().error_frames, 0u);
  EXPECT_EQ(bus.error_counters(speaker).transmit(), 0);
  expect_talk(id());
}

std::string name_of(const testing::TestParamInfo<LssBitRate::ParamType>& info) {
  const std::string_view kind = std::get<0>(info.param);
  return (kind == "operator" ? "OperatorAt" : "Io401At") +
         std::to_string(std::get<1>(info.param).bit_rate / 1000);
}
INSTANTIATE_TEST_SUITE_P(All, LssBitRate,
                         testing::Combine(testing::Values("operator", "io-401"),
                                          testing::ValuesIn(shall_rates)),
                         name_of);

}  // namespace
}  // namespace canvoy::cia852::operator_lss_test
