#include "canvoy/web/document_server.hpp"

#include <csignal>
#include <mutex>
#include <utility>

namespace canvoy::web {

class DocumentServer::Document : public WebApplication {
 public:
  Document(std::string type, std::string content)
      : type_(std::move(type)), content_(std::move(content)) {}

  std::string methods(std::string_view) const override { return "GET, HEAD"; }
  void answer(const WebRequest&, Answer done) override {
    WebResponse response{.type = type_};
    {
      const std::scoped_lock lock(mutex_);
      response.body = content_;
    }
    done(std::move(response));
  }
  std::unique_ptr<LiveClient> connect(const RequestTarget&) override { return nullptr; }

  void publish(std::string content) {
    const std::scoped_lock lock(mutex_);
    content_ = std::move(content);
  }

 private:
  std::string type_;
  std::mutex mutex_;
  std::string content_;
};

DocumentServer::DocumentServer(std::unique_ptr<host::EventLoop> loop,
                               std::unique_ptr<Document> document,
                               std::unique_ptr<WebServer> server)
    : loop_(std::move(loop)), document_(std::move(document)), server_(std::move(server)) {
  // Signals are handled by the creating thread.
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { loop_->run(); });
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

DocumentServer::~DocumentServer() {
  loop_->stop();
  thread_.join();
}

host::Result<std::unique_ptr<DocumentServer>> DocumentServer::create(std::string address,
                                                                     std::string content_type,
                                                                     std::string content) {
  host::Result<std::unique_ptr<host::EventLoop>> loop = host::EventLoop::create();
  if (!loop) return loop.error();
  auto document = std::make_unique<Document>(std::move(content_type), std::move(content));
  auto server =
      WebServer::create(**loop, {.address = std::move(address), .is_public = true}, *document);
  if (!server) return server.error();
  return std::unique_ptr<DocumentServer>(
      new DocumentServer(*std::move(loop), std::move(document), *std::move(server)));
}

void DocumentServer::publish(std::string content) {
  document_->publish(std::move(content));
}

}  // namespace canvoy::web
