// What an operating system would do for the network of a page, and a browser does not: files, real
// buses, terminals and threads. Who asks for them is told in a line; most cannot be asked for
// there.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/formats/gtfs/feed_archive.hpp"
#include "canvoy/formats/trace/inflater.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/png_file.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/play/bus_realtime.hpp"
#include "canvoy/tools/play/run_depot.hpp"
#include "canvoy/tools/player/player.hpp"
#include "canvoy/tools/player/real_buses.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/watch/log_writer.hpp"
#include "canvoy/tools/watch/value_table.hpp"

namespace {

constexpr const char* no_files = "a browser has no files";

[[noreturn]] void refuse(const char* why = no_files) {
  throw canvoy::tools::Failure(why);
}

}  // namespace

namespace canvoy::host {

EventLoop::EventLoop(Descriptor poll, Descriptor timer, Descriptor wakeup)
    : poll_(std::move(poll)), timer_(std::move(timer)), wakeup_(std::move(wakeup)) {}

EventLoop::~EventLoop() = default;

Result<std::unique_ptr<EventLoop>> EventLoop::create() {
  return std::unique_ptr<EventLoop>(new EventLoop({}, {}, {}));
}

Time EventLoop::now() const {
  return {};
}

EventLoop::Id EventLoop::at(Time, TimerAction) {
  return 0;
}

void EventLoop::cancel(Id) {}

void EventLoop::remove(Id) {}

HostBus::~HostBus() = default;

void HostBus::leave(Endpoint&) {}

Result<CandumpWriter> CandumpWriter::create(const std::string& path, Duration) {
  return Error{path, no_files, "save the log by the page's Share"};
}

CandumpWriter::~CandumpWriter() = default;

Result<void> CandumpWriter::write(Time, std::string_view, const Frame&) {
  return {};
}

Result<void> CandumpWriter::flush() {
  return {};
}

Result<void> CandumpWriter::flush_each_second(Time) {
  return {};
}

Result<AtomicFile> AtomicFile::begin(const std::string& path) {
  return Error{path, no_files, ""};
}

AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;

AtomicFile::~AtomicFile() = default;

Result<void> AtomicFile::write(std::span<const std::uint8_t>) {
  return {};
}

Result<void> AtomicFile::finish() {
  return {};
}

}  // namespace canvoy::host

namespace canvoy::formats {

struct Deflater::Stream {};

Deflater::~Deflater() = default;

std::string_view Deflater::run(std::string_view, bool) {
  return {};
}

}  // namespace canvoy::formats

namespace canvoy::gtfs {

void CloseFile::operator()(std::FILE*) const {}

void CloseZipFile::operator()(::zip_file*) const {}

void CloseZip::operator()(::zip*) const {}

host::Result<std::size_t> FeedFile::read(std::span<char>) {
  return wrong(no_files);
}

host::Result<FeedArchive> FeedArchive::open(const std::string& path) {
  return host::Error{path, no_files, ""};
}

host::Result<FeedFile> FeedArchive::file(std::string_view name) const {
  return host::Error{std::string(name), no_files, ""};
}

}  // namespace canvoy::gtfs

namespace canvoy::tools {

host::Result<LogWriter> LogWriter::create(const std::string& path, Duration) {
  return host::Error{path, no_files, "save the log by the page's Share"};
}

host::Result<void> LogWriter::write(Time, std::string_view, const Frame&) {
  return {};
}

host::Result<void> LogWriter::flush_each_second(Time) {
  return {};
}

host::Result<void> LogWriter::finish() {
  return {};
}

std::string log_option_text(std::string_view what) {
  return std::string(what);
}

std::string_view csv_head() {
  return {};
}

void append_csv(std::string&, const ValueRow&) {}

RealBuses::RealBuses(World&, const std::vector<RealBus>&, host::EventLoop&) {
  refuse("a browser has no real buses");
}

Time RealBuses::reach(Time) {
  return {};
}

std::string RealBuses::trouble() const {
  return {};
}

std::uint64_t RealBuses::frames_lost() {
  return 0;
}

host::BusAddress real_bus(std::string_view) {
  refuse("a browser has no real buses");
}

std::unique_ptr<RealtimeOutlet> open_realtime(const std::string&, bus_line::BusNetwork&) {
  refuse("a browser serves nothing to others: leave --gtfs-rt out");
}

int run_depot(const DepotOptions&) {
  refuse("a browser plays one vehicle: leave --vehicles out");
}

int play(PlayedNetwork&, const PlayOptions&) {
  refuse("a browser has no terminal");
}

int verdict_status(const nlohmann::ordered_json&, bool) {
  return exit_done;
}

Screen::Size Screen::size() {
  return {};
}

void write_png(const std::string&, const Picture&) {
  refuse();
}

// Data sheets are of files, and so are hands that drive a car.

formats::DataSheet read_sheet_file(const std::string&, formats::Findings&) {
  refuse();
}

Configuration read_configuration(const std::string&, NodeId) {
  refuse();
}

Configuration parse_configuration(std::string_view, std::span<const std::uint8_t>, NodeId) {
  refuse();
}

bool DeviceCar::drive(double) {
  return false;
}

void DeviceCar::sense(CarSense, std::optional<double>) {}

void DeviceCar::sense_gps(const std::string&, std::function<void(cia447::GpsReading&)>) {}

void DeviceCar::set_clock(CarClock, Duration) {}

}  // namespace canvoy::tools
