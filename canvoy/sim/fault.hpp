// Faults of simulated networks: their kinds, as rows of a table, when and where they occur, and
// their text form. All worlds share one grammar: `heartbeat-loss@20min+30s`,
// `cable-cut:lift=2:node=16@5min`. A world gives an enumeration of its kinds, a row for each, and
// its places.
//
//     enum class FaultKind : std::uint8_t { lost_node, no_paper };
//     constexpr FaultRow fault_rows[] = {
//         {"lost-node", "a node has no power", {.is_at_node = true, .node = 5}},
//         {"no-paper", "the printer has no paper", {.is_harmless = true}}};
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
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// Properties of all faults of a kind.
struct FaultTraits {
  bool is_at_node = false;       ///< true: a fault of this kind is at a node, as events report it
  NodeId node = 0;               ///< node where the plan leaves it open; 0: nowhere
  bool is_at_spot = false;       ///< true: a fault of this kind is at a spot
  std::uint8_t spot = 0;         ///< spot where the plan leaves it open
  bool is_over_at_once = false;  ///< true: it has no duration
  bool is_harmless = false;  ///< true: it excuses nothing, except at the moment in which it begins
                             ///< or ends
  /// True: it stands for fraud, which must be found out. A soak does not draw these kinds, since it
  /// looks at failures without intent. Their rows are the last ones.
  bool is_tampering = false;
};

/// A kind of fault. Its index in the table of its world is the number of the kind.
struct FaultRow {
  std::string_view name;         ///< as written in a plan: `lost-node`
  std::string_view description;  ///< one line for a help text
  FaultTraits traits{};          ///< of all faults of the kind
};

/// Duration of a fault that is not mended.
inline constexpr Duration for_the_rest = Duration::max();

/// A fault of a plan.
template <class Kind>
struct ScheduledFault {
  Kind kind{};                       ///< in the table of the world
  Time start{};                      ///< time of the world
  Duration duration = for_the_rest;  ///< above zero; for_the_rest: not mended
  std::uint8_t part = 1;  ///< part of the world: which lift; 0: the group of them, or all
  NodeId node = 0;        ///< 0: the plan leaves it open
  std::uint8_t spot = 0;  ///< a floor or an axis; 0: the plan leaves it open

  Time end() const { return duration == for_the_rest ? never : start + duration; }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};
/// A fault of any world, by the number of its kind.
using AnyFault = ScheduledFault<std::size_t>;

/// The same fault with its kind as another type of number.
template <class To, class From>
ScheduledFault<To> fault_as(const ScheduledFault<From>& fault) {
  return {
      static_cast<To>(fault.kind), fault.start, fault.duration, fault.part, fault.node, fault.spot};
}

/// The faults of a run.
template <class Kind>
struct FaultPlan {
  std::uint64_t seed = 1;                      ///< seed of everything that is left to chance
  std::vector<ScheduledFault<Kind>> faults{};  ///< in any order
};

/// Share of all frames that are corrupted while a fault corrupts frames.
inline constexpr double corrupted_share = 0.01;

/// A word that may follow the name of a fault and says where it is.
struct FaultPlaceName {
  std::string_view name;  ///< `node`, followed by a number: `:node=5`
  unsigned most =
      0;  ///< the greatest number; 0: the word stands alone, as in `:group`, and means the number 0
  std::uint8_t AnyFault::*member = &AnyFault::node;  ///< of the fault that the number is for
};
/// The places in most worlds.
inline constexpr FaultPlaceName node_place[] = {{"node", node_id_max}};

/// Kinds and places of a world.
struct FaultGrammar {
  std::span<const FaultRow> kinds;              ///< by their numbers
  std::span<const FaultPlaceName> places = {};  ///< that a fault may name
};

// The functions below take the grammar that grammar_of(Kind) returns, which is found beside the
// kind.

/// Grammar of the world with these kinds.
template <class Kind>
constexpr FaultGrammar fault_grammar() {
  return grammar_of(Kind{});
}
/// Row of a kind.
template <class Kind>
constexpr const FaultRow& fault_row(Kind kind) {
  return grammar_of(kind).kinds[static_cast<std::size_t>(kind)];
}
/// Name of a kind, as written in a plan.
template <class Kind>
constexpr std::string_view fault_name(Kind kind) {
  return fault_row(kind).name;
}
/// True if faults of the kind are at a node.
template <class Kind>
constexpr bool has_node(Kind kind) {
  return fault_row(kind).traits.is_at_node;
}
/// True if faults of the kind are at a spot.
template <class Kind>
constexpr bool has_spot(Kind kind) {
  return fault_row(kind).traits.is_at_spot;
}
/// True if faults of the kind have a duration.
template <class Kind>
constexpr bool lasts(Kind kind) {
  return !fault_row(kind).traits.is_over_at_once;
}
/// True if the fault excuses nothing.
template <class Kind>
constexpr bool is_harmless(Kind kind) {
  return fault_row(kind).traits.is_harmless;
}
/// True if the fault stands for fraud.
template <class Kind>
constexpr bool is_tampering(Kind kind) {
  return fault_row(kind).traits.is_tampering;
}
/// Number of kinds of a world that are not tampering.
constexpr std::size_t untampered_kinds(std::span<const FaultRow> kinds) {
  std::size_t count = 0;
  while (count < kinds.size() && !kinds[count].traits.is_tampering) ++count;
  return count;
}
/// Node of a fault; 0: it is at no node.
template <class Kind>
constexpr NodeId node_of(const ScheduledFault<Kind>& fault) {
  return has_node(fault.kind) && fault.node != 0 ? fault.node : fault_row(fault.kind).traits.node;
}
/// Spot of a fault; 0: it is at no spot.
template <class Kind>
constexpr std::uint8_t spot_of(const ScheduledFault<Kind>& fault) {
  return fault.spot != 0 ? fault.spot : fault_row(fault.kind).traits.spot;
}

/// Returns the fault, or one line that says what is wrong with the text and what would be right.
template <class Kind>
struct ParsedFault {
  std::optional<ScheduledFault<Kind>> fault;  ///< nothing: see the error
  std::string error;                          ///< one line; empty if there is a fault
};
/// The result for any world.
using FaultParse = ParsedFault<std::size_t>;
/// Parses a fault: its name, places, and times.
FaultParse parse_fault(const FaultGrammar& grammar, std::string_view text);
/// Parses a fault of the world with these kinds.
template <class Kind>
ParsedFault<Kind> parse_fault(std::string_view text) {
  FaultParse parsed = parse_fault(fault_grammar<Kind>(), text);
  if (!parsed.fault) return {std::nullopt, std::move(parsed.error)};
  return {fault_as<Kind>(*parsed.fault), {}};
}

/// Text that parse_fault() reads as this fault.
std::string fault_text(const FaultGrammar& grammar, const AnyFault& fault);
/// Text that parse_fault() reads as this fault.
template <class Kind>
std::string fault_text(const ScheduledFault<Kind>& fault) {
  return fault_text(fault_grammar<Kind>(), fault_as<std::size_t>(fault));
}

/// Help text: how to write faults, and a line for each kind.
std::string fault_help(const FaultGrammar& grammar);

}  // namespace canvoy
