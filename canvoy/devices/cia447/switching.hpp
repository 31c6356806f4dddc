// Functions that are switched and moved: a command acts on the status of its object after the time
// that the thing takes (CiA 447-3, 4.2). A table says all of it, and most virtual devices are such
// a table and nothing else.
//
//     constexpr const ObjectInfo* commands[] = {&door_command_object};
//     constexpr Effect effects[] = {
//         effect(door_command_driver, OpeningCommand::open, door_status_driver,
//                Opening::is_getting_open, Opening::open, 2s)};
//     constexpr SwitchedTable table = {.commands = commands, .effects = effects};
//     SwitchedUnit<table> doors(network, {}, {});
//
// What moves from one state to another knows how far it has come: told to go back it takes as long
// as it was under way, and stopped on its way it goes on from there.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/commands.hpp"

namespace canvoy::cia447 {

/// What a status does for a command.
enum class Manner : std::uint8_t {
  motion,  ///< goes from what it is to `done`; where it is that, nothing happens
  pulse,   ///< is `moving` for a time, and `done` again; another command prolongs it
  stop,    ///< ends a motion where it is
};

/// A code of a command, and what becomes of a status: `moving` at once, `done` after a time.
struct Effect {
  static constexpr std::uint32_t any_state = 0xFFFF'FFFF;

  FieldPlace command;
  std::uint32_t code = 0;
  FieldPlace status;
  std::uint32_t moving = 0;
  std::uint32_t done = 0;
  Duration takes{};
  Manner manner = Manner::motion;
  std::uint32_t from = any_state;  ///< where the status is something else, nothing happens
};
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
/// Without a state on the way: until it is done, the status says what it was.
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
template <class Command, class Code, class Status, class State>
constexpr Effect pulse(const Command& command, Code code, const Status& status, State during,
                       State after, Duration takes) {
  Effect made = effect(command, code, status, during, after, takes);
  made.manner = Manner::pulse;
  return made;
}
/// Of a motion: it stays where it is, and the status says `stopped`.
template <class Command, class Code, class Status, class State>
constexpr Effect stop(const Command& command, Code code, const Status& status, State moving,
                      State stopped) {
  Effect made = effect_from(command, code, status, moving, stopped);
  made.manner = Manner::stop;
  return made;
}

/// Effects of several things as one array.
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
/// in the status: that one takes the code over. Effects go before mirrors.
struct Mirror {
  const ObjectInfo* command = nullptr;
  const ObjectInfo* status = nullptr;
  Duration takes{};
};

/// What a status is at power-on, and what it becomes of itself after a time, if it does.
struct Rest {
  FieldPlace status;
  std::uint32_t code = 0;
  std::uint32_t then = 0;
  Duration takes{};
};
template <class Status, class State>
constexpr Rest rest(const Status& status, State state) {
  return {.status = place_of(status), .code = static_cast<std::uint32_t>(state)};
}
template <class Status, class State>
constexpr Rest rest(const Status& status, State state, State then, Duration takes) {
  Rest made = rest(status, state);
  made.then = static_cast<std::uint32_t>(then);
  made.takes = takes;
  return made;
}

struct SwitchedTable {
  std::span<const ObjectInfo* const> commands = {};
  std::span<const Mirror> mirrors = {};
  std::span<const Effect> effects = {};
  /// Statuses that are neither mirrored nor in an effect may stand here as well.
  std::span<const Rest> rests = {};
};

/// What a sensor says of a status.
enum class Sensing : std::uint8_t { working, failure, not_available };

struct SwitchedHardware {
  /// Carries a command out, and reports by Switching::report() what comes of it; false: as the
  /// table says. Without it all is as the table says: a simulation.
  Callback<bool(const Commanded&)> drive = {};
  /// Is told what a thing has become, whatever its sensor says: who simulates lets it shine, or
  /// move.
  Callback<void(const FieldPlace& status, std::uint32_t code)> became = {};
};
struct SwitchedSettings {
  /// Commands that the device cannot do. It must outlive the unit.
  std::span<const FieldPlace> lacking = {};
};

class Switching {
 public:
  /// A status, and what is under way with it.
  struct Field {
    FieldPlace place;
    std::uint32_t actual = 0;  ///< what it would say if its sensor worked
    std::uint32_t target = 0;
    std::uint32_t origin = 0;  ///< of the motion to `target`
    Time due = never;
    Time began{};
    Duration takes{};  ///< of the whole way; zero: it is not on one
    Duration gone{};   ///< of it when it `began`, or where it was stopped
    Sensing sensing = Sensing::working;
  };

  /// `table`, and `fields`, which has room for count_fields(table), must outlive this.
  Switching(CarNetwork& network, const SwitchedTable& table, std::span<Field> fields,
            const SwitchedHardware& hardware, const SwitchedSettings& settings);
  Switching(const Switching&) = delete;
  Switching& operator=(const Switching&) = delete;

  /// The thing is so now; a motion that is under way ends. Nothing happens where the table does not
  /// know the status.
  void report(const FieldPlace& status, std::uint32_t code);
  template <class Handle, class State>
    requires requires { typename Handle::Place; }
  void report(const Handle& handle, State state) {
    report(place_of(handle), static_cast<std::uint32_t>(state));
  }
  /// What a sensor says from now on: where it does not work, the status is "Failure" or "Signal not
  /// available", whatever the thing does meanwhile.
  void sense(const FieldPlace& status, Sensing sensing);
  template <class Handle>
    requires requires { typename Handle::Place; }
  void sense(const Handle& handle, Sensing sensing) {
    sense(place_of(handle), sensing);
  }
  /// All of them.
  void sense(Sensing sensing);

  /// As if a client had written it: a key of the device itself wants something.
  void command(const FieldPlace& command, std::uint32_t code) { commanded({command, code, 0}); }
  template <class Handle, class Code>
  void command(const Handle& handle, Code code) {
    command(place_of(handle), static_cast<std::uint32_t>(code));
  }

  /// What the thing is, whatever its sensor says; 0 where the table does not know it.
  std::uint32_t actual(const FieldPlace& status) const;
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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  bool has_begun_ = false;
};

/// Calls `each` with every field of a mirrored status that has one in the command.
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

/// How many statuses a table knows; `each` is called with every one, once.
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

/// A virtual device that is a table.
template <const SwitchedTable& table>
class SwitchedUnit {
 public:
  /// What `hardware` and `settings` refer to must outlive this.
  SwitchedUnit(CarNetwork& network, const SwitchedHardware& hardware,
               const SwitchedSettings& settings)
      : switching_(network, table, fields_, hardware, settings) {}

  Switching& switching() { return switching_; }
  const Switching& switching() const { return switching_; }

 private:
  static constexpr std::size_t count = each_status(table, [](const FieldPlace&) {});

  std::array<Switching::Field, count> fields_{};
  Switching switching_;
};

}  // namespace canvoy::cia447
