#include "canvoy/canopen/storage/storage.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/canopen/storage/crc32.hpp"

namespace canvoy {

namespace {

/// "save" and "load", the first character in the lowest byte.
constexpr std::uint32_t save_signature = 0x6576'6173;
constexpr std::uint32_t load_signature = 0x6461'6F6C;
/// Value of 1010h and 1011h when read: the device stores and restores on command.
constexpr std::uint32_t on_command = 1;

constexpr std::uint32_t parameter_record = 0x5043'4F43;  ///< "COCP"

Error refused(RecordState state) {
  return {.code = emergency_code::data_set,
          .instance = object_index::store_parameters,
          .info = {static_cast<std::uint8_t>(state)}};
}

bool is_reached(std::uint16_t index, ResetScope scope) {
  return scope == ResetScope::node ||
         (index >= object_index::communication_first && index <= object_index::communication_last);
}

}  // namespace

constexpr AccessHandlers Storage::hook_calls = {.first = object_index::store_parameters,
                                                .last = object_index::restore_parameters,
                                                .before_write = method<&Storage::before_write>};
constexpr ServiceHandlers Storage::service_calls = {
    .state_entered = method<&Storage::state_entered>, .hooks = {&hook_calls, 1}};

Storage::Storage(Node& node, const Flash& flash, const Settings& settings)
    : node_(node),
      settings_(settings),
      record_(flash, {settings.address, settings.slot_size, parameter_record}),
      set_(node.dictionary(), record_, settings_.groups),
      timer_(callback<&Storage::step>(*this)) {
  former_ = node_.on_defaults_restored(callback<&Storage::defaults_restored>(*this));
  node_.attach(service_);
}

void Storage::defaults_restored(ResetScope scope) {
  former_(scope);
  if (busy()) finish(AbortCode::device_state);
  sign();
  state_ = record_.find();
  if (usable()) state_ = load(scope);
}

/// Identifies a kind of device: its type, vendor and product.
void Storage::sign() {
  const Dictionary& dictionary = node_.dictionary();
  std::uint8_t kind[12];
  canvoy::store(kind, static_cast<std::uint32_t>(dictionary.number(object_index::device_type, 0)));
  canvoy::store(kind + 4, static_cast<std::uint32_t>(dictionary.number(object_index::identity, 1)));
  canvoy::store(kind + 8, static_cast<std::uint32_t>(dictionary.number(object_index::identity, 2)));
  record_.sign(crc32(kind), parameter_signature(dictionary));
}

bool Storage::usable() const {
  return state_ == RecordState::valid ||
         (state_ == RecordState::outdated && settings_.keep_what_fits);
}

/// All of the set is checked before its first value is used. If the flash fails to answer
/// afterwards, defaults apply again: a part of a set is none.
RecordState Storage::load(ResetScope scope) {
  StoredHead head;
  StoredWalk check(record_);
  while (check.next(head)) {
    if (!settings_.keep_what_fits && !fits(head, node_.dictionary())) return RecordState::damaged;
  }
  if (!check.is_whole()) return RecordState::damaged;
  StoredWalk walk(record_);
  bool is_read = true;
  while (is_read && walk.next(head)) {
    const bool is_used = is_reached(head.index, scope) && fits(head, node_.dictionary());
    is_read = !is_used || take(head, walk.value());
  }
  if (is_read && walk.is_whole()) return RecordState::valid;
  const bool all = scope == ResetScope::node;
  node_.dictionary().restore_defaults(all ? 0x0000 : object_index::communication_first,
                                      all ? 0xFFFF : object_index::communication_last, node_.id());
  former_(scope);
  return RecordState::unreadable;
}

/// Numbers pass the checks of their range; strings are read into their entry.
bool Storage::take(const StoredHead& head, std::uint32_t at) {
  const Entry entry = *node_.dictionary().find(head.index, head.sub);
  if (is_string(entry.row->type)) {
    canvoy::store(entry.value, static_cast<std::uint16_t>(head.length));
    return record_.read(at, entry.bytes());
  }
  std::uint8_t bytes[8];
  const auto value = std::span(bytes).first(head.length);
  if (!record_.read(at, value)) return false;
  // A set of an earlier version may contain one.
  if (is_dynamic_channel(head.index, value)) return true;
  if (node_.dictionary().check_value(*entry.row, value) == AbortCode::none) {
    node_.dictionary().set(entry, value);
  }
  return true;
}

/// Not earlier: the emergency producer discards errors from before a reset.
void Storage::state_entered(NmtState state) {
  if (state != NmtState::pre_operational) return;
  const bool good = state_ == RecordState::valid || state_ == RecordState::empty;
  good ? node_.clear(refused(state_)) : node_.raise(refused(state_));
}

AbortCode Storage::before_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const bool stores = entry.index == object_index::store_parameters;
  const bool is_signed = load_unsigned(value) == (stores ? save_signature : load_signature);
  const bool can = (load_unsigned(entry.bytes()) & on_command) != 0;
  if (!is_signed || !can) return AbortCode::cannot_store;
  if (node_.is_deferred()) return AbortCode::device_state;
  const auto done = Done::to<&Node::finish_deferred>(node_);
  const AbortCode started = stores ? store(entry.sub, done) : restore(entry.sub, done);
  return started == AbortCode::none ? AbortCode::deferred : started;
}

AbortCode Storage::store(std::uint8_t group, Done done) {
  return begin({.group = group, .store = true, .keep = usable(), .node_id = node_.id()}, done);
}

AbortCode Storage::restore(std::uint8_t group, Done done) {
  return begin({.group = group, .store = false, .keep = usable(), .node_id = node_.id()}, done);
}

AbortCode Storage::begin(const ParameterSet::Recipe& recipe, Done done) {
  if (busy()) return AbortCode::device_state;
  // The values of other groups would be lost.
  if (state_ == RecordState::unreadable) return AbortCode::hardware;
  done_ = done;
  end_ = node_.now() + settings_.time_out;
  record_.begin(set_.cook(recipe));
  node_.timers().arm(timer_, node_.now());
  return AbortCode::none;
}

void Storage::step(Time now) {
  switch (record_.step()) {
    case RecordStep::again:
      return node_.timers().arm(timer_, now);
    case RecordStep::wait:
      if (now >= end_) return finish(AbortCode::hardware);
      return node_.timers().arm(timer_, now + settings_.poll_interval);
    case RecordStep::done:
      return finish(record_.outcome());
  }
}

void Storage::finish(AbortCode answer) {
  record_.cancel();
  node_.timers().disarm(timer_);
  if (answer == AbortCode::none && state_ != RecordState::valid) {
    node_.clear(refused(state_));
    state_ = RecordState::valid;
  }
  std::exchange(done_, {})(answer);
}

}  // namespace canvoy
