// Emergencies, and their objects (CiA 301, 7.2.7, 7.5.2.2, 7.5.2.4, 7.5.2.17). The error is a
// heartbeat that the test withholds.
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

constexpr unsigned generic_and_communication = 0x11;

/// Provokes an emergency; without one, returns the verdict, which another case gives.
std::optional<Verdict> provoke(Bench& bench, Frame& emergency) {
  const LostHeartbeat lost = lose_heartbeat(bench);
  if (lost.cannot) return lost.cannot;
  if (!lost.emergency) return not_applicable("no emergency could be provoked");
  emergency = lost.emergency->frame;
  return std::nullopt;
}

Verdict judge_emergency_id(Bench& bench) {
  const auto raw = bench.number(index::cob_id_emergency, 0);
  if (!raw) return not_applicable("the device has no 1014h");
  const CobId id{*raw};
  if (!id.valid() || has_free_id(id)) return passed();
  return failed(fmt::format("1014h is {:08X}h", *raw));
}

Verdict judge_emergency_length(Bench& bench) {
  Frame emergency;
  if (const auto without = provoke(bench, emergency)) return *without;
  return emergency.length == 8 ? passed()
                               : failed(fmt::format("it has {} bytes", emergency.length));
}

Verdict judge_register(Bench& bench) {
  Frame emergency;
  if (const auto without = provoke(bench, emergency)) return *without;
  const auto now = bench.number(index::error_register, 0);
  const unsigned told = emergency.data[2];
  if ((told & generic_and_communication) != generic_and_communication) {
    return failed(fmt::format("it tells error register {:02X}h, without bits 0 and 4", told));
  }
  return now == told ? passed()
                     : failed(fmt::format("it tells error register {:02X}h, and 1001h is {:02X}h",
                                          told, now.value_or(0)));
}

Verdict judge_history(Bench& bench) {
  if (!bench.has(index::error_history)) return not_applicable("the device has no 1003h");
  Frame emergency;
  if (const auto without = provoke(bench, emergency)) return *without;
  if (bench.number(index::error_history, 0).value_or(0) == 0) return failed("1003h:00h is 0");
  const auto newest = bench.number(index::error_history, 1);
  const std::uint16_t code = error_code(emergency);
  if (newest && (*newest & 0xFFFF) == code) return passed();
  return failed(
      fmt::format("1003h:01h is {:08X}h behind emergency {:04X}h", newest.value_or(0), code));
}

Verdict judge_history_cleared(Bench& bench) {
  if (!bench.has(index::error_history)) return not_applicable("the device has no 1003h");
  // An error comes first, where the device can be given one: an empty list is no proof.
  lose_heartbeat(bench);
  const Reply done = bench.write(index::error_history, 0, 0, 1);
  if (!done) return failed(fmt::format("1003h:00h does not take 0: {}", done.text()));
  const auto left = bench.number(index::error_history, 0);
  return left == 0U ? passed() : failed("1003h:00h is not 0 behind it");
}

Verdict judge_history_kept(Bench& bench) {
  if (!bench.has(index::error_history)) return not_applicable("the device has no 1003h");
  const Reply done = bench.write(index::error_history, 0, 1, 1);
  return done.has_aborted(AbortCode::value_range)
             ? passed()
             : failed(fmt::format("1003h:00h = 1: {}", done.text()));
}

Verdict judge_emergency_off(Bench& bench) {
  const auto raw = bench.number(index::cob_id_emergency, 0);
  if (!raw) return not_applicable("the device has no 1014h");
  const Reply done = bench.set(index::cob_id_emergency, 0, *raw | CobId::bit31, 4);
  if (!done) return cannot_set("1014h", done);
  const LostHeartbeat lost = lose_heartbeat(bench);
  if (lost.cannot) return *lost.cannot;
  return lost.emergency ? failed("an emergency though 1014h is invalid") : passed();
}

Verdict judge_no_error(Bench& bench) {
  Frame emergency;
  if (const auto without = provoke(bench, emergency)) return *without;
  const std::uint32_t id = emergency_id(bench);
  bench.drain();
  send_heartbeat(bench);
  const auto came = bench.await(id, 90ms);
  if (!came) return failed("no emergency when the heartbeat is back");
  const std::uint16_t code = error_code(came->frame);
  return code == 0 ? passed() : failed(fmt::format("emergency {:04X}h", code));
}

constexpr CaseRow emergency_rows[] = {
    {"emergency-01", "CiA 301, 7.5.2.17", "1014h is a CAN-ID that it may be", "an upload of 1014h",
     "none that is restricted", judge_emergency_id},
    {"emergency-02", "CiA 301, 7.2.7.3", "an emergency has eight bytes", "a heartbeat is withheld",
     "8 bytes", judge_emergency_length},
    {"emergency-03", "CiA 301, 7.5.2.2", "it tells the error register", "an upload of 1001h",
     "the same in both, with bits 0 and 4", judge_register},
    {"emergency-04", "CiA 301, 7.5.2.4", "1003h has it at its front", "uploads of 1003h",
     "its code in 1003h:01h", judge_history},
    {"emergency-05", "CiA 301, 7.5.2.4", "0 clears 1003h", "a heartbeat is withheld; 1003h:00h = 0",
     "1003h:00h is 0", judge_history_cleared},
    {"emergency-06", "CiA 301, 7.5.2.4", "1003h:00h takes nothing but 0", "1003h:00h = 1",
     "0609 0030h", judge_history_kept},
    {"emergency-07", "CiA 301, 7.5.2.17", "none comes where 1014h is invalid", "1014h with bit 31",
     "no EMCY", judge_emergency_off},
    {"emergency-08", "CiA 301, 7.2.7.1", "the end of an error is told", "the heartbeat is back",
     "EMCY 0000h", judge_no_error},
};

}  // namespace

void add_emergency_cases(TestCases& cases) {
  add_rows(cases, Group::emergency, emergency_rows);
}

}  // namespace canvoy::conformance
