// Reads and writes other nodes without waiting: requests queue for each server, and many servers
// are accessed at a time (CiA 301, 7.2.4).
//
//     SdoBlockWorkers<8> workers(node);  // up to 8 servers at a time, in blocks where it pays
//     SdoQueue queue(node, workers.all());
//     SdoRequest name{.server = 5, .index = 0x1008, .destination = text, .done = on_name};
//     queue.upload(name);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

class SdoQueue;

/// One request, in its owner's memory, where it must stay until it is done. It may be used again
/// afterwards.
struct SdoRequest {
  /// Called once for each request that was accepted, at its end.
  using Done = Callback<void(SdoRequest&)>;

  NodeId server = 0;        ///< node-ID, 1 to 127
  std::uint16_t index = 0;  ///< object in the server
  std::uint8_t sub = 0;     ///< sub-index

  /// Upload: destination of the value; a sink, if there is one, takes it instead.
  std::span<std::uint8_t> destination = {};
  SdoClient::Sink sink = {};  ///< takes the bytes as they come
  /// Download: the value; or data from a supply, if there is one, with this size if it is known.
  std::span<const std::uint8_t> value = {};
  SdoClient::Supply supply = {};           ///< gives the bytes as they are needed
  std::optional<std::uint32_t> size = {};  ///< in bytes; announced to the server

  SdoTransfer transfer = SdoTransfer::automatic;    ///< expedited, segments or blocks
  Duration time_out = SdoClient::default_time_out;  ///< for each single answer
  /// Called at the end; may queue this request again, or others.
  Done done = {};

  /// State in the queue: not queued, queued, or under way.
  enum class State : std::uint8_t { idle, waiting, active };
  /// State in the queue. A request may be changed or destroyed while it is idle only.
  State state() const { return place.state; }
  /// Outcome of the last transfer; cancelled before the first, or after cancel().
  const SdoClient::Outcome& outcome() const { return place.outcome; }
  /// Bytes transferred so far, and in all if known.
  std::size_t transferred() const;
  /// Size in bytes of the present transfer, if either side has announced it.
  std::optional<std::uint32_t> announced() const;

  /// Data of the queue.
  struct Place {
    bool is_download = false;   ///< of the present or last transfer
    State state = State::idle;  ///< see SdoRequest::state()
    SdoOutcome outcome = SdoEnd::cancelled(AbortCode::no_data);  ///< of the last transfer
    const SdoClient* client = nullptr;                           ///< the client that carries it out
    SdoRequest* next = nullptr;    ///< the first request to the next server
    SdoRequest* behind = nullptr;  ///< the next request to this server
  };
  Place place = {};  ///< written by the queue only
};

/// A queue of requests. Requests to one server are made one after the other, in the order in which
/// they came; requests to several servers at a time, as many as there are workers, in turns, and
/// not faster than the controller takes frames. Queueing one costs a step for each server with
/// requests, and for each request to its own server.
class SdoQueue {
 public:
  /// A client that works for the queue.
  class Worker {
   public:
    /// Makes a worker; arguments as for SdoClient.
    explicit Worker(Node& node, std::optional<std::uint8_t> number = std::nullopt)
        : client_(node, number) {}
    /// The client, for its channel and its extension for blocks; requests are made by the queue
    /// only.
    SdoClient& client() { return client_; }

   private:
    friend class SdoQueue;
    bool is_free() const { return request_ == nullptr && !client_.busy(); }
    void finished(SdoClient::Outcome outcome) { queue_->finished(*this, outcome); }

    SdoClient client_;
    SdoQueue* queue_ = nullptr;
    SdoRequest* request_ = nullptr;
  };

  /// Makes a queue. `workers` belong to the same node, must outlive the queue, and work only for
  /// it. The node's backlog needs a frame for each of them: their servers may all answer before one
  /// is asked again.
  SdoQueue(Node& node, std::span<Worker> workers);
  SdoQueue(const SdoQueue&) = delete;
  SdoQueue& operator=(const SdoQueue&) = delete;

  /// Queues a request. Each accepted request ends with one call of `done`, possibly during this
  /// call. Time is that of the node: outside of its callbacks, call node.advance(now) before. False
  /// if the request is queued already, or `server` is not a node-ID; and during `done` of a request
  /// that could not begin (device_state, no_sdo_connection, out_of_memory, unsupported_access):
  /// otherwise a request that is always queued again would be refused without end.
  bool upload(SdoRequest& request) { return add(request, false); }
  /// Queues a download: like upload().
  bool download(SdoRequest& request) { return add(request, true); }

  /// Cancels a request: its server is notified if it has begun, and `done` is not called.
  void cancel(SdoRequest& request);

  /// True if no request waits or is under way.
  bool idle() const { return first_ == nullptr; }

 private:
  bool add(SdoRequest& request, bool is_download);
  void remove(SdoRequest& request);
  void start_waiting();
  bool start_one();
  AbortCode start(Worker& worker, SdoRequest& request);
  void finished(Worker& worker, SdoClient::Outcome outcome);
  void finish(SdoRequest& request, SdoClient::Outcome outcome);
  void append(SdoRequest& request);
  SdoRequest** first_of(NodeId server);

  Node& node_;
  std::span<Worker> workers_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  SdoRequest* first_ = nullptr;
  bool is_starting_ = false;
  bool is_refusing_ = false;  ///< reports to a request that it could not begin
};

/// Workers on the default SDO channels of all servers.
template <std::size_t count>
class SdoWorkers {
 public:
  /// Makes the workers. `node` must outlive them.
  explicit SdoWorkers(Node& node) : SdoWorkers(node, std::make_index_sequence<count>{}) {}
  /// The workers, for SdoQueue.
  std::span<SdoQueue::Worker> all() { return workers_; }

 private:
  template <std::size_t... numbers>
  SdoWorkers(Node& node, std::index_sequence<numbers...>)
      : workers_{((void)numbers, SdoQueue::Worker(node))...} {}

  std::array<SdoQueue::Worker, count> workers_;
};

/// Like SdoWorkers, but with block transfers, and the memory that they need.
template <std::size_t count>
class SdoBlockWorkers {
 public:
  /// Makes the workers, each with an extension for blocks. `node` must outlive them.
  explicit SdoBlockWorkers(Node& node) : SdoBlockWorkers(node, std::make_index_sequence<count>{}) {}
  /// The workers, for SdoQueue.
  std::span<SdoQueue::Worker> all() { return workers_.all(); }

 private:
  template <std::size_t... numbers>
  SdoBlockWorkers(Node& node, std::index_sequence<numbers...>)
      : workers_(node), blocks_{SdoBlockClient(all()[numbers].client(), buffers_[numbers])...} {}

  SdoWorkers<count> workers_;
  std::array<std::array<std::uint8_t, SdoBlockClient::buffer_size>, count> buffers_{};
  std::array<SdoBlockClient, count> blocks_;
};

}  // namespace canvoy
