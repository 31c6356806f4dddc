#include "canvoy/devices/cia419/battery_link.hpp"

namespace canvoy::cia419 {

namespace {

std::uint16_t low_word(std::uint32_t answer) {
  return static_cast<std::uint16_t>(answer);
}

}  // namespace

/// Cheap ones first: a battery that does not answer these will not answer the others.
const std::array<BatteryLink::Question, 13> BatteryLink::questions = {{
    {0x1800, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[0].raw = answer; }},
    {0x1801, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[1].raw = answer; }},
    {0x1802, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[2].raw = answer; }},
    {0x1800, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[0] = low_word(answer);
     }},
    {0x1801, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[1] = low_word(answer);
     }},
    {0x1802, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[2] = low_word(answer);
     }},
    {0x1400, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[0].raw = answer; }},
    {0x1401, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[1].raw = answer; }},
    {0x1402, 1, [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[2].raw = answer; }},
    {0x1017, 0,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.heartbeat_ms = low_word(answer); }},
    {0x6052, 0,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.ampere_hours_returned = low_word(answer);
     }},
    {0x6020, 2,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.capacity_ampere_hours = low_word(answer);
     }},
    {0x6020, 3,
     [](BatteryOffer& offer,
        std::uint32_t answer) { offer.current_max_ampere = low_word(answer); }},
}};

BatteryLink::BatteryLink(Node& node) : client_(node) {}

void BatteryLink::ask(NodeId battery) {
  cancel();
  offer_ = {};
  offer_.id = battery;
  question_ = 0;
  next();
}

void BatteryLink::cancel() {
  client_.cancel();
  under_way_ = nullptr;
  question_ = questions.size();
}

void BatteryLink::next() {
  if (question_ == questions.size()) {
    answered_(offer_);
    return send_next_message();
  }
  const Question& question = questions[question_];
  buffer_ = {};
  const AbortCode refused =
      client_.upload(offer_.id, question.index, question.sub, std::span<std::uint8_t>(buffer_),
                     SdoClient::Done::to<&BatteryLink::answered>(*this));
  if (refused != AbortCode::none) failed_(refused);
}

void BatteryLink::answered(SdoClient::Outcome outcome) {
  const bool is_silent =
      outcome.abort() == AbortCode::time_out || outcome.abort() == AbortCode::device_state;
  if (!outcome && is_silent) return failed_(outcome.abort());
  if (outcome) questions[question_].take(offer_, load<std::uint32_t>(buffer_.data()));
  ++question_;
  next();
}

void BatteryLink::write_back(NodeId battery, std::uint16_t ampere_hours_returned) {
  tell(messages_[0], battery, ampere_hours_returned);
}

void BatteryLink::write_heartbeat(NodeId battery, std::uint16_t milliseconds) {
  tell(messages_[1], battery, milliseconds);
}

void BatteryLink::tell(Message& message, NodeId battery, std::uint16_t value) {
  message.battery = battery;
  message.value = value;
  message.tries_left = tries_max;
  send_next_message();
}

void BatteryLink::send_next_message() {
  if (client_.busy()) return;
  for (Message& message : messages_) {
    if (message.tries_left == 0) continue;
    --message.tries_left;
    under_way_ = &message;
    store(buffer_.data(), message.value);
    const AbortCode refused = client_.download(message.battery, message.index, 0,
                                               std::span<const std::uint8_t>(buffer_).first(2),
                                               SdoClient::Done::to<&BatteryLink::told>(*this));
    if (refused == AbortCode::none) return;
    under_way_ = nullptr;
  }
}

void BatteryLink::told(SdoClient::Outcome outcome) {
  // A battery that answered, even with a refusal, needs not be told again; nor one that was told a
  // newer value since.
  const bool is_known = outcome.abort() != AbortCode::time_out;
  if (under_way_ != nullptr && is_known &&
      load<std::uint16_t>(buffer_.data()) == under_way_->value) {
    under_way_->tries_left = 0;
  }
  under_way_ = nullptr;
  send_next_message();
}

}  // namespace canvoy::cia419
