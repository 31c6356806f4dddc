#include "canvoy/worlds/police/operator_hands.hpp"

namespace canvoy::police {

namespace {

constexpr Duration thought = 700ms;   ///< time before a hand moves
constexpr Duration reaction = 400ms;  ///< time from a title that is read, or a key, to the next key
constexpr Duration press_again = 3s;  ///< where a key has no effect
constexpr Duration open_again = 5s;   ///< where the client does not appear

}  // namespace

void Operator::begin(Time now) {
  phase_ = Phase::opening;
  typed_ = 0;
  is_pressed_ = false;
  acted_ = now;
  hands_.open(tasks_.front().client);
}

void Operator::step(Time now) {
  if (tasks_.empty()) {
    phase_ = Phase::idle;
    return;
  }
  const bool is_shown = hands_.title() == title_of(tasks_.front().client);
  switch (phase_) {
    case Phase::idle:
      acted_ = since_ = now;
      phase_ = Phase::thinking;
      return;
    case Phase::thinking:
      return now < acted_ + thought ? void() : begin(now);
    case Phase::opening:
      if (is_shown) {
        phase_ = Phase::typing;
        acted_ = now;
      } else if (now >= acted_ + open_again) {
        begin(now);
      }
      return;
    case Phase::typing:
      // The client has gone: start from the beginning.
      return is_shown ? type(now) : begin(now);
  }
}

void Operator::type(Time now) {
  const TerminalTask& task = tasks_.front();
  if (is_pressed_ && hands_.text().starts_with(task.answers.at(typed_))) {
    is_pressed_ = false;
    since_ = now;
    if (++typed_ == task.keys.size()) {
      tasks_.pop_front();
      phase_ = Phase::idle;
      ++done_;
      return;
    }
  }
  const Duration pause = is_pressed_ ? press_again : reaction;
  if (now < acted_ + pause) return;
  acted_ = now;
  is_pressed_ = true;
  hands_.press(task.client, task.keys.at(typed_));
}

}  // namespace canvoy::police
