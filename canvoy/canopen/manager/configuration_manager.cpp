#include "canvoy/canopen/manager/configuration_manager.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/manager/nmt_startup.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t restore_communication_sub = 2;
constexpr std::uint32_t restore_signature = 0x6461'6F6C;  // "load"

constexpr std::uint8_t date_sub = 1;
constexpr std::uint8_t time_sub = 2;

std::uint32_t expected(const Node& node, std::uint16_t index, NodeId slave) {
  return static_cast<std::uint32_t>(node.dictionary().number(index, slave));
}

}  // namespace

constexpr AccessHandlers ConfigurationManager::hook_calls = {
    .first = object_index::configure_slave,
    .last = object_index::configure_slave,
    .before_write = method<&ConfigurationManager::before_write>,
    .after_write = method<&ConfigurationManager::after_write>};
constexpr ServiceHandlers ConfigurationManager::service_calls = {
    .reset = method<&ConfigurationManager::reset>, .hooks = {&hook_calls, 1}};

ConfigurationManager::ConfigurationManager(Node& node, std::span<Worker> workers, Duration time_out)
    : node_(node),
      workers_(workers),
      time_out_(time_out),
      timer_(callback<&ConfigurationManager::begin_waiting>(*this)) {
  node_.attach(service_);
}

void ConfigurationManager::reset(ResetScope) {
  for (Worker& worker : workers_) {
    worker.drop();
    worker.parked_ = {};
  }
  node_.timers().disarm(timer_);
  wanted_.reset();
  started_.reset();
}

AbortCode ConfigurationManager::update(NodeId slave, When when) {
  if (!is_node_id(slave) || slave == node_.id()) return AbortCode::value_range;
  if (wanted_[slave]) return AbortCode::device_state;
  wanted_[slave] = true;
  always_[slave] = when == When::always;
  node_.timers().arm(timer_, node_.now());
  return AbortCode::none;
}

bool ConfigurationManager::has_configuration(NodeId slave) const {
  const Result<Entry> entry = node_.dictionary().find(object_index::concise_dcf, slave);
  if (!entry) return false;
  const Domain* domain = node_.dictionary().domain(*entry);
  if (domain == nullptr) return false;
  const Result<std::uint32_t> size = domain->open_read(*entry);
  return size && *size != 0;
}

AbortCode ConfigurationManager::before_write(const Entry& entry,
                                             std::span<const std::uint8_t> value) {
  if (entry.sub == 0) return AbortCode::none;
  if (load_unsigned(value) != signature) return AbortCode::cannot_store;
  if (entry.sub >= all_slaves) return AbortCode::none;
  if (entry.sub == node_.id()) return AbortCode::value_range;
  if (wanted_[entry.sub]) return AbortCode::device_state;
  return has_configuration(entry.sub) ? AbortCode::none : AbortCode::no_data;
}

void ConfigurationManager::after_write(const Entry& entry, Source) {
  if (entry.sub != 0 && entry.sub < all_slaves) update(entry.sub, When::always);
  if (entry.sub != all_slaves) return;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    if (has_configuration(slave)) update(slave, When::always);
  }
}

void ConfigurationManager::serve(BootHooks& hooks) {
  hooks.update_configuration = callback<&ConfigurationManager::boot>(*this);
  hooks.abandon = callback<&ConfigurationManager::abandon>(*this);
}

void ConfigurationManager::boot(const BootTask& task) {
  drop(task.slave);
  const auto place = std::ranges::find_if(
      workers_, [](const Worker& worker) { return worker.parked_.slave == 0; });
  if (place == workers_.end()) {
    return task.done({BootError::configuration, AbortCode::out_of_memory});
  }
  place->parked_ = task;
  wanted_[task.slave] = started_[task.slave] = true;
  node_.timers().arm(timer_, node_.now());
}

void ConfigurationManager::abandon(NodeId slave) {
  drop(slave);
  node_.timers().arm(timer_, node_.now());
}

void ConfigurationManager::drop(NodeId slave) {
  for (Worker& worker : workers_) {
    if (worker.slave_ == slave) worker.drop();
    if (worker.parked_.slave == slave) worker.parked_ = {};
  }
  wanted_[slave] = started_[slave] = false;
}

/// Slaves that the NMT master waits for come first.
void ConfigurationManager::begin_waiting(Time) {
  begin_parked();
  NodeId slave = node_id_min;
  for (Worker& worker : workers_) {
    if (!worker.idle()) continue;
    while (slave <= node_id_max && (!wanted_[slave] || started_[slave])) ++slave;
    if (slave > node_id_max) return;
    started_[slave] = true;
    worker.begin(*this, slave, always_[slave] ? When::always : When::different);
  }
}

void ConfigurationManager::begin_parked() {
  for (Worker& parking : workers_) {
    if (parking.parked_.slave == 0) continue;
    for (Worker& worker : workers_) {
      if (!worker.idle()) continue;
      worker.begin(*this, std::exchange(parking.parked_, {}));
      break;
    }
  }
}

void ConfigurationManager::finished(Worker& worker, const ConfigurationOutcome& outcome) {
  const NodeId slave = worker.slave_;
  wanted_[slave] = started_[slave] = false;
  const bool is_told = node_.state() != NmtState::initialisation;
  const bool is_of_boot = worker.task_.slave != 0;
  if (!is_told || !is_of_boot) {
    worker.slave_ = 0;
    worker.task_ = {};
  }
  if (!is_told) return;
  node_.timers().arm(timer_, node_.now());
  // Called before the boot-up continues, which may start the slave at once.
  done_(slave, outcome);
  // The callback may abandon the slave, or have the node reset: then its boot ends.
  if (!is_of_boot || worker.slave_ != slave) return;
  worker.slave_ = 0;
  const BootTask task = std::exchange(worker.task_, {});
  const bool failed = outcome.kind == ConfigurationOutcome::Kind::failed;
  task.done(failed ? BootOutcome{BootError::configuration, outcome.end} : BootOutcome{});
}

void ConfigurationManager::Worker::begin(ConfigurationManager& manager, NodeId slave, When when) {
  manager_ = &manager;
  slave_ = slave;
  client_ = &own_client_;
  begin(when);
}

void ConfigurationManager::Worker::begin(ConfigurationManager& manager, const BootTask& task) {
  manager_ = &manager;
  slave_ = task.slave;
  client_ = task.client;
  task_ = task;
  begin(When::different);
}

void ConfigurationManager::Worker::begin(When when) {
  written_ = 0;
  has_verification_ = true;
  expected_date_ = expected(node_, object_index::expected_configuration_date, slave_);
  expected_time_ = expected(node_, object_index::expected_configuration_time, slave_);
  if (when == When::different && is_expected()) {
    read_verification<&Worker::date_read>(date_sub);
  } else {
    configure();
  }
}

void ConfigurationManager::Worker::drop() {
  slave_ = 0;
  task_ = {};
  download_.forget();
  own_client_.cancel();
}

template <auto step>
void ConfigurationManager::Worker::read_verification(std::uint8_t sub) {
  buffer_ = {};
  const AbortCode refused = client_->upload(slave_, object_index::verify_configuration, sub,
                                            std::span<std::uint8_t>(buffer_),
                                            SdoClient::Done::to<step>(*this), manager_->time_out_);
  if (refused != AbortCode::none) fail(refused, object_index::verify_configuration, sub);
}

template <auto step>
void ConfigurationManager::Worker::write_verification(std::uint8_t sub, std::uint32_t value) {
  store(buffer_.data(), value);
  const AbortCode refused = client_->download(
      slave_, object_index::verify_configuration, sub, std::span<const std::uint8_t>(buffer_),
      SdoClient::Done::to<step>(*this), manager_->time_out_);
  if (refused != AbortCode::none) fail(refused, object_index::verify_configuration, sub);
}

void ConfigurationManager::Worker::date_read(SdoClient::Outcome outcome) {
  has_verification_ = !is_absent(outcome);
  if (!has_verification_) return configure();
  if (!outcome) return fail(outcome, object_index::verify_configuration, date_sub);
  if (load<std::uint32_t>(buffer_.data()) != expected_date_) return configure();
  read_verification<&Worker::time_read>(time_sub);
}

void ConfigurationManager::Worker::time_read(SdoClient::Outcome outcome) {
  if (!outcome) return fail(outcome, object_index::verify_configuration, time_sub);
  if (load<std::uint32_t>(buffer_.data()) != expected_time_) return configure();
  finish({.kind = ConfigurationOutcome::Kind::up_to_date});
}

/// Restores the defaults first, if required and if the slave can be reset.
void ConfigurationManager::Worker::configure() {
  restore_sub_ = 0;
  if (task_.restart && slave_assignment(node_.dictionary(), slave_).is_restored()) {
    restore_sub_ = static_cast<std::uint8_t>(
        node_.dictionary().number(master_object::restore_configuration, slave_));
  }
  if (restore_sub_ == 0) return download();
  store(buffer_.data(), restore_signature);
  const AbortCode refused =
      client_->download(slave_, object_index::restore_parameters, restore_sub_,
                        std::span<const std::uint8_t>(buffer_),
                        SdoClient::Done::to<&Worker::restored>(*this), manager_->time_out_);
  if (refused != AbortCode::none) fail(refused, object_index::restore_parameters, restore_sub_);
}

void ConfigurationManager::Worker::restored(SdoClient::Outcome outcome) {
  if (!outcome) return fail(outcome, object_index::restore_parameters, restore_sub_);
  task_.restart(restore_sub_ == restore_communication_sub ? NmtCommand::reset_communication
                                                          : NmtCommand::reset_node,
                callback<&Worker::restarted>(*this));
}

void ConfigurationManager::Worker::restarted(AbortCode answer) {
  const SdoEnd end = answer == AbortCode::time_out ? SdoEnd::no_answer() : SdoEnd(answer);
  if (!end) return fail(end, object_index::restore_parameters, restore_sub_);
  download();
}

void ConfigurationManager::Worker::download() {
  ByteSource source;
  AbortCode answer = open_source(source);
  if (answer == AbortCode::none) {
    answer = download_.start(*client_, slave_, source,
                             ConfigurationDownload::Done::to<&Worker::downloaded>(*this),
                             manager_->time_out_);
  }
  if (answer == AbortCode::no_data && !is_expected()) {
    return finish({.kind = ConfigurationOutcome::Kind::nothing_known});
  }
  if (answer != AbortCode::none) fail(answer, 0, 0);
}

/// Opened twice, as a domain is read in ascending order only: the first time to check it.
AbortCode ConfigurationManager::Worker::open_source(ByteSource& source) {
  const Result<Entry> entry = node_.dictionary().find(object_index::concise_dcf, slave_);
  domain_ = entry ? node_.dictionary().domain(*entry) : nullptr;
  if (domain_ == nullptr || !domain_->open_read || !domain_->read) return AbortCode::no_data;
  entry_ = *entry;
  const Result<std::uint32_t> size = domain_->open_read(entry_);
  if (!size) return size.abort();
  if (*size == 0) return AbortCode::no_data;
  if (*size == Domain::size_unknown) return AbortCode::internal_incompatible;
  source.size = *size;
  source.read = callback<&Worker::read_source>(*this);
  return AbortCode::none;
}

/// Starts again from the beginning: after the check comes the download.
AbortCode ConfigurationManager::Worker::read_source(std::uint32_t offset,
                                                    std::span<std::uint8_t> bytes) {
  if (offset == 0) {
    const Result<std::uint32_t> size = domain_->open_read(entry_);
    if (!size) return size.abort();
  }
  const Result<std::size_t> size = domain_->read(entry_, offset, bytes);
  if (!size) return size.abort();
  return *size == bytes.size() ? AbortCode::none : AbortCode::length_too_low;
}

void ConfigurationManager::Worker::downloaded(const ConfigurationDownload::Outcome& outcome) {
  written_ = outcome.written;
  if (!outcome.end) return fail(outcome.end, outcome.index, outcome.sub);
  if (!is_expected() || !has_verification_) {
    return finish({.kind = ConfigurationOutcome::Kind::downloaded});
  }
  write_verification<&Worker::date_written>(date_sub, expected_date_);
}

void ConfigurationManager::Worker::date_written(SdoClient::Outcome outcome) {
  // If 1020h was not read before, its absence shows here.
  if (is_absent(outcome)) return finish({.kind = ConfigurationOutcome::Kind::downloaded});
  if (!outcome) return fail(outcome, object_index::verify_configuration, date_sub);
  write_verification<&Worker::time_written>(time_sub, expected_time_);
}

void ConfigurationManager::Worker::time_written(SdoClient::Outcome outcome) {
  if (!outcome) return fail(outcome, object_index::verify_configuration, time_sub);
  finish({.kind = ConfigurationOutcome::Kind::downloaded});
}

void ConfigurationManager::Worker::fail(SdoEnd end, std::uint16_t index, std::uint8_t sub) {
  finish({.kind = ConfigurationOutcome::Kind::failed, .end = end, .index = index, .sub = sub});
}

void ConfigurationManager::Worker::finish(ConfigurationOutcome outcome) {
  outcome.written = written_;
  manager_->finished(*this, outcome);
}

}  // namespace canvoy
