// Store and restore without their signature (CiA 301, 7.5.2.13 and 7.5.2.14), and restricted
// CAN-IDs (CiA 301, 7.3.5).
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/bench/own_pdo.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

/// An end of each range of CiA 301, 7.3.5; 180h is used by CiA 417, and not tested.
constexpr std::uint32_t restricted_ends[] = {0x001, 0x07F, 0x101, 0x17F, 0x581, 0x5FF, 0x601,
                                             0x67F, 0x6E0, 0x6FF, 0x701, 0x77F, 0x780, 0x7FF};

/// `flags` are added to each.
Verdict judge_restricted(Bench& bench, std::uint16_t index, std::uint8_t sub, std::uint32_t flags) {
  const std::string place = text::object_text(index, sub);
  // A client may use the default server of any node.
  const bool is_client = index == object_index::sdo_client;
  for (const std::uint32_t id : restricted_ends) {
    if (is_client && id > can_id::sdo_request && id <= can_id::sdo_request + node_id_max) continue;
    const Reply done = bench.set(index, sub, id | flags, 4);
    if (done.has_aborted(AbortCode::read_only)) return cannot_set(place, done);
    if (done) return failed(fmt::format("{} takes {:03X}h", place, id));
    if (!done.has_aborted(AbortCode::value_range)) {
      return failed(fmt::format("{} = {:03X}h: {}", place, id, done.text()));
    }
  }
  return passed();
}

Verdict judge_sync_ids(Bench& bench) {
  if (!bench.has(object_index::cob_id_sync)) return not_applicable("the device has no 1005h");
  return judge_restricted(bench, object_index::cob_id_sync, 0, 0);
}
Verdict judge_time_ids(Bench& bench) {
  if (!bench.has(object_index::cob_id_time)) return not_applicable("the device has no 1012h");
  const auto now = bench.number(object_index::cob_id_time, 0).value_or(0);
  if ((now & (CobId::bit31 | CobId::bit30)) != 0) {
    const Reply done = bench.set(object_index::cob_id_time, 0, now & Frame::id_max, 4);
    if (!done) return cannot_set("1012h", done);
  }
  return judge_restricted(bench, object_index::cob_id_time, 0, 0);
}

/// Objects that bit 31 switches off before their CAN-ID may change.
Verdict judge_switched_ids(Bench& bench, std::uint16_t index, std::uint8_t sub) {
  const auto now = bench.number(index, sub);
  if (!now) return not_applicable(fmt::format("the device has no {:04X}h", index));
  const Reply done = bench.set(index, sub, *now | CobId::bit31, 4);
  if (!done) return cannot_set(text::object_text(index, sub), done);
  return judge_restricted(bench, index, sub, 0);
}
Verdict judge_emergency_ids(Bench& bench) {
  return judge_switched_ids(bench, object_index::cob_id_emergency, 0);
}
Verdict judge_server_ids(Bench& bench) {
  return judge_switched_ids(bench, object_index::sdo_server + 1, 1);
}
Verdict judge_client_ids(Bench& bench) {
  return judge_switched_ids(bench, object_index::sdo_client, 1);
}
Verdict judge_pdo_ids(Bench& bench, PdoWay way) {
  const auto pdo = find_pdo(bench, way);
  if (!pdo) return not_applicable("the device has none that carries anything");
  if (auto cannot = disable(bench, *pdo)) return *cannot;
  return judge_restricted(bench, pdo->parameter, 1, pdo->cob_id & CobId::bit30);
}
Verdict judge_rpdo_ids(Bench& bench) {
  return judge_pdo_ids(bench, PdoWay::receive);
}
Verdict judge_tpdo_ids(Bench& bench) {
  return judge_pdo_ids(bench, PdoWay::transmit);
}

/// The reverse of "evas" is no signature.
constexpr std::uint32_t no_signature = 0x7361'7665;

Verdict judge_signature(Bench& bench, std::uint16_t index) {
  if (!bench.has(index)) return not_applicable(fmt::format("the device has no {:04X}h", index));
  const auto count = bench.number(index, 0).value_or(0);
  unsigned tried = 0;
  for (unsigned sub = 1; sub <= std::min(count, 127U); ++sub) {
    const Reply done = bench.write(index, static_cast<std::uint8_t>(sub), no_signature, 4);
    if (done.is_absent() || done.has_aborted(AbortCode::read_only)) continue;
    ++tried;
    if (done.has_aborted(AbortCode::cannot_store)) continue;
    return failed(fmt::format("{} = {:08X}h: {}",
                              text::object_text(index, static_cast<std::uint8_t>(sub)),
                              no_signature, done.text()));
  }
  return tried == 0 ? not_applicable(fmt::format("no entry of {:04X}h is written", index))
                    : passed();
}
Verdict judge_store_signature(Bench& bench) {
  return judge_signature(bench, object_index::store_parameters);
}
Verdict judge_restore_signature(Bench& bench) {
  return judge_signature(bench, object_index::restore_parameters);
}

/// Bits 0 and 1 give its abilities; the others are reserved.
Verdict judge_abilities(Bench& bench) {
  if (!bench.has(object_index::store_parameters)) return not_applicable("the device has no 1010h");
  const auto bits = bench.number(object_index::store_parameters, 1);
  if (!bits) return failed("1010h:01h is not read");
  return *bits <= 3 ? passed() : failed(fmt::format("1010h:01h is {:08X}h", *bits));
}

constexpr std::string_view restricted_clause = "CiA 301, 7.3.5";
constexpr std::string_view restricted_sends = "001h, 07Fh, 101h ... 7FFh: the ends of its ranges";
constexpr CaseRow store_rows[] = {
    {"store-01", "CiA 301, 7.5.2.13", "1010h says what it does by bits 0 and 1", "an upload",
     "0 to 3", judge_abilities},
    {"store-02", "CiA 301, 7.5.2.13", "nothing is stored without its signature",
     "1010h = 7361 7665h", "0800 0020h", judge_store_signature},
    {"store-03", "CiA 301, 7.5.2.14", "nothing is restored without its signature",
     "1011h = 7361 7665h", "0800 0020h", judge_restore_signature},
    {"can-id-01", restricted_clause, "1005h takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_sync_ids},
    {"can-id-02", restricted_clause, "1012h takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_time_ids},
    {"can-id-03", restricted_clause, "1014h takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_emergency_ids},
    {"can-id-04", restricted_clause, "an RPDO takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_rpdo_ids},
    {"can-id-05", restricted_clause, "a TPDO takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_tpdo_ids},
    {"can-id-06", restricted_clause, "1201h takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_server_ids},
    {"can-id-07", restricted_clause, "1280h takes no restricted CAN-ID", restricted_sends,
     "0609 0030h", judge_client_ids},
};

}  // namespace

void add_store_cases(TestCases& cases) {
  add_rows(cases, Group::store, store_rows);
}

}  // namespace canvoy::conformance
