#include "canvoy/devices/cia419/battery_link.hpp"

namespace canvoy::cia419 {

namespace {

std::uint16_t low_word(std::uint32_t answer) {
  return static_cast<std::uint16_t>(answer);
}

/// A word with a valid value.
std::optional<std::uint16_t> said(std::uint32_t answer) {
  const std::uint16_t word = low_word(answer);
  return word != 0 && word != 0xFFFF ? std::optional(word) : std::nullopt;
}

/// A battery that answers, even with a refusal, is present.
bool is_silent(SdoOutcome outcome) {
  return outcome.is_silence() || outcome.kind() == SdoEnd::Kind::cancelled;
}

/// What one end sends, the other receives.
std::uint16_t mapping_of_battery(std::size_t mapping) {
  return static_cast<std::uint16_t>(
      mapping < BatteryOffer::pdos ? object_index::tpdo_mapping + mapping
                                   : object_index::rpdo_mapping + mapping - BatteryOffer::pdos);
}
std::uint16_t mapping_of_charger(std::size_t mapping) {
  return static_cast<std::uint16_t>(
      mapping < BatteryOffer::pdos ? object_index::rpdo_mapping + mapping
                                   : object_index::tpdo_mapping + mapping - BatteryOffer::pdos);
}

}  // namespace

/// Cheap ones first: a battery that does not answer these does not answer the others.
const std::array<BatteryLink::Question, 14> BatteryLink::questions = {{
    {object_index::tpdo_parameter, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[0].raw = answer; }},
    {object_index::tpdo_parameter + 1, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[1].raw = answer; }},
    {object_index::tpdo_parameter + 2, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.tpdo[2].raw = answer; }},
    {object_index::tpdo_parameter, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[0] = low_word(answer);
     }},
    {object_index::tpdo_parameter + 1, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[1] = low_word(answer);
     }},
    {object_index::tpdo_parameter + 2, 5,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.tpdo_event_timer_ms[2] = low_word(answer);
     }},
    {object_index::rpdo_parameter, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[0].raw = answer; }},
    {object_index::rpdo_parameter + 1, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[1].raw = answer; }},
    {object_index::rpdo_parameter + 2, 1,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.rpdo[2].raw = answer; }},
    {object_index::heartbeat_producer, 0,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.heartbeat_ms = low_word(answer); }},
    {0x6052, 0,
     [](BatteryOffer& offer, std::uint32_t answer) {
       offer.ampere_hours_returned = low_word(answer);
     }},
    {0x6020, 2,
     [](BatteryOffer& offer,
        std::uint32_t answer) { offer.capacity_ampere_hours = low_word(answer); }},
    {0x6020, 3,
     [](BatteryOffer& offer, std::uint32_t answer) { offer.current_max_ampere = said(answer); }},
    {0x6020, 4, [](BatteryOffer& offer, std::uint32_t answer) { offer.cells = said(answer); }},
}};

BatteryLink::BatteryLink(Node& node) : node_(node), default_client_(node) {}

void BatteryLink::ask(NodeId battery) {
  cancel();
  offer_ = {};
  offer_.id = battery;
  question_ = mapping_ = mapping_sub_ = 0;
  for (Message& message : messages_) message.is_known = false;
  next();
}

void BatteryLink::cancel() {
  client_->cancel();
  under_way_ = nullptr;
}

void BatteryLink::forget() {
  cancel();
  for (Message& message : messages_) message.tries_left = 0;
}

void BatteryLink::next() {
  if (question_ == questions.size()) return compare_mappings();
  const Question& question = questions[question_];
  ask_for(question.index, question.sub, SdoClient::Done::to<&BatteryLink::answered>(*this));
}

void BatteryLink::ask_for(std::uint16_t index, std::uint8_t sub, SdoClient::Done done) {
  buffer_ = {};
  const AbortCode refused =
      client_->upload(offer_.id, index, sub, std::span<std::uint8_t>(buffer_), done);
  if (refused != AbortCode::none) failed_();
}

void BatteryLink::answered(SdoClient::Outcome outcome) {
  if (is_silent(outcome)) return failed_();
  if (outcome) questions[question_].take(offer_, load<std::uint32_t>(buffer_.data()));
  ++question_;
  next();
}

/// Entry by entry, while they are equal. A battery that does not show its mapping is trusted.
void BatteryLink::compare_mappings() {
  while (mapping_ < mappings && !is_linkable(mapping_)) ++mapping_;
  if (mapping_ == mappings) {
    answered_(offer_);
    return send_next_message();
  }
  ask_for(mapping_of_battery(mapping_), mapping_sub_,
          SdoClient::Done::to<&BatteryLink::mapping_answered>(*this));
}

bool BatteryLink::is_linkable(std::size_t mapping) const {
  const bool is_tpdo = mapping < BatteryOffer::pdos;
  const std::size_t position = mapping % BatteryOffer::pdos;
  const CobId offered = is_tpdo ? offer_.tpdo[position] : offer_.rpdo[position];
  return offered.valid() && node_.dictionary().find(mapping_of_charger(mapping), 0);
}

void BatteryLink::mapping_answered(SdoClient::Outcome outcome) {
  if (is_silent(outcome)) return failed_();
  const std::uint16_t own = mapping_of_charger(mapping_);
  const bool is_alike =
      load<std::uint32_t>(buffer_.data()) == node_.dictionary().number(own, mapping_sub_);
  if (outcome && !is_alike) note_misfit(mapping_);
  const bool was_last = mapping_sub_ == node_.dictionary().number(own, 0);
  if (!outcome || !is_alike || was_last) {
    ++mapping_;
    mapping_sub_ = 0;
  } else {
    ++mapping_sub_;
  }
  compare_mappings();
}

void BatteryLink::note_misfit(std::size_t mapping) {
  const bool is_tpdo = mapping < BatteryOffer::pdos;
  (is_tpdo ? offer_.misfit_tpdos : offer_.misfit_rpdos)[mapping % BatteryOffer::pdos] = true;
}

void BatteryLink::write_back(NodeId battery, std::uint16_t ampere_hours_returned) {
  const Message& last = messages_[0];
  const bool is_same = last.battery == battery && last.value == ampere_hours_returned;
  if (is_same && (last.is_known || last.tries_left != 0)) return;
  tell(messages_[0], battery, ampere_hours_returned);
}

void BatteryLink::write_heartbeat(NodeId battery, std::uint16_t milliseconds) {
  tell(messages_[1], battery, milliseconds);
}

void BatteryLink::tell(Message& message, NodeId battery, std::uint16_t value) {
  message.battery = battery;
  message.value = value;
  message.tries_left = tries_max;
  message.is_known = false;
  send_next_message();
}

void BatteryLink::send_next_message() {
  if (client_->busy()) return;
  for (Message& message : messages_) {
    if (message.tries_left == 0) continue;
    --message.tries_left;
    under_way_ = &message;
    store(buffer_.data(), message.value);
    if (send(message) == AbortCode::none) return;
  }
}

/// If the connection was removed, the default channel remains.
AbortCode BatteryLink::send(const Message& message) {
  const auto value = std::span<const std::uint8_t>(buffer_).first(2);
  const auto done = SdoClient::Done::to<&BatteryLink::told>(*this);
  const AbortCode refused = client_->download(message.battery, message.index, 0, value, done);
  if (refused != AbortCode::no_sdo_connection || client_ == &default_client_) return refused;
  use(nullptr);
  return client_->download(message.battery, message.index, 0, value, done);
}

void BatteryLink::told(SdoClient::Outcome outcome) {
  // A value is not written again to a battery that has answered, even with a refusal, or that has
  // received a newer value.
  if (under_way_ != nullptr && !is_silent(outcome) &&
      load<std::uint16_t>(buffer_.data()) == under_way_->value) {
    under_way_->tries_left = 0;
    under_way_->is_known = true;
  }
  send_next_message();
}

}  // namespace canvoy::cia419
