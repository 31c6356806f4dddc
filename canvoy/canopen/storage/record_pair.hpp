// The newer of two records, with the other slot for its successor: at any moment, the stored record
// is the old or the new one, whenever power fails.
//
// The writer works in steps, so that no caller waits for the flash. When all is written it checks
// the content once more at one point in time, compares it with the flash, and only then makes it
// valid; so the record is consistent at that moment, even if values changed while they were
// written.
//
//     RecordPair pair(flash, {.address = 0, .slot_size = 2048, .kind = kind});
//     if (pair.find() == RecordState::valid) pair.read(0, bytes);
//     pair.begin(content);
//     while (pair.step() != RecordStep::done) { ... }
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/record.hpp"

namespace canvoy {

/// State of the newest record.
enum class RecordState : std::uint8_t {
  valid,
  empty,    ///< there never was a record
  damaged,  ///< changed since it was written
  other_format,
  foreign,     ///< of another kind of device
  outdated,    ///< of this kind of device with another dictionary
  too_long,    ///< its stated length exceeds its slot
  unreadable,  ///< the flash does not answer
};

/// What a caller of step() does next.
enum class RecordStep : std::uint8_t {
  again,  ///< step() may be called at once
  wait,   ///< the flash is busy: call step() again later
  done,   ///< see outcome()
};

/// The content of a record, in pieces and as often as required.
struct RecordSource {
  /// Begins again with the first byte; called before each pass.
  Callback<void()> rewind;
  /// Fills `bytes`, which are RecordHead::size long, and returns their number: fewer mark the end.
  /// An abort code ends the attempt.
  Callback<Result<std::size_t>(std::span<std::uint8_t> bytes)> next;
};

/// Two slots of a flash: the newer record, and room for the next.
class RecordPair {
 public:
  /// Where the slots are, and what is kept there.
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot; the other follows it
    std::uint32_t slot_size = 0;  ///< whole sectors
    std::uint32_t kind = 0;       ///< of the record: others are foreign
  };

  /// Makes the pair; `flash` must outlive it.
  RecordPair(const Flash& flash, const Place& place) : flash_(flash), place_(place) {}

  /// Finds the newest record, and reads all of it once. If its slot was partly overwritten by an
  /// incomplete successor, the older record is the newest: as long as there is one, an interrupted
  /// step is no damage. It waits for a flash that is still busy with a cancelled attempt, for a
  /// limited time: then the record is unreadable.
  RecordState find();
  /// Sets the signature of readers and writer: device and dictionary.
  void sign(std::uint32_t device, std::uint32_t dictionary) { signature_ = {device, dictionary}; }

  /// Length of the newest record after find() or a finished step(): valid or outdated.
  std::uint32_t length() const { return head_.length; }
  /// Reads from the newest record. False if the flash does not answer, or it is beyond its end.
  bool read(std::uint32_t offset, std::span<std::uint8_t> bytes) const;

  /// Begins to write; discards an earlier attempt. `source` must live until the end, and may read
  /// from the newest record. Content that is stored already is not written again.
  void begin(const RecordSource& source);
  /// Carries out a step; find() must be called before. Returns `done` again if nothing was begun.
  RecordStep step();
  /// Stops writing; the old record stays, unless the head of the new one was already being
  /// programmed: then it is either of them, and the next call determines which.
  void cancel() { phase_ = Phase::idle; }
  /// True from begin() until the end or cancel().
  bool busy() const { return phase_ != Phase::idle; }
  /// Result of the last attempt: none; out_of_memory (the slot is too small); hardware (the flash
  /// failed, holds other data than programmed, or does not confirm that it lasts); device_state
  /// (the content keeps changing).
  AbortCode outcome() const { return outcome_; }

 private:
  enum class Phase : std::uint8_t {
    idle,
    resume,  ///< after an attempt that may have left a head
    compare,
    erase,
    write,
    settle,
    commit,
    secure,
    check
  };
  static constexpr unsigned attempts_max = 3;
  static constexpr std::size_t nowhere = 2;
  /// Limit of polls of a busy flash in find(): some seconds.
  static constexpr unsigned polls_max = 1'000'000;

  std::uint32_t slot(std::size_t number) const {
    return place_.address + static_cast<std::uint32_t>(number) * place_.slot_size;
  }
  std::uint32_t capacity() const { return place_.slot_size - RecordHead::size; }
  std::size_t free_slot() const { return newest_ == 0 ? 1 : 0; }

  bool await_flash();
  RecordState judge(HeadState first, HeadState second) const;
  RecordState judge_newest() const;
  RecordStep proceed();
  RecordStep compare();
  RecordStep erase();
  RecordStep write();
  RecordStep commit();
  RecordStep check();
  RecordStep try_again();
  bool holds(std::size_t slot_number, std::uint32_t length) const;
  RecordHead successor() const;
  RecordStep go_on(FlashState state, Phase next);
  RecordStep finish(AbortCode outcome);

  const Flash& flash_;
  Place place_;
  std::array<std::uint32_t, 2> signature_ = {};
  RecordHead head_;               ///< of the newest record
  std::size_t newest_ = nowhere;  ///< its slot
  RecordState state_ = RecordState::empty;

  RecordSource source_;
  Phase phase_ = Phase::idle;
  bool waiting_ = false;       ///< for the flash
  bool in_doubt_ = false;      ///< unclear whether the head that was programmed last is permanent
  std::uint8_t attempts_ = 0;  ///< number of failed attempts
  AbortCode outcome_ = AbortCode::none;
  std::uint32_t offset_ = 0;  ///< in the slot being erased, in the content being written
  Crc32 programmed_;          ///< of the content as passed to the flash
};

}  // namespace canvoy
