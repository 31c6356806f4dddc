#include <fmt/format.h>

#include <algorithm>

#include "canvoy/text/doctor/judges.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

template <class Judge>
void for_each_node(const Judge& judge) {
  for (NodeId node = node_id_min; node <= node_id_max; ++node) judge(node);
}

/// From 1017h, or as heard; zero: unknown.
Duration period_of(const Observed& bus, NodeId node) {
  if (const auto told = bus.known.producer_time(node)) return *told;
  return bus.heartbeats.of(node).period();
}

/// Time after which a node counts as lost.
struct Limit {
  Duration time{};
  NodeId consumer = 0;  ///< the consumer with this time (1016h); 0: none
};
Limit limit_of(const Observed& bus, NodeId node) {
  if (const auto consumer = bus.known.consumer_of(node)) return {consumer->time, consumer->by};
  return {period_of(bus, node) * 5 / 2, 0};
}

std::string period_text(const Observed& bus, NodeId node) {
  const bool is_told = bus.known.producer_time(node).has_value();
  return fmt::format("{}{}", short_time(period_of(bus, node)),
                     is_told ? " by 1017h" : ", as most of them come");
}

constexpr unsigned turns_least = 4;
constexpr std::uint64_t doubles_least = 2;

/// Evidence that two devices have this node-ID; empty: none.
std::string twice_text(const Observed& bus, NodeId node) {
  const NodeHeartbeats& beats = bus.heartbeats.of(node);
  std::string text;
  if (beats.two_rhythms()) {
    text += fmt::format(
        " Its heartbeats come in two rhythms: each every {}, the one {} behind the other.",
        short_time(beats.two_rhythms()->period), short_time(beats.two_rhythms()->apart));
  } else if (beats.two_periods()) {
    text += fmt::format(" Its heartbeats are those of two: one every {}, and one every {}.",
                        short_time(beats.two_periods()->shorter),
                        short_time(beats.two_periods()->longer));
  } else if (beats.crossed()) {
    text += fmt::format(" Between heartbeats that are {} apart, its period, come others.",
                        short_time(period_of(bus, node)));
  }
  if (beats.state_turns() >= turns_least) {
    text += fmt::format(" It says in turns that it is {} and {}, and nobody commands it.",
                        nmt_state_text(beats.states_in_turns().first),
                        nmt_state_text(beats.states_in_turns().second));
  }
  const Tally& doubles = bus.sdos.of(node).doubles;
  if (doubles.count >= doubles_least) {
    text += fmt::format(" To one SDO request came two answers, {}.", times_text(doubles.count));
  }
  const auto struck = struck_id(bus);
  if (struck && *struck == can_id::error_control + node) {
    text += " Nearly all error frames strike its heartbeats: two that begin at once, and differ.";
  }
  return text;
}

}  // namespace

void judge_node_id_twice(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const std::string text = twice_text(bus, node);
    if (text.empty()) return;
    const NodeHeartbeats& beats = bus.heartbeats.of(node);
    const auto& rhythms = beats.two_rhythms();
    const Tally& doubles = bus.sdos.of(node).doubles;
    const Time answered_first = doubles.count != 0 ? doubles.first : bus.begin;
    const auto& periods = beats.two_periods();
    const Time last = std::max({rhythms ? rhythms->last : Time{}, periods ? periods->last : Time{},
                                beats.turned_at(), beats.crossed().value_or(Time{}), doubles.last});
    findings.push_back({.kind = FindingKind::node_id_twice,
                        .node = node,
                        .count = 1,
                        .first = rhythms ? rhythms->since : answered_first,
                        .last = last == Time{} ? bus.end : last,
                        .what = fmt::format("Two devices are {}.{}", node_text(node), text)});
  });
}

namespace {

/// A node that does not answer guarding requests.
void judge_guarding(const Observed& bus, Findings& findings, NodeId node) {
  const Guarding& guarding = bus.guarding.at(node);
  if (guarding.most_in_row < Guarding::lost_from) return;
  findings.push_back(
      found(FindingKind::heartbeat_missing, node, guarding.missed,
            fmt::format("{} has left {} guarding requests without an answer, {} in a row.",
                        node_text(node), guarding.missed.count, guarding.most_in_row)));
}

/// A node that another one waits for (1016h), and of which no frame was heard.
void judge_awaited(const Observed& bus, Findings& findings, NodeId node) {
  const auto consumer = bus.known.consumer_of(node);
  const bool is_heard = bus.traffic.is_heard(node) || bus.heartbeats.of(node).has_booted();
  if (!consumer || is_heard || bus.traffic.awake() <= 2 * consumer->time) return;
  findings.push_back(
      {.kind = FindingKind::heartbeat_missing,
       .node = node,
       .count = 1,
       .first = bus.begin,
       .last = bus.end,
       .what = fmt::format("Node {} waits for heartbeats of {} within {} (1016h), "
                           "and nothing of it was heard.",
                           consumer->by, node_text(node), short_time(consumer->time))});
}

}  // namespace

void judge_heartbeat_missing(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const NodeHeartbeats& beats = bus.heartbeats.of(node);
    const Limit limit = limit_of(bus, node);
    judge_guarding(bus, findings, node);
    if (!beats.is_heard()) judge_awaited(bus, findings, node);
    if (!beats.is_heard() || limit.time <= Duration::zero()) return;
    if (period_of(bus, node) <= Duration::zero()) return;
    Finding finding{.kind = FindingKind::heartbeat_missing, .node = node};
    for (const HeartbeatGap& gap : beats.gaps()) {
      if (gap.awake <= limit.time) continue;
      ++finding.count;
      finding.first = finding.count == 1 ? gap.end : std::min(finding.first, gap.end);
      finding.last = std::max(finding.last, gap.end);
    }
    if (finding.count == 0) return;
    const std::string who = limit.consumer == 0
                                ? std::string("2.5 of its periods")
                                : fmt::format(
                                      "the time after which node {} takes it for lost "
                                      "(1016h)",
                                      limit.consumer);
    const bool is_gone = bus.end - beats.latest() > limit.time;
    finding.what = fmt::format(
        "{} was without heartbeat {} for longer than {}, {}: for {} at "
        "most. Its period is {}.{}",
        node_text(node), times_text(finding.count), short_time(limit.time), who,
        short_time(beats.gaps().front().length), period_text(bus, node),
        is_gone ? " It has not come back." : "");
    findings.push_back(finding);
  });
}

void judge_heartbeat_late(const Observed& bus, Findings& findings) {
  constexpr Duration by_chance = 20ms;
  constexpr unsigned least = 2;
  for_each_node([&](NodeId node) {
    const NodeHeartbeats& beats = bus.heartbeats.of(node);
    const Duration period = period_of(bus, node);
    if (!beats.is_heard() || period <= Duration::zero()) return;
    Finding finding{.kind = FindingKind::heartbeat_late, .node = node};
    Duration longest{};
    for (const HeartbeatGap& gap : beats.gaps()) {
      const bool is_late = gap.awake > period * 5 / 4 + by_chance;
      if (!is_late || gap.awake > limit_of(bus, node).time || gap.end == bus.end) continue;
      ++finding.count;
      finding.first = finding.count == 1 ? gap.end : std::min(finding.first, gap.end);
      finding.last = std::max(finding.last, gap.end);
      longest = std::max(longest, gap.length);
    }
    if (finding.count < least) return;
    finding.what = fmt::format("Heartbeats of {} were late {}, by up to {}. Its period is {}.",
                               node_text(node), times_text(finding.count),
                               short_time(longest - period), period_text(bus, node));
    findings.push_back(finding);
  });
}

void judge_heartbeat_jitter(const Observed& bus, Findings& findings) {
  constexpr unsigned intervals_least = 10;
  constexpr unsigned uneven_of = 5;
  for_each_node([&](NodeId node) {
    const NodeHeartbeats& beats = bus.heartbeats.of(node);
    const Duration period = period_of(bus, node);
    if (!beats.is_heard() || period <= Duration::zero()) return;
    const auto [uneven, intervals] = beats.uneven(period);
    if (intervals < intervals_least || uneven * uneven_of < intervals) return;
    findings.push_back(
        {.kind = FindingKind::heartbeat_jitter,
         .node = node,
         .count = uneven,
         .first = bus.begin,
         .last = bus.end,
         .what = fmt::format("Of the last {} heartbeats of {}, {} came more than a fifth of the "
                             "period too early or too late; the standard deviation is {}. Its "
                             "period is {}.",
                             intervals, node_text(node), uneven, short_time(beats.jitter()),
                             period_text(bus, node))});
  });
}

void judge_unexpected_boot_up(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const Tally& boots = bus.nodes.of(node).boot_ups;
    if (boots.count == 0) return;
    findings.push_back(found(FindingKind::unexpected_boot_up, node, boots,
                             fmt::format("{} has started anew {}, and no NMT command had asked "
                                         "for it.",
                                         node_text(node), times_text(boots.count))));
  });
}

void judge_emergency_storm(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const HeardNode& heard = bus.nodes.of(node);
    if (heard.storm.count == 0) return;
    findings.push_back(found(FindingKind::emergency_storm, node, heard.emergencies,
                             fmt::format("{} has sent {} emergencies, more than {} in {} s. The "
                                         "latest is {:04X}h: {}.",
                                         node_text(node), heard.emergencies.count,
                                         NodeWatch::storm_least, NodeWatch::storm_time / 1s,
                                         heard.error_code, emergency_text(heard.error_code))));
  });
}

void judge_reported_error(const Observed& bus, Findings& findings) {
  const bool has_cause = std::ranges::any_of(findings, [](const Finding& each) {
    return finding_row(each.kind).severity != Severity::note;
  });
  for_each_node([&](NodeId node) {
    const HeardNode& heard = bus.nodes.of(node);
    if (heard.errors.count == 0 || heard.storm.count != 0) return;
    const auto of_communication = [](std::uint16_t code) {
      return code >> 8U == 0x81 || code >> 8U == 0x82;
    };
    if (has_cause && std::ranges::all_of(heard.codes, of_communication)) return;
    std::vector<std::string> codes;
    codes.reserve(heard.codes.size());
    for (const std::uint16_t code : heard.codes) {
      codes.push_back(fmt::format("{:04X}h: {}", code, emergency_text(code)));
    }
    findings.push_back(
        found(FindingKind::reported_error, node, heard.errors,
              fmt::format("{} has told of an error {}: {}. {}", node_text(node),
                          times_text(heard.errors.count), fmt::join(codes, "; "),
                          heard.error_code == 0 ? "The latest emergency says that it is gone."
                                                : "Nothing says that it is gone.")));
  });
}

void judge_sdo_time_out(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const HeardServer& server = bus.sdos.of(node);
    if (server.time_outs.count == 0) return;
    findings.push_back(found(
        FindingKind::sdo_time_out, node, server.time_outs,
        fmt::format("{} is there, and has left SDO requests without an "
                    "answer {}, the latest one for {}.{}",
                    node_text(node), times_text(server.time_outs.count),
                    object_text(server.index, server.sub),
                    server.answers == 0 ? std::string(" It has answered to none.")
                                        : fmt::format(" It has answered to {}.", server.answers))));
  });
}

void judge_sdo_slow(const Observed& bus, Findings& findings) {
  for_each_node([&](NodeId node) {
    const HeardServer& server = bus.sdos.of(node);
    if (server.slow.count == 0) return;
    findings.push_back(found(
        FindingKind::sdo_slow, node, server.slow,
        fmt::format("{} took {} or longer for an SDO answer {}, {} at most, for {}.",
                    node_text(node), short_time(SdoWatch::slow_from), times_text(server.slow.count),
                    short_time(server.slowest), object_text(server.index, server.sub))));
  });
}

}  // namespace canvoy::text
