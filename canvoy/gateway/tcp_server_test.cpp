// The gateway over real sockets on the loopback interface.
#include "canvoy/gateway/tcp_server.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/gateway/tcp_address.hpp"

namespace canvoy::gateway::tcp_server_test {
namespace {

/// A client program: a non-blocking socket.
class Client {
 public:
  explicit Client(const std::string& address) { connect(address); }
  Client() = default;

  void connect(const std::string& address) {
    const auto server = parse_tcp_address(address);
    EXPECT_EQ(::connect(socket_.get(), server->get(), server->length), 0);
    ::fcntl(socket_.get(), F_SETFL, O_NONBLOCK);
  }

  /// Number of its bytes that the socket accepted.
  std::size_t say(std::string_view text) {
    const ssize_t size = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL);
    return size < 0 ? 0 : static_cast<std::size_t>(size);
  }
  /// All data received so far.
  const std::string& heard() {
    char bytes[4096];
    ssize_t size = 0;
    while ((size = ::recv(socket_.get(), bytes, sizeof bytes, 0)) > 0) {
      heard_.append(bytes, static_cast<std::size_t>(size));
    }
    closed_ = closed_ || size == 0 || (errno != EAGAIN && errno != EWOULDBLOCK);
    return heard_;
  }
  bool is_closed() {
    heard();
    return closed_;
  }
  void end_output() { ::shutdown(socket_.get(), SHUT_WR); }
  /// Ends the connection without a closing handshake, like a machine that is switched off and on
  /// again.
  void reset() {
    const linger at_once{.l_onoff = 1, .l_linger = 0};
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    socket_ = host::Descriptor();
  }
  void shrink_receive_buffer() {
    const int bytes = 2048;
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }

 private:
  host::Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  std::string heard_;
  bool closed_ = false;
};

class GatewayTcp : public testing::Test {
 protected:
  explicit GatewayTcp(const SessionSettings& settings = {}, const TcpLimits& limits = {})
      : loop_(*host::EventLoop::create()),
        network_(1, {this, &GatewayTcp::take, nullptr}),
        gateway_(settings) {
    network_.start(loop_->now());
    gateway_.add(network_);
    server_ = *TcpServer::create(*loop_, gateway_, "127.0.0.1:0", limits);
    server_->on_note([this](std::string_view note) { notes_.emplace_back(note); });
  }

  Client connect() {
    const std::size_t before = server_->clients();
    Client client(server_->address());
    EXPECT_TRUE(until([&] { return server_->clients() > before; }));
    return client;
  }
  /// Runs the loop until the condition holds, for ten seconds at most.
  template <class Condition>
  bool until(Condition condition) {
    const Time end = loop_->now() + 10s;
    while (!condition() && loop_->now() < end) loop_->run_until(loop_->now() + 1ms);
    return condition();
  }
  bool is_noted(std::string_view part) const {
    return std::ranges::any_of(
        notes_, [part](const std::string& note) { return note.find(part) != std::string::npos; });
  }

  // Output until the end.
  std::vector<std::string> sent_;
  std::vector<std::string> notes_;
  std::unique_ptr<host::EventLoop> loop_;
  Network network_;
  Gateway gateway_;
  std::unique_ptr<TcpServer> server_;

 private:
  static bool take(void* context, const Frame& frame) {
    static_cast<GatewayTcp*>(context)->sent_.push_back(wire_text(frame));
    return true;
  }
};

TEST_F(GatewayTcp, ACommandIsAnswered) {
  Client client = connect();
  client.say("[1] 5 start\r\n");
  EXPECT_TRUE(until([&] { return client.heard() == "[1] OK\r\n"; }));
  EXPECT_EQ(sent_, std::vector<std::string>{"000#01 05"});
}

TEST_F(GatewayTcp, AnAnswerThatTakesTimeComesWhenTheFrameComes) {
  Client client = connect();
  client.say("[1] 5 r 0x1000 0 u32\r\n");
  EXPECT_TRUE(until([&] { return !sent_.empty(); }));
  EXPECT_EQ(client.heard(), "");
  network_.receive(wire_frame("585#43 00 10 00 A3 01 00 00"), loop_->now());
  EXPECT_TRUE(until([&] { return client.heard() == "[1] 419\r\n"; }));
}

TEST_F(GatewayTcp, ACommandThatTakesTooLongIsAnswered) {
  Client client = connect();
  client.say("[1] set command_timeout 20\r\n[2] 5 r 0x1000 0 u32\r\n");
  EXPECT_TRUE(until([&] { return client.heard() == "[1] OK\r\n[2] ERROR:103\r\n"; }));
}

TEST_F(GatewayTcp, BytesMayComeOneByOne) {
  Client client = connect();
  for (const char c : std::string("[1] 5 start\r\n[2] 5 stop\r\n")) {
    client.say({&c, 1});
    loop_->run_until(loop_->now() + 100us);
  }
  EXPECT_TRUE(until([&] { return client.heard() == "[1] OK\r\n[2] OK\r\n"; }));
}

TEST_F(GatewayTcp, AllClientsHearEvents) {
  Client first = connect();
  Client second = connect();
  network_.receive(wire_frame("705#00"), loop_->now());
  EXPECT_TRUE(until([&] { return first.heard() == "1 5 BOOT_UP\r\n"; }));
  EXPECT_TRUE(until([&] { return second.heard() == "1 5 BOOT_UP\r\n"; }));
}

TEST_F(GatewayTcp, ManyCommandsAtOnceAreAllAnsweredInTheirOrder) {
  Client client = connect();
  constexpr int count = 20'000;
  std::string all;
  std::string expected;
  for (int i = 0; i < count; ++i) {
    all += "[" + std::to_string(i) + "] 5 start\r\n";
    expected += "[" + std::to_string(i) + "] OK\r\n";
  }
  std::string_view rest = all;
  EXPECT_TRUE(until([&] {
    rest.remove_prefix(client.say(rest));
    return client.heard().size() >= expected.size();
  }));
  EXPECT_TRUE(client.heard() == expected);
  EXPECT_EQ(sent_.size(), std::size_t{count});
}

TEST_F(GatewayTcp, AClientThatEndsItsHalfIsServedToTheEnd) {
  Client client = connect();
  client.say("[1] 5 r 0x1000 0 u32\r\n[2] 5 sta");
  client.end_output();
  EXPECT_TRUE(until([&] { return !sent_.empty(); }));
  loop_->run_until(loop_->now() + 10ms);
  EXPECT_FALSE(client.is_closed());
  network_.receive(wire_frame("585#43 00 10 00 A3 01 00 00"), loop_->now());
  EXPECT_TRUE(until([&] { return client.is_closed(); }));
  EXPECT_EQ(client.heard(), "[1] 419\r\n") << "half a command is none";
  EXPECT_TRUE(until([&] { return server_->clients() == 0; }));
}

TEST_F(GatewayTcp, AClientThatVanishesTakesItsCommandsAlong) {
  Client client = connect();
  client.say("[1] 5 r 0x1000 0 u32\r\n");
  EXPECT_TRUE(until([&] { return !sent_.empty(); }));
  client.reset();
  EXPECT_TRUE(until([&] { return server_->clients() == 0; }));
  EXPECT_EQ(sent_.back(), "605#80 00 10 00 00 00 00 08");
  EXPECT_TRUE(is_noted("left"));
}

TEST_F(GatewayTcp, AsManyClientsAsAllowedAndNotOneMore) {
  std::vector<Client> clients;
  for (std::size_t i = 0; i < TcpLimits{}.clients_max; ++i) clients.push_back(connect());
  Client one_more(server_->address());
  EXPECT_TRUE(until([&] { return one_more.is_closed(); }));
  EXPECT_EQ(one_more.heard(), "# too many clients: try again later\r\n");
  clients.front().reset();
  EXPECT_TRUE(until([&] { return server_->clients() < TcpLimits{}.clients_max; }));
  Client late = connect();
  late.say("[1] 5 start\r\n");
  EXPECT_TRUE(until([&] { return late.heard() == "[1] OK\r\n"; }));
}

TEST_F(GatewayTcp, GarbageIsAnsweredAndHarmsNobody) {
  Client garbler = connect();
  Client other = connect();
  std::string garbage;
  for (unsigned i = 0; i < 100'000; ++i) garbage += static_cast<char>(i * 7919 >> 3);
  std::string_view rest = garbage;
  EXPECT_TRUE(until([&] {
    rest.remove_prefix(garbler.say(rest));
    garbler.heard();
    return rest.empty();
  }));
  other.say("[1] 5 start\r\n");
  EXPECT_TRUE(until([&] { return other.heard() == "[1] OK\r\n"; }));
  EXPECT_TRUE(until([&] { return garbler.heard().starts_with("[0] ERROR:101\r\n"); }));
  EXPECT_EQ(sent_.size(), 1U);
}

class GatewayTcpWithFewEvents : public GatewayTcp {
 protected:
  GatewayTcpWithFewEvents() : GatewayTcp({.event_bytes_max = 64 * 1024}) {}
};

TEST_F(GatewayTcpWithFewEvents, AClientThatDoesNotReadIsDroppedAndTheOthersAreServed) {
  Client sleeper = connect();
  sleeper.shrink_receive_buffer();
  Client reader = connect();
  const std::string line = "1 5 EMCY 8130 11 1 2 3 4 255\r\n";
  std::size_t events = 0;
  EXPECT_TRUE(until([&] {
    for (int i = 0; i < 1000; ++i, ++events) {
      network_.receive(wire_frame("085#30 81 11 01 02 03 04 FF"), loop_->now());
      reader.heard();
    }
    return is_noted("dropped");
  }));
  EXPECT_TRUE(until([&] { return reader.heard().size() == events * line.size(); }));
  EXPECT_TRUE(until([&] { return server_->clients() == 1; }));
}

// Data that a page in a browser can send to a port of its machine: a form of `text/plain`.
TEST_F(GatewayTcp, AWebPageCommandsNothing) {
  const std::string post =
      "POST / HTTP/1.1\r\nHost: 127.0.0.1:60000\r\nContent-Type: text/plain\r\n"
      "Content-Length: 13\r\n\r\n[1] 5 start\r\n";
  for (const std::size_t cut : {std::size_t{0}, std::size_t{3}, post.find('\n'), post.size()}) {
    Client page = connect();
    page.say(post.substr(0, cut));
    loop_->run_until(loop_->now() + 1ms);
    page.say(post.substr(cut));
    EXPECT_TRUE(until([&] { return page.is_closed(); }));
    EXPECT_EQ(page.heard(), "") << "nothing that a browser could show or run";
  }
  EXPECT_TRUE(is_noted("dropped: it speaks HTTP"));
  EXPECT_EQ(sent_, std::vector<std::string>{});
}

TEST_F(GatewayTcp, ATlsClientCommandsNothing) {
  Client client = connect();
  client.say(std::string_view("\x16\x03\x01\x00\xFF\n[1] 5 start\r\n", 19));
  EXPECT_TRUE(until([&] { return client.is_closed(); }));
  EXPECT_TRUE(is_noted("dropped: it speaks TLS"));
  EXPECT_EQ(sent_, std::vector<std::string>{});
}

TEST_F(GatewayTcp, WithoutDescriptorsNewcomersWaitAndCostNoTime) {
  Client first = connect();
  Client late;
  const int free = ::dup(STDOUT_FILENO);
  ::close(free);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{.rlim_cur = static_cast<rlim_t>(free), .rlim_max = before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  late.connect(server_->address());
  late.say("[1] 5 start\r\n");
  const std::uint64_t wakeups = loop_->counters().wakeups;
  loop_->run_until(loop_->now() + 350ms);
  EXPECT_LT(loop_->counters().wakeups - wakeups, 20U);
  EXPECT_EQ(std::ranges::count(notes_, "no client can come: Too many open files"), 1);
  first.say("[2] 5 stop\r\n");
  EXPECT_TRUE(until([&] { return first.heard() == "[2] OK\r\n"; }));
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_TRUE(until([&] { return late.heard() == "[1] OK\r\n"; }));
}

class GatewayTcpWithLittleTime : public GatewayTcp {
 protected:
  GatewayTcpWithLittleTime()
      : GatewayTcp({}, {.clients_max = 3, .idle_max = 800ms, .idle_for_others = 300ms}) {}
};

TEST_F(GatewayTcpWithLittleTime, WhoIsIdleIsDropped) {
  Client idle = connect();
  Client speaker = connect();
  Client waiter = connect();
  waiter.say("[1] set sdo_timeout 10000\r\n[2] 5 r 0x1000 0 u32\r\n");
  const Time begin = loop_->now();
  EXPECT_TRUE(until([&] {
    speaker.say("# still here\r\n");
    return idle.is_closed();
  }));
  EXPECT_GE(loop_->now() - begin, 700ms);
  EXPECT_TRUE(is_noted("dropped: it is idle"));
  EXPECT_FALSE(speaker.is_closed());
  EXPECT_FALSE(waiter.is_closed()) << "it waits for an answer";
  EXPECT_TRUE(until([&] { return speaker.is_closed(); })) << "it said no more";
  EXPECT_FALSE(waiter.is_closed());
}

TEST_F(GatewayTcpWithLittleTime, WhoIsIdleLongestMakesRoomForANewcomer) {
  Client idle = connect();
  Client busy = connect();
  Client other = connect();
  Client too_early(server_->address());
  EXPECT_TRUE(until([&] { return too_early.is_closed(); }));
  EXPECT_EQ(too_early.heard(), "# too many clients: try again later\r\n");
  for (const Time end = loop_->now() + 400ms; loop_->now() < end;) {
    busy.say("[1] 5 start\r\n");
    other.say("[1] 5 start\r\n");
    idle.say("\r\n# nothing\r\n");  // no command
    loop_->run_until(loop_->now() + 3ms);
  }
  Client newcomer(server_->address());
  newcomer.say("[1] 5 start\r\n");
  EXPECT_TRUE(until([&] { return newcomer.heard() == "[1] OK\r\n"; }));
  EXPECT_TRUE(idle.is_closed());
  EXPECT_TRUE(is_noted("dropped: it is idle, and others wait"));
  EXPECT_FALSE(busy.is_closed());
  EXPECT_FALSE(other.is_closed());
}

TEST_F(GatewayTcp, NotesOnClientsHaveAnEnd) {
  for (int i = 0; i < 100; ++i) {
    const std::size_t before = server_->clients();
    {
      Client passing(server_->address());
      until([&] { return server_->clients() > before; });
    }
    until([&] { return server_->clients() == before; });
  }
  EXPECT_EQ(notes_.size(), 30U);
}

class GatewayTcpWithLittleMemory : public GatewayTcp {
 protected:
  GatewayTcpWithLittleMemory() : GatewayTcp({}, {.bytes_max = 100'000}) {}
};

TEST_F(GatewayTcpWithLittleMemory, WhoHoldsMostIsDroppedWhereAllHoldTooMuch) {
  const std::string line = "[1] 5 w 0x1F50 1 d " + std::string(40'000, 'A');
  Client greedy = connect();
  Client modest = connect();
  greedy.say(line + "\r\n" + line);
  modest.say(line);
  EXPECT_TRUE(until([&] { return greedy.is_closed(); }));
  EXPECT_TRUE(is_noted("dropped: it holds most of the memory of all clients"));
  modest.say("\r\n");
  EXPECT_TRUE(until([&] { return std::ranges::count(sent_, "605#21 50 1F 01 30 75 00 00") == 2; }));
  EXPECT_FALSE(modest.is_closed());
}

TEST_F(GatewayTcp, APortThatIsTakenIsAnErrorThatNamesIt) {
  const auto second = TcpServer::create(*loop_, gateway_, server_->address());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().line(),
            server_->address() + ": Address already in use; choose another address or port");
}

TEST(GatewayTcpAddress, IsAnAddressAndAPort) {
  for (const char* text : {"127.0.0.1:60000", "0.0.0.0:1", "[::1]:65535", "[2001:db8::1]:0"}) {
    const auto address = parse_tcp_address(text);
    ASSERT_TRUE(address) << text;
    EXPECT_EQ(address->text(), text);
  }
}

TEST(GatewayTcpAddress, WhatIsNoneIsRefusedWithALine) {
  for (const char* text :
       {"", "127.0.0.1", "127.0.0.1:", ":60000", "127.0.0.1:65536", "localhost:1", "::1:60000",
        "[::1]", "[]:1", "127.0.0.1:0x", "256.0.0.1:1", "[1.2.3.4]:1"}) {
    const auto address = parse_tcp_address(text);
    ASSERT_FALSE(address) << text;
    EXPECT_NE(address.error().line().find("127.0.0.1:60000"), std::string::npos);
  }
}

TEST(GatewayTcpAddress, KnowsTheLoopback) {
  EXPECT_TRUE(parse_tcp_address("127.0.0.1:1")->is_loopback());
  EXPECT_TRUE(parse_tcp_address("127.9.9.9:1")->is_loopback());
  EXPECT_TRUE(parse_tcp_address("[::1]:1")->is_loopback());
  EXPECT_FALSE(parse_tcp_address("0.0.0.0:1")->is_loopback());
  EXPECT_FALSE(parse_tcp_address("192.168.0.1:1")->is_loopback());
  EXPECT_FALSE(parse_tcp_address("[::]:1")->is_loopback());
}

}  // namespace
}  // namespace canvoy::gateway::tcp_server_test
