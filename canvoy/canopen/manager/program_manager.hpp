// Program manager: sees in the boot-up procedure that each slave has the program that is expected
// of it, and downloads that where it may (CiA 302-2, letters G, H and I; CiA 302-3, objects 1F53h
// to 1F55h).
//
//     ProgramManager::Worker workers[] = {ProgramManager::Worker(node)};  // one for each boot slot
//     ProgramManager programs(workers, {.open = ..., .read = ...});
//     configurations.serve(hooks);
//     programs.serve(hooks);  // the last one
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/manager/boot_hooks.hpp"
#include "canvoy/canopen/manager/program_download.hpp"

namespace canvoy {

/// Where the programs of the slaves are.
struct ProgramLibrary {
  /// How long the program for a slave is; an abort code where there is none.
  Callback<Result<std::uint32_t>(NodeId slave)> open;
  /// Fills in the bytes from `offset` on, all that are asked for.
  Callback<AbortCode(NodeId slave, std::uint32_t offset, std::span<std::uint8_t> bytes)> read;
};

/// For a slave of which 1F81h bit 5 asks for the check: its 1F56h is compared with 1F55h, and its
/// 1F52h with 1F53h and 1F54h, each where that is not zero. Where nothing is expected, or the slave
/// lacks the object, or an update is needed and the library has none, the boot-up ends with G;
/// where it is needed and 1F81h bit 6 is not set, with H; where it fails, with I. Program 1 is
/// meant.
class ProgramManager {
 public:
  class Worker;

  /// With as many workers as slaves are booted at a time; one too many ends with I and
  /// out_of_memory. All must outlive this.
  ProgramManager(std::span<Worker> workers, const ProgramLibrary& library,
                 const ProgramDownload::Settings& settings = default_settings)
      : workers_(workers), library_(library), settings_(settings) {}
  ProgramManager(const ProgramManager&) = delete;
  ProgramManager& operator=(const ProgramManager&) = delete;

  /// Called for each download that ended, when the boot-up has gone on.
  void on_update(Callback<void(NodeId, const ProgramOutcome&)> told) { told_ = told; }

  /// Who was to be told of abandoned slaves goes on being told.
  void serve(BootHooks& hooks);
  void boot(const BootTask& task);
  void abandon(NodeId slave);

 private:
  static constexpr ProgramDownload::Settings default_settings{};

  std::span<Worker> workers_;
  ProgramLibrary library_;
  ProgramDownload::Settings settings_;
  Callback<void(NodeId)> abandoned_;
  Callback<void(NodeId, const ProgramOutcome&)> told_;
};

/// Sees to one slave at a time.
class ProgramManager::Worker {
 public:
  explicit Worker(Node& node) : node_(node) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

 private:
  friend class ProgramManager;

  /// What a slave has to have.
  struct Check {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::uint32_t expected = 0;
  };

  bool idle() const { return task_.slave == 0; }
  void begin(ProgramManager& manager, const BootTask& task);
  void drop();
  void check();
  void checked(SdoClient::Outcome outcome);
  void update();
  void download(std::uint32_t size);
  Result<std::size_t> supply(std::span<std::uint8_t> bytes);
  void downloaded(const ProgramOutcome& outcome);
  std::uint32_t expected(std::uint16_t index) const;
  void finish(BootError error, SdoEnd end = {});

  Node& node_;
  ProgramManager* manager_ = nullptr;
  BootTask task_{};  ///< slave 0: none
  std::array<Check, 3> checks_{};
  std::size_t position_ = 0;  ///< in the checks
  std::uint32_t size_ = 0;
  std::uint32_t offset_ = 0;  ///< in the program
  std::array<std::uint8_t, 4> value_{};
  std::optional<ProgramDownload> download_;
};

}  // namespace canvoy
