// Conditions that must always hold in a simulated network, and by what margin they held. The types
// are common to all worlds; each world has its own kinds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace canvoy {

/// An invariant in the words of its world: a row. Its index is the number of the kind.
struct InvariantRow {
  std::string_view name;  ///< `no_endless_wait`
  std::string_view text;  ///< text before a measure: `longest wait`
  std::string_view unit;  ///< unit of the measure: `s`; empty: a count
  /// Source of the bound: a norm with its clause, `file` or `canvoy`.
  std::string_view bound = "canvoy";
};

inline constexpr std::size_t no_fault = ~std::size_t{0};  ///< of Invariant::fault: about none

template <class Kind>
struct Invariant {
  Kind kind{};                   ///< the row of this invariant
  std::uint8_t part = 0;         ///< part of the world: which lift; 0: all of it
  std::size_t fault = no_fault;  ///< index in the plan, if it is about one fault
  double worst = 0;              ///< in the unit of its row
  double allowed = 0;            ///< in the same unit; a greater value breaks it
  bool held = true;              ///< so far; true also where nothing was judged
  /// Number of judgements: trips, calls, messages; for a condition that must hold at all times,
  /// looks at it. What a fault excuses, and what cannot be seen, is not judged.
  std::uint64_t judged = 0;

  /// True if it was judged: otherwise nothing could have broken it.
  bool is_decided() const { return judged != 0; }
};

/// The row of a kind, by rows_of(Kind), which is found beside the kind.
template <class Kind>
constexpr const InvariantRow& invariant_name(Kind kind) {
  return rows_of(kind)[static_cast<std::size_t>(kind)];
}

}  // namespace canvoy
