#include "canvoy/gateway/sdo_access.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::gateway {

Answer sdo_answer(const Operation& operation, AbortCode outcome, Version version) {
  if (operation.is_too_much()) return Answer::failed(ErrorCode::out_of_memory);
  if (outcome != AbortCode::none) return Answer::failed(outcome);
  if (operation.request.command == Command::write) return Answer::ok();
  auto text = value_text(operation.request.type, operation.received(), version);
  return text ? Answer::value(*std::move(text)) : Answer::failed(AbortCode::length);
}

void SdoAccess::begin(Operation& operation, Duration time_out) {
  jobs_.push_back(std::make_unique<Job>(Job{this, &operation}));
  Job& job = *jobs_.back();
  const Request& asked = operation.request;
  SdoRequest& request = job.request;
  request.server = static_cast<NodeId>(asked.node.value_or(0));
  request.index = asked.index;
  request.sub = asked.sub;
  request.transfer = transfer_;
  request.time_out = time_out;
  request.done = SdoRequest::Done::to<&Job::done>(job);
  // The job may be done, and destroyed, when these return.
  if (asked.command == Command::write) {
    request.value = asked.value;
    queue_.download(request);
  } else {
    request.sink = SdoClient::Sink::to<&Job::receive>(job);
    queue_.upload(request);
  }
}

bool SdoAccess::is_stopped() const {
  const NmtState state = node_.state();
  const bool speaks = state == NmtState::operational || state == NmtState::pre_operational;
  return is_node_id(node_.id()) && !speaks;
}

void SdoAccess::finished(Job& job) {
  const SdoEnd end = job.request.outcome();
  const bool is_own = !end && !end.is_refusal() && end.abort() == AbortCode::device_state;
  job.operation->answer = is_own && is_stopped()
                              ? Answer::failed(ErrorCode::internal_state)
                              : sdo_answer(*job.operation, end.abort(), version_);
  const std::size_t gone =
      std::erase_if(jobs_, [&](const auto& other) { return other.get() == &job; });
  check_invariant(gone == 1);
}

bool SdoAccess::cancel(Operation& operation) {
  const auto found =
      std::ranges::find_if(jobs_, [&](const auto& job) { return job->operation == &operation; });
  if (found == jobs_.end()) return false;
  // The queue continues with the next request, which may be done, and destroyed, at once.
  const std::unique_ptr<Job> job = std::move(*found);
  jobs_.erase(found);
  queue_.cancel(job->request);
  return true;
}

void SdoAccess::fail_all(const Answer& answer) {
  while (!jobs_.empty()) {
    Operation& operation = *jobs_.back()->operation;
    cancel(operation);
    operation.answer = answer;
  }
}

}  // namespace canvoy::gateway
