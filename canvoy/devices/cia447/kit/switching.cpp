#include "canvoy/devices/cia447/kit/switching.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::cia447 {

namespace {

/// True for a code of a known state.
bool is_state(const FieldPlace& place, std::uint32_t code) {
  const ValueInfo* value = find_value_info(place);
  if (value == nullptr) return false;
  for (const NamedValue& named : value->names) {
    if (code < named.first || code > named.last) continue;
    return named.meaning == Meaning::state || named.meaning == Meaning::manufacturer;
  }
  const Limits& limits = value->limits;
  return limits.kind == Limits::Kind::absolute && code >= limits.low && code <= limits.high;
}

}  // namespace

constexpr ServiceHandlers Switching::service_calls = {.reset = method<&Switching::reset>};

Switching::Switching(CarNetwork& network, const SwitchedTable& table, std::span<Field> fields,
                     const SwitchedHardware& hardware, const SwitchedSettings& settings)
    : network_(network),
      table_(table),
      fields_(fields),
      hardware_(hardware),
      commands_(network, table.commands,
                {.commanded = callback<&Switching::commanded>(*this), .lacking = settings.lacking}),
      timer_(callback<&Switching::advance>(*this)) {
  std::size_t count = 0;
  each_status(table, [&](const FieldPlace& place) {
    check_invariant(count < fields_.size());
    fields_[count++].place = place;
  });
  for (const Rest& rest : table.rests) find(rest.status)->actual = rest.code;
  network.node().attach(service_);
}

/// The states stay: an NMT reset moves nothing.
void Switching::reset(ResetScope) {
  if (!has_begun_) {
    has_begun_ = true;
    for (const Rest& rest : table_.rests) {
      if (rest.takes == Duration::zero()) continue;
      Field& field = *find(rest.status);
      field.target = rest.then;
      become(field, rest.code, network_.node().now() + rest.takes);
    }
  }
  for (const Field& field : fields_) show(field);
}

void Switching::commanded(const Commanded& wanted) {
  if (hardware_.drive && hardware_.drive(wanted)) return;
  bool has_effect = false;
  for (const Effect& effect : table_.effects) {
    if (effect.command != wanted.place) continue;
    has_effect = true;
    if (effect.code == wanted.code) act(effect);
  }
  if (has_effect) return;
  for (const Mirror& mirror : table_.mirrors) {
    if (mirror.command->index != wanted.place.index) continue;
    each_mirrored(mirror, [&](const FieldPlace& command, const FieldPlace& status) {
      if (command != wanted.place || !is_state(status, wanted.code)) return;
      act({.command = command,
           .code = wanted.code,
           .status = status,
           .moving = Effect::any_state,
           .done = wanted.code,
           .takes = mirror.takes});
    });
  }
}

void Switching::act(const Effect& effect) {
  Field* const found = find(effect.status);
  check_invariant(found != nullptr);
  Field& field = *found;
  if (effect.from != Effect::any_state && effect.from != field.actual) return;
  switch (effect.manner) {
    case Manner::motion:
      return go(field, effect);
    case Manner::pulse:
      field.takes = Duration::zero();
      field.target = effect.done;
      return become(field, effect.moving, network_.node().now() + effect.takes);
    case Manner::stop:
      field.gone = gone(field);
      return become(field, effect.done, never);
  }
}

/// Back to its origin, a motion takes the elapsed time; to its target, the remaining time.
void Switching::go(Field& field, const Effect& effect) {
  const bool is_moving = field.due != never;
  const bool is_on_way = field.takes > Duration::zero();
  if (!is_moving && !is_on_way && field.actual == effect.done) return;
  if (is_moving && is_on_way && field.target == effect.done) return;
  const std::uint32_t moving = effect.moving == Effect::any_state ? field.actual : effect.moving;
  Duration left = effect.takes;
  if (is_on_way && field.target == effect.done) {
    left -= gone(field) * effect.takes.count() / field.takes.count();
  } else if (is_on_way && field.origin == effect.done) {
    left = gone(field) * effect.takes.count() / field.takes.count();
    field.origin = field.target;
  } else {
    field.origin = field.actual;
  }
  field.target = effect.done;
  field.takes = effect.takes;
  field.gone = effect.takes - left;
  field.began = network_.node().now();
  if (left > Duration::zero()) return become(field, moving, field.began + left);
  field.takes = Duration::zero();
  become(field, effect.done, never);
}

Duration Switching::gone(const Field& field) const {
  const bool is_moving = field.due != never && field.takes > Duration::zero();
  return is_moving ? field.gone + (network_.node().now() - field.began) : field.gone;
}

void Switching::become(Field& field, std::uint32_t code, Time due) {
  const bool is_new = field.actual != code;
  field.actual = code;
  field.due = due;
  show(field);
  if (due < timer_.at()) network_.node().timers().arm(timer_, due);
  if (is_new && hardware_.became) hardware_.became(field.place, code);
}

void Switching::advance(Time now) {
  Time next = never;
  for (Field& field : fields_) {
    if (field.due <= now) {
      field.takes = Duration::zero();
      become(field, field.target, never);
    }
    next = std::min(next, field.due);
  }
  if (next < timer_.at()) network_.node().timers().arm(timer_, next);
}

void Switching::report(const FieldPlace& status, std::uint32_t code) {
  Field* field = find(status);
  if (field == nullptr) return;
  field->takes = Duration::zero();
  become(*field, code, never);
}

void Switching::sense(const FieldPlace& status, Sensing sensing) {
  Field* field = find(status);
  if (field == nullptr) return;
  field->sensing = sensing;
  show(*field);
}

void Switching::sense(Sensing sensing) {
  for (Field& field : fields_) {
    field.sensing = sensing;
    show(field);
  }
}

std::uint32_t Switching::actual(const FieldPlace& status) const {
  const auto found = std::ranges::find(fields_, status, &Field::place);
  return found == fields_.end() ? 0 : found->actual;
}

/// A status without a code for a failure (errata Z35) is not available.
void Switching::show(const Field& field) {
  std::uint32_t code = field.actual;
  if (field.sensing != Sensing::working) {
    const auto none = code_meaning(field.place, Meaning::invalid);
    const auto failure = code_meaning(field.place, Meaning::failure);
    const bool is_failure = field.sensing == Sensing::failure && failure.has_value();
    code = is_failure ? *failure : none.value_or(code);
  }
  write_field(network_.node().dictionary(), field.place, code);
}

Switching::Field* Switching::find(const FieldPlace& status) {
  const auto found = std::ranges::find(fields_, status, &Field::place);
  return found == fields_.end() ? nullptr : &*found;
}

}  // namespace canvoy::cia447
