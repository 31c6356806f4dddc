// Further buses with faults: guarding, messages that are against CiA 301, several devices with one
// node-ID, and load by several senders.
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/doctor/testing/sick_buses.hpp"

namespace canvoy::sick {

namespace {

/// A master guards node 9 each half second; the node answers until `answers_until`.
std::unique_ptr<Clinic> guarded(bool toggles, Duration answers_until) {
  auto clinic = healthy();
  const ControllerId master = clinic->add();
  const ControllerId who = clinic->add();
  for (unsigned i = 0; i < 118; ++i) {
    const Duration at = 500ms + i * 500ms;
    clinic->send(at, master, Frame::remote_frame(can_id::error_control + sick_node, 1));
    if (at >= answers_until) continue;
    const std::uint8_t toggle = toggles && i % 2 != 0 ? 0x80 : 0x00;
    clinic->send(at + 3ms, who, state_of(sick_node, 0x05 | toggle));
  }
  return clinic;
}

/// Heartbeats of three devices with the node-ID 2, of 500 ms each.
std::unique_ptr<Clinic> triplets() {
  auto clinic = healthy();
  clinic->beat(clinic->add(), 2, 130ms);
  clinic->beat(clinic->add(), 2, 290ms);
  return clinic;
}
/// A second node 2, whose heartbeats come every 700 ms.
std::unique_ptr<Clinic> twin_of_another_period() {
  auto clinic = healthy();
  const ControllerId who = clinic->add();
  clinic->every(700ms, 123ms, [at = clinic.get(), who] { at->bus().send(who, state_of(2, 5)); });
  return clinic;
}

/// Node 1 waits for heartbeats of node 40, which is not there.
std::unique_ptr<Clinic> waits_for_nobody() {
  auto clinic = healthy();
  tells(*clinic, 0, 1, 300ms, object_index::heartbeat_consumers, 1, 4, 0x0028'03E8);
  return clinic;
}

/// One more sender sends this every five seconds.
std::unique_ptr<Clinic> sends(const Frame& frame) {
  auto clinic = healthy();
  const ControllerId who = clinic->add();
  clinic->every(5s, 3s, [at = clinic.get(), who, frame] { at->bus().send(who, frame); });
  return clinic;
}

/// A segmented upload of 14 bytes, in which the toggle bit of the second segment stays 0.
std::unique_ptr<Clinic> does_not_toggle() {
  auto clinic = healthy();
  const ControllerId client = clinic->add();
  const auto ask = [&](Duration at, std::initializer_list<std::uint8_t> bytes) {
    clinic->send(at, client, Frame::data_frame(can_id::sdo_request + 2, bytes));
  };
  const auto answer = [&](Duration at, std::initializer_list<std::uint8_t> bytes) {
    clinic->send(at, 2, Frame::data_frame(can_id::sdo_response + 2, bytes));
  };
  ask(10s, {0x40, 0x08, 0x10, 0, 0, 0, 0, 0});
  answer(10s + 2ms, {0x41, 0x08, 0x10, 0, 14, 0, 0, 0});
  ask(10s + 4ms, {0x60, 0, 0, 0, 0, 0, 0, 0});
  answer(10s + 6ms, {0x00, 'a', 'b', 'c', 'd', 'e', 'f', 'g'});
  ask(10s + 8ms, {0x70, 0, 0, 0, 0, 0, 0, 0});
  answer(10s + 10ms, {0x01, 'h', 'i', 'j', 'k', 'l', 'm', 'n'});
  return clinic;
}

/// Four senders of eight bytes each 5 ms, at 125 kbit/s: 4 * 200 * 111 bits of 125,000 at least.
std::unique_ptr<Clinic> crowded() {
  auto clinic = healthy();
  for (NodeId node = 10; node < 14; ++node) {
    const ControllerId who = clinic->add();
    clinic->every(node == 10 ? 4ms : 5ms, 1s + 1ms * node, [at = clinic.get(), who, node] {
      at->bus().send(who, pdo(node, {1, 2, 3, 4, 5, 6, 7, 8}));
    });
  }
  return clinic;
}

/// Noise for ten seconds of a minute, which strikes the PDOs of all nodes in turn.
std::unique_ptr<Clinic> noise_for_a_while() {
  auto clinic = healthy({.bit_rate = 250'000, .seed = 7});
  for (unsigned i = 0; i < 100; ++i) {
    const Duration before_pdo = 12ms + 7ms * (i % 5);
    clinic->at(40s + i * 100ms + before_pdo,
               [at = clinic.get(), i] { at->bus().disturb(1, 15 + i % 40); });
  }
  return clinic;
}

/// Node 4 is told to stop, or to be pre-operational, and sends its TPDO on.
std::unique_ptr<Clinic> sends_on(std::uint8_t command, std::uint8_t state) {
  auto clinic = std::make_unique<Clinic>();
  for (NodeId node = 1; node <= 3; ++node) clinic->add_healthy(node);
  const ControllerId master = clinic->add();
  const ControllerId who = clinic->add();
  clinic->send(5s, master, Frame::data_frame(can_id::nmt, {command, sick_node}));
  clinic->every(500ms, 200ms, [at = clinic.get(), who, state] {
    const bool is_told = at->bus().now() >= Time(5s);
    at->bus().send(who, state_of(sick_node, is_told ? state : std::uint8_t{5}));
  });
  clinic->every(100ms, 250ms, [at = clinic.get(), who] {
    at->bus().send(who, pdo(sick_node, {1, 2}));
  });
  return clinic;
}

/// Two devices send the time of day, each every ten seconds.
std::unique_ptr<Clinic> two_clocks() {
  auto clinic = healthy();
  for (const Duration first : {2s, 5s}) {
    const ControllerId who = clinic->add();
    clinic->every(10s, first, [at = clinic.get(), who, is_late = first == 5s] {
      const auto ms = static_cast<std::uint8_t>(is_late ? 90 : 10);
      at->bus().send(who, Frame::data_frame(0x100, {ms, 1, 2, 3, 0x10, 0x3D}));
    });
  }
  return clinic;
}

}  // namespace

std::vector<SickBusRow> other_rows() {
  using enum FindingKind;
  return {
      {"AGuardedNodeFallsSilent", heartbeat_missing, sick_node, 0,
       [] { return guarded(true, 30s); }},
      {"AGuardedNodeNeverAnswers", heartbeat_missing, sick_node, 0,
       [] { return guarded(true, 0s); }},
      {"AGuardedNodeDoesNotToggle", against_protocol, sick_node, 0,
       [] { return guarded(false, 60s); }},
      {"ThreeDevicesHaveOneNodeId", node_id_twice, 2, 0, triplets},
      {"ATwinHasAnotherPeriod", node_id_twice, 2, 0, twin_of_another_period},
      {"AConsumerWaitsForANodeThatIsNotThere", heartbeat_missing, 40, 0, waits_for_nobody},
      {"SyncHasTwoBytes", against_protocol, 0, 0,
       [] {
         return sends(Frame::data_frame(can_id::sync, {1, 2}));
       }},
      {"AHeartbeatTellsNoState", against_protocol, sick_node, 0,
       [] { return sends(state_of(sick_node, 0x03)); }},
      {"AnEmergencyIsTooShort", against_protocol, 3, 0,
       [] {
         return sends(Frame::data_frame(can_id::emergency + 3, {0, 0, 0, 0, 0}));
       }},
      {"AnNmtCommandIsTooShort", against_protocol, 0, 0,
       [] { return sends(Frame::data_frame(can_id::nmt, {0x01})); }},
      {"AnNmtCommandStandsForNothing", against_protocol, 0, 0,
       [] {
         return sends(Frame::data_frame(can_id::nmt, {0x55, 0x03}));
       }},
      {"AToggleBitStays", against_protocol, 2, 0, does_not_toggle},
      {"FourSendersFillTheBus", load_peak, 10, 0, crowded},
      {"NoiseForAWhile", bus_errors, 0, 0, noise_for_a_while},
      {"AStoppedNodeSendsPdos", against_protocol, sick_node, 0,
       [] { return sends_on(0x02, 0x04); }},
      {"APreOperationalNodeSendsPdos", against_protocol, sick_node, 0,
       [] { return sends_on(0x80, 0x7F); }},
      {"TwoDevicesTellTheTime", cob_id_twice, 0, 0x100, two_clocks},
  };
}

}  // namespace canvoy::sick
