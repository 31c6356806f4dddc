#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/doctor/judges.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

constexpr std::uint64_t least = 3;

std::string pdo_text(std::uint16_t can_id, const HeardPdo& pdo) {
  std::string text = fmt::format("{:03X}h", can_id);
  if (pdo.number != 0) text += fmt::format(", TPDO{}", pdo.number);
  if (pdo.node != 0) text += fmt::format(" of {}", node_text(pdo.node));
  return text;
}

/// `1800h of node 5 and 1801h of node 7`: TPDOs that are to use the same CAN-ID, if they belong to
/// more than one node; else empty.
std::map<std::uint16_t, std::string> shared_ids(const Observed& bus) {
  std::map<std::uint16_t, std::vector<std::pair<NodeId, std::uint16_t>>> senders;
  for (const auto& [place, tpdo] : bus.known.tpdos()) {
    if (!tpdo.cob_id || !tpdo.cob_id->valid() || !tpdo.cob_id->is_base_frame()) continue;
    senders[static_cast<std::uint16_t>(tpdo.cob_id->can_id())].push_back(place);
  }
  std::map<std::uint16_t, std::string> shared;
  for (const auto& [id, places] : senders) {
    if (places.front().first == places.back().first) continue;
    for (const auto& [node, number] : places) {
      std::string& text = shared[id];
      text += fmt::format("{}{:04X}h of {}", text.empty() ? "" : " and ",
                          object_index::tpdo_parameter + number - 1, node_text(node));
    }
  }
  return shared;
}

/// Evidence that two nodes send it; empty: none.
std::string twice_text(std::uint16_t can_id, const HeardPdo& pdo,
                       const std::map<std::uint16_t, std::string>& shared) {
  if (pdo.is_multiplexed) return {};
  std::string text;
  if (pdo.lengths == 2 && pdo.length_changes.count > least) {
    text += fmt::format(" Its frames have {} and {} bytes in turns: the length has changed {}.",
                        pdo.length, pdo.other_length, times_text(pdo.length_changes.count));
  }
  if (const auto& rhythms = pdo.rhythm.found()) {
    text += fmt::format(" It comes in two rhythms, each every {}, the one {} behind the other.",
                        short_time(rhythms->period), short_time(rhythms->apart));
  }
  if (pdo.twice_in_cycle.count >= least) {
    text += fmt::format(" It has come more than once between two SYNC, {}.",
                        times_text(pdo.twice_in_cycle.count));
  }
  const auto found = shared.find(can_id);
  if (found != shared.end()) text += fmt::format(" It is in {}.", found->second);
  return text;
}

Finding of_pdo(FindingKind kind, std::uint16_t can_id, const HeardPdo& pdo, const Tally& tally) {
  return {.kind = kind,
          .node = pdo.node,
          .can_id = can_id,
          .count = tally.count,
          .first = tally.first,
          .last = tally.last};
}

/// Two nodes that start at the same time and differ: the bit errors of both affect what they send.
void judge_struck(const Observed& bus, Findings& findings) {
  const std::optional<std::uint16_t> id = struck_id(bus);
  if (!id || *id > can_id::error_control) return;
  const ErrorWatch::Struck& struck = bus.errors.by_id().at(*id);
  const bool is_on_list = std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.kind == FindingKind::cob_id_twice && finding.can_id == id;
  });
  if (is_on_list) return;
  findings.push_back(
      {.kind = FindingKind::cob_id_twice,
       .node = struck.node,
       .can_id = id,
       .count = struck.errors,
       .first = bus.errors.errors().first,
       .last = bus.errors.errors().last,
       .what = fmt::format("Nearly all error frames strike {:03X}h, {} of {}, on {} frames: two "
                           "that send it at once, and differ.",
                           *id, struck.errors, bus.errors.known(), struck.frames)});
}

}  // namespace

namespace {

/// Two producers of TIME (CiA 301, 7.2.6: one producer).
void judge_clocks(const Observed& bus, Findings& findings) {
  const auto& rhythms = bus.clocks.found();
  if (!rhythms) return;
  findings.push_back(
      {.kind = FindingKind::cob_id_twice,
       .can_id = static_cast<std::uint16_t>(can_id::time),
       .count = 1,
       .first = rhythms->since,
       .last = rhythms->last,
       .what = fmt::format("Two devices send TIME, {:03X}h. It comes in two rhythms, each every "
                           "{}, the one {} behind the other.",
                           can_id::time, short_time(rhythms->period), short_time(rhythms->apart))});
}

/// PDOs of nodes that say that they are stopped or pre-operational.
void judge_quiet(const Observed& bus, Findings& findings) {
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    const Tally& sent = bus.quiet.of(node);
    if (sent.count < least) continue;
    findings.push_back(
        found(FindingKind::against_protocol, node, sent,
              fmt::format("{} has sent PDOs, {}, while it said that it is stopped or "
                          "pre-operational (CiA 301, 7.3.2.2).",
                          node_text(node), times_text(sent.count))));
  }
}

}  // namespace

void judge_cob_id_twice(const Observed& bus, Findings& findings) {
  const auto shared = shared_ids(bus);
  for (const auto& [id, pdo] : bus.pdos.pdos()) {
    const std::string text = twice_text(id, pdo, shared);
    if (text.empty() || pdo.frames == 0) continue;
    Finding finding = of_pdo(FindingKind::cob_id_twice, id, pdo, pdo.length_changes);
    finding.count = std::max<std::uint64_t>(finding.count, 1);
    finding.what = fmt::format("Two devices send {}.{}", pdo_text(id, pdo), text);
    findings.push_back(finding);
  }
  judge_clocks(bus, findings);
  judge_struck(bus, findings);
}

void judge_pdo_length(const Observed& bus, Findings& findings) {
  for (const auto& [id, pdo] : bus.pdos.pdos()) {
    if (pdo.wrong_length.count == 0) continue;
    Finding finding = of_pdo(FindingKind::pdo_length, id, pdo, pdo.wrong_length);
    finding.what = fmt::format(
        "{} has come with another length than its mapping says, {}; the "
        "latest frame has {} bytes.",
        pdo_text(id, pdo), times_text(pdo.wrong_length.count), pdo.length);
    findings.push_back(finding);
  }
}

void judge_sync_window(const Observed& bus, Findings& findings) {
  for (const auto& [id, pdo] : bus.pdos.pdos()) {
    if (pdo.too_late.count < least) continue;
    Finding finding = of_pdo(FindingKind::sync_window, id, pdo, pdo.too_late);
    finding.what = fmt::format("{} came behind the window of {} (1007h) {}, up to {} behind SYNC.",
                               pdo_text(id, pdo), short_time(pdo.window),
                               times_text(pdo.too_late.count), short_time(pdo.latest_in_cycle));
    findings.push_back(finding);
  }
}

void judge_inhibit_time(const Observed& bus, Findings& findings) {
  for (const auto& [id, pdo] : bus.pdos.pdos()) {
    if (pdo.too_early.count < least) continue;
    Finding finding = of_pdo(FindingKind::inhibit_time, id, pdo, pdo.too_early);
    finding.what = fmt::format(
        "{} came again before half of its inhibit time of {} was over {}, at the "
        "soonest after {}.",
        pdo_text(id, pdo), short_time(pdo.inhibit_time), times_text(pdo.too_early.count),
        short_time(pdo.shortest));
    findings.push_back(finding);
  }
}

namespace {

std::string entry_text(const std::tuple<NodeId, std::uint16_t, std::uint8_t>& place,
                       const HeardValue& value) {
  const auto& [node, index, sub] = place;
  std::string text = object_text(index, sub);
  if (!value.name.empty()) text += fmt::format(" {}", value.name);
  if (node != 0) text += fmt::format(" of {}", node_text(node));
  return text;
}

}  // namespace

void judge_reserved_value(const Observed& bus, Findings& findings) {
  for (const auto& [place, value] : bus.values.wrong()) {
    findings.push_back(
        found(FindingKind::reserved_value, std::get<0>(place), value.tally,
              fmt::format("{} had a value that is {}, {}.", entry_text(place, value),
                          value.mark == decoder::Mark::reserved ? "reserved" : "out of range",
                          times_text(value.tally.count))));
  }
}

void judge_failed_value(const Observed& bus, Findings& findings) {
  for (const auto& [place, value] : bus.values.failed()) {
    findings.push_back(
        found(FindingKind::failed_value, std::get<0>(place), value.tally,
              fmt::format("{} says '{}' in place of a value, {}.", entry_text(place, value),
                          value.meaning, times_text(value.tally.count))));
  }
}

void judge_against_protocol(const Observed& bus, Findings& findings) {
  judge_quiet(bus, findings);
  for (const auto& [place, tally] : bus.values.messages()) {
    const auto& [node, mark] = place;
    const std::string of =
        node == 0 ? std::string("of nobody known") : fmt::format("of {}", node_text(node));
    findings.push_back(found(FindingKind::against_protocol, node, tally,
                             fmt::format("Messages {} are against CiA 301 or its profile, {}: "
                                         "{}.",
                                         of, times_text(tally.count), decoder::mark_name(mark))));
  }
}

void judge_sheet_differs(const Observed& bus, Findings& findings) {
  std::map<NodeId, Finding> by_node;
  constexpr std::uint64_t shown_max = 5;
  for (const auto& [place, difference] : bus.sheets.differences()) {
    const NodeId node = std::get<0>(place);
    Finding& finding = by_node[node];
    if (finding.count == 0) {
      finding = {.kind = FindingKind::sheet_differs,
                 .node = node,
                 .first = difference.tally.first,
                 .what = fmt::format("{} is not what its data sheet says:", node_text(node))};
    }
    finding.last = std::max(finding.last, difference.tally.last);
    if (++finding.count <= shown_max) {
      finding.what += fmt::format("{} {}", finding.count == 1 ? "" : ";", difference.text);
    }
  }
  for (auto& [node, finding] : by_node) {
    finding.what += finding.count > shown_max
                        ? fmt::format("; and {} more.", finding.count - shown_max)
                        : std::string(".");
    findings.push_back(finding);
  }
}

}  // namespace canvoy::text
