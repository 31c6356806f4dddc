#include "canvoy/can/host/receive_batch.hpp"

#include <cerrno>
#include <cstring>

namespace canvoy::host {

void ReceiveBatch::request_details(int socket) {
  const int on = 1;
  setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
  setsockopt(socket, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on);
  const int size = 1 << 20;
  if (setsockopt(socket, SOL_SOCKET, SO_RCVBUFFORCE, &size, sizeof size) != 0) {
    setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &size, sizeof size);
  }
}

int ReceiveBatch::receive(int socket) {
  newly_dropped_ = 0;
  for (std::size_t i = 0; i < packets_max; ++i) {
    vectors_[i] = {bytes_[i].data(), packet_max};
    msghdr& header = headers_[i].msg_hdr;
    header = {};
    header.msg_name = &senders_[i];
    header.msg_namelen = sizeof senders_[i];
    header.msg_iov = &vectors_[i];
    header.msg_iovlen = 1;
    header.msg_control = &controls_[i];
    header.msg_controllen = sizeof controls_[i];
  }
  const int count = recvmmsg(socket, headers_.data(), packets_max, MSG_DONTWAIT, nullptr);
  if (count < 0) return errno == EAGAIN || errno == EINTR ? 0 : -errno;
  for (int i = 0; i < count; ++i) read_control(static_cast<std::size_t>(i));
  return count;
}

void ReceiveBatch::read_control(std::size_t position) {
  stamps_[position] = {};
  msghdr* header = &headers_[position].msg_hdr;
  for (cmsghdr* message = CMSG_FIRSTHDR(header); message != nullptr;
       message = CMSG_NXTHDR(header, message)) {
    if (message->cmsg_level != SOL_SOCKET) continue;
    if (message->cmsg_type == SO_TIMESTAMPNS) {
      std::memcpy(&stamps_[position], CMSG_DATA(message), sizeof(timespec));
    } else if (message->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t dropped = 0;
      std::memcpy(&dropped, CMSG_DATA(message), sizeof dropped);
      newly_dropped_ += dropped - dropped_;
      dropped_ = dropped;
    }
  }
}

ReceivedPacket ReceiveBatch::packet(std::size_t position) const {
  const mmsghdr& header = headers_[position];
  ReceivedPacket packet;
  packet.bytes = {bytes_[position].data(), header.msg_len};
  packet.sender = &senders_[position];
  packet.stamp = stamps_[position];
  packet.confirms = (header.msg_hdr.msg_flags & MSG_CONFIRM) != 0;
  packet.cut_off = (header.msg_hdr.msg_flags & MSG_TRUNC) != 0;
  return packet;
}

}  // namespace canvoy::host
