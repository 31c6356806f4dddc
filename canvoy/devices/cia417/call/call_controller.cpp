#include "canvoy/devices/cia417/call/call_controller.hpp"

#include <algorithm>
#include <bit>

#include "canvoy/profiles/reactions.hpp"

namespace canvoy::cia417 {

namespace {

constexpr auto first_hall_call = static_cast<unsigned>(BasicFunction::standard_hall_call);
constexpr auto first_car_call = static_cast<unsigned>(BasicFunction::standard_car_call);

/// Of a hall call.
std::uint8_t sub_function_of(CallKind kind) {
  if (kind == CallKind::up) return hall_up;
  return kind == CallKind::down ? hall_down : hall_undirected;
}
Direction direction_of(CallKind kind) {
  if (kind == CallKind::up) return Direction::up;
  return kind == CallKind::down ? Direction::down : Direction::none;
}

}  // namespace

/// Which panel shows a call. Car panels at all doors do, in the column of the door that opens.
VirtualOutput acknowledgement_of(const Call& call, std::uint8_t lifts, bool on) {
  const auto priority = static_cast<unsigned>(call.priority);
  const auto door_bits = static_cast<unsigned>(call.doors);
  VirtualOutput output{.lifts = lifts, .data = output_data(on, Property::standard, 0, on)};
  if (call.kind == CallKind::car) {
    output.function = static_cast<BasicFunction>(first_car_call + priority);
    output.sub_function = call.floor;
    output.doors = static_cast<std::uint8_t>(0xF0U | door_bits);
  } else {
    output.function = static_cast<BasicFunction>(first_hall_call + priority);
    output.sub_function = sub_function_of(call.kind);
    output.floor = call.floor;
    output.doors = static_cast<std::uint8_t>(door_bits << 4);
  }
  return output;
}

CallPriority priority_of(BasicFunction function) {
  const unsigned first = is_hall_call(function) ? first_hall_call : first_car_call;
  return static_cast<CallPriority>((static_cast<unsigned>(function) - first) % 3);
}

Call hall_call_of(const VirtualInput& input, DoorMask doors) {
  Call call{CallKind::any, priority_of(input.function), input.floor, doors};
  const unsigned direction = input.sub_function & unsigned{hall_undirected};
  if (direction == hall_up) call.kind = CallKind::up;
  if (direction == hall_down) call.kind = CallKind::down;
  return call;
}

constexpr HookCalls CallController::hook_calls[] = {
    after_write<&CallController::received, virtual_input_mapping_object>};
constexpr ServiceCalls CallController::service_calls = {
    .reset = method<&CallController::reset>,
    .state_entered = method<&CallController::state_entered>,
    .hooks = hook_calls};

CallController::CallController(Node& node, Tpdos& tpdos, std::span<Destination> destinations,
                               const CallControllerSettings& settings)
    : node_(node),
      destinations_(destinations),
      settings_(settings),
      mapping_(node, tpdos, virtual_output_mapping_object.index,
               {.waits = Callback<bool()>::to<&CallController::waits>(*this),
                .next = Callback<std::uint64_t()>::to<&CallController::next>(*this)}),
      indications_(settings.lift),
      low_timer_(Callback<void(Time)>::to<&CallController::promote>(*this)) {
  node.attach(service_);
}

void CallController::reset(ResetScope) {
  calls_.remove_all();
  shown_.remove_all();
  told_.remove_all();
  were_on_.remove_all();
  told_again_.remove_all();
  tells_again_ = false;
  specials_.clear();
  indications_.forget();
  lamps_out_.begin();
  answers_.clear();
  help_is_coming_ = false;
  std::ranges::fill(destinations_, Destination{});
  destinations_used_ = 0;
  node_.timers().disarm(low_timer_);
}

/// Panels may have been there before: they are told what is shown.
void CallController::state_entered(NmtState state) {
  if (state == NmtState::operational) show();
}

void CallController::set_lift_mask(std::uint8_t mask) {
  const auto lift = static_cast<unsigned>(std::countr_zero(mask)) + 1;
  if (lift == settings_.lift) return;
  settings_.lift = lift;
  indications_.set_lift(lift);
  told_.remove_all();
  were_on_.remove_all();
  told_again_.remove_all();
  tells_again_ = false;
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
  // One of the two bits "shall be set": 00h is reserved, as of the other functions.
  if ((input.sub_function & hall_undirected) == 0) return;
  if (call.doors == 0 || (call.doors & ~there) != 0 || (accepted_ & kinds_of(call.kind)) == 0 ||
      is_on(SpecialFunction::hall_call_disable)) {
    return refuse(call);
  }
  if (offered_(input)) return;
  if (!is_hall_call_possible(call)) return refuse(call);
  register_call(call);
}

/// From the highest floor of the lift nobody goes up with it, nor down from the lowest.
bool CallController::is_hall_call_possible(const Call& call) const {
  const GroupLift lift{.served = settings_.served};
  return lift.serves(call.floor, call.doors) && lift.leaves(call.floor, direction_of(call.kind));
}

void CallController::take_car_call(const VirtualInput& input) {
  const Call call = target_call_of(input);
  if (!is_car_call_possible(call)) return refuse(call);
  register_call(call);
}

Call CallController::target_call_of(const VirtualInput& input) const {
  const DoorMask wanted = destination_doors(input.doors);
  return {CallKind::car, priority_of(input.function), input.sub_function,
          wanted == 0 ? doors_at(input.sub_function) : wanted};
}

bool CallController::is_car_call_possible(const Call& call) const {
  const bool has_doors = call.doors != 0 && (call.doors & ~doors_at(call.floor)) == 0;
  return has_doors && (accepted_ & car_calls) != 0 && !is_locked(call.floor);
}

/// A panel whose button is pressed again may have lost the answer: it gets another one.
void CallController::register_call(const Call& call) {
  add(call);
  acknowledge(call, true);
}

/// Door by door: the lamp of one that stands goes on to be lit. Where the lift has no door, and the
/// panel names none, the answer is that of door 1.
void CallController::refuse(const Call& call) {
  if (!FloorSet::is_floor(call.floor)) return;
  Call one = call;
  for (unsigned door = 0; door < lift_doors_max; ++door) {
    one.doors = static_cast<DoorMask>((call.doors == 0 ? 1U : call.doors) & 1U << door);
    if (one.doors != 0 && !shown_.contains(one)) acknowledge(one, false);
  }
}

void CallController::serve_up_to(unsigned floor) {
  for (FloorSet& floors : settings_.served) floors &= FloorSet::between(1, floor);
}

void CallController::add(const Call& call) {
  Call there = call;
  there.doors &= doors_at(call.floor);
  calls_.add(there);
  watch_low();
}

/// Where destination calls wait for the same car, it has to stop for them all the same.
void CallController::withdraw(const Call& call) {
  calls_.remove(call);
  for (const Destination& destination : destinations()) {
    if (!destination.active) continue;
    const DoorMask at_panel = source_doors(destination.input.doors);
    const Call source = source_call_of(
        destination.input, at_panel == 0 ? doors_at(destination.input.floor) : at_panel);
    if (source.floor == call.floor && source.kind == call.kind) add(source);
  }
}

void CallController::acknowledge(const Call& call, bool on) {
  if (on) {
    shown_.add(call);
    told_.remove(call);
  } else {
    shown_.remove(call);
    told_.add(call);
  }
  show();
}

void CallController::adopt(std::uint8_t lift) {
  refuse_out_of_reach();
  calls_.add_all(shown_, hall_calls);
  for (Destination& destination : destinations()) {
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
    const FloorSet floors = shown_.floors(kinds_of(kind));
    for (std::uint8_t floor = floors.lowest(); floor != 0; floor = floors.next_up(floor + 1U)) {
      for (const CallPriority priority :
           {CallPriority::standard, CallPriority::low, CallPriority::high}) {
        for (unsigned door = 0; door < lift_doors_max; ++door) {
          const Call call{kind, priority, floor, static_cast<DoorMask>(1U << door)};
          if (!is_hall_call_possible(call)) shown_.remove(call);
        }
      }
    }
  }
}

void CallController::answered(std::uint8_t floor, Direction departure, CallKinds kinds) {
  const auto done = static_cast<CallKinds>(answered_calls(departure) & kinds);
  calls_.remove_at(floor, done);
  shown_.remove_at(floor, done);
  for (Destination& destination : destinations()) {
    const bool has_arrived = destination.is_in_car() && destination.input.sub_function == floor;
    if (has_arrived && (done & car_calls) != 0) destination.end();
    if (!destination.active || destination.input.floor != floor) continue;
    const Call source = source_call_of(destination.input, 0x0F);
    if ((done & kinds_of(source.kind)) != 0) board(destination);
  }
  watch_low();
  show();
}

void CallController::cancel(CallKinds kinds) {
  calls_.remove_all(kinds);
  shown_.remove_all(kinds);
  for (Destination& destination : destinations()) {
    const CallKinds its_kinds = destination.is_in_car() ? car_calls : hall_calls;
    if ((kinds & its_kinds) == its_kinds) destination.end();
  }
  watch_low();
  show();
}

void CallController::set(SpecialFunction function, bool on) {
  specials_.set(function, on);
  show();
}

DoorMask CallController::doors_at(std::uint8_t floor) const {
  return GroupLift{.served = settings_.served}.doors_at(floor);
}

bool CallController::is_locked(std::uint8_t floor) const {
  constexpr auto first_key = static_cast<std::size_t>(SpecialFunction::key_lock_1);
  for (std::size_t key = 0; key < settings_.locked_by_key.size(); ++key) {
    const auto function = static_cast<SpecialFunction>(first_key + key);
    if (settings_.locked_by_key[key].contains(floor) && !is_on(function)) return true;
  }
  return false;
}

void CallController::watch_low() {
  const bool waits = !calls_.floors(all_calls, CallPriority::low).empty();
  if (!waits) return node_.timers().disarm(low_timer_);
  if (!low_timer_.armed()) {
    node_.timers().arm(low_timer_, node_.now() + settings_.low_priority_max);
  }
}

/// The panels go on to show them as they were made.
void CallController::promote(Time) {
  calls_.promote_low();
  changed_();
}

void CallController::show() {
  if (waits()) mapping_.announce();
}

void CallController::show_again() {
  told_again_ = were_on_;
  tells_again_ = !told_again_.empty();
  show_destinations_again();
  specials_.tell_again();
  indications_.tell_again();
  show();
}

void CallController::ring(std::uint8_t floor, DoorMask doors, Direction direction) {
  indications_.ring(floor, doors, direction);
  show();
}

bool CallController::waits() {
  return lamps_out_.waits() || next_untold().floor != 0 || destination_waits() ||
         !answers_.empty() || specials_.waits() || indications_.waits();
}

std::uint64_t CallController::next() {
  const VirtualOutput record = next_record();
  record_(record);
  return encode(record);
}

VirtualOutput CallController::next_record() {
  if (lamps_out_.waits()) return lamps_out_.next(lift_mask());
  if (next_untold().floor != 0) return next_acknowledgement();
  if (destination_waits()) return next_destination();
  if (!answers_.empty()) return decode_output(answers_.pop());
  if (specials_.waits()) return specials_.next(lift_mask());
  return indications_.next();
}

/// What has changed comes first; of floor 0: nothing waits.
Call CallController::next_untold() const {
  const Call changed = shown_.first_difference(told_);
  constexpr LiftCalls none{};
  if (changed.floor != 0 || !tells_again_) return changed;
  return told_again_.first_difference(none);
}

VirtualOutput CallController::next_acknowledgement() {
  const Call call = next_untold();
  const bool on = shown_.contains(call);
  told_again_.remove(call);
  tells_again_ = tells_again_ && !told_again_.empty();
  if (on) {
    told_.add(call);
    were_on_.add(call);
  } else {
    told_.remove(call);
    if (call.kind != CallKind::car) tell_overlapping(call);
  }
  return acknowledgement_of(call, lift_mask(), on);
}

/// The sub-function addresses the lamps of each direction (4.4.1): where a call without a direction
/// goes out, so do those of both, and the other way round. Those of calls that stand are lit again.
void CallController::tell_overlapping(const Call& gone) {
  for (const CallKind kind : {CallKind::up, CallKind::down, CallKind::any}) {
    const Call standing{kind, gone.priority, gone.floor, gone.doors};
    const bool shares_a_lamp =
        kind != gone.kind && (sub_function_of(kind) & sub_function_of(gone.kind)) != 0;
    if (shares_a_lamp && shown_.contains(standing)) told_.remove(standing);
  }
}

}  // namespace canvoy::cia417
