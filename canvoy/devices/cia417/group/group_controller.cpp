#include "canvoy/devices/cia417/group/group_controller.hpp"

#include <bit>

#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

Direction direction_of(std::uint8_t arrows) {
  const unsigned direction = arrows & (arrow_up | arrow_down);
  if (direction == arrow_up) return Direction::up;
  return direction == arrow_down ? Direction::down : Direction::none;
}

std::uint8_t hall_bits(Direction direction) {
  if (direction == Direction::up) return hall_up;
  return direction == Direction::down ? hall_down : hall_undirected;
}
BasicFunction function_of(BasicFunction first, CallPriority priority) {
  return static_cast<BasicFunction>(static_cast<unsigned>(first) + static_cast<unsigned>(priority));
}

VirtualInput record_of(const HallCall& call, unsigned lift) {
  return {.function = function_of(BasicFunction::standard_hall_call, call.priority),
          .sub_function = hall_bits(call.direction),
          .lifts = lift == 0 ? std::uint8_t{0} : lift_bit(lift),
          .floor = call.floor,
          .doors = static_cast<std::uint8_t>(call.doors << 4),
          .data = static_cast<std::uint8_t>(CallRequest::request)};
}
VirtualInput record_of(const DestinationCall& call, unsigned lift) {
  const BasicFunction first = call.to_floor ? BasicFunction::standard_call_to_destination_floor
                                            : BasicFunction::standard_destination_call;
  return {.function = function_of(first, call.priority),
          .sub_function = call.target,
          .lifts = lift == 0 ? std::uint8_t{0} : lift_bit(lift),
          .floor = call.source,
          .doors = static_cast<std::uint8_t>(call.source_doors << 4 | call.target_doors),
          .data = static_cast<std::uint8_t>(CallRequest::request)};
}

Call shown_call(const HallCall& call) {
  Call made{CallKind::any, call.priority, call.floor, call.doors};
  if (call.direction == Direction::up) made.kind = CallKind::up;
  if (call.direction == Direction::down) made.kind = CallKind::down;
  return made;
}

}  // namespace

constexpr AccessHandlers GroupController::hook_calls[] = {
    after_write<&GroupController::call_received, group_input_object>,
    after_write<&GroupController::status_received, group_output_object>};
constexpr ServiceHandlers GroupController::service_calls = {
    .reset = method<&GroupController::reset>,
    .state_entered = method<&GroupController::state_entered>,
    .hooks = hook_calls};

GroupController::GroupController(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats,
                                 const GroupControllerMemory& memory,
                                 const GroupControllerSettings& settings)
    : node_(node),
      settings_(settings),
      lifts_(settings.lift),
      heartbeats_(heartbeats),
      hall_(std::span<const GroupLift>(lifts_).first(settings.lifts), memory.hall_calls,
            settings.hall),
      destinations_(std::span<const GroupLift>(lifts_).first(settings.lifts), memory.destinations,
                    settings.destination),
      up_peak_(std::span<const GroupLift>(lifts_).first(settings.lifts), settings.up_peak),
      assignments_(memory.assignments),
      acknowledgements_(memory.acknowledgements),
      assignment_mapping_(node, tpdos, virtual_input_mapping_object.index,
                          {.waits = callback<&GroupController::assignment_waits>(*this),
                           .next = callback<&GroupController::next_assignment>(*this)}),
      acknowledgement_mapping_(node, tpdos, virtual_output_mapping_object.index,
                               {.waits = callback<&GroupController::acknowledgement_waits>(*this),
                                .next = callback<&GroupController::next_acknowledgement>(*this)}),
      timer_(callback<&GroupController::reconsider>(*this)),
      again_timer_(callback<&GroupController::report_again>(*this)),
      gaps_(node, callback<&GroupController::ask_anew>(*this)) {
  node.attach(service_);
  heartbeats.on_change(callback<&GroupController::heard>(*this));
  hall_.plan_with(destinations_.plans());
  destinations_.plan_with(hall_.plans());
  hall_.on_assigned(callback<&GroupController::hall_assigned>(*this));
  destinations_.on_assigned(callback<&GroupController::destination_assigned>(*this));
  destinations_.on_withdrawn(callback<&GroupController::destination_withdrawn>(*this));
}

void GroupController::reset(ResetScope) {
  lifts_ = settings_.lift;
  for (GroupLift& lift : lifts_) lift.in_service = false;
  serves_ = {};
  hall_.remove_all();
  destinations_.remove_all();
  up_peak_.reset();
  assignments_.clear();
  acknowledgements_.clear();
  shown_.remove_all();
  told_.remove_all();
  were_on_.remove_all();
  told_again_.remove_all();
  resend_ = SIZE_MAX;
  node_.timers().disarm(timer_);
  node_.timers().disarm(again_timer_);
}

void GroupController::state_entered(NmtState state) {
  if (state != NmtState::operational) return node_.timers().disarm(timer_);
  node_.timers().arm(timer_, node_.now() + settings_.reconsider);
  announce();
}

void GroupController::heard(NodeId id, RemoteState state) {
  if (id >= 1 && id <= settings_.lifts) {
    update_service(id);
    if (state == RemoteState::operational) lift_returned();
  }
  announce();
}

void GroupController::lift_returned() {
  node_.timers().arm(again_timer_, node_.now() + settings_.tells_again);
}

void GroupController::report_again(Time) {
  resend_ = 0;
  told_again_ = were_on_;
  announce();
}

void GroupController::update_service(unsigned lift) {
  const auto id = static_cast<NodeId>(lift);
  const bool serves = serves_[lift - 1] && heartbeats_.state(id) == RemoteState::operational;
  if (serves == lifts_[lift - 1].in_service) return;
  lifts_[lift - 1].in_service = serves;
  // A lift that returns sends them again.
  if (heartbeats_.state(id) != RemoteState::operational) lifts_[lift - 1].car_calls.clear();
  hall_.service_changed();
  destinations_.service_changed();
}

void GroupController::call_received() {
  const VirtualInput call = decode_input(node_.dictionary().number(group_input_object.index, 0));
  if (call.request() != CallRequest::request) return;
  if (is_hall_call(call.function)) {
    take_hall_call(call);
  } else if (is_destination_call(call.function)) {
    take_destination(call);
  }
  announce();
}

void GroupController::take_hall_call(const VirtualInput& call) {
  const DoorMask at_panel = source_doors(call.doors);
  const Call wanted = hall_call_of(call, at_panel == 0 ? DoorMask{1} : at_panel);
  if ((call.sub_function & hall_undirected) == 0) return;
  const HallCall asked{.floor = call.floor,
                       .direction = direction_of(call.sub_function),
                       .doors = wanted.doors,
                       .priority = wanted.priority,
                       .lifts = call.lifts};
  const DispatchAnswer answer = hall_.add(asked);
  const bool known = answer == DispatchAnswer::assigned || answer == DispatchAnswer::waits;
  if (known) up_peak_.called(node_.now(), asked);
  refresh_shown();
  // A repeated press, or a refused call, is answered again.
  if (known) {
    told_.remove(wanted);
  } else {
    told_.add(wanted);
  }
}

void GroupController::take_destination(const VirtualInput& call) {
  const DoorMask at_panel = source_doors(call.doors);
  const DestinationCall asked{
      .source = call.floor,
      .target = call.sub_function,
      .source_doors = at_panel == 0 ? DoorMask{1} : at_panel,
      .target_doors = destination_doors(call.doors),
      .priority = priority_of(call.function),
      .lifts = call.lifts,
      .to_floor = call.function >= BasicFunction::standard_call_to_destination_floor};
  const auto answer = destinations_.add(asked);
  if (answer.answer == DispatchAnswer::assigned) return;  // reported when it was assigned
  acknowledge(asked, call.lifts, answer.answer == DispatchAnswer::waits);
}

void GroupController::hall_assigned(const HallCall& call, unsigned lift) {
  assign(record_of(call, lift));
}
void GroupController::destination_assigned(const DestinationCall& call, unsigned lift) {
  if (lift != 0) assign(record_of(call, lift));
  // Without a lift, the call is known, and will get one.
  acknowledge(call, lift != 0 ? lift_bit(lift) : call.lifts, true);
}

void GroupController::destination_withdrawn(const DestinationCall& call, unsigned lift) {
  VirtualInput record = record_of(call, lift);
  record.set_request(CallRequest::none);
  assign(record);
}

/// A passenger presses again if the panel missed its answer.
void GroupController::acknowledge(const DestinationCall& call, std::uint8_t lifts, bool on) {
  const VirtualInput record = record_of(call, 0);
  acknowledgements_.push(encode(VirtualOutput{.function = record.function,
                                              .sub_function = record.sub_function,
                                              .lifts = lifts,
                                              .floor = record.floor,
                                              .doors = record.doors,
                                              .data = output_data(on, Property::standard, 0, on)}));
}

/// Without room, all assignments are sent again when the queue is empty.
void GroupController::assign(const VirtualInput& record) {
  if (!assignments_.push(encode(record))) resend_ = 0;
}

/// Calls that come after the repetition of all are sent once.
bool GroupController::assignment_waits() {
  if (resend_ >= resend_end()) resend_ = SIZE_MAX;
  return !assignments_.empty() || resend_ != SIZE_MAX;
}

std::size_t GroupController::resend_end() const {
  return hall_.calls().size() + destinations_.calls().size();
}

std::uint64_t GroupController::next_assignment() {
  if (!assignments_.empty()) return assignments_.pop();
  const std::size_t position = resend_++;
  const auto hall = hall_.calls();
  if (position < hall.size()) return encode(record_of(hall[position].call, hall[position].lift));
  // Without a lift, it is not assigned.
  const auto& slot = destinations_.calls()[position - hall.size()];
  return encode(record_of(slot.call, slot.lift));
}

void GroupController::status_received() {
  const VirtualOutput status =
      decode_output(node_.dictionary().number(group_output_object.index, 0));
  if (std::popcount(status.lifts) != 1) return node_.count_malformed();
  const auto lift = static_cast<unsigned>(std::countr_zero(status.lifts)) + 1;
  if (lift <= settings_.lifts) lift_told(lift, status);
  open_more();
  destinations_.assign_waiting();
  announce();
}

void GroupController::lift_told(unsigned number, const VirtualOutput& status) {
  GroupLift& lift = lifts_[number - 1];
  const bool on = (status.data & 1) != 0;
  if (status.function == BasicFunction::position_indicator) {
    if (status.sub_function != 0) lift.floor = status.sub_function;
  } else if (status.function == BasicFunction::direction_indication) {
    lift.direction = direction_of(status.sub_function);
    up_peak_.told(node_.now(), number, (status.sub_function & arrow_moving) != 0);
  } else if (status.function == BasicFunction::arrival_indication) {
    lift_stopped(number, status);
  } else if (status.function == BasicFunction::standard_car_call) {
    if (on) {
      lift.car_calls.insert(status.sub_function);
    } else {
      lift.car_calls.erase(status.sub_function);
      destinations_.alighted(number, status.sub_function);
    }
  } else if (status.function == BasicFunction::special_indication) {
    if (status.sub_function == sub_function_of(SpecialIndication::full_load)) lift.full = on;
    if (status.sub_function == sub_function_of(SpecialIndication::out_of_order)) {
      // Changes that are not yet sent come one by one: it starts from the beginning.
      if (serves_[number - 1] == !on) lift_returned();
      serves_[number - 1] = !on;
      update_service(number);
    }
  }
}

void GroupController::lift_stopped(unsigned lift, const VirtualOutput& arrival) {
  const Landing landing{arrival.floor, direction_of(arrival.sub_function)};
  const DoorMask doors = source_doors(arrival.doors);
  // Its position and direction are sent after the stop, and passengers board a car that is here.
  lifts_[lift - 1].floor = landing.floor;
  lifts_[lift - 1].direction = landing.direction;
  up_peak_.opened(lift, landing);
  hall_.answered(lift, landing, doors);
  auto boarded = [this, lift](const DestinationCall& call) {
    acknowledge(call, lift_bit(lift), false);
  };
  destinations_.departed(lift, landing, doors, Callback<void(const DestinationCall&)>::of(boarded));
  refresh_shown();
}

void GroupController::reconsider(Time now) {
  node_.timers().arm(timer_, now + settings_.reconsider);
  hall_.reconsider();
  announce();
}

/// Opens further cars when more passengers wait at the main floor than one car takes.
void GroupController::open_more() {
  if (!up_peak_.is_crowded()) return;
  unsigned busy = 0;
  for (unsigned lift = 1; lift <= settings_.lifts; ++lift) {
    if (!hall_.route(lift).stops().empty()) busy |= lift_bit(lift);
  }
  const LiftMask wanted = up_peak_.call_more(static_cast<LiftMask>(busy));
  if (wanted == 0) return;
  VirtualInput record = record_of(up_peak_.call(), 0);
  record.lifts = wanted;
  assign(record);
}

void GroupController::refresh_shown() {
  shown_.remove_all();
  for (const auto& slot : hall_.calls()) shown_.add(shown_call(slot.call));
}

void GroupController::announce() {
  if (assignment_waits()) assignment_mapping_.announce();
  if (acknowledgement_waits()) acknowledgement_mapping_.announce();
}

bool GroupController::acknowledgement_waits() {
  return !acknowledgements_.empty() || next_untold().floor != 0;
}

/// Changes come first; floor 0: nothing is waiting.
Call GroupController::next_untold() const {
  constexpr LiftCalls none{};
  const Call changed = shown_.first_difference(told_);
  return changed.floor != 0 ? changed : told_again_.first_difference(none);
}

std::uint64_t GroupController::next_acknowledgement() {
  if (!acknowledgements_.empty()) return acknowledgements_.pop();
  const Call call = next_untold();
  const bool on = shown_.contains(call);
  told_again_.remove(call);
  if (on) {
    told_.add(call);
    were_on_.add(call);
  } else {
    told_.remove(call);
  }
  return encode(acknowledgement_of(call, all_lifts, on));
}

}  // namespace canvoy::cia417
