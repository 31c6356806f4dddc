// Result of operations that can fail at the edge of the program (a file, an argument, a socket):
// the value, or the one line that the user needs: where, what, and what to do.
//
//     Result<CandumpWriter> log = CandumpWriter::create("bus.log");
//     // bus.log: permission denied; choose another folder
//     if (!log) return fail(log.error().line());
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace canvoy::host {

/// An error for the user, in one line.
struct Error {
  std::string where;   ///< the file, address or interface, in the user's notation
  std::string what;    ///< the problem
  std::string remedy;  ///< what to do; may be empty

  /// The line: where, what, and what to do, with a colon and a semicolon between.
  std::string line() const { return where + ": " + what + (remedy.empty() ? "" : "; " + remedy); }
};

/// A value or an Error. Access to the one that is absent is a defect of the caller.
template <class Value>
class [[nodiscard]] Result {
 public:
  /// A value; returned as it is.
  Result(Value value) : content_(std::in_place_index<0>, std::move(value)) {}
  /// An error; returned as it is.
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return content_.index() == 0; }
  Value&& operator*() && { return std::move(*std::get_if<0>(&content_)); }
  Value& operator*() & { return *std::get_if<0>(&content_); }
  const Value& operator*() const& { return *std::get_if<0>(&content_); }
  Value* operator->() { return std::get_if<0>(&content_); }
  const Value* operator->() const { return std::get_if<0>(&content_); }
  /// The error; only if there is no value.
  const Error& error() const { return *std::get_if<1>(&content_); }

 private:
  std::variant<Value, Error> content_;
};

/// Success, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  /// Success.
  Result() = default;
  /// An error; returned as it is.
  Result(Error error) : failed_(true), error_(std::move(error)) {}

  explicit operator bool() const { return !failed_; }
  /// The error; only if there is one.
  const Error& error() const { return error_; }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace canvoy::host
