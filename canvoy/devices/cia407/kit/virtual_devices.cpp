#include "canvoy/devices/cia407/kit/virtual_devices.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::cia407 {

namespace {

constexpr std::uint16_t types_index = 0x6000;
constexpr std::uint16_t events_from_index = 0x6001;
constexpr std::uint16_t events_for_index = 0x6002;
constexpr std::uint16_t counts_index = passenger_counting_in_and_out_per_door_object.index;

/// An event in the form of 6001h and 6002h.
constexpr std::uint32_t event_word(std::uint8_t code, std::uint16_t information,
                                   std::uint8_t flags) {
  return std::uint32_t{code} << event_code_bit |
         std::uint32_t{information} << event_information_bit | flags;
}

}  // namespace

constexpr AccessHandlers VirtualDevices::hook_calls[] = {
    {.first = any_object.first,
     .last = any_object.last,
     .before_read = method<&VirtualDevices::before_read>,
     .before_write = method<&VirtualDevices::check>,
     .after_write = method<&VirtualDevices::written>}};
constexpr ServiceHandlers VirtualDevices::service_calls = {.reset = method<&VirtualDevices::reset>,
                                                           .hooks = hook_calls};

VirtualDevices::VirtualDevices(Node& node) : node_(node) {
  next_restored_ = node.on_defaults_restored(callback<&VirtualDevices::defaults_restored>(*this));
  node.attach(service_);
}

/// 6000h, where there are several (9.2.3.1).
void VirtualDevices::defaults_restored(ResetScope scope) {
  if (next_restored_) next_restored_(scope);
  for (const VirtualDevice* device = first_; device != nullptr; device = device->next_) {
    node_.dictionary().set_number(types_index, static_cast<std::uint8_t>(device->number_),
                                  device_type(device->info_) >> 16);
  }
}

void VirtualDevices::reset(ResetScope scope) {
  for (VirtualDevice* device = first_; device != nullptr; device = device->next_) {
    if (scope == ResetScope::node) {
      device->flags_ = 0;
      device->information_ = 0;
    }
    if (device->on_reset) device->on_reset(scope);
  }
}

template <class Act>
AbortCode VirtualDevice::for_rows_of(const Entry& entry, const Act& act) const {
  AbortCode answer = AbortCode::none;
  for (const AccessHandlers& row : rows_) {
    if (answer != AbortCode::none) break;
    if (row.covers(entry.index, entry.sub)) answer = act(row, unit_);
  }
  return answer;
}

AbortCode VirtualDevices::before_read(const Entry& entry) {
  const auto ask = [&entry](const AccessHandlers& row, void* unit) {
    return row.before_read == nullptr ? AbortCode::none : row.before_read(unit, entry);
  };
  AbortCode answer = AbortCode::none;
  const VirtualDevice* device = first_;
  for (; device != nullptr && answer == AbortCode::none; device = device->next_) {
    answer = device->for_rows_of(entry, ask);
  }
  return answer;
}

AbortCode VirtualDevices::check(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.index == counts_index) own_counts_ = static_cast<std::uint16_t>(entry.word());
  const auto ask = [&](const AccessHandlers& row, void* unit) {
    return row.before_write == nullptr ? AbortCode::none : row.before_write(unit, entry, value);
  };
  for (VirtualDevice* device = first_; device != nullptr; device = device->next_) {
    // An event for a virtual device other than the one at this position; all zeros are no event.
    if (entry.index == events_for_index && entry.sub == device->number_ && value.size() == 4) {
      const std::uint32_t word = load_word(value.data(), 4);
      if (word != 0 && word >> event_code_bit != device->info_.code) return AbortCode::value_range;
    }
    const AbortCode answer = device->for_rows_of(entry, ask);
    if (answer != AbortCode::none) return answer;
  }
  return AbortCode::none;
}

void VirtualDevices::listen(std::span<const AccessHandlers> rows) {
  for (const AccessHandlers& row : rows) {
    if (row.after_write == nullptr) continue;
    const unsigned count = static_cast<unsigned>(
        std::min<std::size_t>(row.last - row.first + 1U, 64U * listened_.size()));
    for (unsigned index = row.first; index < row.first + count; ++index) {
      listened_[index / 64 % listened_.size()] |= std::uint64_t{1} << index % 64;
    }
  }
}

bool VirtualDevices::is_of_events(std::uint16_t index) {
  return index == events_for_index;
}

void VirtualDevices::written(const Entry& entry, Source source) {
  const bool is_heard = has_listener(entry.index);
  const auto tell = [&](const AccessHandlers& row, void* unit) {
    if (row.after_write != nullptr) row.after_write(unit, entry, source);
    return AbortCode::none;
  };
  for (VirtualDevice* device = is_heard ? first_ : nullptr; device != nullptr;
       device = device->next_) {
    if (device != teller_) device->for_rows_of(entry, tell);
    if (entry.index != events_for_index || entry.sub != device->number_) continue;
    const std::uint32_t word = entry.word();
    // An event written within the device may be for a device at this position in the network.
    const bool is_for_it = word == 0 || word >> event_code_bit == device->info_.code;
    if (is_for_it && device->on_event) {
      device->on_event(static_cast<std::uint8_t>(word),
                       static_cast<std::uint16_t>(word >> event_information_bit));
    }
  }
  // Counts of another door are accepted; the values that are read and sent stay those of the door
  // here (6.21).
  const bool is_provided = allows(entry.row->access, Access::sdo_read);
  if (entry.index == counts_index && is_provided && source != Source::application) {
    node_.dictionary().set_number(counts_index, 0, own_counts_);
  }
}

void VirtualDevices::report_events(VirtualDevice& device) {
  if (device.number_ > with_events_max) return;
  const bool has_event = device.flags_ != 0 || device.information_ != 0;
  const std::uint32_t word =
      has_event ? event_word(device.info_.code, device.information_, device.flags_) : 0;
  Dictionary& dictionary = node_.dictionary();
  const std::uint32_t bit = std::uint32_t{1} << (device.number_ - 1);
  const std::uint32_t others = dictionary.word(events_from_index, 1) & ~bit;
  const auto sub = static_cast<std::uint8_t>(device.number_ + 1);
  const bool is_news = dictionary.word(events_from_index, sub) != word;
  dictionary.set_number(events_from_index, sub, word);
  dictionary.set_number(events_from_index, 1, others | (has_event ? bit : 0));
  if (is_news) device.announce_at(events_from_index, sub);
}

VirtualDevice::VirtualDevice(VirtualDevices& all, const VirtualDeviceInfo& info, unsigned number)
    : all_(all), info_(info), number_(number) {
  *all.last_ = this;
  all.last_ = &next_;
}

void VirtualDevice::announce_at(std::uint16_t index, std::uint8_t sub) {
  const Result<Entry> entry = node().dictionary().find(index, sub);
  if (entry) announce(*entry);
}

/// Most values are of interest to none of this physical device, and the one hook is that of all_.
void VirtualDevice::announce(const Entry& entry) {
  const bool is_ours_alone = entry.is_hooked_by_one() && any_object.covers(entry.index);
  if (is_ours_alone && !all_.has_listener(entry.index)) return;
  const VirtualDevice* const before = std::exchange(all_.teller_, this);
  node().dictionary().announce(entry, Source::application);
  all_.teller_ = before;
}

void VirtualDevice::signal(std::uint8_t flags, bool is_pending) {
  const auto kept = static_cast<std::uint8_t>(flags_ & ~flags);
  const auto wanted = static_cast<std::uint8_t>(is_pending ? kept | flags : kept);
  if (wanted == flags_) return;
  flags_ = wanted;
  all_.report_events(*this);
}

void VirtualDevice::inform(std::uint16_t information) {
  if (information_ == information) return;
  information_ = information;
  all_.report_events(*this);
}

}  // namespace canvoy::cia407
