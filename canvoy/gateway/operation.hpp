// A command under way: what is asked, what has come until now, and its answer in the end.
//
//     Operation operation(request, budget);
//     network.begin(operation, now);
//     if (operation.answer) ...           // now, or after some frames
#pragma once

#include <optional>

#include "canvoy/gateway/answer.hpp"
#include "canvoy/gateway/request.hpp"

namespace canvoy::gateway {

/// How many bytes the commands of one client may hold together.
class Budget {
 public:
  explicit Budget(std::size_t bytes) : left_(bytes) {}

  bool take(std::size_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  void give(std::size_t bytes) { left_ += bytes; }

 private:
  std::size_t left_;
};

/// It stays where it is until it is answered or cancelled.
class Operation {
 public:
  Operation(Request asked, Budget& budget) : request(std::move(asked)), budget_(budget) {}
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;
  ~Operation() { budget_.give(received_.size()); }

  /// The next bytes of an upload; out_of_memory where the client holds too much already.
  AbortCode receive(std::span<const std::uint8_t> bytes) {
    is_too_much_ = !budget_.take(bytes.size());
    if (is_too_much_) return AbortCode::out_of_memory;
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    return AbortCode::none;
  }
  const Bytes& received() const { return received_; }
  bool is_too_much() const { return is_too_much_; }

  const Request request;
  std::optional<Answer> answer;

 private:
  Budget& budget_;
  Bytes received_;
  bool is_too_much_ = false;
};

}  // namespace canvoy::gateway
