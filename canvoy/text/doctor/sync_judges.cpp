#include <fmt/format.h>

#include <algorithm>

#include "canvoy/text/doctor/judges.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

constexpr std::uint64_t syncs_least = 3;

/// `node 1 (01h) and node 2 (02h)`: nodes that report that they produce this SYNC (1005h, bit 30);
/// empty: fewer than two.
std::string producers_text(const Observed& bus, std::uint32_t can_id) {
  std::string text;
  unsigned count = 0;
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    const KnownSync& sync = bus.known.sync(node);
    if (!sync.is_produced() || sync.cob_id->can_id() != can_id) continue;
    text += fmt::format("{}{}", text.empty() ? "" : " and ", node_text(node));
    ++count;
  }
  return count < 2 ? std::string() : text;
}

Finding of_sync(FindingKind kind, const Observed& bus, NodeId node, std::string what) {
  const Tally& heard = bus.syncs.heard();
  return {.kind = kind,
          .node = node,
          .can_id = bus.syncs.can_id(),
          .count = std::max<std::uint64_t>(heard.count, 1),
          .first = heard.first,
          .last = heard.last,
          .what = std::move(what)};
}

/// True if one of its TPDOs is known to follow SYNC.
bool has_synchronous_pdo(const Observed& bus, NodeId node) {
  return std::ranges::any_of(bus.known.tpdos(), [node](const auto& each) {
    return each.first.first == node && each.second.is_synchronous();
  });
}

bool is_as_told(Duration heard, Duration told) {
  return std::chrono::abs(heard - told) <= told / 8 + 1ms;
}

}  // namespace

void judge_sync_twice(const Observed& bus, Findings& findings) {
  const SyncWatch& syncs = bus.syncs;
  if (syncs.heard().count == 0) return;
  std::string text;
  if (const auto& rhythms = syncs.rhythms()) {
    text += fmt::format(" It comes in two rhythms, each every {}, the one {} behind the other.",
                        short_time(rhythms->period), short_time(rhythms->apart));
  }
  // A lost SYNC makes one jump; with two counters nearly each SYNC does.
  if (syncs.jumps().count >= syncs_least && syncs.jumps().count > syncs.heard().count / 2) {
    text += fmt::format(" Its counter jumps, {}.", times_text(syncs.jumps().count));
  }
  const std::string producers = producers_text(bus, syncs.can_id());
  if (!producers.empty()) {
    text += fmt::format(" {} tell that they produce it (1005h, bit 30).", producers);
  }
  if (text.empty()) return;
  findings.push_back(
      of_sync(FindingKind::sync_twice, bus, 0,
              fmt::format("Two devices send SYNC, {:03X}h.{}", syncs.can_id(), text)));
}

void judge_sync_differs(const Observed& bus, Findings& findings) {
  const SyncWatch& syncs = bus.syncs;
  if (syncs.heard().count < syncs_least) return;
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    const KnownSync& sync = bus.known.sync(node);
    if (!sync.cob_id) continue;
    const bool is_other = sync.cob_id->is_base_frame() && sync.cob_id->can_id() != syncs.can_id();
    if (is_other && !sync.is_produced() && has_synchronous_pdo(bus, node)) {
      findings.push_back(of_sync(
          FindingKind::sync_differs, bus, node,
          fmt::format(
              "{} goes by {:03X}h (1005h), and has synchronous PDOs; SYNC comes as {:03X}h.",
              node_text(node), sync.cob_id->can_id(), syncs.can_id())));
    }
    const Duration told = sync.period.value_or(Duration::zero());
    const bool is_its = sync.is_produced() && !is_other && told > Duration::zero();
    if (is_its && syncs.period() > Duration::zero() && !is_as_told(syncs.period(), told)) {
      findings.push_back(
          of_sync(FindingKind::sync_differs, bus, node,
                  fmt::format("SYNC comes every {}, and 1006h of {}, which produces "
                              "it, is {}.",
                              short_time(syncs.period()), node_text(node), short_time(told))));
    }
  }
}

}  // namespace canvoy::text
