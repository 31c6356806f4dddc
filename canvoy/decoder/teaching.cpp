#include "canvoy/decoder/teaching.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/pdo_plans.hpp"
#include "canvoy/decoder/unit_source.hpp"

namespace canvoy::decoder {

namespace {

bool is_default_sdo(std::uint32_t id) {
  const std::uint32_t of_node_0 = id & ~std::uint32_t{node_id_max};
  return of_node_0 == can_id::sdo_response || of_node_0 == can_id::sdo_request;
}

bool is_learned(unsigned index, unsigned sub) {
  if (index > PdoPlans::index_last) return is_unit_source(index, sub);
  return index == object_index::device_type || index == object_index::identity ||
         (index >= object_index::sdo_server && index <= object_index::sdo_client_last) ||
         index >= PdoPlans::index_first;
}

}  // namespace

bool may_teach(const Frame& frame) {
  if (!frame.is_plain() || frame.length != Frame::length_max) return false;
  if (frame.id == can_id::lss_request || frame.id == can_id::lss_response) return true;
  return is_default_sdo(frame.id) && is_learned(load<std::uint16_t>(&frame.data[1]), frame.data[3]);
}

}  // namespace canvoy::decoder
