// A command under way: its request, the data received so far, and finally its answer.
//
//     Operation operation(request, budget);
//     network.begin(operation, now);
//     if (operation.answer) ...           // now, or after some frames
#pragma once

#include <optional>

#include "canvoy/gateway/answer.hpp"
#include "canvoy/gateway/request.hpp"

namespace canvoy::gateway {

/// Limit on the bytes that the commands of one client may hold together.
class Budget {
 public:
  /// Makes a budget of so many bytes.
  explicit Budget(std::size_t bytes) : left_(bytes) {}

  /// Takes bytes; false, and nothing is taken, if there are not as many left.
  bool take(std::size_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  /// Gives bytes back that were taken.
  void give(std::size_t bytes) { left_ += bytes; }

 private:
  std::size_t left_;
};

/// A command under way. It must not move until it is answered or cancelled.
class Operation {
 public:
  /// Makes an operation without an answer. `budget` must outlive it.
  Operation(Request asked, Budget& budget) : request(std::move(asked)), budget_(budget) {}
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;
  ~Operation() { budget_.give(received_.size()); }

  /// Appends the next bytes of an upload; out_of_memory if the client holds too much already.
  AbortCode receive(std::span<const std::uint8_t> bytes) {
    is_too_much_ = !budget_.take(bytes.size());
    if (is_too_much_) return AbortCode::out_of_memory;
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    return AbortCode::none;
  }
  /// Bytes of an upload so far.
  const Bytes& received() const { return received_; }
  /// True if an upload ended since the client holds too much.
  bool is_too_much() const { return is_too_much_; }

  const Request request;         ///< as parsed
  std::optional<Answer> answer;  ///< nothing while it is under way

 private:
  Budget& budget_;
  Bytes received_;
  bool is_too_much_ = false;
};

}  // namespace canvoy::gateway
