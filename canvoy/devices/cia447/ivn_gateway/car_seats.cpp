#include "canvoy/devices/cia447/ivn_gateway/car_seats.hpp"

#include <algorithm>

#include "canvoy/profiles/cia447/car_handles.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint8_t position_at_first = CarSeats::position_max / 2;

constexpr const ObjectInfo* seat_commands_wanted[] = {&seat_adjustment_command_object};

/// Fields of the driver's seat, in the order of the ways.
constexpr std::array<FieldPlace, CarSeats::ways> way_commands = {
    place_of(seat_adjustment_command_forward_backward),
    place_of(seat_adjustment_command_up_down),
    place_of(seat_adjustment_command_angle_lift_sink),
    place_of(seat_adjustment_command_tight_support_forward_backward),
    place_of(seat_adjustment_command_back_forward_backward),
    place_of(seat_adjustment_command_headrest_up_down)};
constexpr std::array<FieldPlace, CarSeats::ways + 2> statuses = {
    place_of(seat_adjustment_status_forward_backward),
    place_of(seat_adjustment_status_up_down),
    place_of(seat_adjustment_status_angle_lift_sink),
    place_of(seat_adjustment_status_tight_support_forward_backward),
    place_of(seat_adjustment_status_back_forward_backward),
    place_of(seat_adjustment_status_headrest_up_down),
    place_of(seat_adjustment_status_recall_memory),
    place_of(seat_adjustment_status_store_memory)};

constexpr FieldPlace of_seat(FieldPlace place, unsigned seat) {
  place.sub = static_cast<std::uint8_t>(seat);
  return place;
}

}  // namespace

constexpr ServiceHandlers CarSeats::service_calls = {.reset = method<&CarSeats::reset>};

CarSeats::CarSeats(CarNetwork& network, const SwitchedHardware& hardware,
                   const SwitchedSettings& settings)
    : network_(network),
      hardware_(hardware),
      commands_(network, seat_commands_wanted,
                {.commanded = callback<&CarSeats::commanded>(*this), .lacking = settings.lacking}),
      timer_(callback<&CarSeats::step>(*this)) {
  for (Seat& seat : seats_) {
    seat.position.fill(position_at_first);
    seat.target = seat.position;
  }
  network.node().attach(service_);
}

/// The contents of the store are not trusted: no seat moves beyond its end.
void CarSeats::keep_in(const SeatStore& store) {
  store_ = store;
  if (!store_.load) return;
  memories_ = store_.load();
  for (auto& seat : memories_.of_seat) {
    for (SeatMemories::Memory& memory : seat) {
      for (std::uint8_t& position : memory.position) {
        position = std::min<std::uint8_t>(position, position_max);
      }
    }
  }
}

void CarSeats::reset(ResetScope) {
  show();
}

void CarSeats::commanded(const Commanded& wanted) {
  if (hardware_.drive && hardware_.drive(wanted)) return;
  Seat& seat = seats_[wanted.place.sub - 1U];
  const FieldPlace place = of_seat(wanted.place, 1);
  if (place == place_of(seat_adjustment_command_recall_memory)) {
    recall(seat, wanted.as<SeatMemory>());
  } else if (place == place_of(seat_adjustment_command_store_memory)) {
    store(seat, wanted.as<SeatMemory>());
  } else {
    const auto way = std::ranges::find(way_commands, place) - way_commands.begin();
    move(seat, static_cast<Way>(way), wanted.as<SeatMotion>());
  }
  show();
  if (!timer_.armed()) network_.node().timers().arm(timer_, network_.node().now() + step_time);
}

/// Manual movement: it ends a recall, and the seat is then at no stored position.
void CarSeats::move(Seat& seat, Way way, SeatMotion to) {
  if (seat.recalling != SeatMemory::none) recall(seat, SeatMemory::none);
  seat.recalled = seat.stored = SeatMemory::none;
  const int steps = to == SeatMotion::forward ? steps_of_command : -steps_of_command;
  const int target = std::clamp(seat.position[way] + steps, 0, position_max);
  seat.target[way] = static_cast<std::uint8_t>(target);
}

/// For no memory, or an empty one, the seat stops.
void CarSeats::recall(Seat& seat, SeatMemory memory) {
  seat.recalled = seat.recalling = SeatMemory::none;
  seat.target = seat.position;
  if (memory == SeatMemory::none) return;
  const SeatMemories::Memory& one = memory_of(seat, memory);
  if (!one.is_used) return;
  seat.target = one.position;
  if (seat.target == seat.position) {
    seat.recalled = memory;
  } else {
    seat.recalling = memory;
    seat.stored = SeatMemory::none;
  }
}

void CarSeats::store(Seat& seat, SeatMemory memory) {
  seat.stored = memory;
  if (memory == SeatMemory::none) return;
  memory_of(seat, memory) = {true, seat.position};
  store_.store(memories_);
}

/// `memory` is 1 to 4.
SeatMemories::Memory& CarSeats::memory_of(const Seat& seat, SeatMemory memory) {
  const auto number = static_cast<std::size_t>(&seat - seats_.data());
  return memories_.of_seat[number][static_cast<std::size_t>(memory) - 1];
}

void CarSeats::step(Time now) {
  bool is_moving = false;
  for (Seat& seat : seats_) {
    for (unsigned way = 0; way < ways; ++way) {
      const int step = std::clamp(seat.target[way] - seat.position[way], -1, 1);
      seat.position[way] = static_cast<std::uint8_t>(seat.position[way] + step);
    }
    if (seat.position != seat.target) {
      is_moving = true;
    } else if (seat.recalling != SeatMemory::none) {
      seat.recalled = seat.recalling;
      seat.recalling = SeatMemory::none;
    }
  }
  show();
  if (is_moving) network_.node().timers().arm(timer_, now + step_time);
}

void CarSeats::report(const FieldPlace& status, std::uint32_t code) {
  bool is_of_seat = false;
  for (unsigned seat = 1; seat <= seats_.size(); ++seat) {
    for (unsigned field = 0; field < fields; ++field) {
      if (of_seat(statuses[field], seat) != status) continue;
      seats_[seat - 1].reported[field] = code;
      is_of_seat = true;
    }
  }
  if (is_of_seat) show();
}

void CarSeats::show() {
  Dictionary& dictionary = network_.node().dictionary();
  for (unsigned number = 1; number <= seats_.size(); ++number) {
    const Seat& seat = seats_[number - 1];
    const auto tell = [&](unsigned field, auto state) {
      const auto code = seat.reported[field].value_or(static_cast<std::uint32_t>(state));
      write_field(dictionary, of_seat(statuses[field], number), code);
    };
    for (unsigned way = 0; way < ways; ++way) {
      const int left = seat.target[way] - seat.position[way];
      tell(way, left > 0   ? SeatMotion::forward
                : left < 0 ? SeatMotion::backward
                           : SeatMotion::not_available);
    }
    tell(ways, seat.recalled);
    tell(ways + 1, seat.stored);
  }
}

}  // namespace canvoy::cia447
