#include "canvoy/tools/device/bus/device_bus_panel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/bus/device_bus_displays.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t bus_sector_size = 4096;
/// Two each for the node-ID and for the values.
constexpr std::uint32_t bus_sectors = 4;
constexpr RecordPair::Place bus_values_place = {
    .address = 2 * bus_sector_size, .slot_size = bus_sector_size, .kind = 0x5653'5542};  // "BUSV"

/// The numbers of KeptBusValues, eight bytes each.
using BusNumbers = std::array<std::uint64_t, 11>;
using BusNumberBytes = std::array<std::uint8_t, sizeof(BusNumbers)>;

}  // namespace

BusStore::BusStore(const std::string& path)
    : file_(value_or_throw(
          host::FileFlash::open(path, {.sector_size = bus_sector_size, .sectors = bus_sectors}))),
      values_(file_->flash(), bus_values_place) {}

LssStore::Place BusStore::lss_place() const {
  return {.address = 0, .slot_size = bus_sector_size};
}

KeptBusValues BusStore::load() {
  BusNumberBytes bytes;
  if (!values_.load(bytes)) return {};
  BusNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers.at(i) = canvoy::load<std::uint64_t>(&bytes.at(i * sizeof(std::uint64_t)));
  }
  KeptBusValues values{.assignment = {.driver_id = static_cast<std::uint32_t>(numbers[0]),
                                      .destination_number = static_cast<std::uint32_t>(numbers[1]),
                                      .line_id = static_cast<std::uint16_t>(numbers[2]),
                                      .route_number = static_cast<std::uint16_t>(numbers[3]),
                                      .block_id = static_cast<std::uint32_t>(numbers[4]),
                                      .journey_number = static_cast<std::uint16_t>(numbers[5])},
                       .metres = std::bit_cast<double>(numbers[6]),
                       .trip_begin = std::bit_cast<double>(numbers[7]),
                       .counts = {.in = static_cast<std::uint16_t>(numbers[8]),
                                  .out = static_cast<std::uint16_t>(numbers[9]),
                                  .aboard = static_cast<unsigned>(numbers[10])}};
  return values;
}

void BusStore::keep(const KeptBusValues& values) {
  const cia407::Assignment& drives = values.assignment;
  const BusNumbers numbers = {drives.driver_id,
                              drives.destination_number,
                              drives.line_id,
                              drives.route_number,
                              drives.block_id,
                              drives.journey_number,
                              std::bit_cast<std::uint64_t>(values.metres),
                              std::bit_cast<std::uint64_t>(values.trip_begin),
                              values.counts.in,
                              values.counts.out,
                              values.counts.aboard};
  BusNumberBytes bytes;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    store(&bytes.at(i * sizeof(std::uint64_t)), numbers.at(i));
  }
  values_.keep(bytes);
}

namespace {

constexpr double cabin_celsius = 20;

}  // namespace

void BusComputer::join(Environment& environment) {
  using namespace cia407;
  environment.provide(callback<&BusComputer::hardware>(*this));
  environment.watch(unit_);
  environment.provide(callback<&BusComputer::identification_hardware>(*this));
  environment.watch(identification_);
}

void BusComputer::act(const BusPress& press) {
  if (press.what == "log-in" || press.what == "log-out") log_in(press);
  if (press.what == "stop") unit_->request_stop();
  if (press.what == "block" || press.what == "unblock") {
    unit_->block_tickets(press.what == "block");
  }
  if (press.what == "place") place(press);
}

/// After a log-out there is no assignment.
void BusComputer::log_in(const BusPress& press) {
  const auto given = [&](std::string_view name) { return press.number(name).value_or(0); };
  assignment_ = {.driver_id = given("driver"),
                 .destination_number = given("destination"),
                 .line_id = static_cast<std::uint16_t>(given("line")),
                 .route_number = static_cast<std::uint16_t>(given("route")),
                 .block_id = given("block"),
                 .journey_number = static_cast<std::uint16_t>(given("journey"))};
  identification_->log_in(assignment_);
}

void BusComputer::place(const BusPress& press) {
  unit_->set_position(
      {.stop_point_id = press.number("stop").value_or(0),
       .number_of_running = static_cast<std::uint8_t>(press.number("running").value_or(1)),
       .fare_zone = static_cast<std::uint8_t>(press.number("zone").value_or(0)),
       .route_segment = static_cast<std::uint16_t>(press.number("segment").value_or(0))});
}

cia407::MainOnBoardComputerHardware BusComputer::hardware() {
  return {.clock = callback<&BusComputer::clock>(*this),
          .inside_temperature = {[](void*) -> std::optional<double> { return cabin_celsius; },
                                 nullptr}};
}

cia407::IdentificationHardware BusComputer::identification_hardware() {
  assignment_ = kept_;
  return {.remembered = callback<&BusComputer::remembered>(*this)};
}

namespace {

struct SegmentWord {
  std::string_view word;
  void (*apply)(cia407::BusSegment& segment);
};
constexpr SegmentWord segment_words[] = {
    {"minimum",
     [](cia407::BusSegment& segment) { segment.configuration = cia407::Configuration::minimum; }},
    {"no-main-computer", [](cia407::BusSegment& segment) { segment.has_main_computer = false; }},
    {"no-diagnostics", [](cia407::BusSegment& segment) { segment.has_diagnostics = false; }},
    {"identification-texts",
     [](cia407::BusSegment& segment) { segment.identification_provides_texts = true; }},
};

}  // namespace

cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words) {
  cia407::BusSegment segment;
  for (const std::string& word : words) {
    const auto found = std::ranges::find(segment_words, word, &SegmentWord::word);
    if (found == std::end(segment_words)) {
      std::vector<std::string_view> known;
      for (const SegmentWord& each : segment_words) known.push_back(each.word);
      throw UsageError(fmt::format("--segment: '{}' is none of {}", word, fmt::join(known, ", ")));
    }
    found->apply(segment);
  }
  return segment;
}

void add_bus_panel_options(Verb& command, BusPanelOptions& options) {
  command.add({
      {"--segment", options.segment,
       "of a network of CiA 407, each by itself: minimum (the configuration), "
       "no-main-computer, no-diagnostics, identification-texts",
       one_each},
      {"--display", options.display,
       "columns and lines of a passenger information device (default 32x4)"},
      {"--png", options.png, "the file in which its display is drawn, whenever it looks different"},
      {"--announce", options.announcements,
       "what an acoustic-announcer says of a stop point: '17=Town Hall'; it has nothing "
       "for others then",
       one_each},
      {"--capacity", options.capacity,
       "passengers of the vehicle of a passenger-counting-manager (default 80)",
       between(1U, 1000U)},
  });
}

void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses) {
  for (const std::string& text : presses) parse_bus_press(units, text);
  parse_bus_segment(options.segment);
  parse_display_size(options.display);
  parse_announcements(options.announcements);
  const std::size_t displays = display_names(units).size();
  if (!options.png.empty() && displays != 1) {
    throw UsageError(
        fmt::format("--png: the picture is one of a display, and there are {}", displays));
  }
}

namespace {

constexpr std::size_t relayed_value_max = 4;

}  // namespace

void TrainBus::join(Environment& environment) {
  using cia407::TrainBusGatewayHardware, cia407::TrainBusGatewayUnit;
  environment.provide(callback<&TrainBus::hardware>(*this));
  environment.watch(gateway_);
}

/// In the number of bytes of the object.
void TrainBus::act(const BusPress& press, Node& node) {
  if (press.what != "from-train") return;
  const auto index = static_cast<std::uint16_t>(press.number("index").value_or(0));
  const auto sub = static_cast<std::uint8_t>(press.number("sub").value_or(0));
  std::array<std::uint8_t, relayed_value_max> bytes{};
  store(bytes.data(), press.number("value").value_or(0));
  const Result<Entry> entry = node.dictionary().find(index, sub);
  const bool is_taken =
      entry && entry->bytes().size() <= bytes.size() &&
      gateway_->receive(index, sub, std::span(bytes).first(entry->bytes().size()));
  if (!is_taken) {
    output_.say("train-bus-gateway",
                fmt::format("{:04X}h:{:02X}h is none that it tells here", index, sub));
  }
}

cia407::TrainBusGatewayHardware TrainBus::hardware() {
  return {.send = callback<&TrainBus::send>(*this)};
}

void TrainBus::send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
  output_.say("train-bus-gateway", fmt::format("to the train: {:04X}h:{:02X}h = {:02X}", index, sub,
                                               fmt::join(value, " ")));
}

void BusCounting::join(Environment& environment) {
  using namespace cia407;
  environment.provide(callback<&BusCounting::counter_settings>(*this));
  environment.watch(counter_);
  environment.provide(callback<&BusCounting::manager_settings>(*this));
  environment.watch(callback<&BusCounting::is_manager>(*this));
}

void BusCounting::act(const BusPress& press) {
  const unsigned people = press.number().value_or(1);
  if (press.what == "in") counter_->count_in(people);
  if (press.what == "out") counter_->count_out(people);
  if (press.what == "open-door" || press.what == "close-door") {
    counter_->set_door(press.what == "open-door");
  }
  if (press.what == "clear") manager_->clear();
}

std::optional<BusCounting::Counts> BusCounting::counts() const {
  return manager_ == nullptr ? std::nullopt : std::optional(manager_->counts());
}

void BusCounting::is_manager(cia407::CountingManagerUnit& unit, Node& /*node*/) {
  manager_ = &unit;
  unit.restore(settings_.kept);
}

void BusSatellites::join(Environment& environment) {
  environment.provide(callback<&BusSatellites::positioning>(*this));
  environment.provide(callback<&BusSatellites::time_fixing>(*this));
}

void BusSatellites::act(const BusPress& press) {
  if (press.what == "signal" || press.what == "no-signal") has_signal_ = press.what == "signal";
}

cia407::PositioningHardware BusSatellites::positioning() {
  return {.read = callback<&BusSatellites::position>(*this)};
}

cia447::GpsReading BusSatellites::position() {
  return has_signal_ ? motion_.receiver() : cia447::GpsReading{.fix = cia447::GpsFix::none};
}

cia407::TimeFixingHardware BusSatellites::time_fixing() {
  return {.utc = callback<&BusSatellites::time>(*this), .local_offset = {}};
}

std::optional<cia407::CivilTime> BusSatellites::time() {
  return has_signal_ ? motion_.utc() : std::nullopt;
}

namespace {

constexpr Duration kept_each = 1s;

}  // namespace

BusPanel::BusPanel(std::span<const cia407::BusUnit* const> units,
                   const std::vector<std::string>& presses, const BusPanelOptions& options,
                   Environment& environment, const Place& place)
    : units_(units.begin(), units.end()),
      segment_(parse_bus_segment(options.segment)),
      store_(place.store),
      kept_(store_ != nullptr ? store_->load() : KeptBusValues{}),
      stored_(kept_),
      motion_(place.car, kept_.metres),
      displays_(display_names(units), parse_display_size(options.display), options.png, place.clock,
                place.output),
      loudspeakers_(parse_announcements(options.announcements), place.output),
      tickets_(place.output),
      computer_(motion_, kept_.assignment),
      console_(place.clock, place.output),
      vehicle_(motion_, console_, kept_.trip_begin),
      satellites_(motion_),
      counting_({.door = environment.door, .capacity = options.capacity, .kept = kept_.counts}),
      train_(place.output),
      wires_(errors_, place.output) {
  for (const std::string& text : presses) {
    if (has_bus_press(units, text)) plan_.push_back({parse_bus_press(units, text)});
  }
  segment_.is_started_by_first = environment.manages_network;
  join(environment);
}

void BusPanel::join(Environment& environment) {
  environment.provide(callback<&BusPanel::segment>(*this));
  errors_.join(environment);
  displays_.join(environment);
  loudspeakers_.join(environment);
  tickets_.join(environment);
  computer_.join(environment);
  console_.join(environment);
  vehicle_.join(environment);
  satellites_.join(environment);
  counting_.join(environment);
  train_.join(environment);
  wires_.join(environment);
}

void BusPanel::take(std::string_view press) {
  std::erase_if(plan_, [](const Planned& each) { return each.is_done; });
  plan_.push_back({parse_bus_press(units_, press)});
}

void BusPanel::step(Node& node, Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  if (now >= keep_at_) {
    keep_at_ = now + kept_each;
    keep();
  }
  for (Planned& each : plan_) {
    if (each.is_done || now - begin < each.press.at) continue;
    each.is_done = true;
    // An action from outside of the node: the node is advanced to the present.
    node.advance(now);
    act(each.press, node);
  }
  console_.step(now);
  displays_.look();
}

/// One of them performs the press, and the others ignore it.
void BusPanel::act(const BusPress& press, Node& node) {
  errors_.act(press);
  tickets_.act(press);
  computer_.act(press);
  console_.act(press);
  vehicle_.act(press);
  satellites_.act(press);
  counting_.act(press);
  train_.act(press, node);
  wires_.act(press);
}

/// Values that no device here counts are unchanged.
void BusPanel::keep() {
  if (store_ == nullptr) return;
  KeptBusValues now = kept_;
  now.metres = motion_.metres();
  now.trip_begin = vehicle_.trip_begin().value_or(kept_.trip_begin);
  now.counts = counting_.counts().value_or(kept_.counts);
  now.assignment = computer_.assignment();
  if (now == stored_) return;
  stored_ = now;
  store_->keep(now);
}

}  // namespace canvoy::tools
