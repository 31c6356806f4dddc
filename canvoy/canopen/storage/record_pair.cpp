#include "canvoy/canopen/storage/record_pair.hpp"

#include <algorithm>
#include <array>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

/// Size of the pieces that go to the flash: a multiple of every unit.
constexpr std::size_t piece_size = RecordHead::size;
using Piece = std::array<std::uint8_t, piece_size>;

}  // namespace

RecordState RecordPair::find() {
  if (!await_flash()) {
    newest_ = nowhere;
    head_ = {};
    return state_ = RecordState::unreadable;
  }
  RecordHead heads[2];
  const HeadState first = read_head(flash_, slot(0), heads[0]);
  const HeadState second = read_head(flash_, slot(1), heads[1]);
  newest_ = nowhere;
  if (first == HeadState::good) newest_ = 0;
  if (second == HeadState::good && (newest_ == nowhere || heads[1].newer_than(heads[0]))) {
    newest_ = 1;
  }
  head_ = newest_ == nowhere ? RecordHead{} : heads[newest_];
  state_ = judge(first, second);
  check_invariant(state_ != RecordState::valid || newest_ != nowhere);
  return state_;
}

/// A cancelled attempt may still be in progress in the flash, which cannot be read meanwhile.
bool RecordPair::await_flash() {
  for (unsigned polls = 0; waiting_ && polls < polls_max; ++polls) {
    waiting_ = flash_.poll() == FlashState::busy;
  }
  return !waiting_;
}

RecordState RecordPair::judge(HeadState first, HeadState second) const {
  if (first == HeadState::unreadable || second == HeadState::unreadable) {
    return RecordState::unreadable;
  }
  if (newest_ != nowhere) return judge_newest();
  const bool blank = first == HeadState::blank && second == HeadState::blank;
  return blank ? RecordState::empty : RecordState::damaged;
}

RecordState RecordPair::judge_newest() const {
  if (head_.kind != place_.kind) return RecordState::foreign;
  if (head_.format != RecordHead::present_format) return RecordState::other_format;
  if (head_.length > capacity()) return RecordState::too_long;
  const auto crc = crc32_of(flash_, slot(newest_) + RecordHead::size, head_.length);
  if (!crc) return RecordState::unreadable;
  if (*crc != head_.crc) return RecordState::damaged;
  if (head_.signature[0] != signature_[0]) return RecordState::foreign;
  return head_.signature[1] == signature_[1] ? RecordState::valid : RecordState::outdated;
}

bool RecordPair::read(std::uint32_t offset, std::span<std::uint8_t> bytes) const {
  if (newest_ == nowhere || offset > head_.length || bytes.size() > head_.length - offset) {
    return false;
  }
  return flash_.read(slot(newest_) + RecordHead::size + offset, bytes);
}

void RecordPair::begin(const RecordSource& source) {
  source_ = source;
  attempts_ = 0;
  outcome_ = AbortCode::none;
  phase_ = Phase::resume;
}

RecordStep RecordPair::step() {
  if (waiting_) {
    const FlashState state = flash_.poll();
    if (state == FlashState::busy) return RecordStep::wait;
    waiting_ = false;
    // In `resume` it is an earlier attempt that has ended.
    if (state == FlashState::failed && phase_ > Phase::resume) {
      if (phase_ < Phase::secure) return finish(AbortCode::hardware);
      outcome_ = AbortCode::hardware;
    }
  }
  return phase_ == Phase::idle ? RecordStep::done : proceed();
}

RecordStep RecordPair::proceed() {
  switch (phase_) {
    case Phase::resume:
      return go_on(in_doubt_ ? flash_.sync() : FlashState::done, Phase::compare);
    case Phase::compare:
      return compare();
    case Phase::erase:
      return erase();
    case Phase::write:
      return write();
    case Phase::settle:
      return go_on(flash_.sync(), Phase::commit);
    case Phase::commit:
      return commit();
    case Phase::secure:
      return go_on(flash_.sync(), Phase::check);
    case Phase::check:
      return check();
    case Phase::idle:
      break;
  }
  return RecordStep::done;
}

/// Compares with the present contents of the flash: an earlier attempt may have left its record
/// there.
RecordStep RecordPair::compare() {
  in_doubt_ = false;
  if (find() == RecordState::unreadable) return finish(AbortCode::hardware);
  if (state_ == RecordState::valid && holds(newest_, head_.length)) {
    return finish(AbortCode::none);
  }
  offset_ = 0;
  return go_on(FlashState::done, Phase::erase);
}

/// The sector with the head is erased first, so that no head precedes incomplete content.
RecordStep RecordPair::erase() {
  const FlashState state = flash_.erase(slot(free_slot()) + offset_);
  offset_ += flash_.sector_size;
  if (offset_ < place_.slot_size) return go_on(state, Phase::erase);
  offset_ = 0;
  return go_on(state, Phase::write);
}

RecordStep RecordPair::write() {
  // Not while a sector is still being erased: the source may read from the newest record.
  if (offset_ == 0) {
    programmed_ = {};
    source_.rewind();
  }
  check_invariant(offset_ <= capacity());
  Piece piece;
  piece.fill(0xFF);
  const Result<std::size_t> filled = source_.next(piece);
  if (!filled) return finish(filled.abort());
  const std::size_t size = *filled;
  if (size > capacity() - offset_) return finish(AbortCode::out_of_memory);
  programmed_.add(std::span(piece).first(size));
  const std::uint32_t address = slot(free_slot()) + RecordHead::size + offset_;
  offset_ += static_cast<std::uint32_t>(size);
  const Phase next = size == piece.size() ? Phase::write : Phase::settle;
  if (size == 0) return go_on(FlashState::done, next);
  const std::size_t whole_units = (size + flash_.unit - 1) / flash_.unit * flash_.unit;
  return go_on(flash_.program(address, std::span(piece).first(whole_units)), next);
}

/// The content is compared and made valid in one step: nothing can change in between.
RecordStep RecordPair::commit() {
  if (!holds(free_slot(), offset_)) return try_again();
  in_doubt_ = true;
  return go_on(flash_.program(slot(free_slot()), successor().bytes()), Phase::secure);
}

/// Whatever the flash answered, the readable record applies; but the attempt fails if the flash
/// does not confirm that it lasts.
RecordStep RecordPair::check() {
  const RecordHead wanted = successor();
  RecordHead head;
  const bool good = read_head(flash_, slot(free_slot()), head) == HeadState::good;
  if (!good || head.bytes() != wanted.bytes()) return finish(AbortCode::hardware);
  newest_ = free_slot();
  head_ = head;
  state_ = RecordState::valid;
  in_doubt_ = outcome_ != AbortCode::none;
  return finish(outcome_);
}

/// Either the flash has other contents than programmed, or the values have changed since.
RecordStep RecordPair::try_again() {
  if (++attempts_ < attempts_max) {
    offset_ = 0;
    return go_on(FlashState::done, Phase::erase);
  }
  const auto kept = crc32_of(flash_, slot(free_slot()) + RecordHead::size, offset_);
  return finish(kept == programmed_.value() ? AbortCode::device_state : AbortCode::hardware);
}

bool RecordPair::holds(std::size_t slot_number, std::uint32_t length) const {
  Piece wanted;
  Piece kept;
  std::size_t size = piece_size;
  source_.rewind();
  for (std::uint32_t offset = 0; size == piece_size; offset += piece_size) {
    check_invariant(offset <= length);
    const Result<std::size_t> filled = source_.next(wanted);
    if (!filled) return false;
    size = *filled;
    if (size > length - offset || (size < piece_size && size != length - offset)) {
      return false;
    }
    const auto place = std::span(kept).first(size);
    if (!flash_.read(slot(slot_number) + RecordHead::size + offset, place)) return false;
    if (!std::ranges::equal(place, std::span(wanted).first(size))) return false;
  }
  return true;
}

/// Head of the record that is being written.
RecordHead RecordPair::successor() const {
  return {.kind = place_.kind,
          .sequence = head_.sequence + 1,
          .length = offset_,
          .crc = programmed_.value(),
          .signature = signature_};
}

/// From `secure` on a failure ends nothing: the readable record applies. But the failure is
/// reported.
RecordStep RecordPair::go_on(FlashState state, Phase next) {
  if (state == FlashState::failed) {
    if (next < Phase::secure) return finish(AbortCode::hardware);
    outcome_ = AbortCode::hardware;
  }
  phase_ = next;
  waiting_ = state == FlashState::busy;
  return waiting_ ? RecordStep::wait : RecordStep::again;
}

RecordStep RecordPair::finish(AbortCode outcome) {
  phase_ = Phase::idle;
  outcome_ = outcome;
  return RecordStep::done;
}

}  // namespace canvoy
