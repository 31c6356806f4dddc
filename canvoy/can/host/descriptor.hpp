// A file descriptor that closes itself.
//
//     Descriptor socket{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
//     if (!socket) return error(errno);
#pragma once

#include <unistd.h>

#include <utility>

namespace canvoy::host {

class Descriptor {
 public:
  Descriptor() = default;
  /// Takes the result of a system call; a negative value is no descriptor.
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  explicit operator bool() const { return number_ >= 0; }
  /// The number; negative if there is none.
  int get() const { return number_; }

 private:
  int number_ = -1;
};

}  // namespace canvoy::host
