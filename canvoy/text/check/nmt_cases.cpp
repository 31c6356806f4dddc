// NMT states and transitions, as reported by the device and as seen in its behaviour (CiA 301,
// 7.3.2).
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr Duration transition = 20ms;
constexpr Duration boot_max = 5s;

std::optional<NmtState> state_after(Bench& bench, NmtCommand command) {
  bench.command(command);
  bench.listen(transition);
  return bench.state();
}

std::string told(const std::optional<NmtState>& state) {
  return state ? std::string(text::nmt_state_text(*state)) : "nothing";
}

/// The device reports the state, and serves SDO or not.
Verdict judge_state(Bench& bench, NmtCommand command, NmtState wanted) {
  const bool is_watched = bench.watch_state();
  const auto state = state_after(bench, command);
  if (is_watched && state != wanted) {
    return failed(fmt::format("it tells that it is {}, and not {}", told(state),
                              text::nmt_state_text(wanted)));
  }
  const bool is_served = bench.has_services_by_sdo();
  if (is_served == has_services(wanted)) return passed();
  return failed(is_served ? "SDO is served" : "SDO is not served");
}

Verdict judge_pre_operational(Bench& bench) {
  return judge_state(bench, NmtCommand::enter_pre_operational, NmtState::pre_operational);
}
Verdict judge_operational(Bench& bench) {
  return judge_state(bench, NmtCommand::start, NmtState::operational);
}
Verdict judge_stopped(Bench& bench) {
  return judge_state(bench, NmtCommand::stop, NmtState::stopped);
}

Verdict judge_boot(Bench& bench, NmtCommand from, NmtCommand reset) {
  bench.command(from);
  bench.listen(transition);
  bench.drain();
  bench.command(reset);
  // A heartbeat that was already queued precedes it.
  const Time until = bench.now() + boot_max;
  while (bench.now() < until && !bench.is_broken()) {
    const auto came = bench.await(can_id::error_control + bench.node(), until - bench.now());
    if (!came) break;
    if (came->frame.is_remote() || (came->frame.length == 1 && came->frame.data[0] != 0)) continue;
    if (came->frame.length != 1) return failed(fmt::format("it has {} bytes", came->frame.length));
    bench.listen(transition);
    return bench.has_services_by_sdo() ? passed() : failed("SDO is not served behind it");
  }
  return failed("no boot-up message within 5 s");
}

Verdict judge_boot_communication(Bench& bench) {
  return judge_boot(bench, NmtCommand::enter_pre_operational, NmtCommand::reset_communication);
}
Verdict judge_boot_node(Bench& bench) {
  return judge_boot(bench, NmtCommand::start, NmtCommand::reset_node);
}
Verdict judge_boot_stopped(Bench& bench) {
  return judge_boot(bench, NmtCommand::stop, NmtCommand::reset_communication);
}

Verdict judge_transitions(Bench& bench) {
  if (!bench.watch_state()) return not_applicable("the device does not tell its state");
  struct Transition {
    NmtCommand command;
    NmtState state;
  };
  constexpr Transition way[] = {{NmtCommand::start, NmtState::operational},
                                {NmtCommand::stop, NmtState::stopped},
                                {NmtCommand::start, NmtState::operational},
                                {NmtCommand::enter_pre_operational, NmtState::pre_operational},
                                {NmtCommand::stop, NmtState::stopped},
                                {NmtCommand::enter_pre_operational, NmtState::pre_operational}};
  NmtState before = NmtState::pre_operational;
  for (const Transition& each : way) {
    const auto state = state_after(bench, each.command);
    if (state != each.state) {
      return failed(fmt::format("from {} it is to be {}, and tells that it is {}",
                                text::nmt_state_text(before), text::nmt_state_text(each.state),
                                told(state)));
    }
    before = each.state;
  }
  return passed();
}

/// A command for another node, or an undefined one.
Verdict judge_ignored(Bench& bench, const Frame& frame) {
  if (!bench.watch_state()) return not_applicable("the device does not tell its state");
  bench.send(frame);
  bench.listen(transition);
  const auto state = bench.state();
  if (state == NmtState::pre_operational) return passed();
  return failed(fmt::format("it tells that it is {}", told(state)));
}
Verdict judge_other_nodes_command(Bench& bench) {
  return judge_ignored(bench, Frame::data_frame(can_id::nmt, {0x01, played_node(bench)}));
}
Verdict judge_no_command(Bench& bench) {
  return judge_ignored(bench, Frame::data_frame(can_id::nmt, {0x03, bench.node()}));
}

constexpr CaseRow nmt_rows[] = {
    {"nmt-01", "CiA 301, 7.3.2.2.2", "pre-operational: SDO is served", "NMT 80h",
     "state 7Fh; an answer", judge_pre_operational},
    {"nmt-02", "CiA 301, 7.3.2.2.3", "operational: SDO is served", "NMT 01h",
     "state 05h; an answer", judge_operational},
    {"nmt-03", "CiA 301, 7.3.2.2.4", "stopped: SDO is not served", "NMT 02h",
     "state 04h; no answer", judge_stopped},
    {"nmt-04", "CiA 301, 7.2.8.3.3", "reset communication ends in a boot-up message", "NMT 82h",
     "700h + node-ID with 00h; SDO is served", judge_boot_communication},
    {"nmt-05", "CiA 301, 7.2.8.3.3", "reset node, from operational, ends in a boot-up message",
     "NMT 01h, 81h", "700h + node-ID with 00h; SDO is served", judge_boot_node},
    {"nmt-06", "CiA 301, 7.3.2.1", "it is reset from stopped", "NMT 02h, 82h",
     "700h + node-ID with 00h; SDO is served", judge_boot_stopped},
    {"nmt-07", "CiA 301, 7.3.2.1", "all transitions between the three states",
     "NMT 01h, 02h, 01h, 80h, 02h, 80h", "each state", judge_transitions},
    {"nmt-08", "CiA 301, 7.2.8.3.1", "a command for another node is not followed",
     "NMT 01h to a node that is not there", "state 7Fh", judge_other_nodes_command},
    {"nmt-09", "CiA 301, 7.2.8.3.1", "a command that there is not is not followed", "NMT 03h",
     "state 7Fh", judge_no_command},
};

}  // namespace

void add_nmt_cases(TestCases& cases) {
  add_rows(cases, Group::nmt, nmt_rows);
}

}  // namespace canvoy::conformance
