// Program manager: checks in the boot-up procedure that each slave has its expected program, and
// downloads it if allowed (CiA 302-2, letters G, H and I; CiA 302-3, objects 1F53h to 1F55h).
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

/// Source of the programs for slaves.
struct ProgramLibrary {
  /// Returns the length of the program for a slave; an abort code if there is none.
  Callback<Result<std::uint32_t>(NodeId slave)> open;
  /// Fills in all bytes from `offset` on.
  Callback<AbortCode(NodeId slave, std::uint32_t offset, std::span<std::uint8_t> bytes)> read;
};

/// Checks programs. For a slave with 1F81h bit 5 set, its 1F56h is compared with 1F55h, and its
/// 1F52h with 1F53h and 1F54h, each if it is not zero. If nothing is expected, the slave lacks the
/// object, or an update is needed and the library has none, the boot-up ends with G; if it is
/// needed and 1F81h bit 6 is not set, with H; if it fails, with I. The program number is 1.
class ProgramManager {
 public:
  /// Sees to one slave at a time.
  class Worker {
   public:
    /// Makes a worker; `node` must outlive it.
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

  /// Makes the manager. It needs as many workers as slaves booted at a time; a slave without a
  /// worker ends with I and out_of_memory. All arguments must outlive it.
  ProgramManager(std::span<Worker> workers, const ProgramLibrary& library,
                 const ProgramDownload::Settings& settings = default_settings)
      : workers_(workers), library_(library), settings_(settings) {}
  ProgramManager(const ProgramManager&) = delete;
  ProgramManager& operator=(const ProgramManager&) = delete;

  /// Sets the callback for each download that ended, called when the boot-up has continued.
  void on_update(Callback<void(NodeId, const ProgramOutcome&)> told) { told_ = told; }

  /// Sets the hooks of the boot-up procedure. An earlier function for abandoned slaves is still
  /// called.
  void serve(BootHooks& hooks);
  /// Checks the program of one slave, on the client of the task; BootHooks::update_program.
  void boot(const BootTask& task);
  /// Ends the task for a slave without an answer to it; BootHooks::abandon.
  void abandon(NodeId slave);

 private:
  static constexpr ProgramDownload::Settings default_settings{};

  std::span<Worker> workers_;
  ProgramLibrary library_;
  ProgramDownload::Settings settings_;
  Callback<void(NodeId)> abandoned_;
  Callback<void(NodeId, const ProgramOutcome&)> told_;
};

}  // namespace canvoy
