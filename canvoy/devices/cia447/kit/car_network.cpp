#include "canvoy/devices/cia447/kit/car_network.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint32_t off = 0x8000'0000;
constexpr std::uint32_t not_on_request = 0x4000'0000;
constexpr std::uint16_t first_mesh_server = object_index::sdo_server + 1;
constexpr std::uint16_t first_mesh_client = object_index::sdo_client;
constexpr std::uint16_t error_control = 0x700;
constexpr std::uint16_t default_request = 0x600;
constexpr unsigned offset_mask = pdos_per_node - 1;

bool is_in(const Dictionary& dictionary, std::uint16_t index) {
  return static_cast<bool>(dictionary.find(index, 1));
}

/// Sender of the PDO with this CAN-ID; 0: none.
NodeId sender_of(std::uint32_t can_id) {
  for (unsigned node = 1; node <= node_id_max; ++node) {
    if (pdo_base(node) == (can_id & ~offset_mask)) return static_cast<NodeId>(node);
  }
  return 0;
}

}  // namespace

/// Folded tables may have one shape for an object of the profile and another one.
AbortCode check_car_number(const DictionaryTables& tables, const EntryShape& row,
                           const std::uint8_t* value) {
  constexpr unsigned first_of_profile = 0x6000;
  const AbortCode answer = check_number(tables, row, value);
  if (answer != AbortCode::value_too_low && answer != AbortCode::value_too_high) return answer;
  const auto place = static_cast<std::size_t>(&row - tables.entries.data());
  const bool is_of_profile = std::ranges::any_of(tables.objects, [&](const ObjectRow& object) {
    return object.index >= first_of_profile && place >= object.entry_first &&
           place - object.entry_first < object.entry_count;
  });
  return is_of_profile ? AbortCode::value_range : answer;
}

constexpr AccessHandlers CarNetwork::hook_calls = {
    .first = object_index::sdo_client,
    .last = object_index::sdo_client_last,
    .before_write = method<&CarNetwork::check_client>};
constexpr ServiceHandlers CarNetwork::service_calls = {.hooks = {&hook_calls, 1}};

CarNetwork::CarNetwork(Node& node, const CarNetworkSettings& settings)
    : node_(node),
      settings_(settings),
      timer_(callback<&CarNetwork::look>(*this)),
      gaps_(node, callback<&CarNetwork::missed>(*this), rhythms_) {
  node.attach(service_);
  next_restored_ = node.on_defaults_restored(callback<&CarNetwork::defaults_restored>(*this));
  const auto heard = Callback<void(const Frame&, Time)>::to<&CarNetwork::error_control_came>(*this);
  for (unsigned other = 1; other <= node_id_max; ++other) {
    node.router().add(static_cast<std::uint16_t>(error_control + other), heard);
  }
}

/// Called before any service of the node is notified of the reset: so its routes come after these,
/// and the client is known when its request is executed.
void CarNetwork::defaults_restored(ResetScope scope) {
  if (next_restored_) next_restored_(scope);
  listen_to_pdos();
  listen_to_requests();
  set_pdo_ids();
  set_sdo_ids();
}

/// An RPDO is received as that of the gateway; from another node it is passed on with that CAN-ID.
void CarNetwork::listen_to_pdos() {
  if (listens_to_pdos_) return;
  listens_to_pdos_ = true;
  const auto came = Callback<void(const Frame&, Time)>::to<&CarNetwork::pdo_came>(*this);
  for (std::size_t i = 0; i < predefined.size(); ++i) {
    const auto index =
        static_cast<std::uint16_t>(object_index::rpdo_parameter + predefined[i].number - 1);
    if (!is_in(node_.dictionary(), index)) continue;
    for (unsigned sender = 1; sender <= node_id_max; ++sender) {
      node_.router().add(static_cast<std::uint16_t>(pdo_base(sender) + settings_.pdo_offsets[i]),
                         came);
    }
  }
}

void CarNetwork::pdo_came(const Frame& frame, Time now) {
  if (hands_on_) return;
  is_request_ = false;
  const NodeId sender = sender_of(frame.id);
  for (std::size_t i = 0; i < predefined.size(); ++i) {
    if (settings_.pdo_offsets[i] == (frame.id & offset_mask)) sources_[i] = sender;
  }
  if (sender == gateway_node_id) return;
  Frame as_of_gateway = frame;
  as_of_gateway.id = pdo_base(gateway_node_id) + (frame.id & offset_mask);
  // Passes it at once to the receiver, which may meanwhile ask for its sender.
  hands_on_ = true;
  if constexpr (is_small_machine) {
    node_.receive(as_of_gateway, now);  // its RPDOs have no routes
  } else {
    node_.router().dispatch(as_of_gateway, now);
  }
  hands_on_ = false;
}

NodeId CarNetwork::source_of(unsigned pdo_number) const {
  for (std::size_t i = 0; i < predefined.size(); ++i) {
    if (predefined[i].number == pdo_number) return sources_[i];
  }
  return 0;
}

void CarNetwork::listen_to_requests() {
  if (node_.id() == listens_as_) return;
  const auto came = Callback<void(const Frame&, Time)>::to<&CarNetwork::request_came>(*this);
  const auto each_request = [](NodeId server, auto change) {
    if (server == 0) return;
    change(static_cast<std::uint16_t>(default_request + server));
    if (!is_node_id(server)) return;
    for (unsigned client = 1; client <= node_id_max; ++client) {
      if (client != server) change(static_cast<std::uint16_t>(sdo_request(client, server)));
    }
  };
  each_request(listens_as_, [&](std::uint16_t id) { node_.router().remove(id, came); });
  listens_as_ = canvoy::is_node_id(node_.id()) ? node_.id() : NodeId{0};
  each_request(listens_as_, [&](std::uint16_t id) { node_.router().add(id, came); });
}

void CarNetwork::request_came(const Frame& frame, Time) {
  is_request_ = true;
  mesh_client_ = 0;
  for (unsigned client = 1; client <= node_id_max; ++client) {
    if (sdo_request(client, node_.id()) == frame.id) mesh_client_ = static_cast<NodeId>(client);
  }
  client_ = mesh_client_ == 0 ? NodeId{gateway_node_id} : mesh_client_;
}

/// PDOs are valid for node-IDs 1 to 16 only: others have no CAN-IDs.
void CarNetwork::set_pdo_ids() {
  Dictionary& dictionary = node_.dictionary();
  const bool is_one = is_node_id(node_.id());
  for (std::size_t i = 0; i < predefined.size(); ++i) {
    const unsigned number = predefined[i].number - 1U;
    const std::uint32_t offset = settings_.pdo_offsets[i];
    dictionary.set_number(static_cast<std::uint16_t>(object_index::tpdo_parameter + number), 1,
                          is_one ? (pdo_base(node_.id()) + offset) | not_on_request : off);
    dictionary.set_number(static_cast<std::uint16_t>(object_index::rpdo_parameter + number), 1,
                          pdo_base(gateway_node_id) + offset);
  }
}

/// The server for client n is 1200h + n; the one for the node itself is off, since that CAN-ID
/// carries ISO-TP. As a client, the node accesses server n by 127Fh + n: SdoClient(node, n - 1).
void CarNetwork::set_sdo_ids() {
  Dictionary& dictionary = node_.dictionary();
  for (unsigned client = 1; client <= node_id_max; ++client) {
    const auto index = static_cast<std::uint16_t>(first_mesh_server + client - 1);
    const bool is_one = is_node_id(node_.id()) && client != node_.id();
    dictionary.set_number(index, 1, is_one ? sdo_request(client, node_.id()) : off);
    dictionary.set_number(index, 2, is_one ? sdo_response(client, node_.id()) : off);
    dictionary.set_number(index, 3, client);
  }
  for (unsigned server = 1; server <= node_id_max; ++server) {
    const auto index = static_cast<std::uint16_t>(first_mesh_client + server - 1);
    const bool is_one = is_node_id(node_.id()) && server != node_.id();
    dictionary.set_number(index, 1, is_one ? sdo_request(node_.id(), server) : off);
    dictionary.set_number(index, 2, is_one ? sdo_response(node_.id(), server) : off);
    dictionary.set_number(index, 3, server);
  }
}

void CarNetwork::watch(NodeId node) {
  if (!is_node_id(node) || watched_[node]) return;
  watched_[node] = true;
  last_heard_[node] = node_.now();
  look(node_.now());
}

void CarNetwork::error_control_came(const Frame& frame, Time now) {
  if (frame.length != 1) return node_.count_malformed();
  const auto node = static_cast<NodeId>(frame.id - error_control);
  constexpr std::uint8_t boot_up = 0;
  const std::uint8_t state = frame.data[0];
  last_heard_[node] = now;
  if (state == boot_up && watched_[node]) lose(node);
  gaps_.heard(node, remote_state(state));
  if (heard_) heard_(node, state);
}

void CarNetwork::look(Time now) {
  Time next = never;
  for (unsigned node = 1; node <= node_id_max; ++node) {
    if (!watched_[node]) continue;
    const Time due = last_heard_[node] + settings_.time_out;
    if (due <= now) {
      lose(static_cast<NodeId>(node));
    } else {
      next = std::min(next, due);
    }
  }
  if (next != never) node_.timers().arm(timer_, next);
}

void CarNetwork::lose(NodeId node) {
  watched_[node] = false;
  if (lost_) lost_(node);
}

}  // namespace canvoy::cia447
