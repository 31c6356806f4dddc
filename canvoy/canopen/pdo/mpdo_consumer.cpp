#include "canvoy/canopen/pdo/mpdo_consumer.hpp"

namespace canvoy {

namespace {

/// Entry that an MPDO can write, or the reason against it.
Result<Entry> find_writable(const Dictionary& dictionary, std::uint16_t index, unsigned sub) {
  if (sub > sub_index_max) return AbortCode::no_sub_index;
  const Result<Entry> entry = dictionary.find_for_bus(index, static_cast<std::uint8_t>(sub));
  if (!entry) return entry.abort();
  const unsigned length = byte_length(entry->row->type);
  const bool fits = length != 0 && length <= mpdo_data_max;
  return fits && allows(entry->row->access, Access::rpdo) ? entry : AbortCode::not_mappable;
}

}  // namespace

constexpr AccessHandlers MpdoConsumer::hook_calls[] = {
    {.first = mpdo_list::dispatcher_first,
     .last = mpdo_list::dispatcher_last,
     .before_write = method<&MpdoConsumer::before_list_write>},
    {.first = mpdo_list::rpdo_first,
     .last = mpdo_list::rpdo_last,
     .before_write = method<&MpdoConsumer::before_parameter_write>}};
constexpr ServiceHandlers MpdoConsumer::service_calls = {.hooks = hook_calls};

MpdoConsumer::MpdoConsumer(Node& node, Rpdos& rpdos) : node_(node), rpdos_(rpdos) {
  node_.attach(service_);
  rpdos_.use(receiver_);
}

AbortCode MpdoConsumer::before_list_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const std::uint64_t written = load_unsigned(value);
  if (entry.sub == 0 || written == 0) return AbortCode::none;
  const DispatcherEntry wanted = decode_dispatcher_entry(written);
  if (!is_node_id(wanted.producer)) return AbortCode::value_range;
  return find_writable(node_.dictionary(), wanted.index, wanted.sub).abort();
}

AbortCode MpdoConsumer::before_parameter_write(const Entry& entry,
                                               std::span<const std::uint8_t> value) {
  return check_mpdo_parameter(node_.dictionary(), entry, value);
}

void MpdoConsumer::receive(std::uint16_t number, MpdoMode mode, const std::uint8_t* data) {
  rpdos_.finish(number, take(mode, decode_mpdo(data)));
}

MpdoAnswer MpdoConsumer::take(MpdoMode mode, const Mpdo& mpdo) {
  const bool has_producer = mpdo.mode == MpdoMode::destination || mpdo.node != 0;
  if (mpdo.mode != mode || !has_producer) {
    node_.count_malformed();
    return {};
  }
  return mode == MpdoMode::destination ? take_destination(mpdo) : take_source(mpdo);
}

MpdoAnswer MpdoConsumer::take_destination(const Mpdo& mpdo) {
  if (mpdo.node != 0 && mpdo.node != node_.id()) return {};
  return put(mpdo.index, mpdo.sub, mpdo);
}

MpdoAnswer MpdoConsumer::take_source(const Mpdo& mpdo) {
  const Dictionary& dictionary = node_.dictionary();
  for (unsigned list = mpdo_list::dispatcher_first; list <= mpdo_list::dispatcher_last; ++list) {
    const auto index = static_cast<std::uint16_t>(list);
    if (!dictionary.find(index, 0)) break;
    const std::uint64_t count = dictionary.number(index, 0);
    for (unsigned sub = 1; sub <= count; ++sub) {
      const DispatcherEntry entry =
          decode_dispatcher_entry(dictionary.number(index, static_cast<std::uint8_t>(sub)));
      if (!entry.covers(mpdo)) continue;
      const MpdoAnswer answer =
          put(entry.index, unsigned{entry.sub} + mpdo.sub - entry.producer_sub, mpdo);
      if (answer.outcome != MpdoAnswer::missing) return answer;
      node_.count_malformed();
      return {};
    }
  }
  return {};
}

MpdoAnswer MpdoConsumer::put(std::uint16_t index, unsigned sub, const Mpdo& mpdo) {
  Dictionary& dictionary = node_.dictionary();
  const auto told_sub = static_cast<std::uint8_t>(sub);
  const Result<Entry> entry = find_writable(dictionary, index, sub);
  if (!entry) return {MpdoAnswer::missing, index, told_sub};
  const auto value = std::span(mpdo.data).first(byte_length(entry->row->type));
  if (dictionary.check(*entry, value) != AbortCode::none) {
    return {MpdoAnswer::refused, index, told_sub};
  }
  dictionary.commit(*entry, value, Source::pdo);
  return {MpdoAnswer::taken, index, told_sub};
}

}  // namespace canvoy
