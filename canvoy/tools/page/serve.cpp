#include "canvoy/tools/page/serve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/live_page.hpp"
#include "canvoy/web/web_server.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration due_period = 50ms;

/// From $CANVOY_WEB_TOKEN, for programs that need it in advance; empty: a random one.
std::string chosen_token() {
  constexpr std::size_t token_min = 16;
  const char* const given = std::getenv("CANVOY_WEB_TOKEN");
  std::string token = given == nullptr ? "" : given;
  const auto is_plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  if (!token.empty() && (token.size() < token_min || !std::ranges::all_of(token, is_plain))) {
    throw UsageError("$CANVOY_WEB_TOKEN has to be at least 16 letters and digits");
  }
  return token;
}

/// Advances the source, and shows it, at each step.
class Server {
 public:
  Server(LiveSource& source, host::EventLoop& loop, const ServeOptions& options)
      : source_(source),
        loop_(loop),
        page_(source),
        server_(value_or_throw(web::WebServer::create(
            loop, {.address = listening_address(options.address), .token = chosen_token()},
            page_))) {
    source_.set_reach({.addresses = server_->urls(), .is_local = server_->is_loopback()});
  }

  void run() {
    fmt::print("{}\n", server_->urls().front());
    std::fflush(stdout);
    page_.look();
    look_later();
    loop_.run();
    if (failure_) throw Failure(*failure_);
  }

 private:
  void look_later() {
    loop_.at(loop_.now() + due_period, [this](Time) { look(); });
  }
  void look() {
    try {
      source_.advance(loop_.now());
    } catch (const Failure& failure) {
      failure_ = failure.what();
      return loop_.stop();
    }
    if (server_->live_clients() != 0 || server_->clients() != 0) page_.look();
    server_->offer();
    look_later();
  }

  LiveSource& source_;
  host::EventLoop& loop_;
  LivePage page_;
  std::unique_ptr<web::WebServer> server_;
  std::optional<std::string> failure_;
};

}  // namespace

void ServeOptions::add_to(Verb& command) {
  command.add({
      {"--allow-write", allow_write,
       "what people at the page may write and command: all, or a list as "
       "nmt,1017,6000-67FF,10:6010 (default: nothing)"},
      {"--allow-record", allow_record,
       "a folder for logs that people at the page begin by a button, as "
       "canvoy-1.log (default: they begin none)"},
  });
}

std::string listening_address(const std::string& text) {
  if (text.empty()) return "127.0.0.1:0";
  if (text.find(':') != std::string::npos) return text;
  const bool is_port =
      text.size() <= 5 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  if (!is_port || std::stoul(text) > 65535) {
    throw UsageError(
        fmt::format("'{}' is no port: give 8080, or an address as 127.0.0.1:8080", text));
  }
  return "127.0.0.1:" + text;
}

int serve(LiveSource& source, host::EventLoop& loop, const ServeOptions& options) {
  ok_or_throw(loop.stop_on_signals());
  Server server(source, loop, options);
  source.begin_log();
  server.run();
  return source.finish();
}

}  // namespace canvoy::tools
