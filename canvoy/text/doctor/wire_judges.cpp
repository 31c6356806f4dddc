#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "canvoy/text/doctor/judges.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

/// Fewer errors are chance: for example, a connector was plugged in.
constexpr std::uint64_t errors_least = 5;
/// Share of the errors at one node or one CAN-ID, if its share of all frames is smaller.
constexpr double struck_share = 0.7;
/// Number of attributed errors that is needed for a statement.
constexpr std::uint64_t known_least = 8;

bool is_alone(const Observed& bus) {
  const std::uint64_t errors = bus.errors.errors().count;
  return errors >= errors_least && bus.errors.unacknowledged() * 2 >= errors;
}

bool are_too_many(const Observed& bus) {
  const std::uint64_t errors = bus.errors.errors().count;
  constexpr std::uint64_t frames_per_error = 1000;
  const bool is_heard = bus.traffic.frames() != 0;
  return is_heard && errors >= errors_least && errors * frames_per_error >= bus.traffic.frames() &&
         !is_alone(bus);
}

/// True if nearly all errors belong to it.
bool is_struck(const ErrorWatch::Struck& struck, const Observed& bus) {
  const auto errors = static_cast<double>(struck.errors) / static_cast<double>(bus.errors.known());
  const auto frames =
      static_cast<double>(struck.frames) / static_cast<double>(bus.traffic.frames());
  return errors >= struck_share && frames < errors / 2;
}

/// The node with nearly all errors; 0: none, or a single CAN-ID of it.
NodeId struck_node(const Observed& bus) {
  if (bus.errors.known() < known_least || struck_id(bus)) return 0;
  for (const auto& [node, struck] : bus.errors.by_node()) {
    if (is_struck(struck, bus)) return node;
  }
  return 0;
}

/// The only node with hardly any errors: it may destroy the frames of the others. 0: none.
NodeId spared_node(const Observed& bus) {
  constexpr double errors_expected = 8;
  const double share =
      static_cast<double>(bus.errors.known()) / static_cast<double>(bus.traffic.frames());
  NodeId spared = 0;
  unsigned struck_nodes = 0;
  for (const auto& [node, struck] : bus.errors.by_node()) {
    const double expected = share * static_cast<double>(struck.frames);
    const auto errors = static_cast<double>(struck.errors);
    if (errors > expected / 2) {
      ++struck_nodes;
    } else if (expected >= errors_expected) {
      if (spared != 0 || errors > expected / 4) return 0;
      spared = node;
    }
  }
  return struck_nodes >= 2 ? spared : NodeId{0};
}

std::string share_text(const Observed& bus) {
  const auto errors = static_cast<double>(bus.errors.errors().count);
  const auto frames = static_cast<double>(bus.traffic.frames());
  return fmt::format("{} error frames beside {} frames: {:.1f} %", bus.errors.errors().count,
                     bus.traffic.frames(), errors / (errors + frames) * 100);
}

std::string state_text(const Observed& bus) {
  if (bus.errors.was_bus_off()) return " The controller that listens was bus-off.";
  if (bus.errors.was_passive()) return " The controller that listens was error-passive.";
  return {};
}

/// `node 5: 12 of 300, node 7: 9 of 250`
std::string by_node_text(const Observed& bus) {
  std::vector<ErrorWatch::Struck> nodes;
  for (const auto& [node, struck] : bus.errors.by_node()) {
    if (struck.errors != 0) nodes.push_back(struck);
  }
  std::ranges::sort(nodes, std::ranges::greater{}, &ErrorWatch::Struck::errors);
  constexpr std::size_t shown_max = 5;
  if (nodes.size() > shown_max) nodes.resize(shown_max);
  std::string text;
  for (const ErrorWatch::Struck& node : nodes) {
    text += fmt::format("{}node {}: {} on {} frames", text.empty() ? "" : ", ", node.node,
                        node.errors, node.frames);
  }
  return text;
}

std::string by_id_text(const Observed& bus, NodeId node) {
  std::vector<std::pair<std::uint32_t, ErrorWatch::Struck>> ids;
  for (const auto& each : bus.errors.by_id()) {
    if (each.second.errors != 0 && (node == 0 || each.second.node == node)) ids.emplace_back(each);
  }
  std::ranges::sort(ids,
                    [](const auto& a, const auto& b) { return a.second.errors > b.second.errors; });
  constexpr std::size_t shown_max = 5;
  if (ids.size() > shown_max) ids.resize(shown_max);
  std::string text;
  for (const auto& [id, struck] : ids) {
    text += fmt::format("{}{:03X}h: {} on {} frames", text.empty() ? "" : ", ", id, struck.errors,
                        struck.frames);
  }
  return text;
}

Finding of_errors(FindingKind kind, const Observed& bus, std::string what) {
  return found(kind, 0, bus.errors.errors(), std::move(what));
}

}  // namespace

Finding found(FindingKind kind, NodeId node, const Tally& seen, std::string what) {
  return {.kind = kind,
          .node = node,
          .count = seen.count,
          .first = seen.first,
          .last = seen.last,
          .what = std::move(what)};
}

std::string short_time(Duration time) {
  const auto micros = static_cast<double>(time.count());
  if (time < 1ms) return fmt::format("{} us", time.count());
  if (time < 1s) return fmt::format("{:.4g} ms", micros / 1e3);
  return fmt::format("{:.4g} s", micros / 1e6);
}

std::string times_text(std::uint64_t count) {
  if (count == 1) return "once";
  return count == 2 ? "twice" : fmt::format("{} times", count);
}

std::optional<std::uint16_t> struck_id(const Observed& bus) {
  if (bus.errors.known() < known_least || !are_too_many(bus)) return std::nullopt;
  for (const auto& [id, struck] : bus.errors.by_id()) {
    if (id <= Frame::id_max && is_struck(struck, bus)) return static_cast<std::uint16_t>(id);
  }
  return std::nullopt;
}

void judge_no_traffic(const Observed& bus, Findings& findings) {
  if (bus.traffic.frames() != 0 || bus.errors.errors().count != 0) return;
  findings.push_back({.kind = FindingKind::no_traffic,
                      .first = bus.begin,
                      .last = bus.end,
                      .what = fmt::format("In {} nobody has sent anything, and there was no error "
                                          "either.",
                                          short_time(bus.end - bus.begin))});
}

void judge_wrong_bit_rate(const Observed& bus, Findings& findings) {
  if (bus.traffic.frames() != 0 || bus.errors.errors().count == 0 || is_alone(bus)) return;
  findings.push_back(of_errors(FindingKind::wrong_bit_rate, bus,
                               fmt::format("Not one whole frame, and {} error frames.{}",
                                           bus.errors.errors().count, state_text(bus))));
}

void judge_not_acknowledged(const Observed& bus, Findings& findings) {
  if (!is_alone(bus)) return;
  findings.push_back(of_errors(
      FindingKind::not_acknowledged, bus,
      fmt::format("Of {} error frames, {} say that a frame was not acknowledged: who sends it is "
                  "alone, or no other node has its bit rate.{}",
                  bus.errors.errors().count, bus.errors.unacknowledged(), state_text(bus))));
}

void judge_bus_errors(const Observed& bus, Findings& findings) {
  if (!are_too_many(bus) || struck_id(bus) || struck_node(bus) != 0 || spared_node(bus) != 0)
    return;
  std::string what = share_text(bus) + ".";
  if (bus.errors.known() != 0) {
    what +=
        fmt::format(" They strike {}; by identifier {}.", by_node_text(bus), by_id_text(bus, 0));
  }
  findings.push_back(of_errors(FindingKind::bus_errors, bus, what + state_text(bus)));
}

void judge_errors_at_node(const Observed& bus, Findings& findings) {
  if (!are_too_many(bus) || struck_id(bus)) return;
  const NodeId struck = struck_node(bus);
  const NodeId spared = spared_node(bus);
  if (struck == 0 && spared == 0) return;
  Finding finding = of_errors(FindingKind::errors_at_node, bus, share_text(bus));
  finding.node = struck != 0 ? struck : spared;
  if (struck != 0) {
    finding.what += fmt::format(". Nearly all strike the frames of {}: {}.", node_text(struck),
                                by_id_text(bus, struck));
  } else {
    finding.what += fmt::format(
        ". They strike the frames of all but {} ({}): it may be the one that destroys "
        "those of the others.",
        node_text(spared), by_node_text(bus));
  }
  finding.what += state_text(bus);
  findings.push_back(finding);
}

void judge_load_peak(const Observed& bus, Findings& findings) {
  const Tally& peaks = bus.traffic.peaks();
  if (peaks.count == 0) return;
  std::string senders;
  for (const TrafficWatch::Share& share : bus.traffic.peak_shares()) {
    senders += fmt::format("{}{:.0f} % {:03X}h", senders.empty() ? "" : ", ", share.of_bus * 100,
                           share.can_id);
    if (share.node != 0) senders += fmt::format(" of {}", node_text(share.node));
  }
  const auto& shares = bus.traffic.peak_shares();
  findings.push_back(found(FindingKind::load_peak, shares.empty() ? NodeId{0} : shares.front().node,
                           peaks,
                           fmt::format("In {} s the bus was busy for more than {:.0f} % of a "
                                       "second, at most for {:.0f} %. Who made that one: {}.",
                                       peaks.count, TrafficWatch::load_most * 100,
                                       bus.traffic.highest_load() * 100, senders)));
}

void judge_lost_bus(const Observed& bus, Findings& findings) {
  const Tally& losses = bus.losses;
  if (losses.count == 0) return;
  findings.push_back(
      found(FindingKind::lost_bus, 0, losses,
            fmt::format("It was lost {} after the beginning, {}: {}.",
                        short_time(losses.first - bus.begin), times_text(losses.count), bus.loss)));
}

void judge_silence(const Observed& bus, Findings& findings) {
  const Tally& silences = bus.traffic.silences();
  if (silences.count == 0) return;
  findings.push_back(
      found(FindingKind::silence, 0, silences,
            fmt::format("Nobody spoke for {} s or longer, {}; the longest silence was {}.",
                        TrafficWatch::silence_least / 1s, times_text(silences.count),
                        short_time(bus.traffic.longest_silence()))));
}

}  // namespace canvoy::text
