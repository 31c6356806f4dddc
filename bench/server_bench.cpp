// Cost of SDO for a server alone: frames enter by Node::receive, and sent frames are dropped. Also
// the cost of a look-up among hundreds of objects.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "canvoy/canopen/device/heap_tables.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/crc16.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"

namespace canvoy {
namespace server_bench {

constexpr std::uint16_t request_id = 0x605;
constexpr std::size_t content_size = 100'000;

/// 2000h: a value with limits; 2001h: a domain that is streamed; 2002h: one that stands in memory.
constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                                          {.index = 0x1001, .entry_count = 1},
                                                          {.index = 0x1017, .entry_count = 1},
                                                          {.index = 0x1018, .entry_count = 2},
                                                          {.index = 0x2000, .entry_count = 1},
                                                          {.index = 0x2001, .entry_count = 1},
                                                          {.index = 0x2002, .entry_count = 1}}),
                                std::to_array<EntryRow>({
                                    {.type = DataType::unsigned32, .initial = 0x0001'01A2},
                                    {.type = DataType::unsigned8},
                                    {.type = DataType::unsigned16, .access = Access::rw},
                                    {.type = DataType::unsigned8, .initial = 4},
                                    {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32},
                                    {.type = DataType::unsigned32,
                                     .access = Access::rw,
                                     .traits = EntryTraits::limited,
                                     .high = 1'000'000},
                                    {.type = DataType::domain, .access = Access::rw},
                                    {.type = DataType::domain, .access = Access::rw},
                                }));
constexpr DictionaryTables tables = layout.tables();

/// What is counted: a function of its own, so that bench/run finds it.
[[gnu::noinline]] void serve(Node& node, const Frame& frame) {
  node.receive(frame, Time{});
}

/// A server, whose answers are kept until the next one.
class Server {
 public:
  Server() {
    dictionary().attach(hook_);
    domain_.open_read = Callback<Result<std::uint32_t>(const Entry&)>::to<&Server::size>(*this);
    domain_.read = Callback<Result<std::size_t>(const Entry&, std::uint32_t,
                                                std::span<std::uint8_t>)>::to<&Server::read>(*this);
    domain_.open_write =
        Callback<AbortCode(const Entry&, std::uint32_t)>::to<&Server::begin>(*this);
    domain_.write =
        Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&Server::write>(*this);
    domain_.close_write = Callback<AbortCode(const Entry&, bool)>::to<&Server::end>(*this);
    dictionary().attach(streamed_hook_);
    whole_.view =
        Callback<Result<std::span<const std::uint8_t>>(const Entry&)>::to<&Server::view>(*this);
    whole_.room =
        Callback<Result<std::span<std::uint8_t>>(const Entry&, std::uint32_t)>::to<&Server::room>(
            *this);
    whole_.write =
        Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&Server::keep>(*this);
    whole_.close_write = domain_.close_write;
    dictionary().attach(whole_hook_);
    std::iota(content.begin(), content.end(), std::uint8_t{0});
    node_.start(Time{});
  }

  Dictionary& dictionary() { return node_.dictionary(); }
  void ask(std::uint8_t first, std::uint32_t multiplexer, std::uint32_t value) {
    std::array<std::uint8_t, 8> bytes{first};
    store(&bytes[1], multiplexer);
    store(&bytes[4], value);
    ask(bytes);
  }
  void ask(const std::array<std::uint8_t, 8>& bytes) {
    Frame frame{.id = request_id, .length = 8};
    frame.data = bytes;
    serve(node_, frame);
  }

  Frame answer;
  std::uint64_t answers = 0;
  std::vector<std::uint8_t> content = std::vector<std::uint8_t>(content_size);
  std::size_t taken = 0;

 private:
  static bool send(void* context, const Frame& frame) {
    auto& self = *static_cast<Server*>(context);
    self.answer = frame;
    ++self.answers;
    return true;
  }

  Result<std::uint32_t> size(const Entry&) { return static_cast<std::uint32_t>(content.size()); }
  Result<std::size_t> read(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    std::memcpy(bytes.data(), content.data() + offset, bytes.size());
    return bytes.size();
  }
  AbortCode begin(const Entry&, std::uint32_t) {
    taken = 0;
    return AbortCode::none;
  }
  AbortCode write(const Entry&, std::span<const std::uint8_t> bytes) {
    std::memcpy(content.data() + taken, bytes.data(), bytes.size());
    taken += bytes.size();
    return AbortCode::none;
  }
  AbortCode end(const Entry&, bool complete) {
    return complete ? AbortCode::none : AbortCode::general;
  }
  Result<std::span<const std::uint8_t>> view(const Entry&) {
    return std::span<const std::uint8_t>(content);
  }
  Result<std::span<std::uint8_t>> room(const Entry&, std::uint32_t) {
    return std::span<std::uint8_t>(content);
  }
  AbortCode keep(const Entry&, std::span<const std::uint8_t> bytes) {
    taken = bytes.size();
    return AbortCode::none;
  }
  AbortCode ask_hook(const Entry&, std::span<const std::uint8_t>) { return AbortCode::none; }

  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::vector<ObjectState> states_ = std::vector<ObjectState>(tables.objects.size());
  std::array<Router::Route, 4> routes_;
  std::array<Frame, 8> backlog_;
  std::array<std::uint8_t, 889> buffer_{};
  Node node_{tables, {values_, states_, routes_, backlog_}, {this, send, nullptr}, 5};
  SdoServer server_{node_, 0, buffer_};
  SdoBlockServer blocks_{server_};
  Hook hook_{
      .first = 0x2000,
      .last = 0x2000,
      .before_write =
          Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&Server::ask_hook>(
              *this)};
  Domain domain_;
  Hook streamed_hook_{.first = 0x2001, .last = 0x2001, .domain = &domain_};
  Domain whole_;
  Hook whole_hook_{.first = 0x2002, .last = 0x2002, .domain = &whole_};
};

void check(benchmark::State& state, bool done) {
  if (!done) state.SkipWithError("the transfer failed");
}

void server_download_limited(benchmark::State& state) {
  Server server;
  std::uint32_t number = 0;
  for (auto _ : state) server.ask(0x23, 0x002000, ++number % 1'000'000);
  check(state, server.answer.data[0] == 0x60);
}
BENCHMARK(server_download_limited);

void server_upload_value(benchmark::State& state) {
  Server server;
  for (auto _ : state) server.ask(0x40, 0x002000, 0);
  check(state, server.answer.data[0] == 0x43);
}
BENCHMARK(server_upload_value);

// Of 100,000 bytes; one call is one transfer.

constexpr std::uint32_t streamed = 0x002001;
constexpr std::uint32_t whole = 0x002002;

[[gnu::noinline]] void transfer_segmented_upload(Server& server, std::uint32_t object) {
  server.ask(0x40, object, 0);
  for (std::uint8_t toggle = 0; server.answer.data[0] != 0x80; toggle ^= 0x10) {
    server.ask(static_cast<std::uint8_t>(0x60 | toggle), 0, 0);
    if ((server.answer.data[0] & 1) != 0) break;
  }
}

[[gnu::noinline]] void transfer_segmented_download(Server& server, std::uint32_t object) {
  server.ask(0x21, object, content_size);
  std::uint8_t toggle = 0;
  for (std::size_t at = 0; at < content_size; at += 7, toggle ^= 0x10) {
    const std::size_t unused = at + 7 < content_size ? 0 : at + 7 - content_size;
    const bool last = at + 7 >= content_size;
    server.ask(
        {static_cast<std::uint8_t>(toggle | unused << 1 | (last ? 1U : 0U)), 1, 2, 3, 4, 5, 6, 7});
  }
}

[[gnu::noinline]] void transfer_block_upload(Server& server, std::uint32_t object, bool crc) {
  server.ask(crc ? 0xA4 : 0xA0, object, 127);
  std::uint64_t before = server.answers;
  server.ask(0xA3, 0, 0);
  for (;;) {
    const auto sent = static_cast<std::uint8_t>(server.answers - before);
    const bool last = (server.answer.data[0] & 0x80) != 0;
    before = server.answers;
    server.ask({0xA2, sent, 127});
    if (last || server.answers == before) break;
  }
  server.ask(0xA1, 0, 0);
}

[[gnu::noinline]] void transfer_block_download(Server& server, std::uint32_t object, bool crc,
                                               std::uint16_t sum) {
  server.ask(crc ? 0xC6 : 0xC2, object, content_size);
  unsigned number = 0;
  for (std::size_t at = 0; at < content_size; at += 7) {
    const bool last = at + 7 >= content_size;
    number = number % 127 + 1;
    server.ask({static_cast<std::uint8_t>(number | (last ? 0x80U : 0U)), 1, 2, 3, 4, 5, 6, 7});
  }
  const std::size_t unused = 7 - content_size % 7;
  server.ask({static_cast<std::uint8_t>(0xC1 | unused << 2), static_cast<std::uint8_t>(sum),
              static_cast<std::uint8_t>(sum >> 8)});
}

std::uint16_t sum_of_download() {
  std::vector<std::uint8_t> sent(content_size);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::uint8_t>(i % 7 + 1);
  return crc16(sent);
}

void server_segmented_upload(benchmark::State& state, std::uint32_t object) {
  Server server;
  for (auto _ : state) transfer_segmented_upload(server, object);
  check(state, (server.answer.data[0] & 0xE1) == 0x01);
}
BENCHMARK_CAPTURE(server_segmented_upload, streamed, streamed);
BENCHMARK_CAPTURE(server_segmented_upload, whole, whole);

void server_segmented_download(benchmark::State& state, std::uint32_t object) {
  Server server;
  for (auto _ : state) transfer_segmented_download(server, object);
  check(state, (server.answer.data[0] & 0xEF) == 0x20);
}
BENCHMARK_CAPTURE(server_segmented_download, streamed, streamed);
BENCHMARK_CAPTURE(server_segmented_download, whole, whole);

void server_block_upload(benchmark::State& state, std::uint32_t object, bool crc) {
  Server server;
  for (auto _ : state) transfer_block_upload(server, object, crc);
  check(state, (server.answer.data[0] & 0xE3) == 0xC1);
}
BENCHMARK_CAPTURE(server_block_upload, streamed, streamed, false);
BENCHMARK_CAPTURE(server_block_upload, streamed_crc, streamed, true);
BENCHMARK_CAPTURE(server_block_upload, whole, whole, false);
BENCHMARK_CAPTURE(server_block_upload, whole_crc, whole, true);

void server_block_download(benchmark::State& state, std::uint32_t object, bool crc) {
  Server server;
  const std::uint16_t sum = crc ? sum_of_download() : std::uint16_t{0};
  for (auto _ : state) transfer_block_download(server, object, crc, sum);
  check(state, server.answer.data[0] == 0xA1);
}
BENCHMARK_CAPTURE(server_block_download, streamed, streamed, false);
BENCHMARK_CAPTURE(server_block_download, streamed_crc, streamed, true);
BENCHMARK_CAPTURE(server_block_download, whole, whole, false);
BENCHMARK_CAPTURE(server_block_download, whole_crc, whole, true);

[[gnu::noinline]] bool look_up(const Dictionary& dictionary, std::uint16_t index) {
  return static_cast<bool>(dictionary.find(index, 0));
}

/// Objects with an index each, every third one, in an order in which none is found twice soon.
void look_up_among(benchmark::State& state) {
  const auto count = static_cast<unsigned>(state.range(0));
  HeapTables many;
  for (unsigned i = 0; i < count; ++i) {
    add_object(many, {.index = static_cast<std::uint16_t>(0x1000 + 3 * i)},
               std::to_array<EntryRow>({{.type = DataType::unsigned32}}));
  }
  std::vector<std::uint8_t> values(many.value_bytes);
  std::vector<ObjectState> states(many.objects.size());
  const Dictionary dictionary(many.tables(), values, states);
  unsigned position = 0;
  bool found = true;
  for (auto _ : state) {
    position = (position + 1237) % count;
    found &= look_up(dictionary, static_cast<std::uint16_t>(0x1000 + 3 * position));
  }
  check(state, found);
}
BENCHMARK(look_up_among)->Arg(50)->Arg(500)->Arg(5000);

}  // namespace server_bench
}  // namespace canvoy
