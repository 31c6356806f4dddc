// Buses with faults of PDOs and their values.
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/text/doctor/testing/sick_buses.hpp"

namespace canvoy::sick {

namespace {

/// Reports 1800h of the node: type, inhibit time in 100 us, event timer in ms.
void report_pdo(Clinic& clinic, ControllerId who, NodeId node, std::uint32_t type,
                std::uint32_t inhibit, std::uint32_t timer) {
  using object_index::tpdo_parameter;
  // Two devices report the same, at different times.
  const Duration at = 1ms * (200 + 100 * who);
  tells(clinic, who, node, at, tpdo_parameter, 1, 4, can_id::tpdo1 + node);
  tells(clinic, who, node, at + 10ms, tpdo_parameter, 2, 1, type);
  tells(clinic, who, node, at + 20ms, tpdo_parameter, 3, 2, inhibit);
  tells(clinic, who, node, at + 30ms, tpdo_parameter, 5, 2, timer);
}

/// Reports 1A00h of the node: this number of entries of two bytes.
void report_mapping(Clinic& clinic, ControllerId who, NodeId node, std::uint8_t count) {
  for (std::uint8_t sub = 1; sub <= count; ++sub) {
    tells(clinic, who, node, 1ms * (300 + 10 * sub), object_index::tpdo_mapping, sub, 4,
          0x2000'0010U + (std::uint32_t{sub} << 8U));
  }
  tells(clinic, who, node, 400ms, object_index::tpdo_mapping, 0, 1, count);
}

std::unique_ptr<Clinic> two_lengths(std::uint16_t id, Duration behind) {
  auto clinic = healthy();
  for (const unsigned length : {4U, 8U}) {
    const ControllerId who = clinic->add();
    const std::array<std::uint8_t, 8> bytes{};
    const Frame frame = Frame::data_frame(id, std::span(bytes).first(length));
    clinic->every(500ms, length == 4 ? 100ms : 100ms + behind,
                  [at = clinic.get(), who, frame] { at->bus().send(who, frame); });
  }
  return clinic;
}

std::unique_ptr<Clinic> two_rhythms(Duration behind) {
  auto clinic = healthy();
  for (const bool is_second : {false, true}) {
    const ControllerId who = clinic->add();
    if (!is_second) report_pdo(*clinic, who, sick_node, 255, 0, 200);
    clinic->every(200ms, is_second ? 1s + behind : 1s, [at = clinic.get(), who, is_second] {
      at->bus().send(who, pdo(sick_node, {1, static_cast<std::uint8_t>(is_second ? 2 : 1)}));
    });
  }
  return clinic;
}

std::unique_ptr<Clinic> at_once(std::uint16_t id) {
  auto clinic = healthy();
  clinic->collide(Frame::data_frame(id, {0x11, 0}), Frame::data_frame(id, {0x22, 0}));
  return clinic;
}

/// Two nodes report that they send 189h.
std::unique_ptr<Clinic> reported_twice() {
  auto clinic = healthy();
  for (const NodeId node : {sick_node, NodeId{10}}) {
    const ControllerId who = clinic->add();
    tells(*clinic, who, node, 100ms * node, object_index::tpdo_parameter, 1, 4,
          can_id::tpdo1 + sick_node);
    if (node == sick_node) {
      clinic->every(300ms, 2s, [at = clinic.get(), who] { at->bus().send(who, pdo(9, {1, 2})); });
    }
  }
  return clinic;
}

std::unique_ptr<Clinic> length(std::uint8_t mapped, std::initializer_list<std::uint8_t> bytes,
                               unsigned count) {
  auto clinic = healthy();
  const ControllerId who = clinic->add();
  tells(*clinic, who, sick_node, 200ms, object_index::tpdo_parameter, 1, 4,
        can_id::tpdo1 + sick_node);
  report_mapping(*clinic, who, sick_node, mapped);
  for (unsigned i = 0; i < count; ++i) clinic->send(2s + i * 500ms, who, pdo(sick_node, bytes));
  return clinic;
}

/// SYNC every 100 ms, and a window of 10 ms; the PDO comes this time after SYNC.
std::unique_ptr<Clinic> late_behind_sync(Duration behind, std::uint32_t window_us, unsigned every) {
  auto clinic = healthy();
  const ControllerId master = clinic->add();
  const ControllerId who = clinic->add();
  report_pdo(*clinic, who, sick_node, every, 0, 0);
  tells(*clinic, who, sick_node, 1500ms, object_index::sync_window, 0, 4, window_us);
  for (unsigned i = 0; i < 500; ++i) {
    const Duration sync = 1s + i * 100ms;
    clinic->send(sync, master, Frame::data_frame(can_id::sync, {}));
    if (i % every != 0) continue;
    const bool is_late = i % 5 == 0;
    clinic->send(sync + (is_late ? behind : 2ms), who, pdo(sick_node, {1, 2}));
  }
  return clinic;
}

/// A node that reports 1005h and 1006h (in us).
void report_sync(Clinic& clinic, ControllerId who, NodeId node, std::uint32_t cob_id,
                 std::uint32_t period_us) {
  const Duration at = 1ms * (1000 + 100 * who);
  tells(clinic, who, node, at, object_index::cob_id_sync, 0, 4, cob_id);
  tells(clinic, who, node, at + 20ms, object_index::sync_period, 0, 4, period_us);
}
constexpr std::uint32_t produced = CobId::bit30 | can_id::sync;
/// Adds SYNC every 100 ms, from `first` on; with a counter if it starts above 0.
ControllerId add_sync(Clinic& clinic, Duration first, std::uint8_t counter = 0,
                      Duration period = 100ms) {
  const ControllerId who = clinic.add();
  const bool counts = counter != 0;
  clinic.every(period, first, [&clinic, who, counts, counter]() mutable {
    clinic.bus().send(who, counts ? Frame::data_frame(can_id::sync, {counter})
                                  : Frame::data_frame(can_id::sync, {}));
    counter = static_cast<std::uint8_t>(counter % 240 + 1);
  });
  return who;
}
std::unique_ptr<Clinic> two_syncs(Duration behind, std::uint8_t counter, bool are_told) {
  auto clinic = healthy();
  for (const bool is_second : {false, true}) {
    const std::uint8_t start = counter == 0 || !is_second ? counter : 100;
    const ControllerId who = add_sync(*clinic, is_second ? 2s + behind : 2s, start);
    if (are_told) report_sync(*clinic, who, is_second ? NodeId{10} : sick_node, produced, 100'000);
  }
  return clinic;
}
/// Both report that they produce SYNC, and one is heard.
std::unique_ptr<Clinic> second_producer_waits() {
  auto clinic = healthy();
  const ControllerId who = add_sync(*clinic, 2s);
  report_sync(*clinic, who, sick_node, produced, 100'000);
  report_sync(*clinic, clinic->add(), 10, produced, 100'000);
  return clinic;
}
/// Its period differs from the reported one.
std::unique_ptr<Clinic> sync_of_another_period(Duration period) {
  auto clinic = healthy();
  const ControllerId who = add_sync(*clinic, 2s, 0, period);
  report_sync(*clinic, who, sick_node, produced, 100'000);
  return clinic;
}
/// A node with a synchronous PDO waits for 081h.
std::unique_ptr<Clinic> waits_for_another_sync() {
  auto clinic = healthy();
  const ControllerId producer = add_sync(*clinic, 2s);
  report_sync(*clinic, producer, 10, produced, 100'000);
  const ControllerId who = clinic->add();
  report_pdo(*clinic, who, sick_node, 1, 0, 0);
  tells(*clinic, who, sick_node, 1900ms, object_index::cob_id_sync, 0, 4, 0x81);
  return clinic;
}

std::unique_ptr<Clinic> hasty(std::uint32_t inhibit, Duration interval, unsigned count) {
  auto clinic = healthy();
  const ControllerId who = clinic->add();
  report_pdo(*clinic, who, sick_node, 254, inhibit, 0);
  for (unsigned i = 0; i < count; ++i)
    clinic->send(5s + i * interval, who,
                 pdo(sick_node, {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i % 3)}));
  return clinic;
}

}  // namespace

std::vector<SickBusRow> pdo_rows() {
  using enum FindingKind;
  return {
      {"TwoLengthsOfATpdo", cob_id_twice, sick_node, 0x189,
       [] { return two_lengths(0x189, 100ms); }},
      {"TwoLengthsOfAFreeCanId", cob_id_twice, 0, 0x6A0, [] { return two_lengths(0x6A0, 250ms); }},
      {"TwoRhythmsOfATpdo", cob_id_twice, sick_node, 0x189, [] { return two_rhythms(50ms); }},
      {"TwoRhythmsHalfAPeriodApart", cob_id_twice, sick_node, 0x189,
       [] { return two_rhythms(100ms); }},
      {"TwoSendATpdoAtOnce", cob_id_twice, sick_node, 0x289, [] { return at_once(0x289); }},
      {"TwoAreToldToSendIt", cob_id_twice, sick_node, 0x189, reported_twice},
      {"TwoSyncInTwoRhythms", sync_twice, 0, 0x080, [] { return two_syncs(30ms, 0, false); }},
      {"TwoSyncHalfAPeriodApartThatTellIt", sync_twice, 0, 0x080,
       [] { return two_syncs(50ms, 0, true); }},
      {"TwoCountersOfSync", sync_twice, 0, 0x080, [] { return two_syncs(50ms, 1, false); }},
      {"TwoAreToldToProduceSync", sync_twice, 0, 0x080, second_producer_waits},
      {"SyncIsFasterThanItsPeriod", sync_differs, sick_node, 0x080,
       [] { return sync_of_another_period(40ms); }},
      {"SyncIsSlowerThanItsPeriod", sync_differs, sick_node, 0x080,
       [] { return sync_of_another_period(200ms); }},
      {"ANodeWaitsForAnotherSync", sync_differs, sick_node, 0x080, waits_for_another_sync},
      {"APdoIsTooShort", pdo_length, sick_node, 0x189,
       [] {
         return length(4, {1, 2, 3, 4, 5, 6}, 50);
       }},
      {"APdoIsTooLong", pdo_length, sick_node, 0x189,
       [] {
         return length(2, {1, 2, 3, 4, 5, 6, 7, 8}, 50);
       }},
      {"APdoIsEmpty", pdo_length, sick_node, 0x189, [] { return length(1, {}, 3); }},
      {"ASynchronousPdoIsLate", sync_window, sick_node, 0x189,
       [] { return late_behind_sync(15ms, 10'000, 1); }},
      {"ASynchronousPdoIsNearlyInTheNextCycle", sync_window, sick_node, 0x189,
       [] { return late_behind_sync(90ms, 20'000, 1); }},
      {"APdoOfEachFifthSyncIsLate", sync_window, sick_node, 0x189,
       [] { return late_behind_sync(9ms, 5'000, 5); }},
      {"APdoIgnoresItsInhibitTime", inhibit_time, sick_node, 0x189,
       [] { return hasty(1000, 20ms, 100); }},
      {"APdoHastensNowAndThen", inhibit_time, sick_node, 0x189,
       [] { return hasty(5000, 200ms, 6); }},
      {"APdoIsSentAsFastAsItGoes", inhibit_time, sick_node, 0x189,
       [] { return hasty(100, 3ms, 60); }},
  };
}

namespace {

/// A battery (CiA 418) as node 9, without a known TPDO: 180h + ID has temperature and status.
std::unique_ptr<Clinic> battery(std::initializer_list<std::uint8_t> bytes, unsigned count) {
  auto clinic = healthy();
  clinic->doctor().network().set_profile(sick_node, cia418::profile);
  const ControllerId who = clinic->add();
  for (unsigned i = 0; i < count; ++i) clinic->send(2s + i * 1s, who, pdo(sick_node, bytes));
  return clinic;
}
std::unique_ptr<Clinic> battery_tells(std::uint16_t index, unsigned bytes, std::uint32_t value) {
  auto clinic = healthy();
  clinic->doctor().network().set_profile(sick_node, cia418::profile);
  tells(*clinic, clinic->add(), sick_node, 5s, index, 0, bytes, value);
  return clinic;
}

/// A car with this value in node 9.
std::unique_ptr<Clinic> car_tells(std::uint16_t index, unsigned bytes, std::uint32_t value) {
  auto clinic = std::make_unique<Clinic>();
  clinic->doctor().network().set_profile(sick_node, cia447::profile);
  const ControllerId who = clinic->add();
  clinic->beat(who, sick_node);
  tells(*clinic, who, sick_node, 5s, index, 0, bytes, value);
  return clinic;
}

std::unique_ptr<Clinic> says(NodeId node, const Frame& request, const Frame& answer) {
  auto clinic = healthy();
  const ControllerId client = clinic->add();
  clinic->send(10s, client, request);
  clinic->send(10s + 3ms, static_cast<ControllerId>(node == 1 ? 0 : node), answer);
  return clinic;
}

/// The sheet of node 2 describes an entry, and the device has `value` in this number of bytes; 0:
/// the entry does not exist.
std::unique_ptr<Clinic> differs(std::uint16_t index, const formats::SheetEntry& entry,
                                unsigned bytes, std::uint32_t value) {
  static std::vector<std::unique_ptr<formats::DataSheet>> sheets;  // must outlive the doctors
  formats::DataSheet& sheet = *sheets.emplace_back(std::make_unique<formats::DataSheet>());
  sheet.objects[index].own = entry;
  // The object that is read from the healthy node.
  sheet.objects[object_index::heartbeat_producer].own = {.data_type = 6, .access = "rw"};
  auto clinic = healthy();
  clinic->doctor().add_sheet(2, sheet);
  constexpr ControllerId node_two = 2;
  if (bytes != 0) {
    tells(*clinic, node_two, 2, 7s, index, 0, bytes, value);
  } else {
    const std::array<char, 8> abort = {static_cast<char>(0x80),
                                       static_cast<char>(index),
                                       static_cast<char>(index >> 8U),
                                       0,
                                       0,
                                       0,
                                       0x02,
                                       0x06};
    clinic->answer(node_two, 2, 7s, abort.data());
  }
  return clinic;
}

}  // namespace

std::vector<SickBusRow> value_rows() {
  using enum FindingKind;
  return {
      // Bits 1 to 7 of the battery status are reserved; 6081h is 0 to 100 % (CiA 418).
      {"AReservedBitInAPdo", reserved_value, sick_node, 0,
       [] {
         return battery({0xA0, 0, 3}, 20);
       }},
      {"AReservedBitOnce", reserved_value, sick_node, 0,
       [] {
         return battery({0xA0, 0, 0x80}, 1);
       }},
      {"AReservedValueBySdo", reserved_value, sick_node, 0,
       [] { return battery_tells(0x6000, 1, 0x41); }},
      // The second highest code of a status is `Failure` (CiA 447-3).
      {"ADistanceIsNotThere", failed_value, sick_node, 0,
       [] { return car_tells(0x60C0, 2, 0xFFFE); }},
      {"ASpeedIsNotThere", failed_value, sick_node, 0, [] { return car_tells(0x605A, 2, 0xFFFE); }},
      {"AnOdometerIsNotThere", failed_value, sick_node, 0,
       [] { return car_tells(0x605B, 3, 0xFF'FFFE); }},
      {"AnSdoCommandThatStandsForNothing", against_protocol, 2, 0,
       [] {
         return says(2, Frame::data_frame(0x602, {0xE0, 0, 0x10, 0, 0, 0, 0, 0}),
                     Frame::data_frame(0x582, {0x80, 0, 0x10, 0, 1, 0, 4, 5}));
       }},
      {"AnSdoAnswerIsTooShort", against_protocol, 3, 0,
       [] {
         return says(3, Frame::data_frame(0x583, {0x60, 0, 0x10, 0}), pdo(3, {0, 0, 0, 0}));
       }},
      {"AnAnswerToAnotherQuestion", against_protocol, 4, 0,
       [] {
         return says(4, Frame::data_frame(0x604, {0x40, 0, 0x10, 0, 0, 0, 0, 0}),
                     Frame::data_frame(0x584, {0x4F, 0x01, 0x10, 0, 0, 0, 0, 0}));
       }},
      {"AnotherDeviceType", sheet_differs, 2, 0,
       [] {
         return differs(0x1000, {.data_type = 7, .access = "ro", .default_value = "0x191"}, 4,
                        0x192);
       }},
      {"AnObjectIsMissing", sheet_differs, 2, 0,
       [] { return differs(0x2000, {.data_type = 7, .access = "rw"}, 0, 0); }},
      {"AnObjectHasAnotherLength", sheet_differs, 2, 0,
       [] { return differs(0x2001, {.data_type = 5, .access = "ro"}, 4, 1); }},
  };
}

}  // namespace canvoy::sick
