// Who called? The call on 6E0h names nobody, so that all 1F10h are read until requests are found.
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"

namespace canvoy {

/// A call in the middle of a scan has those that were heard asked once more: an answer may have
/// been lost. The scan of the others goes on where it is.
void SdoManager::begin_scan() {
  call_waits_ = has_found_ = false;
  if (!scanning_) to_ask_.reset();
  if (!scanning_) asks_all_ = false;
  scanning_ = true;
  to_ask_ |= heard_;
}

void SdoManager::scan() {
  while (scanning_) {
    const NodeId next = choose();
    if (next != 0 && ask(next)) return;
    if (next != 0) continue;
    scanning_ = !asks_all_ && !has_found_;
    asks_all_ = true;
    to_ask_ = ~heard_;
  }
}

/// First the nodes that were heard of. The others may be silent, or absent, which costs time, and
/// are left out when the device that called is found.
NodeId SdoManager::choose() const {
  for (const bool heard : {true, false}) {
    for (NodeId id = node_id_min; id <= node_id_max; ++id) {
      if (to_ask_[id] && heard_[id] == heard && id != node_.id()) return id;
    }
    if (has_found_) break;
  }
  return 0;
}

bool SdoManager::ask(NodeId node) {
  to_ask_[node] = false;
  asked_ = node;
  buffer_ = {};
  busy_ = true;  // before the answer, which may come at once
  const AbortCode refused =
      client_.upload(node, dynamic_sdo::state, 0, std::span<std::uint8_t>(buffer_),
                     SdoClient::Done::to<&SdoManager::scanned>(*this),
                     heard_[node] ? settings_.time_out : settings_.scan_time_out);
  if (refused != AbortCode::none) busy_ = false;
  return refused == AbortCode::none;
}

void SdoManager::scanned(SdoClient::Outcome outcome) {
  busy_ = false;
  wake();
  if (!outcome || *outcome != buffer_.size()) return;
  const DynamicSdoState state(load<std::uint32_t>(buffer_.data()));
  if (state.is_request()) found(asked_, state);
}

/// A device that registers anew has forgotten what it had, or wants to.
void SdoManager::found(NodeId node, const DynamicSdoState& state) {
  has_found_ = heard_[node] = true;
  for (SdoConnection& connection : connections_) {
    const bool is_used = connection.state != SdoConnection::State::unused;
    if (is_used && connection.client == node) connection.state = SdoConnection::State::ending;
  }
  const SdoConnection wanted{
      .state = SdoConnection::State::requested,
      .client = node,
      .client_channel = static_cast<std::uint8_t>(state.client_parameter - sdo_client_parameter),
      .server = node_.id(),
      .wants_all = state.wants_all};
  if (add(wanted) != nullptr) return;
  // A place is about to come free, perhaps one of its own: it is asked again then.
  call_waits_ = find(SdoConnection::State::ending) != nullptr;
  if (call_waits_) return;
  busy_ = true;
  current_ = nullptr;
  writes_.begin(SdoWriteList::Done::to<&SdoManager::closed>(*this));
  SdoConnection refused = wanted;
  refused.error = DynamicSdoError::no_manager_channel;
  tell(refused, DynamicSdoState::Status::failed);
  writes_.run();
}

}  // namespace canvoy
