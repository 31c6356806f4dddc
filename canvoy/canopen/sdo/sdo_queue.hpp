// Reads and writes other nodes without waiting: requests queue for each server, and many servers
// are asked at a time (CiA 301, 7.2.4).
//
//     SdoBlockWorkers<8> workers(node);          // up to 8 servers at a time, in blocks where it
//     pays SdoQueue queue(node, workers.all()); SdoRequest name{.server = 5, .index = 0x1008,
//     .destination = text, .done = on_name}; queue.upload(name);
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

/// One request, in its owner's memory, where it must stay until it is done. Then it may be used
/// again.
struct SdoRequest {
  using Done = Callback<void(SdoRequest&)>;

  NodeId server = 0;
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  /// Of an upload: where the value goes to; or, where there is a sink, that.
  std::span<std::uint8_t> destination = {};
  SdoClient::Sink sink = {};
  /// Of a download: the value; or, where there is a supply, what that gives, of this size if it is
  /// known.
  std::span<const std::uint8_t> value = {};
  SdoClient::Supply supply = {};
  std::optional<std::uint32_t> size = {};

  SdoTransfer transfer = SdoTransfer::automatic;
  Duration time_out = SdoClient::default_time_out;  ///< for each single answer
  /// May queue this request again, or others.
  Done done = {};

  enum class State : std::uint8_t { idle, waiting, active };
  State state() const { return place.state; }
  /// How the last transfer ended; cancelled while there is none, or where it was taken back.
  const SdoClient::Outcome& outcome() const { return place.outcome; }
  /// Progress: bytes until now, and in all where that is known.
  std::size_t transferred() const;
  std::optional<std::uint32_t> announced() const;

  /// What the queue notes.
  struct Place {
    bool is_download = false;
    State state = State::idle;
    SdoOutcome outcome = SdoEnd::cancelled(AbortCode::no_data);
    const SdoClient* client = nullptr;  ///< that works on it
    SdoRequest* next = nullptr;         ///< the first request to the next server
    SdoRequest* behind = nullptr;       ///< the next request to this server
  };
  Place place = {};
};

/// Requests to one server are made one after the other, in the order in which they came; those to
/// several at a time, as many as there are workers, in turns, and not faster than the controller
/// takes frames. To queue one costs a step for each server with requests, and for each request to
/// its own server.
class SdoQueue {
 public:
  /// A client that works for the queue.
  class Worker {
   public:
    /// As SdoClient.
    explicit Worker(Node& node, std::optional<std::uint8_t> number = std::nullopt)
        : client_(node, number) {}
    SdoClient& client() { return client_; }

   private:
    friend class SdoQueue;
    bool is_free() const { return request_ == nullptr && !client_.busy(); }
    void finished(SdoClient::Outcome outcome) { queue_->finished(*this, outcome); }

    SdoClient client_;
    SdoQueue* queue_ = nullptr;
    SdoRequest* request_ = nullptr;
  };

  /// `workers` are of the same node, must outlive the queue, and work for it alone. The node's
  /// backlog needs a frame for each of them: their servers may all answer before one is asked
  /// again.
  SdoQueue(Node& node, std::span<Worker> workers);
  SdoQueue(const SdoQueue&) = delete;
  SdoQueue& operator=(const SdoQueue&) = delete;

  /// Each request that is taken ends with one call of `done`, perhaps from within. Time is that of
  /// the node: from outside of its callbacks, call node.advance(now) before. False where the
  /// request is queued already, or `server` is no node-ID; and from within `done` of a request that
  /// could not even begin (device_state, no_sdo_connection, out_of_memory, unsupported_access):
  /// else one that always queues again would be refused without end.
  bool upload(SdoRequest& request) { return add(request, false); }
  bool download(SdoRequest& request) { return add(request, true); }

  /// Takes a request back: its server is told, if it has begun, and `done` is not called.
  void cancel(SdoRequest& request);

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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  SdoRequest* first_ = nullptr;
  bool is_starting_ = false;
  bool is_refusing_ = false;  ///< tells a request that it could not begin
};

/// So many workers on the default SDO channels of all servers.
template <std::size_t count>
class SdoWorkers {
 public:
  explicit SdoWorkers(Node& node) : SdoWorkers(node, std::make_index_sequence<count>{}) {}
  std::span<SdoQueue::Worker> all() { return workers_; }

 private:
  template <std::size_t... numbers>
  SdoWorkers(Node& node, std::index_sequence<numbers...>)
      : workers_{((void)numbers, SdoQueue::Worker(node))...} {}

  std::array<SdoQueue::Worker, count> workers_;
};

/// The same, with block transfers, and the memory that they need.
template <std::size_t count>
class SdoBlockWorkers {
 public:
  explicit SdoBlockWorkers(Node& node) : SdoBlockWorkers(node, std::make_index_sequence<count>{}) {}
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
