// Pictures as PNG files.
//
//     write_png("receipt.png", paper.receipts().back());
#pragma once

#include <string>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy::tools {

/// 8 bits each of red, green and blue. Throws Failure where it cannot be written (then a file that
/// was there before is as it was), and where the picture has no rows or no columns.
void write_png(const std::string& path, const Picture& picture);

}  // namespace canvoy::tools
