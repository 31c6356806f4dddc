#include "canvoy/devices/cia447/terminal/terminal_client.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

/// Objects of a part that can be locked here: its command, and the status with its holder.
struct PartObjects {
  TerminalPart part;
  const ObjectInfo* command;
  const ObjectInfo* status;
};
constexpr PartObjects terminal_parts[] = {
    {TerminalPart::number_pad, &number_pad_command_object, &number_pad_status_object},
    {TerminalPart::function_pad, &function_keys_command_object, &function_keys_status_object},
    {TerminalPart::display_1, &display_1_command_object, &display_1_status_object},
    {TerminalPart::display_2, &display_2_command_object, &display_2_status_object}};

/// Equal in all of them.
constexpr auto bits_of_access = place_of(display_1_status).bits;
constexpr unsigned access_mask = (1U << bits_of_access) - 1;

constexpr const PartObjects* find_part(unsigned part) {
  for (const PartObjects& one : terminal_parts) {
    if (static_cast<unsigned>(one.part) == part) return &one;
  }
  return nullptr;
}

/// Place of the present key of a pad.
constexpr FieldPlace key_place_of(TerminalPart pad) {
  return pad == TerminalPart::number_pad ? place_of(number_pad_user_interaction)
                                         : place_of(function_keys_user_interaction_key);
}

struct TextPlace {
  const ObjectInfo* object;
  TerminalPart part;
};
/// In the order of TerminalText.
constexpr TextPlace text_places[] = {{&display_1_title_object, TerminalPart::display_1},
                                     {&display_1_text_object, TerminalPart::display_1},
                                     {&display_2_text_object, TerminalPart::display_2}};

}  // namespace

constexpr AccessHandlers TerminalClient::hook_calls[] = {
    after_write<&TerminalClient::status_written<TerminalPart::number_pad>,
                number_pad_status_object>,
    after_write<&TerminalClient::status_written<TerminalPart::function_pad>,
                function_keys_status_object>,
    after_write<&TerminalClient::status_written<TerminalPart::display_1>, display_1_status_object>,
    after_write<&TerminalClient::status_written<TerminalPart::display_2>, display_2_status_object>,
    after_write<&TerminalClient::number_written, number_pad_user_interaction_object>,
    after_write<&TerminalClient::function_written, function_keys_user_interaction_object>};
constexpr ServiceHandlers TerminalClient::service_calls = {.reset = method<&TerminalClient::reset>,
                                                           .hooks = hook_calls};

TerminalClient::TerminalClient(CarNetwork& network, const TerminalClientSettings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(settings.terminal)),
      timer_(callback<&TerminalClient::go_on>(*this)) {
  next_lost_ = network.on_lost(callback<&TerminalClient::lost>(*this));
  network.node().attach(service_);
}

// Life of the node, and of the terminal.

void TerminalClient::reset(ResetScope) {
  client_.cancel();
  job_ = {};
  number_pad_ = function_pad_ = {};
  forget();
  go_on_soon();
}

void TerminalClient::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node != settings_.terminal) return;
  forget();
  not_before_ = network_.node().now() + settings_.retry;
  go_on_soon();
}

/// The state without a pressed key is kept: a terminal that was not received for a time, and has
/// not lost this device, does not send it again.
void TerminalClient::forget() {
  for (unsigned part = 0; part < states_.size(); ++part) let_go(part);
  to_check_ = lockable_part_count;
}

void TerminalClient::let_go(unsigned part) {
  states_[part].is_held = false;
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    if (number_of(text_places[i].part) == part) texts_[i].is_told = false;
  }
}

// Requests to the terminal.

void TerminalClient::want(TerminalPart part, bool is_wanted) {
  if (find_part(number_of(part)) == nullptr) return;
  states_[number_of(part)].is_wanted = is_wanted;
  go_on_soon();
}

void TerminalClient::show(TerminalText where, std::string_view text) {
  ShownText& shown = texts_[static_cast<unsigned>(where)];
  text = std::string_view(text.data(), std::min(text.size(), text_max));
  if (std::ranges::equal(std::span(shown.bytes).first(shown.length), text, {}, {},
                         [](char character) { return static_cast<std::uint8_t>(character); })) {
    return;
  }
  std::ranges::copy(text, shown.bytes.begin());
  shown.length = text.size();
  shown.is_told = false;
  go_on_soon();
}

/// Nothing is sent from within a callback of another object.
void TerminalClient::go_on_soon() {
  network_.node().timers().arm(timer_, std::max(network_.node().now(), not_before_));
}

void TerminalClient::go_on(Time now) {
  if (client_.busy()) return;  // its end continues
  if (now < not_before_) return network_.node().timers().arm(timer_, not_before_);
  if (now >= check_due_) {
    to_check_ = 0;
    check_due_ = now + settings_.check;
    network_.watch(settings_.terminal);
  }
  while (to_check_ < lockable_part_count && !states_[to_check_].is_held) ++to_check_;
  job_ = next_job(now);
  if (job_.kind == Job::Kind::none) return network_.node().timers().arm(timer_, next_time());
  start(job_);
}

/// Released parts go first: another device may wait for them. Refused parts do not prevent the use
/// of held ones.
TerminalClient::Job TerminalClient::next_job(Time now) const {
  for (unsigned part = 0; part < states_.size(); ++part) {
    if (states_[part].is_held && !states_[part].is_wanted) return {Job::Kind::release, part};
  }
  for (unsigned i = 0; i < texts_.size(); ++i) {
    if (has(text_places[i].part) && !texts_[i].is_told) return {Job::Kind::write, i};
  }
  for (unsigned part = 0; now >= look_due_ && part < states_.size(); ++part) {
    if (is_unknown_pad(part)) return {Job::Kind::look, part};
  }
  for (unsigned part = 0; now >= lock_due_ && part < states_.size(); ++part) {
    if (!states_[part].is_held && states_[part].is_wanted) return {Job::Kind::lock, part};
  }
  if (to_check_ < lockable_part_count) return {Job::Kind::check, to_check_};
  return {};
}

/// Time of the next action.
Time TerminalClient::next_time() const {
  const bool waits = std::ranges::any_of(
      states_, [](const PartWish& part) { return part.is_wanted && !part.is_held; });
  Time next = waits ? std::min(lock_due_, check_due_) : check_due_;
  for (unsigned part = 0; part < states_.size(); ++part) {
    if (is_unknown_pad(part)) next = std::min(next, look_due_);
  }
  return next;
}

TerminalClient::Pad* TerminalClient::pad_of(unsigned part) {
  if (part == number_of(TerminalPart::number_pad)) return &number_pad_;
  return part == number_of(TerminalPart::function_pad) ? &function_pad_ : nullptr;
}
const TerminalClient::Pad* TerminalClient::pad_of(unsigned part) const {
  if (part == number_of(TerminalPart::number_pad)) return &number_pad_;
  return part == number_of(TerminalPart::function_pad) ? &function_pad_ : nullptr;
}

/// A terminal that has not lost a device which boots does not send its keys again: a lock that
/// changes nothing is no event.
bool TerminalClient::is_unknown_pad(unsigned part) const {
  const Pad* const pad = pad_of(part);
  return pad != nullptr && !pad->is_known && states_[part].is_held;
}

void TerminalClient::start(const Job& job) {
  const auto started = job.kind == Job::Kind::write   ? start_write(job.what)
                       : job.kind == Job::Kind::check ? start_check(job.what)
                       : job.kind == Job::Kind::look  ? start_look(job.what)
                       : job.kind == Job::Kind::lock
                           ? start_command(job.what, AccessCommand::lock)
                           : start_command(job.what, AccessCommand::release);
  if (started != AbortCode::none) done(started);
}

AbortCode TerminalClient::start_write(unsigned text) {
  ShownText& shown = texts_[text];
  // A text that is set meanwhile is written after this one.
  shown.is_told = true;
  written_ = shown.bytes;
  return client_.download(settings_.terminal, text_places[text].object->index, 0,
                          std::span(written_).first(shown.length),
                          SdoClient::Done::to<&TerminalClient::done>(*this), settings_.time_out);
}

AbortCode TerminalClient::start_command(unsigned part, AccessCommand command) {
  // All other fields of a command are neutral.
  constexpr std::uint8_t other_bits = 0xFC;
  command_[0] = static_cast<std::uint8_t>(other_bits | static_cast<unsigned>(command));
  return client_.download(settings_.terminal, find_part(part)->command->index, 0, command_,
                          SdoClient::Done::to<&TerminalClient::done>(*this), settings_.time_out);
}

AbortCode TerminalClient::start_check(unsigned part) {
  return client_.upload(settings_.terminal, find_part(part)->status->index, 0, command_,
                        SdoClient::Done::to<&TerminalClient::done>(*this), settings_.time_out);
}

AbortCode TerminalClient::start_look(unsigned part) {
  return client_.upload(settings_.terminal, key_place_of(static_cast<TerminalPart>(part)).index, 0,
                        command_, SdoClient::Done::to<&TerminalClient::done>(*this),
                        settings_.time_out);
}

void TerminalClient::done(SdoClient::Outcome outcome) {
  const Time now = network_.node().now();
  const Job job = job_;
  job_ = {};
  const bool has_no_room = outcome == SdoEnd::by_server(AbortCode::value_range);
  const bool was_answered =
      outcome || has_no_room || outcome == SdoEnd::by_server(AbortCode::device_state);
  switch (job.kind) {
    case Job::Kind::none:
      break;
    case Job::Kind::lock:
      if (outcome) {
        states_[job.what].is_held = true;
        look_due_ = now + settings_.retry;
        break;
      }
      if (was_answered) let_go(job.what);
      lock_due_ = now + settings_.retry;
      break;
    case Job::Kind::check:
      if (job.what == to_check_) ++to_check_;
      if (outcome) take(job.what, command_[0]);
      break;
    case Job::Kind::look:
      look_due_ = now + settings_.retry;
      if (Pad* const pad = pad_of(job.what); pad != nullptr && !pad->is_known && outcome) {
        const FieldPlace place = key_place_of(static_cast<TerminalPart>(job.what));
        const unsigned key = command_[0] >> place.first_bit & ((1U << place.bits) - 1);
        *pad = {.is_armed = key == 0 && states_[job.what].is_held, .is_known = true};
      }
      break;
    case Job::Kind::release:
      // A terminal that does not answer loses this device, or releases the part on the next
      // request.
      if (was_answered) let_go(job.what);
      break;
    case Job::Kind::write:
      // A text without room has none the next time.
      if (outcome || has_no_room) break;
      texts_[job.what].is_told = false;
      if (was_answered) let_go(number_of(text_places[job.what].part));
      break;
  }
  if (!was_answered) not_before_ = now + settings_.retry;
  go_on_soon();
}

// Messages of the terminal.

bool TerminalClient::is_mine(TerminalAccess access) const {
  const unsigned mine = static_cast<unsigned>(TerminalAccess::vehicle) + network_.node().id();
  return static_cast<unsigned>(access) == mine;
}

template <TerminalPart part>
void TerminalClient::status_written(const Entry& entry) {
  const std::uint32_t status =
      read_field(network_.node().dictionary(), {entry.index, 0, 0, bits_of_access});
  take(number_of(part), static_cast<std::uint8_t>(status));
}

void TerminalClient::take(unsigned part, std::uint8_t status) {
  const bool is_held = is_mine(static_cast<TerminalAccess>(status & access_mask));
  if (is_held == states_[part].is_held) return;
  if (!is_held) let_go(part);
  if (is_held) states_[part].is_held = true;
  go_on_soon();
}

template <class Key>
void TerminalClient::look_at(Pad& pad, bool is_mine, Key key, const Callback<void(Key)>& pressed) {
  const bool is_key = key > Key::none && key < Key::several;
  const bool was_armed = pad.is_armed;
  pad.is_known = true;
  pad.is_armed = is_mine && key == Key::none;
  if (was_armed && is_mine && is_key && pressed) pressed(key);
}

void TerminalClient::number_written() {
  look_at(number_pad_, has(TerminalPart::number_pad),
          static_cast<NumberPadKey>(
              read_field(network_.node().dictionary(), place_of(number_pad_user_interaction))),
          number_pressed_);
}
void TerminalClient::function_written() {
  look_at(function_pad_, has(TerminalPart::function_pad),
          static_cast<FunctionKey>(read_field(network_.node().dictionary(),
                                              place_of(function_keys_user_interaction_key))),
          function_pressed_);
}

}  // namespace canvoy::cia447
