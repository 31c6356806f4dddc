// canvoy gateway: serves CANopen networks to clients with the ASCII protocol of CiA 309-3.
#include "canvoy/gateway/gateway.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/can_link.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/gateway/number.hpp"
#include "canvoy/gateway/tcp_server.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/network/boot_master.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

struct GatewayOptions {
  std::vector<std::string> buses;
  std::string listen = "127.0.0.1:60000";
  std::string node_id;
  std::string version = "3.0";
  std::string idle;
  std::string boot;
  bool from_stdin = false;
  bool explain = false;
};

struct NumberedBus {
  std::uint16_t number;
  std::string address;
};

/// `can0`, which gets the next number, or `2=can0`.
std::vector<NumberedBus> parse_buses(const std::vector<std::string>& texts) {
  std::vector<NumberedBus> buses;
  std::set<unsigned> numbers;
  for (const std::string& text : texts) {
    const std::size_t separator = text.find('=');
    // In `udp:...?ttl=1` the sign has another meaning.
    const auto given = separator == std::string::npos
                           ? std::nullopt
                           : gateway::parse_unsigned(text.substr(0, separator), UINT16_MAX);
    const std::uint64_t number = given.value_or(buses.size() + 1);
    if (number == 0) throw UsageError(fmt::format("'{}': networks are numbered from 1", text));
    if (!numbers.insert(static_cast<unsigned>(number)).second) {
      throw UsageError(fmt::format("network {} is there twice; number the others", number));
    }
    buses.push_back(
        {static_cast<std::uint16_t>(number), given ? text.substr(separator + 1) : text});
  }
  return buses;
}

gateway::Version parse_version(std::string_view text) {
  if (text == "3.0") return gateway::Version::v3_0;
  if (text == "2.1") return gateway::Version::v2_1;
  throw UsageError(fmt::format("'{}' is no edition of CiA 309-3 known here: 3.0 or 2.1", text));
}

gateway::SessionSettings session_settings(const GatewayOptions& options) {
  gateway::SessionSettings settings;
  settings.style = {.version = parse_version(options.version), .explain = options.explain};
  return settings;
}

gateway::TcpLimits tcp_limits(const GatewayOptions& options) {
  gateway::TcpLimits limits;
  if (!options.idle.empty()) limits.idle_max = parse_duration_argument(options.idle);
  return limits;
}

/// True if the interface has this bit rate, by its index in CiA 305; an interface without a
/// controller has any. It is not set here, since that would take the interface from all other
/// users; use `ip link`.
bool has_bit_rate(const std::string& interface, unsigned index) {
  const host::Result<host::CanLink> link = host::read_can_link(interface);
  if (!link) return false;
  const bool is_known = index < lss_bit_timing::bit_rates.size();
  return !link->has_controller || (is_known && link->bit_rate == lss_bit_timing::bit_rates[index]);
}

/// Settings for this bus only.
gateway::NetworkSettings settings_for(const host::BusAddress& address,
                                      gateway::NetworkSettings settings) {
  if (address.kind == host::BusType::socketcan) {
    settings.set_bit_rate = [interface = address.interface](unsigned index) {
      return has_bit_rate(interface, index);
    };
  }
  return settings;
}

/// A bus with its network.
class ServedNetwork {
 public:
  ServedNetwork(host::EventLoop& loop, const NumberedBus& bus,
                const gateway::NetworkSettings& settings)
      : bus_(value_or_throw(host::open_bus(loop, real_bus(bus.address)))),
        loop_(loop),
        attachment_(loop, *bus_),
        network_(bus.number, attachment_.port(), settings_for(real_bus(bus.address), settings)) {
    bus_->on_trouble(
        [](const host::Error& error) { print_message(fmt::format("canvoy: {}", error.line())); });
    // Lost frames are noticed at the next received one.
    bus_->on_frame([this](const host::BusFrame&) { look_for_overrun(); });
    attachment_.attach(network_);
    network_.start(loop.now());
  }

  gateway::Network& network() { return network_; }
  host::HostBus& bus() { return *bus_; }
  std::string text() const { return fmt::format("{} = {}", network_.number(), bus_->name()); }

 private:
  void look_for_overrun() {
    const std::uint64_t overruns = bus_->counters().carrier.overrun;
    if (std::exchange(overruns_, overruns) != overruns) network_.overrun(loop_.now());
  }

  std::unique_ptr<host::HostBus> bus_;
  host::EventLoop& loop_;
  host::Attachment attachment_;
  gateway::Network network_;
  std::uint64_t overruns_ = 0;
};

/// An NMT master beside the gateway, which boots the network from a plan (CiA 302-2) and reports
/// the result for each slave to the clients of the gateway.
class BootedNetwork {
 public:
  BootedNetwork(host::EventLoop& loop, ServedNetwork& served, BootPlan plan)
      : plan_(std::move(plan)),
        network_(served.network()),
        attachment_(loop, served.bus()),
        master_(plan_, attachment_.port()) {
    master_.boot_manager().on_report(callback<&BootedNetwork::told>(*this));
    attachment_.attach(master_.node());
    master_.node().start(loop.now());
  }
  BootedNetwork(const BootedNetwork&) = delete;
  BootedNetwork& operator=(const BootedNetwork&) = delete;

 private:
  /// A slave that is to be started is reported when it has started.
  void told(const BootReport& report) {
    const BootError error = report.outcome.error;
    switch (report.event) {
      case BootEvent::retried:
      case BootEvent::failed:
      case BootEvent::given_up:
      case BootEvent::unknown:
        return network_.boot_ended(report.slave, error, NmtState::initialisation);
      case BootEvent::booted:
        if (error == BootError::none && plan_.start != BootPlan::Start::none) return;
        return network_.boot_ended(report.slave, error, NmtState::pre_operational);
      case BootEvent::started:
        return network_.boot_ended(report.slave, BootError::none, NmtState::operational);
      default:
        return;
    }
  }

  BootPlan plan_;
  gateway::Network& network_;
  host::Attachment attachment_;
  BootMaster master_;
};

/// The plan of --boot, or nothing.
std::optional<BootPlan> boot_plan(const GatewayOptions& options, std::optional<NodeId> gateway_id) {
  if (options.boot.empty()) return std::nullopt;
  if (options.buses.size() != 1) throw UsageError("--boot: of one network only");
  BootPlan plan = read_boot_plan(options.boot);
  check(plan);
  if (gateway_id == plan.master) {
    throw UsageError(fmt::format("--boot: its master and the gateway are both {}",
                                 text::node_text(plan.master)));
  }
  return plan;
}

/// Commands from a pipe or a file: the answers go to stdout, and the end of the input ends the
/// gateway.
class StdinClient {
 public:
  StdinClient(host::EventLoop& loop, gateway::Gateway& gateway)
      : loop_(loop), gateway_(gateway), session_(gateway.open()) {
    gateway_.on_settled([this] { serve(); });
    host::Task task;
    task.deadline = callback<&StdinClient::deadline>(*this);
    task.advance = callback<&StdinClient::advance>(*this);
    task_ = loop_.add(task);
  }
  ~StdinClient() {
    gateway_.on_settled({});
    loop_.remove(task_);
    if (watch_ != 0) loop_.unwatch(watch_);
  }
  StdinClient(const StdinClient&) = delete;
  StdinClient& operator=(const StdinClient&) = delete;

  /// 0 if all commands succeeded.
  int run() {
    // A file is always readable, and epoll does not accept it.
    is_file_ = !watch();
    loop_.run();
    const bool complete = loop_.signal() == 0 && session_.failures() == 0;
    return complete ? exit_done : exit_failed;
  }

 private:
  Time deadline() const {
    const bool may_read = is_file_ && !ended_ && session_.wants_input();
    return may_read ? Time::min() : gateway_.deadline();
  }
  void advance(Time now) {
    if (is_file_ && !ended_ && session_.wants_input()) receive();
    gateway_.advance(now);
  }
  bool watch() {
    const auto id = loop_.watch(STDIN_FILENO, {.readable = true},
                                host::EventLoop::Ready::to<&StdinClient::ready>(*this));
    if (id) watch_ = *id;
    return static_cast<bool>(id);
  }
  /// A closed pipe is signalled as long as it is watched, for any event.
  void watch_as_wanted() {
    const bool wanted = !ended_ && session_.wants_input();
    if (!wanted && watch_ != 0) loop_.unwatch(std::exchange(watch_, 0));
    if (wanted && watch_ == 0) watch();
  }
  void ready(host::Readiness) {
    receive();
    gateway_.settle(loop_.now());
  }
  void receive() {
    std::array<char, 4096> bytes;
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size > 0) return session_.receive({bytes.data(), static_cast<std::size_t>(size)});
    ended_ = true;
    session_.end_input();
  }
  void serve() {
    const std::string_view output = session_.output();
    fmt::print("{}", output);
    if (!output.empty()) std::fflush(stdout);
    session_.consume(output.size());
    if (!is_file_) watch_as_wanted();
    if (ended_ && session_.idle()) loop_.stop();
  }

  host::EventLoop& loop_;
  gateway::Gateway& gateway_;
  gateway::Session& session_;
  host::EventLoop::Id watch_ = 0;
  host::EventLoop::Id task_ = 0;
  bool is_file_ = false;
  bool ended_ = false;
};

int serve_tcp(host::EventLoop& loop, gateway::Gateway& gateway, const GatewayOptions& options,
              std::string_view networks) {
  const auto server = value_or_throw(
      gateway::TcpServer::create(loop, gateway, options.listen, tcp_limits(options)));
  fmt::print("listening at {}, networks {}\n", server->address(), networks);
  std::fflush(stdout);
  if (!server->is_loopback()) {
    print_message(fmt::format("canvoy: {}: the protocol has no password: who reaches it, commands",
                              server->address()));
  }
  server->on_note([](std::string_view line) { print_message(fmt::format("canvoy: {}", line)); });
  loop.run();
  return exit_done;
}

int run_gateway(const GatewayOptions& options) {
  const gateway::SessionSettings settings = session_settings(options);
  gateway::NetworkSettings network_settings;
  network_settings.version = settings.style.version;
  if (!options.node_id.empty()) network_settings.node_id = parse_node_id(options.node_id);
  const std::optional<BootPlan> plan = boot_plan(options, network_settings.node_id);
  const auto loop = value_or_throw(host::EventLoop::create());
  std::vector<std::unique_ptr<ServedNetwork>> networks;
  gateway::Gateway gateway(settings);
  std::string names;
  for (const NumberedBus& bus : parse_buses(options.buses)) {
    networks.push_back(std::make_unique<ServedNetwork>(*loop, bus, network_settings));
    gateway.add(networks.back()->network());
    names += (names.empty() ? "" : ", ") + networks.back()->text();
  }
  std::unique_ptr<BootedNetwork> booted;
  if (plan) booted = std::make_unique<BootedNetwork>(*loop, *networks.front(), *plan);
  ok_or_throw(loop->stop_on_signals());
  if (options.from_stdin) return StdinClient(*loop, gateway).run();
  return serve_tcp(*loop, gateway, options, names);
}

}  // namespace

void add_gateway(Verb& app) {
  const auto options = std::make_shared<GatewayOptions>();
  Verb& command = app.add_verb(
      "gateway", "Serve networks to clients that speak the ASCII protocol of CiA 309-3");
  command.add({
      {"bus", options->buses,
       "a network: can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0; with a number of "
       "its own as 2=can1; or several",
       required},
      {"--listen", options->listen, "address and port of TCP (default 127.0.0.1:60000)"},
      {"--stdin", options->from_stdin,
       "take commands from stdin instead, and end with it; status 1 if one failed",
       excludes("--listen")},
      {"--idle", options->idle, "drop clients that say nothing for so long (default 1h)"},
      {"--node-id", options->node_id,
       "of the gateway itself, for PDOs, guarding and a heartbeat (default: none)"},
      {"--version", options->version,
       "how answers are written: 3.0 (as CANopenNode) or 2.1 (as Lely)"},
      {"--boot", options->boot,
       "a network to boot, in a file as that of canvoy boot: clients are told how it "
       "ended for each slave (USER BOOT)"},
      {"--explain", options->explain, "add the meaning of errors as a comment"},
  });
  command.add_examples(
      "  canvoy gateway can0 --listen 127.0.0.1:60000\n"
      "  canvoy gateway can0 2=can1 --node-id 127 --idle 10min\n"
      "  echo '[1] 10 read 0x1000 0 u32' | canvoy gateway can0 --stdin");
  command.runs([options] { return run_gateway(*options); });
}

}  // namespace canvoy::tools
