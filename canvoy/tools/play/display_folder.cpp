#include "canvoy/tools/play/display_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/png_file.hpp"

namespace canvoy::tools {

DisplayFolder::DisplayFolder(std::string folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw UsageError(fmt::format("--displays: {}: {}; check the path", folder_, error.message()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    if (entry.path().extension() != ".png") continue;
    throw UsageError(
        fmt::format("--displays: there are pictures in '{}'; give another folder", folder_));
  }
  if (error) throw UsageError(fmt::format("--displays: {}: {}", folder_, error.message()));
}

void DisplayFolder::look(const bus_line::BusNetwork& network) {
  const bus_line::BusDesign& design = network.options().design;
  for (const bus_line::DevicePlace& place : bus_line::places_of(design.cars)) {
    const bus_line::ShownDisplay* shown = network.find_display(id_of(design, place.id));
    if (shown == nullptr) continue;
    const BusDisplay& display = shown->display();
    Drawn& drawn = drawn_.at(place.id);
    std::vector<std::string> text = display.text();
    const bool is_same =
        drawn.pictures != 0 && text == drawn.text && shown->is_sign_lit() == drawn.has_sign;
    if (is_same) continue;
    drawn.text = std::move(text);
    drawn.has_sign = shown->is_sign_lit();
    const std::string name = fmt::format("{}-{:04}.png", place.name, ++drawn.pictures);
    write_png((std::filesystem::path(folder_) / name).string(), display.picture());
    ++written_;
  }
}

}  // namespace canvoy::tools
