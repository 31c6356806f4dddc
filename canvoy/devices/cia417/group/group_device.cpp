#include "canvoy/devices/cia417/group/group_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

std::uint8_t arrows(Direction direction, bool moving) {
  unsigned bits = moving ? arrow_moving : 0U;
  if (direction == Direction::up) bits |= arrow_up;
  if (direction == Direction::down) bits |= arrow_down;
  return static_cast<std::uint8_t>(bits);
}

/// A hall call in the form in which its panel sends it; any lift may answer it.
VirtualInput input_of(const Call& call) {
  const VirtualOutput shown = acknowledgement_of(call, all_lifts, true);
  return {.function = shown.function,
          .sub_function = shown.sub_function,
          .lifts = shown.lifts,
          .floor = shown.floor,
          .doors = shown.doors,
          .data = static_cast<std::uint8_t>(CallRequest::request)};
}

}  // namespace

constexpr AccessHandlers GroupMember::hook_calls[] = {
    after_write<&GroupMember::assigned, group_input_object>,
    after_write<&GroupMember::acknowledged, group_output_object>};
constexpr ServiceHandlers GroupMember::lift_service_calls = {.reset =
                                                                 method<&GroupMember::lift_reset>};
constexpr ServiceHandlers GroupMember::service_calls = {
    .reset = method<&GroupMember::reset>,
    .state_entered = method<&GroupMember::state_entered>,
    .hooks = hook_calls};

GroupMember::GroupMember(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats, Node& lift_node,
                         CallController& calls, LiftController& lift,
                         std::span<std::uint64_t> queue, const GroupMemberSettings& settings)
    : node_(node),
      heartbeats_(heartbeats),
      lift_node_(lift_node),
      calls_(calls),
      lift_(lift),
      queue_(queue),
      settings_(settings),
      call_mapping_(node, tpdos, virtual_input_mapping_object.index,
                    {.waits = callback<&GroupMember::call_waits>(*this),
                     .next = callback<&GroupMember::next_call>(*this)}),
      status_mapping_(node, tpdos, virtual_output_mapping_object.index,
                      {.waits = callback<&GroupMember::status_waits>(*this),
                       .next = callback<&GroupMember::next_status>(*this)}),
      gaps_(node, callback<&GroupMember::report_anew>(*this)) {
  node.attach(service_);
  lift_node.attach(lift_service_);
  heartbeats_.on_change(callback<&GroupMember::group_heard>(*this));
  calls_.on_hall_call(callback<&GroupMember::offer>(*this));
  lift_.on_stop(callback<&GroupMember::stopped>(*this));
  lift_.on_change(callback<&GroupMember::update>(*this));
}

void GroupMember::reset(ResetScope) {
  queue_.clear();
  own_calls_.remove_all();
  is_in_group_ = knows_status_ = false;
  stop_ = {};
}

/// The lift has lost its calls: the group is notified by a full status.
void GroupMember::lift_reset(ResetScope) {
  knows_status_ = false;
}

void GroupMember::state_entered(NmtState state) {
  if (state != NmtState::operational) return join(false);
  join(heartbeats_.state(settings_.group_controller) == RemoteState::operational);
}

void GroupMember::group_heard(NodeId id, RemoteState state) {
  if (id != settings_.group_controller) return;
  join(state == RemoteState::operational && node_.state() == NmtState::operational);
}

/// A group controller that has started has no state of the lift; without one, the calls assigned to
/// the group belong to the lift.
void GroupMember::join(bool is_in_group) {
  if (is_in_group == is_in_group_) return;
  is_in_group_ = is_in_group;
  knows_status_ = false;
  stop_ = {};
  is_inside_ = true;
  if (is_in_group) {
    own_calls_.add_all(calls_.shown(), hall_calls);
    announce();
  } else {
    queue_.clear();
    own_calls_.remove_all();
    calls_.adopt(lift_bit(settings_.lift));
    act_on_lift();
  }
  is_inside_ = false;
}

/// The group cannot request messages that it may have missed: it gets all of them, as when a lift
/// joins it.
void GroupMember::report_anew(NodeId) {
  if (!is_in_group_) return;
  knows_status_ = false;
  own_calls_.add_all(calls_.shown(), hall_calls);
  announce();
}

/// Calls that the panels requested while the lift was alone come last.
std::uint64_t GroupMember::next_call() {
  if (!queue_.empty()) return queue_.pop();
  constexpr LiftCalls none{};
  const Call call = own_calls_.first_difference(none);
  own_calls_.remove(call);
  return encode(input_of(call));
}

bool GroupMember::offer(const VirtualInput& call) {
  if (!is_in_group_ || !queue_.push(encode(call))) return false;
  update();
  return true;
}

void GroupMember::stopped(const Landing& landing, DoorMask doors) {
  stop_ = {landing, doors};
}

/// Called from the lift's bus, or from within a frame of the group's bus.
void GroupMember::update() {
  if (is_inside_) {
    announce();
  } else if (node_.state() == NmtState::operational) {
    node_.advance(lift_node_.now());
    announce();
    node_.advance(lift_node_.now());
  }
  changed_();
}

void GroupMember::announce() {
  if (!is_in_group_) return;
  if (call_waits()) call_mapping_.announce();
  if (status_waits()) status_mapping_.announce();
}

void GroupMember::act_on_lift() {
  lift_node_.advance(node_.now());
  lift_.update();
  lift_node_.advance(node_.now());
}

/// While it is alone, no calls are assigned to it: an assignment shows that the group controller
/// does not yet know that it was alone.
void GroupMember::assigned() {
  if (!is_in_group_) return;
  const auto record = node_.dictionary().number(group_input_object.index, 0);
  is_inside_ = true;
  assign(decode_input(record));
  act_on_lift();
  is_inside_ = false;
}

/// A hall call belongs to one lift: the others remove it. Passengers with the same destination call
/// may have several lifts: a lift that loses them is notified.
void GroupMember::assign(const VirtualInput& call) {
  const bool is_meant = (call.lifts & lift_bit(settings_.lift)) != 0;
  const bool is_mine = is_meant && call.request() == CallRequest::request;
  if (is_hall_call(call.function)) {
    const Call wanted = hall_call_of(call, source_doors(call.doors));
    if (is_mine) {
      calls_.add(wanted);
    } else {
      calls_.withdraw(wanted);
    }
  } else if (is_destination_call(call.function)) {
    if (is_mine) {
      calls_.add_destination(call);
    } else if (is_meant) {
      calls_.withdraw_destination(call);
    }
  }
}

void GroupMember::acknowledged() {
  if (!is_in_group_) return;
  const VirtualOutput record =
      decode_output(node_.dictionary().number(group_output_object.index, 0));
  const bool on = (record.data & 1) != 0;
  const VirtualInput call{record.function, record.sub_function, record.lifts, record.floor,
                          record.doors};
  is_inside_ = true;
  if (is_hall_call(record.function)) {
    const Call wanted = hall_call_of(call, source_doors(record.doors));
    if (!on) calls_.withdraw(wanted);
    if (on || calls_.shows(wanted)) calls_.acknowledge(wanted, on);
  } else if (is_destination_call(record.function)) {
    // The same call may belong to several lifts: a lift that loses it is notified by its
    // assignments.
    calls_.acknowledge_destination(call, on, record.lifts);
  }
  act_on_lift();
  is_inside_ = false;
}

GroupMember::Status GroupMember::status() const {
  return {.floor = lift_.floor(),
          .direction = lift_.direction(),
          .moving = lift_.is_moving(),
          .serves = lift_.takes_hall_calls(),
          .full = lift_.is_full(),
          .car_calls = calls_.calls().floors(car_calls)};
}

bool GroupMember::status_waits() {
  return is_in_group_ && (!knows_status_ || stop_.landing.floor != 0 || told_ != status());
}

/// The stop comes before the changes that it causes.
std::uint64_t GroupMember::next_status() {
  const Status now = status();
  VirtualOutput record{.lifts = lift_bit(settings_.lift), .doors = 0xF0, .data = output_data(true)};
  if (stop_.landing.floor != 0) {
    record.function = BasicFunction::arrival_indication;
    record.sub_function = arrows(stop_.landing.direction, false);
    record.floor = stop_.landing.floor;
    record.doors = static_cast<std::uint8_t>(stop_.doors << 4);
    stop_ = {};
    return encode(record);
  }
  if (!knows_status_) {
    // Later changes are relative to the status sent here. Ended car calls may have been sent.
    knows_status_ = true;
    told_ = {.moving = !now.moving,
             .serves = !now.serves,
             .full = !now.full,
             .car_calls = told_.car_calls ^ (told_.car_calls & now.car_calls)};
  }
  if (told_.floor != now.floor) {
    told_.floor = record.sub_function = now.floor;
    record.function = BasicFunction::position_indicator;
    return encode(record);
  }
  if (told_.direction != now.direction || told_.moving != now.moving) {
    told_.direction = now.direction;
    told_.moving = now.moving;
    record.function = BasicFunction::direction_indication;
    record.sub_function = arrows(now.direction, now.moving);
    return encode(record);
  }
  const FloorSet difference = told_.car_calls ^ now.car_calls;
  if (!difference.empty()) return encode(next_car_call(difference, now.car_calls));
  record.function = BasicFunction::special_indication;
  if (told_.full != now.full) {
    told_.full = now.full;
    record.sub_function = sub_function_of(SpecialIndication::full_load);
    record.data = output_data(now.full);
    return encode(record);
  }
  told_.serves = now.serves;
  record.sub_function = sub_function_of(SpecialIndication::out_of_order);
  record.data = output_data(!now.serves);
  return encode(record);
}

VirtualOutput GroupMember::next_car_call(const FloorSet& difference, const FloorSet& wanted) {
  const std::uint8_t floor = difference.lowest();
  const bool on = wanted.contains(floor);
  if (on) {
    told_.car_calls.insert(floor);
  } else {
    told_.car_calls.erase(floor);
  }
  return acknowledgement_of({.floor = floor}, lift_bit(settings_.lift), on);
}

namespace {

class SitedGroupController {
 public:
  SitedGroupController(const Port& port, NodeId node_id, const Environment& environment)
      : device_(port, environment.get<GroupControllerSettings>(), node_id) {
    environment.made(device_.group(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  GroupControllerDevice<full_group_controller_layout, 512, 512, 64, catalogue_routes> device_;
};

constexpr DeviceForm group_controller_forms[] = {
    form_of<SitedGroupController, full_group_controller>};

}  // namespace

const DeviceKind group_controller_kind = {
    .info = group_controller_info, .profile = &profile, .forms = group_controller_forms};

}  // namespace canvoy::cia417
