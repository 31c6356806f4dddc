// Writes a concise DCF into a slave, entry by entry by SDO (CiA 302-3).
//
//     ConfigurationDownload download;
//     AbortCode refused = download.start(client, 5, source,
//                                        ConfigurationDownload::Done::to<&App::configured>(app));
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/concise_dcf.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// A download. All of the concise DCF is checked before the first entry is written, so that a
/// malformed one changes nothing. It stops at the first entry that the slave refuses; entries
/// written before stay.
class ConfigurationDownload {
 public:
  /// End of a download: done, or the reason, with the entry that was refused. If the concise DCF
  /// itself is wrong, the index is 0.
  struct Outcome {
    SdoEnd end = {};
    std::uint16_t index = 0;    ///< of the object that was refused
    std::uint8_t sub = 0;       ///< sub-index
    std::uint32_t written = 0;  ///< number of entries
  };
  /// Called once at the end, with how far it came.
  using Done = Callback<void(const Outcome&)>;

  ConfigurationDownload() = default;
  ConfigurationDownload(const ConfigurationDownload&) = delete;
  ConfigurationDownload& operator=(const ConfigurationDownload&) = delete;

  /// Starts a download. It uses `client` and `source` until `done` is called, once. `done` is not
  /// called for an immediate refusal: device_state (a download is under way), no_data (an empty
  /// concise DCF), the aborts of ConciseDcf, those of SdoClient::download().
  AbortCode start(SdoClient& client, NodeId slave, const ByteSource& source, Done done,
                  Duration time_out = SdoClient::default_time_out);
  /// Ends it without a call of `done`, and notifies the slave.
  void cancel();
  /// Ends it without using the client, which belongs to another service already.
  void forget() { busy_ = false; }

  /// True from start() until `done` or cancel().
  bool busy() const { return busy_; }
  /// Number of entries in the concise DCF.
  std::uint32_t entries() const { return dcf_.count(); }
  /// Number of entries that the slave has taken.
  std::uint32_t entries_written() const { return written_; }

 private:
  AbortCode write_next();
  AbortCode write_short();
  AbortCode write_long();
  Result<std::size_t> supply(std::span<std::uint8_t> bytes);
  void written(SdoClient::Outcome outcome);
  void finish(SdoEnd end);

  SdoClient* client_ = nullptr;
  ConciseDcf dcf_;
  ConciseDcf::Item item_;
  Done done_;
  Duration time_out_{};
  std::uint32_t supplied_ = 0;  ///< bytes of the present value
  std::uint32_t written_ = 0;
  std::array<std::uint8_t, 4> buffer_{};
  NodeId slave_ = 0;
  bool busy_ = false;
};

}  // namespace canvoy
