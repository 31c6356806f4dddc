#include "canvoy/canopen/sdo/sdo_channel.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

bool is_usable(const Entry& entry, std::uint32_t can_id) {
  if (!is_restricted(can_id)) return true;
  if (entry.index < sdo_client_parameter) return false;
  const std::uint16_t base =
      entry.sub == sdo_sub_request ? can_id::sdo_request : can_id::sdo_response;
  return can_id > base && can_id - base <= node_id_max;
}

}  // namespace

SdoChannel sdo_channel(const Dictionary& dictionary, std::uint16_t index) {
  const Result<Entry> request = dictionary.find(index, sdo_sub_request);
  const Result<Entry> response = dictionary.find(index, sdo_sub_response);
  if (!request || !response) return {};
  const CobId request_id{load<std::uint32_t>(request->value)};
  const CobId response_id{load<std::uint32_t>(response->value)};
  for (const CobId id : {request_id, response_id}) {
    if (!id.valid() || !id.is_base_frame()) return {};
  }
  return {static_cast<std::uint16_t>(request_id.can_id()),
          static_cast<std::uint16_t>(response_id.can_id())};
}

AbortCode check_sdo_parameter(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.sub != sdo_sub_request && entry.sub != sdo_sub_response) return AbortCode::none;
  const CobId present{load<std::uint32_t>(entry.value)};
  const CobId wanted{load<std::uint32_t>(value.data())};
  if (!wanted.valid()) return AbortCode::none;
  if (!wanted.is_base_frame() || !is_usable(entry, wanted.can_id())) return AbortCode::value_range;
  const bool stays = !present.valid() || present.can_id() == wanted.can_id();
  return stays ? AbortCode::none : AbortCode::value_range;
}

}  // namespace canvoy
