// A node with all services that its dictionary needs, in memory laid out at compile time.
//
// If the dictionary has no SYNC, TIME, node guarding, PDOs, heartbeat or emergency consumers, their
// services are neither in the object nor linked. A dictionary that lacks what CiA 301 requires of
// every device, or of the services that it claims, does not compile (mandatory_objects.hpp).
//
//     constexpr auto layout = lay_out_device<my_charger>();
//     DeviceNode<layout> device(port, 5);
//     device.node().start(now);
//
// On a small machine, what is known at compile time needs no code to be constructed:
//
//     constinit DeviceServices<layout>::Memory memory{};
//     constinit DeviceServices<layout> device{memory, port, 5};
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "canvoy/canopen/device/mandatory_objects.hpp"
#include "canvoy/canopen/device/verify_configuration.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/dictionary/folded_tables.hpp"
#include "canvoy/canopen/dictionary/initial_values.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/emergency/collision_watch.hpp"
#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/nmt/error_behaviour.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/nmt/heartbeat_producer.hpp"
#include "canvoy/canopen/nmt/node_guarding_slave.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/mpdo_consumer.hpp"
#include "canvoy/canopen/pdo/mpdo_producer.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/sdo/sdo_entry.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/sync/high_resolution_time.hpp"
#include "canvoy/canopen/sync/sync.hpp"
#include "canvoy/canopen/sync/time_stamp.hpp"

namespace canvoy {

namespace detail {

/// Number of objects in a dictionary from index `first` to `last`.
constexpr std::size_t count_objects(const DictionaryTables& tables, unsigned first, unsigned last) {
  std::size_t count = 0;
  for (const ObjectRow& row : tables.objects) {
    const unsigned end = std::min(row.index + unsigned{row.count}, last + 1);
    const unsigned begin = std::max(unsigned{row.index}, first);
    if (begin < end) count += end - begin;
  }
  return count;
}

constexpr bool has_object(const DictionaryTables& tables, unsigned index) {
  return count_objects(tables, index, index) != 0;
}

/// True if masters cannot write any parameter of SYNC and its CAN-ID is allowed.
constexpr bool has_constant_sync(const DictionaryTables& tables) {
  const DescribedEntry cob_id = find_described(tables, object_index::cob_id_sync, 0);
  return are_constant(tables, object_index::cob_id_sync, object_index::sync_window) &&
         are_constant(tables, object_index::sync_counter_overflow,
                      object_index::sync_counter_overflow) &&
         (cob_id.row == nullptr || has_free_id(CobId{cob_id.initial}));
}

/// The PDOs with parameters from index `first` to `last`, from the lowest number to the highest.
/// Numbers between them that the device does not have exist, but are disabled.
struct PdoNumbers {
  std::uint16_t lowest = 1;
  std::uint16_t count = 0;
};
constexpr PdoNumbers pdo_numbers(const DictionaryTables& tables, unsigned first, unsigned last) {
  PdoNumbers numbers;
  for (const ObjectRow& row : tables.objects) {
    if (row.index < first || row.index > last) continue;
    const unsigned lowest = row.index - first + 1;
    if (numbers.count == 0) numbers.lowest = static_cast<std::uint16_t>(lowest);
    numbers.count = static_cast<std::uint16_t>(lowest + row.count - numbers.lowest);
  }
  return numbers;
}

/// Highest sub-index of these objects; 0 if there are none.
constexpr std::size_t highest_sub_index(const DictionaryTables& tables, unsigned first,
                                        unsigned last) {
  std::size_t highest = 0;
  for (const ObjectRow& row : tables.objects) {
    if (row.index < first || row.index > last || row.entry_count == 0) continue;
    highest = std::max<std::size_t>(highest, tables.entries_of(row).back().sub_last);
  }
  return highest;
}

constexpr std::size_t highest_sub_index(const DictionaryTables& tables, unsigned index) {
  return highest_sub_index(tables, index, index);
}

/// True if one of these PDO mapping records makes a multiplexed PDO by default.
constexpr bool has_mpdo(const DictionaryTables& tables, unsigned first, unsigned last) {
  for (const ObjectRow& row : tables.objects) {
    for (unsigned i = 0; i < row.count; ++i) {
      const unsigned index = row.index + i;
      if (index < first || index > last) continue;
      const DescribedEntry count = find_described(tables, index, 0);
      if (count.row != nullptr && mpdo_mode(count.initial) != MpdoMode::none) return true;
    }
  }
  return false;
}

/// Number of values that a multiplexed PDO can carry.
constexpr std::size_t count_mpdo_values(const DictionaryTables& tables) {
  std::size_t count = 0;
  for (const ObjectRow& row : tables.objects) {
    for (const EntryShape& entry : tables.entries_of(row)) {
      const unsigned length = byte_length(entry.type);
      if (length == 0 || length > mpdo_data_max || !allows(entry.access, Access::tpdo)) continue;
      count += std::size_t{row.count} * (entry.sub_last - entry.sub_first + 1U);
    }
  }
  return count;
}

/// Tables with the check of numbers that the type of their layout has (`number_check`), if it has
/// one; the layout itself takes no memory for it.
template <class Layout>
constexpr DictionaryTables with_number_check(DictionaryTables tables) {
  if constexpr (requires { Layout::number_check; }) tables.check_number = Layout::number_check;
  return tables;
}

/// Tables in which a node of this layout looks up entries.
template <const auto& layout, bool is_folded = is_small_machine>
struct TablesOf {
  static constexpr DictionaryTables value =
      with_number_check<std::remove_cvref_t<decltype(layout)>>(
          tables_with_initial_values<layout>());
};
template <const auto& layout>
struct TablesOf<layout, true> {
  static constexpr auto folded = fold_tables<layout>();
  static constexpr DictionaryTables value =
      with_number_check<std::remove_cvref_t<decltype(layout)>>(folded.tables());
};

/// Memory for `count` items, or no member at all: even an empty array takes space.
template <class Item, std::size_t count>
struct Room {
  std::array<Item, count> items;
  constexpr std::span<Item> span() { return items; }
};
template <class Item>
struct Room<Item, 0> {
  constexpr std::span<Item> span() { return {}; }
};

/// A service, or an empty placeholder.
template <class Type, bool present>
struct Optional {
  template <class... Arguments>
  constexpr explicit Optional(Arguments&&... arguments)
      : service(std::forward<Arguments>(arguments)...) {}
  constexpr Type* get() { return &service; }
  constexpr Type& operator*() { return service; }

  Type service;
};
template <class Type>
struct Optional<Type, false> {
  template <class... Arguments>
  constexpr explicit Optional(Arguments&&...) {}
  constexpr Type* get() { return nullptr; }
  /// For another service that is absent too.
  constexpr Optional& operator*() { return *this; }
};

}  // namespace detail

/// The services of a device. `layout` is a DictionaryLayout of static storage. `own_routes` is the
/// number of CAN-IDs that the application's services need (SDO clients, an NMT master, emergency
/// consumers). Without `sdo_blocks`, SDO servers have no block transfer, and clients use segmented
/// transfer. `backlog_max` frames wait while the controller is full. `errors_max` limits the errors
/// present at a time, and the emergency messages that wait.
///
/// Contains everything but the memory, which must outlive it; DeviceNode has both.
template <const auto& layout, std::size_t own_routes = 0, bool sdo_blocks = true,
          std::size_t backlog_max = 16, std::size_t errors_max = 8>
class DeviceServices {
  static_assert(detail::WholeDevice<layout>::is_whole);

 public:
  /// Tables that the node looks entries up in; made at compile time from `layout`.
  static constexpr DictionaryTables tables = detail::TablesOf<layout>::value;

  /// RPDOs by their parameters, 1400h to 15FFh: the lowest number, and how many from there on.
  static constexpr detail::PdoNumbers rpdo_numbers =
      detail::pdo_numbers(tables, object_index::rpdo_parameter, object_index::rpdo_parameter_last);
  /// TPDOs by their parameters, 1800h to 19FFh: the lowest number, and how many from there on.
  static constexpr detail::PdoNumbers tpdo_numbers =
      detail::pdo_numbers(tables, object_index::tpdo_parameter, object_index::tpdo_parameter_last);
  /// Numbers that are not in the dictionary included.
  static constexpr std::size_t rpdo_count = rpdo_numbers.count;
  /// Numbers that are not in the dictionary included.
  static constexpr std::size_t tpdo_count = tpdo_numbers.count;
  /// SDO servers: the default one, which needs no object, and one for each of 1201h to 127Fh.
  static constexpr std::size_t sdo_servers =
      1 +
      detail::count_objects(tables, object_index::sdo_server + 1, object_index::sdo_server_last);
  /// Nodes that can be monitored: the highest sub-index of 1016h.
  static constexpr std::size_t heartbeats =
      detail::highest_sub_index(tables, object_index::heartbeat_consumers);
  /// Number of emergency consumers: 1028h has a sub-index for each node-ID.
  static constexpr std::size_t emergencies =
      detail::highest_sub_index(tables, object_index::emergency_consumers);
  /// True with 100Ch: the node answers node guarding, and monitors the master.
  static constexpr bool has_guarding = detail::has_object(tables, object_index::guard_time);
  /// True with 1012h: the node takes or sends TIME messages.
  static constexpr bool has_time = detail::has_object(tables, object_index::cob_id_time);
  /// True with 1013h: TIME is refined by the high resolution time stamp of a SYNC producer.
  static constexpr bool has_high_resolution =
      detail::has_object(tables, object_index::high_resolution_time);
  /// True if there are lists for source address mode, or a PDO is multiplexed by default.
  static constexpr bool has_mpdo_consumer =
      rpdo_count > 0 &&
      (detail::count_objects(tables, object_index::dispatching_list,
                             object_index::dispatching_list_last) != 0 ||
       detail::has_mpdo(tables, object_index::rpdo_mapping, object_index::rpdo_mapping_last));
  /// True if there are scanner lists, or a TPDO is multiplexed by default.
  static constexpr bool has_mpdo_producer =
      tpdo_count > 0 &&
      (detail::count_objects(tables, object_index::scanner_list, object_index::scanner_list_last) !=
           0 ||
       detail::has_mpdo(tables, object_index::tpdo_mapping, object_index::tpdo_mapping_last));
  /// Where the records of RPDOs stand in the tables.
  static constexpr PdoRecords rpdo_records = pdo_records(tables, PdoDirection::receive);
  /// Where the records of TPDOs stand in the tables.
  static constexpr PdoRecords tpdo_records = pdo_records(tables, PdoDirection::transmit);
  /// Parts of SYNC that the dictionary needs: whether its objects can be written, and whether the
  /// node may produce SYNC (1006h).
  static constexpr Sync::Objects sync_objects = {
      .writable = !detail::has_constant_sync(tables),
      .period = detail::has_object(tables, object_index::sync_period)};
  /// True with 1005h.
  static constexpr bool has_sync = detail::has_object(tables, object_index::cob_id_sync);
  /// True with 1029h; without it, a communication error leads from operational to pre-operational.
  static constexpr bool has_error_behaviour =
      detail::has_object(tables, object_index::error_behaviour);
  /// True with 1020h.
  static constexpr bool has_verification =
      detail::has_object(tables, object_index::verify_configuration);

 private:
  /// CAN-IDs that this node alone sends.
  static constexpr std::size_t watched_ids =
      is_small_machine ? 0 : CollisionWatch::ids_beside_tpdos + tpdo_count;
  /// On a small machine, NMT, SYNC, SDO servers and PDOs need no routes.
  static constexpr std::size_t routes_max =
      has_time + has_guarding + heartbeats + emergencies + own_routes + watched_ids +
      (is_small_machine ? 0 : 2 + sdo_servers + rpdo_count + tpdo_count);
  static constexpr std::size_t sdo_block_servers = sdo_blocks ? sdo_servers : 0;
  static constexpr std::size_t sdo_buffer_bytes = sdo_buffer_size(tables);
  static constexpr std::size_t rpdo_values =
      !Pdo::has_plans ? 0
                      : rpdo_count * detail::highest_sub_index(tables, object_index::rpdo_mapping,
                                                               object_index::rpdo_mapping_last);
  static constexpr std::size_t tpdo_values =
      !Pdo::has_plans ? 0
                      : tpdo_count * detail::highest_sub_index(tables, object_index::tpdo_mapping,
                                                               object_index::tpdo_mapping_last);

  /// Every value can be in a scanner list once.
  static constexpr std::size_t scanned_objects =
      detail::count_objects(tables, object_index::scanner_list, object_index::scanner_list_last) !=
              0
          ? detail::count_mpdo_values(tables)
          : 0;
  static constexpr std::size_t mpdo_queue_max = has_mpdo_producer ? 4 : 0;

  static constexpr std::size_t states_max = is_small_machine ? 0 : tables.objects.size();

 public:
  /// The memory, initially zero.
  struct Memory {
    std::array<std::uint8_t, tables.value_bytes> values;  ///< of all entries
    /// One for each ObjectRow; none on a small machine.
    [[no_unique_address]] detail::Room<ObjectState, states_max> states;
    /// One for each CAN-ID that is listened to.
    [[no_unique_address]] detail::Room<Router::Route, routes_max> routes;
    std::array<Frame, backlog_max> backlog;  ///< frames that wait for the controller
    /// Values longer than one frame, in transfer.
    std::array<std::array<std::uint8_t, sdo_buffer_bytes>, sdo_servers> sdo_buffers;
    std::array<Error, errors_max> errors;           ///< errors present
    std::array<Emergency, errors_max> emergencies;  ///< messages that wait
    /// One for each sub-index of 1016h.
    [[no_unique_address]] detail::Room<HeartbeatConsumer::Slot, heartbeats> heartbeat_slots;
    /// One for each sub-index of 1028h.
    [[no_unique_address]] detail::Room<EmergencyConsumer::Slot, DeviceServices::emergencies>
        emergency_slots;
    [[no_unique_address]] detail::Room<Rpdo, rpdo_count> rpdos;  ///< by number, without gaps
    [[no_unique_address]] detail::Room<Tpdo, tpdo_count> tpdos;  ///< by number, without gaps
    /// Mapped values of all RPDOs.
    [[no_unique_address]] detail::Room<MappedValue, rpdo_values> mapped_by_rpdos;
    /// Mapped values of all TPDOs.
    [[no_unique_address]] detail::Room<MappedValue, tpdo_values> mapped_by_tpdos;
    /// Values in scanner lists.
    [[no_unique_address]] detail::Room<ScannedObject, scanned_objects> scanned;
    /// Multiplexed PDOs that wait.
    [[no_unique_address]] detail::Room<MpdoProducer::Message, mpdo_queue_max> mpdo_queue;
    /// CAN-IDs of the node that no other may use; none on a small machine.
    [[no_unique_address]] detail::Room<CollisionWatch::Slot, watched_ids> own_ids;
  };

  /// Makes the services. `node_id` and `autostart` are as for Node. `port` is copied; its context
  /// must outlive this object.
  constexpr DeviceServices(Memory& memory, const Port& port, NodeId node_id, bool autostart = false)
      : node_(tables, {memory.values, memory.states.span(), memory.routes.span(), memory.backlog},
              port, node_id, autostart),
        sdo_servers_(node_, memory, std::make_index_sequence<sdo_servers>{}),
        sdo_block_servers_(sdo_servers_.all, std::make_index_sequence<sdo_block_servers>{}),
        emergency_producer_(node_, memory.errors, memory.emergencies,
                            !detail::are_constant(tables, object_index::cob_id_emergency,
                                                  object_index::emergency_inhibit_time)),
        error_behaviour_(node_, has_error_behaviour),
        heartbeat_producer_(node_),
        heartbeat_consumer_(node_, memory.heartbeat_slots.span()),
        emergency_consumer_(node_, memory.emergency_slots.span()),
        node_guarding_(node_),
        time_stamp_(node_),
        sync_(node_, sync_objects),
        verify_configuration_(node_),
        high_resolution_time_(node_, sync_.get()),
        rpdos_(node_, memory.rpdos.span(), memory.mapped_by_rpdos.span(), sync_.get(),
               rpdo_numbers.lowest, rpdo_records),
        tpdos_(node_, memory.tpdos.span(), memory.mapped_by_tpdos.span(), sync_.get(),
               Tpdos::AtStart::send, tpdo_numbers.lowest, tpdo_records),
        mpdo_consumer_(node_, *rpdos_),
        mpdo_producer_(node_, *tpdos_, memory.scanned.span(), memory.mpdo_queue.span()),
        collision_watch_(node_, memory.own_ids.span(), tpdo_numbers.lowest) {}
  DeviceServices(const DeviceServices&) = delete;
  DeviceServices& operator=(const DeviceServices&) = delete;

  /// The node itself: frames and points in time are handed to it.
  constexpr Node& node() { return node_; }
  /// The node, for its states and counters.
  const Node& node() const { return node_; }
  /// Object dictionary with the present values; the same as node().dictionary().
  Dictionary& dictionary() { return node_.dictionary(); }
  /// Sends errors that the application raises, and keeps 1001h and 1003h.
  EmergencyProducer& emergency_producer() { return emergency_producer_; }
  /// Changes the NMT state after an error, by 1029h or its default.
  ErrorBehaviour& error_behaviour() { return error_behaviour_; }
  /// Monitors other nodes. Exists if the dictionary has 1016h with at least one sub-index.
  HeartbeatConsumer& heartbeat_consumer()
    requires(heartbeats > 0)
  {
    return heartbeat_consumer_.service;
  }
  /// Receives emergency messages of other nodes. Exists if the dictionary has 1028h.
  EmergencyConsumer& emergency_consumer()
    requires(emergencies > 0)
  {
    return emergency_consumer_.service;
  }
  /// Answers node guarding. Exists if the dictionary has 100Ch.
  NodeGuardingSlave& node_guarding()
    requires has_guarding
  {
    return node_guarding_.service;
  }
  /// Receives or sends TIME. Exists if the dictionary has 1012h.
  TimeStamp& time_stamp()
    requires has_time
  {
    return time_stamp_.service;
  }
  /// Receives or sends SYNC. Exists if the dictionary has 1005h.
  Sync& sync()
    requires has_sync
  {
    return sync_.service;
  }
  /// All RPDOs. Exists if the dictionary has one.
  Rpdos& rpdos()
    requires(rpdo_count > 0)
  {
    return rpdos_.service;
  }
  /// All TPDOs. Exists if the dictionary has one.
  Tpdos& tpdos()
    requires(tpdo_count > 0)
  {
    return tpdos_.service;
  }
  /// Sends multiplexed PDOs. Exists with has_mpdo_producer.
  MpdoProducer& mpdo_producer()
    requires has_mpdo_producer
  {
    return mpdo_producer_.service;
  }

 private:
  struct SdoServers {
    template <std::size_t... numbers>
    constexpr SdoServers(Node& node, Memory& memory, std::index_sequence<numbers...>)
        : all{{{node, static_cast<std::uint8_t>(numbers), memory.sdo_buffers[numbers]}...}} {}

    std::array<SdoServer, sdo_servers> all;
  };
  struct BlockServers {
    template <std::size_t... numbers>
    constexpr BlockServers(std::array<SdoServer, sdo_servers>& servers,
                           std::index_sequence<numbers...>)
        : all{{{servers[numbers], sdo::block_size_max}...}} {}

    std::array<SdoBlockServer, sdo_blocks ? sdo_servers : 0> all;
  };

  Node node_;
  SdoServers sdo_servers_;
  [[no_unique_address]] detail::Optional<BlockServers, sdo_blocks> sdo_block_servers_;
  // The emergency producer precedes the services that change NMT states after an error, so that the
  // error is sent first.
  EmergencyProducer emergency_producer_;
  ErrorBehaviour error_behaviour_;
  HeartbeatProducer heartbeat_producer_;
  [[no_unique_address]] detail::Optional<HeartbeatConsumer, (heartbeats > 0)> heartbeat_consumer_;
  [[no_unique_address]] detail::Optional<EmergencyConsumer, (emergencies > 0)> emergency_consumer_;
  [[no_unique_address]] detail::Optional<NodeGuardingSlave, has_guarding> node_guarding_;
  [[no_unique_address]] detail::Optional<TimeStamp, has_time> time_stamp_;
  [[no_unique_address]] detail::Optional<Sync, has_sync> sync_;
  [[no_unique_address]] detail::Optional<VerifyConfiguration, has_verification>
      verify_configuration_;
  [[no_unique_address]] detail::Optional<HighResolutionTime, has_high_resolution>
      high_resolution_time_;
  [[no_unique_address]] detail::Optional<Rpdos, (rpdo_count > 0)> rpdos_;
  [[no_unique_address]] detail::Optional<Tpdos, (tpdo_count > 0)> tpdos_;
  [[no_unique_address]] detail::Optional<MpdoConsumer, has_mpdo_consumer> mpdo_consumer_;
  [[no_unique_address]] detail::Optional<MpdoProducer, has_mpdo_producer> mpdo_producer_;
  [[no_unique_address]] detail::Optional<CollisionWatch, !is_small_machine> collision_watch_;
};

namespace detail {

/// A base class, so that the memory is constructed before the services and destroyed after them.
template <class Memory>
struct OwnMemory {
  Memory memory{};
};

}  // namespace detail

/// Like DeviceServices, but with its own memory.
template <const auto& layout, std::size_t own_routes = 0, bool sdo_blocks = true,
          std::size_t backlog_max = 16, std::size_t errors_max = 8>
class DeviceNode
    : private detail::OwnMemory<
          typename DeviceServices<layout, own_routes, sdo_blocks, backlog_max, errors_max>::Memory>,
      public DeviceServices<layout, own_routes, sdo_blocks, backlog_max, errors_max> {
 public:
  /// Makes the device in its own memory. The arguments are those of DeviceServices.
  DeviceNode(const Port& port, NodeId node_id, bool autostart = false)
      : DeviceServices<layout, own_routes, sdo_blocks, backlog_max, errors_max>(
            this->memory, port, node_id, autostart) {}
};

}  // namespace canvoy
