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

void TextSender::done(SdoRequest& request) {
  if (request.outcome()) {
    ++delivered_;
    if (done_) done_(request.server, true);
    return;
  }
  const auto job = std::ranges::find_if(
      jobs_, [&request](const Job& each) { return &each.request == &request; });
  const bool may_try_again = request.outcome().is_silence();
  if (may_try_again && job->tries++ < tries_max && queue_.download(request)) return;
  ++failed_;
  if (done_) done_(request.server, false);
}

TextSender::Job* TextSender::free_job() {
  const auto job = std::ranges::find_if(
      jobs_, [](const Job& each) { return each.request.state() == SdoRequest::State::idle; });
  return job == jobs_.end() ? nullptr : &*job;
}

}  // namespace canvoy::cia407
