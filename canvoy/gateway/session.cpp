#include "canvoy/gateway/session.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/gateway/gateway.hpp"

namespace canvoy::gateway {

namespace {

constexpr std::size_t command_size_min = 64;

}  // namespace

bool Session::Pending::is_node_command() const {
  return scope_of(operation.request.command) == Scope::node &&
         is_node_id(operation.request.node.value_or(0));
}

std::size_t Session::Pending::held_bytes() const {
  const Request& request = operation.request;
  return sizeof *this + request.value.size() + request.numbers.size() * sizeof(std::uint64_t) +
         operation.received().size() + (operation.answer ? operation.answer->text.size() : 0);
}

Session::Session(Gateway& gateway, const SessionSettings& settings)
    : gateway_(gateway),
      settings_(settings),
      reader_(settings.command_size),
      budget_(settings.held_bytes_max) {}

Session::~Session() {
  for (const auto& pending : pending_) {
    if (pending->begun) pending->network->abandon(pending->operation);
  }
}

void Session::end_input() {
  if (reader_.size() != 0) reader_.append("\n");
}

bool Session::may_read() const {
  return pending_.size() < settings_.pending_max && output_.size() < settings_.output_max;
}

bool Session::may_emit() const {
  return !pending_.empty() && pending_.front()->operation.answer &&
         output_.size() < settings_.output_max;
}

bool Session::is_busy() const {
  return std::ranges::any_of(pending_,
                             [](const auto& pending) { return !pending->operation.answer; });
}

std::size_t Session::held_bytes() const {
  std::size_t bytes = reader_.size() + output_.size();
  for (const auto& pending : pending_) bytes += pending->held_bytes();
  return bytes;
}

bool Session::is_ready() const {
  return may_emit() || (may_read() && reader_.has_line());
}

void Session::settle(Time now) {
  bool goes_on = true;
  while (goes_on) {
    goes_on = read_lines();
    goes_on = begin_ready(now) || goes_on;
    goes_on = expire(now) || goes_on;
    goes_on = emit() || goes_on;
  }
}

bool Session::read_lines() {
  bool any = false;
  while (may_read()) {
    const std::optional<Line> line = reader_.next();
    if (!line) break;
    take(*line);
    any = true;
  }
  return any;
}

void Session::take(const Line& line) {
  Parsed parsed = parse_request(line.text);
  if (line.too_long) parsed.error = ErrorCode::out_of_memory;
  if (parsed.error == ErrorCode::none && parsed.request.command == Command::none) return;
  Network* network = nullptr;
  std::optional<Answer> answer = parsed.error == ErrorCode::none ? prepare(parsed.request, network)
                                                                 : Answer::failed(parsed.error);
  auto pending = std::make_unique<Pending>(parsed.sequence, std::move(parsed.request), budget_);
  pending->network = network;
  pending->operation.answer = std::move(answer);
  pending_.push_back(std::move(pending));
}

/// A command for the session alone is carried out and answered at once, so that it applies to the
/// next line.
std::optional<Answer> Session::prepare(Request& request, Network*& network) {
  const ErrorCode wrong = complete(request, network);
  return wrong == ErrorCode::none ? set_up(request) : Answer::failed(wrong);
}

std::optional<Answer> Session::set_up(const Request& request) {
  const std::uint64_t number = request.numbers.empty() ? 0 : request.numbers.front();
  switch (request.command) {
    case Command::set_network:
      if (gateway_.find(static_cast<std::uint32_t>(number)) == nullptr) {
        return Answer::failed(ErrorCode::unknown_net);
      }
      default_net_ = static_cast<std::uint32_t>(number);
      return Answer::ok();
    case Command::set_node:
      if (!is_node_id(static_cast<unsigned>(number))) {
        return Answer::failed(ErrorCode::unknown_node);
      }
      default_node_ = static_cast<std::uint32_t>(number);
      return Answer::ok();
    case Command::set_command_timeout:
      command_time_out_ = std::chrono::milliseconds(number);
      return Answer::ok();
    case Command::set_command_size:
      if (number < command_size_min || number > settings_.command_size_max) {
        return Answer::failed(ErrorCode::out_of_memory);
      }
      reader_.set_length_max(number);
      return Answer::ok();
    case Command::boot_up_indication:
      if (number != 0) {
        without_boot_up_.erase(*request.net);
      } else {
        without_boot_up_.insert(*request.net);
      }
      return Answer::ok();
    default:
      return std::nullopt;
  }
}

/// Fills in the defaults, and finds the network.
ErrorCode Session::complete(Request& request, Network*& network) const {
  const Scope scope = scope_of(request.command);
  if (scope == Scope::gateway) return ErrorCode::none;
  if (!request.net) request.net = default_net_;
  if (!request.net) request.net = gateway_.only_network();
  if (!request.net) return ErrorCode::no_default_net;
  network = gateway_.find(*request.net);
  if (network == nullptr) return ErrorCode::unknown_net;
  if (scope != Scope::node) return ErrorCode::none;
  if (!request.node) request.node = default_node_;
  return request.node ? ErrorCode::none : ErrorCode::no_default_node;
}

bool Session::begin_ready(Time now) {
  bool any = false;
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    Pending& pending = *pending_[i];
    if (pending.begun || pending.operation.answer || !may_begin(i)) continue;
    check_invariant(pending.network != nullptr);
    pending.begun = true;
    if (command_time_out_) pending.until = now + *command_time_out_;
    pending.network->begin(pending.operation, now);
    any = true;
  }
  return any;
}

/// A command waits for earlier ones for the same node; one for a whole network waits for, and holds
/// up, all of that network.
bool Session::may_begin(std::size_t position) const {
  const Pending& pending = *pending_[position];
  return std::all_of(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(position),
                     [&](const auto& earlier) {
                       if (earlier->operation.answer || earlier->network != pending.network)
                         return true;
                       return pending.is_node_command() && earlier->is_node_command() &&
                              earlier->operation.request.node != pending.operation.request.node;
                     });
}

bool Session::expire(Time now) {
  bool any = false;
  for (const auto& pending : pending_) {
    if (!pending->begun || pending->operation.answer || pending->until > now) continue;
    pending->network->cancel(pending->operation, now);
    pending->operation.answer = Answer::failed(ErrorCode::time_out);
    any = true;
  }
  return any;
}

bool Session::emit() {
  bool any = false;
  while (may_emit()) {
    const Answer& answer = *pending_.front()->operation.answer;
    output_ += answer_line(pending_.front()->sequence, answer, settings_.style);
    if (!answer.good()) ++failures_;
    pending_.pop_front();
    any = true;
  }
  return any;
}

Time Session::deadline() const {
  Time earliest = never;
  for (const auto& pending : pending_) {
    if (pending->begun && !pending->operation.answer) {
      earliest = std::min(earliest, pending->until);
    }
  }
  return earliest;
}

void Session::tell(const Event& event) {
  if (too_slow_) return;
  if (event.kind == Event::Kind::boot_up && without_boot_up_.contains(event.net)) return;
  const std::string line = event_line(event, settings_.style);
  event_bytes_ += line.size();
  too_slow_ = event_bytes_ > settings_.event_bytes_max;
  if (!too_slow_) output_ += line;
}

void Session::consume(std::size_t size) {
  check_invariant(size <= output_.size());
  output_.erase(0, size);
  if (output_.empty()) event_bytes_ = 0;
}

}  // namespace canvoy::gateway
