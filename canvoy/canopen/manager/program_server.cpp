#include "canvoy/canopen/manager/program_server.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr std::uint32_t program_record = 0x5250'4F43;  ///< "COPR"

std::uint32_t capacity(const ProgramSlot& slot) {
  return slot.size - ProgramSlot::head_size;
}

std::uint32_t content(const ProgramSlot& slot) {
  return slot.address + ProgramSlot::head_size;
}

}  // namespace

constexpr AccessHandlers ProgramServer::hook_calls = {
    .first = program::control,
    .last = program::control,
    .before_write = method<&ProgramServer::before_control>,
    .after_write = method<&ProgramServer::control_written>};
constexpr ServiceHandlers ProgramServer::service_calls = {.reset = method<&ProgramServer::reset>,
                                                          .hooks = {&hook_calls, 1}};

ProgramServer::ProgramServer(Node& node, const Flash& flash, std::span<ProgramSlot> slots,
                             const ProgramHooks& hooks)
    : ProgramServer(node, flash, slots, hooks, Settings{}) {}

ProgramServer::ProgramServer(Node& node, const Flash& flash, std::span<ProgramSlot> slots,
                             const ProgramHooks& hooks, const Settings& settings)
    : node_(node),
      flash_(flash),
      slots_(slots),
      hooks_(hooks),
      settings_(settings),
      timer_(callback<&ProgramServer::clear_on>(*this)) {
  for (ProgramSlot& slot : slots_) find(slot);
  domain_.open_write = decltype(Domain::open_write)::to<&ProgramServer::open_write>(*this);
  domain_.write = decltype(Domain::write)::to<&ProgramServer::write>(*this);
  domain_.close_write = decltype(Domain::close_write)::to<&ProgramServer::close_write>(*this);
  data_hook_.first = data_hook_.last = program::data;
  data_hook_.domain = &domain_;
  node_.dictionary().attach(data_hook_);
  node_.attach(service_);
}

/// Determines the contents of a slot after power-on.
void ProgramServer::find(ProgramSlot& slot) const {
  RecordHead head;
  const HeadState state = read_head(flash_, slot.address, head);
  slot.valid = state == HeadState::good && head.kind == program_record &&
               head.format == RecordHead::present_format && head.length <= capacity(slot) &&
               crc32_of(flash_, content(slot), head.length) == head.crc;
  slot.cleared = state == HeadState::blank && is_blank(slot);
  if (!slot.valid) head = {};
  slot.length = head.length;
  slot.identification = head.crc;
  slot.date = head.signature;
  slot.status = FlashStatus(slot.valid ? FlashError::none : FlashError::no_valid_program);
}

bool ProgramServer::is_blank(const ProgramSlot& slot) const {
  std::array<std::uint8_t, piece_size> piece;
  for (std::uint32_t offset = 0; offset < slot.size; offset += piece_size) {
    if (!flash_.read(slot.address + offset, piece)) return false;
    if (std::ranges::any_of(piece, [](std::uint8_t byte) { return byte != 0xFF; })) return false;
  }
  return true;
}

/// Sets values again after the dictionary got its defaults.
void ProgramServer::reset(ResetScope) {
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    publish(static_cast<std::uint8_t>(slot + 1));
  }
  if (slots_.empty()) return;
  node_.dictionary().set_number(program::verify, 1, slots_[0].date[0]);
  node_.dictionary().set_number(program::verify, 2, slots_[0].date[1]);
}

void ProgramServer::publish(std::uint8_t number) {
  const ProgramSlot& slot = slots_[number - std::size_t{1}];
  Dictionary& dictionary = node_.dictionary();
  dictionary.set_number(program::control, number, slot.running ? 1 : 0);
  dictionary.set_number(program::identification, number, slot.identification);
  dictionary.set_number(program::status, number, slot.status.raw());
}

ProgramSlot* ProgramServer::slot_of(const Entry& entry) {
  if (entry.sub < 1 || entry.sub > slots_.size()) return nullptr;
  return &slots_[entry.sub - std::size_t{1}];
}

AbortCode ProgramServer::before_control(const Entry& entry, std::span<const std::uint8_t> value) {
  ProgramSlot* slot = slot_of(entry);
  if (slot == nullptr) return AbortCode::unsupported_access;
  return command(*slot, entry.sub, static_cast<ProgramCommand>(value[0]));
}

/// The entry reads as the state of the program, not as the last command.
void ProgramServer::control_written(const Entry& entry, Source) {
  publish(entry.sub);
}

AbortCode ProgramServer::command(ProgramSlot& slot, std::uint8_t number, ProgramCommand command) {
  switch (command) {
    case ProgramCommand::start:
      return start(slot, number);
    case ProgramCommand::clear:
      return clear(slot, number);
    case ProgramCommand::stop: {
      const AbortCode answer = hooks_.control(number, command);
      if (answer == AbortCode::none) slot.running = false;
      return answer;
    }
    case ProgramCommand::reset:
      return hooks_.control(number, command);
  }
  return AbortCode::value_range;
}

AbortCode ProgramServer::start(ProgramSlot& slot, std::uint8_t number) {
  if (!slot.valid || number == number_) return AbortCode::device_state;
  const AbortCode answer = hooks_.control(number, ProgramCommand::start);
  if (answer == AbortCode::none) slot.running = true;
  return answer;
}

AbortCode ProgramServer::clear(ProgramSlot& slot, std::uint8_t number) {
  if (slot.running || number_ != nobody) return AbortCode::device_state;
  begin(number);
  waiting_ = false;
  node_.timers().arm(timer_, node_.now());
  return AbortCode::none;
}

/// The sector with the head is erased first: from then on there is no valid program.
void ProgramServer::clear_on(Time now) {
  FlashState state = waiting_ ? flash_.poll() : FlashState::done;
  if (state == FlashState::done && offset_ == present().size) {
    present().cleared = true;
    return end(FlashError::none);
  }
  if (state == FlashState::done) {
    state = flash_.erase(present().address + offset_);
    offset_ += flash_.sector_size;
  }
  if (state == FlashState::failed) return end(FlashError::write_error);
  waiting_ = state == FlashState::busy;
  node_.timers().arm(timer_, waiting_ ? now + settings_.poll_interval : now);
}

void ProgramServer::begin(std::uint8_t number) {
  number_ = number;
  offset_ = 0;
  ProgramSlot& slot = present();
  slot.valid = slot.cleared = false;
  slot.length = slot.identification = 0;
  slot.date = {};
  slot.status = FlashStatus(FlashError::none, true);
  publish(number);
  hooks_.under_way(true);
}

void ProgramServer::end(FlashError error) {
  const std::uint8_t number = number_;
  ProgramSlot& slot = present();
  slot.status = FlashStatus(error);
  if (!slot.valid) {
    slot.length = slot.identification = 0;
    slot.date = {};
  }
  number_ = nobody;
  publish(number);
  hooks_.under_way(false);
}

AbortCode ProgramServer::open_write(const Entry& entry, std::uint32_t size) {
  ProgramSlot* slot = slot_of(entry);
  if (slot == nullptr) return AbortCode::unsupported_access;
  if (slot->running || number_ != nobody) return AbortCode::device_state;
  if (!slot->cleared) {
    slot->status = FlashStatus(FlashError::not_cleared);
    publish(entry.sub);
    return AbortCode::device_state;
  }
  if (size > capacity(*slot)) return AbortCode::length_too_high;
  begin(entry.sub);
  gathered_ = 0;
  crc_ = {};
  return AbortCode::none;
}

AbortCode ProgramServer::write(const Entry&, std::span<const std::uint8_t> bytes) {
  if (bytes.size() > capacity(present()) - offset_ - gathered_) return AbortCode::length_too_high;
  crc_.add(bytes);
  for (const std::uint8_t byte : bytes) {
    piece_[gathered_++] = byte;
    if (gathered_ < piece_size || program_piece()) continue;
    present().status = FlashStatus(FlashError::write_error, true);
    return AbortCode::hardware;
  }
  return AbortCode::none;
}

bool ProgramServer::program_piece() {
  std::fill(piece_.begin() + gathered_, piece_.end(), std::uint8_t{0xFF});
  const std::size_t size = (gathered_ + flash_.unit - 1) / flash_.unit * flash_.unit;
  const std::uint32_t address = content(present()) + offset_;
  offset_ += gathered_;
  gathered_ = 0;
  return size == 0 || waited(flash_.program(address, std::span(piece_).first(size)));
}

/// Programming 32 bytes takes microseconds on most chips, and the client waits anyway.
bool ProgramServer::waited(FlashState state) const {
  for (std::uint32_t polls = 0; state == FlashState::busy && polls < settings_.polls_max; ++polls) {
    state = flash_.poll();
  }
  return state == FlashState::done;
}

AbortCode ProgramServer::close_write(const Entry&, bool complete) {
  if (number_ == nobody) return AbortCode::none;
  if (!complete || offset_ + gathered_ == 0) {
    const FlashError before = present().status.error();
    end(before == FlashError::none ? FlashError::no_valid_program : before);
    return complete ? AbortCode::length_too_low : AbortCode::none;
  }
  const FlashError error = program_piece() ? make_valid(present()) : FlashError::write_error;
  end(error);
  if (error == FlashError::none) return AbortCode::none;
  return error == FlashError::write_error ? AbortCode::hardware : AbortCode::cannot_store;
}

/// The flash is read once more, so that only its actual contents are valid; the head is written
/// last.
FlashError ProgramServer::make_valid(ProgramSlot& slot) {
  slot.length = offset_;
  slot.identification = crc_.value();
  if (!waited(flash_.sync())) return FlashError::write_error;
  if (crc32_of(flash_, content(slot), offset_) != crc_.value()) return FlashError::write_error;
  const FlashError refused = hooks_.check(number_, slot);
  if (refused != FlashError::none) return refused;
  if (number_ == 1) {
    slot.date = {static_cast<std::uint32_t>(node_.dictionary().number(program::verify, 1)),
                 static_cast<std::uint32_t>(node_.dictionary().number(program::verify, 2))};
  }
  const RecordHead head{.kind = program_record,
                        .length = slot.length,
                        .crc = slot.identification,
                        .signature = slot.date};
  // Whatever the flash answers, what can be read applies after power-on.
  waited(flash_.program(slot.address, head.bytes()));
  waited(flash_.sync());
  RecordHead found;
  slot.valid =
      read_head(flash_, slot.address, found) == HeadState::good && found.bytes() == head.bytes();
  return slot.valid ? FlashError::none : FlashError::write_error;
}

}  // namespace canvoy
