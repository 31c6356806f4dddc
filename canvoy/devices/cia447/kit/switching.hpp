// Functions that are switched and moved: a command acts on the status of its object after the time
// that the movement takes (CiA 447-3, 4.2). A table describes all of it, and most virtual devices
// consist of such a table.
//
//     constexpr const ObjectInfo* commands[] = {&door_command_object};
//     constexpr Effect effects[] = {
//         effect(door_command_driver, OpeningCommand::open, door_status_driver,
//                Opening::is_getting_open, Opening::open, 2s)};
//     constexpr SwitchedTable table = {.commands = commands, .effects = effects};
//
//     SwitchedUnit<table> doors(network, {}, {});
//
// A movement between two states keeps its progress: a reversed one takes as long as it was under
// way, and a stopped one continues from its position.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/kit/commands.hpp"

namespace canvoy::cia447 {

/// Effect of a command on a status.
enum class Manner : std::uint8_t {
  motion,  ///< from the present state to `done`; no effect in that state
  pulse,   ///< `moving` for a time, then `done` again; another command prolongs it
  stop,    ///< ends a motion at its present position
};

/// A code of a command, and its effect on a status: `moving` at once, `done` after a time.
struct Effect {
  static constexpr std::uint32_t any_state = 0xFFFF'FFFF;  ///< for `from`

  FieldPlace command;              ///< field that is written
  std::uint32_t code = 0;          ///< of the command
  FieldPlace status;               ///< field that it acts on
  std::uint32_t moving = 0;        ///< code of the status, at once
  std::uint32_t done = 0;          ///< code of the status, after the time
  Duration takes{};                ///< of the whole way
  Manner manner = Manner::motion;  ///< see Manner
  std::uint32_t from = any_state;  ///< in any other state, no effect
};
/// A motion, by handles of command and status.
template <class Command, class Code, class Status, class State>
constexpr Effect effect(const Command& command, Code code, const Status& status, State moving,
                        State done, Duration takes) {
  return {.command = place_of(command),
          .code = static_cast<std::uint32_t>(code),
          .status = place_of(status),
          .moving = static_cast<std::uint32_t>(moving),
          .done = static_cast<std::uint32_t>(done),
          .takes = takes};
}
/// Without a state in between: the status keeps its value until the end.
template <class Command, class Code, class Status, class State>
constexpr Effect effect(const Command& command, Code code, const Status& status, State done,
                        Duration takes) {
  Effect made = effect(command, code, status, done, done, takes);
  made.moving = Effect::any_state;
  return made;
}
/// At once, and only from this state.
template <class Command, class Code, class Status, class State>
constexpr Effect effect_from(const Command& command, Code code, const Status& status, State from,
                             State done) {
  Effect made = effect(command, code, status, done, Duration{});
  made.from = static_cast<std::uint32_t>(from);
  return made;
}
/// A state that ends by itself.
template <class Command, class Code, class Status, class State>
constexpr Effect pulse(const Command& command, Code code, const Status& status, State during,
                       State after, Duration takes) {
  Effect made = effect(command, code, status, during, after, takes);
  made.manner = Manner::pulse;
  return made;
}
/// Stops a motion: it stays where it is, and the status is `stopped`.
template <class Command, class Code, class Status, class State>
constexpr Effect stop(const Command& command, Code code, const Status& status, State moving,
                      State stopped) {
  Effect made = effect_from(command, code, status, moving, stopped);
  made.manner = Manner::stop;
  return made;
}

/// Effects of several functions as one array.
template <std::size_t... counts>
constexpr auto join(const std::array<Effect, counts>&... groups) {
  std::array<Effect, (counts + ...)> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& group) {
    for (const Effect& one : group) all[next++] = one;
  };
  (append(groups), ...);
  return all;
}

/// Objects of which every field of the command has a field of the same name, with the same codes,
/// in the status, which takes over the code. Effects have priority over mirrors.
struct Mirror {
  const ObjectInfo* command = nullptr;  ///< object that is written
  const ObjectInfo* status = nullptr;   ///< object that takes its codes over
  Duration takes{};                     ///< until the status follows
};

/// State of a status at power-on, and optionally the state that follows by itself after a time.
struct Rest {
  FieldPlace status;       ///< field
  std::uint32_t code = 0;  ///< at power-on
  std::uint32_t then = 0;  ///< after the time, if there is one
  Duration takes{};        ///< zero: it stays
};
/// A state at power-on.
template <class Status, class State>
constexpr Rest rest(const Status& status, State state) {
  return {.status = place_of(status), .code = static_cast<std::uint32_t>(state)};
}
/// A state at power-on that changes by itself.
template <class Status, class State>
constexpr Rest rest(const Status& status, State state, State then, Duration takes) {
  Rest made = rest(status, state);
  made.then = static_cast<std::uint32_t>(then);
  made.takes = takes;
  return made;
}

/// All of a unit that is switched.
struct SwitchedTable {
  std::span<const ObjectInfo* const> commands = {};  ///< command objects
  std::span<const Mirror> mirrors = {};              ///< commands that are taken over
  std::span<const Effect> effects = {};              ///< commands with motions
  /// May include statuses that are neither mirrored nor in an effect.
  std::span<const Rest> rests = {};
};

/// State of the sensor of a status.
enum class Sensing : std::uint8_t { working, failure, not_available };

/// What a unit of a table drives.
struct SwitchedHardware {
  /// Executes a command, and reports the result by Switching::report(). Returns false to use the
  /// table. Without a callback, the table is always used: a simulation.
  Callback<bool(const Commanded&)> drive = {};
  /// Called with the actual state, regardless of its sensor: a simulation shows it as light or
  /// movement.
  Callback<void(const FieldPlace& status, std::uint32_t code)> became = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(SwitchedHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::drive; } || requires { &Plain::became; },
      "the class has no member function of SwitchedHardware: drive or became");
  if constexpr (requires { &Plain::drive; }) hardware.drive = callback<&Plain::drive>(plain);
  if constexpr (requires { &Plain::became; }) hardware.became = callback<&Plain::became>(plain);
}
/// What the hardware of a unit has.
struct SwitchedSettings {
  /// Commands that the device lacks. Must outlive the unit.
  std::span<const FieldPlace> lacking = {};
};

class Switching {
 public:
  /// A status, and its present motion.
  struct Field {
    FieldPlace place;                    ///< of the status
    std::uint32_t actual = 0;            ///< its value with a working sensor
    std::uint32_t target = 0;            ///< its value at the end of the motion
    std::uint32_t origin = 0;            ///< of the motion to `target`
    Time due = never;                    ///< end of the motion; never: no motion
    Time began{};                        ///< when the present piece of it began
    Duration takes{};                    ///< of the whole motion; zero: no motion
    Duration gone{};                     ///< elapsed time of it when it `began`, or was stopped
    Sensing sensing = Sensing::working;  ///< of its sensor
  };

  /// `table`, and `fields`, which has room for count_fields(table), must outlive this.
  Switching(CarNetwork& network, const SwitchedTable& table, std::span<Field> fields,
            const SwitchedHardware& hardware, const SwitchedSettings& settings);

  /// Sets the actual state, and ends a motion under way. No effect if the table does not have the
  /// status.
  void report(const FieldPlace& status, std::uint32_t code);
  /// The same, by the handle of a field.
  template <class Handle, class State>
    requires requires { typename Handle::Place; }
  void report(const Handle& handle, State state) {
    report(place_of(handle), static_cast<std::uint32_t>(state));
  }
  /// Sets the state of a sensor: while it does not work, the status is "Failure" or "Signal not
  /// available", regardless of the actual state.
  void sense(const FieldPlace& status, Sensing sensing);
  /// The same, by the handle of a field.
  template <class Handle>
    requires requires { typename Handle::Place; }
  void sense(const Handle& handle, Sensing sensing) {
    sense(place_of(handle), sensing);
  }
  /// Sets the state of all sensors.
  void sense(Sensing sensing);

  /// Executes a command like one written by a client: for keys of the device itself.
  void command(const FieldPlace& command, std::uint32_t code) { commanded({command, code, 0}); }
  /// Carries a command of the device itself out, as if a client had written it.
  template <class Handle, class Code>
  void command(const Handle& handle, Code code) {
    command(place_of(handle), static_cast<std::uint32_t>(code));
  }

  /// Actual state, regardless of the sensor; 0 if the table does not have it.
  std::uint32_t actual(const FieldPlace& status) const;
  /// True if a status has this value at present.
  template <class Handle, class State>
  bool is(const Handle& handle, State state) const {
    return actual(place_of(handle)) == static_cast<std::uint32_t>(state);
  }

 private:
  void reset(ResetScope scope);
  void commanded(const Commanded& wanted);
  void act(const Effect& effect);
  void go(Field& field, const Effect& effect);
  void become(Field& field, std::uint32_t code, Time due);
  Duration gone(const Field& field) const;
  void advance(Time now);
  void show(const Field& field);
  Field* find(const FieldPlace& status);

  CarNetwork& network_;
  const SwitchedTable& table_;
  std::span<Field> fields_;
  SwitchedHardware hardware_;
  Commands commands_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  bool has_begun_ = false;
};

/// Calls `each` with every field of a mirrored status that has a field in the command.
template <class Each>
constexpr void each_mirrored(const Mirror& mirror, Each each) {
  for (const EntryInfo& entry : mirror.command->entries()) {
    const EntryInfo* status = find_entry(*mirror.status, entry.sub_first);
    const bool is_count = !mirror.command->subs.empty() && entry.sub_first == 0;
    if (status == nullptr || is_count) continue;
    const auto place = [&](const ObjectInfo& object, unsigned first_bit, unsigned bits) {
      return FieldPlace{object.index, entry.sub_first, static_cast<std::uint8_t>(first_bit),
                        static_cast<std::uint8_t>(bits)};
    };
    if (entry.fields.empty()) {
      const unsigned bits = bit_length(entry.type);
      each(place(*mirror.command, 0, bits), place(*mirror.status, 0, bits));
    }
    for (const FieldInfo& field : entry.fields) {
      for (const FieldInfo& other : status->fields) {
        if (field.name == "r" || field.name != other.name || field.number != other.number) continue;
        each(place(*mirror.command, field.first_bit, field.bits),
             place(*mirror.status, other.first_bit, other.bits));
      }
    }
  }
}

/// Number of statuses of a table; `each` is called once with every one.
template <class Each>
constexpr std::size_t each_status(const SwitchedTable& table, Each each) {
  std::size_t count = 0;
  const auto is_in_rests = [&table](const FieldPlace& place, std::size_t before) {
    return std::ranges::any_of(table.rests.first(before),
                               [&](const Rest& rest) { return rest.status == place; });
  };
  const auto is_in_effects = [&table](const FieldPlace& place, std::size_t before) {
    return std::ranges::any_of(table.effects.first(before),
                               [&](const Effect& effect) { return effect.status == place; });
  };
  const auto add = [&](const FieldPlace& place) {
    each(place);
    ++count;
  };
  for (std::size_t i = 0; i < table.rests.size(); ++i) {
    if (!is_in_rests(table.rests[i].status, i)) add(table.rests[i].status);
  }
  for (std::size_t i = 0; i < table.effects.size(); ++i) {
    const FieldPlace& place = table.effects[i].status;
    if (!is_in_rests(place, table.rests.size()) && !is_in_effects(place, i)) add(place);
  }
  for (const Mirror& mirror : table.mirrors) {
    each_mirrored(mirror, [&](const FieldPlace&, const FieldPlace& place) {
      if (!is_in_rests(place, table.rests.size()) && !is_in_effects(place, table.effects.size())) {
        add(place);
      }
    });
  }
  return count;
}

/// A virtual device that consists of a table.
template <const SwitchedTable& table>
class SwitchedUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  SwitchedUnit(CarNetwork& network, const SwitchedHardware& hardware,
               const SwitchedSettings& settings)
      : switching_(network, table, fields_, hardware, settings) {}

  /// The machine of commands and states.
  Switching& switching() { return switching_; }
  /// The machine of commands and states.
  const Switching& switching() const { return switching_; }

 private:
  static constexpr std::size_t count = each_status(table, [](const FieldPlace&) {});

  std::array<Switching::Field, count> fields_{};
  Switching switching_;
};

}  // namespace canvoy::cia447
