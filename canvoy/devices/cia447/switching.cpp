#include "canvoy/devices/cia447/switching.hpp"

#include "canvoy/can/must_hold.hpp"

namespace canvoy::cia447 {

namespace {

/// A code that says something of the thing, and not that it is unknown.
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

Switching::Switching(CarNetwork& network, const SwitchedTable& table, std::span<Field> fields,
                     const SwitchedHardware& hardware, const SwitchedSettings& settings)
    : network_(network),
      table_(table),
      fields_(fields),
      hardware_(hardware),
      commands_(network, table.commands,
                {.commanded = Callback<void(const Commanded&)>::to<&Switching::commanded>(*this),
                 .lacking = settings.lacking}),
      timer_(Callback<void(Time)>::to<&Switching::advance>(*this)) {
  std::size_t count = 0;
  each_status(table, [&](const FieldPlace& place) {
    must_hold(count < fields_.size());
    fields_[count++].place = place;
  });
  for (const Rest& rest : table.rests) find(rest.status)->actual = rest.code;
  service_.reset = Callback<void(ResetScope)>::to<&Switching::reset>(*this);
  network.node().attach(service_);
}

/// The things are as they are: an NMT reset moves nothing.
void Switching::reset(ResetScope) {
  for (const Field& field : fields_) show(field);
}

void Switching::commanded(const Commanded& wanted) {
  if (hardware_.drive && hardware_.drive(wanted)) return;
  bool has_effect = false;
  for (const Effect& effect : table_.effects) {
    if (effect.command != wanted.place) continue;
    has_effect = true;
    if (effect.code == wanted.code) move(effect.status, effect.moving, effect.done, effect.takes);
  }
  if (has_effect) return;
  for (const Mirror& mirror : table_.mirrors) {
    if (mirror.command->index != wanted.place.index) continue;
    each_mirrored(mirror, [&](const FieldPlace& command, const FieldPlace& status) {
      if (command != wanted.place || !is_state(status, wanted.code)) return;
      const Field* field = find(status);
      move(status, field->actual, wanted.code, mirror.takes);
    });
  }
}

void Switching::move(const FieldPlace& status, std::uint32_t moving, std::uint32_t done,
                     Duration takes) {
  Field& field = *find(status);
  field.actual = takes > Duration::zero() ? moving : done;
  field.target = done;
  field.due = takes > Duration::zero() ? network_.node().now() + takes : never;
  show(field);
  if (field.due < timer_.at()) network_.node().timers().arm(timer_, field.due);
}

void Switching::advance(Time now) {
  Time next = never;
  for (Field& field : fields_) {
    if (field.due <= now) {
      field.actual = field.target;
      field.due = never;
      show(field);
    }
    next = std::min(next, field.due);
  }
  if (next != never) network_.node().timers().arm(timer_, next);
}

void Switching::report(const FieldPlace& status, std::uint32_t code) {
  Field* field = find(status);
  if (field == nullptr) return;
  field->actual = code;
  field->due = never;
  show(*field);
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

/// A status without a code for a failure (errata Z35) says that it is not available.
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
