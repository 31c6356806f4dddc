#include "canvoy/gateway/sdo_access.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::gateway {

Answer sdo_answer(const Operation& operation, AbortCode outcome, Version version) {
  if (operation.is_too_much()) return Answer::failed(ErrorCode::out_of_memory);
  if (outcome != AbortCode::none) return Answer::failed(outcome);
  if (operation.request.command == Command::write) return Answer::ok();
  auto text = value_text(operation.request.type, operation.received(), version);
  return text ? Answer::value(*std::move(text)) : Answer::failed(AbortCode::length);
}

void SdoAccess::begin(Operation& operation, Duration time_out) {
  auto& lane = lanes_.at(operation.request.node.value_or(0));
  if (!lane) lane = std::make_unique<Lane>(node_, version_);
  lane->add({&operation, time_out});
}

bool SdoAccess::cancel(Operation& operation) {
  const auto& lane = lanes_.at(operation.request.node.value_or(0));
  return lane && lane->cancel(operation);
}

void SdoAccess::fail_all(const Answer& answer) {
  for (const auto& lane : lanes_) {
    if (lane) lane->fail_all(answer);
  }
}

void SdoAccess::Lane::add(const Waiting& waiting) {
  waiting_.push_back(waiting);
  if (current_ == nullptr) begin_next();
}

void SdoAccess::Lane::begin_next() {
  while (current_ == nullptr && !waiting_.empty()) {
    const Waiting next = waiting_.front();
    waiting_.pop_front();
    current_ = next.operation;
    const AbortCode refused = begin(next);
    if (refused == AbortCode::none) continue;
    current_ = nullptr;
    // The gateway itself is stopped: no fault of the server.
    next.operation->answer = refused == AbortCode::device_state
                                 ? Answer::failed(ErrorCode::internal_state)
                                 : Answer::failed(refused);
  }
}

AbortCode SdoAccess::Lane::begin(const Waiting& waiting) {
  const Request& request = waiting.operation->request;
  const auto node = static_cast<NodeId>(request.node.value_or(0));
  const auto done = SdoClient::Done::to<&Lane::finished>(*this);
  if (request.command == Command::write) {
    return client_.download(node, request.index, request.sub, request.value, done,
                            waiting.time_out);
  }
  return client_.upload(node, request.index, request.sub,
                        SdoClient::Sink::to<&Lane::received>(*this), done, waiting.time_out);
}

AbortCode SdoAccess::Lane::received(std::span<const std::uint8_t> bytes) {
  return current_->receive(bytes);
}

void SdoAccess::Lane::finished(SdoClient::Outcome outcome) {
  Operation& operation = *std::exchange(current_, nullptr);
  operation.answer = sdo_answer(operation, outcome.abort(), version_);
  begin_next();
}

bool SdoAccess::Lane::cancel(Operation& operation) {
  if (current_ == &operation) {
    client_.cancel();
    current_ = nullptr;
    begin_next();
    return true;
  }
  return std::erase_if(waiting_, [&](const Waiting& waiting) {
           return waiting.operation == &operation;
         }) != 0;
}

void SdoAccess::Lane::fail_all(const Answer& answer) {
  for (const Waiting& waiting : std::exchange(waiting_, {})) waiting.operation->answer = answer;
  if (current_ == nullptr) return;
  client_.cancel();
  std::exchange(current_, nullptr)->answer = answer;
}

}  // namespace canvoy::gateway
