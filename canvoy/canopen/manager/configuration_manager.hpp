// Configuration manager: brings slaves to their configuration in 1F22h (CiA 302-3).
//
// Objects 1F22h (concise DCF), 1F25h (configure a slave), 1F26h and 1F27h (expected configuration
// date and time), 1F8Ah (restore configuration, CiA 302-2), all optional. The content of 1F22h is a
// domain of the application with a known size, read in pieces; see FixedConfigurations for one in
// flash.
//
//     ConfigurationManager::Worker workers[] = {ConfigurationManager::Worker(node)};
//     ConfigurationManager manager(node, workers);
//     manager.on_done(ConfigurationManager::Done::to<&App::configured>(app));
//     manager.update(5);
//     manager.serve(boot_hooks);  // and each slave that an NMT master boots
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/boot_hooks.hpp"
#include "canvoy/canopen/manager/configuration_download.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Outcome of a slave's configuration.
struct ConfigurationOutcome {
  /// How it ended.
  enum class Kind : std::uint8_t {
    up_to_date,     ///< 1020h of the slave has the expected date and time: nothing was written
    downloaded,     ///< all entries, and date and time if they are expected
    nothing_known,  ///< neither a concise DCF nor an expected date: nothing to do
    failed,
  };
  Kind kind = Kind::failed;  ///< see Kind
  SdoEnd end = {};
  /// Object of the slave at which it failed; 0: the concise DCF itself is wrong.
  std::uint16_t index = 0;
  std::uint8_t sub = 0;       ///< sub-index
  std::uint32_t written = 0;  ///< number of entries
};

/// Configures slaves. For a slave with an expected date or time, its 1020h is read first, and if
/// both are equal nothing is written. Otherwise the concise DCF is downloaded, and date and time
/// are written to 1020h afterwards. A slave without 1020h is configured each time; so is one
/// without an expected date and time. A slave with an expected configuration, a different actual
/// one, and no concise DCF fails (no_data).
///
/// In the boot-up procedure, a slave with 1F81h bit 7 set has its defaults restored before it is
/// configured: "load" is written to the sub-index of its 1011h that is in 1F8Ah (0: none), and it
/// is reset, for sub-index 2 its communication only.
///
/// As many slaves as there are workers are configured at a time; others wait, the lowest node-ID
/// first. For the NMT master's boot-up procedure there should be as many workers as slaves booted
/// at once. A reset of the manager's node discards all tasks without a call of on_done; NMT state
/// stopped fails them (device_state).
class ConfigurationManager {
 public:
  /// Called for a slave that update() or 1F25h asked for.
  using Done = Callback<void(NodeId, const ConfigurationOutcome&)>;
  /// Which slaves update() configures.
  enum class When : std::uint8_t {
    different,  ///< only if the slave's date and time differ
    always,
  };
  static constexpr std::uint32_t signature = 0x666E'6F63;  ///< "conf", written to 1F25h
  static constexpr std::uint8_t all_slaves = 128;          ///< sub-index of 1F25h

  /// Configures one slave at a time. Each needs a route of the node.
  class Worker {
   public:
    /// Makes a worker; `node` is that of the manager, and must outlive it.
    explicit Worker(Node& node) : node_(node), own_client_(node) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// True if no slave is being configured here.
    bool idle() const { return slave_ == 0; }
    /// Slave that is being configured; 0 while it is idle.
    NodeId slave() const { return slave_; }
    /// The download, for its progress.
    const ConfigurationDownload& download() const { return download_; }

   private:
    friend class ConfigurationManager;

    void begin(ConfigurationManager& manager, NodeId slave, When when);
    void begin(ConfigurationManager& manager, const BootTask& task);
    void begin(When when);
    /// Forgets the work in progress; the client of a boot task is in other use by now.
    void drop();
    void configure();
    void restored(SdoClient::Outcome outcome);
    void restarted(AbortCode answer);
    void download();
    AbortCode open_source(ByteSource& source);
    AbortCode read_source(std::uint32_t offset, std::span<std::uint8_t> bytes);
    void date_read(SdoClient::Outcome outcome);
    void time_read(SdoClient::Outcome outcome);
    void downloaded(const ConfigurationDownload::Outcome& outcome);
    void date_written(SdoClient::Outcome outcome);
    void time_written(SdoClient::Outcome outcome);
    template <auto step>
    void read_verification(std::uint8_t sub);
    template <auto step>
    void write_verification(std::uint8_t sub, std::uint32_t value);
    bool is_expected() const { return expected_date_ != 0 || expected_time_ != 0; }
    void fail(SdoEnd end, std::uint16_t index, std::uint8_t sub);
    void finish(ConfigurationOutcome outcome);

    Node& node_;
    SdoClient own_client_;
    SdoClient* client_ = nullptr;
    ConfigurationDownload download_;
    ConfigurationManager* manager_ = nullptr;
    const Domain* domain_ = nullptr;
    Entry entry_;  ///< 1F22h of this slave
    std::uint32_t expected_date_ = 0;
    std::uint32_t expected_time_ = 0;
    std::uint32_t written_ = 0;
    std::array<std::uint8_t, 4> buffer_{};
    NodeId slave_ = 0;
    std::uint8_t restore_sub_ = 0;   ///< of 1011h of the slave
    bool has_verification_ = false;  ///< the slave has 1020h
    BootTask task_{};                ///< that is under way, slave 0: none
    BootTask parked_{};              ///< that waits for any worker, slave 0: none
  };

  /// Both must outlive the manager.
  ConfigurationManager(Node& node, std::span<Worker> workers,
                       Duration time_out = SdoClient::default_time_out);
  ConfigurationManager(const ConfigurationManager&) = delete;
  ConfigurationManager& operator=(const ConfigurationManager&) = delete;

  /// Sets the callback that is called once for each slave requested by update() or by 1F25h.
  void on_done(Done done) { done_ = done; }

  /// Requests the configuration of a slave. Aborts: value_range (not a node-ID, or the manager's
  /// own), device_state (its configuration is under way, or waits).
  AbortCode update(NodeId slave, When when = When::different);

  /// Sets the hooks of the boot-up procedure to configure each slave (CiA 302-2; letter J on
  /// failure).
  void serve(BootHooks& hooks);
  /// Configures one slave of the boot-up procedure, on the client of the task. Replaces what was
  /// under way for the slave. Ends with out_of_memory if there are fewer workers than such tasks.
  void boot(const BootTask& task);
  /// Ends the task for a slave of the boot-up procedure without an answer to it.
  void abandon(NodeId slave);

  /// True if the configuration of a slave is under way, or waits.
  bool busy(NodeId slave) const { return slave <= node_id_max && wanted_[slave]; }

 private:
  void reset(ResetScope scope);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void after_write(const Entry& entry, Source source);
  bool has_configuration(NodeId slave) const;
  void begin_waiting(Time now);
  void begin_parked();
  void drop(NodeId slave);
  void finished(Worker& worker, const ConfigurationOutcome& outcome);

  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;

  Node& node_;
  std::span<Worker> workers_;
  Duration time_out_;
  Done done_;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;  ///< begins waiting work, so that it never begins within a call of done
  std::bitset<node_id_max + 1> wanted_;   ///< waiting or under way
  std::bitset<node_id_max + 1> started_;  ///< under way
  std::bitset<node_id_max + 1> always_;   ///< independent of date and time
};

}  // namespace canvoy
