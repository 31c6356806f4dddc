#include "canvoy/tools/player/sdo_requests.hpp"

#include <utility>

namespace canvoy::tools {

namespace {

/// A client has no entries of its own.
constexpr DictionaryTables nothing{};

}  // namespace

SdoRequests::SdoRequests(const Port& port)
    : node_(nothing, NodeMemory{.values = {}, .states = {}, .routes = routes_, .backlog = backlog_},
            port, node_id_unconfigured),
      client_(node_) {
  client_.choose(SdoTransfer::segmented);
}

void SdoRequests::read(NodeId server, std::uint16_t index, std::uint8_t sub, Done done) {
  add({.server = server, .index = index, .sub = sub, .value = {}, .done = std::move(done)});
}

void SdoRequests::write(NodeId server, std::uint16_t index, std::uint8_t sub, Bytes value,
                        Done done) {
  add({.server = server,
       .index = index,
       .sub = sub,
       .writes = true,
       .value = std::move(value),
       .done = std::move(done)});
}

void SdoRequests::add(Request request) {
  if (waiting_.size() == waiting_max) return request.done({.end = AbortCode::out_of_memory});
  waiting_.push_back(std::move(request));
  if (waiting_.size() == 1) start_next();
}

void SdoRequests::start_next() {
  while (!waiting_.empty()) {
    read_.clear();
    const AbortCode refused = start(waiting_.front());
    if (refused == AbortCode::none) return;
    const Done done = std::move(waiting_.front().done);
    waiting_.pop_front();
    done({.end = refused});
  }
}

AbortCode SdoRequests::start(const Request& request) {
  const auto done = SdoClient::Done::to<&SdoRequests::finished>(*this);
  if (request.writes) {
    return client_.download(request.server, request.index, request.sub, request.value, done);
  }
  return client_.upload(request.server, request.index, request.sub,
                        SdoClient::Sink::to<&SdoRequests::take>(*this), done);
}

AbortCode SdoRequests::take(std::span<const std::uint8_t> bytes) {
  if (read_.size() + bytes.size() > value_max) return AbortCode::out_of_memory;
  read_.insert(read_.end(), bytes.begin(), bytes.end());
  return AbortCode::none;
}

void SdoRequests::finished(SdoClient::Outcome outcome) {
  Answer answer{.end = outcome};
  if (outcome) answer.bytes = std::move(read_);
  const Done done = std::move(waiting_.front().done);
  waiting_.pop_front();
  done(answer);
  start_next();
}

}  // namespace canvoy::tools
