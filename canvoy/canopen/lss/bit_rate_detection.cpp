#include "canvoy/canopen/lss/bit_rate_detection.hpp"

namespace canvoy {

namespace {

/// Pause after a bit rate that the controller does not support: it may support none of them.
constexpr Duration refusal_pause = 10ms;

}  // namespace

BitRateDetection::BitRateDetection(Restart restart) : BitRateDetection(restart, Options{}) {}

BitRateDetection::BitRateDetection(Restart restart, const Options& options)
    : restart_(restart), options_(options) {}

void BitRateDetection::start(Time now) {
  position_ = 0;
  rounds_ = 0;
  enter(options_.bit_rates.empty() ? State::failed : State::listening);
  if (state_ == State::listening) listen(now);
}

void BitRateDetection::enter(State state) {
  const bool was_listening = state_ == State::listening;
  state_ = state;
  if (was_listening != (state == State::listening)) under_way_(!was_listening);
}

void BitRateDetection::listen(Time now) {
  errors_ = 0;
  const bool listens = restart_(bit_rate(), true);
  until_ = now + (listens ? options_.dwell : refusal_pause);
}

void BitRateDetection::next(Time now) {
  if (++position_ == options_.bit_rates.size()) {
    position_ = 0;
    if (options_.rounds_max != 0 && ++rounds_ == options_.rounds_max) {
      enter(State::failed);
      return found_(0);
    }
  }
  listen(now);
}

void BitRateDetection::receive(const Frame& frame, Time now) {
  if (state_ != State::listening) return;
  if (frame.is_error()) return bus_error(now);
  // Before it takes part, further frames are ignored.
  state_ = State::found;
  const bool takes_part = restart_(bit_rate(), false);
  state_ = State::listening;
  if (!takes_part) return next(now);
  enter(State::found);
  found_(bit_rate());
}

void BitRateDetection::bus_error(Time now) {
  if (state_ == State::listening && ++errors_ >= options_.errors_max) next(now);
}

void BitRateDetection::advance(Time now) {
  if (state_ == State::listening && until_ <= now) next(now);
}

}  // namespace canvoy
