#include "canvoy/canopen/sdo/sdo_queue.hpp"

#include <algorithm>
#include <tuple>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

std::size_t SdoRequest::transferred() const {
  if (place.client != nullptr) return place.client->transferred();
  return place.outcome ? *place.outcome : 0;
}

std::optional<std::uint32_t> SdoRequest::announced() const {
  return place.client == nullptr ? std::nullopt : place.client->announced();
}

constexpr ServiceHandlers SdoQueue::service_calls = {.tx_ready = method<&SdoQueue::start_waiting>};

SdoQueue::SdoQueue(Node& node, std::span<Worker> workers) : node_(node), workers_(workers) {
  node_.attach(service_);
  for (Worker& worker : workers_) worker.queue_ = this;
}

/// Link to the first request to a server, or the one at the end.
SdoRequest** SdoQueue::first_of(NodeId server) {
  SdoRequest** link = &first_;
  while (*link != nullptr && (*link)->server != server) link = &(*link)->place.next;
  return link;
}

bool SdoQueue::add(SdoRequest& request, bool is_download) {
  if (is_refusing_) return false;
  if (request.place.state != SdoRequest::State::idle || !is_node_id(request.server)) return false;
  request.place.is_download = is_download;
  request.place.outcome = SdoEnd::cancelled(AbortCode::no_data);
  request.place.state = SdoRequest::State::waiting;
  append(request);
  start_waiting();
  return true;
}

void SdoQueue::append(SdoRequest& request) {
  check_invariant(request.place.next == nullptr);
  SdoRequest** link = first_of(request.server);
  while (*link != nullptr) link = &(*link)->place.behind;
  *link = &request;
}

/// The next request to the same server waits for its turn after those to others.
void SdoQueue::remove(SdoRequest& request) {
  SdoRequest** link = first_of(request.server);
  if (*link == &request) {
    *link = std::exchange(request.place.next, nullptr);
    SdoRequest* next = std::exchange(request.place.behind, nullptr);
    if (next != nullptr) append(*next);
  } else {
    while (*link != &request) link = &(*link)->place.behind;
    *link = std::exchange(request.place.behind, nullptr);
  }
  request.place.state = SdoRequest::State::idle;
  request.place.client = nullptr;
}

/// On some buses an answer comes at once, and `done` may queue: nested calls leave the work to the
/// outer loop.
void SdoQueue::start_waiting() {
  if (std::exchange(is_starting_, true)) return;
  while (start_one()) {
  }
  is_starting_ = false;
}

/// True if there was a request to start, with success or without.
bool SdoQueue::start_one() {
  if (!node_.transmitter().idle()) return false;
  const auto worker =
      std::ranges::find_if(workers_, [](const Worker& candidate) { return candidate.is_free(); });
  if (worker == workers_.end()) return false;
  SdoRequest* request = first_;
  while (request != nullptr && request->place.state != SdoRequest::State::waiting) {
    request = request->place.next;
  }
  if (request == nullptr) return false;
  request->place.state = SdoRequest::State::active;
  request->place.client = &worker->client_;
  worker->request_ = request;
  const AbortCode answer = start(*worker, *request);
  if (answer != AbortCode::none) {
    worker->request_ = nullptr;
    is_refusing_ = true;
    finish(*request, answer);
    is_refusing_ = false;
  }
  return true;
}

AbortCode SdoQueue::start(Worker& worker, SdoRequest& request) {
  SdoClient& client = worker.client_;
  const auto done = SdoClient::Done::to<&Worker::finished>(worker);
  const auto& [server, index, sub] = std::tie(request.server, request.index, request.sub);
  client.choose(request.transfer);
  if (request.place.is_download) {
    return request.supply
               ? client.download(server, index, sub, request.supply, request.size, done,
                                 request.time_out)
               : client.download(server, index, sub, request.value, done, request.time_out);
  }
  return request.sink
             ? client.upload(server, index, sub, request.sink, done, request.time_out)
             : client.upload(server, index, sub, request.destination, done, request.time_out);
}

void SdoQueue::finished(Worker& worker, SdoClient::Outcome outcome) {
  SdoRequest* const request = std::exchange(worker.request_, nullptr);
  if (request != nullptr) finish(*request, outcome);
  start_waiting();
}

/// Nothing of the request is used after the callback: its memory may be gone.
void SdoQueue::finish(SdoRequest& request, SdoClient::Outcome outcome) {
  check_invariant(request.place.state == SdoRequest::State::active);
  remove(request);
  request.place.outcome = outcome;
  const SdoRequest::Done done = request.done;
  done(request);
}

void SdoQueue::cancel(SdoRequest& request) {
  if (request.place.state == SdoRequest::State::idle) return;
  for (Worker& worker : workers_) {
    if (worker.request_ != &request) continue;
    worker.request_ = nullptr;
    // If its last message is being handed over, the worker is free after that.
    if (worker.client_.state_ != SdoClient::State::ending) worker.client_.cancel();
  }
  remove(request);
  start_waiting();
}

}  // namespace canvoy
