// The short way of RPDOs of which the values are nothing but bytes: a frame costs a copy.
#include <cstring>
#include <utility>

#include "canvoy/canopen/pdo/rpdo.hpp"

namespace canvoy {

namespace {

/// Values of one size that fill the PDO. Its bytes are loaded once: loads of single ones, each
/// after a store, take twice the time.
template <class Unit, std::size_t... i>
void copy_units(std::uint8_t* block, const MappedValue* values, const std::uint8_t* data,
                std::index_sequence<i...>) {
  const auto image = load<std::uint64_t>(data);
  (store(block + values[i].offset(), static_cast<Unit>(image >> (i * sizeof(Unit) * 8))), ...);
}
template <class Unit>
void copy_units(std::uint8_t* block, const MappedValue* values, const std::uint8_t* data) {
  copy_units<Unit>(block, values, data, std::make_index_sequence<pdo_bytes_max / sizeof(Unit)>());
}

}  // namespace

inline void Rpdos::copy(const Rpdo& pdo, const std::uint8_t* data) const {
  const MappedValue* values = values_of(pdo);
  std::uint8_t* block = node_.dictionary().values();
  switch (pdo.plan_) {
    case Pdo::whole:
      std::memcpy(block + values->offset(), data, pdo_bytes_max);
      return;
    case Pdo::bytes:
      return copy_units<std::uint8_t>(block, values, data);
    case Pdo::words:
      return copy_units<std::uint16_t>(block, values, data);
    case Pdo::longs:
      return copy_units<std::uint32_t>(block, values, data);
    default:
      std::memcpy(block + values->offset(), data, pdo.length_);
  }
}

void Rpdos::receive_routed(void* context, const Frame& frame, Time now) {
  if constexpr (!Pdo::has_routes) return;
  Rpdo& pdo = *static_cast<Rpdo*>(context);
  Rpdos& self = static_cast<Rpdos&>(*pdo.owner_.value);
  if (pdo.simple_ && frame.length == pdo.length_ &&
      self.places_.value.revision == self.node_.dictionary().revision()) [[likely]] {
    pdo.since_ = low_ticks(now);
    self.copy(pdo, frame.data.data());
    if (self.received) self.received(self.number_of(pdo));
    return;
  }
  self.take_any(pdo, frame);
}

}  // namespace canvoy
