// What must hold in a simulated network, whatever happens, and by how much it did: the same in all
// worlds, of which each has its own kinds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace canvoy {

/// An invariant in the words of its world: a row, whose place is the number of the kind.
struct InvariantRow {
  std::string_view name;  ///< `no_endless_wait`
  std::string_view text;  ///< in front of a measure: `longest wait`
  std::string_view unit;  ///< of the measure: `s`; empty: a count
  /// Whose the bound is: a norm with its clause, `file` or `canvoy`; empty: not told.
  std::string_view bound{};
};

inline constexpr std::size_t no_fault = ~std::size_t{0};

template <class Kind>
struct Invariant {
  Kind kind{};                   ///< the row that it is
  std::uint8_t part = 0;         ///< of the world: which lift; 0: all of it
  std::size_t fault = no_fault;  ///< of those about one: its place in the plan
  double worst = 0;              ///< in the unit of its row
  double allowed = 0;            ///< the same; beyond it is broken
  bool held = true;              ///< so far, also where nothing was judged
  /// How often it was: trips, calls, messages; of what must be so at all times, looks at it. What a
  /// fault excuses, and what cannot be seen, is not judged.
  std::uint64_t judged = 0;

  /// Nothing could have broken it where not.
  bool is_decided() const { return judged != 0; }
};

/// Of the world of a kind, whose rows_of(Kind) is found beside it.
template <class Kind>
constexpr const InvariantRow& invariant_name(Kind kind) {
  return rows_of(kind)[static_cast<std::size_t>(kind)];
}

}  // namespace canvoy
