#include "canvoy/tools/session/session.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/can/host/can_link.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/manager/program.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/session/log_source.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration progress_interval = 200ms;

/// A node writes its memory before it answers a download to these objects.
bool writes_memory(std::uint16_t index) {
  return index == object_index::store_parameters || index == object_index::restore_parameters ||
         index == program::data || index == program::control;
}

}  // namespace

host::BusAddress any_bus(std::string_view text) {
  if (is_log_source(text)) {
    throw UsageError(fmt::format(
        "'{}': {} can only be listened to (canvoy decode, monitor, plot), not asked or told "
        "anything: name a bus, as can0, udp:239.74.163.2:43113 or tcp:HOST:PORT/can0",
        text, text == "-" ? "what comes from a pipe" : "a log"));
  }
  host::Result<host::BusAddress> address = host::parse_bus_address(text);
  if (!address) throw UsageError(address.error().line());
  return *std::move(address);
}

host::BusAddress real_bus(std::string_view text) {
  host::BusAddress address = any_bus(text);
  if (address.kind == host::BusType::simulated) {
    throw UsageError("sim: a simulated bus lives in one process only; use can0 or udp:");
  }
  return address;
}

unsigned bit_rate_of(std::string_view bus, unsigned said) {
  constexpr unsigned kilo = 1000;
  if (said != 0) return said * kilo;
  if (bus.find(',') != std::string_view::npos) return 0;
  const host::BusAddress address = real_bus(bus);
  if (address.kind != host::BusType::socketcan) return 0;
  const auto link = host::read_can_link(address.interface);
  return link ? link->bit_rate : 0;
}

Session::Session(std::string_view bus, AnswerTime time_out)
    : time_out_(time_out),
      limit_(time_out.usual),
      loop_(value_or_throw(host::EventLoop::create())) {
  std::vector<host::BusAddress> addresses;
  for (std::string_view rest = bus; addresses.empty() || !rest.empty();) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    addresses.push_back(real_bus(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  bus_ = value_or_throw(host::open_bus(*loop_, addresses.front()));
  for (const host::BusAddress& other : std::span(addresses).subspan(1)) {
    others_.push_back(value_or_throw(host::open_bus(*loop_, other)));
  }
  for (host::HostBus* each : buses()) follow(*each);
  join();
  ok_or_throw(loop_->stop_on_signals());
}

void Session::follow(host::HostBus& bus) {
  bus.on_trouble([this](const host::Error& error) {
    loss_ = error.line();
    was_lost_ = true;
  });
  bus.on_state([this](BusState state, Time) {
    if (state == BusState::error_active) loss_.clear();
  });
}

Session::~Session() = default;

/// Starts the node on the bus that is used for sending.
void Session::join() {
  routes_ = {};
  backlog_ = {};
  attachment_ = std::make_unique<host::Attachment>(*loop_, *bus_);
  node_ = std::make_unique<Node>(
      no_dictionary, NodeMemory{.values = {}, .states = {}, .routes = routes_, .backlog = backlog_},
      attachment_->port(), node_id_unconfigured);
  client_ = std::make_unique<SdoClient>(*node_);
  client_->choose(SdoTransfer::segmented);
  blocks_ = std::make_unique<SdoBlockClient>(*client_, block_);
  attachment_->attach(*node_);
}

void Session::speak_on(const host::HostBus& bus) {
  const auto other = std::ranges::find(others_, &bus, &std::unique_ptr<host::HostBus>::get);
  if (other == others_.end()) return;
  blocks_.reset();
  client_.reset();
  node_.reset();
  attachment_.reset();
  bus_.swap(*other);
  join();
}

std::vector<host::HostBus*> Session::buses() {
  std::vector<host::HostBus*> all = {bus_.get()};
  for (const auto& other : others_) all.push_back(other.get());
  return all;
}

std::vector<std::uint8_t> Session::read(NodeId node, std::uint16_t index, std::uint8_t sub) {
  wait_done(node, index, sub, start_upload(node, index, sub));
  return read_;
}

Result<std::vector<std::uint8_t>> Session::try_read(NodeId node, std::uint16_t index,
                                                    std::uint8_t sub) {
  const SdoEnd end = wait(node, index, sub, start_upload(node, index, sub));
  if (!end) return end.abort();
  return read_;
}

AbortCode Session::start_upload(NodeId node, std::uint16_t index, std::uint8_t sub) {
  read_.clear();
  limit_ = time_out_.usual;
  const NodeId server = server_of(node);
  node_->advance(loop_->now());
  return client_->upload(server, index, sub, SdoClient::Sink::to<&Session::take>(*this),
                         SdoClient::Done::to<&Session::finished>(*this), limit_);
}

AbortCode Session::take(std::span<const std::uint8_t> bytes) {
  if (read_.size() + bytes.size() > value_max) return AbortCode::out_of_memory;
  read_.insert(read_.end(), bytes.begin(), bytes.end());
  return AbortCode::none;
}

void Session::write(NodeId node, std::uint16_t index, std::uint8_t sub,
                    std::span<const std::uint8_t> value) {
  // A request of now would wait for the bus to come back, and be carried out then.
  if (!loss_.empty() && bus_->state() == BusState::bus_off) throw Failure(loss_);
  const NodeId server = server_of(node);
  limit_ = writes_memory(index) ? time_out_.storing : time_out_.usual;
  node_->advance(loop_->now());
  wait_done(node, index, sub,
            client_->download(server, index, sub, value,
                              SdoClient::Done::to<&Session::finished>(*this), limit_));
}

std::string Session::node_text(NodeId node) const {
  const std::string text = text::node_text(node);
  return behind_.module == 0 ? text
                             : fmt::format("{} of network {}", text, behind_.settings.network);
}

/// The server for a request to `node`: for a node behind another, that other node, after an
/// indication.
NodeId Session::server_of(NodeId node) {
  const NodeId module = behind_.module;
  if (module == 0) return node;
  const sdo::Message indication =
      remote_indication(behind_.settings, behind_.settings.network, node);
  const SdoChannel channel = default_sdo_channel(module);
  const auto receiver = Router::Receiver::to<&Session::confirmed>(*this);
  confirmation_.reset();
  node_->router().add(channel.response, receiver);
  send(indication.frame(channel.request));
  const Time until = loop_->now() + time_out_.usual;
  while (!confirmation_ && loop_->signal() == 0 && loop_->now() < until) loop_->run_until(until);
  node_->router().remove(channel.response, receiver);
  if (loop_->signal() != 0) throw Failure("interrupted");
  if (confirmation_ == indication) return module;
  const bool is_abort = confirmation_ && confirmation_->response() == sdo::Response::abort;
  throw Failure(
      fmt::format("{}: {} {}", node_text(node), text::node_text(module),
                  is_abort ? "refuses: " + text::abort_text(confirmation_->abort_code())
                           : "does not answer: is it on the bus, and has it networks behind it?"));
}

void Session::confirmed(const Frame& frame, Time /*now*/) {
  if (frame.length != Frame::length_max) return;
  confirmation_ = sdo::Message(frame);
  loop_->stop();
}

void Session::wait_done(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started) {
  const SdoEnd end = wait(node, index, sub, started);
  if (end) return;
  throw Failure(fmt::format("{}, {}: {}", node_text(node), text::object_text(index, sub),
                            text::end_text(end)));
}

/// The end of a transfer, if the node answers at all.
SdoEnd Session::wait(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started) {
  end_ = started;
  if (started == AbortCode::none) run();
  if (loop_->signal() != 0) throw Failure("interrupted");
  if (!end_.is_silence()) {
    loss_.clear();
    return end_;
  }
  if (!loss_.empty()) throw Failure(loss_);
  throw Failure(fmt::format(
      "{}, {}: no answer within {}; is the node on {}, with power and this node-ID?",
      node_text(node), text::object_text(index, sub), text::duration_text(limit_), bus_->name()));
}

void Session::run() {
  if (!shows_progress_ || ::isatty(STDERR_FILENO) == 0) return loop_->run();
  bool shown = false;
  while (loop_->run_until(loop_->now() + progress_interval) == host::EventLoop::End::reached) {
    const auto announced = client_->announced();
    const std::string whole = announced ? fmt::format(" of {}", *announced) : std::string();
    fmt::print(stderr, "\r{}{} bytes", client_->transferred(), whole);
    std::fflush(stderr);
    shown = true;
  }
  if (shown) fmt::print(stderr, "\r\x1B[K");
}

void Session::finished(SdoClient::Outcome outcome) {
  end_ = outcome;
  loop_->stop();
}

void Session::hear(std::function<void(const host::BusFrame&)> hears) {
  hears_ = std::move(hears);
  if (std::exchange(is_hearing_, true)) return;
  bus_->on_frame([this](const host::BusFrame& heard) {
    if (hears_) hears_(heard);
  });
}

void Session::run_for(Duration duration) {
  loop_->run_until(loop_->now() + duration);
  if (loop_->signal() != 0) throw Failure("interrupted");
}

void Session::send(const Frame& frame) {
  const std::uint64_t sent = bus_->counters().sent;
  if (!bus_->send(frame)) throw Failure(fmt::format("{}: the frame was refused", bus_->name()));
  const Time until = loop_->now() + time_out_.usual;
  while (bus_->counters().sent == sent && loop_->now() < until) {
    loop_->run_until(std::min(until, loop_->now() + Duration(1ms)));
  }
  if (bus_->counters().sent == sent) {
    if (!loss_.empty()) throw Failure(loss_);
    throw Failure(fmt::format("{}: the frame did not get onto the bus; is it up?", bus_->name()));
  }
}

}  // namespace canvoy::tools
