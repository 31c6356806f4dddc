#include "canvoy/gateway/lss_access.hpp"

#include <cstdio>
#include <utility>

namespace canvoy::gateway {

namespace {

bool is_lss(Command command) {
  return command >= Command::lss_switch_global && command <= Command::lss_fastscan;
}

/// Error for a slave's refusal: code 1 means that the requested value is not supported.
ErrorCode refusal(Command command, std::uint8_t code) {
  if (command == Command::lss_store && code == LssError::store_failed) return ErrorCode::lss_media;
  if (code != LssError::out_of_range) return ErrorCode::lss;
  switch (command) {
    case Command::lss_set_node:
      return ErrorCode::lss_node_id;
    case Command::lss_configure_bit_rate:
      return ErrorCode::lss_bit_rate;
    case Command::lss_store:
      return ErrorCode::lss_storing;
    default:
      return ErrorCode::lss;
  }
}

Answer failure(Command command, const LssMaster::Reply& reply) {
  if (reply.outcome == LssMaster::Outcome::time_out) return Answer::failed(ErrorCode::time_out);
  return Answer::failed(refusal(command, reply.error.code));
}

std::string hexadecimal(std::uint32_t number) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", number);
  return text;
}

LssAddress address_of(const std::vector<std::uint64_t>& numbers) {
  LssAddress address;
  for (std::size_t i = 0; i < address.parts.size(); ++i) {
    address.parts[i] = static_cast<std::uint32_t>(numbers.at(i));
  }
  return address;
}

/// Vendor-ID, product code, lowest and highest revision, lowest and highest serial number.
LssRange range_of(const std::vector<std::uint64_t>& numbers) {
  const auto part = [&](std::size_t position) {
    return static_cast<std::uint32_t>(numbers.at(position));
  };
  return {{{part(0), part(1), part(2), part(4)}}, {{part(0), part(1), part(3), part(5)}}};
}

/// Four pairs of number and mask, with masks of all or no bits. Nothing for another mask.
std::optional<LssPattern> pattern_of(const std::vector<std::uint64_t>& numbers) {
  LssPattern pattern;
  if (numbers.size() != 2 * pattern.known.size()) return pattern;
  for (std::size_t i = 0; i < pattern.known.size(); ++i) {
    const std::uint64_t mask = numbers[2 * i + 1];
    if (mask != 0 && mask != UINT32_MAX) return std::nullopt;
    pattern.known[i] = mask != 0;
    pattern.address.parts[i] = static_cast<std::uint32_t>(numbers[2 * i]);
  }
  return pattern;
}

}  // namespace

bool LssAccess::begin(Operation& operation) {
  if (!is_lss(operation.request.command)) return false;
  waiting_.push_back(&operation);
  if (current_ == nullptr) go_on();
  return true;
}

void LssAccess::go_on() {
  while (current_ == nullptr && !waiting_.empty()) {
    current_ = waiting_.front();
    waiting_.pop_front();
    if (!start()) finish(Answer::failed(ErrorCode::internal_state));
  }
}

/// False if the message could not be sent. The operation may be answered at once.
bool LssAccess::start() {
  const auto& numbers = current_->request.numbers;
  const auto done = LssMaster::Done::to<&LssAccess::replied>(*this);
  switch (current_->request.command) {
    case Command::lss_switch_global:
      return answer_at_once(master_.switch_global(static_cast<LssState>(numbers.at(0))));
    case Command::lss_activate_bit_rate:
      return answer_at_once(master_.activate_bit_timing(std::chrono::milliseconds(numbers.at(0))));
    case Command::lss_switch_selective:
      return master_.select(address_of(numbers), done);
    case Command::lss_set_node:
      return configure_node_id();
    case Command::lss_configure_bit_rate:
      return master_.configure_bit_timing(static_cast<std::uint8_t>(numbers.at(1)), done,
                                          static_cast<std::uint8_t>(numbers.at(0)));
    case Command::lss_store:
      return master_.store(done);
    case Command::lss_inquire_address:
      parts_.clear();
      part_ = numbers.empty() ? 0 : static_cast<std::size_t>(numbers.front());
      return inquire();
    case Command::lss_get_node:
      return master_.inquire_node_id(done);
    case Command::lss_identity:
      return master_.identify(range_of(numbers), done);
    case Command::lss_identify_unconfigured:
      return master_.identify_unconfigured(done);
    default:
      return find();
  }
}

bool LssAccess::answer_at_once(bool sent) {
  if (sent) finish(Answer::ok());
  return sent;
}

bool LssAccess::configure_node_id() {
  const auto id = static_cast<NodeId>(current_->request.numbers.at(0));
  if (!is_node_id(id) && id != node_id_unconfigured) {
    finish(Answer::failed(ErrorCode::lss_node_id));
    return true;
  }
  return master_.configure_node_id(id, LssMaster::Done::to<&LssAccess::replied>(*this));
}

bool LssAccess::inquire() {
  return master_.inquire(part_, LssMaster::Done::to<&LssAccess::inquired>(*this));
}

/// The time-out is that of the first answer; Fastscan measures the others itself.
bool LssAccess::find() {
  const auto& numbers = current_->request.numbers;
  const std::optional<LssPattern> pattern = pattern_of(numbers);
  if (!pattern) {
    finish(Answer::failed(ErrorCode::not_supported));
    return true;
  }
  LssFastscan::Options options;
  if (numbers.size() == 1) options.first_time_out = std::chrono::milliseconds(numbers.front());
  fastscan_.emplace(node_, master_, options);
  return fastscan_->find(*pattern, LssFastscan::Done::to<&LssAccess::found>(*this));
}

void LssAccess::replied(const LssMaster::Reply& reply) {
  const Command command = current_->request.command;
  if (!reply.ok()) return finish(failure(command, reply));
  finish(command == Command::lss_get_node ? Answer::value(std::to_string(reply.value))
                                          : Answer::ok());
}

void LssAccess::inquired(const LssMaster::Reply& reply) {
  if (!reply.ok()) return finish(failure(current_->request.command, reply));
  if (!parts_.empty()) parts_ += ' ';
  parts_ += hexadecimal(reply.value);
  const bool all_are_wanted = current_->request.numbers.empty();
  if (!all_are_wanted || ++part_ == LssAddress{}.parts.size()) {
    return finish(Answer::value(parts_));
  }
  if (!inquire()) finish(Answer::failed(ErrorCode::internal_state));
}

void LssAccess::found(const LssFastscan::Result& result) {
  if (result.outcome == LssFastscan::Outcome::nobody) {
    return finish(Answer::failed(ErrorCode::time_out));
  }
  if (result.outcome == LssFastscan::Outcome::lost) return finish(Answer::failed(ErrorCode::lss));
  std::string text;
  for (const std::uint32_t part : result.address.parts) {
    text += (text.empty() ? "" : " ") + hexadecimal(part);
  }
  finish(Answer::value(text));
}

void LssAccess::finish(const Answer& answer) {
  std::exchange(current_, nullptr)->answer = answer;
}

bool LssAccess::cancel(Operation& operation) {
  if (current_ == &operation) {
    if (fastscan_) fastscan_->cancel();
    master_.cancel();
    current_ = nullptr;
    go_on();
    return true;
  }
  return std::erase(waiting_, &operation) != 0;
}

void LssAccess::fail_all(const Answer& answer) {
  for (Operation* operation : std::exchange(waiting_, {})) operation->answer = answer;
  if (current_ == nullptr) return;
  if (fastscan_) fastscan_->cancel();
  master_.cancel();
  std::exchange(current_, nullptr)->answer = answer;
}

}  // namespace canvoy::gateway
