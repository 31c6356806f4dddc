#include "canvoy/devices/cia417/virtual_io/virtual_mpdo.hpp"

namespace canvoy::cia417 {

constexpr AccessHandlers VirtualMpdoProducer::hook_calls[] = {
    {.first = record_parts_object.index,
     .last = record_parts_object.index,
     .before_read = method<&VirtualMpdoProducer::before_read>}};
constexpr ServiceHandlers VirtualMpdoProducer::service_calls = {
    .state_entered = method<&VirtualMpdoProducer::state_entered>, .hooks = hook_calls};

VirtualMpdoProducer::VirtualMpdoProducer(Node& node, Tpdos& tpdos, MpdoProducer& producer,
                                         VirtualMapping& mapping,
                                         const VirtualMpdoSettings& settings)
    : node_(node),
      tpdos_(tpdos),
      producer_(producer),
      mapping_(mapping),
      settings_(settings),
      former_(tpdos.before_transmit),
      timer_(callback<&VirtualMpdoProducer::go_on>(*this)) {
  tpdos_.before_transmit = callback<&VirtualMpdoProducer::before_transmit>(*this);
  node.attach(service_);
  mapping.use({callback<&VirtualMpdoProducer::is_working>(*this),
               callback<&VirtualMpdoProducer::announce>(*this)});
}

/// The owner sends again the record that was under way. In source address mode, both parts are sent
/// when the PDO starts, in any order: the first record comes after them.
void VirtualMpdoProducer::state_entered(NmtState state) {
  if (state == NmtState::operational) return;
  part_ = parts_told;
  transmitting_ = false;
  changed_ = true;
}

bool VirtualMpdoProducer::is_destination() const {
  return tpdos_.is_ready(settings_.number, MpdoMode::destination);
}
bool VirtualMpdoProducer::is_working() {
  return is_destination() || tpdos_.is_ready(settings_.number, MpdoMode::source);
}

/// Part after part, as long as there is room for them.
void VirtualMpdoProducer::announce() {
  while (is_destination() || (is_working() && !changed_)) {
    std::uint64_t record = 0;
    if (part_ == parts_told) {
      if (!mapping_.take(record)) return;
      parts_ = split(record, ++count_);
      part_ = 1;
    }
    if (!tell(part_)) return;
    ++part_;
  }
}

bool VirtualMpdoProducer::tell(std::uint8_t part) {
  const std::uint32_t value = part == 1 ? parts_.first : parts_.second;
  if (!is_destination()) return change(part, value);
  const auto sub = static_cast<std::uint8_t>(2 * (node_.id() - 1) + part);
  std::array<std::uint8_t, 4> bytes;
  store(bytes.data(), value);
  return producer_.send(settings_.number, settings_.consumer, received_parts_object.index, sub,
                        bytes);
}

/// Source address mode: a change is sent, and the next one waits until it has been sampled.
bool VirtualMpdoProducer::change(std::uint8_t part, std::uint32_t value) {
  Dictionary& dictionary = node_.dictionary();
  changed_ = dictionary.number(record_parts_object.index, part) != value;
  return dictionary.set_number(record_parts_object.index, part, value);
}

/// Frames are sent: there will be room for others.
void VirtualMpdoProducer::before_transmit(std::uint16_t number) {
  if (former_) former_(number);
  if (number != settings_.number) return;
  transmitting_ = true;
  node_.timers().arm(timer_, node_.now());
}

/// A part is sampled, or read by SDO, which is ignored.
AbortCode VirtualMpdoProducer::before_read(const Entry&) {
  if (transmitting_) changed_ = false;
  return AbortCode::none;
}

void VirtualMpdoProducer::go_on(Time) {
  transmitting_ = false;
  announce();
}

constexpr AccessHandlers VirtualMpdoConsumer::hook_calls[] = {
    {.first = received_parts_object.index,
     .last = received_parts_object.index,
     .after_write = method<&VirtualMpdoConsumer::written>}};
constexpr ServiceHandlers VirtualMpdoConsumer::service_calls = {.hooks = hook_calls};

void VirtualMpdoConsumer::written(const Entry& entry, Source source) {
  const bool is_second = entry.sub != 0 && entry.sub % 2 == 0;
  if (!is_second) return;
  Dictionary& dictionary = node_.dictionary();
  const auto part = [&](unsigned sub) {
    const auto number = static_cast<std::uint8_t>(sub);
    return static_cast<std::uint32_t>(dictionary.number(entry.index, number));
  };
  std::uint64_t record = 0;
  if (!join({part(entry.sub - 1U), part(entry.sub)}, record)) return node_.count_malformed();
  const Result<Entry> mapping = dictionary.find(mapping_, 0);
  if (!mapping) return;
  std::array<std::uint8_t, 8> bytes;
  store(bytes.data(), record);
  const std::span<const std::uint8_t> value = std::span(bytes).first(mapping->row->capacity);
  if (dictionary.check(*mapping, value) == AbortCode::none) {
    dictionary.commit(*mapping, value, source);
  }
}

}  // namespace canvoy::cia417
