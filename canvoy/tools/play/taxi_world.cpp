// canvoy run taxi: plays a shift of a taxi.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/sim/plants/paper_picture.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/png_file.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/device/car/drive_file.hpp"
#include "canvoy/tools/play/car_file.hpp"
#include "canvoy/tools/play/tariff_settings.hpp"
#include "canvoy/tools/play/taxi_settings.hpp"
#include "canvoy/tools/play/taxi_text.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::tools {

namespace {

// Report for the verification of a taximeter after a shift: each trip as driven and as metered,
// with errors and their limits (Directive 2014/32/EU, annex MI-007, as far as public text gives
// them), totals, tariff changes, power interruptions.
//
//     write_taxi_report(network, "shift.txt");    // or shift.json

using Json = nlohmann::ordered_json;
using taxi::money_unit;
using taxi::TaxiEvent;
using taxi::TaxiNetwork;
using taxi::Trip;

/// An interruption of the power of the meter.
struct Interruption {
  Time begin{};
  Time end{};
};
std::vector<Interruption> interruptions(const TaxiNetwork& network) {
  std::vector<Interruption> all;
  const auto is_of_meter = [](const auto& fault) {
    return has_node(fault.kind) && fault.place.node == taxi::taximeter_id;
  };
  for (const TaxiEvent& event : network.events()) {
    if (const auto* began = std::get_if<taxi::FaultBegan>(&event.what)) {
      if (is_of_meter(*began)) all.push_back({event.at, event.at});
    } else if (const auto* ended = std::get_if<taxi::FaultEnded>(&event.what)) {
      if (is_of_meter(*ended) && !all.empty()) all.back().end = event.at;
    }
  }
  return all;
}

std::size_t tariff_changes(const TaxiNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(network.trips(), &Trip::has_tariff_change));
}

std::string verdict(const Trip& trip) {
  if (!trip.is_read) return "not judged";
  const bool is_good =
      trip.distance_excess() <= 0 && trip.time_excess() <= 0 && trip.fare_excess() <= 0;
  return is_good ? "within" : "BEYOND";
}

struct Total {
  std::string_view name;
  std::uint32_t shift;
  std::uint32_t all;
  double unit;  ///< unit of the amount; 1: none
};
std::vector<Total> totals(TaxiNetwork& network) {
  const cia447::TaximeterRecord& record = network.meter().record();
  const cia447::TaxiTotals& shift = record.shift;
  const cia447::TaxiTotals& all = record.total;
  return {{"distance", shift.distance, all.distance, money_unit},
          {"distance_hired", shift.distance_hired, all.distance_hired, money_unit},
          {"hirings", shift.hirings, all.hirings, 1},
          {"fare", shift.fare, all.fare, money_unit},
          {"supplements", shift.supplements, all.supplements, money_unit},
          {"income", shift.income, all.income, money_unit}};
}

std::string taxi_report_text(TaxiNetwork& network) {
  std::string text = fmt::format(
      "Taximeter: {} trips in {}, k = {} pulses\n\n"
      "{:>9} {:>11} {:>11} {:>8} {:>8} {:>9} {:>9} {:>8} {:>9} {:>21}  {}\n",
      network.trips().size(), text::duration_text(network.now() - Time{}),
      network.options().meter.k, "begin s", "true m", "metered m", "error m", "limit m", "true s",
      "metered s", "error s", "fare", "asked for", "limits");
  for (const Trip& trip : network.trips()) {
    text += fmt::format(
        "{:>9.1f} {:>11.1f} {:>11.0f} {:>8.1f} {:>8.1f} {:>9.1f} {:>9.0f} {:>8.1f} {:>9.2f} "
        "{:>10.2f}..{:>9.2f}  {}{}\n",
        in_seconds(trip.begin - Time{}), trip.metres, trip.metered_metres,
        trip.metered_metres - trip.metres, trip.distance_limit(), trip.seconds,
        trip.metered_seconds, trip.metered_seconds - trip.seconds, trip.metered_fare / money_unit,
        trip.fare_low / money_unit, trip.fare_high / money_unit, verdict(trip),
        trip.has_tariff_change ? ", tariff changed" : "");
  }
  text += fmt::format("\n{:<16} {:>14} {:>14}\n", "totals", "shift", "all time");
  for (const Total& total : totals(network)) {
    const int digits = total.unit > 1 ? 3 : 0;
    text += fmt::format("{:<16} {:>14.{}f} {:>14.{}f}\n", total.name, total.shift / total.unit,
                        digits, total.all / total.unit, digits);
  }
  text += fmt::format("\ntrips with a change of tariff: {}\ninterruptions of power: {}\n",
                      tariff_changes(network), interruptions(network).size());
  for (const Interruption& each : interruptions(network)) {
    text += fmt::format("  at {} for {}\n", text::duration_text(each.begin - Time{}),
                        text::duration_text(each.end - each.begin));
  }
  return text;
}

std::string taxi_report_json(TaxiNetwork& network) {
  Json trips = Json::array();
  for (const Trip& trip : network.trips()) {
    trips.push_back({{"begin", in_seconds(trip.begin - Time{})},
                     {"distance_m", trip.metres},
                     {"metered_distance_m", trip.metered_metres},
                     {"distance_limit_m", trip.distance_limit()},
                     {"duration_s", trip.seconds},
                     {"metered_duration_s", trip.metered_seconds},
                     {"duration_limit_s", trip.time_limit()},
                     {"fare", trip.metered_fare / money_unit},
                     {"fare_low", trip.fare_low / money_unit},
                     {"fare_high", trip.fare_high / money_unit},
                     {"paid", trip.paid / money_unit},
                     {"tariff_change", trip.has_tariff_change},
                     {"verdict", verdict(trip)}});
  }
  Json sums = Json::object();
  for (const Total& total : totals(network)) {
    sums[total.name] = {{"shift", total.shift / total.unit}, {"all", total.all / total.unit}};
  }
  Json cuts = Json::array();
  for (const Interruption& each : interruptions(network)) {
    cuts.push_back(
        {{"begin", in_seconds(each.begin - Time{})}, {"end", in_seconds(each.end - Time{})}});
  }
  const Json report = {{"k", network.options().meter.k},
                       {"trips", trips},
                       {"totals", sums},
                       {"interruptions", cuts}};
  return report.dump(2) + "\n";
}

/// Writes JSON if the name ends with `.json`, else text. Throws Failure; no partial file is left.
void write_taxi_report(TaxiNetwork& network, const std::string& path) {
  const std::string report =
      path.ends_with(".json") ? taxi_report_json(network) : taxi_report_text(network);
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(report.data()), report.size()});
}

// Receipts of a simulated printer as images in a folder: receipt-0001.png and so on.
//
//     ReceiptFolder folder("receipts");
//     printer.paper = folder.paper().paper();
//     folder.write();    // now and again

class ReceiptFolder {
 public:
  /// Creates the folder if needed. Throws UsageError if this fails, or if it contains receipts.
  explicit ReceiptFolder(std::string folder);

  PaperPicture& paper() { return paper_; }
  /// Writes each receipt cut since the last call; to be called before there are
  /// PaperPicture::receipts_max. Throws Failure.
  void write();
  std::size_t written() const { return written_; }

 private:
  std::string folder_;
  PaperPicture paper_;
  std::size_t written_ = 0;
};

ReceiptFolder::ReceiptFolder(std::string folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw UsageError(fmt::format("--receipts: {}: {}; check the path", folder_, error.message()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    if (!entry.path().filename().string().starts_with("receipt-")) continue;
    throw UsageError(
        fmt::format("--receipts: there are receipts in '{}'; give another folder", folder_));
  }
  if (error) throw UsageError(fmt::format("--receipts: {}: {}", folder_, error.message()));
}

void ReceiptFolder::write() {
  while (written_ < paper_.cuts()) {
    const std::size_t first_kept = paper_.cuts() - paper_.receipts().size();
    const std::size_t place = written_ < first_kept ? 0 : written_ - first_kept;
    const Picture& receipt = paper_.receipts()[place];
    ++written_;
    if (receipt.height() == 0) continue;
    const auto path = std::filesystem::path(folder_) / fmt::format("receipt-{:04}.png", written_);
    write_png(path.string(), receipt);
  }
}

using taxi::TaxiNetwork;
using taxi::TaxiOptions;

class PlayedTaxi : public Played<TaxiNetwork> {
 public:
  /// Draws receipts if `receipts` names a folder.
  PlayedTaxi(const TaxiRun& run, const std::string& receipts)
      : Played(run.network), tariff_(run.tariff) {
    plan_hands(network_, run.hands);
    if (receipts.empty()) return;
    receipts_.emplace(receipts);
    network_.paper().copy_to(receipts_->paper().paper());
  }

  void run_until(Time until) override {
    network_.run_until(until);
    if (receipts_) receipts_->write();
  }

 private:
  std::shared_ptr<const TariffParts> tariff_;  ///< to which the network refers
  std::optional<ReceiptFolder> receipts_;
};

struct TaxiWorld {
  using Run = TaxiRun;
  using Kind = taxi::FaultKind;
  /// Output files beside the printed text, and the drive; empty: none.
  struct Choice {
    std::string report{};
    std::string receipts{};  ///< a folder
    std::string nmea{};
  };
  static constexpr std::string_view name = "taxi";
  static constexpr auto network = &Run::network;

  static WorldInfo info();
  static WorldFile<Run> file(const std::string& folder);
  static void check(const TomlTable& file, const std::string& folder, Run& run);
  static Run run_of_file() { return {}; }
  static Duration& length(Run& run) { return run.network.length; }
  static std::string check_fault_node(NodeId id) {
    return check_node_up_to(taxi::device_names.size(), id);
  }
  static void add_options(Verb& verb, Choice& choice);
  static Run chosen(const Choice& choice);
  static Choice choice_beside_file(const RunOptions& options) {
    return {.report = options.taxi_report, .receipts = options.taxi_receipts};
  }
  static std::optional<int> play(const Run& run, const PlayOptions& play_as,
                                 const RunOptions& options, const Choice& choice);
  static MadeWorld make(const Run& run, const Choice& choice) {
    return {.network = std::make_unique<PlayedTaxi>(run, choice.receipts)};
  }
  static std::vector<DescribedNode> describe(const Run& run) {
    return describe_car<TaxiNetwork>(run.network, run.network.car_network.nodes.pdo_offsets);
  }
};

WorldInfo TaxiWorld::info() {
  return {.about = "A shift of a taxi: CiA 447-3 (12h)",
          .examples =
              "  canvoy run taxi --for 1h\n"
              "  canvoy run taxi --for 30min --fault lost-node:node=5@16min+1min --json",
          .page = "taxi",
          .decoding = {.profiles = {"447-3"}}};
}

SettingTable<TaxiRun> taxi_device(NodeId id) {
  using Run = TaxiRun;
  constexpr auto network = &Run::network;
  constexpr auto car = &TaxiOptions::car;
  SettingTable<Run> device{std::string(taxi::device_names.at(id - 1U)), "", played_in_car<Run>(id)};
  if (id == cia447::gateway_node_id) {
    device.settings.push_back(setting<network, car, &cia447::CarSettings::pulses_per_rotation>(
        "pulses_per_rotation", "of a wheel", {{21, 253}}));
    device.settings.push_back(setting<network, car, &cia447::CarSettings::wheel_circumference_m>(
        "wheel_circumference", "m", {{0.5, 5}}));
  } else if (id == taxi::taximeter_id) {
    device.settings.push_back(setting<network, &TaxiOptions::meter, &cia447::TaximeterSettings::k>(
        "k", "pulses for a kilometre", {{1, 10'000'000}}));
    device.settings.push_back(taxi_identifier_setting());
  }
  return device;
}

WorldFile<TaxiRun> TaxiWorld::file(const std::string&) {
  WorldFile<Run> file{.network = name,
                      .title = "A shift of a taxi: CiA 447-3.",
                      .head = world_head(setting<network, &TaxiOptions::length>(
                                             "for", "virtual time; the shift ends an hour before"),
                                         name),
                      .parts = {SettingTable<Run>{"bus",
                                                  "",
                                                  {setting<network, &TaxiOptions::bit_rate>(
                                                       "bit_rate", "bit/s", {{50'000, 1'000'000}}),
                                                   real_setting<Run>(0)}}}};
  file.head.push_back(
      setting<network, &TaxiOptions::begin>("begin", "what clocks show at the start"));
  file.head.push_back(setting<&Run::nmea>("nmea", "a recorded drive is what the car does")
                          .as_example("\"drive.nmea\""));
  file.head.push_back(time_zone_setting());
  file.head.push_back(holidays_setting());
  for (std::size_t i = 0; i < taxi::device_names.size(); ++i) {
    file.parts.emplace_back(taxi_device(static_cast<NodeId>(i + 1)));
  }
  add_taxi_settings(file.parts);
  add_tariff_settings(file.parts);
  file.parts.push_back(hands_part<TaxiNetwork, Run>(
      TaxiOptions{}, [](const Run&) { return taxi::device_names.size(); }));
  return file;
}

void TaxiWorld::check(const TomlTable& file, const std::string& folder, Run& run) {
  take_tariff(file, run);
  check_real(file, run, [](NodeId) { return BusIndex{0}; }, {"bus"});
  check_identities(file, run, taxi::device_names);
  if (run.nmea.empty()) return;
  run.network.record = read_drive_file((std::filesystem::path(folder) / run.nmea).string());
}

void TaxiWorld::add_options(Verb& verb, Choice& choice) {
  verb.add({
      {"--report", choice.report,
       "write what a verification of a taximeter asks for: as JSON where the name ends "
       "with .json, else as text"},
      {"--receipts", choice.receipts,
       "a folder for pictures of all receipts: receipt-0001.png and so on"},
      {"--nmea", choice.nmea,
       "a drive that a satellite receiver recorded, as NMEA 0183 (RMC, GGA, VTG): the "
       "car goes as it went then, and each way between two stops of 2 min is a trip"},
  });
}

TaxiRun TaxiWorld::chosen(const Choice& choice) {
  Run run;
  run.nmea = choice.nmea;
  if (!run.nmea.empty()) run.network.record = read_drive_file(run.nmea);
  return run;
}

/// Writes a report.
std::optional<int> TaxiWorld::play(const Run& run, const PlayOptions& play_as,
                                   const RunOptions& options, const Choice& choice) {
  const auto folder = std::filesystem::path(choice.report).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw UsageError(fmt::format("--report: '{}' is no folder", folder.string()));
  }
  if (choice.report.empty()) return std::nullopt;
  if (options.is_watched()) throw UsageError("--report is of a run on the terminal");
  PlayedTaxi played(run, choice.receipts);
  const int status = tools::play(played, play_as);
  write_taxi_report(played.network(), choice.report);
  return status;
}

}  // namespace

WorldEntry taxi_world() {
  return world_entry<TaxiWorld>();
}

}  // namespace canvoy::tools
