// Transmission and reception of PDOs (CiA 301, 7.2.2), and SYNC (CiA 301, 7.2.5, 7.5.2.5, 7.5.2.6,
// 7.5.2.22).
#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/bench/own_pdo.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

std::size_t count_of(const std::vector<Heard>& all, std::uint32_t id) {
  return static_cast<std::size_t>(std::ranges::count_if(
      all, [id](const Heard& each) { return each.frame.id == id && each.frame.is_plain(); }));
}

/// The first TPDO, prepared, and the device in that state.
struct Stage {
  std::optional<Verdict> cannot = {};
  OwnPdo pdo = {};
};
Stage set_stage(Bench& bench, const Sending& sending, NmtCommand command = NmtCommand::start) {
  const auto pdo = find_pdo(bench, PdoWay::transmit);
  if (!pdo) return {not_applicable("the device has no TPDO that carries anything"), {}};
  if (auto cannot = arrange(bench, *pdo, sending)) return {cannot, {}};
  bench.command(command);
  bench.listen(20ms);
  return {{}, *pdo};
}

/// Sends this number of SYNCs; returns the number of TPDOs that follow.
std::size_t follow_sync(Bench& bench, unsigned count, Duration period, std::uint32_t sync) {
  std::size_t followed = 0;
  for (unsigned i = 0; i < count; ++i) {
    bench.send(Frame::data_frame(sync, {}));
    followed += count_of(bench.listen(period), tpdo_test_id);
  }
  return followed;
}

std::optional<std::uint32_t> sync_id(Bench& bench) {
  const auto raw = bench.number(index::cob_id_sync, 0);
  if (!raw) return std::nullopt;
  return *raw & Frame::id_max;
}

Verdict judge_each(Bench& bench, unsigned type, unsigned syncs, Duration period) {
  const auto sync = sync_id(bench);
  if (!sync) return not_applicable("the device has no 1005h");
  const Stage stage = set_stage(bench, {.type = type});
  if (stage.cannot) return *stage.cannot;
  const std::size_t wanted = syncs / type;
  const std::size_t came = follow_sync(bench, syncs, period, *sync);
  return came == wanted
             ? passed()
             : failed(fmt::format("{} TPDO follow {} SYNC, in place of {}", came, syncs, wanted));
}
Verdict judge_type_1(Bench& bench) {
  return judge_each(bench, 1, 6, 20ms);
}
Verdict judge_type_3(Bench& bench) {
  return judge_each(bench, 3, 9, 20ms);
}
Verdict judge_type_240(Bench& bench) {
  return judge_each(bench, 240, 480, 5ms);
}

Verdict judge_length_of_pdo(Bench& bench) {
  const auto sync = sync_id(bench);
  if (!sync) return not_applicable("the device has no 1005h");
  const Stage stage = set_stage(bench, {.type = 1});
  if (stage.cannot) return *stage.cannot;
  bench.send(Frame::data_frame(*sync, {}));
  const auto came = bench.await(tpdo_test_id, 200ms);
  if (!came) return not_applicable("none came");
  const std::size_t bytes = (stage.pdo.bits() + 7) / 8;
  return came->frame.length == bytes ? passed()
                                     : failed(fmt::format("it has {} bytes, and its mapping {}",
                                                          came->frame.length, bytes));
}

/// A state in which no PDO is sent.
Verdict judge_quiet(Bench& bench, NmtCommand command) {
  const auto sync = sync_id(bench);
  const Stage stage = set_stage(bench, {.type = sync ? 1U : 255U}, command);
  if (stage.cannot) return *stage.cannot;
  const std::size_t came = follow_sync(bench, 5, 20ms, sync.value_or(can_id::sync));
  return came == 0 ? passed() : failed(fmt::format("{} come", came));
}
Verdict judge_quiet_pre_operational(Bench& bench) {
  return judge_quiet(bench, NmtCommand::enter_pre_operational);
}
Verdict judge_quiet_stopped(Bench& bench) {
  return judge_quiet(bench, NmtCommand::stop);
}

Verdict judge_invalid(Bench& bench) {
  const auto sync = sync_id(bench);
  if (!sync) return not_applicable("the device has no 1005h");
  Stage stage = set_stage(bench, {.type = 1});
  if (stage.cannot) return *stage.cannot;
  stage.pdo.cob_id = stage.pdo.can_id;
  if (auto cannot = disable(bench, stage.pdo)) return *cannot;
  const std::size_t came = follow_sync(bench, 5, 20ms, *sync);
  return came == 0 ? passed() : failed(fmt::format("{} come though it is invalid", came));
}

std::vector<Duration> gaps_of(const std::vector<Heard>& all) {
  std::vector<Duration> gaps;
  std::optional<Time> last;
  for (const Heard& each : all) {
    if (each.frame.id != tpdo_test_id || !each.frame.is_plain()) continue;
    if (last) gaps.push_back(each.time - *last);
    last = each.time;
  }
  return gaps;
}

/// Every 100 ms, or earlier by an event of the device.
Verdict judge_event_timer(Bench& bench) {
  const Stage stage = set_stage(bench, {.type = 255, .event_ms = 100});
  if (stage.cannot) return *stage.cannot;
  const std::vector<Heard> all = bench.listen(1050ms);
  const std::size_t came = count_of(all, tpdo_test_id);
  if (came < 9) return failed(fmt::format("{} come in 1.05 s", came));
  const std::vector<Duration> gaps = gaps_of(all);
  const Duration longest = *std::ranges::max_element(gaps);
  return longest <= 120ms ? passed() : failed(fmt::format("{} ms between two", longest / 1ms));
}

Verdict judge_inhibit_time(Bench& bench) {
  const Stage stage = set_stage(bench, {.type = 255, .event_ms = 20, .inhibit_100us = 1000});
  if (stage.cannot) return *stage.cannot;
  const std::vector<Duration> gaps = gaps_of(bench.listen(1050ms));
  if (gaps.empty()) return failed("less than two come in 1.05 s");
  const Duration shortest = *std::ranges::min_element(gaps);
  return shortest >= 95ms ? passed()
                          : failed(fmt::format("{:.1f} ms between two",
                                               static_cast<double>(shortest.count()) / 1e3));
}

Verdict judge_remote_request(Bench& bench) {
  const auto pdo = find_pdo(bench, PdoWay::transmit);
  if (!pdo) return not_applicable("the device has no TPDO that carries anything");
  if ((pdo->cob_id & CobId::bit30) != 0) return not_applicable("it forbids remote frames (bit 30)");
  if (auto cannot = arrange(bench, *pdo, {.type = 253})) return *cannot;
  bench.command(NmtCommand::start);
  bench.listen(20ms);
  bench.send(Frame::remote_frame(tpdo_test_id, static_cast<std::uint8_t>((pdo->bits() + 7) / 8)));
  const std::size_t came = count_of(bench.listen(200ms), tpdo_test_id);
  return came == 1 ? passed() : failed(fmt::format("{} come to one remote frame", came));
}

/// Its values equal those read by SDO, if they do not change.
Verdict judge_content(Bench& bench) {
  const auto sync = sync_id(bench);
  if (!sync) return not_applicable("the device has no 1005h");
  const Stage stage = set_stage(bench, {.type = 1});
  if (stage.cannot) return *stage.cannot;
  const std::uint32_t first = stage.pdo.mapped.front();
  const auto at = static_cast<std::uint16_t>(first >> 16);
  const auto sub = static_cast<std::uint8_t>(first >> 8);
  if ((first & 7) != 0 || at < 0x2000) return not_applicable("its first entry has no whole bytes");
  const Reply before = bench.read(at, sub);
  bench.send(Frame::data_frame(*sync, {}));
  const auto came = bench.await(tpdo_test_id, 200ms);
  const Reply after = bench.read(at, sub);
  if (!before || before.value != after.value)
    return not_applicable("its value does not stand still");
  if (!came) return not_applicable("none came");
  return std::equal(before.value.begin(), before.value.end(), came->frame.data.begin())
             ? passed()
             : failed(fmt::format("it carries {}, and {} is {}",
                                  text::bytes_text(came->frame.payload()),
                                  text::object_text(at, sub), before.text()));
}

/// One byte less than mapped: no value is taken, and an emergency reports it (CiA 301, 7.2.2.6.2).
Verdict judge_short_rpdo(Bench& bench) {
  const auto pdo = find_pdo(bench, PdoWay::receive);
  if (!pdo) return not_applicable("the device has no RPDO that carries anything");
  if (auto cannot = arrange(bench, *pdo, {.type = 255})) return *cannot;
  const std::uint32_t id = emergency_id(bench);
  bench.command(NmtCommand::start);
  bench.listen(20ms);
  const std::size_t bytes = (pdo->bits() + 7) / 8;
  const std::uint8_t data[8] = {};
  bench.send(Frame::data_frame(rpdo_test_id, std::span(data).first(bytes - 1)));
  const auto came = bench.await(id, 300ms);
  if (!came) return failed("no emergency");
  const std::uint16_t code = error_code(came->frame);
  return code == 0x8210 ? passed() : failed(fmt::format("emergency {:04X}h", code));
}

constexpr std::string_view sending_clause = "CiA 301, 7.5.2.37";
constexpr CaseRow sending_rows[] = {
    {"tpdo-12", "CiA 301, 7.2.2.2", "a TPDO has the length of its mapping", "type 1; SYNC",
     "as many bytes", judge_length_of_pdo},
    {"tpdo-13", "CiA 301, 7.2.2.2", "a TPDO carries what SDO reads", "type 1; SYNC; uploads",
     "the same value", judge_content},
    {"tpdo-14", "CiA 301, 7.3.2.2.2", "no TPDO in pre-operational", "five SYNC", "none",
     judge_quiet_pre_operational},
    {"tpdo-15", "CiA 301, 7.3.2.2.4", "no TPDO in stopped", "five SYNC", "none",
     judge_quiet_stopped},
    {"tpdo-16", sending_clause, "a TPDO that is invalid is not sent", "bit 31; five SYNC", "none",
     judge_invalid},
    {"tpdo-17", sending_clause, "the event timer sends it", "type 255, event timer 100 ms",
     "one each 100 ms", judge_event_timer},
    {"tpdo-18", sending_clause, "the inhibit time holds it back",
     "event timer 20 ms, inhibit time 100 ms", "one each 100 ms", judge_inhibit_time},
    {"tpdo-19", sending_clause, "a remote frame asks for it", "type 253; a remote frame", "one",
     judge_remote_request},
    {"rpdo-12", "CiA 301, 7.2.2.6.2", "an RPDO that is too short is an emergency",
     "one byte less than is mapped", "EMCY 8210h", judge_short_rpdo},
};

Verdict judge_sync_moved(Bench& bench) {
  const auto old = sync_id(bench);
  if (!old) return not_applicable("the device has no 1005h");
  Reply done = bench.set(index::cob_id_sync, 0, *old, 4);
  if (!done) return cannot_set("1005h", done);
  done = bench.set(index::cob_id_sync, 0, sync_test_id, 4);
  if (!done) return failed(fmt::format("{:03X}h is not taken: {}", sync_test_id, done.text()));
  const Stage stage = set_stage(bench, {.type = 1});
  if (stage.cannot) return *stage.cannot;
  const std::size_t by_new = follow_sync(bench, 3, 20ms, sync_test_id);
  const std::size_t by_old = follow_sync(bench, 3, 20ms, *old);
  if (by_new == 3 && by_old == 0) return passed();
  return failed(fmt::format("{} TPDO follow three SYNC on the new CAN-ID, {} on the old one",
                            by_new, by_old));
}

/// SYNC of the device, on a CAN-ID without consumers.
std::optional<Verdict> produce(Bench& bench, unsigned period_us) {
  if (!bench.has(index::sync_period)) return not_applicable("the device has no 1006h");
  Reply done = bench.set(index::cob_id_sync, 0, sync_test_id, 4);
  if (!done) return cannot_set("1005h", done);
  done = bench.set(index::sync_period, 0, period_us, 4);
  if (!done) return cannot_set("1006h", done);
  done = bench.set(index::cob_id_sync, 0, sync_test_id | CobId::bit30, 4);
  if (!done) return cannot_set("1005h with bit 30", done);
  return std::nullopt;
}

Verdict judge_producer(Bench& bench) {
  if (auto cannot = produce(bench, 20'000)) return *cannot;
  bench.listen(40ms);
  const std::size_t came = count_of(bench.listen(400ms), sync_test_id);
  return came >= 18 && came <= 22 ? passed()
                                  : failed(fmt::format("{} SYNC in 400 ms, in place of 20", came));
}

Verdict judge_producer_off(Bench& bench) {
  if (auto cannot = produce(bench, 20'000)) return *cannot;
  const Reply done = bench.set(index::cob_id_sync, 0, sync_test_id, 4);
  if (!done) return failed(fmt::format("bit 30 is not cleared: {}", done.text()));
  bench.listen(10ms);
  return count_of(bench.listen(200ms), sync_test_id) == 0 ? passed() : failed("SYNC go on");
}

Verdict judge_producer_moved(Bench& bench) {
  if (auto cannot = produce(bench, 20'000)) return *cannot;
  const std::uint32_t other = (sync_test_id + 8) | CobId::bit30;
  const Reply done = bench.set(index::cob_id_sync, 0, other, 4);
  return refusal(done, "another CAN-ID is taken while it produces");
}

Verdict judge_producer_stopped(Bench& bench) {
  if (auto cannot = produce(bench, 20'000)) return *cannot;
  bench.command(NmtCommand::stop);
  bench.listen(20ms);
  return count_of(bench.listen(200ms), sync_test_id) == 0 ? passed()
                                                          : failed("SYNC go on in stopped");
}

Verdict judge_counter_values(Bench& bench) {
  if (!bench.has(index::sync_counter_overflow)) return not_applicable("the device has no 1019h");
  for (const unsigned value : {1U, 241U, 255U}) {
    const Reply done = bench.set(index::sync_counter_overflow, 0, value, 1);
    if (done.has_aborted(AbortCode::read_only) || done.has_aborted(AbortCode::device_state)) {
      return cannot_set("1019h", done);
    }
    if (!done.has_aborted(AbortCode::value_range) && !done.has_aborted(AbortCode::value_too_high) &&
        !done.has_aborted(AbortCode::value_too_low)) {
      return failed(fmt::format("1019h = {}: {}", value, done.text()));
    }
  }
  return passed();
}

Verdict judge_counter(Bench& bench) {
  const Reply done = bench.set(index::sync_counter_overflow, 0, 4, 1);
  if (!done) return cannot_set("1019h", done);
  if (auto cannot = produce(bench, 20'000)) return *cannot;
  unsigned expected = 0;
  for (int i = 0; i < 9; ++i) {
    const auto came = bench.await(sync_test_id, 100ms);
    if (!came) return failed("no SYNC");
    if (came->frame.length != 1) return failed("a SYNC has no counter");
    if (expected != 0 && came->frame.data[0] != expected) {
      return failed(fmt::format("counter {} in place of {}", came->frame.data[0], expected));
    }
    expected = came->frame.data[0] % 4 + 1;
  }
  return passed();
}

Verdict judge_counter_while_period(Bench& bench) {
  if (!bench.has(index::sync_counter_overflow)) return not_applicable("the device has no 1019h");
  if (!bench.has(index::sync_period)) return not_applicable("the device has no 1006h");
  Reply done = bench.set(index::sync_period, 0, 100'000, 4);
  if (!done) return cannot_set("1006h", done);
  done = bench.set(index::sync_counter_overflow, 0, 4, 1);
  return done.has_aborted(AbortCode::device_state)
             ? passed()
             : failed(fmt::format("1019h = 4 with 1006h not 0: {}", done.text()));
}

constexpr CaseRow sync_rows[] = {
    {"sync-01", sending_clause, "type 1: a TPDO follows each SYNC", "six SYNC", "six TPDO",
     judge_type_1},
    {"sync-02", sending_clause, "type 3: a TPDO follows each third", "nine SYNC", "three TPDO",
     judge_type_3},
    {"sync-03", sending_clause, "type 240: a TPDO follows each 240th", "480 SYNC", "two TPDO",
     judge_type_240},
    {"sync-04", "CiA 301, 7.5.2.5", "another CAN-ID of SYNC is followed, the old one not",
     "1005h = 6B2h; three SYNC on both", "three TPDO", judge_sync_moved},
    {"sync-05", "CiA 301, 7.5.2.6", "a producer sends with the period of 1006h",
     "1006h = 20000; 1005h with bit 30", "20 in 400 ms", judge_producer},
    {"sync-06", "CiA 301, 7.5.2.5", "a producer ends without bit 30", "1005h with bit 30, without",
     "none", judge_producer_off},
    {"sync-07", "CiA 301, 7.5.2.5", "a producer's CAN-ID does not change",
     "1005h with bit 30 and another CAN-ID", "an abort", judge_producer_moved},
    {"sync-08", "CiA 301, 7.3.2.2.4", "a producer that is stopped sends none", "NMT 02h", "none",
     judge_producer_stopped},
    {"sync-09", "CiA 301, 7.5.2.22", "1019h is 0, or 2 to 240", "1019h = 1, 241, 255",
     "0609 0030h to 0032h", judge_counter_values},
    {"sync-10", "CiA 301, 7.5.2.22", "a producer counts from 1 to 1019h", "1019h = 4",
     "1, 2, 3, 4, 1", judge_counter},
    {"sync-11", "CiA 301, 7.5.2.22", "1019h does not change with a period",
     "1006h = 100000; 1019h = 4", "0800 0022h", judge_counter_while_period},
};

}  // namespace

void add_pdo_sending_cases(TestCases& cases) {
  add_rows(cases, Group::pdo, sending_rows);
}

void add_sync_cases(TestCases& cases) {
  add_rows(cases, Group::sync, sync_rows);
}

}  // namespace canvoy::conformance
