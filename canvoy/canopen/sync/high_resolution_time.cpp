#include "canvoy/canopen/sync/high_resolution_time.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

constexpr AccessHandlers HighResolutionTime::hook_calls = {
    .first = object_index::high_resolution_time,
    .last = object_index::high_resolution_time,
    .before_read = method<&HighResolutionTime::before_read>,
    .after_write = method<&HighResolutionTime::after_write>};
constexpr ServiceHandlers HighResolutionTime::service_calls = {.hooks = {&hook_calls, 1}};

HighResolutionTime::HighResolutionTime(Node& node, Sync* sync) : node_(node) {
  node_.attach(service_);
  if (sync == nullptr) return;
  listener_.received = callback<&HighResolutionTime::received>(*this);
  sync->attach(listener_);
}

void HighResolutionTime::received(std::uint8_t) {
  stamped_ = true;
  stamped_at_ = node_.now();
  node_.dictionary().set_number(object_index::high_resolution_time, 0, clock(stamped_at_));
}

/// Without Dictionary::set(): a read is no reason to send a PDO.
AbortCode HighResolutionTime::before_read(const Entry& entry) {
  store(entry.value, clock(node_.now()));
  return AbortCode::none;
}

void HighResolutionTime::after_write(const Entry&, Source) {
  const Time at = stamped_ ? stamped_at_ : node_.now();
  const auto written =
      static_cast<std::uint32_t>(node_.dictionary().number(object_index::high_resolution_time, 0));
  ahead_ = written - static_cast<std::uint32_t>(at.time_since_epoch().count());
}

}  // namespace canvoy
