// Takes what waits in a socket, many packets a system call, with the kernel's time stamps and its
// count of drops.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <span>

namespace canvoy::host {

/// Valid until the next call of ReceiveBatch::receive().
struct ReceivedPacket {
  std::span<const std::uint8_t> bytes;
  const sockaddr_in* sender = nullptr;  ///< of an IPv4 socket
  timespec stamp{};                     ///< CLOCK_REALTIME; zero where the kernel gave none
  bool confirms = false;                ///< MSG_CONFIRM: sent by this very socket
  bool cut_off = false;                 ///< it was longer than ReceiveBatch::packet_max
};

/// Buffers for one socket, which must be non-blocking. For stamps and drops it needs
/// request_details().
class ReceiveBatch {
 public:
  static constexpr std::size_t packets_max = 32;
  static constexpr std::size_t packet_max = 512;
  /// So many calls of receive() a turn of the event loop, so that a flood does not keep all else
  /// waiting.
  static constexpr int batches_max = 32;

  /// Switches time stamps and the count of drops on, and asks for a receive buffer of 1 MB: a burst
  /// waits in the kernel while the program does something else. What the kernel does not have is
  /// gone without.
  static void request_details(int socket);

  /// The packets that wait, at most packets_max: 0 where there are none, or a negative errno.
  int receive(int socket);
  /// From now on it is another socket, which counts its drops from 0.
  void begin_anew() { dropped_ = 0; }
  ReceivedPacket packet(std::size_t position) const;
  /// Packets that the kernel had to drop, as the last receive() learnt.
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
