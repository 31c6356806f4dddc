#include "canvoy/can/host/host_bus.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/can/host/socketcan.hpp"
#include "canvoy/can/host/socketcand.hpp"
#include "canvoy/can/host/udp_multicast.hpp"

namespace canvoy::host {

HostBus::HostBus(EventLoop& loop, std::unique_ptr<Carrier> carrier)
    : loop_(loop), carrier_(std::move(carrier)) {
  CarrierEvents events;
  events.frame = decltype(events.frame)::to<&HostBus::frame_arrived>(*this);
  events.state = decltype(events.state)::to<&HostBus::state_changed>(*this);
  events.writable = decltype(events.writable)::to<&HostBus::flush>(*this);
  events.trouble = decltype(events.trouble)::to<&HostBus::trouble>(*this);
  carrier_->connect(events);
}

HostBus::~HostBus() {
  loop_.cancel(filter_due_);
}

BusCounters HostBus::counters() const {
  BusCounters counters = counters_;
  counters.carrier = carrier_->counters();
  return counters;
}

HostBus::Endpoint& HostBus::join() {
  Endpoint& endpoint = *endpoints_.emplace_back(std::make_unique<Endpoint>(*this));
  filter();
  return endpoint;
}

void HostBus::leave(Endpoint& endpoint) {
  endpoint.left_ = true;
  endpoint.member_ = {};
  seats_left_ = true;
  echoes_.forget_sender(&endpoint);
  queue_.forget_sender(&endpoint);
  filter_later();
  sweep();
}

// An endpoint that left is kept while a round over the endpoints may refer to it.
void HostBus::sweep() {
  if (rounds_ > 0 || !seats_left_) return;
  std::erase_if(endpoints_,
                [](const std::unique_ptr<Endpoint>& endpoint) { return endpoint->left_; });
  seats_left_ = false;
}

void HostBus::on_frame(std::function<void(const BusFrame&)> observer) {
  frame_observers_.push_back(std::move(observer));
  filter();
}

bool HostBus::wants_all() const {
  const auto is_open = [](const auto& endpoint) {
    return !endpoint->left_ && !endpoint->filtering_;
  };
  return !frame_observers_.empty() || endpoints_.empty() ||
         std::ranges::any_of(endpoints_, is_open);
}

/// Sets the filter of the carrier to the identifiers that the members need.
void HostBus::filter() {
  if (wants_all()) {
    if (std::exchange(filters_, false)) carrier_->accept(nullptr);
    return;
  }
  AcceptedIds wanted = sent_;
  for (const std::unique_ptr<Endpoint>& endpoint : endpoints_) {
    if (!endpoint->left_) wanted |= endpoint->wanted_;
  }
  if (std::exchange(filters_, true) && wanted == accepted_) return;
  accepted_ = wanted;
  carrier_->accept(&accepted_);
}

/// Postponed: unneeded frames may still come for a while, and a node sets one identifier after the
/// other at its start.
void HostBus::filter_later() {
  if (filter_due_ != 0) return;
  filter_due_ = loop_.at(loop_.now(), [this](Time) {
    filter_due_ = 0;
    filter();
  });
}

void HostBus::wants(std::uint16_t id) {
  const bool is_missed = filters_ && !accepted_[id];
  is_missed ? filter() : filter_later();
}

void HostBus::on_state(std::function<void(BusState, Time)> observer) {
  state_observers_.push_back(std::move(observer));
}

void HostBus::on_trouble(std::function<void(const Error&)> observer) {
  trouble_observers_.push_back(std::move(observer));
}

bool HostBus::send_for(Endpoint* sender, const Frame& frame) {
  const bool waits = !queue_.empty();
  const bool taken =
      state_ != BusState::bus_off && (waits ? !queue_.full() : transmit({frame, sender}));
  if (taken && waits) queue_.push({frame, sender});
  if (!taken) {
    ++counters_.refused;
    if (sender != nullptr) sender->refused_ = true;
  }
  return taken;
}

// Called with an empty queue only. True if the frame is sent, or waits.
bool HostBus::transmit(const SentFrame& sent) {
  switch (give(sent.frame)) {
    case SendResult::sent:
      echoes_.push(sent);
      return true;
    case SendResult::busy:
      queue_.push(sent);
      return true;
    case SendResult::refused:
      break;
  }
  return false;
}

SendResult HostBus::give(const Frame& frame) {
  if (!frame.is_extended() && !sent_[frame.id]) {
    sent_[frame.id] = true;
    wants(static_cast<std::uint16_t>(frame.id));
  }
  return carrier_->send(frame);
}

void HostBus::flush() {
  while (!queue_.empty() && state_ != BusState::bus_off) {
    const SendResult result = give(queue_[0].frame);
    if (result == SendResult::busy) break;
    if (result == SendResult::sent) echoes_.push(queue_[0]);
    if (result == SendResult::refused) ++counters_.dropped;
    queue_.pop();
  }
  if (queue_.size() <= SendQueue::capacity / 2) offer_room();
}

void HostBus::offer_room() {
  each_endpoint([this](Endpoint& endpoint) {
    if (!std::exchange(endpoint.refused_, false)) return;
    endpoint.member_.tx_ready(member_time(loop_.now()));
  });
}

void HostBus::frame_arrived(const Frame& frame, Time time, Origin origin) {
  for (std::size_t i = 0; i < frame_observers_.size(); ++i)
    frame_observers_[i]({frame, time, origin});
  if (frame.is_error()) return;
  if (origin == Origin::elsewhere) {
    ++counters_.received;
    return deliver(frame, time, nullptr);
  }
  ++counters_.sent;
  const std::optional<const void*> sender = echoes_.take(frame);
  if (sender) return deliver(frame, time, *sender);
  ++counters_.unknown_echo;
}

void HostBus::deliver(const Frame& frame, Time time, const void* sender) {
  const Time heard_at = member_time(time);
  each_endpoint([&](Endpoint& endpoint) {
    if (&endpoint != sender && endpoint.wants(frame)) endpoint.member_.receive(frame, heard_at);
  });
}

// Frames in transit are lost with the bus, as in a controller that goes bus-off; the nodes are
// notified by their state.
void HostBus::state_changed(BusState state, Time time) {
  if (state == state_) return;
  const bool back = state_ == BusState::bus_off;
  state_ = state;
  if (state == BusState::bus_off) {
    counters_.dropped += queue_.size() + echoes_.size();
    queue_.clear();
    echoes_.clear();
  }
  for (std::size_t i = 0; i < state_observers_.size(); ++i) state_observers_[i](state, time);
  const Time told_at = member_time(time);
  each_endpoint([&](Endpoint& endpoint) { endpoint.member_.bus_state(state, told_at); });
  if (back) flush();
}

void HostBus::trouble(const Error& error) {
  for (std::size_t i = 0; i < trouble_observers_.size(); ++i) trouble_observers_[i](error);
}

// Members may join and leave meanwhile: new members are not served in this round.
template <class Action>
void HostBus::each_endpoint(Action action) {
  const std::size_t count = endpoints_.size();
  ++rounds_;
  for (std::size_t i = 0; i < count; ++i) {
    check_invariant(i < endpoints_.size());
    Endpoint& endpoint = *endpoints_[i];
    if (!endpoint.left_) action(endpoint);
  }
  --rounds_;
  sweep();
}

// A stamp may be earlier than the time a node was advanced to, and after a step of the wall clock
// also in the future.
Time HostBus::member_time(Time stamp) {
  const Time earliest = std::max(member_time_, loop_.advanced_to());
  member_time_ = std::max(earliest, std::min(stamp, loop_.now()));
  return member_time_;
}

Port HostBus::Endpoint::port() {
  Port port;
  port.context = this;
  port.send = [](void* context, const Frame& frame) {
    Endpoint& endpoint = *static_cast<Endpoint*>(context);
    return endpoint.bus_->send_for(&endpoint, frame);
  };
  port.accept = [](void* context, std::uint16_t id, bool wanted) {
    Endpoint& endpoint = *static_cast<Endpoint*>(context);
    endpoint.filtering_ = true;
    if (id > Frame::id_max) return;
    endpoint.wanted_[id] = wanted;
    wanted ? endpoint.bus_->wants(id) : endpoint.bus_->filter_later();
  };
  return port;
}

Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, const BusAddress& address) {
  if (address.kind == BusType::simulated) {
    return Error{"sim", "the simulated bus lives in one process only",
                 "give a bus that programs share: can0, vcan0, udp: or tcp:"};
  }
  Result<std::unique_ptr<Carrier>> carrier =
      address.kind == BusType::socketcan    ? SocketCan::open(loop, address.interface)
      : address.kind == BusType::socketcand ? Socketcand::open(loop, address)
                                            : UdpMulticast::open(loop, address.udp);
  if (!carrier) return carrier.error();
  return std::make_unique<HostBus>(loop, std::move(*carrier));
}

Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, std::string_view address) {
  const Result<BusAddress> parsed = parse_bus_address(address);
  if (!parsed) return parsed.error();
  return open_bus(loop, *parsed);
}

}  // namespace canvoy::host
