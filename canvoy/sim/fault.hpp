// Faults of simulated networks: which kinds there are, as rows of a table, when and where they
// come, and how people write them. All worlds have one grammar: `heartbeat-loss@20min+30s`,
// `cable-cut:lift=2:node=16@5min`. A world gives an enumeration of its kinds, a row for each, and
// its places.
//
//     enum class FaultKind : std::uint8_t { lost_node, no_paper };
//     constexpr FaultRow fault_rows[] = {{"lost-node", "a node has no power", {.is_at_node = true,
//     .node = 5}},
//                                        {"no-paper", "the printer has no paper", {.is_harmless =
//                                        true}}};
//     constexpr FaultGrammar grammar_of(FaultKind) { return {fault_rows, node_place}; }
//
//     FaultPlan<FaultKind> plan{.seed = 1, .faults = {{FaultKind::no_paper, Time(20min), 30s}}};
//     ParsedFault<FaultKind> parsed = parse_fault<FaultKind>("lost-node:node=5@20min+30s");
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"

namespace canvoy {

/// What holds for all faults of a kind.
struct FaultTraits {
  bool is_at_node = false;  ///< it is one of a node, as events tell it
  NodeId node = 0;          ///< where the plan leaves it open; 0: nowhere
  bool is_at_spot = false;  ///< it is one of a spot
  std::uint8_t spot = 0;    ///< where the plan leaves it open
  bool is_over_at_once = false;
  bool is_harmless = false;  ///< it excuses nothing, but for the moment in which it begins or ends
  /// Somebody cheats, and it is to be found out: a soak, which looks at what goes wrong by itself,
  /// does not draw it. Rows of these are the last ones.
  bool is_tampering = false;
};

/// A kind of fault; its place in the table of its world is the number of the kind.
struct FaultRow {
  std::string_view name;         ///< as it is written: `lost-node`
  std::string_view description;  ///< one line for a help text
  FaultTraits traits{};
};

/// The duration of a fault that is not mended.
inline constexpr Duration for_the_rest = Duration::max();

/// A fault of a plan.
template <class Kind>
struct ScheduledFault {
  Kind kind{};
  Time start{};
  Duration duration = for_the_rest;
  std::uint8_t part = 1;  ///< of the world: which lift; 0: the group of them, or all
  NodeId node = 0;        ///< 0: the plan leaves it open
  std::uint8_t spot = 0;  ///< a floor, an axis; 0: the plan leaves it open

  Time end() const { return duration == for_the_rest ? never : start + duration; }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};
/// By the number of its kind.
using AnyFault = ScheduledFault<std::size_t>;

template <class To, class From>
ScheduledFault<To> fault_as(const ScheduledFault<From>& fault) {
  return {
      static_cast<To>(fault.kind), fault.start, fault.duration, fault.part, fault.node, fault.spot};
}

/// What goes wrong in a run.
template <class Kind>
struct FaultPlan {
  std::uint64_t seed = 1;  ///< of what is left to chance
  std::vector<ScheduledFault<Kind>> faults{};
};

/// Of all frames, where they are corrupted.
inline constexpr double corrupted_share = 0.01;

/// What may stand behind the name of a fault to say where.
struct FaultPlaceName {
  std::string_view name;  ///< `node`, with a number: `:node=5`
  unsigned most =
      0;  ///< the greatest number; 0: the word stands alone, as `:group`, and is the number 0
  std::uint8_t AnyFault::*member = &AnyFault::node;
};
/// The places of most worlds.
inline constexpr FaultPlaceName node_place[] = {{"node", node_id_max}};

/// What a world knows.
struct FaultGrammar {
  std::span<const FaultRow> kinds;
  std::span<const FaultPlaceName> places = {};
};

// Of the world of a kind, whose grammar_of(Kind) is found beside it.

template <class Kind>
constexpr FaultGrammar fault_grammar() {
  return grammar_of(Kind{});
}
template <class Kind>
constexpr const FaultRow& fault_row(Kind kind) {
  return grammar_of(kind).kinds[static_cast<std::size_t>(kind)];
}
template <class Kind>
constexpr std::string_view fault_name(Kind kind) {
  return fault_row(kind).name;
}
template <class Kind>
constexpr bool has_node(Kind kind) {
  return fault_row(kind).traits.is_at_node;
}
template <class Kind>
constexpr bool has_spot(Kind kind) {
  return fault_row(kind).traits.is_at_spot;
}
template <class Kind>
constexpr bool lasts(Kind kind) {
  return !fault_row(kind).traits.is_over_at_once;
}
/// It excuses nothing.
template <class Kind>
constexpr bool is_harmless(Kind kind) {
  return fault_row(kind).traits.is_harmless;
}
/// Somebody cheats.
template <class Kind>
constexpr bool is_tampering(Kind kind) {
  return fault_row(kind).traits.is_tampering;
}
/// How many kinds of a world are none of tampering.
constexpr std::size_t untampered_kinds(std::span<const FaultRow> kinds) {
  std::size_t count = 0;
  while (count < kinds.size() && !kinds[count].traits.is_tampering) ++count;
  return count;
}
/// The node at which a fault is; 0: it is at none.
template <class Kind>
constexpr NodeId node_of(const ScheduledFault<Kind>& fault) {
  return has_node(fault.kind) && fault.node != 0 ? fault.node : fault_row(fault.kind).traits.node;
}
template <class Kind>
constexpr std::uint8_t spot_of(const ScheduledFault<Kind>& fault) {
  return fault.spot != 0 ? fault.spot : fault_row(fault.kind).traits.spot;
}

/// A fault, or in one line what is wrong with the text and what would be right.
template <class Kind>
struct ParsedFault {
  std::optional<ScheduledFault<Kind>> fault;
  std::string error;
};
using FaultParse = ParsedFault<std::size_t>;
FaultParse parse_fault(const FaultGrammar& grammar, std::string_view text);
template <class Kind>
ParsedFault<Kind> parse_fault(std::string_view text) {
  FaultParse parsed = parse_fault(fault_grammar<Kind>(), text);
  if (!parsed.fault) return {std::nullopt, std::move(parsed.error)};
  return {fault_as<Kind>(*parsed.fault), {}};
}

/// What parse_fault() reads as the same.
std::string fault_text(const FaultGrammar& grammar, const AnyFault& fault);
template <class Kind>
std::string fault_text(const ScheduledFault<Kind>& fault) {
  return fault_text(fault_grammar<Kind>(), fault_as<std::size_t>(fault));
}

/// How faults are written, and a line for each kind.
std::string fault_help(const FaultGrammar& grammar);

}  // namespace canvoy
