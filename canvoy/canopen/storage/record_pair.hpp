// The newest of two records, and the other one's place for its successor: what is stored is the old
// record or the new one at any moment, whenever power fails.
//
// The writer goes step by step, so that nobody waits for the flash. When all is written it goes
// through the content once more at one point in time, compares it with what the flash holds, and
// only then makes it valid; so the record is a moment's whole truth, even where values changed
// while they were written.
//
//     RecordPair pair(flash, {.address = 0, .slot_size = 2048, .kind = kind});
//     if (pair.find() == RecordState::valid) pair.read(0, bytes);
//     pair.begin(content);
//     while (pair.step() != RecordStep::done) { ... }
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/record.hpp"

namespace canvoy {

/// What the newest record is worth.
enum class RecordState : std::uint8_t {
  valid,
  empty,    ///< there never was one
  damaged,  ///< it was changed since it was written
  other_format,
  foreign,     ///< of another kind of device
  outdated,    ///< of a device of this kind with another dictionary
  too_long,    ///< it says that it is longer than its place
  unreadable,  ///< the flash does not answer
};

enum class RecordStep : std::uint8_t {
  again,  ///< step() may be called at once
  wait,   ///< the flash is busy: step() again after a while
  done,   ///< see outcome()
};

/// The content of a record, piece by piece and as often as is wanted.
struct RecordSource {
  Callback<void()> rewind;
  /// Fills `bytes`, which are RecordHead::size, and says how many there were: fewer than asked for,
  /// and they were the last. An abort code ends the attempt.
  Callback<Result<std::size_t>(std::span<std::uint8_t> bytes)> next;
};

class RecordPair {
 public:
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot; the other one follows it
    std::uint32_t slot_size = 0;  ///< whole sectors
    std::uint32_t kind = 0;
  };

  /// `flash` must outlive this.
  RecordPair(const Flash& flash, const Place& place) : flash_(flash), place_(place) {}

  /// Finds the newest record, and reads all of it once. Where its place was begun to be overwritten
  /// by a successor that never came to its end, it is the older one: as long as there is one, an
  /// interrupted step is no damage. It waits for a flash that is still busy with a cancelled
  /// attempt, but not for ever: then it is unreadable.
  RecordState find();
  /// Who may read the records, and who writes them: its device and its dictionary.
  void sign(std::uint32_t device, std::uint32_t dictionary) { signature_ = {device, dictionary}; }

  /// Of the newest record, as find() or a finished step() left it: valid or outdated.
  std::uint32_t length() const { return head_.length; }
  bool read(std::uint32_t offset, std::span<std::uint8_t> bytes) const;

  /// Begins to write; it forgets an attempt before it. `source` must live until the end, and may
  /// read from the newest record. A content that is stored already is not written again.
  void begin(const RecordSource& source);
  /// `find` was called before. It answers `done` again where nothing was begun.
  RecordStep step();
  /// Stops writing; the old record stays, unless the head of the new one was already being
  /// programmed: then it is the one or the other. Whatever comes next looks which.
  void cancel() { phase_ = Phase::idle; }
  bool busy() const { return phase_ != Phase::idle; }
  /// Of the last attempt: none; out_of_memory (the slot is too small); hardware (the flash failed,
  /// or holds something else than was programmed, or does not say that it lasts); device_state (the
  /// content does not hold still).
  AbortCode outcome() const { return outcome_; }

 private:
  enum class Phase : std::uint8_t {
    idle,
    resume,  ///< after an attempt that may have left a head behind
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
  /// How often find() asks a flash that is busy: some seconds.
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
  bool in_doubt_ = false;      ///< whether the head that was programmed last is a lasting one
  std::uint8_t attempts_ = 0;  ///< that have failed
  AbortCode outcome_ = AbortCode::none;
  std::uint32_t offset_ = 0;  ///< in the slot that is erased, in the content that is written
  Crc32 programmed_;          ///< of the content, as it was handed to the flash
};

}  // namespace canvoy
