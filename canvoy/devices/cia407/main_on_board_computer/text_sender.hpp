// Sends texts and display mappings from the main on-board computer to other devices by SDO (CiA
// 407, 5.2): in order for each device, to several devices at a time, and again if a device does not
// answer.
//
//     sender.send(5, 0x6112, 1, octets);   // 6112h:01h of node 5
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/sdo/sdo_queue.hpp"

namespace canvoy::cia407 {

class TextSender {
 public:
  static constexpr std::size_t size_max = 128;    ///< of a plain text (errata 106)
  static constexpr std::size_t waiting_max = 64;  ///< texts
  static constexpr std::size_t servers_max = 4;   ///< written at a time
  static constexpr unsigned tries_max = 3;        ///< of a text at one device

  /// Makes a sender; `node` must outlive it and needs routes for its SDO clients.
  explicit TextSender(Node& node);

  /// False if the text is too long, too many are waiting, or there is no such node-ID. Time is that
  /// of the node.
  bool send(NodeId server, std::uint16_t index, std::uint8_t sub,
            std::span<const std::uint8_t> octets);
  /// Sends an object of four bytes, for example of a display mapping.
  bool send(NodeId server, std::uint16_t index, std::uint8_t sub, std::uint32_t number);

  /// Reads a number of at most four bytes; on_read() gets it. False if too many are waiting, or
  /// there is no such node-ID.
  bool read(NodeId server, std::uint16_t index, std::uint8_t sub);
  /// Called for each read value; nothing if it was refused, or not answered after all tries. The
  /// callback may read again.
  void on_read(Callback<void(NodeId server, std::optional<std::uint32_t> number)> read) {
    read_ = read;
  }

  /// Called for each text that has arrived or finally failed. The callback may send again.
  void on_done(Callback<void(NodeId server, bool has_arrived)> done) { done_ = done; }

  /// True if no text waits or is being written.
  bool is_idle() const { return queue_.idle(); }
  /// Number of texts that devices have taken.
  std::uint32_t delivered() const { return delivered_; }
  /// Number of texts that were refused, or not answered after all tries.
  std::uint32_t failed() const { return failed_; }

 private:
  struct Job {
    SdoRequest request;
    std::array<std::uint8_t, size_max> octets{};
    unsigned tries = 0;    ///< so far
    bool is_read = false;  ///< otherwise it is written
  };

  void done(SdoRequest& request);
  void finish(const Job& job, bool has_arrived);
  Job* free_job();

  SdoWorkers<servers_max> workers_;
  SdoQueue queue_;
  std::array<Job, waiting_max> jobs_;
  Callback<void(NodeId, bool)> done_;
  Callback<void(NodeId, std::optional<std::uint32_t>)> read_;
  std::uint32_t delivered_ = 0;
  std::uint32_t failed_ = 0;
};

}  // namespace canvoy::cia407
