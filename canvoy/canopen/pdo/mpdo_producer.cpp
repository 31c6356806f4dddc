#include "canvoy/canopen/pdo/mpdo_producer.hpp"

#include <algorithm>
#include <cstring>

namespace canvoy {

namespace {

/// Entry that an MPDO can carry, or the reason against it.
Result<Entry> find_readable(const Dictionary& dictionary, std::uint16_t index, unsigned sub) {
  if (sub > sub_index_max) return AbortCode::no_sub_index;
  const Result<Entry> entry = dictionary.find_for_bus(index, static_cast<std::uint8_t>(sub));
  if (!entry) return entry.abort();
  const unsigned length = byte_length(entry->row->type);
  const bool fits = length != 0 && length <= mpdo_data_max;
  return fits && allows(entry->row->access, Access::tpdo) ? entry : AbortCode::not_mappable;
}

}  // namespace

constexpr AccessHandlers MpdoProducer::hook_calls[] = {
    {.first = mpdo_list::scanner_first,
     .last = mpdo_list::scanner_last,
     .before_write = method<&MpdoProducer::before_list_write>,
     .after_write = method<&MpdoProducer::written>},
    {.first = mpdo_list::tpdo_first,
     .last = mpdo_list::tpdo_last,
     .before_write = method<&MpdoProducer::before_parameter_write>}};
constexpr ServiceHandlers MpdoProducer::service_calls = {.hooks = hook_calls};
constexpr MpdoCalls MpdoProducer::mpdo_calls = {.event = method<&MpdoProducer::event>,
                                                .transmit = method<&MpdoProducer::transmit>,
                                                .watch = method<&MpdoProducer::watch>};

MpdoProducer::MpdoProducer(Node& node, Tpdos& tpdos, std::span<ScannedObject> scanned,
                           std::span<Message> queue)
    : node_(node), tpdos_(tpdos), scanned_(scanned), queue_(queue) {
  node_.attach(service_);
  tpdos_.use(source_);
}

bool MpdoProducer::send(std::uint16_t number, NodeId consumer, std::uint16_t index,
                        std::uint8_t sub, std::span<const std::uint8_t> value) {
  if (consumer > node_id_max || value.size() > mpdo_data_max || queued_ == queue_.size() ||
      !tpdos_.is_ready(number, MpdoMode::destination)) {
    return false;
  }
  Message& message = queue_[queued_++];
  message = {number, {.node = consumer, .index = index, .sub = sub}};
  if (!value.empty()) std::memcpy(message.mpdo.data.data(), value.data(), value.size());
  tpdos_.announce_mpdos(number);
  return true;
}

AbortCode MpdoProducer::before_list_write(const Entry& entry, std::span<const std::uint8_t> value) {
  const Change change{entry.index, entry.sub, static_cast<std::uint32_t>(load_unsigned(value))};
  if (entry.sub != 0 && change.value != 0) {
    const ScannerEntry wanted = decode_scanner_entry(change.value);
    const Result<Entry> first = find_readable(node_.dictionary(), wanted.index, wanted.sub);
    if (!first) return first.abort();
  }
  return scan({}, change) > scanned_.size() ? AbortCode::out_of_memory : AbortCode::none;
}

/// A node has one TPDO in source address mode.
AbortCode MpdoProducer::before_parameter_write(const Entry& entry,
                                               std::span<const std::uint8_t> value) {
  const Dictionary& dictionary = node_.dictionary();
  const AbortCode answer = check_mpdo_parameter(dictionary, entry, value);
  if (answer != AbortCode::none || entry.sub != pdo_sub::cob_id) return answer;
  const CobId wanted{static_cast<std::uint32_t>(load_unsigned(value))};
  const auto mapping = static_cast<std::uint16_t>(entry.index + pdo_count_max);
  const auto number = static_cast<std::uint16_t>(entry.index - mpdo_list::tpdo_first + 1);
  const MpdoMode mode = mpdo_mode(static_cast<unsigned>(dictionary.number(mapping, 0)));
  const bool is_second =
      wanted.valid() && mode == MpdoMode::source && tpdos_.has_other(number, MpdoMode::source);
  return is_second ? AbortCode::parameter_incompatible : AbortCode::none;
}

void MpdoProducer::written(const Entry&, Source) {
  load();
  tpdos_.restart_mpdos(MpdoMode::source);
}

void MpdoProducer::load() {
  count_ = std::min(scan(scanned_, {}), scanned_.size());
  next_ = 0;
}

/// Writes the objects of the scanner lists, with one entry changed, to `objects`, as far as there
/// is room. Returns their number.
std::size_t MpdoProducer::scan(std::span<ScannedObject> objects, const Change& change) const {
  const Dictionary& dictionary = node_.dictionary();
  const auto read = [&](std::uint16_t index, std::uint8_t sub) {
    const bool changes = index == change.index && sub == change.sub;
    return changes ? change.value : static_cast<std::uint32_t>(dictionary.number(index, sub));
  };
  std::size_t count = 0;
  for (unsigned list = mpdo_list::scanner_first; list <= mpdo_list::scanner_last; ++list) {
    const auto index = static_cast<std::uint16_t>(list);
    if (!dictionary.find(index, 0)) break;
    const unsigned entries = read(index, 0);
    for (unsigned sub = 1; sub <= entries; ++sub) {
      const std::uint32_t written = read(index, static_cast<std::uint8_t>(sub));
      if (written != 0) append(decode_scanner_entry(written), objects, count);
    }
  }
  return count;
}

void MpdoProducer::append(const ScannerEntry& entry, std::span<ScannedObject> objects,
                          std::size_t& count) const {
  for (unsigned i = 0; i < entry.block_size; ++i) {
    const unsigned sub = entry.sub + i;
    if (!find_readable(node_.dictionary(), entry.index, sub)) continue;
    if (count < objects.size()) objects[count] = {entry.index, static_cast<std::uint8_t>(sub)};
    ++count;
  }
}

void MpdoProducer::event(std::uint16_t number, MpdoMode mode, MpdoEvent event) {
  if (event == MpdoEvent::reset) return load();
  if (mode == MpdoMode::destination) {
    if (event == MpdoEvent::end) forget(number);
    return;
  }
  for (ScannedObject& object : scanned_.first(count_)) {
    switch (event) {
      case MpdoEvent::begin:
        object.sent = value_of(object);
        break;
      case MpdoEvent::change:
        object.waits |= value_of(object) != object.sent;
        break;
      default:
        object.waits = event == MpdoEvent::all;
    }
  }
}

/// Sends one frame after the other, until none is left, or the TPDO may not send the next one yet.
void MpdoProducer::transmit(std::uint16_t number, MpdoMode mode) {
  tpdos_.before_transmit(number);
  PdoImage image;
  while (next(number, mode, image) && tpdos_.may_send_mpdo(number)) {
    // Removed before it leaves: an answer may come at once, and end the transmission.
    sent(number, mode);
    if (!tpdos_.send_mpdo(number, image)) return;
  }
}

bool MpdoProducer::next(std::uint16_t number, MpdoMode mode, PdoImage& image) {
  if (mode == MpdoMode::source) return next_scanned(image);
  const auto message = first_of(number);
  if (message == queue_.begin() + static_cast<std::ptrdiff_t>(queued_)) return false;
  image = encode(message->mpdo);
  return true;
}

/// Searches from the object that was sent last.
bool MpdoProducer::next_scanned(PdoImage& image) {
  for (std::size_t i = 0; i < count_; ++i, next_ = (next_ + 1) % count_) {
    ScannedObject& object = scanned_[next_];
    if (!object.waits) continue;
    const Result<Entry> entry = node_.dictionary().find_for_bus(object.index, object.sub);
    // A hook may refresh the value; if it refuses, the value stays.
    if (entry) static_cast<void>(node_.dictionary().read(*entry));
    object.sent = value_of(object);
    image = encode({MpdoMode::source, node_.id(), object.index, object.sub, object.sent});
    return true;
  }
  return false;
}

void MpdoProducer::sent(std::uint16_t number, MpdoMode mode) {
  if (mode == MpdoMode::source) {
    scanned_[next_].waits = false;
    next_ = (next_ + 1) % count_;
    return;
  }
  const auto message = first_of(number);
  std::move(message + 1, queue_.begin() + static_cast<std::ptrdiff_t>(queued_), message);
  --queued_;
}

/// Oldest message for this TPDO, or the end of the queue.
std::span<MpdoProducer::Message>::iterator MpdoProducer::first_of(std::uint16_t number) {
  return std::ranges::find(queue_.first(queued_), number, &Message::number);
}

void MpdoProducer::forget(std::uint16_t number) {
  const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(queued_);
  const auto kept_end = std::remove_if(
      queue_.begin(), end, [number](const Message& each) { return each.number == number; });
  queued_ = static_cast<std::size_t>(kept_end - queue_.begin());
}

void MpdoProducer::watch(MpdoMode mode, std::uint32_t watchers) {
  if (mode != MpdoMode::source) return;
  for (const ScannedObject& object : scanned_.first(count_)) {
    const Result<Entry> entry = node_.dictionary().find_for_bus(object.index, object.sub);
    if (entry) node_.dictionary().watch(*entry, watchers);
  }
}

MpdoProducer::Value MpdoProducer::value_of(const ScannedObject& object) const {
  Value value{};
  const Result<Entry> entry = node_.dictionary().find_for_bus(object.index, object.sub);
  if (entry) store(value.data(), entry->word());
  return value;
}

}  // namespace canvoy
