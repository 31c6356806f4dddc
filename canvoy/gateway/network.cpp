#include "canvoy/gateway/network.hpp"

#include <cstdio>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::gateway {

namespace {

/// After a reset a node waits in pre-operational.
constexpr NmtState state_after(NmtCommand command) {
  switch (command) {
    case NmtCommand::start:
      return NmtState::operational;
    case NmtCommand::stop:
      return NmtState::stopped;
    case NmtCommand::enter_pre_operational:
    case NmtCommand::reset_node:
    case NmtCommand::reset_communication:
      break;
  }
  return NmtState::pre_operational;
}

}  // namespace

Supervision::Supervision(GatewayDevice& device, Report report)
    : device_(device), report_(std::move(report)), guarding_(device.node(), slots_) {
  device_.heartbeat_consumer().on_change(callback<&Supervision::heartbeat_changed>(*this));
  guarding_.on_event(callback<&Supervision::guarding_event>(*this));
}

Answer Supervision::watch_heartbeat(std::uint32_t node, Duration time) {
  if (!is_node_id(node)) return Answer::failed(ErrorCode::unknown_node);
  heard_[node] = false;
  // A node that is already monitored is reported again: its earlier state is discarded first.
  set_time(node, Duration::zero());
  const AbortCode refused = set_time(node, time);
  return refused == AbortCode::none ? Answer::ok() : Answer::failed(refused);
}

AbortCode Supervision::set_time(std::uint32_t node, Duration time) {
  std::array<std::uint8_t, 4> value{};
  store(value.data(), static_cast<std::uint32_t>(node << 16 | time / 1ms));
  return device_.dictionary().write(object_index::heartbeat_consumers,
                                    static_cast<std::uint8_t>(node), value, Source::application);
}

Answer Supervision::guard(std::uint32_t node, Duration guard_time, std::uint8_t life_time_factor) {
  const auto id = static_cast<NodeId>(node);
  if (!is_node_id(node) || id == device_.node().id()) {
    return Answer::failed(ErrorCode::unknown_node);
  }
  if (guard_time == Duration::zero() || life_time_factor == 0) {
    guarding_.release(id);
    return Answer::ok();
  }
  const bool guarded = guarding_.guard(id, guard_time, life_time_factor);
  return guarded ? Answer::ok() : Answer::failed(ErrorCode::internal_state);
}

void Supervision::commanded(NodeId node, NmtCommand command) {
  const NodeId first = node == 0 ? node_id_min : node;
  const NodeId last = node == 0 ? node_id_max : node;
  for (unsigned id = first; id <= last; ++id) {
    guarding_.expect(static_cast<NodeId>(id), state_after(command));
  }
}

void Supervision::heartbeat_changed(NodeId node, RemoteState state) {
  if (state == RemoteState::boot_up) return;
  const bool comes = state != RemoteState::lost;
  if (comes && !heard_[node]) report_(node, ErrorCode::heartbeat_started);
  if (!comes) report_(node, ErrorCode::heartbeat_lost);
  heard_[node] = comes;
}

void Supervision::guarding_event(NodeId node, NodeGuardingEvent event, bool occurs) {
  if (!occurs) return;
  report_(node, event == NodeGuardingEvent::time_out ? ErrorCode::guarding_lost
                                                     : ErrorCode::wrong_nmt_state);
}

namespace {

/// Class 3: NMT master. Then the editions of CiA 309, and the version of this gateway.
constexpr const char* version_3_0 = "3 3.0 0.1";
constexpr const char* version_2_1 = "3 2.1 0.1";

constexpr unsigned reserved_bit_rate = 5;

std::optional<NmtCommand> nmt_command(Command command) {
  switch (command) {
    case Command::start:
      return NmtCommand::start;
    case Command::stop:
      return NmtCommand::stop;
    case Command::preoperational:
      return NmtCommand::enter_pre_operational;
    case Command::reset_node:
      return NmtCommand::reset_node;
    case Command::reset_communication:
      return NmtCommand::reset_communication;
    default:
      return std::nullopt;
  }
}

Duration milliseconds(const Request& request) {
  return std::chrono::milliseconds(request.numbers.at(0));
}

AbortCode write_number(Dictionary& dictionary, std::uint16_t index, std::uint8_t sub,
                       std::uint64_t number) {
  const canvoy::Result<Entry> entry = dictionary.find(index, sub);
  if (!entry) return entry.abort();
  std::array<std::uint8_t, 8> bytes{};
  store(bytes.data(), number);
  return dictionary.write(*entry, std::span(bytes).first(entry->row->capacity),
                          Source::application);
}

Answer answer_of(AbortCode outcome) {
  return outcome == AbortCode::none ? Answer::ok() : Answer::failed(outcome);
}

/// CiA 309-3 has no code for the warning limit.
ErrorCode reported_of(BusState state) {
  if (state == BusState::bus_off) return ErrorCode::bus_off;
  return is_error_active(state) ? ErrorCode::can_active : ErrorCode::error_passive;
}

}  // namespace

Network::Core::Core(Network& network, const Port& port)
    : device(port, network.settings_.node_id, true),
      sdo(device.node(), network.settings_.version),
      pdo(device, network.number_,
          [&network](std::uint16_t number, std::vector<std::uint64_t> values) {
            network.emit(Event::of(network.number_, number, std::move(values)));
          }),
      supervision(device,
                  [&network](NodeId node, ErrorCode error) { network.report(node, error); }),
      lss(device.node()) {}

Network::Network(std::uint16_t number, const Port& port, NetworkSettings settings)
    : number_(number),
      // No filter: events are reported for all nodes.
      port_{port.context, port.send, nullptr},
      settings_(std::move(settings)),
      pending_id_(settings_.node_id),
      core_(std::make_unique<Core>(*this, port_)) {}

void Network::start(Time now) {
  node().start(now);
}

void Network::receive(const Frame& frame, Time now) {
  observe(frame);
  node().receive(frame, now);
  progress(now);
}

void Network::progress(Time now) {
  core_->lss.go_on();
  watch_connection();
  if (progress_) progress_(now);
}

/// Reports the life guarding event of the gateway's own node: its master is lost.
void Network::watch_connection() {
  const bool lost = core_->device.node_guarding().is_master_lost();
  if (lost && !connection_lost_) report(node().id(), ErrorCode::connection_lost);
  connection_lost_ = lost;
}

void Network::overrun(Time now) {
  node().overrun(now);
  report(0, ErrorCode::buffer_overflow);
  progress(now);
}

void Network::advance(Time now) {
  node().advance(now);
  progress(now);
}

void Network::tx_ready(Time now) {
  node().tx_ready(now);
  progress(now);
}

void Network::bus_state(BusState state, Time now) {
  const ErrorCode before = reported_of(node().bus_state());
  node().bus_state(state, now);
  if (reported_of(state) != before) report(0, reported_of(state));
  progress(now);
}

/// Takes emergency and boot-up messages of all nodes, also while the gateway has no node-ID.
void Network::observe(const Frame& frame) {
  if (!frame.is_plain()) return;
  const std::uint32_t function = frame.id & ~0x7FU;
  const auto node = static_cast<NodeId>(frame.id & 0x7F);
  if (node == 0) return;
  if (function == can_id::emergency && frame.length == Emergency::length) {
    emit(Event::of(number_, node, decode_emergency(frame)));
  } else if (function == can_id::error_control && frame.length == 1 && frame.data[0] == 0) {
    emit(Event::boot_up(number_, node));
  }
}

void Network::begin(Operation& operation, Time now) {
  node().advance(now);
  std::optional<Answer> answer = execute(operation);
  if (answer) operation.answer = std::move(answer);
}

void Network::cancel(Operation& operation, Time now) {
  node().advance(now);
  abandon(operation);
}

void Network::abandon(Operation& operation) {
  if (operation.answer) return;
  if (core_->sdo.cancel(operation) || core_->pdo.cancel(operation)) return;
  core_->lss.cancel(operation);
}

std::optional<Answer> Network::execute(Operation& operation) {
  const Request& request = operation.request;
  const std::uint32_t addressed = request.node.value_or(0);
  Supervision& supervision = core_->supervision;
  if (const auto nmt = nmt_command(request.command)) return command(*nmt, request);
  switch (request.command) {
    case Command::read:
    case Command::write:
      return access(operation);
    case Command::set_sdo_timeout:
      sdo_time_out_ = milliseconds(request);
      return Answer::ok();
    case Command::set_sdo_block:
      core_->sdo.use_blocks(request.numbers.at(0) != 0);
      return Answer::ok();
    case Command::set_rpdo:
      return core_->pdo.set(PdoDirection::receive,
                            static_cast<std::uint16_t>(request.numbers.at(0)), request.pdo);
    case Command::set_tpdo:
      return core_->pdo.set(PdoDirection::transmit,
                            static_cast<std::uint16_t>(request.numbers.at(0)), request.pdo);
    case Command::read_pdo:
      core_->pdo.begin_read(operation, sdo_time_out_);
      return std::nullopt;
    case Command::write_pdo:
      return core_->pdo.write(static_cast<std::uint16_t>(request.numbers.at(0)),
                              std::span(request.numbers).subspan(1));
    case Command::enable_guarding:
      return supervision.guard(addressed, milliseconds(request),
                               static_cast<std::uint8_t>(request.numbers.at(1)));
    case Command::disable_guarding:
      return supervision.guard(addressed, Duration::zero(), 0);
    case Command::enable_heartbeat:
      return supervision.watch_heartbeat(addressed, milliseconds(request));
    case Command::disable_heartbeat:
      return supervision.watch_heartbeat(addressed, Duration::zero());
    case Command::init:
      return initialise(request);
    case Command::set_heartbeat:
      return produce_heartbeat(milliseconds(request));
    case Command::set_id:
      return set_id(request);
    case Command::info_version:
      return version();
    default:
      if (core_->lss.begin(operation)) return std::nullopt;
      return Answer::failed(ErrorCode::not_supported);
  }
}

std::optional<Answer> Network::access(Operation& operation) {
  const std::uint32_t server = operation.request.node.value_or(0);
  if (!is_node_id(server)) return Answer::failed(ErrorCode::unknown_node);
  if (server == node().id()) return access_own(operation);
  core_->sdo.begin(operation, sdo_time_out_);
  return std::nullopt;
}

/// A node cannot send requests to itself.
Answer Network::access_own(Operation& operation) {
  const Request& request = operation.request;
  Dictionary& dictionary = node().dictionary();
  const canvoy::Result<Entry> entry = dictionary.find_for_bus(request.index, request.sub);
  if (!entry) return Answer::failed(entry.abort());
  if (request.command == Command::write) {
    return answer_of(dictionary.write(*entry, request.value, Source::sdo));
  }
  const auto value = dictionary.read(*entry);
  AbortCode outcome = value.abort();
  if (outcome == AbortCode::none) outcome = operation.receive(*value);
  return sdo_answer(operation, outcome, settings_.version);
}

/// The gateway obeys a command to itself, but not to all nodes: after `stop` it could not receive,
/// and after a reset it would have no PDOs.
Answer Network::command(NmtCommand command, const Request& request) {
  const auto addressed = static_cast<NodeId>(request.node.value_or(0));
  const Frame frame =
      Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(command), addressed});
  if (!node().transmitter().send(frame)) return Answer::failed(ErrorCode::internal_state);
  core_->supervision.commanded(addressed, command);
  if (addressed == node().id()) node().command(command);
  return Answer::ok();
}

Answer Network::produce_heartbeat(Duration period) {
  if (!is_node_id(node().id())) return Answer::failed(ErrorCode::internal_state);
  return answer_of(write_number(node().dictionary(), object_index::heartbeat_producer, 0,
                                static_cast<std::uint64_t>(period / 1ms)));
}

Answer Network::set_id(const Request& request) {
  const auto id = static_cast<NodeId>(request.numbers.at(0));
  if (!is_node_id(id) && id != node_id_unconfigured) return Answer::failed(ErrorCode::unknown_node);
  pending_id_ = id;
  return Answer::ok();
}

/// As at power-on, with the node-ID of `set id`.
Answer Network::initialise(const Request& request) {
  const auto bit_rate = static_cast<unsigned>(request.numbers.at(0));
  if (bit_rate == reserved_bit_rate) return Answer::failed(ErrorCode::syntax);
  if (settings_.set_bit_rate && !settings_.set_bit_rate(bit_rate)) {
    return Answer::failed(ErrorCode::can_init);
  }
  const Time now = node().now();
  core_->sdo.fail_all(Answer::failed(ErrorCode::internal_state));
  core_->pdo.fail_all(Answer::failed(ErrorCode::internal_state));
  core_->lss.fail_all(Answer::failed(ErrorCode::internal_state));
  settings_.node_id = pending_id_;
  sdo_time_out_ = SdoClient::default_time_out;
  core_ = std::make_unique<Core>(*this, port_);
  node().start(now);
  return Answer::ok();
}

/// Vendor, product, revision, serial number; class; editions of CiA 309-3 and of this gateway.
Answer Network::version() const {
  const Dictionary& dictionary = core_->device.node().dictionary();
  const auto number = [&](std::uint8_t sub) {
    return static_cast<unsigned>(dictionary.number(object_index::identity, sub));
  };
  const unsigned revision = number(3);
  char text[96];
  std::snprintf(text, sizeof text, "%u %u %u.%u %u %s", number(1), number(2), revision >> 16,
                revision & 0xFFFF, number(4),
                settings_.version == Version::v3_0 ? version_3_0 : version_2_1);
  return Answer::value(text);
}

}  // namespace canvoy::gateway
