#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::cia407 {

namespace {

constexpr std::uint8_t flag_many = 1;

}  // namespace

constexpr ServiceHandlers PassengerCounterUnit::service_calls = {
    .state_entered = method<&PassengerCounterUnit::state_entered>};
constexpr AccessHandlers PassengerCounterUnit::hook_calls[] = {
    after_write<&PassengerCounterUnit::doors_written, state_of_doors_object>};

PassengerCounterUnit::PassengerCounterUnit(VirtualDevice& device, const NoHardware& /*hardware*/,
                                           const PassengerCounterSettings& settings)
    : device_(device), settings_(settings) {
  device.on_reset = callback<&PassengerCounterUnit::reset>(*this);
  device.react(*this, hook_calls);
  device.node().attach(service_);
}

/// The result of a closed door would otherwise be sent again at the next start, as a new result.
void PassengerCounterUnit::state_entered(NmtState state) {
  const bool is_operational = state == NmtState::operational;
  const bool has_left = std::exchange(was_operational_, is_operational) && !is_operational;
  if (!has_left || is_counting_) return;
  in_ = 0;
  out_ = 0;
  tell();
}

/// A count that was under way is sent: the passengers have passed.
void PassengerCounterUnit::reset(ResetScope scope) {
  if (scope != ResetScope::node) return;
  if (!is_counting_) tell();
  device_.signal(flag_many, in_ > many || out_ > many);
}

void PassengerCounterUnit::doors_written(const Entry& entry) {
  if (entry.sub != door_sub(settings_.door)) return;
  const DoorState door = door_state(device_.node().dictionary(), settings_.door);
  if (door.is_valid) set_door(door.is_open);
}

void PassengerCounterUnit::set_door(bool is_open) {
  if (is_open == is_counting_) return;
  is_counting_ = is_open;
  if (!is_open) return tell();
  in_ = 0;
  out_ = 0;
  tell();
  device_.signal(flag_many, false);
}

void PassengerCounterUnit::count(unsigned& counter, unsigned people) {
  if (!is_counting_) return;
  counter = std::min(counter + std::min(people, count_max), count_max);
  if (counter > many) device_.signal(flag_many, true);
}

/// Both at once: a PDO must not carry half of it.
void PassengerCounterUnit::tell() {
  device_.node().dictionary().set_number(passenger_counting_in_and_out_per_door_object.index, 0,
                                         in_ << 8 | out_);
  device_.tell(incoming_passengers_of_door, in_);
}

}  // namespace canvoy::cia407
