// canvoy run taxi: plays a shift of a taxi.
#include <filesystem>

#include "canvoy/tools/device/car/drive_file.hpp"
#include "canvoy/tools/play/car_file.hpp"
#include "canvoy/tools/play/receipt_folder.hpp"
#include "canvoy/tools/play/tariff_settings.hpp"
#include "canvoy/tools/play/taxi_report.hpp"
#include "canvoy/tools/play/taxi_settings.hpp"
#include "canvoy/tools/play/taxi_text.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools {

namespace {

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
