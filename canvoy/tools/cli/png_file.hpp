// Writes images as PNG files.
//
//     write_png("receipt.png", paper.receipts().back());
#pragma once

#include <string>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy::tools {

/// Writes 8 bits each of red, green and blue. Throws Failure if the file cannot be written (an
/// existing file is then unchanged), or if the picture has no rows or no columns.
void write_png(const std::string& path, const Picture& picture);

}  // namespace canvoy::tools
