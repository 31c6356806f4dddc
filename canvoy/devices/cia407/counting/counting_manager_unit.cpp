#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"

#include <algorithm>

namespace canvoy::cia407 {

namespace {

constexpr std::uint8_t flag_close = 1;
constexpr std::uint8_t flag_limit = 2;
constexpr unsigned percent = 100;
constexpr unsigned usage_max = 255;
constexpr std::size_t stop_point_at = 14;
constexpr std::size_t in_at = 20;
constexpr std::size_t out_at = 22;

/// Adds to a number of two bytes.
void add(std::span<std::uint8_t> bytes, std::uint8_t count) {
  store(bytes.data(), static_cast<std::uint16_t>(load<std::uint16_t>(bytes.data()) + count));
}

}  // namespace

constexpr AccessHandlers CountingManagerUnit::hook_calls[] = {
    after_write<&CountingManagerUnit::counts_written,
                passenger_counting_in_and_out_per_door_object>,
    after_write<&CountingManagerUnit::stop_point_written, stop_point_id_object>};

CountingManagerUnit::CountingManagerUnit(VirtualDevice& device, const NoHardware& /*hardware*/,
                                         const CountingManagerSettings& settings)
    : device_(device),
      settings_(settings),
      hook_{.first = passenger_counting_manager_data_object.index,
            .last = passenger_counting_manager_data_object.index,
            .domain = &domain_} {
  device.on_reset = callback<&CountingManagerUnit::reset>(*this);
  device.react(*this, hook_calls);
  domain_.open_read = callback<&CountingManagerUnit::open_read>(*this);
  domain_.read = callback<&CountingManagerUnit::read>(*this);
  device.node().dictionary().attach(hook_);
}

void CountingManagerUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) tell();
}

void CountingManagerUnit::counts_written() {
  take(device_[incoming_passengers_of_door].raw(), device_[outgoing_passengers_of_door].raw());
}

/// The same stop is sent again with each event of another device (8.1.4.3).
void CountingManagerUnit::stop_point_written() {
  if (!is_stop_open_) return;
  const auto open_stop = load<std::uint32_t>(&last_record()[stop_point_at]);
  is_stop_open_ = device_[stop_point_id].raw() == open_stop;
}

void CountingManagerUnit::take(std::uint8_t in, std::uint8_t out) {
  if (in == 0 && out == 0) return;
  counts_.in = static_cast<std::uint16_t>(counts_.in + in);
  counts_.out = static_cast<std::uint16_t>(counts_.out + out);
  // More passengers get off than were counted in: the counters have missed some.
  counts_.aboard = counts_.aboard + in < out ? 0 : counts_.aboard + in - out;
  note(in, out);
  tell();
}

void CountingManagerUnit::clear() {
  restore({});
}

void CountingManagerUnit::tell() {
  device_.tell(total_incoming_passengers, counts_.in);
  device_.tell(total_outgoing_passengers, counts_.out);
  device_.tell(counter_passenger_sum, counts_.aboard);
  const unsigned usage = counts_.aboard * percent / std::max(settings_.capacity, 1U);
  device_.tell(passenger_capacity_usage, std::min(usage, usage_max));
  device_.signal(flag_close, usage >= settings_.close_percent);
  device_.signal(flag_limit, usage >= settings_.limit_percent);
}

CountingManagerUnit::Record& CountingManagerUnit::open_record() {
  if (!is_stop_open_) {
    is_stop_open_ = true;
    ++records_made_;
    Record& made = last_record();
    made = {};
    const Dictionary& dictionary = device_.node().dictionary();
    for (std::uint8_t sub = 1; sub <= 6; ++sub) {
      made[sub - 1U] =
          static_cast<std::uint8_t>(dictionary.word(local_time_and_date_object.index, sub));
    }
    store(&made[6], device_[line_id].raw());
    store(&made[8], device_[route_number].raw());
    store(&made[10], device_[destination_number].raw());
    store(&made[stop_point_at], device_[stop_point_id].raw());
    made[18] = device_[journey_direction].raw();
  }
  return last_record();
}

void CountingManagerUnit::note(std::uint8_t in, std::uint8_t out) {
  Record& record = open_record();
  add(std::span(record).subspan(in_at, 2), in);
  add(std::span(record).subspan(out_at, 2), out);
}

Result<std::uint32_t> CountingManagerUnit::open_read(const Entry& /*entry*/) {
  return static_cast<std::uint32_t>(std::min(records_made_, records_max) * record_size);
}

Result<std::size_t> CountingManagerUnit::read(const Entry& /*entry*/, std::uint32_t offset,
                                              std::span<std::uint8_t> bytes) {
  const std::size_t count = std::min(records_made_, records_max);
  const std::size_t size = count * record_size;
  std::size_t written = 0;
  for (; written < bytes.size() && offset + written < size; ++written) {
    const std::size_t at = offset + written;
    const std::size_t record = records_made_ - count + at / record_size;
    bytes[written] = records_[record % records_max][at % record_size];
  }
  return written;
}

}  // namespace canvoy::cia407
