// Faults of a simulated network as people write them. All worlds have one grammar, and each its own
// kinds and places: `heartbeat-loss@20min+30s`, `cable-cut:lift=2:node=16@5min`.
//
//     constexpr FaultName names[] = {{"lost-node", "a node has no power"}};
//     constexpr FaultPlaceName places[] = {{"node", 127}};
//     FaultParse parsed = parse_fault({names, places}, "lost-node:node=5@20min+30s");
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// A kind of fault; its place in a list of them is the number of the kind.
struct FaultName {
  std::string_view name;         ///< as it is written: `lost-node`
  std::string_view description;  ///< one line for a help text
};

/// What may stand behind the name of a fault to say where.
struct FaultPlaceName {
  std::string_view name;  ///< `node`, with a number: `:node=5`
  unsigned most = 0;      ///< the greatest number; 0: the word stands alone, as `:group`
};

/// What a world knows.
struct FaultGrammar {
  std::span<const FaultName> kinds;
  std::span<const FaultPlaceName> places = {};
};

/// The duration of a fault that is not mended.
inline constexpr Duration for_the_rest = Duration::max();

/// When a fault is over.
constexpr Time end_of_fault(Time start, Duration duration) {
  return duration == for_the_rest ? never : start + duration;
}

/// A fault as it is written, by the grammar of a world.
struct WrittenFault {
  struct Place {
    std::size_t place = 0;  ///< which of the grammar's
    unsigned number = 0;
  };
  std::size_t kind = 0;  ///< which of the grammar's
  std::vector<Place> places{};
  Time start{};
  Duration duration = for_the_rest;
};

/// As a world has them whose only place is a node: with `kind`, `node`, `start` and `duration`; 0
/// is no node.
template <class Scheduled>
Scheduled scheduled_at_node(const WrittenFault& fault) {
  Scheduled made{};
  made.kind = static_cast<decltype(made.kind)>(fault.kind);
  if (!fault.places.empty()) {
    made.node = static_cast<decltype(made.node)>(fault.places.back().number);
  }
  made.start = fault.start;
  made.duration = fault.duration;
  return made;
}
template <class Scheduled>
WrittenFault written_at_node(const Scheduled& fault) {
  WrittenFault made{.kind = static_cast<std::size_t>(fault.kind),
                    .start = fault.start,
                    .duration = fault.duration};
  if (fault.node != 0) made.places.push_back({0, fault.node});
  return made;
}

/// A fault, or in one line what is wrong with the text and what would be right.
struct FaultParse {
  std::optional<WrittenFault> fault;
  std::string error;
};
FaultParse parse_fault(const FaultGrammar& grammar, std::string_view text);

/// What parse_fault() reads as the same.
std::string fault_text(const FaultGrammar& grammar, const WrittenFault& fault);

/// How faults are written, and a line for each kind.
std::string fault_help(const FaultGrammar& grammar);

}  // namespace canvoy
