// Plays a behaviour case on the bench: prepares its PDOs, performs its steps, and reports the first
// unexpected result.
//
//     const Verdict verdict = play(bench, row);
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canvoy/text/check/behaviour/carrier.hpp"
#include "canvoy/text/check/behaviour/step.hpp"

namespace canvoy::conformance {

/// Not applicable if no block of the profile has what the case is about.
Verdict play(Bench& bench, const BehaviourRow& row);

/// Records what is heard during a case, and the PDOs that carry its entries.
class Stage {
 public:
  /// Listens for its whole lifetime.
  explicit Stage(Bench& bench);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Finds the PDO of each step and prepares it. Returns the reason if this fails.
  std::optional<Verdict> prepare(const BehaviourRow& row);
  /// Performs a step. Returns nothing if the result is as expected.
  std::optional<Verdict> act(const Step& step);

 private:
  Reply download(const Step& step);
  std::optional<Verdict> put(const Step& step);
  std::optional<Verdict> refuse(const Step& step);
  std::optional<Verdict> put_text(const Step& step, bool is_to_be_taken);
  std::optional<Verdict> wait_for_text(const Step& step);
  std::optional<Verdict> feed(const Step& step);
  std::optional<Verdict> lose();
  std::optional<Verdict> ask_hand(const Step& step);
  std::optional<Verdict> wait_until_it_is(const Step& step);
  std::optional<Verdict> watch_whether_it_stays(const Step& step);
  std::optional<Verdict> wait_for_pdo(const Step& step);
  std::optional<Verdict> wait_for_none(const Step& step);
  std::optional<Verdict> wait_for_alarm(const Step& step);
  std::optional<Verdict> wait_for_no_alarm(const Step& step);
  template <class Check>
  bool hears(Duration time, Check is_it);
  bool is_emergency(const Frame& frame) const;
  std::size_t length_of(const Place& place);
  const Carrier* carrier_of(const Place& place, PdoWay way) const;

  Bench& bench_;
  Player player_;
  std::vector<Carrier> carriers_;
  std::vector<Place> carried_;
  std::vector<Heard> heard_;  ///< since the last action
  std::uint32_t emergencies_ = 0;
};

}  // namespace canvoy::conformance
