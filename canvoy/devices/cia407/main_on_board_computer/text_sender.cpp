#include "canvoy/devices/cia407/main_on_board_computer/text_sender.hpp"

#include <algorithm>

namespace canvoy::cia407 {

TextSender::TextSender(Node& node) : workers_(node), queue_(node, workers_.all()) {}

bool TextSender::send(NodeId server, std::uint16_t index, std::uint8_t sub,
                      std::span<const std::uint8_t> octets) {
  Job* const job = free_job();
  if (octets.size() > size_max || job == nullptr) return false;
  std::ranges::copy(octets, job->octets.begin());
  job->tries = 1;
  job->is_read = false;
  job->request.server = server;
  job->request.index = index;
  job->request.sub = sub;
  job->request.value = std::span(job->octets).first(octets.size());
  job->request.done = SdoRequest::Done::to<&TextSender::done>(*this);
  return queue_.download(job->request);
}

bool TextSender::send(NodeId server, std::uint16_t index, std::uint8_t sub, std::uint32_t number) {
  std::uint8_t bytes[4];
  store(bytes, number);
  return send(server, index, sub, std::span<const std::uint8_t>(bytes));
}

bool TextSender::read(NodeId server, std::uint16_t index, std::uint8_t sub) {
  Job* const job = free_job();
  if (job == nullptr) return false;
  job->tries = 1;
  job->is_read = true;
  job->octets = {};
  job->request.server = server;
  job->request.index = index;
  job->request.sub = sub;
  job->request.destination = std::span(job->octets).first<sizeof(std::uint32_t)>();
  job->request.done = SdoRequest::Done::to<&TextSender::done>(*this);
  return queue_.upload(job->request);
}

void TextSender::done(SdoRequest& request) {
  const auto job = std::ranges::find_if(
      jobs_, [&request](const Job& each) { return &each.request == &request; });
  const bool has_arrived = static_cast<bool>(request.outcome());
  const bool may_try_again = !has_arrived && request.outcome().is_silence();
  if (may_try_again && job->tries++ < tries_max) {
    if (job->is_read ? queue_.upload(request) : queue_.download(request)) return;
  }
  finish(*job, has_arrived);
}

void TextSender::finish(const Job& job, bool has_arrived) {
  const NodeId server = job.request.server;
  if (job.is_read) {
    const auto number = load<std::uint32_t>(job.octets.data());
    if (read_) read_(server, has_arrived ? std::optional(number) : std::nullopt);
    return;
  }
  ++(has_arrived ? delivered_ : failed_);
  if (done_) done_(server, has_arrived);
}

TextSender::Job* TextSender::free_job() {
  const auto job = std::ranges::find_if(
      jobs_, [](const Job& each) { return each.request.state() == SdoRequest::State::idle; });
  return job == jobs_.end() ? nullptr : &*job;
}

}  // namespace canvoy::cia407
