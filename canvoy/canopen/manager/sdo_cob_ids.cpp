#include "canvoy/canopen/manager/sdo_cob_ids.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

unsigned SdoCobIds::count() const {
  return static_cast<unsigned>(dictionary_.number(dynamic_sdo::cob_ids, 0));
}

CobId SdoCobIds::at(unsigned sub) const {
  return CobId{static_cast<std::uint32_t>(
      dictionary_.number(dynamic_sdo::cob_ids, static_cast<std::uint8_t>(sub)))};
}

AbortCode SdoCobIds::check(const Entry& entry, std::uint32_t value) const {
  const CobId present{load<std::uint32_t>(entry.value)};
  if (present.raw == value) return AbortCode::none;
  if (present.valid() && connections_.is_given(present.can_id())) return AbortCode::device_state;
  const CobId wanted{value};
  if (!wanted.valid()) return AbortCode::none;
  if (!wanted.is_base_frame() || is_restricted(wanted.can_id())) return AbortCode::value_range;
  const unsigned last = count();
  for (unsigned sub = 1; sub <= last; ++sub) {
    const CobId other = at(sub);
    if (sub != entry.sub && other.valid() && other.can_id() == wanted.can_id()) {
      return AbortCode::parameter_incompatible;
    }
  }
  return AbortCode::none;
}

std::uint16_t SdoCobIds::free_can_id(std::uint16_t taken) const {
  const unsigned last = count();
  for (unsigned sub = 1; sub <= last; ++sub) {
    const CobId id = at(sub);
    const bool is_usable = id.valid() && id.is_base_frame() && !is_restricted(id.can_id());
    if (is_usable && id.can_id() != taken && !connections_.is_given(id.can_id())) {
      return static_cast<std::uint16_t>(id.can_id());
    }
  }
  return 0;
}

}  // namespace canvoy
