// A set of the controllers of a bus, as two machine words.
//
//     ControllerSet waiting;  waiting.insert(3);
//     waiting.for_each([&](ControllerId id) { ... });
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace canvoy {

/// A controller on a bus, numbered from 0 in the order of attachment, which is also its position
/// along the cable.
using ControllerId = std::uint8_t;

/// Result of attach() if the bus is full.
inline constexpr ControllerId no_controller = 0xFF;

/// A set, as a value type; the order of for_each() is the order of the numbers.
class ControllerSet {
 public:
  static constexpr std::size_t capacity = 128;  ///< 127 nodes and a tool

  /// Adds a controller, 0 to 127.
  constexpr void insert(ControllerId id) { words_[id / 64U] |= bit(id); }
  /// Removes a controller, 0 to 127.
  constexpr void erase(ControllerId id) { words_[id / 64U] &= ~bit(id); }
  /// Adds or removes a controller.
  constexpr void assign(ControllerId id, bool member) { member ? insert(id) : erase(id); }
  /// Removes all.
  constexpr void clear() { words_ = {}; }

  /// True if a controller, 0 to 127, is a member.
  constexpr bool contains(ControllerId id) const { return (words_[id / 64U] & bit(id)) != 0; }
  constexpr bool empty() const { return (words_[0] | words_[1]) == 0; }
  /// True for two members or more.
  constexpr bool has_several() const {
    const std::uint64_t without_first =
        words_[0] != 0 ? (words_[0] & (words_[0] - 1)) | words_[1] : words_[1] & (words_[1] - 1);
    return without_first != 0;
  }
  /// Lowest member; no_controller if the set is empty.
  constexpr ControllerId first() const {
    if (words_[0] != 0) return static_cast<ControllerId>(std::countr_zero(words_[0]));
    if (words_[1] != 0) return static_cast<ControllerId>(64 + std::countr_zero(words_[1]));
    return no_controller;
  }

  /// Calls `visit(ControllerId)` for each member. The set may be changed meanwhile: a copy is
  /// visited.
  template <typename Visit>
  constexpr void for_each(Visit&& visit) const {
    visit_word(words_[0], 0, visit);
    visit_word(words_[1], 64, visit);
  }

  friend constexpr ControllerSet operator&(ControllerSet a, const ControllerSet& b) {
    a.words_[0] &= b.words_[0];
    a.words_[1] &= b.words_[1];
    return a;
  }
  friend constexpr ControllerSet operator|(ControllerSet a, const ControllerSet& b) {
    a.words_[0] |= b.words_[0];
    a.words_[1] |= b.words_[1];
    return a;
  }
  /// Members of `a` that are not in `b`.
  friend constexpr ControllerSet operator-(ControllerSet a, const ControllerSet& b) {
    a.words_[0] &= ~b.words_[0];
    a.words_[1] &= ~b.words_[1];
    return a;
  }
  friend constexpr bool operator==(const ControllerSet&, const ControllerSet&) = default;

 private:
  static constexpr std::uint64_t bit(ControllerId id) { return std::uint64_t{1} << (id % 64U); }

  template <typename Visit>
  static constexpr void visit_word(std::uint64_t rest, unsigned first, Visit& visit) {
    for (; rest != 0; rest &= rest - 1) {
      visit(static_cast<ControllerId>(first + static_cast<unsigned>(std::countr_zero(rest))));
    }
  }

  std::array<std::uint64_t, 2> words_{};
};

}  // namespace canvoy
