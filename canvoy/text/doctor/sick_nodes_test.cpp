// Buses with faults of nodes: heartbeats, boot-ups, emergencies and SDO servers.
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/doctor/testing/sick_buses.hpp"

namespace canvoy::sick {

namespace {

/// A second device with the heartbeats of node 2, delayed by this time.
std::unique_ptr<Clinic> twin(Duration behind) {
  auto clinic = healthy();
  clinic->beat(clinic->add(), 2, behind);
  return clinic;
}

/// Two devices with the heartbeats of one node, each with its period (1017h), which no client
/// reads.
std::unique_ptr<Clinic> twins(Duration one, Duration other) {
  auto clinic = healthy();
  for (const Duration period : {one, other}) {
    clinic->every(period, period / 3, [at = clinic.get(), who = clinic->add()] {
      at->bus().send(who, state_of(sick_node, 5));
    });
  }
  return clinic;
}

/// Half a period later, and in another state; the period is unknown.
std::unique_ptr<Clinic> twin_in_other_state() {
  auto clinic = healthy();
  for (const std::uint8_t state : {std::uint8_t{5}, std::uint8_t{0x7F}}) {
    const ControllerId who = clinic->add();
    clinic->every(1s, state == 5 ? 100ms : 600ms, [at = clinic.get(), who, state] {
      at->bus().send(who, state_of(sick_node, state));
    });
  }
  return clinic;
}

/// Both start at the same time, and report different states.
std::unique_ptr<Clinic> twin_at_once() {
  auto clinic = healthy();
  clinic->collide(state_of(sick_node, 5), state_of(sick_node, 0x7F));
  return clinic;
}

std::unique_ptr<Clinic> twin_answers() {
  auto clinic = healthy();
  const ControllerId twin = clinic->add();
  for (unsigned i = 1; i <= 4; ++i) {
    tells(*clinic, 0, 1, i * 5s, object_index::device_type, 0, 4, 0x191);
    clinic->send(i * 5s + 7ms, twin,
                 Frame::data_frame(can_id::sdo_response + 1, {0x43, 0, 0x10, 0, 0x92, 1, 0, 0}));
  }
  return clinic;
}

/// One more node, with heartbeats at these intervals, in milliseconds, and 1017h of 500 ms.
std::unique_ptr<Clinic> beats(const std::vector<unsigned>& intervals) {
  auto clinic = healthy();
  const ControllerId who = clinic->add();
  tells(*clinic, who, sick_node, 200ms, object_index::heartbeat_producer, 0, 2, 500);
  Duration at = 500ms;
  for (std::size_t i = 0; at < 60s; ++i) {
    clinic->send(at, who, state_of(sick_node, 5));
    at += Duration(1ms) * intervals[i % intervals.size()];
  }
  return clinic;
}

std::unique_ptr<Clinic> loses_power(NodeId node, Duration from, Duration length) {
  auto clinic = healthy();
  const auto who = static_cast<ControllerId>(node == 1 ? 0 : node);
  clinic->at(from, [at = clinic.get(), who] { at->bus().power(who, false); });
  if (length != Duration::max()) {
    clinic->at(from + length, [at = clinic.get(), who] { at->bus().power(who, true); });
  }
  return clinic;
}

/// A consumer with a time shorter than the heartbeat period of node 3.
std::unique_ptr<Clinic> impatient_consumer(unsigned milliseconds) {
  auto clinic = healthy();
  tells(*clinic, 0, 1, 300ms, object_index::heartbeat_consumers, 1, 4, 0x0003'0000 | milliseconds);
  return clinic;
}

std::unique_ptr<Clinic> reboots(NodeId node, const std::vector<Duration>& times) {
  auto clinic = healthy();
  const auto who = static_cast<ControllerId>(node == 1 ? 0 : node);
  for (const Duration time : times) clinic->send(time, who, state_of(node, 0));
  return clinic;
}

std::unique_ptr<Clinic> storm(NodeId node, unsigned count, Duration period, std::uint16_t code) {
  auto clinic = healthy();
  const auto who = static_cast<ControllerId>(node == 1 ? 0 : node);
  for (unsigned i = 0; i < count; ++i) {
    clinic->send(15s + i * period, who,
                 Frame::data_frame(can_id::emergency + node,
                                   {static_cast<std::uint8_t>(code),
                                    static_cast<std::uint8_t>(code >> 8U), 1, 0, 0, 0, 0, 0}));
  }
  return clinic;
}

/// Node 4 leaves requests unanswered; a client that gives up aborts after a second.
std::unique_ptr<Clinic> mute(const std::vector<Duration>& times, bool aborts) {
  auto clinic = healthy();
  const ControllerId client = clinic->add();
  for (const Duration time : times) {
    clinic->ask(time, 4, 0x00, 0x10, 0);
    if (!aborts) continue;
    clinic->send(time + 1s, client,
                 Frame::data_frame(can_id::sdo_request + 4, {0x80, 0, 0x10, 0, 0, 0, 0x04, 0x05}));
  }
  return clinic;
}

std::unique_ptr<Clinic> slow(NodeId node, Duration later, unsigned count) {
  auto clinic = healthy();
  for (unsigned i = 1; i <= count; ++i) {
    clinic->answer(static_cast<ControllerId>(node == 1 ? 0 : node), node, i * 6s,
                   "\x43\x00\x10\x00\x91\x01\x00\x00", later);
  }
  return clinic;
}

std::vector<SickBusRow> heartbeat_rows() {
  using enum FindingKind;
  return {
      {"TwinAFifthBehind", node_id_twice, 2, 0, [] { return twin(100ms); }},
      {"TwinHalfAPeriodBehind", node_id_twice, 2, 0, [] { return twin(250ms); }},
      {"TwinsAtFiveAndSevenTenths", node_id_twice, sick_node, 0,
       [] { return twins(500ms, 700ms); }},
      {"TwinsAtASecondAndATenthLess", node_id_twice, sick_node, 0, [] { return twins(900ms, 1s); }},
      {"TwinsAtASecondAndTwo", node_id_twice, sick_node, 0, [] { return twins(1s, 2s); }},
      {"TwinsAtATenthAndASecond", node_id_twice, sick_node, 0, [] { return twins(100ms, 1s); }},
      {"TwinsAtTwoSecondsAndFive", node_id_twice, sick_node, 0, [] { return twins(5s, 2s); }},
      {"TwinInAnotherState", node_id_twice, sick_node, 0, twin_in_other_state},
      {"TwinAtOnceInAnotherState", node_id_twice, sick_node, 0, twin_at_once},
      {"TwinAnswers", node_id_twice, 1, 0, twin_answers},
      {"ANodeLosesItsPower", heartbeat_missing, 3, 0,
       [] { return loses_power(3, 20s, Duration::max()); }},
      {"ANodeIsAwayForThreeSeconds", heartbeat_missing, 5, 0,
       [] { return loses_power(5, 30s, 3s); }},
      {"ANodeBeatsMuchTooSeldom", heartbeat_missing, sick_node, 0, [] { return beats({2600}); }},
      {"AConsumerIsImpatient", heartbeat_missing, 3, 0, [] { return impatient_consumer(450); }},
      {"SomeHeartbeatsAreLate", heartbeat_late, sick_node, 0,
       [] {
         return beats({500, 500, 500, 500, 500, 500, 500, 500, 900, 500, 500, 500, 500, 500, 500});
       }},
      {"AllHeartbeatsAreLate", heartbeat_late, sick_node, 0, [] { return beats({1100}); }},
      {"HeartbeatsAreLateNowAndThen", heartbeat_late, sick_node, 0,
       [] {
         return beats({500, 500, 700, 500, 500, 500, 500, 500, 500, 500, 500, 500, 800});
       }},
      {"HeartbeatsAreUneven", heartbeat_jitter, sick_node, 0,
       [] {
         return beats({390, 500, 620, 610, 380, 510, 500, 615, 395, 480});
       }},
      {"HeartbeatsAreUnevenByAThird", heartbeat_jitter, sick_node, 0,
       [] {
         return beats({340, 500, 500, 620, 500, 330, 500, 500});
       }},
      {"HeartbeatsComeTooSoon", heartbeat_jitter, sick_node, 0,
       [] {
         return beats({300, 500, 350, 500, 320, 500, 500});
       }},
  };
}

}  // namespace

std::vector<SickBusRow> node_rows() {
  using enum FindingKind;
  std::vector<SickBusRow> rows = heartbeat_rows();
  const std::vector<SickBusRow> others = {
      {"ANodeStartsByItself", unexpected_boot_up, 2, 0, [] { return reboots(2, {25s}); }},
      {"ANodeStartsAgainAndAgain", unexpected_boot_up, 4, 0,
       [] {
         return reboots(4, {10s, 20s, 33s, 41s});
       }},
      {"ANodeStartsAtTheEnd", unexpected_boot_up, 1, 0, [] { return reboots(1, {59s}); }},
      {"EmergenciesOfABouncingContact", emergency_storm, 3, 0,
       [] { return storm(3, 40, 100ms, 0x5000); }},
      {"EmergenciesOfOverload", emergency_storm, 1, 0, [] { return storm(1, 15, 600ms, 0x2310); }},
      {"EmergenciesOfTheBus", emergency_storm, 5, 0, [] { return storm(5, 200, 20ms, 0x8110); }},
      {"AnErrorThatStands", reported_error, 3, 0, [] { return storm(3, 1, 1s, 0x3100); }},
      {"AnErrorNowAndThen", reported_error, 1, 0, [] { return storm(1, 4, 9s, 0x4210); }},
      {"AnErrorOfTheBusThatNothingExplains", reported_error, 5, 0,
       [] { return storm(5, 2, 9s, 0x8130); }},
      {"AnErrorThatIsGone", reported_error, 2, 0,
       [] {
         auto clinic = storm(2, 1, 1s, 0x5010);
         clinic->send(20s, 2, Frame::data_frame(can_id::emergency + 2, {0, 0, 0, 0, 0, 0, 0, 0}));
         return clinic;
       }},
      {"ANodeDoesNotAnswerAndIsAborted", sdo_time_out, 4, 0,
       [] {
         return mute({10s, 20s, 30s}, true);
       }},
      {"ANodeDoesNotAnswerAndIsAskedAgain", sdo_time_out, 4, 0,
       [] {
         return mute({10s, 12s}, false);
       }},
      {"ANodeDoesNotAnswerAtTheEnd", sdo_time_out, 4, 0, [] { return mute({57s}, false); }},
      {"AnAnswerTakesLong", sdo_slow, 2, 0, [] { return slow(2, 400ms, 1); }},
      {"AnswersTakeLong", sdo_slow, 3, 0, [] { return slow(3, 900ms, 8); }},
      {"AnswersTakeSeconds", sdo_slow, 1, 0, [] { return slow(1, 2500ms, 4); }},
  };
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

}  // namespace canvoy::sick
