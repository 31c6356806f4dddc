#include "canvoy/worlds/excavator/machine_control.hpp"

#include <cmath>
#include <numbers>

namespace canvoy::excavator {

namespace {

constexpr Duration look_again = 1s;
constexpr Duration toot = 200ms;
/// Position of a stick below which nothing moves; above the point where its contact closes.
constexpr std::int16_t dead_zone = 1600;
static_assert(dead_zone > contact_closes * full_scale);

constexpr std::uint32_t bit_of(Button button) {
  return 1U << static_cast<unsigned>(button);
}

}  // namespace

constexpr ServiceHandlers MachineControl::service_calls = {.reset = method<&MachineControl::reset>};

MachineControl::MachineControl(HostNode& device, const HostSettings& settings)
    : device_(device),
      settings_(settings),
      remotes_(std::make_unique<std::array<NmtMaster::RemoteNode, node_id_max>>()),
      master_(device.node(), *remotes_),
      seat_(device.node(), seat_id, seat_setup(settings),
            callback<&MachineControl::start_seat>(*this)),
      valves_(device.node(), valves_id, valves_setup(settings),
              callback<&MachineControl::start_valves>(*this)),
      armrest_(device.node(), callback<&MachineControl::armrest_changed>(*this)),
      look_timer_(callback<&MachineControl::look>(*this)),
      horn_timer_(callback<&MachineControl::end_horn>(*this)),
      gaps_(device.node(), callback<&MachineControl::ask_anew>(*this)) {
  device.node().attach(service_);
  device.heartbeat_consumer().on_change(callback<&MachineControl::changed>(*this));
  device.rpdos().received = callback<&MachineControl::received>(*this);
  device.rpdos().timed_out = callback<&MachineControl::timed_out>(*this);
  for (Partner* partner : {&seat_, &valves_}) {
    partner->setup.on_done(callback<&MachineControl::set_up>(*this));
  }
}

std::int16_t MachineControl::integer(std::uint16_t index, unsigned sub) const {
  return static_cast<std::int16_t>(
      device_.dictionary().word(index, static_cast<std::uint8_t>(sub)));
}

double MachineControl::sensor(Sensor which) const {
  return integer(sensor_values, static_cast<unsigned>(which)) / digits_of(which);
}

std::int16_t MachineControl::axis_value(std::size_t seat, Stick stick) const {
  const auto place = static_cast<unsigned>(stick);
  const auto joystick = static_cast<unsigned>(2 * seat) + place / 2;
  return integer(axis_values, 3 * joystick + place % 2 + 1);
}

// Presence of the nodes.

void MachineControl::reset(ResetScope) {
  forget(seat_);
  forget(valves_);
  has_light_ = has_beacon_ = is_fast_ = false;
  seat_.was_ready = valves_.was_ready = false;
  node().timers().arm(look_timer_, node().now());
}

/// Its state is unknown from here on; the machine stands still.
void MachineControl::forget(Partner& partner) {
  partner.setup.stop();
  node().timers().disarm(partner.start_timer);
  partner.is_ready = false;
  is_unlocked_ = false;
  has_horn_ = false;
  is_armed_.fill(false);
  if (&partner == &seat_) {
    armrest_.stop();
    is_fresh_.fill(false);
    asks_.fill(std::nullopt);
    command_ = 0;
    knows_buttons_ = false;
  }
}

void MachineControl::changed(NodeId id, RemoteState state) {
  Partner& who = partner(id);
  if (state == RemoteState::operational && who.is_ready) return;
  // The heartbeat after a boot-up message has no new information.
  if (state == RemoteState::pre_operational && who.is_in_setup()) return;
  forget(who);
  drive();
  if (state != RemoteState::lost && state != RemoteState::unknown) begin(who);
}

/// A node that worked before the host had its state is stopped, so that it sends everything again.
void MachineControl::begin(Partner& partner) {
  if (partner.was_ready && !settings_.restarts_others) return;
  if (device_.heartbeat_consumer().state(partner.id) == RemoteState::operational) {
    master_.command(partner.id, NmtCommand::enter_pre_operational);
  }
  partner.setup.begin();
}

/// The node is started when it has heard a heartbeat: from then on, 1016h watches the host.
void MachineControl::set_up(NodeId id, bool is_done) {
  if (!is_done) return;  // a failed setup is tried again
  node().timers().arm(partner(id).start_timer, node().now() + heartbeat_ms * Duration(1ms));
}

void MachineControl::start_seat(Time) {
  start(seat_);
}
void MachineControl::start_valves(Time) {
  start(valves_);
}

void MachineControl::start(Partner& who) {
  if (!master_.command(who.id, NmtCommand::start)) {
    node().timers().arm(who.start_timer, node().now() + heartbeat_ms * Duration(1ms));
    return;
  }
  who.is_ready = who.was_ready = true;
  drive();
  if (&who == &seat_ && settings_.has_armrest) armrest_.begin();
  report_anew(who);
}

void MachineControl::report_anew(const Partner& partner) {
  const bool is_seat = &partner == &seat_;
  const auto first = static_cast<std::uint16_t>(is_seat ? Output::lamps : Output::switches);
  for (std::uint16_t i = 0; i < 3; ++i) {
    device_.tpdos().trigger(static_cast<std::uint16_t>(first + i));
  }
}

/// Buttons and the knob are sent only when they change, and so are lamps, display and switches.
void MachineControl::ask_anew(NodeId) {
  const auto inputs =
      static_cast<unsigned>(settings_.has_trainer ? Input::trainer_right : Input::engine);
  for (std::uint16_t input = 1; input <= inputs; ++input) device_.rpdos().request(input);
  for (const Partner* partner : {&seat_, &valves_}) {
    if (partner->is_ready) report_anew(*partner);
  }
}

/// A command was lost, or a node did not answer.
void MachineControl::look(Time now) {
  node().timers().arm(look_timer_, now + look_again);
  for (Partner* partner : {&seat_, &valves_}) {
    const RemoteState state = device_.heartbeat_consumer().state(partner->id);
    if (state == RemoteState::lost || state == RemoteState::unknown) continue;
    if (partner->is_in_setup()) continue;
    const bool is_late = partner->is_ready && state != RemoteState::operational;
    if (is_late) {
      forget(*partner);
      drive();
    }
    if (!partner->is_ready) begin(*partner);
  }
}

// Inputs.

void MachineControl::received(std::uint16_t number) {
  is_fresh_[number] = seat_.is_ready;
  if (static_cast<Input>(number) == Input::buttons) press();
  if (settings_.has_trainer) look_for_command();
  drive();
}

void MachineControl::timed_out(std::uint16_t number) {
  is_fresh_[number] = false;
  drive();
}

/// Without these the hydraulics are locked, and stay so until they are unlocked by hand.
void MachineControl::armrest_changed() {
  if (!is_released()) {
    is_unlocked_ = false;
    is_armed_.fill(false);
  }
  drive();
}

void MachineControl::press() {
  if (!seat_.is_ready) return;
  const std::uint32_t now = dictionary().word(button_values, 1);
  const std::uint32_t before = settings_.counts_edges ? pressed_ : 0;
  pressed_ = now;
  if (!std::exchange(knows_buttons_, true)) return;
  for (std::size_t i = 0; i < button_count; ++i) {
    const auto button = static_cast<Button>(i);
    if ((now & ~before & bit_of(button)) != 0) pressed(button);
  }
}

void MachineControl::pressed(Button button) {
  if (!valves_.is_ready) return;
  switch (button) {
    case Button::horn:
      has_horn_ = true;
      return node().timers().arm(horn_timer_, node().now() + toot);
    case Button::light:
      has_light_ = !has_light_;
      return;
    case Button::beacon:
      has_beacon_ = !has_beacon_;
      return;
    case Button::travel:
      is_fast_ = !is_fast_;
      return;
    case Button::lock:
      is_unlocked_ = !is_unlocked_ && is_released();
      return;
  }
}

void MachineControl::end_horn(Time) {
  has_horn_ = false;
  drive();
}

// Outputs.

void MachineControl::drive() {
  for (std::size_t i = 0; i < movements; ++i) {
    const double command = command_of(static_cast<Movement>(i));
    const bool may_move = seat_.is_ready && valves_.is_ready && is_unlocked_;
    dictionary().set_number(
        valve_values, static_cast<std::uint8_t>(i + 1),
        static_cast<std::uint64_t>(std::lround(may_move ? command * valve_digits : 0)));
  }
  const std::int16_t throttle = seat_.is_ready ? integer(wheel_values, 1) : std::int16_t{0};
  dictionary().set_number(valve_values, throttle_output,
                          static_cast<std::uint64_t>(std::max<std::int16_t>(throttle, 0)));
  unsigned switched = 0;
  if (has_horn_) switched |= bit_of(Switched::horn);
  if (has_light_) switched |= bit_of(Switched::light);
  if (has_beacon_) switched |= bit_of(Switched::beacon);
  if (is_fast_) switched |= bit_of(Switched::fast_travel);
  if (is_unlocked_) switched |= bit_of(Switched::pilot_pressure);
  dictionary().set_number(switch_values, 1, switched);
  tell();
  show();
}

double MachineControl::command_of(Movement movement) {
  bool& is_armed = is_armed_[static_cast<std::size_t>(movement)];
  switch (movement) {
    case Movement::slew:
      return command_of_stick(Stick::left_x, is_armed);
    case Movement::stick:
      return command_of_stick(Stick::left_y, is_armed);
    case Movement::bucket:
      return command_of_stick(Stick::right_x, is_armed);
    case Movement::boom:
      return command_of_stick(Stick::right_y, is_armed);
    case Movement::left_track:
      return command_of_value(integer(pedal_values, 1), has_own(Input::pedals), is_armed);
    case Movement::right_track:
      return command_of_value(integer(pedal_values, 2), has_own(Input::pedals), is_armed);
    case Movement::rotator:
      return command_of_value(integer(wheel_values, 2), has_own(Input::wheels), is_armed);
  }
  return 0;
}

double MachineControl::command_of_stick(Stick stick, bool& is_armed) {
  if (!settings_.obeys_all_seats) return command_of_seat(command_, stick, is_armed);
  const double own = command_of_seat(0, stick, is_armed);
  return own != 0 ? own : command_of_seat(1, stick, is_armed);
}

double MachineControl::command_of_seat(std::size_t seat, Stick stick, bool& is_armed) {
  const bool is_good = is_fresh_stick(seat, stick) && has_good_axis(seat, stick);
  return command_of_value(axis_value(seat, stick), is_good, is_armed);
}

bool MachineControl::is_fresh_stick(std::size_t seat, Stick stick) const {
  const Input left = seat == 0 ? Input::left_stick : Input::trainer_left;
  return is_fresh_[static_cast<std::size_t>(stick) / 2 + static_cast<std::size_t>(left)];
}

/// True if wire, sensors and contact of a stick are in order.
bool MachineControl::has_good_axis(std::size_t seat, Stick stick) const {
  const std::int16_t value = axis_value(seat, stick);
  return value != broken_wire_reads && is_plausible(seat, stick, value);
}

bool MachineControl::all_are_at_rest() const {
  bool at_rest = is_fresh(Input::pedals) && is_fresh(Input::wheels);
  for (std::size_t seat = 0; seat < seats(); ++seat) {
    for (std::size_t i = 0; i < stick_count; ++i) {
      const auto stick = static_cast<Stick>(i);
      const bool rests = std::abs(axis_value(seat, stick)) < dead_zone;
      at_rest = at_rest && is_fresh_stick(seat, stick) && rests;
    }
  }
  for (const std::int16_t value :
       {integer(pedal_values, 1), integer(pedal_values, 2), integer(wheel_values, 2)}) {
    at_rest = at_rest && std::abs(value) < dead_zone;
  }
  return at_rest;
}

/// A button that was held before it was first heard asks for nothing.
void MachineControl::look_for_command() {
  for (std::size_t seat = 0; seat < seats(); ++seat) {
    const Input left = seat == 0 ? Input::left_stick : Input::trainer_left;
    if (!is_fresh(left)) continue;
    const auto sub = static_cast<std::uint8_t>(4 * seat + 2);
    const bool asks = (dictionary().word(joystick_values, sub) & command_bit) != 0;
    const bool was_up = std::exchange(asks_[seat], asks) == std::optional(false);
    if (!asks || !was_up || seat == command_ || !all_are_at_rest()) continue;
    command_ = seat;
    is_armed_.fill(false);
  }
}

double MachineControl::command_of_value(std::int16_t value, bool is_good, bool& is_armed) const {
  if (!is_good) is_armed = false;
  if (std::abs(value) < dead_zone) {
    if (is_good) is_armed = true;
    return 0;
  }
  if (!is_armed) return 0;
  const double share = (std::abs(value) - dead_zone) / (full_scale - dead_zone);
  return std::copysign(std::min(share, 1.0), value);
}

/// True if the contact of a direction is closed where the sensor has the stick in that direction.
bool MachineControl::is_plausible(std::size_t seat, Stick stick, std::int16_t value) const {
  if (!settings_.checks_contacts || std::abs(value) < dead_zone) return true;
  const auto place = static_cast<unsigned>(stick);
  const std::uint32_t contacts =
      device_.dictionary().word(joystick_values,
                                static_cast<std::uint8_t>(4 * seat + 2 * (place / 2) + 2)) >>
      (first_contact_bit + 2 * (place % 2));
  return (contacts & 3) == (value < 0 ? 1U : 2U);
}

/// Sets the lamps: what the machine does, as far as it is known.
void MachineControl::tell() {
  const bool has_valves = valves_.is_ready;
  const auto lit = [](Lamp lamp, bool is_on) {
    return (is_on ? 1U : 0U) << static_cast<unsigned>(lamp);
  };
  bool is_odd = false;
  for (std::size_t i = 0; i < seats() * stick_count; ++i) {
    const std::size_t seat = i / stick_count;
    const auto stick = static_cast<Stick>(i % stick_count);
    is_odd = is_odd || (is_fresh_stick(seat, stick) && !has_good_axis(seat, stick));
  }
  is_odd = is_odd || (settings_.has_armrest && !armrest_.is_there());
  const bool is_low = sensor(Sensor::fuel) < low_fuel_percent;
  const unsigned lamps_now =
      lit(Lamp::light, has_valves && has_light_) | lit(Lamp::beacon, has_valves && has_beacon_) |
      lit(Lamp::fast, has_valves && is_fast_) | lit(Lamp::locked, !has_valves || !is_unlocked_) |
      lit(Lamp::fault, !has_valves || is_odd) | lit(Lamp::low_fuel, has_valves && is_low) |
      lit(Lamp::hot, has_valves && sensor(Sensor::oil) > Excavator::hot) |
      lit(Lamp::ready, has_valves);
  dictionary().set_number(lamp_values, 1, lamps_now);
  if (settings_.has_trainer) dictionary().set_number(lamp_values, 2, 1U << command_);
}

void MachineControl::show() {
  const auto set = [this](Shown what, double value) {
    const auto digits = static_cast<std::int16_t>(std::lround(value));
    dictionary().set_number(shown_values,
                            static_cast<std::uint8_t>(1 + static_cast<unsigned>(what)),
                            static_cast<std::uint64_t>(valves_.is_ready ? digits : no_value));
  };
  const Excavator::Point tip =
      Excavator::tip_at(sensor(Sensor::boom), sensor(Sensor::stick), sensor(Sensor::bucket));
  constexpr double centimetres = 100;
  set(Shown::fuel, sensor(Sensor::fuel));
  set(Shown::oil, sensor(Sensor::oil));
  set(Shown::slew, sensor(Sensor::slew));
  set(Shown::height, tip.z * centimetres);
  set(Shown::rpm, sensor(Sensor::rpm));
  set(Shown::reach, tip.x * centimetres);
  constexpr Sensor details[display_pages] = {Sensor::boom, Sensor::stick, Sensor::bucket,
                                             Sensor::pressure};
  const std::uint32_t page = dictionary().word(knob_value, 1) % display_pages;
  set(Shown::page, page);
  set(Shown::detail, sensor(details[page]));
}

}  // namespace canvoy::excavator
