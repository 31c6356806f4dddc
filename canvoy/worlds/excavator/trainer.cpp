#include "canvoy/worlds/excavator/trainer.hpp"

namespace canvoy::excavator {

namespace {

constexpr Duration lesson_each = 3min;
constexpr Duration comes_to_rest_in = 1500ms;
constexpr Duration asks_for = 300ms;
constexpr Duration asks_again = 1s;
constexpr Duration stops_asking = 8s;
constexpr Duration moves_for = 2s;
/// Longer than an unwanted motion may last.
constexpr Duration pulls_for = 3s;
constexpr double slew_place = 0.3;
constexpr double pull_place = 0.5;

}  // namespace

void Trainer::enter(Time now, Step step) {
  step_ = step;
  since_ = now;
}

void Trainer::step(Time now) {
  const std::uint64_t before = own_.hand_changes() + panel_.hand_changes();
  act(now, now - since_);
  if (own_.hand_changes() + panel_.hand_changes() != before) moved_();
}

bool Trainer::has_asked(SeatPanel& seat, std::size_t number, Duration passed) {
  const bool is_shown = panel_.commanding_seat() == number;
  seat.ask_for_command(!is_shown && passed % asks_again < asks_for);
  return is_shown;
}

void Trainer::act(Time now, Duration passed) {
  const bool is_over = passed >= moves_for;
  switch (step_) {
    case Step::waits:
      if (passed < lesson_each || !driver_.is_working()) return;
      driver_.hold_back(0);
      return enter(now, Step::comes_to_rest);
    case Step::comes_to_rest:
      if (passed >= comes_to_rest_in && panel_.is_at_rest()) enter(now, Step::takes);
      return;
    case Step::takes:
      if (has_asked(own_, 1, passed)) return enter(now, Step::slews);
      if (passed >= stops_asking) enter(now, Step::gives);
      return;
    case Step::slews:
      own_.move_stick(Stick::left_x, is_over ? 0 : slew_place);
      if (is_over) enter(now, Step::looks_on);
      return;
    case Step::looks_on:
      driver_.hold_back(passed < pulls_for ? pull_place : 0);
      if (passed >= pulls_for) enter(now, Step::slews_back);
      return;
    case Step::slews_back:
      own_.move_stick(Stick::left_x, is_over ? 0 : -slew_place);
      if (is_over) enter(now, Step::rests);
      return;
    case Step::rests:
      if (passed >= comes_to_rest_in) enter(now, Step::gives);
      return;
    case Step::gives:
      own_.ask_for_command(false);
      if (!has_asked(panel_, 0, passed) && passed < stops_asking) return;
      if (passed < stops_asking) ++lessons_;
      panel_.ask_for_command(false);
      driver_.hold_back(std::nullopt);
      return enter(now, Step::waits);
  }
}

}  // namespace canvoy::excavator
