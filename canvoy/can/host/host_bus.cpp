#include "canvoy/can/host/host_bus.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/host/socketcan.hpp"
#include "canvoy/can/host/socketcand.hpp"
#include "canvoy/can/host/udp_multicast.hpp"
#include "canvoy/can/must_hold.hpp"

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

HostBus::Seat& HostBus::join() {
  Seat& seat = *seats_.emplace_back(std::make_unique<Seat>(*this));
  filter();
  return seat;
}

void HostBus::leave(Seat& seat) {
  seat.left_ = true;
  seat.member_ = {};
  seats_left_ = true;
  echoes_.forget_sender(&seat);
  queue_.forget_sender(&seat);
  filter_later();
  sweep();
}

// A seat that is left stays as long as a round of the seats may stand on it.
void HostBus::sweep() {
  if (rounds_ > 0 || !seats_left_) return;
  std::erase_if(seats_, [](const std::unique_ptr<Seat>& seat) { return seat->left_; });
  seats_left_ = false;
}

void HostBus::on_frame(std::function<void(const BusFrame&)> observer) {
  frame_observers_.push_back(std::move(observer));
  filter();
}

bool HostBus::wants_all() const {
  const auto is_open = [](const auto& seat) { return !seat->left_ && !seat->filtering_; };
  return !frame_observers_.empty() || seats_.empty() || std::ranges::any_of(seats_, is_open);
}

/// The carrier lets pass what the members want.
void HostBus::filter() {
  if (wants_all()) {
    if (std::exchange(filters_, false)) carrier_->accept(nullptr);
    return;
  }
  AcceptedIds wanted = sent_;
  for (const std::unique_ptr<Seat>& seat : seats_) {
    if (!seat->left_) wanted |= seat->wanted_;
  }
  if (std::exchange(filters_, true) && wanted == accepted_) return;
  accepted_ = wanted;
  carrier_->accept(&accepted_);
}

/// What is no longer wanted may still come for a while, and a node says one identifier after the
/// other when it begins.
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

bool HostBus::send_for(Seat* sender, const Frame& frame) {
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

// Called with an empty queue only. True where the frame is on its way, or waits.
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
  each_seat([this](Seat& seat) {
    if (!std::exchange(seat.refused_, false)) return;
    seat.member_.tx_ready(member_time(loop_.now()));
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
  each_seat([&](Seat& seat) {
    if (&seat != sender && seat.wants(frame)) seat.member_.receive(frame, heard_at);
  });
}

// What was under way is lost with the bus, as in a controller that goes bus-off; the nodes are told
// by their state.
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
  each_seat([&](Seat& seat) { seat.member_.bus_state(state, told_at); });
  if (back) flush();
}

void HostBus::trouble(const Error& error) {
  for (std::size_t i = 0; i < trouble_observers_.size(); ++i) trouble_observers_[i](error);
}

// Members may join and leave meanwhile: those that join now are not served in this round.
template <class Action>
void HostBus::each_seat(Action action) {
  const std::size_t count = seats_.size();
  ++rounds_;
  for (std::size_t i = 0; i < count; ++i) {
    must_hold(i < seats_.size());
    Seat& seat = *seats_[i];
    if (!seat.left_) action(seat);
  }
  --rounds_;
  sweep();
}

// A stamp may be older than what a node was advanced to, and after a step of the wall clock also in
// the future.
Time HostBus::member_time(Time stamp) {
  const Time earliest = std::max(member_time_, loop_.advanced_to());
  member_time_ = std::max(earliest, std::min(stamp, loop_.now()));
  return member_time_;
}

Port HostBus::Seat::port() {
  Port port;
  port.context = this;
  port.send = [](void* context, const Frame& frame) {
    Seat& seat = *static_cast<Seat*>(context);
    return seat.bus_->send_for(&seat, frame);
  };
  port.accept = [](void* context, std::uint16_t id, bool wanted) {
    Seat& seat = *static_cast<Seat*>(context);
    seat.filtering_ = true;
    if (id > Frame::id_max) return;
    seat.wanted_[id] = wanted;
    wanted ? seat.bus_->wants(id) : seat.bus_->filter_later();
  };
  return port;
}

Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, const BusAddress& address) {
  if (address.kind == BusKind::simulated) {
    return Error{"sim", "the simulated bus lives in one process only",
                 "give a bus that programs share: can0, vcan0, udp: or tcp:"};
  }
  Result<std::unique_ptr<Carrier>> carrier =
      address.kind == BusKind::socketcan    ? SocketCan::open(loop, address.interface)
      : address.kind == BusKind::socketcand ? Socketcand::open(loop, address)
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
