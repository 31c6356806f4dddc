// Takes waiting packets from a socket, many in a system call, with time stamps and the drop count
// of the kernel.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <span>

namespace canvoy::host {

/// A packet, valid until the next call of ReceiveBatch::receive().
struct ReceivedPacket {
  std::span<const std::uint8_t> bytes;  ///< of the datagram or frame
  const sockaddr_in* sender = nullptr;  ///< for an IPv4 socket
  timespec stamp{};                     ///< CLOCK_REALTIME; zero if the kernel gave none
  bool confirms = false;                ///< MSG_CONFIRM: sent by this socket
  bool cut_off = false;                 ///< longer than ReceiveBatch::packet_max
};

/// Buffers for one socket, which must be non-blocking. Stamps and drop counts need
/// request_details().
class ReceiveBatch {
 public:
  static constexpr std::size_t packets_max = 32;  ///< in one system call
  static constexpr std::size_t packet_max = 512;  ///< bytes; a longer packet is cut off
  /// Limit of calls of receive() in a turn of the event loop, so that a flood does not block
  /// everything else.
  static constexpr int batches_max = 32;

  /// Enables time stamps and the drop count, and requests a receive buffer of 1 MB: a burst waits
  /// in the kernel while the program is busy. Features that the kernel lacks are omitted.
  static void request_details(int socket);

  /// Receives waiting packets, at most packets_max: 0 if there are none, or a negative errno.
  int receive(int socket);
  /// Prepares for another socket, which counts its drops from 0.
  void begin_anew() { dropped_ = 0; }
  /// A packet of the last receive(); `position` is below its result.
  ReceivedPacket packet(std::size_t position) const;
  /// Number of packets that the kernel dropped, by the last receive().
  std::uint32_t newly_dropped() const { return newly_dropped_; }

 private:
  struct alignas(cmsghdr) Control {
    std::array<std::byte, CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))> bytes;
  };

  void read_control(std::size_t position);

  std::array<mmsghdr, packets_max> headers_{};
  std::array<iovec, packets_max> vectors_{};
  std::array<Control, packets_max> controls_{};
  std::array<sockaddr_in, packets_max> senders_{};
  std::array<timespec, packets_max> stamps_{};
  std::array<std::array<std::uint8_t, packet_max>, packets_max> bytes_{};
  std::uint32_t dropped_ = 0;
  std::uint32_t newly_dropped_ = 0;
};

}  // namespace canvoy::host
