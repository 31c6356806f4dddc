// Program download, the end that is programmed, usually a bootloader (CiA 302-3, objects 1F50h to
// 1F52h, 1F56h, 1F57h).
//
//     ProgramSlot slots[] = {{.address = 0x8000, .size = 0x18000}};
//     ProgramServer programs(node, flash, slots, {.control = ...});
//     if (programs.is_valid(1)) jump_to(0x8000 + ProgramSlot::head_size);
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/program.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/record.hpp"

namespace canvoy {

/// The memory of one program, owned by the device. The first 32 bytes of its flash mark the program
/// behind them as complete; they are written last.
struct ProgramSlot {
  static constexpr std::uint32_t head_size = RecordHead::size;  ///< in bytes

  std::uint32_t address = 0;  ///< of the slot in the flash
  std::uint32_t size = 0;     ///< whole sectors

  // Present contents, maintained by the server.
  std::uint32_t length = 0;                ///< of the program
  std::uint32_t identification = 0;        ///< its CRC-32
  std::array<std::uint32_t, 2> date = {};  ///< days since 1984, ms since midnight
  FlashStatus status = {};                 ///< value of 1F57h
  bool valid = false;                      ///< complete, and as it was downloaded
  bool cleared = false;                    ///< ready for a download
  bool running = false;                    ///< as ProgramHooks::control has done
};

/// The device's part of the download. All functions are optional.
struct ProgramHooks {
  /// Stops, starts or resets program `number` (from 1); an abort code refuses.
  Callback<AbortCode(std::uint8_t number, ProgramCommand)> control;
  /// Checks whether a downloaded program is for this device: called before it becomes valid.
  Callback<FlashError(std::uint8_t number, const ProgramSlot&)> check;
  /// For indicators: a download or a clearing began or ended.
  Callback<void(bool under_way)> under_way;
};

/// A server. Sub-index n of the objects is slot n - 1. Programs are streamed into the flash, 32
/// bytes at a time, and never held in memory. A program is valid when all of it has arrived and the
/// flash holds it; if power fails before that, there is no valid program.
///
/// A download is refused with 0800 0022h while the program runs, while the flash is busy, and if
/// the slot was not cleared (then 1F57h reports it); one that is too long with 0607 0012h. Clearing
/// continues after its answer, a sector at a time, while 1F57h is busy. 1F51h refuses an unknown
/// command with 0609 0030h; starting an invalid program and clearing a running one with 0800 0022h.
///
/// Date and time that a client writes to 1F52h before a download ends are kept with program 1.
class ProgramServer {
 public:
  /// Times of waiting for the flash.
  struct Settings {
    Duration poll_interval = 1ms;  ///< of the flash, while it is busy
    /// Limit of polls of the flash until the bytes of a download are programmed; the download waits
    /// meanwhile.
    std::uint32_t polls_max = 100'000;
  };

  /// Makes the server, and reads all programs once. All arguments must outlive it.
  ProgramServer(Node& node, const Flash& flash, std::span<ProgramSlot> slots,
                const ProgramHooks& hooks = {});
  /// Like the above, with other times.
  ProgramServer(Node& node, const Flash& flash, std::span<ProgramSlot> slots,
                const ProgramHooks& hooks, const Settings& settings);
  ~ProgramServer() { node_.timers().disarm(timer_); }
  ProgramServer(const ProgramServer&) = delete;
  ProgramServer& operator=(const ProgramServer&) = delete;

  /// True if program `number` (from 1, must exist) is complete.
  bool is_valid(std::uint8_t number) const { return slots_[number - std::size_t{1}].valid; }

 private:
  static constexpr std::size_t piece_size = RecordHead::size;
  static constexpr std::uint8_t nobody = 0;

  void find(ProgramSlot& slot) const;
  bool is_blank(const ProgramSlot& slot) const;
  ProgramSlot& present() const { return slots_[number_ - std::size_t{1}]; }
  void reset(ResetScope scope);
  void publish(std::uint8_t number);
  ProgramSlot* slot_of(const Entry& entry);

  AbortCode before_control(const Entry& entry, std::span<const std::uint8_t> value);
  void control_written(const Entry& entry, Source source);
  AbortCode command(ProgramSlot& slot, std::uint8_t number, ProgramCommand command);
  AbortCode start(ProgramSlot& slot, std::uint8_t number);
  AbortCode clear(ProgramSlot& slot, std::uint8_t number);
  void clear_on(Time now);
  void begin(std::uint8_t number);
  void end(FlashError error);

  AbortCode open_write(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close_write(const Entry& entry, bool complete);
  bool program_piece();
  FlashError make_valid(ProgramSlot& slot);
  bool waited(FlashState state) const;

  Node& node_;
  const Flash& flash_;
  std::span<ProgramSlot> slots_;
  ProgramHooks hooks_;
  Settings settings_;

  std::uint8_t number_ = nobody;  ///< of the program being cleared or downloaded
  bool waiting_ = false;          ///< for the erasure of a sector
  std::uint32_t offset_ = 0;      ///< in the slot being cleared, in the program being downloaded
  std::uint8_t gathered_ = 0;
  std::array<std::uint8_t, piece_size> piece_{};
  Crc32 crc_;

  Timer timer_;
  Domain domain_;
  Hook data_hook_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
