#include "canvoy/canopen/node/node.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::node_test {
namespace {

constexpr NodeId own_id = 5;

// A communication object, one with a default that depends on the node-ID, and an application
// object.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1006, .entry_count = 1},
                              {.index = 0x1014, .entry_count = 1},
                              {.index = 0x1FFF, .entry_count = 1},
                              {.index = 0x2000, .entry_count = 1},
                              {.index = 0x6000, .entry_count = 1}}),
    std::to_array<EntryRow>({{.type = DataType::unsigned32, .access = Access::rw, .initial = 1000},
                             {.type = DataType::unsigned32,
                              .access = Access::rw,
                              .traits = EntryTraits::plus_node_id,
                              .initial = 0x4000'0080},
                             {.access = Access::rw, .initial = 0x1F},
                             {.access = Access::rw, .initial = 0x20},
                             {.type = DataType::integer16, .access = Access::rw, .initial = -2}}));

constexpr NmtState states[] = {NmtState::pre_operational, NmtState::operational, NmtState::stopped};

/// A service that records its events.
class Witness {
 public:
  explicit Witness(Node& node, std::string name = "") : name_(std::move(name)) {
    service.reset = callback<&Witness::reset>(*this);
    service.state_entered = callback<&Witness::state_entered>(*this);
    service.bus_state_changed = callback<&Witness::bus_state_changed>(*this);
    service.error_changed = callback<&Witness::error_changed>(*this);
    service.values_changed = callback<&Witness::values_changed>(*this);
    service.tx_ready = callback<&Witness::tx_ready>(*this);
    node.attach(service);
  }

  std::vector<std::string> take() { return std::exchange(log, {}); }

  Service service;
  std::vector<std::string> log;
  std::vector<std::string>* shared = nullptr;

 private:
  void note(const std::string& what) {
    log.push_back(name_ + what);
    if (shared != nullptr) shared->push_back(name_ + what);
  }
  void reset(ResetScope scope) {
    note(scope == ResetScope::node ? "reset node" : "reset communication");
  }
  void state_entered(NmtState state) { note("state " + std::to_string(static_cast<int>(state))); }
  void bus_state_changed(BusState state) { note("bus " + std::to_string(static_cast<int>(state))); }
  void error_changed(const Error& error, bool present) {
    note((present ? "raise " : "clear ") + std::to_string(error.code));
  }
  void values_changed(std::uint32_t mask) { note("values " + std::to_string(mask)); }
  void tx_ready() { note("tx ready"); }

  std::string name_;
};

void enter(Node& node, NmtState state) {
  node.command(state == NmtState::operational ? NmtCommand::start
               : state == NmtState::stopped   ? NmtCommand::stop
                                              : NmtCommand::enter_pre_operational);
}

/// The state machine of CiA 301, figure "NMT state diagram of a CANopen device".
NmtState state_after(NmtState before, unsigned command) {
  switch (command) {
    case 0x01:
      return NmtState::operational;
    case 0x02:
      return NmtState::stopped;
    case 0x80:
    case 0x81:
    case 0x82:
      return NmtState::pre_operational;
    default:
      return before;
  }
}

// NMT slave

TEST(NmtSlave, ObeysEachCommandByteForEachAddressInEachState) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  for (const NmtState before : states) {
    for (unsigned command = 0; command < 256; ++command) {
      for (unsigned address = 0; address < 256; ++address) {
        enter(sut.node, before);
        sut.sent.clear();
        const std::uint32_t malformed = sut.node.counters().malformed;
        const Frame frame = Frame::data_frame(
            0x000, {static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(address)});
        sut.node.receive(frame, sut.now);

        const bool addressed = address == 0 || address == own_id;
        const bool known = command == 1 || command == 2 || (command >= 0x80 && command <= 0x82);
        const bool resets = addressed && (command == 0x81 || command == 0x82);
        ASSERT_EQ(sut.node.state(), addressed ? state_after(before, command) : before)
            << wire_text(frame);
        ASSERT_EQ(sut.sent.size(), resets ? 1U : 0U) << wire_text(frame);
        ASSERT_EQ(sut.node.counters().malformed - malformed, addressed && !known ? 1U : 0U)
            << wire_text(frame);
      }
    }
  }
}

TEST(NmtSlave, ThatIsResetSendsTheBootUpMessageAndNothingThatWaitedBeforeIt) {
  for (const char* reset : {"000#81 05", "000#82 00"}) {
    WireNode sut(layout.tables(), own_id);
    sut.boot_operational();
    sut.full = true;
    while (!sut.node.transmitter().full()) sut.node.transmitter().send(wire_frame("185#01"));
    sut.receive("000#81 06");
    EXPECT_TRUE(sut.node.transmitter().full()) << "another node is meant";
    sut.receive(reset);
    sut.full = false;
    sut.node.tx_ready(sut.now);
    sut.expect({"705#00"});
    EXPECT_EQ(sut.node.transmitter().lost(), 0U);
  }
}

TEST(NmtSlave, TakesTwoBytesAndNoOtherLength) {
  for (const NmtState before : states) {
    for (const unsigned command : {0x01U, 0x02U, 0x80U, 0x81U, 0x82U}) {
      for (unsigned length = 0; length <= 8; ++length) {
        WireNode sut(layout.tables(), own_id);
        sut.boot();
        enter(sut.node, before);
        Frame frame = Frame::data_frame(0x000, {static_cast<std::uint8_t>(command), own_id});
        frame.length = static_cast<std::uint8_t>(length);
        sut.node.receive(frame, sut.now);
        EXPECT_EQ(sut.node.state(), length == 2 ? state_after(before, command) : before);
        EXPECT_EQ(sut.node.counters().malformed, length == 2 ? 0U : 1U);
        EXPECT_EQ(sut.sent.size(), length == 2 && command >= 0x81 ? 1U : 0U);
      }
    }
  }
}

TEST(NmtSlave, DoesNotMindRemote29BitAndErrorFrames) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  sut.receive("000#R2");
  sut.receive("00000000#01 05");
  Frame error = wire_frame("000#01 05");
  error.flags = FrameFlags::error;
  sut.node.receive(error, sut.now);
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  EXPECT_EQ(sut.node.counters().received, 3U);
  EXPECT_EQ(sut.node.counters().unwanted, 1U);
  EXPECT_EQ(sut.node.counters().extended, 2U);
  EXPECT_EQ(sut.node.counters().malformed, 0U);
}

TEST(NmtSlave, DoesNotTakeAnImpossibleIdentifierForAnother) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  for (const std::uint32_t id : {0x800U, 0x1'0000U, 0x1000'0000U, 0xFFFF'0000U}) {
    Frame frame = wire_frame("000#01 05");
    frame.id = id;
    sut.node.receive(frame, sut.now);
  }
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  EXPECT_EQ(sut.node.counters().extended, 4U);
}

TEST(NmtSlave, BootsUpIntoPreOperational) {
  WireNode sut(layout.tables(), own_id);
  EXPECT_EQ(sut.node.state(), NmtState::initialisation);
  sut.start();
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  sut.expect({"@0 705#00"});
  EXPECT_EQ(sut.node.deadline(), never);
}

TEST(NmtSlave, HasTheBootUpMessageOfItsNodeId) {
  for (unsigned id = 1; id <= 127; ++id) {
    WireNode sut(layout.tables(), static_cast<NodeId>(id));
    sut.start();
    ASSERT_EQ(sut.sent.size(), 1U);
    EXPECT_EQ(sut.sent[0].frame, Frame::data_frame(0x700 + id, {0x00}));
  }
}

TEST(NmtSlave, EntersOperationalByItselfWithAutostartAfterEachBootUp) {
  WireNode sut(layout.tables(), own_id, true);
  Witness witness(sut.node);
  sut.start();
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"reset node", "state 127", "state 5"}));
  sut.receive("000#02 00");
  EXPECT_EQ(sut.node.state(), NmtState::stopped);
  sut.receive("000#82 00");
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.expect({"705#00", "705#00"});
}

TEST(NmtSlave, WaitsInInitialisationWithoutANodeId) {
  WireNode sut(layout.tables(), node_id_unconfigured, true);
  sut.start();
  for (const char* command : {"000#01 00", "000#01 FF", "000#82 00", "000#81 FF", "000#80 00"}) {
    sut.receive(command);
  }
  sut.node.command(NmtCommand::start);
  EXPECT_EQ(sut.node.state(), NmtState::initialisation);
  sut.expect({});
}

TEST(NmtSlave, ObeysNobodyBeforeItWasStarted) {
  WireNode sut(layout.tables(), own_id);
  sut.receive("000#01 00");
  sut.receive("000#81 00");
  EXPECT_EQ(sut.node.state(), NmtState::initialisation);
  sut.expect({});
}

TEST(NmtSlave, TellsItsServicesOfEachChangeOfStateAndOfNoOther) {
  WireNode sut(layout.tables(), own_id);
  Witness witness(sut.node);
  sut.start();
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"reset node", "state 127"}));
  sut.receive("000#80 05");
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
  sut.receive("000#01 05");
  sut.receive("000#01 00");
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"state 5"}));
  sut.receive("000#02 05");
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"state 4"}));
  sut.receive("000#81 05");
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"state 0", "reset node", "state 127"}));
  sut.receive("000#82 05");
  EXPECT_EQ(witness.take(),
            (std::vector<std::string>{"state 0", "reset communication", "state 127"}));
}

TEST(NmtSlave, SendsTheBootUpMessageBehindTheResetAndBeforePreOperational) {
  struct Order {
    explicit Order(WireNode& wire_node) : wire(wire_node) {
      service.reset = callback<&Order::reset>(*this);
      service.state_entered = callback<&Order::entered>(*this);
      wire.node.attach(service);
    }
    void reset(ResetScope) { sent_at_reset = wire.sent.size(); }
    void entered(NmtState) { sent_at_entry = wire.sent.size(); }
    WireNode& wire;
    Service service;
    std::size_t sent_at_reset = 99;
    std::size_t sent_at_entry = 99;
  };
  WireNode sut(layout.tables(), own_id);
  Order order(sut);
  sut.start();
  EXPECT_EQ(order.sent_at_reset, 0U);
  EXPECT_EQ(order.sent_at_entry, 1U);
}

// Values and resets

struct Values {
  std::uint64_t first, cob_id, last, manufacturer, application;
  friend bool operator==(const Values&, const Values&) = default;
};
Values values_of(const Dictionary& dictionary) {
  return {dictionary.number(0x1006, 0), dictionary.number(0x1014, 0), dictionary.number(0x1FFF, 0),
          dictionary.number(0x2000, 0), dictionary.number(0x6000, 0)};
}
void change_all(Dictionary& dictionary) {
  constexpr std::uint16_t indices[] = {0x1006, 0x1014, 0x1FFF, 0x2000, 0x6000};
  for (const std::uint16_t index : indices) {
    ASSERT_TRUE(dictionary.set_number(index, 0, 0x55));
  }
}
constexpr Values defaults{1000, 0x4000'0085, 0x1F, 0x20, 0xFFFE};

TEST(NodeValues, HaveTheirDefaultsBeforeAndAfterStart) {
  WireNode sut(layout.tables(), own_id);
  EXPECT_EQ(values_of(sut.node.dictionary()), defaults);
  change_all(sut.node.dictionary());
  sut.start();
  EXPECT_EQ(values_of(sut.node.dictionary()), defaults);
}

TEST(NodeValues, AllReturnToTheirDefaultsByResetNode) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  change_all(sut.node.dictionary());
  sut.receive("000#81 05");
  EXPECT_EQ(values_of(sut.node.dictionary()), defaults);
}

TEST(NodeValues, OfTheCommunicationAreaAloneReturnByResetCommunication) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  change_all(sut.node.dictionary());
  sut.receive("000#82 05");
  EXPECT_EQ(values_of(sut.node.dictionary()), (Values{1000, 0x4000'0085, 0x1F, 0x55, 0x55}));
}

TEST(NodeValues, StayThroughStartStopAndPreOperational) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  change_all(sut.node.dictionary());
  for (const char* command : {"000#01 05", "000#02 05", "000#80 05"}) sut.receive(command);
  EXPECT_EQ(values_of(sut.node.dictionary()), (Values{0x55, 0x55, 0x55, 0x55, 0x55}));
}

TEST(NodeValues, DependOnTheNodeIdWhereTheirDescriptionSaysSo) {
  for (unsigned id = 1; id <= 127; ++id) {
    WireNode sut(layout.tables(), static_cast<NodeId>(id));
    EXPECT_EQ(sut.node.dictionary().number(0x1014, 0), 0x4000'0080U + id);
    EXPECT_EQ(sut.node.dictionary().number(0x1006, 0), 1000U);
  }
}

TEST(NodeValues, AreAnnouncedWhenTheNodeIsCalled) {
  WireNode sut(layout.tables(), own_id);
  Witness witness(sut.node);
  sut.boot();
  witness.take();
  const Entry entry = *sut.node.dictionary().find(0x6000, 0);
  sut.node.dictionary().watch(entry, 0x8000'0001);
  sut.node.dictionary().set_number(0x6000, 0, 7);
  EXPECT_EQ(sut.node.deadline(), Time::min());
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
  sut.settle();
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"values 2147483649"}));
  sut.node.dictionary().set_number(0x6000, 0, 7);
  EXPECT_EQ(sut.node.deadline(), never) << "the value is the same";
  sut.node.dictionary().set_number(0x2000, 0, 7);
  EXPECT_EQ(sut.node.deadline(), never) << "nobody watches this one";
  sut.node.dictionary().set_number(0x6000, 0, 8);
  sut.receive("123#");
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"values 2147483649"}))
      << "a frame is a call as well";
}

// Other functions of a node

TEST(Node, CallsItsServicesInTheOrderInWhichTheyAttached) {
  WireNode sut(layout.tables(), own_id);
  std::vector<std::string> log;
  Witness first(sut.node, "1 ");
  Witness second(sut.node, "2 ");
  Witness third(sut.node, "3 ");
  first.shared = second.shared = third.shared = &log;
  sut.node.raise({.code = 7});
  sut.node.clear({.code = 7});
  sut.node.bus_state(BusState::error_passive, sut.now);
  EXPECT_EQ(log,
            (std::vector<std::string>{"1 raise 7", "2 raise 7", "3 raise 7", "1 clear 7",
                                      "2 clear 7", "3 clear 7", "1 bus 2", "2 bus 2", "3 bus 2"}));
}

TEST(Node, TellsOfTheControllerWhenItsStateChangesOnly) {
  WireNode sut(layout.tables(), own_id);
  Witness witness(sut.node);
  sut.node.bus_state(BusState::error_active, sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
  sut.node.bus_state(BusState::error_passive, sut.now);
  sut.node.bus_state(BusState::error_passive, sut.now);
  sut.node.bus_state(BusState::bus_off, Time(9ms));
  EXPECT_EQ(sut.node.bus_state(), BusState::bus_off);
  EXPECT_EQ(sut.node.now(), Time(9ms));
  sut.node.bus_state(BusState::error_active, sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"bus 2", "bus 3", "bus 0"}));
  EXPECT_EQ(sut.node.counters().bus_off, 1U);
}

TEST(Node, ForgetsWhatWaitsForTheControllerInBusOff) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  sut.full = true;
  sut.node.transmitter().send(wire_frame("123#01"));
  sut.node.bus_state(BusState::bus_off, sut.now);
  sut.full = false;
  sut.node.tx_ready(sut.now);
  sut.expect({});
}

TEST(Node, CountsOverrunsAndRaises8110h) {
  WireNode sut(layout.tables(), own_id);
  Witness witness(sut.node);
  sut.node.overrun(Time(3ms));
  EXPECT_EQ(sut.node.counters().overruns, 1U);
  EXPECT_EQ(sut.node.now(), Time(3ms));
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"raise 33040"}));  // 8110h
}

TEST(Node, TellsItsServicesOfRoomOnlyWhereThereIsSome) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  Witness witness(sut.node);
  sut.full = true;
  for (int i = 0; i < 16; ++i) sut.node.transmitter().send(wire_frame("123#01"));
  sut.node.tx_ready(sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
  sut.full = false;
  sut.node.tx_ready(Time(4ms));
  EXPECT_EQ(sut.sent.size(), 16U);
  EXPECT_EQ(sut.node.now(), Time(4ms));
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"tx ready"}));
}

/// Without frames that waited, no service can wait for room; a lost frame counts as well.
TEST(Node, TellsItsServicesOfRoomOnlyWhereAFrameHadToWait) {
  if (is_small_machine) GTEST_SKIP() << "a small machine notifies each time";
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  Witness witness(sut.node);
  sut.node.transmitter().send(wire_frame("123#01"));
  sut.node.tx_ready(sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
  sut.full = true;
  sut.node.transmitter().send(wire_frame("123#01"));
  sut.node.transmitter().send(wire_frame("123#02"));
  sut.node.tx_ready(sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"tx ready"})) << "there is room for others";
  sut.full = false;
  sut.node.tx_ready(sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{"tx ready"}));
  sut.node.tx_ready(sut.now);
  EXPECT_EQ(witness.take(), (std::vector<std::string>{}));
}

TEST(Node, CountsFramesThatNobodyWants) {
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  for (std::uint32_t id = 1; id <= 0x7FF; ++id) {
    sut.node.receive(Frame::data_frame(id, {}), sut.now);
  }
  EXPECT_EQ(sut.node.counters().received, 0x7FFU);
  EXPECT_EQ(sut.node.counters().unwanted, 0x7FFU);
}

TEST(Node, HandsFramesToItsRoutesWithTheirTime) {
  struct Listener {
    void receive(const Frame& frame, Time now) { heard = {frame, now}; }
    std::pair<Frame, Time> heard;
  } listener;
  WireNode sut(layout.tables(), own_id);
  sut.node.router().add(0x123, Router::Receiver::to<&Listener::receive>(listener));
  sut.node.receive(wire_frame("123#01 02"), Time(77us));
  EXPECT_EQ(listener.heard.first, wire_frame("123#01 02"));
  EXPECT_EQ(listener.heard.second, Time(77us));
  EXPECT_EQ(sut.node.now(), Time(77us));
}

TEST(Node, RunsItsTimersAtTheirDeadlines) {
  struct Bell {
    void ring(Time now) { rung = now; }
    Time rung = never;
  } bell;
  Timer timer{callback<&Bell::ring>(bell)};
  WireNode sut(layout.tables(), own_id);
  sut.boot();
  sut.node.timers().arm(timer, Time(50ms));
  EXPECT_EQ(sut.node.deadline(), Time(50ms));
  sut.run_until(Time(1s));
  EXPECT_EQ(bell.rung, Time(50ms));
  EXPECT_EQ(sut.node.deadline(), never);
}

/// A service that answers the entry of a state with a command.
struct Commander {
  Commander(Node& commanded, NmtState on, NmtCommand answer)
      : node(commanded), state(on), command(answer) {
    service.state_entered = callback<&Commander::entered>(*this);
    node.attach(service);
  }
  void entered(NmtState entered_state) {
    if (entered_state == state) node.command(command);
  }
  Node& node;
  NmtState state;
  NmtCommand command;
  Service service;
};

TEST(Node, MayBeCommandedFromInsideAService) {
  WireNode sut(layout.tables(), own_id);
  Commander commander(sut.node, NmtState::stopped, NmtCommand::reset_communication);
  sut.boot();
  sut.receive("000#02 05");
  EXPECT_EQ(sut.node.state(), NmtState::pre_operational);
  sut.expect({"705#00"});
}

TEST(Node, TellsNobodyOfAStateThatWasLeftMeanwhile) {
  WireNode sut(layout.tables(), own_id);
  Commander commander(sut.node, NmtState::operational, NmtCommand::stop);
  Witness later(sut.node);
  sut.boot();
  later.take();
  sut.receive("000#01 05");
  EXPECT_EQ(sut.node.state(), NmtState::stopped);
  EXPECT_EQ(later.take(), (std::vector<std::string>{"state 4"}));
}

TEST(Node, DoesNotStartByItselfWhatAServiceHasStopped) {
  WireNode sut(layout.tables(), own_id, true);
  Commander commander(sut.node, NmtState::pre_operational, NmtCommand::stop);
  sut.start();
  EXPECT_EQ(sut.node.state(), NmtState::stopped);
}

TEST(Node, ForgetsAtPowerOnWhatWaitedForTheControllerBefore) {
  WireNode sut(layout.tables(), own_id);
  sut.start();
  sut.full = true;
  while (!sut.node.transmitter().full()) sut.node.transmitter().send(wire_frame("123#"));
  sut.full = false;
  sut.sent.clear();
  sut.start();
  sut.expect({"705#00"});
  EXPECT_TRUE(sut.node.transmitter().idle());
}

TEST(Node, KeepsTheBootUpMessageForAFullController) {
  WireNode sut(layout.tables(), own_id);
  sut.full = true;
  sut.start();
  sut.expect({});
  sut.full = false;
  sut.now = Time(2ms);
  sut.node.tx_ready(sut.now);
  sut.expect({"@2000 705#00"});
}

}  // namespace
}  // namespace canvoy::node_test
