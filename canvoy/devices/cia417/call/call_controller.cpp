#include "canvoy/devices/cia417/call/call_controller.hpp"

#include <bit>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

constexpr AccessHandlers CallController::hook_calls[] = {
    after_write<&CallController::received, virtual_input_mapping_object>};
constexpr ServiceHandlers CallController::service_calls = {
    .reset = method<&CallController::reset>,
    .state_entered = method<&CallController::state_entered>,
    .hooks = hook_calls};

CallController::CallController(Node& node, Tpdos& tpdos, std::span<Destination> destinations,
                               const CallControllerSettings& settings)
    : node_(node),
      lift_(settings.lift),
      low_priority_max_(settings.low_priority_max),
      served_(settings.served, settings.locked_by_key),
      destinations_(destinations),
      mapping_(node, tpdos, virtual_output_mapping_object.index,
               {.waits = callback<&CallController::waits>(*this),
                .next = callback<&CallController::next>(*this)}),
      indications_(settings.lift),
      low_timer_(callback<&CallController::promote>(*this)) {
  node.attach(service_);
}

void CallController::reset(ResetScope) {
  calls_.remove_all();
  lamps_.begin_anew();
  specials_.clear();
  indications_.forget();
  lamps_out_.begin();
  answers_.clear();
  help_is_coming_ = false;
  destinations_.begin_anew();
  node_.timers().disarm(low_timer_);
}

/// Panels may have been on the bus before: they receive all that is shown.
void CallController::state_entered(NmtState state) {
  if (state == NmtState::operational) show();
}

void CallController::set_lift_mask(std::uint8_t mask) {
  const auto lift = static_cast<unsigned>(std::countr_zero(mask)) + 1;
  if (lift == lift_) return;
  lift_ = lift;
  indications_.set_lift(lift);
  lamps_.forget();
  show();
}

void CallController::received() {
  take(decode_input(node_.dictionary().number(virtual_input_mapping_object.index, 0)));
}

void CallController::take(const VirtualInput& input) {
  if ((input.lifts & lift_mask()) == 0) return;
  const bool works =
      input.request() == CallRequest::request || input.request() == CallRequest::none;
  if (!works) ++defective_inputs_;
  if (input.function == BasicFunction::special_function) {
    if (!specials_.take(input)) return;
  } else if (is_connection_request(input.function)) {
    take_connection(input);
  } else {
    if (input.request() != CallRequest::request) return;
    if (is_hall_call(input.function)) {
      take_hall_call(input);
    } else if (is_destination_call(input.function)) {
      take_destination(input);
    } else if (has_target_stop(input.function)) {
      take_car_call(input);
    } else {
      return;
    }
  }
  show();
  changed_();
}

void CallController::take_reading(const VirtualInput& input) {
  const bool is_ours = (input.lifts & lift_mask()) != 0;
  if (!is_ours || input.function != BasicFunction::special_function) return;
  if (!specials_.take_reading(input)) return;
  show();
  changed_();
}

void CallController::take_connection(const VirtualInput& input) {
  const bool ends = input.request() == CallRequest::none && input.locks();
  if (input.request() != CallRequest::request && !ends) return;
  const bool is_affirmed = asked_(input);
  connected(input, is_affirmed && !ends);
}

void CallController::connected(const VirtualInput& input, bool on) {
  if (input.function == BasicFunction::speech_connection) {
    constexpr SpecialIndications help = indication_bit(SpecialIndication::help_is_coming);
    SpecialIndications& shown = indications_.display.specials;
    help_is_coming_ = on;
    shown = static_cast<SpecialIndications>(on ? shown | help : shown & ~help);
  }
  answer(input, on, lift_mask());
  show();
}

void CallController::take_hall_call(const VirtualInput& input) {
  const DoorMask there = doors_at(input.floor);
  const DoorMask at_panel = source_doors(input.doors);
  const Call call = hall_call_of(input, at_panel == 0 ? there : at_panel);
  // One of the two bits "shall be set": 00h is reserved, as for the other functions.
  if ((input.sub_function & hall_undirected) == 0) return;
  if (call.doors == 0 || (call.doors & ~there) != 0 || (accepted_ & kinds_of(call.kind)) == 0 ||
      is_on(SpecialFunction::hall_call_disable)) {
    return refuse(call);
  }
  if (offered_(input)) return;
  if (!served_.takes_hall_call(call)) return refuse(call);
  register_call(call);
}

void CallController::take_car_call(const VirtualInput& input) {
  const Call call = target_call_of(input);
  if (!takes_car_call(call)) return refuse(call);
  register_call(call);
}

Call CallController::target_call_of(const VirtualInput& input) const {
  const DoorMask wanted = destination_doors(input.doors);
  return {CallKind::car, priority_of(input.function), input.sub_function,
          wanted == 0 ? doors_at(input.sub_function) : wanted};
}

bool CallController::takes_car_call(const Call& call) const {
  return (accepted_ & car_calls) != 0 && served_.takes_car_call(call, specials_);
}

/// A panel that sends a button again may have lost the answer: it gets another one.
void CallController::register_call(const Call& call) {
  add(call);
  acknowledge(call, true);
}

/// Door by door: the lamp of an existing call stays lit. If the lift has no door there, and the
/// panel names none, the answer is that of door 1.
void CallController::refuse(const Call& call) {
  if (!FloorSet::is_floor(call.floor)) return;
  Call one = call;
  for (unsigned door = 0; door < lift_doors_max; ++door) {
    one.doors = static_cast<DoorMask>((call.doors == 0 ? 1U : call.doors) & 1U << door);
    if (one.doors != 0 && !shows(one)) acknowledge(one, false);
  }
}

void CallController::add(const Call& call) {
  Call there = call;
  there.doors &= doors_at(call.floor);
  calls_.add(there);
  watch_low();
}

/// The car still has to stop for destination calls that wait for it.
void CallController::withdraw(const Call& call) {
  calls_.remove(call);
  for (const Destination& destination : destinations_.used()) {
    if (!destination.active) continue;
    const Call source = source_call_of(destination.input, doors_here(destination.input));
    if (source.floor == call.floor && source.kind == call.kind) add(source);
  }
}

/// The doors at which a destination call waits: those of its panel, or all.
DoorMask CallController::doors_here(const VirtualInput& input) const {
  const DoorMask at_panel = source_doors(input.doors);
  return at_panel == 0 ? doors_at(input.floor) : at_panel;
}

void CallController::acknowledge(const Call& call, bool on) {
  lamps_.set(call, on);
  show();
}

void CallController::adopt(std::uint8_t lift) {
  refuse_out_of_reach();
  calls_.add_all(shown(), hall_calls);
  for (const Destination& destination : destinations_.used()) {
    if (!destination.told || destination.is_in_car()) continue;
    if (!destination.active) add_destination(destination.input);
    acknowledge_destination(destination.input, true, lift);
  }
  watch_low();
  show();
}

/// Hall calls that are shown, and that another lift of the group would have answered.
void CallController::refuse_out_of_reach() {
  for (const CallKind kind : {CallKind::up, CallKind::down, CallKind::any}) {
    const FloorSet floors = shown().floors(kinds_of(kind));
    for (std::uint8_t floor = floors.lowest(); floor != 0; floor = floors.next_up(floor + 1U)) {
      for (const CallPriority priority :
           {CallPriority::standard, CallPriority::low, CallPriority::high}) {
        for (unsigned door = 0; door < lift_doors_max; ++door) {
          const Call call{kind, priority, floor, static_cast<DoorMask>(1U << door)};
          if (!served_.takes_hall_call(call)) lamps_.end(call);
        }
      }
    }
  }
}

void CallController::take_destination(const VirtualInput& input) {
  if (input.floor == floor_of_car) return take_destination_in_car(input);
  const bool is_possible = served_.takes_destination(input, specials_) &&
                           (accepted_ & hall_calls) != 0 &&
                           !is_on(SpecialFunction::hall_call_disable);
  if (!is_possible) return refuse_destination(input);
  if (offered_(input)) return;
  acknowledge_destination(input, add_destination(input), lift_mask());
}

/// A passenger who names a destination in the car does not wait at a source floor: it is a car
/// call, which the panel also receives by the requested function.
void CallController::take_destination_in_car(const VirtualInput& input) {
  const Call call = target_call_of(input);
  if (!takes_car_call(call)) return refuse_destination(input);
  const bool is_kept = destinations_.keep(input);
  if (is_kept) register_call(call);
  acknowledge_destination(input, is_kept, lift_mask());
}

/// An earlier, affirmed call still has to be answered.
void CallController::refuse_destination(const VirtualInput& input) {
  if (!destinations_.report_again(input)) answer(input, false, lift_mask());
  show();
}

bool CallController::add_destination(const VirtualInput& input) {
  if (!destinations_.add(input)) return false;
  add(source_call_of(input, doors_here(input)));
  return true;
}

/// Another call may wait there: a destination call, or a hall call that panels show, which may
/// belong to this lift.
void CallController::withdraw_destination(const VirtualInput& input) {
  if (!destinations_.withdraw(input)) return;
  const Call source = source_call_of(input, 0x0F);
  if (!shows(source) && !destinations_.has_source(source)) calls_.remove(source);
}

void CallController::acknowledge_destination(const VirtualInput& input, bool on,
                                             std::uint8_t lifts) {
  const DestinationCalls::Answer told = destinations_.tell(input, on, lifts);
  if (told == DestinationCalls::Answer::others) return;
  if (told == DestinationCalls::Answer::no_room) {
    ++destinations_without_room_;
    answer(input, on, lifts);
  }
  show();
}

/// For a call that is not kept.
void CallController::answer(const VirtualInput& input, bool on, std::uint8_t lifts) {
  if (!answers_.push(encode(answer_to(input, on, lifts)))) ++answers_lost_;
}

void CallController::answered(std::uint8_t floor, Direction departure, CallKinds kinds) {
  const auto done = static_cast<CallKinds>(answered_calls(departure) & kinds);
  calls_.remove_at(floor, done);
  lamps_.end_at(floor, done);
  destinations_.answered(
      floor, done, [this](const VirtualInput& boarded) { register_call(target_call_of(boarded)); });
  watch_low();
  show();
}

void CallController::cancel(CallKinds kinds) {
  calls_.remove_all(kinds);
  lamps_.end_all(kinds);
  destinations_.cancel(kinds);
  watch_low();
  show();
}

void CallController::set(SpecialFunction function, bool on) {
  specials_.set(function, on);
  show();
}

void CallController::watch_low() {
  const bool waits = !calls_.floors(all_calls, CallPriority::low).empty();
  if (!waits) return node_.timers().disarm(low_timer_);
  if (!low_timer_.armed()) {
    node_.timers().arm(low_timer_, node_.now() + low_priority_max_);
  }
}

/// The panels still show them as they were made.
void CallController::promote(Time) {
  calls_.promote_low();
  changed_();
}

void CallController::show() {
  if (waits()) mapping_.announce();
}

void CallController::show_again() {
  lamps_.report_again();
  destinations_.report_all_again();
  specials_.report_again();
  indications_.report_again();
  show();
}

void CallController::ring(std::uint8_t floor, DoorMask doors, Direction direction) {
  indications_.ring(floor, doors, direction);
  show();
}

bool CallController::waits() {
  return lamps_out_.waits() || lamps_.waits() || destinations_.waits() || !answers_.empty() ||
         specials_.waits() || indications_.waits();
}

std::uint64_t CallController::next() {
  const VirtualOutput record = next_record();
  record_(record);
  return encode(record);
}

VirtualOutput CallController::next_record() {
  if (lamps_out_.waits()) return lamps_out_.next(lift_mask());
  if (lamps_.waits()) return lamps_.next(lift_mask());
  if (destinations_.waits()) return destinations_.next();
  if (!answers_.empty()) return decode_output(answers_.pop());
  if (specials_.waits()) return specials_.next(lift_mask());
  return indications_.next();
}

}  // namespace canvoy::cia417
