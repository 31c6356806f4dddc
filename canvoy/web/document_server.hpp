// Serves one public document by HTTP, in a thread of its own: the last content that its owner
// published.
//
//     auto server = DocumentServer::create("[::]:8080", "application/x-protobuf", bytes);
//     if (!server) return fail(server.error().line());
//     (*server)->publish(newer_bytes);
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/web/web_server.hpp"

namespace canvoy::web {

/// Answers GET and HEAD of any path with the document; other methods and invalid requests as
/// WebServer does.
class DocumentServer {
 public:
  /// `address` as for TcpListener; the media type of the content also applies to published
  /// contents.
  static host::Result<std::unique_ptr<DocumentServer>> create(std::string address,
                                                              std::string content_type,
                                                              std::string content);
  ~DocumentServer();
  DocumentServer(const DocumentServer&) = delete;
  DocumentServer& operator=(const DocumentServer&) = delete;

  /// `http://127.0.0.1:8080/`, with the actual port.
  std::string url() const { return server_->url(); }
  /// Replaces the content, from any thread. An answer in progress has the whole old content.
  void publish(std::string content);

 private:
  class Document;

  DocumentServer(std::unique_ptr<host::EventLoop> loop, std::unique_ptr<Document> document,
                 std::unique_ptr<WebServer> server);

  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<WebServer> server_;
  std::thread thread_;
};

}  // namespace canvoy::web
