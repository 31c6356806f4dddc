#include "canvoy/tools/play/receipt_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/png_file.hpp"

namespace canvoy::tools {

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

}  // namespace canvoy::tools
