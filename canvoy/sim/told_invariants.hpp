// Reports each broken invariant of a world once, at the time when it breaks.
//
//     ToldInvariants<invariant_kinds> told;
//     told.report_broken(referee.verdicts(), [&](const Invariant& it) { note(InvariantBroken{it});
//     });
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace canvoy {

template <std::size_t kinds>
class ToldInvariants {
 public:
  /// Calls `tell` with each invariant that is broken now and was not before.
  template <class Invariants, class Tell>
  void report_broken(const Invariants& invariants, const Tell& tell) {
    for (const auto& invariant : invariants) {
      bool& is_told = is_told_.at(static_cast<std::size_t>(invariant.kind));
      if (!invariant.held && !std::exchange(is_told, true)) tell(invariant);
    }
  }

 private:
  std::array<bool, kinds> is_told_{};
};

}  // namespace canvoy
