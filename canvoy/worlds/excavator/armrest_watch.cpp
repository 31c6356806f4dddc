#include "canvoy/worlds/excavator/armrest_watch.hpp"

#include <utility>

#include "canvoy/worlds/excavator/host_objects.hpp"

namespace canvoy::excavator {

namespace {

constexpr Duration asks_each = 100ms;
constexpr Duration confirms_within = 90ms;
constexpr Duration answers_within = 150ms;
constexpr std::uint16_t contacts_index = 0x6000;
constexpr std::uint8_t contacts_sub = 1;

}  // namespace

void ArmrestWatch::begin() {
  stop();
  node_.timers().arm(ask_timer_, node_.now());
}

void ArmrestWatch::stop() {
  indication_.cancel();
  if (client_.busy()) client_.cancel();
  is_released_ = false;
  node_.timers().disarm(ask_timer_);
  node_.timers().disarm(lost_timer_);
}

void ArmrestWatch::ask(Time now) {
  node_.timers().arm(ask_timer_, now + asks_each);
  if (indication_.busy() || client_.busy()) return;
  asked_at_ = now;
  indication_.begin(seat_id, armrest_id,
                    RemoteIndication::Done::to<&ArmrestWatch::confirmed>(*this), confirms_within);
}

void ArmrestWatch::confirmed(SdoEnd outcome) {
  if (!outcome) return;  // a failed read is tried again
  client_.upload(seat_id, contacts_index, contacts_sub, buffer_,
                 SdoClient::Done::to<&ArmrestWatch::answered>(*this), answers_within);
}

void ArmrestWatch::answered(SdoClient::Outcome outcome) {
  if (!outcome) return;
  const bool was_there = is_there();
  const bool is_closed = (buffer_[0] & released_bits) == released_bits;
  const bool was_released = std::exchange(is_released_, is_closed);
  node_.timers().arm(lost_timer_, asked_at_ + consumer_time);
  if (!was_there || was_released != is_released_) changed_();
}

void ArmrestWatch::lost(Time /*now*/) {
  changed_();
}

}  // namespace canvoy::excavator
