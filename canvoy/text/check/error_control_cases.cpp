// Heartbeats, node guarding and life guarding (CiA 301, 7.2.8.3.2).
#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

constexpr std::uint16_t heartbeat_lost = 0x8130;

double in_ms(Duration time) {
  return static_cast<double>(time.count()) / 1e3;
}

std::vector<Heard> beats_of(Bench& bench, Duration duration) {
  std::vector<Heard> beats = bench.listen(duration);
  const std::uint32_t id = can_id::error_control + bench.node();
  std::erase_if(beats,
                [id](const Heard& each) { return each.frame.id != id || each.frame.is_remote(); });
  return beats;
}

bool is_near(Duration time, Duration wanted, Duration spare) {
  return std::chrono::abs(time - wanted) <= spare;
}

/// True if only this heartbeat is late, as by a busy bus or a busy listener: the next one comes at
/// its own time.
bool is_late_alone(const std::vector<Heard>& beats, std::size_t i, Duration period,
                   Duration spare) {
  return i + 1 < beats.size() && beats[i].time - beats[i - 1].time > period &&
         is_near(beats[i + 1].time - beats[i - 1].time, 2 * period, spare);
}

/// Ten periods with a tolerance of a tenth each, and 10 ms for an operating system; one of them may
/// be late.
Verdict judge_period(Bench& bench, std::uint16_t period_ms) {
  const Reply done = bench.set(index::heartbeat_producer, 0, period_ms, 2);
  if (!done) return cannot_set("1017h", done);
  const Duration period = from_milliseconds(period_ms);
  bench.listen(period);
  const std::vector<Heard> beats = beats_of(bench, 10 * period);
  if (beats.size() < 9 || beats.size() > 11) {
    return failed(fmt::format("{} heartbeats in ten periods of {} ms", beats.size(), period_ms));
  }
  const Duration spare = std::max<Duration>(period / 10, 10ms);
  std::size_t late = 0;
  for (std::size_t i = 0; i < beats.size(); ++i) {
    if (beats[i].frame.length != 1) return failed("a heartbeat has not one byte");
    if (i == 0 || (late != 0 && i == late + 1)) continue;
    const Duration gap = beats[i].time - beats[i - 1].time;
    if (is_near(gap, period, spare)) continue;
    if (late == 0 && is_late_alone(beats, i, period, spare)) {
      late = i;
      continue;
    }
    return failed(fmt::format("{:.1f} ms between two, in place of {}", in_ms(gap), period_ms));
  }
  return passed();
}

Verdict judge_fast(Bench& bench) {
  return judge_period(bench, 50);
}
Verdict judge_slow(Bench& bench) {
  return judge_period(bench, 200);
}

Verdict judge_off(Bench& bench) {
  Reply done = bench.set(index::heartbeat_producer, 0, 50, 2);
  if (!done) return cannot_set("1017h", done);
  done = bench.set(index::heartbeat_producer, 0, 0, 2);
  if (!done) return failed(fmt::format("1017h does not take 0: {}", done.text()));
  bench.listen(10ms);
  return beats_of(bench, 500ms).empty() ? passed() : failed("heartbeats come with 1017h = 0");
}

Verdict judge_state_bytes(Bench& bench) {
  const Reply done = bench.set(index::heartbeat_producer, 0, 50, 2);
  if (!done) return cannot_set("1017h", done);
  constexpr std::pair<NmtCommand, unsigned> states[] = {{NmtCommand::start, 0x05},
                                                        {NmtCommand::stop, 0x04},
                                                        {NmtCommand::enter_pre_operational, 0x7F}};
  for (const auto& [command, state] : states) {
    bench.command(command);
    bench.listen(60ms);
    const std::vector<Heard> beats = beats_of(bench, 200ms);
    if (beats.empty()) return failed(fmt::format("no heartbeat in state {:02X}h", state));
    for (const Heard& beat : beats) {
      if (beat.frame.data[0] == state) continue;
      return failed(
          fmt::format("a heartbeat says {:02X}h in state {:02X}h", beat.frame.data[0], state));
    }
  }
  return passed();
}

Verdict judge_consumer(Bench& bench) {
  const LostHeartbeat lost = lose_heartbeat(bench);
  if (lost.cannot) return *lost.cannot;
  if (!lost.emergency) return failed("no emergency though a heartbeat is missing");
  const std::uint16_t code = error_code(lost.emergency->frame);
  return code == heartbeat_lost ? passed() : failed(fmt::format("emergency {:04X}h", code));
}

/// Monitoring begins with the first heartbeat.
Verdict judge_consumer_waits(Bench& bench) {
  const std::uint32_t watched = std::uint32_t{played_node(bench)} << 16 | 100U;
  const Reply done = bench.set(index::heartbeat_consumers, 1, watched, 4);
  if (!done) return cannot_set("1016h:01h", done);
  const auto came = bench.await(emergency_id(bench), 500ms);
  return came ? failed("an emergency before there was a heartbeat") : passed();
}

Verdict judge_consumer_content(Bench& bench) {
  const std::uint32_t watched = std::uint32_t{played_node(bench)} << 16 | 200U;
  const Reply done = bench.set(index::heartbeat_consumers, 1, watched, 4);
  if (!done) return cannot_set("1016h:01h", done);
  bench.drain();
  const std::uint32_t id = emergency_id(bench);
  for (int i = 0; i < 8; ++i) {
    send_heartbeat(bench);
    if (bench.await(id, 100ms)) return failed("an emergency though heartbeats come in time");
  }
  return passed();
}

Verdict judge_consumer_twice(Bench& bench) {
  const std::uint32_t watched = std::uint32_t{played_node(bench)} << 16 | 1000U;
  const Reply first = bench.set(index::heartbeat_consumers, 1, watched, 4);
  if (!first) return cannot_set("1016h:01h", first);
  const Reply second = bench.set(index::heartbeat_consumers, 2, watched, 4);
  if (second.is_absent()) return not_applicable("1016h has one entry");
  return second.has_aborted(AbortCode::parameter_incompatible)
             ? passed()
             : failed(fmt::format("1016h:02h for the same node: {}", second.text()));
}

constexpr CaseRow heartbeat_rows[] = {
    {"heartbeat-01", "CiA 301, 7.5.2.20", "heartbeats come with the period of 1017h", "1017h = 50",
     "ten in 500 ms", judge_fast},
    {"heartbeat-02", "CiA 301, 7.5.2.20", "another period holds at once", "1017h = 200",
     "ten in 2 s", judge_slow},
    {"heartbeat-03", "CiA 301, 7.5.2.20", "0 turns them off", "1017h = 50, 0", "none", judge_off},
    {"heartbeat-04", "CiA 301, 7.2.8.3.2.2", "they tell the state", "NMT 01h, 02h, 80h",
     "05h, 04h, 7Fh", judge_state_bytes},
    {"heartbeat-05", "CiA 301, 7.5.2.19", "a heartbeat that is missing is an emergency",
     "1016h:01h = 100 ms; one heartbeat of that node", "EMCY 8130h", judge_consumer},
    {"heartbeat-06", "CiA 301, 7.5.2.19", "supervision begins with the first heartbeat",
     "1016h:01h = 100 ms; no heartbeat", "no EMCY", judge_consumer_waits},
    {"heartbeat-07", "CiA 301, 7.5.2.19", "heartbeats in time are no emergency",
     "1016h:01h = 200 ms; a heartbeat each 100 ms", "no EMCY", judge_consumer_content},
    {"heartbeat-08", "CiA 301, 7.5.2.19", "one node is not watched twice",
     "1016h:01h and :02h for one node", "0604 0043h", judge_consumer_twice},
};

/// Guarding without heartbeats. Nothing if this is possible.
std::optional<Verdict> without_heartbeat(Bench& bench) {
  if (!bench.has(index::guard_time)) return not_applicable("the device has no 100Ch");
  if (bench.number(index::heartbeat_producer, 0).value_or(0) == 0) return std::nullopt;
  const Reply done = bench.set(index::heartbeat_producer, 0, 0, 2);
  if (!done) return cannot_set("1017h", done);
  return std::nullopt;
}

std::optional<unsigned> guard(Bench& bench) {
  const std::uint32_t id = can_id::error_control + bench.node();
  bench.drain();
  bench.send(Frame::remote_frame(id, 1));
  const auto came = bench.await(id, 100ms);
  if (!came || came->frame.is_remote() || came->frame.length != 1) return std::nullopt;
  return came->frame.data[0];
}

Verdict judge_guarding(Bench& bench) {
  if (const auto cannot = without_heartbeat(bench)) return *cannot;
  std::optional<unsigned> before;
  for (int i = 0; i < 4; ++i) {
    const auto answer = guard(bench);
    if (!answer) return failed("no answer of one byte to a remote frame");
    if (before && (*before ^ *answer) != 0x80) {
      return failed(fmt::format("{:02X}h follows {:02X}h", *answer, *before));
    }
    before = answer;
  }
  return passed();
}

Verdict judge_guarding_states(Bench& bench) {
  if (const auto cannot = without_heartbeat(bench)) return *cannot;
  constexpr std::pair<NmtCommand, unsigned> states[] = {{NmtCommand::start, 0x05},
                                                        {NmtCommand::stop, 0x04},
                                                        {NmtCommand::enter_pre_operational, 0x7F}};
  for (const auto& [command, state] : states) {
    bench.command(command);
    bench.listen(20ms);
    const auto answer = guard(bench);
    if (!answer) return failed(fmt::format("no answer in state {:02X}h", state));
    if ((*answer & 0x7F) != state) {
      return failed(fmt::format("{:02X}h in state {:02X}h", *answer, state));
    }
  }
  return passed();
}

Verdict judge_first_toggle(Bench& bench) {
  if (const auto cannot = without_heartbeat(bench)) return *cannot;
  guard(bench);
  bench.command(NmtCommand::reset_communication);
  if (!bench.await(can_id::error_control + bench.node(), 5s)) return failed("no boot-up message");
  bench.listen(50ms);
  if (const auto cannot = without_heartbeat(bench)) return *cannot;
  const auto answer = guard(bench);
  if (!answer) return failed("no answer behind a reset");
  return (*answer & 0x80) == 0 ? passed() : failed("the first answer has toggle bit 1");
}

/// Two life times of 100 ms; nothing if the device refuses them.
std::optional<Verdict> begin_life(Bench& bench) {
  if (auto cannot = without_heartbeat(bench)) return cannot;
  Reply done = bench.set(index::guard_time, 0, 100, 2);
  if (!done) return cannot_set("100Ch", done);
  done = bench.set(index::life_time_factor, 0, 2, 1);
  if (!done) return cannot_set("100Dh", done);
  return std::nullopt;
}

Verdict judge_life(Bench& bench) {
  if (const auto cannot = begin_life(bench)) return *cannot;
  const std::uint32_t id = emergency_id(bench);
  if (!guard(bench)) return failed("no answer to a remote frame");
  const auto came = bench.await(id, 600ms);
  if (!came) return failed("no emergency 200 ms behind the last remote frame");
  const std::uint16_t code = error_code(came->frame);
  return code == heartbeat_lost ? passed() : failed(fmt::format("emergency {:04X}h", code));
}

Verdict judge_life_goes_on(Bench& bench) {
  if (const auto cannot = begin_life(bench)) return *cannot;
  const std::uint32_t id = emergency_id(bench);
  for (int i = 0; i < 8; ++i) {
    if (!guard(bench)) return failed("no answer to a remote frame");
    if (bench.await(id, 90ms)) return failed("an emergency though it is guarded in time");
  }
  return passed();
}

Verdict judge_no_life(Bench& bench) {
  if (const auto cannot = without_heartbeat(bench)) return *cannot;
  const Reply done = bench.set(index::life_time_factor, 0, 0, 1);
  if (!done) return cannot_set("100Dh", done);
  const std::uint32_t id = emergency_id(bench);
  if (!guard(bench)) return failed("no answer to a remote frame");
  return bench.await(id, 500ms) ? failed("an emergency with 100Dh = 0") : passed();
}

Verdict judge_both(Bench& bench) {
  if (!bench.has(index::guard_time)) return not_applicable("the device has no 100Ch");
  const Reply done = bench.set(index::heartbeat_producer, 0, 1000, 2);
  if (!done) return cannot_set("1017h", done);
  bench.await(can_id::error_control + bench.node(), 1100ms);
  return guard(bench) ? failed("a remote frame is answered beside heartbeats") : passed();
}

Verdict judge_guarding_again(Bench& bench) {
  if (!bench.has(index::guard_time)) return not_applicable("the device has no 100Ch");
  Reply done = bench.set(index::heartbeat_producer, 0, 1000, 2);
  if (!done) return cannot_set("1017h", done);
  done = bench.set(index::heartbeat_producer, 0, 0, 2);
  if (!done) return cannot_set("1017h", done);
  bench.listen(20ms);
  return guard(bench) ? passed() : failed("a remote frame is not answered with 1017h = 0 again");
}

constexpr std::string_view guarding_clause = "CiA 301, 7.2.8.3.2.1";
constexpr CaseRow guarding_rows[] = {
    {"guarding-01", guarding_clause, "answers have the toggle bit in turns", "four remote frames",
     "four answers", judge_guarding},
    {"guarding-02", guarding_clause, "answers tell the state", "NMT 01h, 02h, 80h; remote frames",
     "05h, 04h, 7Fh", judge_guarding_states},
    {"guarding-03", guarding_clause, "behind a reset the toggle bit is 0",
     "NMT 82h; a remote frame", "toggle bit 0", judge_first_toggle},
    {"guarding-04", guarding_clause, "a life that is over is an emergency",
     "100Ch = 100, 100Dh = 2; one remote frame", "EMCY 8130h", judge_life},
    {"guarding-05", guarding_clause, "a life that goes on is none", "a remote frame each 90 ms",
     "no EMCY", judge_life_goes_on},
    {"guarding-06", guarding_clause, "without 100Dh there is no life",
     "100Dh = 0; one remote frame", "no EMCY", judge_no_life},
    {"both-01", "CiA 301, 7.2.8.2.2", "a device with heartbeats is not guarded",
     "1017h = 1000; a remote frame", "no answer", judge_both},
    {"both-02", "CiA 301, 7.2.8.2.2", "guarding is back without heartbeats",
     "1017h = 0; a remote frame", "an answer", judge_guarding_again},
};

}  // namespace

void add_heartbeat_cases(TestCases& cases) {
  add_rows(cases, Group::heartbeat, heartbeat_rows);
}

void add_guarding_cases(TestCases& cases) {
  add_rows(cases, Group::guarding, guarding_rows);
}

}  // namespace canvoy::conformance
