// One client of the server: its HTTP requests in sequence, or its WebSocket. Only its source
// includes Boost.Beast, which takes as long to compile as twenty others.
//
//     std::shared_ptr<Connection> connection = make_connection(server, std::move(socket));
//     if (connection->begin()) connections.push_back(connection);
//
// Asio performs what is possible at once when the owner has a turn; nothing waits.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <memory>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/web/access.hpp"
#include "canvoy/web/web_server.hpp"

namespace canvoy::web {

/// The server as its clients see it.
class ConnectionOwner {
 public:
  /// `loop` and `application` must outlive this.
  ConnectionOwner(host::EventLoop& loop_of, WebApplication& served, const WebOptions& options,
                  AccessRules access)
      : loop(loop_of),
        application(served),
        limits(options.limits),
        is_public(options.is_public),
        rules(std::move(access)) {}
  virtual ~ConnectionOwner() = default;
  ConnectionOwner(const ConnectionOwner&) = delete;
  ConnectionOwner& operator=(const ConnectionOwner&) = delete;

  /// True if there is room for so many unread bytes: those that have left unread for longest what
  /// was sent to them are disconnected for it.
  virtual bool make_unread_room(std::size_t bytes) = 0;
  /// Performs the work of Asio in this turn of the loop or in the next one.
  virtual void turn_soon() = 0;
  /// Makes room for one more client with a WebSocket.
  virtual void make_live_room() = 0;

  host::EventLoop& loop;
  WebApplication& application;
  const WebLimits limits;
  const bool is_public;  ///< for any client, without the page
  const AccessRules rules;
};

class Connection {
 public:
  Connection() = default;
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Begins to read; false if the socket cannot be watched.
  virtual bool begin() = 0;
  virtual void end() = 0;
  virtual bool is_over() const = 0;
  virtual bool is_live() const = 0;  ///< has a WebSocket
  /// Bytes of its answer or message that it has not received yet.
  virtual std::size_t unread() const = 0;
  virtual Time sending_since() const = 0;  ///< time at which its answer or message was begun
  virtual Time heard_at() const = 0;       ///< time of the last message of the client
  /// Ends the WebSocket with a status that tells the page not to reconnect by itself.
  virtual void give_way() = 0;
  virtual bool is_late() const = 0;  ///< its time-out has passed
  /// A client that waits for an answer gets a refusal and is disconnected, so that a late answer is
  /// not taken for that of another request; other clients are disconnected at once.
  virtual void time_out() = 0;
  /// Watches the socket for what is waited for now.
  virtual void rewatch() = 0;
  /// Sends the next message, if the client can take one.
  virtual void offer() = 0;
};

/// `owner` must outlive the connection.
std::shared_ptr<Connection> make_connection(ConnectionOwner& owner,
                                            boost::asio::ip::tcp::socket socket);

}  // namespace canvoy::web
