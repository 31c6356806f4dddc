// Errors that end a subcommand early: one line for the user, and the exit status.
#pragma once

#include <stdexcept>
#include <string>

#include "canvoy/can/host/result.hpp"

namespace canvoy::tools {

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_usage = 2;
inline constexpr int exit_undecided = 3;  ///< not all was decided, else passed: `--require-decided`

/// An error in one line: where, what, and what to do.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& line, int status = exit_failed)
      : std::runtime_error(line), status_(status) {}

  int status() const { return status_; }

 private:
  int status_;
};

/// The user requested something that does not exist or is not valid.
class UsageError : public Failure {
 public:
  explicit UsageError(const std::string& line) : Failure(line, exit_usage) {}
};

/// The value of a result; throws its error as a Failure.
template <class Value>
Value value_or_throw(host::Result<Value> result) {
  if (!result) throw Failure(result.error().line());
  return *std::move(result);
}
inline void ok_or_throw(const host::Result<void>& result) {
  if (!result) throw Failure(result.error().line());
}

}  // namespace canvoy::tools
