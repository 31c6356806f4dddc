// Receipts of a simulated printer as images in a folder: receipt-0001.png and so on.
//
//     ReceiptFolder folder("receipts");
//     printer.paper = folder.paper().paper();
//     folder.write();    // now and again
#pragma once

#include <cstddef>
#include <string>

#include "canvoy/sim/plants/paper_picture.hpp"

namespace canvoy::tools {

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

}  // namespace canvoy::tools
