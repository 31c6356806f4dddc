// What a client asks for by HTTP/1.x (RFC 9112), as far as a server of one document needs it: the
// head of the request, and which status answers it.
//
//     HttpRequest request;
//     if (request.append(bytes)) answer(request.status(), request.is_head());
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace canvoy::tools {

enum class HttpStatus {
  ok = 200,
  bad_request = 400,
  method_not_allowed = 405,
  request_time_out = 408,
  too_large = 431,  ///< the head of the request
  version_not_supported = 505,
};

/// `Bad Request`
std::string_view reason_of(HttpStatus status);

class HttpRequest {
 public:
  /// Of the request line and all headers together.
  static constexpr std::size_t bytes_max = 8192;

  /// What has come, cut anywhere. True as soon as it is known what to answer; what comes then is
  /// not looked at, be it a body or another request.
  bool append(std::string_view bytes);
  bool is_known() const { return is_known_; }
  /// GET and HEAD of any path are ok.
  HttpStatus status() const { return status_; }
  /// The answer has no content.
  bool is_head() const { return is_head_; }
  /// Something has come.
  bool has_begun() const { return !head_.empty(); }

 private:
  bool know(HttpStatus status);
  HttpStatus judge();

  std::string head_;
  HttpStatus status_ = HttpStatus::bad_request;
  bool is_known_ = false;
  bool is_head_ = false;
};

}  // namespace canvoy::tools
