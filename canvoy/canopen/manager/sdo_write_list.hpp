// A list of short values that are written one after the other into the dictionaries of other nodes,
// and of the own node: for opening and closing connections by an SDO manager (CiA 302-5).
//
//     writes.begin(SdoWriteList::Done::to<&Opening::ended>(*this));
//     writes.add({.node = 10, .index = 0x1201, .sub = 1, .value = 0x640});
//     writes.run();
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// The list stops at the first write that fails. A request without an answer is repeated.
class SdoWriteList {
 public:
  static constexpr std::size_t writes_max = 8;  ///< of one list

  /// One write.
  struct Write {
    NodeId node = 0;          ///< node-ID; the own one needs no frame
    std::uint16_t index = 0;  ///< of the object
    std::uint8_t sub = 0;     ///< sub-index
    std::uint32_t value = 0;  ///< little-endian in `size` bytes
    std::uint8_t size = 4;    ///< bytes of the value, 1 to 4
    bool may_fail = false;    ///< the list continues after a failure
  };
  /// End of a list.
  struct Outcome {
    SdoEnd end = {};
    NodeId node = 0;  ///< node of the failed write
  };
  /// Called once, at the end of run().
  using Done = Callback<void(const Outcome&)>;

  /// Makes a list. Each request is tried up to `tries` times, each with `time_out`. `client` must
  /// outlive the list.
  SdoWriteList(Node& node, SdoClient& client, Duration time_out, unsigned tries)
      : node_(node), client_(client), time_out_(time_out), tries_max_(tries) {}
  SdoWriteList(const SdoWriteList&) = delete;
  SdoWriteList& operator=(const SdoWriteList&) = delete;

  /// Empties the list.
  void begin(Done done) {
    done_ = done;
    size_ = position_ = 0;
  }
  /// Appends a write; beyond writes_max it is dropped.
  void add(const Write& write) {
    if (size_ < writes_max) writes_[size_++] = write;
  }
  /// Carries out the list. Calls `done` once, possibly before it returns.
  void run();

 private:
  bool write_next();
  AbortCode write_here(const Write& write, std::span<const std::uint8_t> value);
  bool step(SdoEnd answer);
  void written(SdoClient::Outcome outcome);

  Node& node_;
  SdoClient& client_;
  Duration time_out_;
  unsigned tries_max_;
  unsigned tries_left_ = 0;
  Done done_;
  std::array<Write, writes_max> writes_{};
  std::array<std::uint8_t, 4> buffer_{};
  std::size_t size_ = 0;
  std::size_t position_ = 0;
};

}  // namespace canvoy
