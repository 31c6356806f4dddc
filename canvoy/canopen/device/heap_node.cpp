#include "canvoy/canopen/device/heap_node.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr std::size_t errors_max = 8;
constexpr std::size_t backlog_max = 64;
constexpr std::size_t mpdo_queue_max = 16;

}  // namespace

HeapNode::HeapNode(const DictionaryTables& tables, const Port& port, NodeId node_id,
                   std::size_t further_routes)
    : tables_(tables),
      initial_bytes_(tables_.value_bytes),
      values_(tables_.value_bytes),
      states_(tables_.objects.size()),
      backlog_(backlog_max),
      errors_(errors_max),
      emergencies_(errors_max),
      heartbeat_slots_(detail::highest_sub_index(tables_, object_index::heartbeat_consumers,
                                                 object_index::heartbeat_consumers)),
      emergency_slots_(detail::highest_sub_index(tables_, object_index::emergency_consumers,
                                                 object_index::emergency_consumers)),
      rpdo_memory_(rpdo_numbers().count),
      tpdo_memory_(tpdo_numbers().count),
      own_ids_(CollisionWatch::ids_beside_tpdos + tpdo_memory_.size()) {
  keep_initial_values();
  const std::size_t servers = 1 + detail::count_objects(tables_, object_index::sdo_server + 1,
                                                        object_index::sdo_server_last);
  constexpr std::size_t basics = 4;  // NMT, SYNC, TIME, guarding
  routes_.resize(basics + servers + heartbeat_slots_.size() + emergency_slots_.size() +
                 rpdo_memory_.size() + tpdo_memory_.size() + own_ids_.size() + further_routes);
  sdo_buffers_.resize(servers);
  node_ = std::make_unique<Node>(tables_, NodeMemory{values_, states_, routes_, backlog_}, port,
                                 node_id);
  add_sdo_servers();
  emergency_producer_ = std::make_unique<EmergencyProducer>(*node_, errors_, emergencies_);
  error_behaviour_.emplace(*node_);
  heartbeat_producer_.emplace(*node_);
  if (!heartbeat_slots_.empty()) heartbeat_consumer_.emplace(*node_, heartbeat_slots_);
  if (!emergency_slots_.empty()) emergency_consumer_.emplace(*node_, emergency_slots_);
  if (has(object_index::guard_time)) node_guarding_.emplace(*node_);
  if (has(object_index::cob_id_time)) time_stamp_.emplace(*node_);
  if (has(object_index::cob_id_sync)) sync_ = std::make_unique<Sync>(*node_);
  if (has(object_index::verify_configuration)) verify_configuration_.emplace(*node_);
  if (has(object_index::high_resolution_time)) high_resolution_time_.emplace(*node_, sync_.get());
  add_pdos();
  add_mpdos();
  collision_watch_.emplace(*node_, own_ids_, tpdo_numbers().lowest);
}

void HeapNode::keep_initial_values() {
  write_defaults(tables_, initial_bytes_,
                 [this](const InitialValues::WithNodeId& each) { with_node_id_.push_back(each); });
  tables_.initial.value = {.bytes = initial_bytes_, .with_node_id = with_node_id_};
}

bool HeapNode::has(std::uint16_t index) const {
  return detail::count_objects(tables_, index, index) != 0;
}

void HeapNode::add_sdo_servers() {
  for (std::size_t number = 0; number < sdo_buffers_.size(); ++number) {
    sdo_buffers_[number].resize(sdo_buffer_size(tables_));
    SdoServer& server =
        sdo_servers_.emplace_back(*node_, static_cast<std::uint8_t>(number), sdo_buffers_[number]);
    sdo_block_servers_.emplace_back(server);
  }
}

detail::PdoNumbers HeapNode::rpdo_numbers() const {
  return detail::pdo_numbers(tables_, object_index::rpdo_parameter,
                             object_index::rpdo_parameter_last);
}
detail::PdoNumbers HeapNode::tpdo_numbers() const {
  return detail::pdo_numbers(tables_, object_index::tpdo_parameter,
                             object_index::tpdo_parameter_last);
}

void HeapNode::add_pdos() {
  rpdo_values_.resize(rpdo_memory_.size() *
                      detail::highest_sub_index(tables_, object_index::rpdo_mapping,
                                                object_index::rpdo_mapping_last));
  tpdo_values_.resize(tpdo_memory_.size() *
                      detail::highest_sub_index(tables_, object_index::tpdo_mapping,
                                                object_index::tpdo_mapping_last));
  if (!rpdo_memory_.empty()) {
    rpdos_.emplace(*node_, rpdo_memory_, rpdo_values_, sync_.get(), rpdo_numbers().lowest);
  }
  if (!tpdo_memory_.empty()) {
    tpdos_.emplace(*node_, tpdo_memory_, tpdo_values_, sync_.get(), Tpdos::AtStart::send,
                   tpdo_numbers().lowest);
  }
}

/// Adds multiplexed PDOs if there are lists for source address mode, or a PDO is multiplexed by
/// default.
void HeapNode::add_mpdos() {
  const bool consumes =
      detail::count_objects(tables_, object_index::dispatching_list,
                            object_index::dispatching_list_last) != 0 ||
      detail::has_mpdo(tables_, object_index::rpdo_mapping, object_index::rpdo_mapping_last);
  const bool produces =
      detail::count_objects(tables_, object_index::scanner_list, object_index::scanner_list_last) !=
          0 ||
      detail::has_mpdo(tables_, object_index::tpdo_mapping, object_index::tpdo_mapping_last);
  if (rpdos_ && consumes) mpdo_consumer_.emplace(*node_, *rpdos_);
  if (!tpdos_ || !produces) return;
  scanned_objects_.resize(detail::count_mpdo_values(tables_));
  mpdo_queue_.resize(mpdo_queue_max);
  mpdo_producer_.emplace(*node_, *tpdos_, scanned_objects_, mpdo_queue_);
}

}  // namespace canvoy
